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
pub const SCHEMA: &str = "ancf-converged/2";

/// Version of the numbers, whose changes stand in `fixtures/CHANGELOG.md`.
pub const VERSION: &str = "2.0";

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
    /// Version of the numbers, [`VERSION`].
    pub version: String,
    /// Version of this package.
    pub program: String,
    /// The built-in scene.
    pub scene: String,
    /// Element of its rods.
    pub element: String,
    /// The probe.
    pub probe: String,
    /// Number of the instants, without the start.
    pub count: usize,
    /// Time from one instant to the next, s.
    pub interval: f64,
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
    /// Largest difference of its velocities from those of the mesh with half the elements, m/s; `None` where they do not converge.
    pub velocity: Option<f64>,
    /// That of the reactions, N.
    pub reaction: Option<f64>,
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

/// What runs are compared with.
#[derive(Clone, Copy, Debug)]
pub struct Limit<'a> {
    /// The converged solution.
    pub solution: &'a Samples,
    /// Its uncertainty, m.
    pub uncertainty: f64,
    /// The solution on the mesh of the run, if it is known.
    pub mesh: Option<&'a Mesh>,
}

impl Reference {
    /// The converged solution with its uncertainty.
    pub fn limit(&self) -> Limit<'_> {
        Limit { solution: self.solution(), uncertainty: self.converged.uncertainty, mesh: None }
    }

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

    /// The file's text: a line for each key and each mesh.
    ///
    /// # Errors
    /// [`Error::Fixture`] if it cannot be written as JSON.
    pub fn text(&self) -> Result<String> {
        let fault = |reason: serde_json::Error| Error::fixture("fixtures/converged", reason.to_string());
        let head = serde_json::to_string_pretty(&Reference { meshes: Vec::new(), ..self.clone() }).map_err(fault)?;
        let meshes: Vec<String> =
            self.meshes.iter().map(serde_json::to_string).collect::<std::result::Result<_, _>>().map_err(fault)?;
        Ok(head.replace("\"meshes\": []", &format!("\"meshes\": [\n    {}\n  ]", meshes.join(",\n    "))))
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
        if self.version != VERSION {
            return Some(format!("its version is {}, not {VERSION}", self.version));
        }
        if (self.count, self.interval) != (benchmark.count(), benchmark.interval / benchmark.instants as f64) {
            return Some(format!("it has {} instants, every {} s", self.count, self.interval));
        }
        if ![space, time, uncertainty].into_iter().all(is_length) || uncertainty < space.max(time) {
            return Some(format!("the uncertainty {uncertainty} m does not cover space {space} m and time {time} m"));
        }
        if self.meshes.len() < 2 || self.meshes.last().map(|mesh| mesh.elements) != Some(elements) {
            return Some(format!("its last mesh is not the converged one of {elements} elements"));
        }
        let bad = self.meshes.iter().find(|mesh| {
            let Mesh { samples, time_uncertainty, .. } = mesh;
            let rates = || samples.velocity.iter().chain(&samples.reaction);
            let numbers = samples.position.iter().chain(rates()).flatten().all(|x| x.is_finite());
            let count = if benchmark.smooth && mesh.elements == elements { self.count } else { 0 };
            let whole = samples.position.len() == self.count && rates().count() == 2 * count;
            !numbers || !whole || !is_length(*time_uncertainty)
        });
        bad.map(|mesh| format!("the run with {} elements is not whole", mesh.elements))
    }

    /// Times and positions of a mesh at the ends of the benchmark's intervals.
    pub fn rows(&self, benchmark: &Benchmark, mesh: &Mesh) -> impl Iterator<Item = (f64, [f64; 2])> {
        let rows: Vec<_> = benchmark.times().into_iter().zip(mesh.samples.position.iter().copied()).collect();
        let instants = benchmark.instants;
        rows.into_iter().skip(instants - 1).step_by(instants)
    }

    /// The converged solution: that of the finest mesh.
    pub fn solution(&self) -> &Samples {
        &self.finest().samples
    }

    /// The finest mesh.
    pub fn finest(&self) -> &Mesh {
        // There is one: a reference without meshes is refused.
        &self.meshes[self.meshes.len() - 1]
    }

    /// The mesh with so many elements.
    pub fn mesh(&self, elements: usize) -> Option<&Mesh> {
        self.meshes.iter().find(|mesh| mesh.elements == elements)
    }

    /// Error in space of a mesh, m: largest distance of its solution from the converged one.
    pub fn space_error(&self, mesh: &Mesh) -> f64 {
        mesh.samples.distance(self.solution())
    }
}
