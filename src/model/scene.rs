//! The scene as plain data: what is simulated, for how long, by which method, and what is recorded.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::choice::{Constraints, Form, Method, Schema, ThermalModel, is_default};
use super::heat::Temperature;
use super::json::shape;
use super::loads::Force;
use super::motion::Motion;
use super::probes::{ENERGY_COLUMNS, Probe};
use super::rod::{Material, Rod, Section};
use super::supports::Support;
use super::time::{Output, Time};

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

impl Scene {
    /// A scene without points and rods, everything else at its default: at rest, neither heated nor loaded, for 1 s.
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
            constraints: Constraints::default(),
            form: Form::default(),
            time: Time::until(1.0),
            output: Output::default(),
            probes: Vec::new(),
        }
    }

    /// Adds a point at [x, y], m.
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

    /// Adds a force.
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

    /// Sets the gravity [g_x, g_y], m/s².
    #[must_use]
    pub fn gravity(mut self, gravity: [f64; 2]) -> Scene {
        self.gravity = gravity;
        self
    }

    /// Sets the temperature of all rods that have none of their own.
    #[must_use]
    pub fn temperature(mut self, temperature: Temperature) -> Scene {
        self.temperature = Some(temperature);
        self
    }

    /// Sets the end, s.
    #[must_use]
    pub fn until(mut self, end: f64) -> Scene {
        self.time.end = end;
        self
    }

    /// Sets the method and its step (s); adaptive methods take it as their longest one.
    #[must_use]
    pub fn method(mut self, method: Method, step: f64) -> Scene {
        (self.time.method, self.time.step) = (method, step);
        self
    }

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
    pub(crate) fn has_energies(&self) -> bool {
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
