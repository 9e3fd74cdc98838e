//! A scene of the study: its probe, its sample times and its meshes.

use crate::error::{Error, Result};
use crate::scene::builtin;
use ancf::model::{Method, Scene};

/// A scene, with the quantity that is compared.
#[derive(Debug, PartialEq)]
pub struct Benchmark {
    /// Name of the built-in scene.
    pub scene: &'static str,
    /// The probe whose position is compared.
    pub probe: &'static str,
    /// Time from one sample to the next, s; the load factor in statics.
    pub interval: f64,
    /// Number of samples, without the start, which is exact.
    pub samples: usize,
    /// Elements of each rod. The finest mesh is the reference; the mesh with half its elements shows its uncertainty.
    pub meshes: &'static [usize],
    /// Whether velocities converge: not if a sudden load has started undamped waves.
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
    /// The built-in scene.
    pub fn built_in(&self) -> Result<Scene> {
        builtin(self.scene)
    }

    /// Name of the probe's point.
    pub fn point(&self) -> Result<String> {
        let probes = self.built_in()?.probes;
        let point = probes.into_iter().find(|probe| probe.name == self.probe).and_then(|probe| probe.point);
        point.ok_or_else(|| Error::fixture(self.scene, format!("there is no probe {}", self.probe)))
    }

    /// Whether it is solved by statics.
    pub fn is_static(&self) -> bool {
        self.witnesses[0].0 == Method::Static
    }

    /// Times of the samples, s.
    pub fn times(&self) -> Vec<f64> {
        (1..=self.samples).map(|n| n as f64 * self.interval).collect()
    }
}
