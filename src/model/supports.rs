//! Supports: points held in place, fully or partly.

use serde::{Deserialize, Serialize};

use super::choice::Direction;
use super::json::shape;

/// Point held in place, fully or partly: by `fix` or `slide`, with or without a `clamp`.
///
/// ```
/// use ancf::model::{Direction, Support};
///
/// assert_eq!(Support::pinned("a").fix, [Direction::X, Direction::Y]);
/// assert_eq!(Support::sliding("b", [1.0, 0.0]).slide, Some([1.0, 0.0]));
/// assert_eq!(Support::pinned("a").clamping("rod").clamp.as_deref(), Some("rod"));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of the supported point.
    pub point: String,
    /// Held directions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fix: Vec<Direction>,
    /// Only free direction, as a vector of any length.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub slide: Option<[f64; 2]>,
    /// Name of a rod whose section keeps its direction at the point, which `fix` or `slide` holds: r_y · t₀ = 0 with the rod's initial direction t₀.
    /// For elements without r_y: r_x · n₀ = 0 with the initial normal n₀.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub clamp: Option<String>,
}

impl Support {
    /// Holds a point in both directions; rods turn freely there.
    pub fn pinned(point: &str) -> Support {
        Support::fixed(point, &[Direction::X, Direction::Y])
    }

    /// Holds a point in the given directions.
    pub fn fixed(point: &str, fix: &[Direction]) -> Support {
        Support { point: point.into(), fix: fix.into(), slide: None, clamp: None }
    }

    /// Lets a point move only along the direction [x, y].
    pub fn sliding(point: &str, along: [f64; 2]) -> Support {
        Support { point: point.into(), fix: Vec::new(), slide: Some(along), clamp: None }
    }

    /// Clamps a rod's section at the point as well: its direction is kept.
    #[must_use]
    pub fn clamping(mut self, rod: &str) -> Support {
        self.clamp = Some(rod.into());
        self
    }

    /// Unit vectors along which the support holds its point.
    pub(crate) fn held(&self) -> Vec<[f64; 2]> {
        self.fix.iter().map(|direction| direction.unit()).chain(self.across()).collect()
    }

    /// Unit normal of the slide, along which the point is held. Scaled first, since squares under- and overflow.
    pub(crate) fn across(&self) -> Option<[f64; 2]> {
        let [x, y] = self.slide?;
        let size = x.abs().max(y.abs());
        let (x, y) = (x / size, y / size);
        let norm = x.hypot(y);
        Some([-y / norm, x / norm])
    }
}
