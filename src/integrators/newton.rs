//! Newton's iteration for any system of nonlinear equations.
//!
//! The matrix of an earlier iteration, or of an earlier step, serves as long as the residual shrinks with it so fast that a
//! new one would not pay: a factorisation costs as much as a few iterations. Where it fails the iterate goes back and
//! a new matrix is made: nothing converges worse than with a new one each time.

use super::counts::Counts;
use crate::linear::SingularAt;

/// More new matrices than this never helped: where Newton converges at all it takes three to eight.
const MOST_MATRICES: usize = 30;

/// Iterations that cost as much as a new matrix, measured: where more than these are left with the old one, it is not used.
const WORTH: f64 = 3.0;

/// Steps that begin with a new matrix after one of an earlier step did harm.
const DISTRUST: usize = 10;

/// An iteration that leaves more than this of the residual has done what it can.
const STUCK: f64 = 0.25;

/// How many times the rounding error of one force a residual of several may be.
const ROUNDINGS: f64 = 8.0;

/// How many times that a residual may be for rounding to be what it failed for.
const NEAR: f64 = 100.0;

/// Size of the residual, and the largest of the terms that it is the sum of, by which it is judged.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// Its largest entry.
    pub size: f64,
    /// The largest entry of all terms.
    pub largest_term: f64,
}

/// Nonlinear equations with their unknowns.
pub trait Equations {
    /// Evaluates what should vanish at the present iterate.
    fn residual(&mut self, counts: &mut Counts) -> Residual;

    /// Whether no entry of it is above `times` the rounding error of the elastic forces.
    fn at_rounding(&self, times: f64) -> bool;

    /// Makes the matrix of the present iterate, and its factors.
    ///
    /// # Errors
    /// The unknown with a vanishing pivot.
    fn factorize(&mut self) -> Result<(), SingularAt>;

    /// Solves with the factors and takes the solution off the unknowns.
    fn improve(&mut self);

    /// Takes the last improvement back.
    fn undo(&mut self);
}

/// Why an iteration ended without a solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// The residual stopped short of its goal.
    NotConverged {
        /// Iterations made.
        iterations: usize,
        /// Last residual over the largest term.
        residual: f64,
        /// What it had to reach.
        tolerance: f64,
        /// Whether it is of the order of rounding errors of the terms.
        at_rounding: bool,
    },
    /// The matrix is singular.
    Singular {
        /// Number of the iteration, from 1.
        iteration: usize,
        /// The pivot that vanishes.
        at: SingularAt,
    },
}

/// What an iteration knows from earlier ones.
#[derive(Clone, Debug)]
pub struct Newton {
    tolerance: f64,
    /// Whether every iteration makes its own matrix.
    always_new: bool,
    has_matrix: bool,
    /// Steps for which matrices of earlier ones are not trusted.
    distrust: usize,
}

impl Newton {
    /// An iteration that ends when the residual's largest entry is at most `tolerance` times the largest force term.
    pub fn new(tolerance: f64) -> Newton {
        Newton { tolerance, always_new: false, has_matrix: false, distrust: 0 }
    }

    /// The same with a new matrix in every iteration.
    pub fn with_new_matrices(tolerance: f64) -> Newton {
        Newton { always_new: true, ..Newton::new(tolerance) }
    }

    /// Whether there are factors of an earlier iteration.
    pub fn has_matrix(&self) -> bool {
        self.has_matrix
    }

    /// Factors were made outside of an iteration.
    pub fn remember(&mut self) {
        self.has_matrix = true;
    }

    /// Forgets the last matrix: the method's step has changed.
    pub fn forget(&mut self) {
        self.has_matrix = false;
    }

    /// Solves the equations, from the guess that they hold.
    ///
    /// Done when the residual's largest entry is at most the tolerance times the largest force term; or, once the iteration
    /// has done what it can, at most eight times the rounding error of the elastic forces, below which it cannot get. The
    /// guess itself is not judged by rounding: a load smaller than that still moves the structure. Constraint rows are not
    /// judged: they are linear, so that every iterate fulfils them.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn solve(&mut self, equations: &mut impl Equations, counts: &mut Counts) -> Result<(), Failure> {
        self.distrust = self.distrust.saturating_sub(1);
        // Whether the last improvement came from the matrix of its own iterate.
        let mut own = true;
        let mut needs_matrix = self.always_new || !self.has_matrix || self.distrust > 0;
        let (mut iterations, mut matrices) = (0, 0);
        let mut last: Option<f64> = None;
        loop {
            let Residual { size, largest_term } = equations.residual(counts);
            let finite = size.is_finite() && largest_term.is_finite();
            let goal = self.tolerance * largest_term;
            // A residual at rounding is not the end as long as iterations reduce it: that of a fine mesh may hide all of a bent shape.
            let stuck = last.is_some_and(|last| size >= STUCK * last);
            if finite && (size <= goal || (stuck && equations.at_rounding(ROUNDINGS))) {
                return Ok(());
            }
            if let Some(last) = last.take() {
                let rate = size / last;
                if !own && (!finite || rate >= 1.0) {
                    // The old matrix did harm.
                    equations.undo();
                    (self.distrust, needs_matrix) = (DISTRUST, true);
                    continue;
                }
                needs_matrix = self.always_new || rate >= 1.0 || (goal / size).ln() / rate.ln() > WORTH;
            }
            if !finite || matrices == MOST_MATRICES {
                self.has_matrix = false;
                let (residual, tolerance) = (size / largest_term, self.tolerance);
                let at_rounding = finite && equations.at_rounding(NEAR * ROUNDINGS);
                return Err(Failure::NotConverged { iterations, residual, tolerance, at_rounding });
            }
            if needs_matrix {
                matrices += 1;
                counts.tangent_calls += 1;
                counts.factorizations += 1;
                equations.factorize().map_err(|at| {
                    self.has_matrix = false;
                    Failure::Singular { iteration: iterations + 1, at }
                })?;
                self.has_matrix = true;
            }
            own = std::mem::take(&mut needs_matrix);
            iterations += 1;
            counts.newton_iterations += 1;
            counts.solves += 1;
            equations.improve();
            last = Some(size);
        }
    }
}

#[cfg(test)]
mod tests;
