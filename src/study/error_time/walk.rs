//! The grid: which meshes and steps are tried for a scene, an element and a method, and which of them are timed.

use super::case::Case;
use super::point::{Point, Status};
use super::reference::{Mesh, Reference};
use super::samples::{Samples, largest};
use super::technique::Technique;
use super::timing::{Timing, repeated, timed};
use super::trial::{Record, Trial};
use crate::error::{Error, Result};
use crate::run::{Run, run};
use crate::scene::Element;

/// Error in time over that in space below which a mesh has no use for a shorter step.
const FINE: f64 = 0.1;

/// The same ratio over which a step is too long for any finer mesh.
const COARSE: f64 = 10.0;

/// Failures in a row after which a mesh is given up.
const FAILURES: usize = 6;

/// A run of the same method that is at least as accurate in less than this part of the time makes a point useless.
const OUTCLASSED: f64 = 1.0 / 3.0;

/// An explicit run that would take this many times the longest one is not begun.
const MOST_RUNS_OVER: f64 = 2.0;

/// How far the grid reaches.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// A run that takes longer is the last of its mesh, s.
    pub longest_run: f64,
    /// Elements of each rod at most.
    pub finest_mesh: usize,
}

impl Reach {
    /// The whole study.
    pub const FULL: Reach = Reach { longest_run: 1.0, finest_mesh: usize::MAX };
    /// A first look.
    pub const QUICK: Reach = Reach { longest_run: 0.1, finest_mesh: 16 };
}

/// A scene and an element with their reference.
#[derive(Debug)]
pub struct Subject {
    /// The scene.
    pub case: &'static Case,
    /// The element.
    pub element: Element,
    /// Its converged solutions.
    pub reference: Reference,
}

impl Subject {
    /// Meshes that are worth a run: up to the first that is as good as the reference.
    pub fn meshes(&self, reach: &Reach) -> Vec<&Mesh> {
        let uncertainty = self.reference.converged.uncertainty;
        let at_limit = |mesh: &&Mesh| Status::of(self.reference.space_error(mesh), uncertainty) == Status::AtLimit;
        let meshes = &self.reference.meshes;
        let useful = meshes.iter().position(|mesh| at_limit(&mesh)).map_or(meshes.len(), |first| first + 1);
        meshes[..useful].iter().filter(|mesh| mesh.elements <= reach.finest_mesh).collect()
    }

    /// All points of one method.
    ///
    /// # Errors
    /// [`Error::Fixture`] for scenes that do not have what the study asks for. A run that fails is a point.
    pub fn walk(&self, technique: &'static Technique, reach: &Reach, on_mesh: impl Fn()) -> Result<Vec<Point>> {
        let &Subject { case, element, ref reference } = self;
        let mut tried: Vec<(Trial, Point)> = Vec::new();
        let mut start = None;
        for mesh in self.meshes(reach) {
            let elements = mesh.elements;
            let mut trial = Trial { case, element, elements, technique, setting: super::trial::Setting::Steps(1) };
            trial.setting = match start {
                // What was too long for a coarser mesh is so for this one; an explicit limit is each mesh's own, and so is
                // the number of load steps, which is a matter of finding the equilibrium.
                Some(setting) if !technique.explicit && !technique.is_static() => setting,
                _ => trial.first_setting()?,
            };
            if trial.explicit_seconds()? > MOST_RUNS_OVER * reach.longest_run {
                // Finer meshes take longer still.
                break;
            }
            start = None;
            let mut failures = 0;
            loop {
                let (point, seconds) = screen(&trial, reference, mesh)?;
                let ratio = point.errors.as_ref().and_then(|errors| Some(errors.time? / errors.space?));
                let (status, useful) = (point.status, ratio.is_some_and(|ratio| ratio <= COARSE));
                tried.push((trial, point));
                failures = if status == Status::Failed { failures + 1 } else { 0 };
                if useful && start.is_none() {
                    start = Some(trial.setting);
                }
                let fine = ratio.is_some_and(|ratio| ratio < FINE) || status == Status::AtLimit;
                if fine || failures == FAILURES || 2.0 * seconds > reach.longest_run {
                    break;
                }
                trial.setting = trial.setting.finer();
            }
            // No step was short enough in the time there is: a finer mesh begins where this one ended.
            start = start.or(Some(trial.setting));
            on_mesh();
        }
        time_useful(tried)
    }
}

/// A first run, with everything that is recorded but not timed, and a second with the time that tells which points are
/// worth more.
fn screen(trial: &Trial, reference: &Reference, mesh: &Mesh) -> Result<(Point, f64)> {
    let mut point = Point::new(trial, reference);
    let recorded = record(trial)?;
    let (run, seconds) = timed(trial);
    match run {
        Err(error) => {
            (point.reason, point.failed_after) = (error.to_string(), Some(seconds));
        }
        Ok(run) => {
            (point.counts, point.rejected) = (run.counts, Some(run.counts.rejected));
            let positions = Samples::of(trial.case, &run);
            point.compare(&positions, reference, Some(mesh));
            point.time = Timing::of(&[seconds]);
            if let (Some(errors), Some(recorded)) = (&mut point.errors, recorded) {
                let samples = Samples::of(trial.case, &recorded);
                errors.velocity = samples.velocity_difference(reference.solution());
                errors.energy = energy_balance(&recorded);
                errors.reaction = reaction_error(trial, &recorded)?;
            }
        }
    }
    Ok((point, seconds))
}

/// The run that is not timed; `None` if it fails.
fn record(trial: &Trial) -> Result<Option<Run>> {
    match run(&trial.scene(Record::Energies)?) {
        // Without the energies nobody notices: the point has an error in position, and a large one.
        Err(Error::EnergyAppeared { .. }) => Ok(run(&trial.scene(Record::All)?).ok()),
        run => Ok(run.ok()),
    }
}

fn energy_balance(run: &Run) -> Option<f64> {
    let balance = run.trajectory.column("energy.balance")?;
    balance.into_iter().map(f64::abs).max_by(f64::total_cmp)
}

fn reaction_error(trial: &Trial, run: &Run) -> Result<Option<f64>> {
    let column = |suffix: &str| {
        let name = run.trajectory.columns.iter().find(|name| name.ends_with(suffix))?;
        run.trajectory.column(name)?.last().copied()
    };
    match (trial.is_static(), column(".rx"), column(".ry")) {
        (true, Some(x), Some(y)) => Ok(Some(largest(&[[x, y]], &[trial.exact_reaction()?]))),
        _ => Ok(None),
    }
}

/// Times the points that no other of the same method makes useless.
fn time_useful(tried: Vec<(Trial, Point)>) -> Result<Vec<Point>> {
    let known: Vec<(f64, f64)> = tried.iter().filter_map(|(_, point)| point.bound().zip(point.seconds())).collect();
    let mut points = Vec::new();
    for (trial, mut point) in tried {
        if let Some((bound, seconds)) = point.bound().zip(point.seconds()) {
            if known.iter().any(|&(error, time)| error <= bound && time < OUTCLASSED * seconds) {
                if point.status == Status::Ok {
                    point.status = Status::Outclassed;
                }
            } else {
                point.time = Timing::of(&repeated(&trial)?);
            }
        }
        points.push(point);
    }
    Ok(points)
}
