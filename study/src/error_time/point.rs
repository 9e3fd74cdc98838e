//! One point of the study: a run with its error and its time, or why there is none.

use serde::{Deserialize, Serialize};

use super::reference::{Mesh, Reference};
use super::samples::Samples;
use super::timing::Timing;
use super::trial::Trial;
use ancf::integrators::counts::Counts;

/// Name of this program among others.
pub const OURS: &str = "ancf";

/// An error below this many uncertainties of the reference says more of the reference than of the run.
const LIMIT: f64 = 3.0;

/// What a point is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// Error and time are known.
    #[serde(rename = "ok")]
    Ok,
    /// The error is within three uncertainties of the reference: the point is better than can be told.
    #[serde(rename = "at the reference's limit")]
    AtLimit,
    /// The same method is more accurate in a fraction of the time, so that this run was timed only once.
    #[serde(rename = "outclassed")]
    Outclassed,
    /// The run ended with an error.
    #[serde(rename = "failed")]
    Failed,
}

impl Status {
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

/// Distances from the reference.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Errors {
    /// Largest distance of the position at the sample times, m.
    pub position: f64,
    /// R.m.s. of the velocity's difference over the sample times, m/s, where velocities converge.
    pub velocity: Option<f64>,
    /// Statics: distance of the support's force from what the loads are, N.
    pub reaction: Option<f64>,
    /// Largest energy balance at the sample times, J; a small one says nothing of the accuracy.
    pub energy: Option<f64>,
    /// Distance from the same mesh's time-converged solution, m.
    pub time: Option<f64>,
    /// That solution's distance from the reference, m.
    pub space: Option<f64>,
}

/// One point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// The program, [`OURS`] or another's name and version.
    pub program: String,
    /// The scene.
    pub scene: String,
    /// Its element, as the program calls it.
    pub element: String,
    /// The method.
    pub method: String,
    /// Whether its step is limited by the largest frequency.
    pub explicit: bool,
    /// Elements of each rod.
    pub elements: usize,
    /// Its step, s; part of the load in statics.
    pub step: Option<f64>,
    /// Local error of a step, m.
    pub tolerance: Option<f64>,
    /// Where Newton's iteration ends, relative to the largest force term; `None` without one.
    pub newton_tolerance: Option<f64>,
    /// Its errors; `None` if it failed.
    pub errors: Option<Errors>,
    /// Uncertainty of the reference, m.
    pub reference_uncertainty: f64,
    /// Its time; `None` if it failed.
    pub time: Option<Timing>,
    /// Wall time until it failed, s.
    pub failed_after: Option<f64>,
    /// The work that was done.
    pub counts: Counts,
    /// Steps that a method made and took back; `None` if it does not count them.
    pub rejected: Option<usize>,
    /// What it is good for.
    pub status: Status,
    /// Why it failed.
    pub reason: String,
}

impl Point {
    /// The point of one of our runs that has not been timed yet.
    pub fn new(trial: &Trial, reference: &Reference) -> Point {
        Point {
            program: OURS.into(),
            scene: trial.case.scene.into(),
            element: trial.element.to_string(),
            method: trial.technique.method.to_string(),
            explicit: trial.technique.explicit,
            elements: trial.elements,
            step: trial.setting.step(trial.case.interval),
            tolerance: trial.setting.tolerance(),
            newton_tolerance: (!trial.technique.explicit).then_some(trial.technique.newton_tolerance),
            errors: None,
            reference_uncertainty: reference.converged.uncertainty,
            time: None,
            failed_after: None,
            counts: Counts::default(),
            rejected: None,
            status: Status::Failed,
            reason: String::new(),
        }
    }

    /// The position's error, m.
    pub fn error(&self) -> Option<f64> {
        self.errors.as_ref().map(|errors| errors.position)
    }

    /// The median of its time, s.
    pub fn seconds(&self) -> Option<f64> {
        self.time.as_ref().map(|time| time.median)
    }

    /// What the true error is not above, m. Above the reference's limit the error is known to a third of itself or better,
    /// and stands for itself. At the limit it may be the reference that is close by chance: the run is off by the error and
    /// the reference's uncertainty at most, and so it still proves itself better than a bound that is far above both.
    pub fn bound(&self) -> Option<f64> {
        let uncertainty = if self.status == Status::AtLimit { self.reference_uncertainty } else { 0.0 };
        self.error().filter(|_| self.status != Status::Failed).map(|error| error + uncertainty)
    }

    /// Takes the errors of its samples; `mesh` is that of the reference, where it has this one.
    pub fn compare(&mut self, samples: &Samples, reference: &Reference, mesh: Option<&Mesh>) {
        let position = samples.distance(reference.solution());
        self.status = Status::of(position, reference.converged.uncertainty);
        if self.status == Status::Failed {
            self.reason = "positions are missing, or are no numbers".into();
            return;
        }
        self.errors = Some(Errors {
            position,
            velocity: samples.velocity_difference(reference.solution()),
            reaction: None,
            energy: None,
            time: mesh.map(|mesh| samples.distance(&mesh.samples)),
            space: mesh.map(|mesh| reference.space_error(mesh)),
        });
    }

    /// Its mesh, its step and its tolerances for a person.
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
