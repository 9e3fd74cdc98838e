//! Checks of statics: no keys that need time, since a load factor from 0 to 1 takes its place.

use std::fmt::Display;

use crate::model::check::{Check, require};
use crate::model::choice::{LoadPath, Method, Quantity, Start};
use crate::model::heat::Temperature;
use crate::model::history::interpolate;
use crate::model::scene::Scene;

/// Refuses keys that need time, and histories that statics cannot follow.
pub(in crate::model) fn check_statics(scene: &Scene) -> Check {
    if scene.time.method != Method::Static {
        return Ok(());
    }
    let path = scene.time.path;
    for (i, force) in scene.forces.iter().enumerate() {
        if let Some(history) = &force.history {
            check_history(format_args!("forces[{i}].history"), history, path)?;
        }
    }
    if let Some(temperature) = &scene.temperature {
        check_temperature("temperature", temperature, path)?;
    }
    for (i, rod) in scene.rods.iter().enumerate() {
        if let Some(temperature) = &rod.temperature {
            check_temperature(format_args!("rods[{i}].temperature"), temperature, path)?;
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

/// Checks a history over the load factor: it starts from nothing, as the structure does.
fn check_history(key: impl Display, history: &[[f64; 2]], path: LoadPath) -> Check {
    let allowed = "no history with \"path\": \"arc-length\", along which all loads grow and fall together; \"path\": \"load\" \
                   follows histories";
    require(path != LoadPath::ArcLength, format_args!("{key}"), "given", allowed)?;
    let start = interpolate(history, 0.0).unwrap_or(0.0);
    let allowed = "0 at the load factor 0: with the method \"static\" a history is one of pairs [load factor, value], and the \
                   structure starts without load; without `history` a force grows to its full size";
    require(start == 0.0, format_args!("{key}"), format_args!("{start:?} at the load factor 0"), allowed)?;
    let last = history.last().map_or(0.0, |[factor, _]| *factor);
    let allowed =
        "pairs up to the load factor 1: with the method \"static\" a history is one of pairs [load factor, value]";
    require(last <= 1.0, format_args!("{key}[{}][0]", history.len() - 1), format_args!("{last:?}"), allowed)
}

fn check_temperature(key: impl Display, temperature: &Temperature, path: LoadPath) -> Check {
    // A single pair is the full heat.
    if temperature.history.len() > 1 {
        check_history(format_args!("{key}.history"), &temperature.history, path)?;
    }
    let allowed = "\"sudden\": with the method \"static\" heat grows from nothing, and has no start";
    require(temperature.start == Start::Sudden, format_args!("{key}.start"), "\"relaxed\"", allowed)
}
