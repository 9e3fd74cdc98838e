//! Steps of a method's own choice, as long as an error estimate allows.
//!
//! A step whose estimate is over the tolerance, or that collapses an element, is made again, shorter; after one that is far below it
//! the next is longer. Steps end at the corners of temperature and force histories: between two of them loads are linear in time, and the
//! method has its order.
//! Between two times that are asked for all steps are equal as long as the estimate allows, so that a matrix serves for many.

use super::counts::Counts;
use super::integrator::{Integrator, same_time};
use super::state::State;
use crate::error::{Error, Result};
use crate::structure::Structure;

/// The shortest step, of the longest; those that a corner or a row ends may be shorter.
const SHORTEST: f64 = 1e-6;

/// What a step may be of the one that the estimate calls for.
const SAFETY: f64 = 0.9;

/// A step is made longer at once by this factor at most, and not for less than the second.
const LONGER: (f64, f64) = (4.0, 1.25);

/// A step is made shorter at once by this factor at most; it is also what a step without a result is made shorter by.
const SHORTER: f64 = 0.25;

/// A method that estimates the error of a step.
pub trait Embedded {
    /// Order of the less accurate solution: the estimate falls with the step to the power of this and one.
    const ORDER: u8;

    /// Makes a step of length `dt` that ends at `t_1`.
    ///
    /// # Errors
    /// Where the step cannot be made; the state is then meaningless.
    fn make(&mut self, structure: &Structure, state: &mut State, dt: f64, t_1: f64, counts: &mut Counts) -> Result<()>;

    /// The estimate for the step just made, m: the largest of positions, and of slopes times the length over which they act.
    fn error(&mut self, structure: &Structure, before: &State, after: &State, dt: f64, counts: &mut Counts) -> f64;

    /// Takes back what the method carries from step to step.
    fn undo(&mut self);

    /// Work of forces and heat over the step just made, J.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> f64;
}

/// A method with its steps.
#[derive(Debug)]
pub struct Adaptive<M> {
    method: M,
    tolerance: f64,
    longest: f64,
    /// The step that is tried next.
    next: f64,
    /// Times inside of the run at which a history has a corner, in order.
    corners: Vec<f64>,
    before: State,
}

impl<M: Embedded> Adaptive<M> {
    /// Steps with an estimated error up to `tolerance` (m), and up to `longest` (s).
    pub fn new(method: M, structure: &Structure, state: &State, tolerance: f64, longest: f64) -> Adaptive<M> {
        let corners = structure.corners().to_vec();
        Adaptive { method, tolerance, longest, next: longest, corners, before: state.clone() }
    }

    /// Where the steps from `t` towards `t_1` have to end first: there, or at a corner before, however near: a pulse between two of
    /// them may be as strong as it is short.
    fn goal(&self, t: f64, t_1: f64) -> f64 {
        let near = same_time(t_1);
        let next = self.corners.partition_point(|corner| *corner <= t + near);
        self.corners.get(next).copied().filter(|corner| *corner < t_1 - near).unwrap_or(t_1)
    }

    /// How much longer the next step may be, for the estimate of this one.
    fn stretch(&self, error: f64) -> f64 {
        if error == 0.0 {
            return LONGER.0;
        }
        let wanted = SAFETY * (self.tolerance / error).powf(1.0 / f64::from(M::ORDER + 1));
        if wanted.is_finite() { wanted.clamp(SHORTER, LONGER.0) } else { SHORTER }
    }
}

impl<M: Embedded> Integrator for Adaptive<M> {
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> Option<f64> {
        Some(self.method.work(structure, before, after))
    }

    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        self.before.copy_from(state);
        let t_1 = self.goal(state.t, t_1);
        loop {
            let left = t_1 - state.t;
            // Equal steps to the end; a remainder of rounding is no step.
            let parts = (left / self.next - 1e-6).ceil().max(1.0);
            let dt = left / parts;
            let end = if parts == 1.0 { t_1 } else { state.t + dt };
            let made = self.method.make(structure, state, dt, end, counts);
            let mut failed = made.and_then(|()| structure.check_collapse(&self.before.u, &state.u, end)).err();
            let error = match failed {
                None => self.method.error(structure, &self.before, state, dt, counts),
                Some(
                    Error::NewtonFailed { .. }
                    | Error::Singular { .. }
                    | Error::NotFinite { .. }
                    | Error::Collapsed { .. },
                ) => f64::INFINITY,
                Some(other) => return Err(other),
            };
            let stretch = self.stretch(error);
            if error <= self.tolerance {
                if stretch >= LONGER.0 {
                    // A step that was cut short by a corner or a row says nothing of longer ones than this.
                    self.next = (dt * stretch).max(self.next).min(self.longest);
                } else if stretch >= LONGER.1 || stretch < 1.0 {
                    self.next = (dt * stretch).min(self.longest);
                }
                counts.steps += 1;
                return Ok(());
            }
            counts.rejected += 1;
            state.copy_from(&self.before);
            self.method.undo();
            self.next = dt * stretch.min(SAFETY);
            if self.next < SHORTEST * self.longest {
                // Nothing shorter mends it.
                if let Some(collapsed @ Error::Collapsed { .. }) = failed.take() {
                    return Err(collapsed);
                }
                let (time, step, tolerance) = (state.t, self.next, self.tolerance);
                return Err(Error::StepTooSmall { time, step, error, tolerance });
            }
        }
    }
}
