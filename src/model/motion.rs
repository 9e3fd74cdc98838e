//! How a structure moves at t = 0: as if it were rigid.

use serde::{Deserialize, Serialize};

/// Initial velocities: those of a rigid motion of everything.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// Velocity of the point `about`, m/s.
    #[serde(default)]
    pub velocity: [f64; 2],
    /// Angular velocity, rad/s, counter-clockwise.
    #[serde(default)]
    pub omega: f64,
    /// The point that the rotation is about, m.
    #[serde(default)]
    pub about: [f64; 2],
}

impl Motion {
    /// Velocity of what is at a place.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Motion { velocity: [v_x, v_y], omega, about: [x_0, y_0] } = *self;
        [v_x - omega * (y - y_0), v_y + omega * (x - x_0)]
    }

    /// Rate of a vector that turns with the motion.
    pub fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [-self.omega * y, self.omega * x]
    }
}
