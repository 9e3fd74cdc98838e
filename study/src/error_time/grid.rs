//! The grid: which meshes and steps are tried for a scene, an element and a method, and which of them are timed.

use super::case::Case;
use super::pareto::DECADES;
use super::point::{Point, Status};
use super::reference::{Mesh, Reference};
use super::samples::{Samples, largest};
use super::technique::{TECHNIQUES, Technique};
use super::timing::{Timing, repeated, timed};
use super::trial::{Record, Setting, Trial};
use crate::error::Result;
use ancf::model::{Element, Method};
use ancf::run::{Run, run};

/// Error in time over that in space below which a mesh has no use for a shorter step.
const FINE: f64 = 0.3;

/// The same ratio over which a step is too long for any finer mesh.
const COARSE: f64 = 10.0;

/// Failures in a row after which a mesh is given up.
const FAILURES: usize = 6;

/// A run of the same method that is at least as accurate in less than this part of the time makes a point useless: more than
/// single runs differ by.
const OUTCLASSED: f64 = 0.8;

/// A mesh whose error in space is this many times the largest error that anybody asks for is not tried.
const HOPELESS: f64 = 10.0;

/// How often the steps between one that is just too long for a decade of error and one that is short enough are halved.
const BISECTIONS: usize = 2;

/// An explicit run that would take this many times the longest one is not begun.
const MOST_RUNS_OVER: f64 = 2.0;

/// How far the grid reaches.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// A run whose finer one would take longer is the last of its mesh, s.
    pub longest_run: f64,
    /// Elements of each rod at most.
    pub finest_mesh: usize,
    /// The same in statics, which takes no time.
    pub finest_static: usize,
}

impl Reach {
    /// The whole study.
    pub const FULL: Reach = Reach { longest_run: 0.6, finest_mesh: 32, finest_static: usize::MAX };
    /// A first look.
    pub const QUICK: Reach = Reach { longest_run: 0.06, finest_mesh: 16, finest_static: 16 };
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
    /// Meshes that are worth a run: from the first that is of use up to the first that is as good as the reference.
    pub fn meshes(&self, reach: &Reach) -> Vec<&Mesh> {
        let uncertainty = self.reference.converged.uncertainty;
        let at_limit = |mesh: &&Mesh| Status::of(self.reference.space_error(mesh), uncertainty) == Status::AtLimit;
        let meshes = &self.reference.meshes;
        let useful = meshes.iter().position(|mesh| at_limit(&mesh)).map_or(meshes.len(), |first| first + 1);
        let hopeless = HOPELESS * DECADES[0];
        let most = if self.case.is_static() { reach.finest_static } else { reach.finest_mesh };
        let of_use = |mesh: &&Mesh| mesh.elements <= most && self.reference.space_error(mesh) <= hopeless;
        meshes[..useful].iter().filter(of_use).collect()
    }

    /// The methods that fit.
    pub fn techniques(&self) -> impl Iterator<Item = &'static Technique> {
        TECHNIQUES.iter().filter(|technique| technique.is_static() == self.case.is_static())
    }

    /// All points of all methods; `on_mesh` is told of each mesh with each of them.
    ///
    /// # Errors
    /// [`Error::Fixture`] for scenes that do not have what the study asks for. A run that fails is a point.
    pub fn points(&self, reach: &Reach, on_mesh: impl Fn()) -> Result<Vec<Point>> {
        let mut tried = Vec::new();
        for technique in self.techniques() {
            self.walk(technique, reach, &mut tried)?;
            self.meshes(reach).iter().for_each(|_| on_mesh());
        }
        for _ in 0..BISECTIONS {
            for (trial, mesh) in self.between(&tried) {
                tried.push((trial, screen(&trial, &self.reference, mesh)?.0));
            }
        }
        time_useful(tried, &self.reference)
    }

    /// Steps in the middle of one that is too long for a decade of error and the next shorter one that is not, where the middle may
    /// be the fastest of all methods.
    fn between(&self, tried: &[(Trial, Point)]) -> Vec<(Trial, &Mesh)> {
        let enough = |point: &Point, decade| point.bound().is_some_and(|bound| bound <= decade);
        let mut between = Vec::new();
        for decade in DECADES {
            let able = tried.iter().filter(|(_, point)| enough(point, decade));
            let best = able.filter_map(|(_, point)| point.seconds()).fold(f64::INFINITY, f64::min);
            for (trial, point) in tried.iter().filter(|(_, point)| enough(point, decade)) {
                let Setting::Steps(parts) = trial.setting else { continue };
                // The longest of the steps that are shorter than what is too long.
                let same = |other: &&(Trial, Point)| {
                    (other.0.technique, other.0.elements) == (trial.technique, trial.elements)
                };
                let longer = tried.iter().filter(same).filter_map(|(other, point)| match other.setting {
                    Setting::Steps(fewer) if fewer < parts => Some((fewer, enough(point, decade))),
                    _ => None,
                });
                let Some((fewer, false)) = longer.max() else { continue };
                let middle = (fewer + parts) / 2;
                let fast = point.seconds().is_some_and(|time| time * middle as f64 <= best * parts as f64);
                let new = Trial { setting: Setting::Steps(middle), ..*trial };
                let known = |other: &Trial| same(&&(*other, point.clone())) && other.setting == new.setting;
                if let (true, true, Some(mesh)) = (fast, middle > fewer, self.reference.mesh(trial.elements))
                    && !tried.iter().any(|(other, _)| known(other))
                    && !between.iter().any(|(other, _)| known(other))
                {
                    between.push((new, mesh));
                }
            }
        }
        between
    }

    /// Tries the meshes and steps of one method.
    fn walk(&self, technique: &'static Technique, reach: &Reach, tried: &mut Vec<(Trial, Point)>) -> Result<()> {
        let &Subject { case, element, ref reference } = self;
        let mut start = None;
        for mesh in self.meshes(reach) {
            let elements = mesh.elements;
            let mut trial = Trial { case, element, elements, technique, setting: Setting::Steps(1) };
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
        }
        Ok(())
    }
}

/// A first run, with the time that tells which points are worth more.
fn screen(trial: &Trial, reference: &Reference, mesh: &Mesh) -> Result<(Point, f64)> {
    let mut point = Point::new(trial, reference);
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
        }
    }
    Ok((point, seconds))
}

/// Velocities, energies and reactions from a run that is not timed.
fn complete(trial: &Trial, point: &mut Point, reference: &Reference) -> Result<()> {
    if let (Some(errors), Some(recorded)) = (&mut point.errors, record(trial)?) {
        let samples = Samples::of(trial.case, &recorded);
        errors.velocity = samples.velocity_difference(reference.solution());
        errors.energy = energy_balance(&recorded);
        errors.reaction = reaction_error(trial, &recorded)?;
    }
    Ok(())
}

/// The run with everything that is recorded; `None` if it fails.
fn record(trial: &Trial) -> Result<Option<Run>> {
    match run(&trial.scene(Record::Energies)?) {
        // Without the energies nobody notices: the point has an error in position, and a large one.
        Err(ancf::error::Error::EnergyAppeared { .. }) => Ok(run(&trial.scene(Record::All)?).ok()),
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
fn time_useful(tried: Vec<(Trial, Point)>, reference: &Reference) -> Result<Vec<Point>> {
    let numbers = |(trial, point): &(Trial, Point)| Some((trial.technique.method, point.bound()?, point.seconds()?));
    let known: Vec<(Method, f64, f64)> = tried.iter().filter_map(numbers).collect();
    let mut points = Vec::new();
    for (trial, mut point) in tried {
        if let Some((bound, seconds)) = point.bound().zip(point.seconds()) {
            let betters = |&(method, error, time): &(Method, f64, f64)| {
                method == trial.technique.method && error <= bound && time < OUTCLASSED * seconds
            };
            if known.iter().any(betters) {
                if point.status == Status::Ok {
                    point.status = Status::Outclassed;
                }
            } else {
                complete(&trial, &mut point, reference)?;
                point.time = Timing::of(&repeated(&trial)?);
            }
        }
        points.push(point);
    }
    Ok(points)
}
