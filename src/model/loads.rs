//! Point forces.

use serde::{Deserialize, Serialize};

use super::history::interpolate;
use super::json::shape;

/// Force at a point, constant or with a history.
///
/// ```
/// use ancf::model::Force;
///
/// let ramp = Force::new("tip", [0.0, -50.0]).history(vec![[0.0, 0.0], [0.5, 1.0]]);
/// assert_eq!(ramp.at(0.25), [0.0, -25.0]);
/// assert_eq!(ramp.at(9.0), [0.0, -50.0]);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Force {
    /// Name of the loaded point.
    pub point: String,
    /// Force [F_x, F_y], N; its direction is fixed in space.
    pub force: [f64; 2],
    /// Factor over time: pairs [t, factor] in order of time, linear in between, constant before the first and after the
    /// last. `None`: always 1. In statics t is the load factor, where the history starts from 0; `None`: it grows with
    /// the load factor.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub history: Option<Vec<[f64; 2]>>,
}

impl Force {
    /// Constant force [F_x, F_y] at a point, N.
    pub fn new(point: &str, force: [f64; 2]) -> Force {
        Force { point: point.into(), force, history: None }
    }

    /// Sets the factor over time: pairs [t, factor].
    #[must_use]
    pub fn history(mut self, history: Vec<[f64; 2]>) -> Force {
        self.history = Some(history);
        self
    }

    /// Force [F_x, F_y] at time `t` (s), N.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let factor = self.history.as_ref().and_then(|history| interpolate(history, t)).unwrap_or(1.0);
        self.force.map(|component| factor * component)
    }
}
