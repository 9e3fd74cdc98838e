//! Duration, steps and method; output rows.

use serde::{Deserialize, Serialize};

use super::choice::{LoadPath, Method, is_default};
use super::json::shape;
use super::shapes::Shapes;

/// Most time steps of a run: more is a mistyped step, and would take days even with one element.
pub const MOST_STEPS: f64 = 1e9;

/// Duration, step and method of a simulation.
///
/// ```
/// use ancf::model::{Method, Time};
///
/// let mut time = Time::until(3.0);
/// (time.method, time.tolerance) = (Method::GaussAdaptive, 1e-5);
/// assert_eq!((time.end, time.step, time.newton_tolerance), (3.0, 1e-3, 1e-10));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Time {
    /// End time, s; a whole number of steps. In statics the load factor 1, which a file may leave out.
    #[serde(default = "default_end")]
    pub end: f64,
    /// Step, s; the longest step of adaptive methods. Refused in statics.
    #[serde(default = "default_step", skip_serializing_if = "is_default_step")]
    pub step: f64,
    /// Time-stepping method.
    #[serde(default)]
    pub method: Method,
    /// Spectral radius ρ∞ of generalized-α at infinite frequency, 0 … 1; refused with other methods.
    #[serde(default = "default_rho_inf", skip_serializing_if = "is_default_rho_inf")]
    pub rho_inf: f64,
    /// Tolerance of Newton's iteration: residual relative to the largest force term. Where rounding prevents that, the
    /// iteration ends at eight times the rounding error of the elastic forces. Refused with explicit methods.
    #[serde(default = "default_newton_tolerance", skip_serializing_if = "is_default_newton_tolerance")]
    pub newton_tolerance: f64,
    /// Adaptive methods: largest estimated error of a step, m, in positions and in slopes times the length over which
    /// they act. Refused with other methods.
    #[serde(default = "default_tolerance", skip_serializing_if = "is_default_tolerance")]
    pub tolerance: f64,
    /// Statics: number of equal load steps for loads and heat. With the path "arc-length" no row changes the load factor
    /// by much more than one of these steps, and there are at most twenty rows for each. Refused with other methods.
    #[serde(default = "default_load_steps", skip_serializing_if = "is_default_load_steps")]
    pub load_steps: usize,
    /// Statics: what it steps along, "load" or "arc-length". With "arc-length" the column `t` is the number of the row,
    /// and the load factor is the column `load`; the path ends where that reaches 1, or with the last of its rows.
    #[serde(default, skip_serializing_if = "is_default")]
    pub path: LoadPath,
}

/// Most rows of an arc-length path for each of its load steps.
const ROWS_PER_LOAD_STEP: usize = 20;

impl Time {
    /// Duration up to `end` (s), everything else at its default.
    pub fn until(end: f64) -> Time {
        Time {
            end,
            step: default_step(),
            method: Method::default(),
            rho_inf: default_rho_inf(),
            newton_tolerance: default_newton_tolerance(),
            tolerance: default_tolerance(),
            load_steps: default_load_steps(),
            path: LoadPath::default(),
        }
    }

    /// Whether the load factor is a result of the run.
    pub(crate) fn has_load_column(&self) -> bool {
        self.method == Method::Static && self.path == LoadPath::ArcLength
    }

    /// Most rows of statics after the first.
    pub(super) fn most_rows(&self) -> usize {
        match self.path {
            LoadPath::Load => self.load_steps,
            LoadPath::ArcLength => ROWS_PER_LOAD_STEP.saturating_mul(self.load_steps),
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

/// Output rows, energy columns and shapes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Interval between rows, s, a whole number of steps; `None`: one row each step.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub interval: Option<f64>,
    /// Whether energies are computed and recorded. Refused in statics.
    #[serde(default = "default_energy", skip_serializing_if = "is_default_energy")]
    pub energy: bool,
    /// Shapes of the rods in a file of their own, `shapes.json`; `None`: no such file.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub shapes: Option<Shapes>,
}

fn default_energy() -> bool {
    true
}

fn is_default_energy(value: &bool) -> bool {
    *value == default_energy()
}

impl Default for Output {
    fn default() -> Self {
        Output { interval: None, energy: default_energy(), shapes: None }
    }
}

fn is_default_step(value: &f64) -> bool {
    *value == default_step()
}

fn is_default_rho_inf(value: &f64) -> bool {
    *value == default_rho_inf()
}

fn is_default_newton_tolerance(value: &f64) -> bool {
    *value == default_newton_tolerance()
}

fn is_default_tolerance(value: &f64) -> bool {
    *value == default_tolerance()
}

fn is_default_load_steps(value: &usize) -> bool {
    *value == default_load_steps()
}
