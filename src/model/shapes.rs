//! Shapes of rods for pictures and other programs.

use serde::{Deserialize, Serialize};

use super::json::shape;

/// What `shapes.json` has of the axis of every rod.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Shapes {
    /// Interval between shapes, s, a whole number of steps; `None`: that of the rows. Refused in statics, which has a shape
    /// at each load step.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub interval: Option<f64>,
    /// Number of points of a rod, its ends included, at equal distances along the unstrained rod.
    #[serde(default = "default_points")]
    pub points: usize,
}

fn default_points() -> usize {
    17
}

impl Default for Shapes {
    fn default() -> Self {
        Shapes { interval: None, points: default_points() }
    }
}
