//! Supports: points held in place, at least in part.

use serde::{Deserialize, Serialize};

use super::choice::Direction;
use super::json::shape;

/// A point held in place, at least in part: `fix`, or `slide`, and with either or without a `clamp`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of the point.
    pub point: String,
    /// The directions in which it cannot move.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fix: Vec<Direction>,
    /// The only direction in which it can move, of any length.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub slide: Option<[f64; 2]>,
    /// Name of a rod whose section keeps its direction there: r_y · t₀ = 0 with the rod's initial direction t₀, or r_x · n₀ = 0
    /// with the one across it where the element has no r_y.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub clamp: Option<String>,
}

impl Support {
    /// Holds a point in both directions; rods turn freely there.
    pub fn pinned(point: &str) -> Support {
        Support::fixed(point, &[Direction::X, Direction::Y])
    }

    /// Holds a point in these directions.
    pub fn fixed(point: &str, fix: &[Direction]) -> Support {
        Support { point: point.into(), fix: fix.into(), slide: None, clamp: None }
    }

    /// Lets a point move along a direction [x, y] only.
    pub fn sliding(point: &str, along: [f64; 2]) -> Support {
        Support { point: point.into(), fix: Vec::new(), slide: Some(along), clamp: None }
    }

    /// Keeps the direction of a rod's section at the point, too.
    #[must_use]
    pub fn clamping(mut self, rod: &str) -> Support {
        self.clamp = Some(rod.into());
        self
    }

    /// Unit vectors along which it holds its point.
    pub(crate) fn held(&self) -> Vec<[f64; 2]> {
        let axis = |direction: &Direction| match direction {
            Direction::X => [1.0, 0.0],
            Direction::Y => [0.0, 1.0],
        };
        self.fix.iter().map(axis).chain(self.across()).collect()
    }

    /// The unit vector across its slide, along which it holds the point. Scaled first, as squares under- and overflow.
    pub(crate) fn across(&self) -> Option<[f64; 2]> {
        let [x, y] = self.slide?;
        let size = x.abs().max(y.abs());
        let (x, y) = (x / size, y / size);
        let norm = x.hypot(y);
        Some([-y / norm, x / norm])
    }
}
