//! What a time-stepping method has to do.

use nalgebra::DVector;

use super::counts::Counts;
use super::state::State;
use crate::error::{Error, Result, written};
use crate::structure::Structure;

/// A one-step method.
pub trait Integrator {
    /// Moves the state on by one step that ends at `t_1` (s; the load factor in statics). A method that chooses its steps may
    /// stop before.
    ///
    /// # Errors
    /// [`Error::NotATime`] where the method's step does not lead to `t_1`: the state is as it was. Others where the step cannot
    /// be made or trusted: the state is then meaningless.
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()>;

    /// The multipliers λ that belong to the state, in their places; `None` for methods without.
    fn multipliers(&self) -> Option<&DVector<f64>> {
        None
    }

    /// Work of forces and heat over the last step, J; `None` for methods of order two, for which the ends of the step say enough.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> Option<f64> {
        let _ = (structure, before, after);
        None
    }
}

/// Times that differ by no more are the same, up to a time `t`: a few times their rounding, of which a step cannot be made.
pub fn same_time(t: f64) -> f64 {
    4.0 * f64::EPSILON * t
}

/// Refuses a time other than the end of a step of length `dt` from `t`.
pub fn check_end(t: f64, dt: f64, t_1: f64) -> Result<()> {
    let end = t + dt;
    if (t_1 - end).abs() <= same_time(t_1.abs().max(end.abs())) {
        return Ok(());
    }
    let allowed = format!("{} s, the end of the next step of {} s", written(end), written(dt));
    Err(Error::NotATime { time: t_1, allowed })
}
