//! How far a run may be from the solution of its equations: in time and in space.
//!
//! The run is made again with half the step (adaptive: of the longest, and a tenth of the tolerance; in statics twice the load steps)
//! and a tenth of Newton's tolerance, and with twice the elements. What that changes of the positions is most of the error where it
//! falls fast, and half of it where it only halves: an estimate is twice the change. Positions are those of all points, and
//! deflections those of the probes and of rods between held points, whether a probe asks for them or not. Velocities, accelerations,
//! reactions and energies are not estimated: after a shock they may not converge at all. Neither a kept energy nor the sum of an
//! adaptive method's local errors says as much: the first knows nothing of places, and the second nothing of how errors grow or
//! cancel on their way.
//!
//! What both runs miss changes nothing. Where a history comes and goes within a step (`run::short`) the finer steps are as many in one
//! as it takes to see it, sixteen at most, and without them there is no estimate.
//!
//! **No digit.** Each place is judged beside its own motion: the way from its start, or from where it would have gone straight on with the
//! centre of what it hangs together with, whichever is shorter, so that neither a far journey nor another part's swing hides it. A place that moves by
//! less than a millionth of the structure's size is judged beside the one that moves farthest.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::error::{Error, Result};
use crate::integrators::{State, integrator};
use crate::plan::Plan;
use crate::run::{Run, mass, missed, moves, run, run_with_progress};
use crate::scene::{Method, Probe, Quantity, Rod, Scene};
use crate::structure::Structure;

/// A halved step, or element, at least halves the error: what is left is as much as what has changed.
const SAFETY: f64 = 2.0;

/// A result whose estimated error is more than this part of its motion has no digit to rely on.
const NO_DIGIT: f64 = 0.1;

/// Motion of a place, of the structure's size, that is too small to judge it by.
const HARDLY: f64 = 1e-6;

/// Newton's tolerance below which rounding ends the iteration.
const LEAST_TOLERANCE: f64 = 1e-12;

/// How often the longest step of an adaptive method may be halved until it makes more steps.
const HALVINGS: usize = 6;

/// Steps of a finer run over those of the run: a tenth of the tolerance makes 1.8 times as many.
const MORE: f64 = 1.5;

/// Most steps in one of the run's for what comes and goes within it.
const MOST_PARTS: usize = 16;

/// An estimated error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Largest over the rows, m.
    pub value: f64,
    /// "m".
    pub unit: &'static str,
    /// How it was found.
    pub method: String,
}

/// What is known of a run's errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// The step's part; `None` where nobody asked.
    pub time: Option<Estimate>,
    /// The mesh's part.
    pub space: Option<Estimate>,
}

impl Accuracy {
    /// Both parts together, m; `None` where one is not known.
    pub fn total(&self) -> Option<f64> {
        Some(self.time.as_ref()?.value + self.space.as_ref()?.value)
    }
}

/// Runs a scene and estimates its errors; `on_step` hears of the steps of the run itself.
///
/// # Errors
/// Those of [`run`]; [`Error::NoEstimate`] where a finer run fails, and [`Error::Inaccurate`] where an estimate is more than a tenth of
/// the motion of its place, and [`Error::Unstable`] for an equilibrium that is.
pub fn run_estimated(scene: &Scene, on_step: impl FnMut(usize)) -> Result<Run> {
    scene.validate("scene")?;
    let watched = watched(scene);
    watched.validate("scene").map_err(|error| no_estimate("a probe of each point", error))?;
    let mut own = run_with_progress(&watched, on_step)?;
    let (finer, in_time, how) = finer_in_time(&watched, &own)?;
    let places = places(&watched);
    let time = changes(&places, &watched, &own, &finer, &in_time);

    // Explicit steps have to be shorter on a finer mesh, and are compared with as short ones.
    let explicit = watched.time.method.is_explicit();
    let (base, base_run) = if explicit { (&finer, &in_time) } else { (&watched, &own) };
    let mut mesh = base.clone();
    mesh.rods.iter_mut().for_each(|rod| rod.elements *= 2);
    let on_mesh = if explicit { format!("twice the elements at {how}") } else { "twice the elements".into() };
    let mesh = stable(mesh).map_err(|error| no_estimate(&on_mesh, error))?;
    let on_finer = run(&mesh).map_err(|error| no_estimate(&on_mesh, error))?;
    let space = changes(&places, base, base_run, &mesh, &on_finer);

    let directions = [&own, &in_time, &on_finer].map(|run| run.unstable_directions).into_iter().max().unwrap_or(0);
    if directions > 0 {
        return Err(Error::Unstable { directions });
    }
    judge(&watched, &places, &own, &time, &space)?;
    let [time, space] = [time, space].map(|errors| errors.into_iter().fold(0.0, f64::max));
    let estimate = |value, method: &str| {
        let method = format!(
            "{SAFETY} × the largest change of a position by {method}; velocities, reactions and energies are not estimated"
        );
        Some(Estimate { value, unit: "m", method })
    };
    own.accuracy = Accuracy { time: estimate(time, &how), space: estimate(space, &on_mesh) };
    let columns = scene.columns();
    let kept: Vec<usize> =
        columns.iter().filter_map(|name| own.trajectory.columns.iter().position(|c| c == name)).collect();
    own.trajectory.rows.iter_mut().for_each(|row| *row = kept.iter().map(|column| row[*column]).collect());
    own.trajectory.columns = columns;
    Ok(own)
}

/// The scene with a probe of each of its points, and of the middles of rods that are held at both ends, of which points say nothing.
fn watched(scene: &Scene) -> Scene {
    let mut watched = scene.clone();
    let mut look = |place: String, probe: Probe| {
        let name = format!("estimate {} of {place}", watched.probes.len());
        watched.probes.push(Probe { name, ..probe });
    };
    let nowhere = Probe { name: String::new(), point: None, rod: None, at: None, of: vec![Quantity::Position] };
    let pivots: BTreeSet<&String> = scene.rods.iter().filter_map(|rod| rod.pivot.as_ref()).collect();
    for point in scene.points.keys().chain(pivots) {
        look(point.clone(), Probe { point: Some(point.clone()), ..nowhere.clone() });
    }
    let is_held = |point: &String| {
        let supports = scene.supports.iter().filter(|support| support.point == *point);
        supports.map(|support| support.held().len()).sum::<usize>() > 1
    };
    for rod in scene.rods.iter().filter(|rod| is_held(&rod.from) && is_held(&rod.to)) {
        // A bow, and a wave with a node in the middle.
        for at in [0.5, 0.25] {
            let of = vec![Quantity::Deflection];
            look(rod.name.clone(), Probe { rod: Some(rod.name.clone()), at: Some(at), of, ..nowhere.clone() });
        }
    }
    watched
}

fn no_estimate(what: &str, error: Error) -> Error {
    Error::NoEstimate { what: what.into(), reason: error.to_string() }
}

/// The scene with its steps made finer, its run, and in words how.
fn finer_in_time(scene: &Scene, own: &Run) -> Result<(Scene, Run, String)> {
    let mut finer = scene.clone();
    let how = match scene.time.method {
        Method::Static => {
            finer.time.load_steps *= 2;
            "twice the load steps".into()
        }
        method if method.is_adaptive() => {
            divide(&mut finer, 2);
            finer.time.tolerance /= 10.0;
            // Where the tolerance asks for less than the longest step it is the step that decides.
            "a tenth of the tolerance and half the longest step".into()
        }
        _ => {
            let parts = parts(scene)?;
            divide(&mut finer, parts);
            if parts == 2 { "half the step".into() } else { format!("1/{parts} of the step") }
        }
    };
    let (mut run_of_it, how) = with_finer_newton(&mut finer, how)?;
    // Where rows and corners of histories are closer than half the longest step, all steps would be the same.
    for _ in 0..HALVINGS {
        if !scene.time.method.is_adaptive() || run_of_it.counts.steps as f64 >= MORE * own.counts.steps as f64 {
            break;
        }
        divide(&mut finer, 2);
        run_of_it = run(&finer).map_err(|error| no_estimate(&how, error))?;
    }
    Ok((finer, run_of_it, how))
}

/// Runs the scene with a tenth of Newton's tolerance; with its own where rounding leaves no less.
fn with_finer_newton(finer: &mut Scene, how: String) -> Result<(Run, String)> {
    let tolerance = finer.time.newton_tolerance;
    // Steps of any length end their iteration alike.
    if !finer.time.method.is_explicit() && tolerance > LEAST_TOLERANCE {
        finer.time.newton_tolerance = (tolerance / 10.0).max(LEAST_TOLERANCE);
        let how = format!("{how}, a tenth of Newton's tolerance");
        match run(finer) {
            Err(Error::NewtonFailed { at_rounding: true, .. }) => finer.time.newton_tolerance = tolerance,
            Err(error) => return Err(no_estimate(&how, error)),
            Ok(run) => return Ok((run, how)),
        }
    }
    let run = run(finer).map_err(|error| no_estimate(&how, error))?;
    Ok((run, how))
}

/// In how many parts a step has to be divided until no history comes and goes within one.
fn parts(scene: &Scene) -> Result<usize> {
    let step = scene.time.step;
    let sees_all = |parts: &usize| missed(scene, step / *parts as f64).is_none();
    (2..=MOST_PARTS).find(sees_all).ok_or_else(|| {
        let short = missed(scene, step / MOST_PARTS as f64).map_or(String::new(), |short| {
            format!(
                "{} rises and falls within less than that, in as little as {:.1e} s; a smaller `time.step` helps, or a method that \
                 chooses its steps",
                short.what, short.length
            )
        });
        Error::NoEstimate { what: format!("1/{MOST_PARTS} of the step"), reason: short }
    })
}

/// Divides the step and leaves the rows.
fn divide(scene: &mut Scene, parts: usize) {
    scene.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
    scene.time.step /= parts as f64;
}

/// The scene with a step that its explicit method takes.
fn stable(mut scene: Scene) -> Result<Scene> {
    let plan = Plan::of(&scene);
    scene.validate("the finer mesh")?;
    let structure = Structure::planned(&scene, &plan)?;
    let state = State::at_start(&structure);
    if let Err(Error::StepTooLarge { step, largest, .. }) =
        integrator(&scene, &plan, &structure, &state, &mut Default::default())
    {
        divide(&mut scene, (step / largest).ceil() as usize);
    }
    Ok(scene)
}

/// What is compared: a position, or a deflection.
struct Place {
    /// In words.
    name: String,
    columns: Vec<usize>,
    /// Velocity at the start of the centre of its part of the structure, m/s.
    velocity: [f64; 2],
}

fn places(scene: &Scene) -> Vec<Place> {
    let mut column = 1;
    let mut places = Vec::new();
    for probe in &scene.probes {
        for quantity in &probe.of {
            let columns: Vec<usize> = (column..column + quantity.suffixes().len()).collect();
            column += columns.len();
            let whose = match (&probe.point, &probe.rod) {
                (Some(point), _) => format!("`{point}`"),
                (None, rod) => format!("the rod `{}`", rod.as_deref().unwrap_or_default()),
            };
            let (what, velocity) = match quantity {
                Quantity::Position => ("position", drift(scene, probe).unwrap_or_default()),
                Quantity::Deflection => ("deflection", [0.0; 2]),
                _ => continue,
            };
            places.push(Place { name: format!("{what} of {whose}"), columns, velocity });
        }
    }
    places
}

/// Velocity at the start of the centre of the rods that hang together with a probe's; `None` where nothing moves.
fn drift(scene: &Scene, probe: &Probe) -> Option<[f64; 2]> {
    let motion = scene.motion.as_ref()?;
    let probed = |rod: &&Rod| {
        Some(&rod.name) == probe.rod.as_ref() || ends(rod).any(|point| Some(point) == probe.point.as_ref())
    };
    let mut points: BTreeSet<&String> = scene.rods.iter().filter(probed).flat_map(ends).collect();
    let hangs = |points: &BTreeSet<&String>, rod: &Rod| ends(rod).any(|point| points.contains(point));
    // As many rounds as the longest chain of rods has.
    for _ in &scene.rods {
        let more: Vec<&String> = scene.rods.iter().filter(|rod| hangs(&points, rod)).flat_map(ends).collect();
        points.extend(more);
    }
    let (mut momentum, mut whole) = ([0.0; 2], 0.0);
    for rod in scene.rods.iter().filter(|rod| hangs(&points, rod)) {
        let (mass, [x, y]) = (mass(scene, rod), motion.at(scene.middle(rod)?));
        momentum = [momentum[0] + mass * x, momentum[1] + mass * y];
        whole += mass;
    }
    Some(momentum.map(|component| component / whole))
}

/// Points of a rod.
fn ends(rod: &Rod) -> impl Iterator<Item = &String> {
    [&rod.from, &rod.to].into_iter().chain(&rod.pivot)
}

/// Estimated errors of the places: twice the largest distance of two runs at the rows of the first; not a number where one of them
/// is not.
fn changes(places: &[Place], scene: &Scene, own: &Run, other: &Scene, finer: &Run) -> Vec<f64> {
    let every = if scene.time.method == Method::Static { other.time.load_steps / scene.time.load_steps } else { 1 };
    let (rows, others) = (&own.trajectory.rows, finer.trajectory.rows.iter().step_by(every));
    if rows.len() != others.len() {
        return vec![f64::NAN; places.len()];
    }
    let change = |place: &Place| {
        let apart = |(a, b): (&Vec<f64>, &Vec<f64>)| norm(place.columns.iter().map(|column| a[*column] - b[*column]));
        SAFETY * largest(rows.iter().zip(others.clone()).map(apart))
    };
    places.iter().map(change).collect()
}

/// Refuses errors that leave no digit of a place's motion.
///
/// # Errors
/// [`Error::Inaccurate`] of the worst place.
fn judge(scene: &Scene, places: &[Place], own: &Run, time: &[f64], space: &[f64]) -> Result<()> {
    let Some(first) = own.trajectory.rows.first() else { return Ok(()) };
    // From the start, or from where it would be without loads.
    let way = |place: &Place, coasts: f64| {
        let gone = |row: &Vec<f64>| {
            let straight = place.velocity.map(|velocity| coasts * velocity * (row[0] - first[0]));
            norm(place.columns.iter().zip(straight).map(|(column, straight)| row[*column] - first[*column] - straight))
        };
        largest(own.trajectory.rows.iter().map(gone))
    };
    let farthest = largest(places.iter().map(|place| way(place, 0.0)));
    let (size, resting) = (scene.size(), !moves(scene));
    let judged = |((place, time), space): ((&Place, &f64), &f64)| {
        let own = way(place, 0.0).min(way(place, 1.0));
        // Where nothing moves the structure there is no motion to compare with.
        let moved = if resting {
            farthest.max(size)
        } else if own >= HARDLY * size {
            own
        } else {
            farthest
        };
        // A NaN is not small.
        let small = time + space <= NO_DIGIT * moved;
        (!small).then(|| Error::Inaccurate { place: place.name.clone(), time: *time, space: *space, moved })
    };
    let share = |error: &Error| match error {
        Error::Inaccurate { time, space, moved, .. } => (time + space) / moved,
        _ => 0.0,
    };
    let bad = places.iter().zip(time).zip(space).filter_map(judged);
    bad.max_by(|a, b| share(a).total_cmp(&share(b))).map_or(Ok(()), Err)
}

fn norm(components: impl Iterator<Item = f64>) -> f64 {
    components.map(|component| component * component).sum::<f64>().sqrt()
}

/// In the total order NaN is the largest, and is not lost.
fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
