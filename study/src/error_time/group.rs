//! The points of one scene with one element, and what follows from them.

use serde::Serialize;

use super::case::{Continuum, ELEMENTS};
use super::grid::Subject;
use super::pareto::{DECADES, Lead, Ratio, fastest, front, leads, ratio};
use super::point::{Point, Status};
use super::reference::Converged;
use super::samples::largest;
use crate::error::{Error, Result};
use crate::paper::continuum;
use ancf::model::Element;

/// Certified solutions of statics.
const REFERENCES: &str = include_str!("../../../fixtures/references.json");

/// A scene with an element.
#[derive(Clone, Debug, Serialize)]
pub struct Group {
    /// The scene.
    pub scene: &'static str,
    /// The element.
    pub element: &'static str,
    /// How well the reference is known.
    pub reference: Converged,
    /// (Elements, error in space, m) of each mesh, at a step of nothing.
    pub space: Vec<(usize, f64)>,
    /// Distance of the reference from the continuum, where that is known.
    pub model: Option<ModelError>,
    /// Our points.
    pub points: Vec<Point>,
    /// Another program's, with errors from the limit of its own theory.
    pub peers: Vec<Point>,
}

/// What no mesh and no step can mend.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModelError {
    /// What the continuum is.
    pub continuum: String,
    /// Largest distance of the beam's reference from it at the sample times, m.
    pub distance: f64,
    /// The continuum's own uncertainty and the reference's, m.
    pub uncertainty: f64,
}

impl Group {
    /// A group of our points.
    ///
    /// # Errors
    /// [`Error::Fixture`] if the continuum cannot be read.
    pub fn new(subject: &Subject, points: Vec<Point>) -> Result<Group> {
        let reference = &subject.reference;
        Ok(Group {
            scene: subject.case.scene,
            element: subject.element.word(),
            reference: reference.converged.clone(),
            space: reference.meshes.iter().map(|mesh| (mesh.elements, reference.space_error(mesh))).collect(),
            model: subject.case.continuum.map(|continuum| model_error(subject, continuum)).transpose()?,
            points,
            peers: Vec::new(),
        })
    }

    /// Its name.
    pub fn name(&self) -> String {
        format!("{}, {}", self.scene, self.element)
    }

    /// Whether its element is the second one.
    pub fn is_second(&self) -> bool {
        self.element == ELEMENTS[1].word()
    }

    /// Whether its element has the other program's theory.
    pub fn has_theory_of_peers(&self) -> bool {
        self.element == Element::EulerBernoulli.word()
    }

    /// The other program's points where they belong: beside the element of their theory.
    pub fn own_peers(&self) -> &[Point] {
        if self.has_theory_of_peers() { &self.peers } else { &[] }
    }

    fn ours(&self) -> Vec<&Point> {
        self.points.iter().collect()
    }

    /// The Pareto front of our points.
    pub fn front(&self) -> Vec<&Point> {
        front(&self.ours())
    }

    /// The fastest point for each decade of error.
    pub fn decades(&self) -> Vec<(f64, Option<&Point>)> {
        let ours = self.ours();
        DECADES.iter().map(|&error| (error, fastest(&ours, error))).collect()
    }

    /// The other program's fastest point for an error.
    pub fn peer(&self, error: f64) -> Option<&Point> {
        fastest(&self.peers.iter().collect::<Vec<_>>(), error)
    }

    /// The other program's time over ours at equal error.
    pub fn ratio(&self, error: f64) -> Option<Ratio> {
        ratio(&self.ours(), &self.peers.iter().collect::<Vec<_>>(), error)
    }

    /// Where which family of methods is the faster one.
    pub fn leads(&self) -> Vec<Lead> {
        leads(&self.ours())
    }

    /// Number of points of a status.
    pub fn count(&self, status: Status) -> usize {
        self.points.iter().filter(|point| point.status == status).count()
    }
}

fn model_error(subject: &Subject, continuum: Continuum) -> Result<ModelError> {
    let reference = &subject.reference;
    let (name, position, uncertainty) = match continuum {
        Continuum::Solid(id) => {
            let fixture = continuum::load()?;
            let solid = fixture.solid(id)?;
            let uncertainty = fixture.windows().map(|window| solid.uncertainty(window)).fold(0.0, f64::max);
            let position = subject.case.times().into_iter().map(|t| solid.tip.at(t)).collect();
            (format!("plane solid, {id}"), position, uncertainty)
        }
        Continuum::Elastica(id) => (format!("{id}, inextensible and rigid in shear"), vec![elastica(id)?], 0.0),
    };
    let distance = largest(&reference.solution().position, &position);
    if distance.is_nan() {
        return Err(Error::Fixture {
            name: subject.case.scene,
            reason: format!("{name} has no positions at its times"),
        });
    }
    Ok(ModelError { continuum: name, distance, uncertainty: uncertainty + reference.converged.uncertainty })
}

fn elastica(id: &str) -> Result<[f64; 2]> {
    let invalid = |reason: String| Error::Fixture { name: "references.json", reason };
    let references: serde_json::Value =
        serde_json::from_str(REFERENCES).map_err(|reason| invalid(reason.to_string()))?;
    let mut entries = references["entries"].as_array().into_iter().flatten();
    let values = entries.find(|entry| entry["id"] == id).map(|entry| &entry["values"]);
    let value = |name: &str| values.and_then(|values| values[name]["f64"].as_f64());
    match (value("tip.x"), value("tip.y")) {
        (Some(x), Some(y)) => Ok([x, y]),
        _ => Err(invalid(format!("there is no {id}"))),
    }
}
