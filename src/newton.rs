//! Newton's iteration, the one loop that every implicit method uses.

use nalgebra::DVector;

use crate::error::{Error, Result};
use crate::integrators::State;
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

/// An equation for the increment `du` of the displacement over a step.
pub struct Equation<R, T> {
    /// What should vanish, as a function of `du`.
    pub residual: R,
    /// Its derivative.
    pub tangent: T,
}

/// Solves an equation of the step from `state` to the time `t_1` (s), from the guess in `du`.
///
/// Done when the residual's largest entry is at most `tolerance` times the largest force term, or at most eight times
/// the rounding error of the elastic forces, below which no iteration can get.
///
/// # Errors
/// [`Error::NewtonFailed`] without convergence, [`Error::Singular`] for a singular tangent, [`Error::NotFinite`] when the iteration
/// leaves the numbers.
pub fn solve(
    structure: &Structure,
    tolerance: f64,
    (state, t_1): (&State, f64),
    equation: Equation<impl Fn(&DVector<f64>) -> Residual, impl Fn(&DVector<f64>) -> BandMatrix>,
    du: &mut DVector<f64>,
    counts: &mut Counts,
) -> Result<()> {
    let rounding = 8.0 * structure.rounding(&state.u);
    let mut iterations = 0;
    loop {
        let Residual { mut value, largest_term } = (equation.residual)(du);
        counts.force_calls += 1;
        let size = structure.largest(&value);
        if size <= (tolerance * largest_term).max(rounding) {
            return Ok(());
        }
        if !size.is_finite() {
            return Err(Error::NotFinite { quantity: "the residual", time: t_1, step: state.step + 1 });
        }
        if iterations == MOST_ITERATIONS {
            return Err(Error::NewtonFailed { time: t_1, iterations, residual: size / largest_term, tolerance });
        }
        let factors = (equation.tangent)(du).lu().map_err(|SingularAt(pivot)| Error::Singular { time: t_1, pivot })?;
        factors.solve(&mut value);
        *du -= value;
        iterations += 1;
        counts.newton_iterations += 1;
        counts.tangent_calls += 1;
        counts.factorizations += 1;
        counts.solves += 1;
    }
}
