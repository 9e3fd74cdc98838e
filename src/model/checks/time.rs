//! Checks of time and output: whole numbers of steps, and no more than a computer can handle.

use crate::model::check::{Check, positive, require};
use crate::model::choice::Method;
use crate::model::scene::Scene;
use crate::model::time::{MOST_STEPS, Time};

/// Most load steps: each is a row of the trajectory.
const MOST_LOAD_STEPS: usize = 1_000_000;

/// Most numbers in a trajectory, which is kept in memory: 0.8 GB.
const MOST_NUMBERS: f64 = 1e8;

/// Most numbers in `shapes.json`: some 200 MB of text.
const MOST_SHAPE_NUMBERS: f64 = 1e7;

/// Most points of a rod's shape: more than any screen shows.
const MOST_SHAPE_POINTS: usize = 10_001;

/// Numbers of a point of a shape: position, director, strain, curvature.
const NUMBERS_OF_A_POINT: f64 = 6.0;

/// Tolerance of a whole ratio: relative, and absolute in the unit of the ratio. The first accepts steps written with
/// ten digits; the second keeps the end of a long run within a thousandth of a step.
const WHOLE_TOLERANCE: (f64, f64) = (1e-9, 1e-3);

/// Checks the steps and the methods' parameters.
pub(in crate::model) fn check_time(scene: &Scene) -> Check {
    let &Time { end, step, method, rho_inf, newton_tolerance, tolerance, load_steps, .. } = &scene.time;
    positive("time.end", end)?;
    positive("time.step", step)?;
    if method == Method::Static {
        let allowed = "1, or nothing: with the method \"static\" the load factor grows from 0 to 1 in place of time";
        require(end == 1.0, "time.end", format_args!("{end:?}"), allowed)?;
    } else {
        let steps = end / step;
        let allowed = format_args!("at least {:.9e} s, for {MOST_STEPS:e} steps at most", end / MOST_STEPS);
        require(steps <= MOST_STEPS, "time.step", format_args!("{step:?}"), allowed)?;
        if !method.is_adaptive() {
            // The proposed step must fit the rows as well.
            let rows = scene.output.interval.filter(|interval| *interval > 0.0 && is_whole(end / interval));
            whole("time.end", end, ("time.step", step), rows.unwrap_or(end))?;
        }
        positive("time.tolerance", tolerance)?;
    }
    let rho_holds = (0.0..=1.0).contains(&rho_inf);
    require(rho_holds, "time.rho_inf", format_args!("{rho_inf:?}"), "a number from 0 to 1, both included")?;
    let tolerance_holds = newton_tolerance > 0.0 && newton_tolerance <= 1e-2;
    let allowed = "a number over 0, and not over 1e-2";
    require(tolerance_holds, "time.newton_tolerance", format_args!("{newton_tolerance:?}"), allowed)?;
    let allowed = format_args!("a whole number from 1 to {MOST_LOAD_STEPS}");
    require((1..=MOST_LOAD_STEPS).contains(&load_steps), "time.load_steps", load_steps, allowed)
}

/// Checks the rows and their memory.
pub(in crate::model) fn check_output(scene: &Scene) -> Check {
    let columns = scene.columns().len() as f64;
    if scene.time.method == Method::Static {
        let Time { load_steps, .. } = scene.time;
        let rows = scene.steps() as f64;
        let most = (MOST_NUMBERS / columns * load_steps as f64 / rows).floor();
        let allowed = format_args!("at most {most}: {columns} columns, and {MOST_NUMBERS:e} numbers at most");
        return require(load_steps as f64 <= most, "time.load_steps", load_steps, allowed);
    }
    let key = "output.interval";
    let Time { end, step, .. } = scene.time;
    if let Some(interval) = scene.output.interval {
        positive(key, interval)?;
        if scene.time.method.is_adaptive() {
            whole("time.end", end, (key, interval), end)?;
        } else {
            whole(key, interval, ("time.step", step), interval)?;
        }
    } else if scene.time.method.is_adaptive() {
        whole("time.end", end, ("time.step", step), end)?;
    }
    let interval = scene.output.interval.unwrap_or(step);
    let rows = end / interval;
    let smallest = end * columns / MOST_NUMBERS;
    let allowed = format_args!("at least {smallest:.3e} s: {columns} columns, and {MOST_NUMBERS:e} numbers at most");
    require(rows * columns <= MOST_NUMBERS, key, format_args!("{interval:?}"), allowed)
}

/// Checks the shapes and their size.
pub(in crate::model) fn check_shapes(scene: &Scene) -> Check {
    let (Some(shapes), Some(every)) = (&scene.output.shapes, scene.shapes_every()) else { return Ok(()) };
    let allowed =
        format_args!("a whole number from 2 to {MOST_SHAPE_POINTS}: the ends of a rod are points of its shape");
    require((2..=MOST_SHAPE_POINTS).contains(&shapes.points), "output.shapes.points", shapes.points, allowed)?;
    if let Some(interval) = shapes.interval {
        let key = "output.shapes.interval";
        positive(key, interval)?;
        let adaptive = scene.time.method.is_adaptive();
        let rows = scene.output.interval.filter(|_| adaptive).map(|interval| ("output.interval", interval));
        whole(key, interval, rows.unwrap_or(("time.step", scene.time.step)), interval)?;
    }
    let instants = scene.steps() as f64 / every as f64;
    let numbers = instants * scene.rods.len() as f64 * shapes.points as f64 * NUMBERS_OF_A_POINT;
    let allowed = format_args!(
        "fewer instants or points: {numbers:.1e} numbers in `shapes.json` here, {MOST_SHAPE_NUMBERS:e} at most; a longer `interval` helps"
    );
    require(numbers <= MOST_SHAPE_NUMBERS, "output.shapes", "too much for a file", allowed)
}

/// Refuses a duration that is not a whole number of steps, and proposes a step that divides `part` of it.
fn whole(key: &str, duration: f64, (unit, step): (&str, f64), part: f64) -> Check {
    let count = duration / step;
    let fitting = part / (part / step).ceil().max(1.0);
    let allowed = format_args!(
        "a whole number of steps of `{unit}` = {step:?} s, not {count:.6}; a step of {fitting:?} s divides it"
    );
    require(is_whole(count), key, format_args!("{duration:?}"), allowed)
}

/// Whether a ratio is a whole number, over 0, but for rounding.
pub(super) fn is_whole(count: f64) -> bool {
    count > 0.5 && (count - count.round()).abs() <= (WHOLE_TOLERANCE.0 * count).min(WHOLE_TOLERANCE.1)
}
