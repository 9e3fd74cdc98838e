//! The points of one scene with one element, and the results derived from them.

use serde::Serialize;

use super::benchmark::ContinuumSolution;
use super::grid::Subject;
use super::pareto::{DECADES, Lead, Ratio, fastest, in_turns, leads, pareto_front, ratio};
use super::point::{Point, Status};
use super::reference::Converged;
use crate::error::{Error, Result};
use crate::fixture::Certified;
use crate::paper::continuum::Continuum;
use crate::paper::tip::Tip;
use crate::path::largest_distance;
use ancf::internals::model::Words;
use ancf::model::Element;

/// A scene with an element.
#[derive(Clone, Debug, Serialize)]
pub struct Group {
    /// The scene.
    pub scene: &'static str,
    /// The element.
    pub element: &'static str,
    /// Uncertainty of the reference.
    pub reference: Converged,
    /// Size of the motion, m.
    pub unit: f64,
    /// (Elements, error in space, m) of each mesh, converged in time.
    pub space: Vec<(usize, f64)>,
    /// Distance of the reference from the continuum, if that is known.
    pub model: Option<ModelError>,
    /// Whether the scene is the user's own.
    pub is_own: bool,
    /// Our points.
    pub points: Vec<Point>,
    /// Another program's, with errors from the limit of its own theory.
    pub peers: Vec<Point>,
    /// Whether those have the theory of the group's element: without shear the Euler–Bernoulli element's, with shear the paper's.
    pub same_theory: bool,
}

/// Error of the beam model, which no mesh and no step reduces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModelError {
    /// Name of the continuum's solution.
    pub continuum: String,
    /// Largest distance of the beam's reference from it, m.
    pub distance: f64,
    /// Uncertainties of the continuum and of the reference, m.
    pub uncertainty: f64,
}

impl Group {
    /// A group of our points.
    ///
    /// # Errors
    /// [`Error::Fixture`] if the continuum's solution cannot be read.
    pub fn new(subject: &Subject, points: Vec<Point>) -> Result<Group> {
        let reference = &subject.reference;
        Ok(Group {
            scene: subject.benchmark.scene,
            element: subject.element.word(),
            reference: reference.converged.clone(),
            unit: subject.benchmark.unit,
            space: reference.meshes.iter().map(|mesh| (mesh.elements, reference.space_error(mesh))).collect(),
            model: subject.benchmark.continuum.map(|solution| model_error(subject, solution)).transpose()?,
            is_own: subject.benchmark.own.is_some(),
            points,
            peers: Vec::new(),
            same_theory: false,
        })
    }

    /// Scene and element.
    pub fn name(&self) -> String {
        format!("{}, {}", self.scene, self.element)
    }

    /// Whether its element is Euler–Bernoulli.
    pub fn is_euler_bernoulli(&self) -> bool {
        self.element == Element::EulerBernoulli.word()
    }

    /// The other program's points of the group's own theory; they stand in one group only.
    pub fn own_peers(&self) -> &[Point] {
        if self.same_theory { &self.peers } else { &[] }
    }

    /// All points of the group: ours, and the other program's of the same theory.
    pub fn all_points(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().chain(self.own_peers())
    }

    /// Takes the other program's points that this element is compared with: those of its own theory, or all where there are none.
    pub fn compare(&mut self, peers: &[Point]) {
        let own: Vec<Point> =
            peers.iter().filter(|peer| peer.has_shear != self.is_euler_bernoulli()).cloned().collect();
        self.same_theory = !own.is_empty();
        self.peers = if own.is_empty() { peers.to_vec() } else { own };
    }

    fn ours(&self) -> Vec<&Point> {
        self.points.iter().collect()
    }

    fn theirs(&self) -> Vec<&Point> {
        self.peers.iter().collect()
    }

    /// The Pareto front of our points.
    pub fn pareto_front(&self) -> Vec<&Point> {
        pareto_front(&self.ours())
    }

    /// Our fastest point for each decade of error.
    pub fn decades(&self) -> Vec<(f64, Option<&Point>)> {
        let ours = in_turns(&self.ours());
        DECADES.iter().map(|error| error * self.unit).map(|error| (error, fastest(&ours, error))).collect()
    }

    /// The other program's fastest point for an error.
    pub fn peer(&self, error: f64) -> Option<&Point> {
        fastest(&in_turns(&self.theirs()), error)
    }

    /// The other program's time over ours at equal error.
    pub fn ratio(&self, error: f64) -> Option<Ratio> {
        ratio(&in_turns(&self.ours()), &in_turns(&self.theirs()), error)
    }

    /// The faster family of methods by ranges of error; empty without explicit points.
    pub fn leads(&self) -> Vec<Lead> {
        if self.points.iter().any(|point| point.explicit) { leads(&self.ours()) } else { Vec::new() }
    }

    /// Number of points with a status.
    pub fn count(&self, status: Status) -> usize {
        self.points.iter().filter(|point| point.status == status).count()
    }
}

fn model_error(subject: &Subject, solution: ContinuumSolution) -> Result<ModelError> {
    let (benchmark, reference) = (subject.benchmark, &subject.reference);
    let known = reference.solution();
    let (continuum, distance, uncertainty) = match solution {
        ContinuumSolution::Solid(id) => {
            let fixture = Continuum::load()?;
            let solid = fixture.solid(id)?;
            let uncertainty = fixture.windows().map(|window| solid.uncertainty(window)).fold(0.0, f64::max);
            // At the solid's instants, every 0.01 s.
            let beam = Tip { t: benchmark.times(), r: known.position.clone() };
            (format!("plane solid, {id}"), beam.largest_distance(&solid.tip, |t| t > 0.0), uncertainty)
        }
        ContinuumSolution::Elastica(id) => {
            let elastica = Certified::load(id)?.tip()?;
            let continuum = format!("{id}, inextensible and rigid in shear");
            (continuum, largest_distance(&known.position, &[elastica]), 0.0)
        }
    };
    if distance.is_nan() {
        return Err(Error::fixture(benchmark.scene, format!("{continuum} has no positions at its times")));
    }
    Ok(ModelError { continuum, distance, uncertainty: uncertainty + reference.converged.uncertainty })
}
