//! `fixtures/converged/`: solutions that are converged in time on each mesh, and in space as far as is stated.

use serde::{Deserialize, Serialize};

use super::case::Case;
use super::samples::Samples;
use crate::error::{Error, Result};
use ancf::model::Element;
use ancf_fixtures::CONVERGED;

/// The files' format.
pub const SCHEMA: &str = "ancf-converged/1";

/// One file: a scene with one element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// The format, [`SCHEMA`].
    pub schema: String,
    /// What the numbers are.
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
    /// How the uncertainties were found.
    pub how: Vec<String>,
    /// What is known of the finest mesh.
    pub converged: Converged,
    /// The meshes, from coarse to fine.
    pub meshes: Vec<Mesh>,
}

/// How far the finest mesh is from the limit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Converged {
    /// Elements of each rod on the finest mesh.
    pub elements: usize,
    /// Its distance from the next coarser mesh, m.
    pub space: f64,
    /// Uncertainty in time of the finest mesh, m.
    pub time: f64,
    /// Both together, m.
    pub uncertainty: f64,
    /// Order of convergence that the last three meshes show.
    pub order: Option<f64>,
    /// What that order would leave of the error in space, m; not used, as three meshes do not prove an order.
    pub extrapolated_space: Option<f64>,
}

/// The time-converged solution on one mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// Elements of each rod.
    pub elements: usize,
    /// Uncertainty in time, m: the larger of what the last halving of the step changed and the distance of the witnesses.
    pub time_uncertainty: f64,
    /// What the methods did.
    pub witnesses: Vec<Witness>,
    /// The solution.
    pub samples: Samples,
}

/// What one method did on one mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Witness {
    /// Its name.
    pub method: String,
    /// Its steps, each half the one before, s.
    pub steps: Vec<f64>,
    /// Whether the last two are extrapolated to a step of nothing.
    pub extrapolated: bool,
    /// What the last halving changed, m.
    pub change: f64,
}

impl Reference {
    /// Name of the file for a scene and an element.
    pub fn file_name(case: &Case, element: Element) -> String {
        format!("{}-{element}.json", case.scene)
    }

    /// Whether there is an embedded file for a scene and an element.
    pub fn is_embedded(case: &Case, element: Element) -> bool {
        CONVERGED.iter().any(|(name, _)| *name == Reference::file_name(case, element))
    }

    /// The embedded file for a scene and an element.
    ///
    /// # Errors
    /// [`Error::Fixture`] if there is none, or it cannot be used.
    pub fn embedded(case: &Case, element: Element) -> Result<Reference> {
        let wanted = Reference::file_name(case, element);
        match CONVERGED.iter().find(|(name, _)| *name == wanted) {
            Some((name, text)) => Reference::parse(name, text, case, element),
            None => {
                let name = case.scene;
                let reason = format!("there is no {wanted}; `ancf error-time --references {name}` writes it");
                Err(Error::Fixture { name, reason })
            }
        }
    }

    /// Reads a file and refuses one that does not hold what the study rests on.
    ///
    /// # Errors
    /// [`Error::Fixture`] with what is wrong.
    pub fn parse(name: &'static str, text: &str, case: &Case, element: Element) -> Result<Reference> {
        let refuse = |reason: String| Error::Fixture { name, reason };
        let reference: Reference = serde_json::from_str(text).map_err(|reason| refuse(reason.to_string()))?;
        match reference.fault(case, element) {
            None => Ok(reference),
            Some(fault) => Err(refuse(fault)),
        }
    }

    fn fault(&self, case: &Case, element: Element) -> Option<String> {
        let Converged { elements, space, time, uncertainty, .. } = self.converged;
        let is_length = |x: f64| x.is_finite() && x >= 0.0;
        if self.schema != SCHEMA {
            return Some(format!("its schema is {}, not {SCHEMA}", self.schema));
        }
        if self.scene != case.scene || self.element != element.word() || self.probe != case.probe {
            return Some(format!("it is of {} with {}, probe {}", self.scene, self.element, self.probe));
        }
        if self.times != case.times() {
            return Some(format!("its samples are at {:?} s, not {:?} s", self.times, case.times()));
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
            let velocities = if case.smooth { case.samples } else { 0 };
            let whole = samples.position.len() == case.samples && samples.velocity.len() == velocities;
            !numbers || !whole || !is_length(*time_uncertainty)
        });
        bad.map(|mesh| format!("the run with {} elements is not whole", mesh.elements))
    }

    /// The converged solution: that of the finest mesh.
    pub fn solution(&self) -> &Samples {
        // There is one: a reference without meshes is refused.
        &self.meshes[self.meshes.len() - 1].samples
    }

    /// A mesh.
    pub fn mesh(&self, elements: usize) -> Option<&Mesh> {
        self.meshes.iter().find(|mesh| mesh.elements == elements)
    }

    /// Distance of a mesh's time-converged solution from the converged one, m.
    pub fn space_error(&self, mesh: &Mesh) -> f64 {
        mesh.samples.distance(self.solution())
    }
}
