//! The grid: meshes and steps that are tried for a scene, an element and a method, and the timing of the useful ones.

use std::time::Instant;

use super::benchmark::{Benchmark, ContinuumSolution};
use super::pareto::DECADES;
use super::point::{Point, Status};
use super::reference::{Limit, Mesh, Reference};
use super::samples::{SUPPORT, Samples};
use super::setup::{Record, Resolution, Setup};
use super::technique::{TECHNIQUES, Technique};
use super::timing::{Timing, repeated, timed};
use super::trace::Trace;
use crate::error::{Error, Result};
use crate::paper::continuum::Continuum;
use crate::paper::tip::Tip;
use crate::path::{column, columns, distance};
use ancf::model::{Element, Method};
use ancf::run::{Run, run};

/// Ratio of the errors in time and space below which a shorter step is useless.
const FINE: f64 = 0.3;

/// Ratio of the errors in time and space above which the step is too long for any finer mesh.
const COARSE: f64 = 10.0;

/// Consecutive failures after which a mesh is abandoned.
const FAILURES: usize = 6;

/// A point is outclassed by a run of its method that is at least as accurate in less than this part of the time; single runs differ by less.
const OUTCLASSED: f64 = 0.8;

/// A mesh is skipped if its error in space is this many times the largest of [`DECADES`].
const HOPELESS: f64 = 10.0;

/// Bisections between a step that is just too long for a decade of error and one that is short enough.
const BISECTIONS: usize = 2;

/// An explicit run that would take this many times the longest one is skipped.
const MOST_RUNS_OVER: f64 = 2.0;

/// Limits of the grid.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Longest run time, s: finer steps on a mesh end before it.
    pub longest_run: f64,
    /// Most elements of a rod.
    pub finest_mesh: usize,
    /// Most elements of a rod in statics, which is fast.
    pub finest_static: usize,
}

impl Limits {
    /// Of the full study.
    pub const FULL: Limits = Limits { longest_run: 0.5, finest_mesh: 32, finest_static: usize::MAX };
    /// Of a scene of the user's own.
    pub const OWN: Limits = Limits { longest_run: 0.3, finest_mesh: usize::MAX, finest_static: usize::MAX };
    /// Of the quick study.
    pub const QUICK: Limits = Limits { longest_run: 0.06, finest_mesh: 16, finest_static: 16 };
}

/// A benchmark with one element, and their reference.
#[derive(Debug)]
pub struct Subject {
    /// The scene.
    pub benchmark: &'static Benchmark,
    /// The element.
    pub element: Element,
    /// Its converged solutions.
    pub reference: Reference,
    /// The plane solid's tip and the reference's distance from it, m, if it is known.
    pub solid: Option<(Tip, f64)>,
}

impl Subject {
    /// A benchmark with an element and their reference; the plane solid is looked up.
    ///
    /// # Errors
    /// [`Error::Fixture`] if that cannot be read.
    pub fn new(benchmark: &'static Benchmark, element: Element, reference: Reference) -> Result<Subject> {
        let solid = match benchmark.continuum {
            Some(ContinuumSolution::Solid(id)) => {
                let tip = Continuum::load()?.solid(id)?.tip;
                let limit = distance_from(&tip, benchmark, reference.solution());
                Some((tip, limit))
            }
            _ => None,
        };
        Ok(Subject { benchmark, element, reference, solid })
    }

    /// Meshes to run: from the first whose error in space is acceptable to the first at the reference's limit.
    pub fn meshes(&self, limits: &Limits) -> Vec<&Mesh> {
        let uncertainty = self.reference.converged.uncertainty;
        let at_limit = |mesh: &&Mesh| Status::of(self.reference.space_error(mesh), uncertainty) == Status::AtLimit;
        let meshes = &self.reference.meshes;
        let useful = meshes.iter().position(|mesh| at_limit(&mesh)).map_or(meshes.len(), |first| first + 1);
        let hopeless = HOPELESS * DECADES[0] * self.benchmark.unit;
        let most = if self.benchmark.is_static() { limits.finest_static } else { limits.finest_mesh };
        let of_use = |mesh: &&Mesh| mesh.elements <= most && self.reference.space_error(mesh) <= hopeless;
        meshes[..useful].iter().filter(of_use).collect()
    }

    /// The methods for the scene: dynamic or static.
    pub fn techniques(&self) -> impl Iterator<Item = &'static Technique> {
        TECHNIQUES.iter().filter(|technique| technique.is_static() == self.benchmark.is_static())
    }

    /// All points of all methods with their setups; calls `on_mesh` after each method for each of its meshes.
    ///
    /// # Errors
    /// [`Error::Fixture`](crate::error::Error::Fixture) for an unsuitable scene. A run that fails is a point.
    pub fn points(&self, limits: &Limits, on_mesh: impl Fn()) -> Result<Vec<(Setup, Point)>> {
        let mut tried = Vec::new();
        for technique in self.techniques() {
            self.refine(technique, limits, &mut tried)?;
            self.meshes(limits).iter().for_each(|_| on_mesh());
        }
        for _ in 0..BISECTIONS {
            for (setup, mesh) in self.between(&tried) {
                tried.push((setup, self.screen(&setup, mesh)?.0));
            }
        }
        time_useful(tried, &self.reference)
    }

    /// Steps between one that is too long for a decade of error and the next shorter one, if the middle may be the fastest of all methods.
    fn between(&self, tried: &[(Setup, Point)]) -> Vec<(Setup, &Mesh)> {
        let enough = |point: &Point, decade| point.bound().is_some_and(|bound| bound <= decade);
        let mut between = Vec::new();
        for decade in DECADES.map(|decade| decade * self.benchmark.unit) {
            let able = tried.iter().filter(|(_, point)| enough(point, decade));
            let best = able.filter_map(|(_, point)| point.seconds()).fold(f64::INFINITY, f64::min);
            for (setup, point) in tried.iter().filter(|(_, point)| enough(point, decade)) {
                let Resolution::Steps(parts) = setup.resolution else { continue };
                // The next longer step, if it is too long.
                let same = |other: &&(Setup, Point)| {
                    (other.0.technique, other.0.elements) == (setup.technique, setup.elements)
                };
                let longer = tried.iter().filter(same).filter_map(|(other, point)| match other.resolution {
                    Resolution::Steps(fewer) if fewer < parts => Some((fewer, enough(point, decade))),
                    _ => None,
                });
                let Some((fewer, false)) = longer.max() else { continue };
                let middle = (fewer + parts) / 2;
                let fast = point.seconds().is_some_and(|time| time * middle as f64 <= best * parts as f64);
                let new = Setup { resolution: Resolution::Steps(middle), ..*setup };
                let known = |other: &Setup| same(&&(*other, point.clone())) && other.resolution == new.resolution;
                if let (true, true, Some(mesh)) = (fast, middle > fewer, self.reference.mesh(setup.elements))
                    && !tried.iter().any(|(other, _)| known(other))
                    && !between.iter().any(|(other, _)| known(other))
                {
                    between.push((new, mesh));
                }
            }
        }
        between
    }

    /// Tries the meshes of one method, each with finer and finer steps.
    fn refine(&self, technique: &'static Technique, limits: &Limits, tried: &mut Vec<(Setup, Point)>) -> Result<()> {
        let &Subject { benchmark, element, .. } = self;
        let mut start = None;
        for mesh in self.meshes(limits) {
            let elements = mesh.elements;
            let mut setup = Setup { benchmark, element, elements, technique, resolution: Resolution::Steps(1) };
            setup.resolution = match start {
                // A step that is too long for a coarser mesh is too long here. Each mesh has its own explicit limit, and its own number of
                // load steps for finding the equilibrium.
                Some(resolution) if !technique.explicit && !technique.is_static() => resolution,
                _ => setup.first_resolution()?,
            };
            if setup.explicit_seconds()? > MOST_RUNS_OVER * limits.longest_run {
                // Finer meshes take longer still.
                break;
            }
            start = None;
            let mut failures = 0;
            loop {
                let (point, seconds) = self.screen(&setup, mesh)?;
                let ratio = point.errors.as_ref().and_then(|errors| Some(errors.time? / errors.space?));
                let (status, useful) = (point.status, ratio.is_some_and(|ratio| ratio <= COARSE));
                tried.push((setup, point));
                failures = if status == Status::Failed { failures + 1 } else { 0 };
                if useful && start.is_none() {
                    start = Some(setup.resolution);
                }
                let fine = ratio.is_some_and(|ratio| ratio < FINE) || status == Status::AtLimit;
                if fine || failures == FAILURES || 2.0 * seconds > limits.longest_run {
                    break;
                }
                setup.resolution = setup.resolution.finer();
            }
            // No step was short enough in the available time: a finer mesh starts where this one ended.
            start = start.or(Some(setup.resolution));
        }
        Ok(())
    }

    /// A run for its error and one for its time, which shows whether it is worth repeating.
    fn screen(&self, setup: &Setup, mesh: &Mesh) -> Result<(Point, f64)> {
        let reference = &self.reference;
        let mut point = Point::new(setup, reference);
        let begun = Instant::now();
        let found = if setup.is_static() {
            run(&setup.scene(Record::Position)?)
                .map_err(Error::from)
                .map(|run| (Samples::of(setup.benchmark, &run), 0.0, run))
        } else {
            Trace::of(setup).map(|(trace, run)| (trace.at(&setup.benchmark.times()), trace.interpolation_error(), run))
        };
        let mut seconds = begun.elapsed().as_secs_f64();
        match found {
            Err(error) => {
                (point.reason, point.failed_after) = (error.to_string(), Some(seconds));
            }
            Ok((samples, interpolation, run)) => {
                (point.counts, point.rejected) = (run.counts, Some(run.counts.rejected));
                point.compare(&samples, interpolation, &Limit { mesh: Some(mesh), ..reference.limit() });
                if let (Some(errors), Some((solid, limit))) = (&mut point.errors, &self.solid) {
                    // A run that is nearer to the solid than its theory's own solution is so by chance.
                    errors.solid = Some(distance_from(solid, setup.benchmark, &samples).max(*limit));
                }
                seconds = timed(setup).1.computed;
                point.time = Timing::of(&[seconds]);
            }
        }
        Ok((point, seconds))
    }
}

/// Largest distance from the plane solid at its instants, m.
fn distance_from(solid: &Tip, benchmark: &Benchmark, samples: &Samples) -> f64 {
    let own = Tip { t: benchmark.times(), r: samples.position.clone() };
    own.largest_distance(solid, |t| t > 0.0)
}

/// Adds errors of energies and reactions from a run that is not timed.
fn complete(setup: &Setup, point: &mut Point, reference: &Reference) -> Result<()> {
    let (Some(errors), Some(recorded)) = (&mut point.errors, record(setup)?) else { return Ok(()) };
    errors.energy = energy_balance(&recorded);
    errors.reaction = if setup.is_static() {
        let force = columns(&recorded, SUPPORT, ["rx", "ry"]).last().copied();
        force.map(|force| setup.exact_reaction().map(|exact| distance(force, exact))).transpose()?
    } else {
        // The ends of the steps that are instants: a force is not smooth enough to be interpolated.
        let times = column(&recorded, "t");
        let forces = columns(&recorded, SUPPORT, ["rx", "ry"]);
        let known = setup.benchmark.times().into_iter().zip(&reference.solution().reaction);
        let apart = known.filter_map(|(t, known)| {
            let row = times.partition_point(|row| *row < t - 1e-9);
            let is_instant = times.get(row).is_some_and(|row| (row - t).abs() < 1e-9);
            forces.get(row).filter(|_| is_instant).map(|force| distance(*force, *known))
        });
        apart.max_by(f64::total_cmp)
    };
    Ok(())
}

/// The run that records everything; `None` if it fails.
fn record(setup: &Setup) -> Result<Option<Run>> {
    match run(&setup.scene(Record::Steps)?) {
        // Without the energies there is no error but a large one of the position.
        Err(ancf::error::Error::EnergyAppeared { .. }) => Ok(run(&setup.scene(Record::Instants)?).ok()),
        run => Ok(run.ok()),
    }
}

fn energy_balance(run: &Run) -> Option<f64> {
    run.trajectory.column("energy.balance")?.into_iter().map(f64::abs).max_by(f64::total_cmp)
}

/// Times the points that are not outclassed.
fn time_useful(tried: Vec<(Setup, Point)>, reference: &Reference) -> Result<Vec<(Setup, Point)>> {
    let numbers = |(setup, point): &(Setup, Point)| Some((setup.technique.method, point.bound()?, point.seconds()?));
    let known: Vec<(Method, f64, f64)> = tried.iter().filter_map(numbers).collect();
    let mut points = Vec::new();
    for (setup, mut point) in tried {
        if let Some((bound, seconds)) = point.bound().zip(point.seconds()) {
            let betters = |&(method, error, time): &(Method, f64, f64)| {
                method == setup.technique.method && error <= bound && time < OUTCLASSED * seconds
            };
            if known.iter().any(betters) {
                if point.status == Status::Ok {
                    point.status = Status::Outclassed;
                }
            } else {
                complete(&setup, &mut point, reference)?;
                point.time = Timing::of(&repeated(&setup)?);
            }
        }
        points.push((setup, point));
    }
    Ok(points)
}
