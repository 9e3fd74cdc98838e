//! The scene file: what is simulated, for how long, by which method, and what is recorded.
//!
//! JSON in SI units (m, kg, s, N, K), with names chosen by the user. [`Scene::parse`] and [`Scene::load`] return
//! validated scenes only: whoever holds one may divide by its step and look up its points by name. Unknown keys,
//! duplicate keys and numbers that are not finite are refused, with the key, the value and what is allowed there.

mod builtin;
mod choice;
mod heat;
mod loads;
mod locate;
mod missing;
mod motion;
mod parse;
mod probes;
mod scissors;
mod shape;
mod statics;
mod supports;
mod text;
mod time;
mod topology;
mod validate;
mod words;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use builtin::{builtin_names, builtin_text};
pub use choice::{Constraints, Direction, Element, Form, Method, Poisson, Quantity, Schema, Start, ThermalModel};
pub use motion::Motion;
pub(crate) use parse::{Refused, nearest, read_json};
pub use scissors::Scissors;

/// One scene: the whole content of a scene file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Version of the file format.
    pub schema: Schema,
    /// What the scene is, in the user's words.
    #[serde(default)]
    pub title: String,
    /// What a reader of the file should know: its sources and assumptions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Material of all rods that have none of their own.
    #[serde(deserialize_with = "shape::object")]
    pub material: Material,
    /// Cross-section of all rods that have none of their own.
    #[serde(deserialize_with = "shape::object")]
    pub section: Section,
    /// Name → initial position [x, y], m.
    #[serde(deserialize_with = "shape::points")]
    pub points: BTreeMap<String, [f64; 2]>,
    /// The rods; those that name the same point, or the same pivot, are pinned there.
    #[serde(deserialize_with = "shape::objects")]
    pub rods: Vec<Rod>,
    /// Points held in place. Several may hold one point, each of them in another way.
    #[serde(default, deserialize_with = "shape::objects")]
    pub supports: Vec<Support>,
    /// Forces at points.
    #[serde(default, deserialize_with = "shape::objects", skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<Force>,
    /// Acceleration of gravity [g_x, g_y], m/s².
    #[serde(default)]
    pub gravity: [f64; 2],
    /// Change of temperature of all rods that have none of their own; `None`: they are not heated.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// How everything moves at t = 0; `None`: at rest.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub motion: Option<Motion>,
    /// How pins and supports are kept.
    #[serde(default)]
    pub constraints: Constraints,
    /// Which form of the paper's element all rods have.
    #[serde(default, skip_serializing_if = "is_default")]
    pub form: Form,
    /// How long, in which steps, by which method.
    #[serde(deserialize_with = "shape::object")]
    pub time: Time,
    /// Which rows and columns are recorded.
    #[serde(default, deserialize_with = "shape::object")]
    pub output: Output,
    /// Quantities recorded at points and along rods.
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
    /// Which element it is made of.
    #[serde(default, skip_serializing_if = "is_default")]
    pub element: Element,
    /// Where Poisson's terms act in the paper's element.
    #[serde(default, skip_serializing_if = "is_default")]
    pub poisson: Poisson,
    /// Name of the point at its middle, a node for even and odd numbers of elements; rods with one pivot are pinned there.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub pivot: Option<String>,
    /// Its own material; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub material: Option<Material>,
    /// Its own cross-section; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub section: Option<Section>,
    /// Its own change of temperature; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
}

fn default_elements() -> usize {
    8
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A point held in place, at least in part: `fix`, or `slide`, and with either or without a `clamp`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of the point.
    pub point: String,
    /// The directions in which it cannot move.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fix: Vec<Direction>,
    /// The only direction in which it can move, of any length.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub slide: Option<[f64; 2]>,
    /// Name of a rod whose section keeps its direction there: r_y · t₀ = 0 with the rod's initial direction t₀, or r_x · n₀ = 0
    /// with the one across it where the element has no r_y.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub clamp: Option<String>,
}

/// A force at a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Force {
    /// Name of the point.
    pub point: String,
    /// The force [F_x, F_y], N; it keeps its direction.
    pub force: [f64; 2],
    /// Pairs [t, factor], in the order of time: the factor is linear between them, constant before the first and after
    /// the last. `None`: always 1.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub history: Option<Vec<[f64; 2]>>,
}

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

/// Quantities recorded at a point, or along a rod.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name that heads the columns.
    pub name: String,
    /// Name of the point; `None` for a place on a rod.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub point: Option<String>,
    /// Name of a rod: with a point, the rod on which the reaction acts; without, the rod that is looked at.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub rod: Option<String>,
    /// Place on the rod as a fraction of its length, 0 … 1.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
    /// What is recorded, in the order of the columns.
    pub of: Vec<Quantity>,
}

/// Columns of `trajectory.csv` that hold energies, J.
pub const ENERGY_COLUMNS: [&str; 5] =
    ["energy.kinetic", "energy.strain", "energy.potential", "energy.input", "energy.balance"];

impl Scene {
    /// Number of time steps from 0 to `time.end`, or of load steps; of output rows where a method chooses its own steps.
    pub fn steps(&self) -> usize {
        match self.time.method {
            Method::Static => self.time.load_steps,
            _ => (self.time.end / self.stride()).round() as usize,
        }
    }

    /// From one of the times that a method has to reach to the next, s: a step, or an output interval where it chooses its own.
    fn stride(&self) -> f64 {
        let own = self.output.interval.filter(|_| self.time.method.is_adaptive());
        own.unwrap_or(self.time.step)
    }

    /// Time after `step` of these, s; the load factor in statics. Not a sum of steps, whose rounding would grow.
    pub fn time_after(&self, step: usize) -> f64 {
        match self.time.method {
            Method::Static => step as f64 / self.time.load_steps as f64,
            _ => step as f64 * self.stride(),
        }
    }

    /// Number of steps from one output row to the next, at least 1; every load step is a row.
    pub fn rows_every(&self) -> usize {
        if self.time.method == Method::Static {
            return 1;
        }
        self.output.interval.map_or(1, |interval| (interval / self.stride()).round().max(1.0) as usize)
    }

    /// Whether the state after `step` steps is an output row: the first, each `rows_every`-th, and the last.
    pub fn is_row(&self, step: usize) -> bool {
        step.is_multiple_of(self.rows_every()) || step == self.steps()
    }

    /// A rod's material.
    pub fn material<'a>(&'a self, rod: &'a Rod) -> &'a Material {
        rod.material.as_ref().unwrap_or(&self.material)
    }

    /// A rod's cross-section.
    pub fn section<'a>(&'a self, rod: &'a Rod) -> &'a Section {
        rod.section.as_ref().unwrap_or(&self.section)
    }

    /// A rod's temperature change, if it strains it: `None` with the model "none" as well.
    pub fn heat<'a>(&'a self, rod: &'a Rod) -> Option<&'a Temperature> {
        let temperature = rod.temperature.as_ref().or(self.temperature.as_ref());
        temperature.filter(|temperature| temperature.model != ThermalModel::None)
    }

    /// Initial position of a point: one of `points`, or a rod's pivot. `None` if there is no such point.
    pub fn position(&self, point: &str) -> Option<[f64; 2]> {
        let pivot =
            || self.rods.iter().find(|rod| rod.pivot.as_deref() == Some(point)).and_then(|rod| self.middle(rod));
        self.points.get(point).copied().or_else(pivot)
    }

    /// How far its points reach, m: the diagonal of the rectangle around them.
    pub(crate) fn size(&self) -> f64 {
        let reach = |axis: usize| {
            let places = || self.points.values().map(move |point| point[axis]);
            places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
        };
        reach(0).hypot(reach(1))
    }

    /// A rod's length, m; 0 if one of its ends is no point.
    pub(crate) fn length(&self, rod: &Rod) -> f64 {
        match (self.points.get(&rod.from), self.points.get(&rod.to)) {
            (Some([x_0, y_0]), Some([x_1, y_1])) => (x_1 - x_0).hypot(y_1 - y_0),
            _ => 0.0,
        }
    }

    /// Initial position of a rod's middle.
    pub(crate) fn middle(&self, rod: &Rod) -> Option<[f64; 2]> {
        let ([x_0, y_0], [x_1, y_1]) = (self.points.get(&rod.from)?, self.points.get(&rod.to)?);
        Some([x_0 + 0.5 * (x_1 - x_0), y_0 + 0.5 * (y_1 - y_0)])
    }

    /// Whether energies are recorded: not in statics, where loads that grow slowly put in what is stored.
    pub fn has_energies(&self) -> bool {
        self.output.energy && self.time.method != Method::Static
    }

    /// Names of the columns of `trajectory.csv`: `t`, two for each probed quantity (one for a deflection), then the energies if asked for.
    pub fn columns(&self) -> Vec<String> {
        let probed = self.probes.iter().flat_map(|probe| {
            let columns = probe.of.iter().flat_map(|quantity| quantity.suffixes().iter().copied());
            columns.map(move |suffix| format!("{}.{suffix}", probe.name))
        });
        let energies = ENERGY_COLUMNS.iter().filter(|_| self.has_energies()).map(|name| name.to_string());
        std::iter::once("t".to_string()).chain(probed).chain(energies).collect()
    }
}

impl Rod {
    /// Whether it has a node of this name: where it begins, where it ends, or its pivot.
    pub fn has_node(&self, point: &str) -> bool {
        self.from == point || self.to == point || self.pivot.as_deref() == Some(point)
    }
}

impl Temperature {
    /// ΔT at time `t` in s, K; 0 if the history is empty. The model is not asked: see [`Scene::heat`].
    pub fn at(&self, t: f64) -> f64 {
        interpolate(&self.history, t).unwrap_or(0.0)
    }
}

impl Force {
    /// The force [F_x, F_y] at time `t` in s, N.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let factor = self.history.as_ref().and_then(|history| interpolate(history, t)).unwrap_or(1.0);
        self.force.map(|component| factor * component)
    }
}

/// Times from 0 to `end` between which all of these histories are linear: both ends and the corners inside, in order.
pub(crate) fn times_of<'a>(histories: impl IntoIterator<Item = &'a [[f64; 2]]>, end: f64) -> Vec<f64> {
    let corners = histories.into_iter().flatten().map(|&[t, _]| t).filter(|t| *t > 0.0 && *t < end);
    let mut times: Vec<f64> = corners.chain([0.0, end]).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// The value at time `t` of a history of pairs [t, value]: linear between them, constant outside; `None` if it is empty.
fn interpolate(history: &[[f64; 2]], t: f64) -> Option<f64> {
    let next = history.partition_point(|&[time, _]| time <= t);
    let before = next.checked_sub(1).and_then(|last| history.get(last));
    match (before, history.get(next)) {
        (Some(&[t0, from]), Some(&[t1, to])) => Some(from + (to - from) * ((t - t0) / (t1 - t0))),
        (Some(&[_, outside]), None) | (None, Some(&[_, outside])) => Some(outside),
        (None, None) => None,
    }
}
