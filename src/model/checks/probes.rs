//! Checks of probes: a point or a place on a rod, and quantities that exist there.

use std::fmt::Display;

use super::time::is_whole;
use super::topology::{check_list, check_name, check_node, check_rod, unique};
use crate::model::check::{Check, require};
use crate::model::choice::{Method, Quantity};
use crate::model::json::words::Words;
use crate::model::probes::Probe;
use crate::model::scene::Scene;
use crate::model::time::Time;

/// Checks names, places and quantities of the probes.
pub(in crate::model) fn check_probes(scene: &Scene) -> Check {
    for (i, probe) in scene.probes.iter().enumerate() {
        check_name(format_args!("probes[{i}].name"), &probe.name)?;
        let allowed = "another name, as the columns `energy.…` hold energies";
        require(probe.name != "energy", format_args!("probes[{i}].name"), "\"energy\"", allowed)?;
        check_list(format_args!("probes[{i}].of"), probe.of.iter().map(|quantity| quantity.word()))?;
        if let Some(window) = probe.mean {
            check_window(scene, format_args!("probes[{i}].mean"), window)?;
        }
        match (&probe.point, &probe.rod) {
            (Some(point), rod) => check_at_point(scene, i, probe, point, rod.as_deref())?,
            (None, Some(rod)) => check_on_rod(scene, i, probe, rod)?,
            (None, None) => {
                let allowed = "the name of a point, or `rod` and `at` for a place on a rod";
                require(false, format_args!("probes[{i}].point"), "missing", allowed)?;
            }
        }
    }
    unique("probes", "name", scene.probes.iter().map(|probe| probe.name.as_str()))
}

/// Most steps of a window of means: 24 MB for each quantity.
const MOST_STEPS_OF_A_WINDOW: usize = 1_000_000;

/// Checks the window of means: a time that the run has, and with fixed steps a whole number of them.
fn check_window(scene: &Scene, key: impl Display, window: f64) -> Check {
    let Time { end, step, method, .. } = scene.time;
    let allowed = "nothing with the method \"static\", which has no time";
    require(method != Method::Static, &key, format_args!("{window:?}"), allowed)?;
    let allowed = format_args!("a number over 0 and up to the end of {end:?} s");
    require(0.0 < window && window <= end, &key, format_args!("{window:?}"), allowed)?;
    let allowed = format_args!("at most {MOST_STEPS_OF_A_WINDOW} steps of {step:?} s: all of its values are kept");
    require(window <= step * MOST_STEPS_OF_A_WINDOW as f64, &key, format_args!("{window:?}"), allowed)?;
    let allowed = format_args!("a whole number of steps of {step:?} s");
    require(method.is_adaptive() || is_whole(window / step), &key, format_args!("{window:?}"), allowed)
}

/// Checks a probe of a point, or of the force on one rod there.
fn check_at_point(scene: &Scene, i: usize, probe: &Probe, point: &str, rod: Option<&str>) -> Check {
    check_node(scene, format_args!("probes[{i}].point"), point)?;
    if let Some(at) = probe.at {
        let allowed = "nothing beside `point`: `at` is a place on a rod, given by `rod` without `point`";
        require(false, format_args!("probes[{i}].at"), format_args!("{at:?}"), allowed)?;
    }
    if let Some(name) = rod {
        check_rod(scene, format_args!("probes[{i}].rod"), name, Some(point))?;
    }
    let supported = scene.supports.iter().any(|support| support.point == point);
    for (k, &quantity) in probe.of.iter().enumerate() {
        let (holds, allowed) = match (quantity, rod) {
            (Quantity::Deflection, _) => {
                (false, "quantities of a point; a deflection has `rod` and `at`, without `point`")
            }
            (Quantity::Reaction, Some(_)) => (true, ""),
            (Quantity::Reaction, None) => (
                supported,
                "a reaction at a point that a support holds, or with `rod` for the force of a pin on that rod",
            ),
            (_, Some(_)) => {
                (false, "\"reaction\" only beside `rod`: pinned rods share every other quantity of the point")
            }
            (_, None) => (true, ""),
        };
        require(holds, format_args!("probes[{i}].of[{k}]"), format_args!("\"{quantity}\""), allowed)?;
    }
    Ok(())
}

/// Checks a probe of a place along a rod.
fn check_on_rod(scene: &Scene, i: usize, probe: &Probe, rod: &str) -> Check {
    check_rod(scene, format_args!("probes[{i}].rod"), rod, None)?;
    let allowed = "a number from 0 to 1, both included: the place as a fraction of the rod's length";
    let key = format_args!("probes[{i}].at");
    match probe.at {
        Some(at) => require((0.0..=1.0).contains(&at), key, format_args!("{at:?}"), allowed)?,
        None => require(false, key, "missing", allowed)?,
    }
    for (k, &quantity) in probe.of.iter().enumerate() {
        let allowed = "\"deflection\" on a rod; the other quantities need a `point`";
        let key = format_args!("probes[{i}].of[{k}]");
        require(quantity == Quantity::Deflection, key, format_args!("\"{quantity}\""), allowed)?;
    }
    Ok(())
}
