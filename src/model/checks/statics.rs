//! Checks of statics: no keys that need time, since a load factor from 0 to 1 takes its place.

use std::fmt::Display;

use crate::model::check::{Check, require};
use crate::model::choice::{Method, Quantity, Start};
use crate::model::heat::Temperature;
use crate::model::scene::Scene;

/// Refuses time-dependent keys in statics.
pub(in crate::model) fn check_statics(scene: &Scene) -> Check {
    if scene.time.method != Method::Static {
        return Ok(());
    }
    for (i, force) in scene.forces.iter().enumerate() {
        let allowed = "no history with the method \"static\": forces grow from nothing to their full size";
        require(force.history.is_none(), format_args!("forces[{i}].history"), "given", allowed)?;
    }
    if let Some(temperature) = &scene.temperature {
        check_temperature("temperature", temperature)?;
    }
    for (i, rod) in scene.rods.iter().enumerate() {
        if let Some(temperature) = &rod.temperature {
            check_temperature(format_args!("rods[{i}].temperature"), temperature)?;
        }
    }
    if let Some(interval) = scene.output.interval {
        let allowed = "no interval with the method \"static\": every load step is a row";
        require(false, "output.interval", format_args!("{interval:?}"), allowed)?;
    }
    for (i, probe) in scene.probes.iter().enumerate() {
        for (k, quantity) in probe.of.iter().enumerate() {
            let moves = matches!(quantity, Quantity::Velocity | Quantity::Acceleration);
            let allowed = "\"position\", \"reaction\" or \"deflection\": with the method \"static\" nothing moves";
            require(!moves, format_args!("probes[{i}].of[{k}]"), format_args!("\"{quantity}\""), allowed)?;
        }
    }
    Ok(())
}

fn check_temperature(key: impl Display, temperature: &Temperature) -> Check {
    let pairs = temperature.history.len();
    let allowed = "a single pair [t, dT] with the method \"static\": heat grows from nothing to this dT";
    require(pairs <= 1, format_args!("{key}.history"), format_args!("{pairs} pairs"), allowed)?;
    let allowed = "\"sudden\": with the method \"static\" heat grows from nothing, and has no start";
    require(temperature.start == Start::Sudden, format_args!("{key}.start"), "\"relaxed\"", allowed)
}
