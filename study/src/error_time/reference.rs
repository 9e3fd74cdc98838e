//! `fixtures/converged/`: solutions that have converged in time on each mesh, and in space to a stated uncertainty.

use serde::{Deserialize, Serialize};

use super::benchmark::Benchmark;
use super::samples::Samples;
use crate::error::{Error, Result};
use crate::fixture;
use ancf::internals::model::Words;
use ancf::model::Element;
use ancf_fixtures::CONVERGED;

/// The files' format.
pub const SCHEMA: &str = "ancf-converged/1";

/// Content of a file: a scene with one element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// The format, [`SCHEMA`].
    pub schema: String,
    /// Title of the content.
    pub title: String,
    /// The command that writes the file.
    pub command: String,
    /// Version of this package.
    pub version: String,
    /// The built-in scene.
    pub scene: String,
    /// Element of its rods.
    pub element: String,
    /// The probe.
    pub probe: String,
    /// Times of the samples, s.
    pub times: Vec<f64>,
    /// Explanation of the uncertainties.
    pub how: Vec<String>,
    /// Uncertainty of the finest mesh.
    pub converged: Converged,
    /// The meshes, from coarse to fine.
    pub meshes: Vec<Mesh>,
}

/// Distance of the finest mesh from the limit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Converged {
    /// Elements of each rod on the finest mesh.
    pub elements: usize,
    /// Distance from the mesh with half the elements, m.
    pub space: f64,
    /// Uncertainty in time of the finest mesh, m.
    pub time: f64,
    /// Sum of both, m.
    pub uncertainty: f64,
    /// Observed order of convergence of the last three meshes.
    pub order: Option<f64>,
    /// Error in space that this order would leave, m; not used, as three meshes do not prove an order.
    pub extrapolated_space: Option<f64>,
}

/// The time-converged solution on one mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// Elements of each rod.
    pub elements: usize,
    /// Uncertainty in time, m: the larger of the change by the last halving of the step and the distance of the witnesses.
    pub time_uncertainty: f64,
    /// The two methods.
    pub witnesses: Vec<Witness>,
    /// The solution.
    pub samples: Samples,
}

/// Runs of one method on one mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Witness {
    /// Its name.
    pub method: String,
    /// Its steps, each half the one before, s.
    pub steps: Vec<f64>,
    /// Whether the last two are extrapolated to a step of zero.
    pub extrapolated: bool,
    /// Change by the last halving, m.
    pub change: f64,
}

impl Reference {
    /// Name of the file for a scene and an element.
    pub fn file_name(benchmark: &Benchmark, element: Element) -> String {
        format!("{}-{element}.json", benchmark.scene)
    }

    /// Whether there is an embedded file for a scene and an element.
    pub fn is_embedded(benchmark: &Benchmark, element: Element) -> bool {
        CONVERGED.iter().any(|(name, _)| *name == Reference::file_name(benchmark, element))
    }

    /// The embedded file for a scene and an element.
    ///
    /// # Errors
    /// [`Error::Fixture`] if there is none, or it cannot be used.
    pub fn embedded(benchmark: &Benchmark, element: Element) -> Result<Reference> {
        let wanted = Reference::file_name(benchmark, element);
        let missing = || {
            let scene = benchmark.scene;
            Error::fixture(scene, format!("there is no {wanted}; `ancf error-time --references {scene}` writes it"))
        };
        let (name, text) = CONVERGED.iter().find(|(name, _)| *name == wanted).ok_or_else(missing)?;
        Reference::parse(name, text, benchmark, element)
    }

    /// Reads a file, and refuses one that is incomplete or of something else.
    ///
    /// # Errors
    /// [`Error::Fixture`] with what is wrong.
    pub fn parse(name: &'static str, text: &str, benchmark: &Benchmark, element: Element) -> Result<Reference> {
        let reference: Reference = fixture::parse(name, text)?;
        let fault = reference.fault(benchmark, element);
        fault.map_or(Ok(reference), |fault| Err(Error::fixture(name, fault)))
    }

    fn fault(&self, benchmark: &Benchmark, element: Element) -> Option<String> {
        let Converged { elements, space, time, uncertainty, .. } = self.converged;
        let is_length = |x: f64| x.is_finite() && x >= 0.0;
        if self.schema != SCHEMA {
            return Some(format!("its schema is {}, not {SCHEMA}", self.schema));
        }
        if self.scene != benchmark.scene || self.element != element.word() || self.probe != benchmark.probe {
            return Some(format!("it is of {} with {}, probe {}", self.scene, self.element, self.probe));
        }
        if self.times != benchmark.times() {
            return Some(format!("its samples are at {:?} s, not {:?} s", self.times, benchmark.times()));
        }
        if ![space, time, uncertainty].into_iter().all(is_length) || uncertainty < space.max(time) {
            return Some(format!("the uncertainty {uncertainty} m does not cover space {space} m and time {time} m"));
        }
        if self.meshes.len() < 2 || self.meshes.last().map(|mesh| mesh.elements) != Some(elements) {
            return Some(format!("its last mesh is not the converged one of {elements} elements"));
        }
        let bad = self.meshes.iter().find(|mesh| {
            let Mesh { samples, time_uncertainty, .. } = mesh;
            let numbers = samples.position.iter().chain(&samples.velocity).flatten().all(|x| x.is_finite());
            let velocities = if benchmark.smooth { benchmark.samples } else { 0 };
            let whole = samples.position.len() == benchmark.samples && samples.velocity.len() == velocities;
            !numbers || !whole || !is_length(*time_uncertainty)
        });
        bad.map(|mesh| format!("the run with {} elements is not whole", mesh.elements))
    }

    /// The converged solution: that of the finest mesh.
    pub fn solution(&self) -> &Samples {
        // There is one: a reference without meshes is refused.
        &self.meshes[self.meshes.len() - 1].samples
    }

    /// The mesh with so many elements.
    pub fn mesh(&self, elements: usize) -> Option<&Mesh> {
        self.meshes.iter().find(|mesh| mesh.elements == elements)
    }

    /// Error in space of a mesh, m: distance of its solution from the converged one.
    pub fn space_error(&self, mesh: &Mesh) -> f64 {
        mesh.samples.distance(self.solution())
    }
}
