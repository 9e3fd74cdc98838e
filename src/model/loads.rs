//! Forces at points.

use serde::{Deserialize, Serialize};

use super::history::interpolate;
use super::json::shape;

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
    /// A constant force [F_x, F_y] at a point, N.
    pub fn new(point: &str, force: [f64; 2]) -> Force {
        Force { point: point.into(), force, history: None }
    }

    /// Sets its factor over time, pairs [t, factor].
    #[must_use]
    pub fn history(mut self, history: Vec<[f64; 2]>) -> Force {
        self.history = Some(history);
        self
    }

    /// The force [F_x, F_y] at time `t` in s, N.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let factor = self.history.as_ref().and_then(|history| interpolate(history, t)).unwrap_or(1.0);
        self.force.map(|component| factor * component)
    }
}
