//! Adaptive steps, controlled by an error estimate.
//!
//! A step is repeated, shorter, if its estimate exceeds the tolerance or an element collapses. After an estimate far
//! below the tolerance the next step is longer. Steps end at the corners of temperature and force histories: in
//! between, loads are linear in time, and the method keeps its order. Between two requested times all steps are equal
//! as long as the estimate allows, so that one matrix serves for many.

use super::counts::Counts;
use super::integrator::{Integrator, same_time};
use super::state::State;
use crate::error::{Error, Result, time_text};
use crate::structure::Structure;

/// Shortest step relative to the longest; those cut short by a corner or a row may be shorter.
const SHORTEST_STEP: f64 = 1e-6;

/// Fraction of the step given by the error estimate that is used.
const SAFETY: f64 = 0.9;

/// Largest factor by which a step grows at once, and the smallest one for which it grows at all.
const GROWTH: (f64, f64) = (4.0, 1.25);

/// Smallest factor by which a step shrinks at once; also used for a step without a result.
const SHRINKAGE: f64 = 0.25;

/// One-step method that estimates its error.
pub trait Embedded {
    /// Order of the less accurate solution: the estimate is proportional to the step to the power of this plus one.
    const ORDER: u8;

    /// Makes a step of length `dt` that ends at `t_1`.
    ///
    /// # Errors
    /// Reason why the step cannot be made; the state is then meaningless.
    fn make(&mut self, structure: &Structure, state: &mut State, dt: f64, t_1: f64, counts: &mut Counts) -> Result<()>;

    /// Estimated error of the last step, m: the largest in positions, and in slopes times the length over which they
    /// act.
    fn error(&mut self, structure: &Structure, before: &State, after: &State, dt: f64, counts: &mut Counts) -> f64;

    /// Restores what the method carries from step to step, after a rejected step.
    fn undo(&mut self);

    /// Work of forces and heat over the last step, J.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> f64;
}

/// Method with adaptive steps.
#[derive(Debug)]
pub struct Adaptive<M> {
    method: M,
    tolerance: f64,
    longest: f64,
    /// Length of the next attempted step, s.
    next: f64,
    /// Times inside the run at which a history has a corner, in order.
    corners: Vec<f64>,
    before: State,
}

impl<M: Embedded> Adaptive<M> {
    /// Controls steps by the tolerance `tolerance` (m) of their estimated error and the longest step `longest` (s).
    pub fn new(method: M, structure: &Structure, state: &State, tolerance: f64, longest: f64) -> Adaptive<M> {
        let corners = structure.corners().to_vec();
        Adaptive { method, tolerance, longest, next: longest, corners, before: state.clone() }
    }

    /// Time at which the steps from `t` towards `t_1` must end first: `t_1`, or an earlier corner, however near. A
    /// pulse between two corners may be as strong as it is short.
    fn next_end(&self, t: f64, t_1: f64) -> f64 {
        let near = same_time(t_1);
        let next = self.corners.partition_point(|corner| *corner <= t + near);
        self.corners.get(next).copied().filter(|corner| *corner < t_1 - near).unwrap_or(t_1)
    }

    /// Factor for the next step, from the error estimate of this one.
    fn growth(&self, error: f64) -> f64 {
        if error == 0.0 {
            return GROWTH.0;
        }
        let wanted = SAFETY * (self.tolerance / error).powf(1.0 / f64::from(M::ORDER + 1));
        // An error so small that the ratio overflows is as good as none; one that is not a number is no small one.
        if wanted.is_nan() { SHRINKAGE } else { wanted.clamp(SHRINKAGE, GROWTH.0) }
    }
}

impl<M: Embedded> Integrator for Adaptive<M> {
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> Option<f64> {
        Some(self.method.work(structure, before, after))
    }

    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        // Also where it is not a number.
        if !(t_1 > state.t && t_1.is_finite()) {
            let allowed = format!("times after {} s", time_text(state.t));
            return Err(Error::NotATime { time: t_1, allowed, statics: false });
        }
        self.before.copy_from(state);
        let t_1 = self.next_end(state.t, t_1);
        loop {
            let left = t_1 - state.t;
            // Equal steps to the end; a remainder of rounding size is no step.
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
            let growth = self.growth(error);
            if error <= self.tolerance {
                if growth >= GROWTH.0 {
                    // A step cut short by a corner or a row is no evidence against longer ones.
                    self.next = (dt * growth).max(self.next).min(self.longest);
                } else if growth >= GROWTH.1 || growth < 1.0 {
                    self.next = (dt * growth).min(self.longest);
                }
                counts.steps += 1;
                return Ok(());
            }
            counts.rejected += 1;
            state.copy_from(&self.before);
            self.method.undo();
            self.next = dt * growth.min(SAFETY);
            if self.next < SHORTEST_STEP * self.longest {
                // Shorter steps do not help.
                if let Some(collapsed @ Error::Collapsed { .. }) = failed.take() {
                    return Err(collapsed);
                }
                let (time, step, tolerance) = (state.t, self.next, self.tolerance);
                return Err(Error::StepTooSmall { time, step, error, tolerance });
            }
        }
    }
}
