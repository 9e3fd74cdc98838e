//! The scene file: what is simulated, for how long, by which method, and what is recorded.
//!
//! JSON in SI units (m, kg, s, N, K), with names chosen by the user. [`Scene::parse`] and [`Scene::load`] return
//! validated scenes only: whoever holds one may divide by its step and look up its points by name. Unknown keys,
//! duplicate keys and numbers that are not finite are refused, with the key, the value and what is allowed there.

mod builtin;
mod choice;
mod locate;
mod parse;
mod shape;
mod topology;
mod validate;
mod words;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use builtin::{builtin_names, builtin_text};
pub use choice::{Direction, Method, Quantity, Schema, Start, ThermalModel};

/// One scene: the whole content of a scene file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Version of the file format.
    pub schema: Schema,
    /// What the scene is, in the user's words.
    #[serde(default)]
    pub title: String,
    /// Material of all rods.
    #[serde(deserialize_with = "shape::object")]
    pub material: Material,
    /// Cross-section of all rods.
    #[serde(deserialize_with = "shape::object")]
    pub section: Section,
    /// Name → initial position [x, y], m.
    #[serde(deserialize_with = "shape::points")]
    pub points: BTreeMap<String, [f64; 2]>,
    /// The rods; rods that name the same point are pinned there.
    #[serde(deserialize_with = "shape::objects")]
    pub rods: Vec<Rod>,
    /// Points held in place.
    #[serde(default, deserialize_with = "shape::objects")]
    pub supports: Vec<Support>,
    /// Acceleration of gravity [g_x, g_y], m/s².
    #[serde(default)]
    pub gravity: [f64; 2],
    /// Change of temperature; `None`: nothing is heated.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// How long, in which steps, by which method.
    #[serde(deserialize_with = "shape::object")]
    pub time: Time,
    /// Which rows and columns are recorded.
    #[serde(default, deserialize_with = "shape::object")]
    pub output: Output,
    /// Quantities recorded at points.
    #[serde(default, deserialize_with = "shape::objects")]
    pub probes: Vec<Probe>,
}

/// An isotropic, linear thermo-elastic material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Young's modulus, Pa; positive.
    #[serde(rename = "E")]
    pub youngs_modulus: f64,
    /// Poisson's ratio ν; −1 < ν < 0.5.
    pub nu: f64,
    /// Density ρ, kg/m³; positive.
    pub rho: f64,
    /// Coefficient of thermal expansion α, 1/K; may be left out of a file that heats nothing.
    #[serde(default)]
    pub alpha: f64,
}

/// A rectangular cross-section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// Height h in the plane of motion, m; positive.
    pub height: f64,
    /// Width w across the plane of motion, m; positive.
    pub width: f64,
}

/// A straight rod between two points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rod {
    /// The rod's own name.
    pub name: String,
    /// Name of the point where it begins.
    pub from: String,
    /// Name of the point where it ends.
    pub to: String,
    /// Number of elements, all of one length.
    #[serde(default = "default_elements")]
    pub elements: usize,
}

fn default_elements() -> usize {
    8
}

/// A point held in place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of the point.
    pub point: String,
    /// The directions in which it cannot move.
    pub fix: Vec<Direction>,
}

/// The temperature change ΔT of all rods over time.
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

/// How long, in which steps, by which method.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// End of the simulation, s; a whole number of steps.
    pub end: f64,
    /// Step, s.
    #[serde(default = "default_step")]
    pub step: f64,
    /// Time-stepping method.
    #[serde(default)]
    pub method: Method,
    /// Spectral radius ρ∞ of generalized-α at infinite frequency, 0 … 1; other methods do without.
    #[serde(default = "default_rho_inf")]
    pub rho_inf: f64,
    /// Where Newton's iteration ends: residual relative to the largest force term.
    #[serde(default = "default_newton_tolerance")]
    pub newton_tolerance: f64,
}

fn default_step() -> f64 {
    1e-3
}

fn default_rho_inf() -> f64 {
    0.9
}

fn default_newton_tolerance() -> f64 {
    1e-10
}

/// Which rows and columns are recorded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Time between two rows, s, a whole number of steps; `None`: a row each step.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub interval: Option<f64>,
    /// Whether the energy columns are computed.
    #[serde(default = "default_energy")]
    pub energy: bool,
}

fn default_energy() -> bool {
    true
}

impl Default for Output {
    fn default() -> Self {
        Output { interval: None, energy: default_energy() }
    }
}

/// Quantities recorded at one point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name that heads the columns.
    pub name: String,
    /// Name of the point.
    pub point: String,
    /// What is recorded, in the order of the columns.
    pub of: Vec<Quantity>,
}

/// Columns of `trajectory.csv` that hold energies, J.
pub const ENERGY_COLUMNS: [&str; 5] =
    ["energy.kinetic", "energy.strain", "energy.potential", "energy.input", "energy.balance"];

impl Scene {
    /// Number of time steps from 0 to `time.end`.
    pub fn steps(&self) -> usize {
        (self.time.end / self.time.step).round() as usize
    }

    /// Number of steps from one output row to the next, at least 1.
    pub fn rows_every(&self) -> usize {
        self.output.interval.map_or(1, |interval| (interval / self.time.step).round().max(1.0) as usize)
    }

    /// Whether the state after `step` steps is an output row: the first, each `rows_every`-th, and the last.
    pub fn is_row(&self, step: usize) -> bool {
        step.is_multiple_of(self.rows_every()) || step == self.steps()
    }

    /// The temperature change, if it strains anything: `None` with the model "none" as well.
    pub fn heat(&self) -> Option<&Temperature> {
        self.temperature.as_ref().filter(|temperature| temperature.model != ThermalModel::None)
    }

    /// Names of the columns of `trajectory.csv`: `t`, two for each probed quantity, then the energies if asked for.
    pub fn columns(&self) -> Vec<String> {
        let probed = self.probes.iter().flat_map(|probe| {
            let columns = probe.of.iter().flat_map(|quantity| quantity.suffixes());
            columns.map(move |suffix| format!("{}.{suffix}", probe.name))
        });
        let energies = ENERGY_COLUMNS.iter().filter(|_| self.output.energy).map(|name| name.to_string());
        std::iter::once("t".to_string()).chain(probed).chain(energies).collect()
    }
}

impl Temperature {
    /// ΔT at time `t` in s, K; 0 if the history is empty. The model is not asked: see [`Scene::heat`].
    pub fn at(&self, t: f64) -> f64 {
        let next = self.history.partition_point(|&[time, _]| time <= t);
        let before = next.checked_sub(1).and_then(|last| self.history.get(last));
        match (before, self.history.get(next)) {
            (Some(&[t0, from]), Some(&[t1, to])) => from + (to - from) * ((t - t0) / (t1 - t0)),
            (Some(&[_, outside]), None) | (None, Some(&[_, outside])) => outside,
            (None, None) => 0.0,
        }
    }
}
