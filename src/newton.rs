//! Newton's iteration, the one loop that every implicit method uses.

use nalgebra::DVector;

use crate::error::{Error, Result};
use crate::linear::{BandMatrix, SingularAt};
use crate::run::Counts;
use crate::structure::Structure;

/// More iterations than this never helped: where Newton converges at all it takes three to eight.
const MOST_ITERATIONS: usize = 30;

/// A residual and the largest of the forces it is made of, N, by which it is judged.
pub struct Residual {
    /// What should vanish.
    pub value: DVector<f64>,
    /// [`Structure::largest`] over its terms.
    pub largest_term: f64,
}

/// Solves `residual(x) = 0` from the guess in `x`.
///
/// Done when the residual's largest entry is at most `tolerance` times the largest force term, or at most eight times
/// the rounding error of an elastic force, below which no iteration can get.
///
/// # Errors
/// [`Error::NewtonFailed`] without convergence, [`Error::Singular`] for a singular tangent, [`Error::NotFinite`] when the iteration
/// leaves the numbers; `time` (s) and `step` are for the message.
pub fn solve(
    structure: &Structure,
    tolerance: f64,
    (time, step): (f64, usize),
    x: &mut DVector<f64>,
    counts: &mut Counts,
    residual: impl Fn(&DVector<f64>) -> Residual,
    tangent: impl Fn(&DVector<f64>) -> BandMatrix,
) -> Result<()> {
    let mut iterations = 0;
    loop {
        let Residual { mut value, largest_term } = residual(x);
        counts.force_calls += 1;
        let size = structure.largest(&value);
        if size <= (tolerance * largest_term).max(8.0 * structure.rounding()) {
            return Ok(());
        }
        if !size.is_finite() {
            return Err(Error::NotFinite { quantity: "the residual", time, step });
        }
        if iterations == MOST_ITERATIONS {
            return Err(Error::NewtonFailed { time, iterations, residual: size / largest_term, tolerance });
        }
        let factors = tangent(x).lu().map_err(|SingularAt(pivot)| Error::Singular { time, pivot })?;
        factors.solve(&mut value);
        *x -= value;
        iterations += 1;
        counts.newton_iterations += 1;
        counts.tangent_calls += 1;
        counts.factorizations += 1;
        counts.solves += 1;
    }
}
