//! Checks of gravity and forces: finite values at existing points.

use super::history::check_history;
use super::topology::check_node;
use crate::model::check::{Check, finite, require};
use crate::model::scene::Scene;

/// Checks gravity and the point forces.
pub(in crate::model) fn check_loads(scene: &Scene) -> Check {
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
