//! State of a structure in motion.

use nalgebra::DVector;

use crate::structure::Structure;

/// Displacement and velocity of all unknowns at a time.
#[derive(Clone, Debug)]
pub struct State {
    /// Number of steps made.
    pub step: usize,
    /// Time, s.
    pub t: f64,
    /// Load factor of statics, at which loads and heat are taken; in motion the time.
    pub load: f64,
    /// Displacement from the initial configuration.
    pub u: DVector<f64>,
    /// Velocity, the rate of `u`.
    pub v: DVector<f64>,
}

impl State {
    /// State of a structure at t = 0.
    pub fn at_start(structure: &Structure) -> State {
        State { step: 0, t: 0.0, load: 0.0, u: structure.start().clone(), v: structure.start_velocity().clone() }
    }

    /// Counts one more step, which ends at time `t`.
    pub fn advance(&mut self, t: f64) {
        (self.step, self.t, self.load) = (self.step + 1, t, t);
    }

    /// Copies another state of the same structure.
    pub fn copy_from(&mut self, other: &State) {
        (self.step, self.t, self.load) = (other.step, other.t, other.load);
        self.u.copy_from(&other.u);
        self.v.copy_from(&other.v);
    }
}
