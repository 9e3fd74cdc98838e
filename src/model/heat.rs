//! The temperature of rods over time.

use serde::{Deserialize, Serialize};

use super::choice::{Start, ThermalModel};
use super::history::interpolate;

/// The temperature change ΔT of rods over time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Temperature {
    /// Which strains heat causes.
    #[serde(default)]
    pub model: ThermalModel,
    /// How the heat is there at t = 0.
    #[serde(default)]
    pub start: Start,
    /// Pairs [t, ΔT] in s and K, in the order of time: linear between them, constant before the first and after the
    /// last. May be empty if the model is [`ThermalModel::None`].
    #[serde(default)]
    pub history: Vec<[f64; 2]>,
}

impl Temperature {
    /// Heat that follows a history of pairs [t, ΔT] in s and K, and meets an unstretched structure at t = 0.
    pub fn new(model: ThermalModel, history: Vec<[f64; 2]>) -> Temperature {
        Temperature { model, start: Start::default(), history }
    }

    /// Begins at the stress-free stretch.
    #[must_use]
    pub fn relaxed(mut self) -> Temperature {
        self.start = Start::Relaxed;
        self
    }

    /// ΔT at time `t` in s, K; 0 if the history is empty. The model is not asked: see [`Scene::heat`](super::Scene::heat).
    pub fn at(&self, t: f64) -> f64 {
        interpolate(&self.history, t).unwrap_or(0.0)
    }
}
