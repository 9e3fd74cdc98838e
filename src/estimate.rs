//! How far a run may be from the solution of its equations: in time and in space.
//!
//! The run is made again with half the step (adaptive: of the longest, and a tenth of the tolerance; in statics twice the load steps) and of Newton's tolerance a tenth, and with twice the elements. What
//! that changes of the positions is most of the error where it falls fast, and half of it where it only halves: an estimate is twice
//! the change. Positions are those of all points, and deflections those of the probes and of rods between held points, whether a probe
//! asks for them or not. Velocities, accelerations, reactions and energies are not estimated: after a shock they may not converge at all.
//! Neither a kept energy nor the sum of an adaptive method's local errors says as much: the first knows nothing of
//! places, and the second nothing of how errors grow or cancel on their way.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::error::{Error, Result};
use crate::integrators::integrator;
use crate::plan::Plan;
use crate::run::{Run, moves, run, run_with_progress};
use crate::scene::{Method, Probe, Quantity, Scene};
use crate::structure::Structure;

/// A halved step, or element, at least halves the error: what is left is as much as what has changed.
const SAFETY: f64 = 2.0;

/// A result whose estimated error is more than this part of its motion has no digit to rely on.
const NO_DIGIT: f64 = 0.1;

/// Newton's tolerance below which rounding ends the iteration.
const LEAST_TOLERANCE: f64 = 1e-12;

/// How often a step may be halved until it is stable on the finer mesh (explicit methods), or makes more steps (adaptive ones).
const HALVINGS: usize = 6;

/// Steps of a finer run over those of the run: a tenth of the tolerance makes 1.8 times as many.
const MORE: f64 = 1.5;

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
/// Those of [`run`]; [`Error::NoEstimate`] where a finer run fails, and [`Error::Inaccurate`] where the estimate is more than a tenth of
/// the motion, and [`Error::Unstable`] for an equilibrium that is.
pub fn run_estimated(scene: &Scene, on_step: impl FnMut(usize)) -> Result<Run> {
    scene.validate("scene")?;
    let no_estimate = |what: &str, error: Error| Error::NoEstimate { what: what.into(), reason: error.to_string() };
    let watched = watched(scene);
    watched.validate("scene").map_err(|error| no_estimate("a probe of each point", error))?;
    let mut own = run_with_progress(&watched, on_step)?;
    let (mut finer, how) = finer_in_time(&watched);
    let mut in_time = run(&finer).map_err(|error| no_estimate(&how, error))?;
    // Where rows and corners of histories are closer than half the longest step, all steps would be the same.
    for _ in 0..HALVINGS {
        if !watched.time.method.is_adaptive() || in_time.counts.steps as f64 >= MORE * own.counts.steps as f64 {
            break;
        }
        finer.time.step /= 2.0;
        in_time = run(&finer).map_err(|error| no_estimate(&how, error))?;
    }
    let time = SAFETY * change(&watched, &own, &finer, &in_time);

    // Explicit steps have to be shorter on a finer mesh, and are compared with as short ones.
    let explicit = watched.time.method.is_explicit();
    let (base, base_run) = if explicit { (&finer, &in_time) } else { (&watched, &own) };
    let mut mesh = base.clone();
    mesh.rods.iter_mut().for_each(|rod| rod.elements *= 2);
    let on_mesh = format!("twice the elements{}", if explicit { " at half the step" } else { "" });
    let fine = stable(mesh).and_then(|mesh| Ok((run(&mesh)?, mesh))).map_err(|error| no_estimate(&on_mesh, error))?;
    let space = SAFETY * change(base, base_run, &fine.1, &fine.0);

    let directions = [&own, &in_time, &fine.0].map(|run| run.unstable_directions).into_iter().max().unwrap_or(0);
    if directions > 0 {
        return Err(Error::Unstable { directions });
    }
    let moved = motion(&watched, &own);
    // Where nothing moves the structure there is no motion to compare with. A NaN is not small.
    let small = time + space <= NO_DIGIT * moved || (!moves(scene) && time + space <= NO_DIGIT * scene.size());
    if !small {
        return Err(Error::Inaccurate { time, space, moved });
    }
    let estimate = |value, method: &str| {
        let method = format!(
            "{SAFETY} × the largest change of a position by {method}; velocities, reactions and energies are not estimated"
        );
        Some(Estimate { value, unit: "m", method })
    };
    own.accuracy = Accuracy { time: estimate(time, &how), space: estimate(space, &on_mesh) };
    let columns = scene.columns();
    let places: Vec<usize> =
        columns.iter().filter_map(|name| own.trajectory.columns.iter().position(|c| c == name)).collect();
    own.trajectory.rows.iter_mut().for_each(|row| *row = places.iter().map(|place| row[*place]).collect());
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

/// The scene with its steps made finer, and in words how.
fn finer_in_time(scene: &Scene) -> (Scene, String) {
    let mut finer = scene.clone();
    let mut how = match scene.time.method {
        Method::Static => {
            finer.time.load_steps *= 2;
            "twice the load steps"
        }
        method => {
            finer.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
            finer.time.step /= 2.0;
            if method.is_adaptive() {
                finer.time.tolerance /= 10.0;
                // Where the tolerance asks for less than the longest step it is the step that decides.
                "a tenth of the tolerance and half the longest step"
            } else {
                "half the step"
            }
        }
    }
    .to_string();
    // Steps of any length end their iteration alike.
    let tolerance = scene.time.newton_tolerance;
    if !scene.time.method.is_explicit() && tolerance > LEAST_TOLERANCE {
        finer.time.newton_tolerance = (tolerance / 10.0).max(LEAST_TOLERANCE);
        how += ", a tenth of Newton's tolerance";
    }
    (finer, how)
}

/// The scene with a step that its explicit method takes.
fn stable(mut scene: Scene) -> Result<Scene> {
    let plan = Plan::of(&scene);
    scene.validate("the finer mesh")?;
    for _ in 0..HALVINGS {
        let structure = Structure::planned(&scene, &plan)?;
        let state = crate::integrators::State::at_start(&structure);
        match integrator(&scene, &plan, &structure, &state, &mut Default::default()) {
            Err(Error::StepTooLarge { .. }) => {
                scene.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
                scene.time.step /= 2.0;
            }
            _ => break,
        }
    }
    Ok(scene)
}

/// Columns of a position, in pairs, and of a deflection.
fn places(scene: &Scene) -> Vec<Vec<usize>> {
    let mut column = 1;
    let mut places = Vec::new();
    for quantity in scene.probes.iter().flat_map(|probe| &probe.of) {
        let count = quantity.suffixes().len();
        if matches!(quantity, Quantity::Position | Quantity::Deflection) {
            places.push((column..column + count).collect());
        }
        column += count;
    }
    places
}

/// The largest distance of two runs' positions at the rows of the first; not a number where one of them is not.
fn change(scene: &Scene, own: &Run, other: &Scene, finer: &Run) -> f64 {
    let every = if scene.time.method == Method::Static { other.time.load_steps / scene.time.load_steps } else { 1 };
    let rows = finer.trajectory.rows.iter().step_by(every);
    if own.trajectory.rows.len() != rows.len() {
        return f64::NAN;
    }
    largest(scene, own.trajectory.rows.iter().zip(rows))
}

/// How far positions get from where they start.
fn motion(scene: &Scene, own: &Run) -> f64 {
    let Some(first) = own.trajectory.rows.first() else { return f64::NAN };
    largest(scene, own.trajectory.rows.iter().map(|row| (row, first)))
}

fn largest<'a>(scene: &Scene, pairs: impl Iterator<Item = (&'a Vec<f64>, &'a Vec<f64>)>) -> f64 {
    let places = places(scene);
    let apart = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let distance = |columns: &Vec<usize>| columns.iter().map(|c| (a[*c] - b[*c]).powi(2)).sum::<f64>().sqrt();
        places.iter().map(distance).max_by(f64::total_cmp).unwrap_or(f64::NAN)
    };
    // In the total order NaN is the largest, and is not lost.
    pairs.map(apart).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
