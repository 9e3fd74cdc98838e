//! A point of the study: a run with its error and its time, or the reason of its failure.

use serde::{Serialize, Serializer};

use super::reference::{Limit, Reference};
use super::samples::Samples;
use super::setup::Setup;
use super::timing::Timing;
use ancf::integrators::Counts;
use ancf::model::Element;

/// Name of this program.
pub const OURS: &str = "ancf";

/// An error below this many uncertainties of the reference may be the reference's.
const LIMIT: f64 = 3.0;

/// Status of a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Status {
    /// Error and time are known.
    Ok,
    /// The error is within three uncertainties of the reference: the true error may be smaller.
    AtLimit,
    /// A run of the method is as accurate in a fraction of the time; this one was timed only once.
    Outclassed,
    /// The run ended with an error.
    #[default]
    Failed,
}

impl Serialize for Status {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}

impl Status {
    /// The word in files.
    pub fn word(self) -> &'static str {
        match self {
            Status::Ok => "ok",
            Status::AtLimit => "at the reference's limit",
            Status::Outclassed => "outclassed",
            Status::Failed => "failed",
        }
    }

    /// The status of a run that succeeded.
    pub fn of(error: f64, uncertainty: f64) -> Status {
        if error.is_nan() {
            Status::Failed
        } else if error < LIMIT * uncertainty {
            Status::AtLimit
        } else {
            Status::Ok
        }
    }
}

/// Distances from the reference, each the largest over all instants.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Distance of the position at the instants, m.
    pub position: f64,
    /// What it may be larger between the instants, m.
    pub between: f64,
    /// Error of the interpolation between the steps of the run, m.
    pub interpolation: f64,
    /// Difference of the velocity, m/s, where velocities converge.
    pub velocity: Option<f64>,
    /// Difference of the first support's force, N, where it converges; in statics its distance from the sum of the loads.
    pub reaction: Option<f64>,
    /// Energy balance over all steps, J; no measure of accuracy.
    pub energy: Option<f64>,
    /// Distance from the time-converged solution of the mesh, m.
    pub time: Option<f64>,
    /// That solution's distance from the reference, m.
    pub space: Option<f64>,
    /// Distance of the run from a plane solid, m, at its instants, and at least that of the theory's own solution.
    pub solid: Option<f64>,
}

impl Errors {
    /// The error that a point is drawn at and judged by, m: the largest of the position's and of its parts in time and space, which may cancel
    /// by chance, with what it may be larger between the instants.
    pub fn shown(&self) -> f64 {
        let parts = [self.time, self.space].into_iter().flatten();
        parts.fold(self.position, f64::max) + self.between
    }
}

/// A run with its error and its time.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Point {
    /// The program: [`OURS`], or another with its version.
    pub program: String,
    /// The scene.
    pub scene: String,
    /// The program's name of the element.
    pub element: String,
    /// Whether its theory has shear.
    pub has_shear: bool,
    /// The method.
    pub method: String,
    /// Whether the largest frequency limits the step.
    pub explicit: bool,
    /// Elements of each rod.
    pub elements: usize,
    /// Step, s; part of the load in statics.
    pub step: Option<f64>,
    /// Tolerance of the local error of a step, m.
    pub tolerance: Option<f64>,
    /// Newton's tolerance, relative to the largest force term; `None` without an iteration.
    pub newton_tolerance: Option<f64>,
    /// Other settings of another program, in words.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub options: String,
    /// Errors; `None` if it failed.
    pub errors: Option<Errors>,
    /// Uncertainty of the reference, m.
    pub reference_uncertainty: f64,
    /// Run time; `None` if it failed.
    pub time: Option<Timing>,
    /// Wall time until the failure, s.
    pub failed_after: Option<f64>,
    /// Work of the run.
    pub counts: Counts,
    /// Rejected steps; `None` if the method does not count them.
    pub rejected: Option<usize>,
    /// The status.
    pub status: Status,
    /// The reason of its failure.
    pub reason: String,
}

impl Point {
    /// A point of ours before its run: failed, without a reason.
    pub fn new(setup: &Setup, reference: &Reference) -> Point {
        Point {
            program: OURS.into(),
            scene: setup.benchmark.scene.into(),
            element: setup.element.to_string(),
            has_shear: setup.element == Element::Ancf,
            method: setup.technique.method.to_string(),
            explicit: setup.technique.explicit,
            elements: setup.elements,
            step: setup.resolution.step(setup.benchmark.interval),
            tolerance: setup.resolution.tolerance(),
            newton_tolerance: (!setup.technique.explicit).then_some(setup.technique.newton_tolerance),
            reference_uncertainty: reference.converged.uncertainty,
            ..Point::default()
        }
    }

    /// Error of the position, m: [`Errors::shown`].
    pub fn error(&self) -> Option<f64> {
        self.errors.as_ref().map(Errors::shown)
    }

    /// Whether its time was taken in turns with others.
    pub fn in_turns(&self) -> bool {
        self.time.as_ref().is_some_and(|time| time.in_turns)
    }

    /// Median run time, s.
    pub fn seconds(&self) -> Option<f64> {
        self.time.as_ref().map(|time| time.median)
    }

    /// Upper bound of the true error at any time, m: the error, what interpolation may hide, and the reference's uncertainty.
    pub fn bound(&self) -> Option<f64> {
        let errors = self.errors.as_ref().filter(|_| self.status != Status::Failed)?;
        Some(errors.shown() + errors.interpolation + self.reference_uncertainty)
    }

    /// Sets errors and status from the motion at the instants and the error of their interpolation.
    pub fn compare(&mut self, samples: &Samples, interpolation: f64, limit: &Limit) {
        let Limit { solution, uncertainty, mesh } = *limit;
        let errors = Errors {
            position: samples.distance(solution),
            between: samples.between(solution),
            interpolation,
            velocity: samples.velocity_difference(solution),
            reaction: None,
            energy: None,
            time: mesh.map(|mesh| samples.distance(&mesh.samples)),
            space: mesh.map(|mesh| mesh.samples.distance(solution)),
            solid: None,
        };
        let known = errors.position.is_finite() && errors.interpolation.is_finite();
        self.status = Status::of(if known { errors.shown() } else { f64::NAN }, uncertainty);
        if self.status == Status::Failed {
            self.reason = "positions are missing, or are not numbers".into();
            return;
        }
        self.errors = Some(errors);
    }

    /// Method, mesh, step and tolerances, for people.
    pub fn what(&self) -> String {
        let elements = if self.elements == 1 { "1 element".into() } else { format!("{} elements", self.elements) };
        let newton = self.newton_tolerance.map_or(String::new(), |tolerance| format!(", Newton to {tolerance:.0e}"));
        let how = match (self.step, self.tolerance) {
            (_, Some(tolerance)) => format!("{}, {elements}, tolerance {tolerance:.0e} m", self.method),
            (Some(step), None) if self.method == "static" => {
                let count = (1.0 / step).round();
                let plural = if count == 1.0 { "step" } else { "steps" };
                format!("{}, {elements}, {count} load {plural}", self.method)
            }
            (Some(step), None) => format!("{}, {elements}, step {step:.2e} s", self.method),
            (None, None) => format!("{}, {elements}", self.method),
        };
        how + &newton
    }
}
