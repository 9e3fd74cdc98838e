//! Forces, and what they and gravity have to fulfil.

use serde::{Deserialize, Serialize};

use super::Scene;
use super::history::{check_history, interpolate};
use super::json::shape;
use super::topology::check_node;
use super::validate::{Check, finite, require};

/// A force at a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Force {
    /// Name of the point.
    pub point: String,
    /// The force [F_x, F_y], N; it keeps its direction.
    pub force: [f64; 2],
    /// Pairs [t, factor], in the order of time: the factor is linear between them, constant before the first and after
    /// the last. `None`: always 1.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub history: Option<Vec<[f64; 2]>>,
}

impl Force {
    /// The force [F_x, F_y] at time `t` in s, N.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let factor = self.history.as_ref().and_then(|history| interpolate(history, t)).unwrap_or(1.0);
        self.force.map(|component| factor * component)
    }
}

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
