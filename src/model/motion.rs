//! Initial rigid motion of a structure.

use serde::{Deserialize, Serialize};

/// Initial velocities: a rigid motion of the whole structure.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// Velocity of the place `about`, m/s.
    #[serde(default)]
    pub velocity: [f64; 2],
    /// Angular velocity, rad/s, positive counter-clockwise.
    #[serde(default)]
    pub omega: f64,
    /// Centre of the rotation, m.
    #[serde(default)]
    pub about: [f64; 2],
}

impl Motion {
    /// Velocity at a place, m/s.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Motion { velocity: [v_x, v_y], omega, about: [x_0, y_0] } = *self;
        [v_x - omega * (y - y_0), v_y + omega * (x - x_0)]
    }

    /// Rate of a vector that turns with the motion, 1/s of its unit.
    pub fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [-self.omega * y, self.omega * x]
    }
}
