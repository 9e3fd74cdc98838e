//! The scene as plain data: structure, loads, duration, method and output.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::choice::{Constraints, Form, Method, Schema, ThermalModel, is_default};
use super::heat::Temperature;
use super::imperfection::Imperfection;
use super::json::shape;
use super::loads::Force;
use super::method_settings::drop_idle;
use super::motion::Motion;
use super::probes::{ENERGY_COLUMNS, Probe};
use super::rod::{Material, Rod, Section};
use super::supports::Support;
use super::time::{MOST_STEPS, Output, Time};

/// The whole content of a scene file, as plain data.
///
/// Start from [`Scene::new`], chain the builder methods, and end with [`build`](Scene::build):
///
/// ```
/// use ancf::model::{Force, Material, Rod, Scene, Section, Support};
///
/// let model = Scene::new(Material::new(7e10, 0.0, 2750.0), Section::new(0.02, 0.02))
///     .point("a", [0.0, 0.0])
///     .point("b", [2.0, 0.0])
///     .rod(Rod::new("ab", "a", "b"))
///     .support(Support::pinned("a").clamping("ab"))
///     .force(Force::new("b", [0.0, -10.0]))
///     .until(0.1)
///     .build()?;
/// assert_eq!(model.scene().steps(), 100);
/// # Ok::<(), ancf::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Scene {
    /// Version of the file format.
    pub schema: Schema,
    /// Title, in the user's words.
    #[serde(default)]
    pub title: String,
    /// Notes for a reader of the file: sources and assumptions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Material of the rods without one of their own.
    #[serde(deserialize_with = "shape::object")]
    pub material: Material,
    /// Cross-section of the rods without one of their own.
    #[serde(deserialize_with = "shape::object")]
    pub section: Section,
    /// Initial positions [x, y] of the points by name, m.
    #[serde(deserialize_with = "shape::points")]
    pub points: BTreeMap<String, [f64; 2]>,
    /// Rods; those that name the same point, or the same pivot, are pinned together there.
    #[serde(deserialize_with = "shape::objects")]
    pub rods: Vec<Rod>,
    /// Supports. One point may have several, each holding another direction.
    #[serde(default, deserialize_with = "shape::objects")]
    pub supports: Vec<Support>,
    /// Point forces.
    #[serde(default, deserialize_with = "shape::objects", skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<Force>,
    /// Acceleration of gravity [g_x, g_y], m/s².
    #[serde(default)]
    pub gravity: [f64; 2],
    /// Temperature change of the rods without one of their own; `None`: no heat.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// Initial rigid motion; `None`: at rest.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub motion: Option<Motion>,
    /// Stress-free deviation of the initial shape, in which the structure starts; `None`: rods are straight.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub imperfection: Option<Imperfection>,
    /// How pins and supports are enforced.
    #[serde(default)]
    pub constraints: Constraints,
    /// Form of the paper's element, for all rods.
    #[serde(default, skip_serializing_if = "is_default")]
    pub form: Form,
    /// Duration, step and method.
    #[serde(deserialize_with = "shape::object")]
    pub time: Time,
    /// Output rows and energy columns.
    #[serde(default, deserialize_with = "shape::object")]
    pub output: Output,
    /// Probes: quantities recorded at points and along rods.
    #[serde(default, deserialize_with = "shape::objects")]
    pub probes: Vec<Probe>,
}

impl Scene {
    /// Starts a scene without points and rods: at rest, neither heated nor loaded, for 1 s.
    ///
    /// ```
    /// use ancf::model::{Material, Scene, Section};
    ///
    /// let scene = Scene::new(Material::new(7e10, 0.3, 2750.0), Section::new(0.02, 0.01));
    /// assert_eq!((scene.time.step, scene.steps()), (1e-3, 1000));
    /// assert!(scene.rods.is_empty());
    /// ```
    pub fn new(material: Material, section: Section) -> Scene {
        Scene {
            schema: Schema::V1,
            title: String::new(),
            notes: Vec::new(),
            material,
            section,
            points: BTreeMap::new(),
            rods: Vec::new(),
            supports: Vec::new(),
            forces: Vec::new(),
            gravity: [0.0; 2],
            temperature: None,
            motion: None,
            imperfection: None,
            constraints: Constraints::default(),
            form: Form::default(),
            time: Time::until(1.0),
            output: Output::default(),
            probes: Vec::new(),
        }
    }

    /// Adds a point at the initial position [x, y], m.
    #[must_use]
    pub fn point(mut self, name: &str, position: [f64; 2]) -> Scene {
        self.points.insert(name.into(), position);
        self
    }

    /// Adds a rod.
    #[must_use]
    pub fn rod(mut self, rod: Rod) -> Scene {
        self.rods.push(rod);
        self
    }

    /// Adds a support.
    #[must_use]
    pub fn support(mut self, support: Support) -> Scene {
        self.supports.push(support);
        self
    }

    /// Adds a point force.
    #[must_use]
    pub fn force(mut self, force: Force) -> Scene {
        self.forces.push(force);
        self
    }

    /// Adds a probe.
    #[must_use]
    pub fn probe(mut self, probe: Probe) -> Scene {
        self.probes.push(probe);
        self
    }

    /// Sets the acceleration of gravity [g_x, g_y], m/s².
    #[must_use]
    pub fn gravity(mut self, gravity: [f64; 2]) -> Scene {
        self.gravity = gravity;
        self
    }

    /// Sets the temperature change of the rods without one of their own.
    #[must_use]
    pub fn temperature(mut self, temperature: Temperature) -> Scene {
        self.temperature = Some(temperature);
        self
    }

    /// Sets the end time, s.
    #[must_use]
    pub fn until(mut self, end: f64) -> Scene {
        self.time.end = end;
        self
    }

    /// Sets the method and its step, s (adaptive methods: the longest step). Settings that the method has no use for
    /// return to their defaults.
    ///
    /// ```
    /// use ancf::model::{Method, Scene};
    ///
    /// let scene = Scene::builtin("pendulum-flexible").unwrap().method(Method::Explicit, 2e-5);
    /// assert_eq!(scene.steps(), 100_000);
    /// ```
    #[must_use]
    pub fn method(mut self, method: Method, step: f64) -> Scene {
        (self.time.method, self.time.step) = (method, step);
        drop_idle(&mut self.time);
        self
    }

    /// Number of steps: time steps up to `time.end`, or load steps of statics (most steps along its arc length); output
    /// rows of adaptive methods. 0 where the step is not valid.
    pub fn steps(&self) -> usize {
        match self.time.method {
            Method::Static => self.time.most_rows(),
            // More steps are not allowed, nor is what is no number: a scene may be asked before it is checked.
            _ => Some((self.time.end / self.stride()).round()).filter(|steps| *steps <= MOST_STEPS).unwrap_or(0.0)
                as usize,
        }
    }

    /// Interval between times that the method has to reach, s: its step, or the output interval of adaptive methods.
    fn stride(&self) -> f64 {
        let own = self.output.interval.filter(|_| self.time.method.is_adaptive());
        own.unwrap_or(self.time.step)
    }

    /// Time after `step` steps, s; load factor in statics, or `step` itself along the arc length. A product, not a sum of steps, whose rounding would grow.
    pub fn time_after(&self, step: usize) -> f64 {
        match self.time.method {
            Method::Static if self.time.has_load_column() => step as f64,
            Method::Static => step as f64 / self.time.load_steps as f64,
            _ => step as f64 * self.stride(),
        }
    }

    /// Number of steps from one output row to the next, at least 1; in statics every load step is a row.
    pub fn rows_every(&self) -> usize {
        if self.time.method == Method::Static {
            return 1;
        }
        self.output.interval.map_or(1, |interval| (interval / self.stride()).round().max(1.0) as usize)
    }

    /// Number of steps from one shape of `output.shapes` to the next, at least 1; `None` without shapes.
    pub fn shapes_every(&self) -> Option<usize> {
        let interval = self.output.shapes.as_ref()?.interval;
        let own = interval.map(|interval| (interval / self.stride()).round().max(1.0) as usize);
        Some(own.unwrap_or_else(|| self.rows_every()))
    }

    /// Whether the state after `step` steps is an output row: the first, each [`rows_every`](Scene::rows_every)-th, and
    /// the last.
    pub fn is_row(&self, step: usize) -> bool {
        step.is_multiple_of(self.rows_every()) || step == self.steps()
    }

    /// Material of a rod: its own, or the scene's.
    pub fn material<'a>(&'a self, rod: &'a Rod) -> &'a Material {
        rod.material.as_ref().unwrap_or(&self.material)
    }

    /// Cross-section of a rod: its own, or the scene's.
    pub fn section<'a>(&'a self, rod: &'a Rod) -> &'a Section {
        rod.section.as_ref().unwrap_or(&self.section)
    }

    /// Temperature change that strains a rod: its own, or the scene's. `None` without one, or with the model "none".
    pub fn heat<'a>(&'a self, rod: &'a Rod) -> Option<&'a Temperature> {
        let temperature = rod.temperature.as_ref().or(self.temperature.as_ref());
        temperature.filter(|temperature| temperature.model != ThermalModel::None)
    }

    /// Initial position of a point or a pivot, m; `None` if there is none of this name.
    pub fn position(&self, point: &str) -> Option<[f64; 2]> {
        let pivot =
            || self.rods.iter().find(|rod| rod.pivot.as_deref() == Some(point)).and_then(|rod| self.middle(rod));
        self.points.get(point).copied().or_else(pivot)
    }

    /// Size of the structure, m: diagonal of the rectangle around its points.
    pub(crate) fn size(&self) -> f64 {
        let reach = |axis: usize| {
            let places = || self.points.values().map(move |point| point[axis]);
            places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
        };
        reach(0).hypot(reach(1))
    }

    /// Length of a rod, m; 0 if one of its ends is not a point.
    pub(crate) fn length(&self, rod: &Rod) -> f64 {
        match (self.points.get(&rod.from), self.points.get(&rod.to)) {
            (Some([x_0, y_0]), Some([x_1, y_1])) => (x_1 - x_0).hypot(y_1 - y_0),
            _ => 0.0,
        }
    }

    /// Initial position of a rod's middle, m.
    pub(crate) fn middle(&self, rod: &Rod) -> Option<[f64; 2]> {
        let ([x_0, y_0], [x_1, y_1]) = (self.points.get(&rod.from)?, self.points.get(&rod.to)?);
        Some([x_0 + 0.5 * (x_1 - x_0), y_0 + 0.5 * (y_1 - y_0)])
    }

    /// Whether the structure moves in time; not in statics.
    pub(crate) fn moves(&self) -> bool {
        self.time.method != Method::Static
    }

    /// Whether energies are recorded. Not in statics, where slowly growing loads supply exactly the stored energy.
    pub(crate) fn has_energies(&self) -> bool {
        self.output.energy && self.moves()
    }

    /// Column names of `trajectory.csv`: `t`, `load` for statics along its arc length, two for each probed quantity (one for a deflection), then the energies if
    /// requested.
    pub fn columns(&self) -> Vec<String> {
        let probed = self.probes.iter().flat_map(|probe| {
            let columns = probe.of.iter().flat_map(|quantity| quantity.suffixes().iter().copied());
            columns.map(move |suffix| format!("{}.{suffix}", probe.name))
        });
        let energies = ENERGY_COLUMNS.iter().filter(|_| self.has_energies()).map(|name| name.to_string());
        let load = self.time.has_load_column().then(|| "load".to_string());
        std::iter::once("t".to_string()).chain(load).chain(probed).chain(energies).collect()
    }
}
