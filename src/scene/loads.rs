//! What gravity and forces have to fulfil.

use std::fmt::Display;

use super::Scene;
use super::topology::check_node;
use super::validate::{Check, finite, require};

/// Gravity and the forces at points.
pub(super) fn check_loads(scene: &Scene) -> Check {
    for (axis, &g) in scene.gravity.iter().enumerate() {
        finite(format_args!("gravity[{axis}]"), g)?;
    }
    for (i, force) in scene.forces.iter().enumerate() {
        check_node(scene, format_args!("forces[{i}].point"), &force.point)?;
        for (axis, &component) in force.force.iter().enumerate() {
            finite(format_args!("forces[{i}].force[{axis}]"), component)?;
        }
        if let Some(history) = &force.history {
            let key = format_args!("forces[{i}].history");
            require(!history.is_empty(), key, "[]", "at least one pair [t, factor]; without the key it is always 1")?;
            check_history(key, history)?;
        }
    }
    Ok(())
}

/// Refuses a history of pairs [t, value] that is no function of time.
pub(super) fn check_history(key: impl Display, history: &[[f64; 2]]) -> Check {
    for (i, &[time, value]) in history.iter().enumerate() {
        finite(format_args!("{key}[{i}][0]"), time)?;
        finite(format_args!("{key}[{i}][1]"), value)?;
    }
    for (i, pair) in history.windows(2).enumerate() {
        if let [[before, _], [time, _]] = pair {
            let allowed = format_args!("a time after the {before:?} s before it");
            require(time > before, format_args!("{key}[{}][0]", i + 1), format_args!("{time:?}"), allowed)?;
        }
    }
    Ok(())
}
