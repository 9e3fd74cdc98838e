//! A scene of the study: its probe, the instants of its errors and its meshes.

use crate::error::{Error, Result};
use crate::scene::{Change, builtin};
use ancf::model::{Element, Method, Scene};

/// A scene, with the quantity that is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Benchmark {
    /// Name of the built-in scene.
    pub scene: &'static str,
    /// The probe whose position is compared.
    pub probe: &'static str,
    /// The scene, if it is no built-in one.
    pub own: Option<&'static Scene>,
    /// Size of its motion, of which errors are parts, m.
    pub unit: f64,
    /// Time from one row of a timed run to the next, s; the load factor in statics.
    pub interval: f64,
    /// Number of intervals.
    pub rows: usize,
    /// Instants in an interval at which errors are taken.
    pub instants: usize,
    /// Elements of each rod. The finest mesh is the reference; the mesh with half its elements shows its uncertainty.
    pub meshes: &'static [usize],
    /// Whether velocities and reactions converge: not if a sudden load has started undamped waves.
    pub smooth: bool,
    /// Longest step, as a part of the interval, of methods without a stability limit; number of load steps in statics.
    pub coarsest: usize,
    /// Two methods that have to agree on the references, and the part of the interval that is their first step. An explicit method starts at
    /// its limit.
    pub witnesses: [(Method, usize); 2],
    /// A solution of the continuum that the beam models, if known.
    pub continuum: Option<ContinuumSolution>,
}

/// A solution that does not come from our beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContinuumSolution {
    /// A run of `fixtures/continuum.json`.
    Solid(&'static str),
    /// An entry of `fixtures/references.json`.
    Elastica(&'static str),
}

impl Benchmark {
    /// The scene as it was written.
    pub fn model(&self) -> Result<Scene> {
        self.own.map_or_else(|| builtin(self.scene), |scene| Ok(scene.clone()))
    }

    /// The scene with so many elements in a rod. A scene of the user's own keeps the elements of its rods, and their proportions: the number is
    /// that of its first rod.
    pub fn meshed(&self, element: Element, elements: usize) -> Result<Scene> {
        let mut scene = self.model()?;
        let Some(first) = scene.rods.first().map(|rod| rod.elements).filter(|_| self.own.is_some()) else {
            return Ok(scene.meshed(element, elements));
        };
        scene.rods.iter_mut().for_each(|rod| rod.elements = rod.elements * elements / first);
        Ok(scene)
    }

    /// Name of the probe's point.
    pub fn point(&self) -> Result<String> {
        let probes = self.model()?.probes;
        let point = probes.into_iter().find(|probe| probe.name == self.probe).and_then(|probe| probe.point);
        point.ok_or_else(|| Error::fixture(self.scene, format!("there is no probe {}", self.probe)))
    }

    /// Whether it is solved by statics.
    pub fn is_static(&self) -> bool {
        self.witnesses[0].0 == Method::Static
    }

    /// Number of the instants, without the start, which is exact.
    pub fn count(&self) -> usize {
        self.rows * self.instants
    }

    /// The instants at which errors are taken, s.
    pub fn times(&self) -> Vec<f64> {
        (1..=self.count()).map(|n| n as f64 * self.interval / self.instants as f64).collect()
    }
}
