//! Newton's iteration for any system of nonlinear equations.
//!
//! The matrix of an earlier iteration or step is reused as long as the residual shrinks so fast that a new one would
//! not pay: a factorisation costs as much as a few iterations. If that fails, the iterate goes back and a new matrix is
//! made. No solution converges worse than with a new matrix each time.

use super::counts::Counts;
use crate::linear::SingularAt;

/// Most matrices per solution: more never helped, since Newton takes three to eight where it converges at all.
const MOST_MATRICES: usize = 30;

/// Most iterations beyond the last matrix, if these are expected to be enough. With one tangent for several stages
/// convergence is linear at long steps, by a factor of two each time, and a new matrix changes nothing.
const FURTHER_ITERATIONS: f64 = 20.0;

/// Cost of a new matrix in iterations, measured: a reused matrix is kept as long as no more iterations are expected.
const MATRIX_COST: f64 = 3.0;

/// Number of steps that begin with a new matrix after a reused one did harm.
const DISTRUSTED_STEPS: usize = 10;

/// Ratio of successive residuals above which an iteration stagnates.
const STAGNATION: f64 = 0.25;

/// Allowed residual in rounding errors of one force; a residual sums several.
const ROUNDING_FACTOR: f64 = 8.0;

/// Multiple of the allowed residual below which rounding is blamed for a failure.
const ROUNDING_SUSPECTED: f64 = 4.0;

/// Magnitude of the residual, and of the largest of its terms, which it is compared with.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// Largest entry of the residual.
    pub size: f64,
    /// Largest entry of all terms.
    pub largest_term: f64,
}

/// Nonlinear equations, with their unknowns.
pub trait Equations {
    /// Evaluates the residual at the present iterate.
    fn residual(&mut self, counts: &mut Counts) -> Residual;

    /// Whether every entry of the residual is within `times` the rounding error of the elastic forces.
    fn at_rounding(&self, times: f64) -> bool;

    /// Makes and factorises the matrix of the present iterate.
    ///
    /// # Errors
    /// Unknown of a vanishing pivot.
    fn factorize(&mut self) -> Result<(), SingularAt>;

    /// Solves with the factors and subtracts the solution from the unknowns.
    fn improve(&mut self);

    /// Takes the last improvement back.
    fn undo(&mut self);
}

/// Failure of an iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// The residual did not reach the tolerance.
    NotConverged {
        /// Number of iterations.
        iterations: usize,
        /// Last residual, relative to the largest term.
        residual: f64,
        /// Required residual, relative to the largest term.
        tolerance: f64,
        /// Whether the residual is at the level of rounding errors.
        at_rounding: bool,
    },
    /// The matrix is singular.
    Singular {
        /// Number of the iteration, from 1.
        iteration: usize,
        /// Vanishing pivot.
        at: SingularAt,
    },
}

/// Newton's iteration, with what it remembers from earlier solutions.
#[derive(Clone, Debug)]
pub struct Newton {
    tolerance: f64,
    /// Whether every iteration makes a new matrix.
    always_new: bool,
    has_matrix: bool,
    /// Number of further steps that begin with a new matrix.
    distrust: usize,
}

impl Newton {
    /// Iteration that ends when the residual's largest entry is at most `tolerance` times the largest force term.
    pub fn new(tolerance: f64) -> Newton {
        Newton { tolerance, always_new: false, has_matrix: false, distrust: 0 }
    }

    /// Iteration with a new matrix each time; it ends as that of [`new`](Newton::new).
    pub fn with_new_matrices(tolerance: f64) -> Newton {
        Newton { always_new: true, ..Newton::new(tolerance) }
    }

    /// Whether a factorised matrix of an earlier iteration can be used again.
    pub fn has_matrix(&self) -> bool {
        self.has_matrix
    }

    /// Records that factors were made outside an iteration.
    pub fn remember(&mut self) {
        self.has_matrix = true;
    }

    /// Discards the last matrix, since the method's step has changed.
    pub fn forget(&mut self) {
        self.has_matrix = false;
    }

    /// Solves the equations, starting from the guess that they hold.
    ///
    /// It ends when the residual's largest entry is at most the tolerance times the largest force term. Once the
    /// iteration stagnates, eight times the rounding error of the elastic forces is enough, since it cannot get below.
    /// The guess itself is not judged by rounding: a load smaller than that still moves the structure. Constraint rows
    /// are not judged: they are linear, so that every iterate fulfils them.
    ///
    /// # Errors
    /// [`Failure`] if the residual stops decreasing or a matrix is singular.
    pub fn solve(&mut self, equations: &mut impl Equations, counts: &mut Counts) -> Result<(), Failure> {
        self.distrust = self.distrust.saturating_sub(1);
        // Whether the last improvement used the matrix of its own iterate.
        let mut own_matrix = true;
        let mut needs_matrix = self.always_new || !self.has_matrix || self.distrust > 0;
        let (mut iterations, mut matrices) = (0, 0);
        let mut last: Option<f64> = None;
        let mut rate = 0.0;
        loop {
            let Residual { size, largest_term } = equations.residual(counts);
            let finite = size.is_finite() && largest_term.is_finite();
            let goal = self.tolerance * largest_term;
            // A residual at rounding level does not end the iteration while it still decreases: for a fine mesh it may
            // hide all of a bent shape.
            let stagnates = last.is_some_and(|last| size >= STAGNATION * last);
            if finite && (size <= goal || (stagnates && equations.at_rounding(ROUNDING_FACTOR))) {
                return Ok(());
            }
            if let Some(last) = last.take() {
                rate = size / last;
                if !own_matrix && (!finite || rate >= 1.0) {
                    // The reused matrix did harm.
                    equations.undo();
                    (self.distrust, needs_matrix) = (DISTRUSTED_STEPS, true);
                    continue;
                }
                needs_matrix = self.always_new || rate >= 1.0 || (goal / size).ln() / rate.ln() > MATRIX_COST;
            }
            // A NaN does not converge.
            let converges = rate < 1.0
                && iterations as f64 + (goal / size).ln() / rate.ln() <= MOST_MATRICES as f64 + FURTHER_ITERATIONS;
            if !finite || (matrices == MOST_MATRICES && !converges) {
                self.has_matrix = false;
                let (residual, tolerance) = (size / largest_term, self.tolerance);
                // A residual that still decreases is no rounding.
                let at_rounding = finite && !converges && equations.at_rounding(ROUNDING_SUSPECTED * ROUNDING_FACTOR);
                return Err(Failure::NotConverged { iterations, residual, tolerance, at_rounding });
            }
            needs_matrix &= matrices < MOST_MATRICES;
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
            own_matrix = std::mem::take(&mut needs_matrix);
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
