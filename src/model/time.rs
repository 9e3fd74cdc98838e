//! Time: how long, in which steps, by which method; and which rows are recorded.

use serde::{Deserialize, Serialize};

use super::choice::Method;
use super::json::shape;

/// How long, in which steps, by which method.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// End of the simulation, s; a whole number of steps. The load factor 1 in statics, where a file may leave it out.
    #[serde(default = "default_end")]
    pub end: f64,
    /// Step, s; the longest one of adaptive methods.
    #[serde(default = "default_step")]
    pub step: f64,
    /// Time-stepping method.
    #[serde(default)]
    pub method: Method,
    /// Spectral radius ρ∞ of generalized-α at infinite frequency, 0 … 1; other methods do without.
    #[serde(default = "default_rho_inf")]
    pub rho_inf: f64,
    /// Where Newton's iteration ends: residual relative to the largest force term; or, where that is out of reach, at eight
    /// times the rounding error of the elastic forces.
    #[serde(default = "default_newton_tolerance")]
    pub newton_tolerance: f64,
    /// Adaptive methods: largest estimated error of a step, m, of positions and of slopes times the length over which they act;
    /// other methods do without.
    #[serde(default = "default_tolerance")]
    pub tolerance: f64,
    /// Statics: equal parts in which loads and heat are applied; other methods do without.
    #[serde(default = "default_load_steps")]
    pub load_steps: usize,
}

impl Time {
    /// Time up to `end` (s), everything else at its default.
    pub fn until(end: f64) -> Time {
        Time {
            end,
            step: default_step(),
            method: Method::default(),
            rho_inf: default_rho_inf(),
            newton_tolerance: default_newton_tolerance(),
            tolerance: default_tolerance(),
            load_steps: default_load_steps(),
        }
    }
}

fn default_end() -> f64 {
    1.0
}

fn default_load_steps() -> usize {
    10
}

fn default_step() -> f64 {
    1e-3
}

fn default_rho_inf() -> f64 {
    0.9
}

fn default_tolerance() -> f64 {
    1e-6
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
