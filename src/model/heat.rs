//! Temperature change of rods over time.

use serde::{Deserialize, Serialize};

use super::choice::{Start, ThermalModel};
use super::history::interpolate;

/// Temperature change ΔT of rods over time.
///
/// ```
/// use ancf::model::{Temperature, ThermalModel};
///
/// let heat = Temperature::new(ThermalModel::TwoD, vec![[0.0, 0.0], [2.0, 100.0]]);
/// assert_eq!([0.0, 1.0, 5.0].map(|t| heat.at(t)), [0.0, 50.0, 100.0]);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Temperature {
    /// Strains caused by heat.
    #[serde(default)]
    pub model: ThermalModel,
    /// State of the structure under the heat of t = 0.
    #[serde(default)]
    pub start: Start,
    /// Pairs [t, ΔT] in s and K, in order of time: linear in between, constant before the first and after the last. May
    /// be empty for [`ThermalModel::None`]. In statics t is the load factor, where the history starts from 0; a single
    /// pair is the full heat, which grows with the load factor.
    #[serde(default)]
    pub history: Vec<[f64; 2]>,
}

impl Temperature {
    /// Heat with a history of pairs [t, ΔT] in s and K; the structure is unstretched at t = 0.
    pub fn new(model: ThermalModel, history: Vec<[f64; 2]>) -> Temperature {
        Temperature { model, start: Start::default(), history }
    }

    /// Starts from the stress-free stretch.
    #[must_use]
    pub fn relaxed(mut self) -> Temperature {
        self.start = Start::Relaxed;
        self
    }

    /// ΔT at time `t` (s), K; 0 if the history is empty. Ignores the model: see [`Scene::heat`](super::Scene::heat).
    pub fn at(&self, t: f64) -> f64 {
        interpolate(&self.history, t).unwrap_or(0.0)
    }
}
