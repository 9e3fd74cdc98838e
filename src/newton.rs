//! Newton's iteration, the one loop that every implicit method uses.

use nalgebra::DVector;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::linear::{BandMatrix, SingularAt};
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

/// The step that an equation belongs to.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// Displacement at its start.
    pub u_0: &'a DVector<f64>,
    /// Time at its end, s.
    pub t_1: f64,
}

/// Solves an equation of a step from the guess in `du`.
///
/// Done when the residual's largest entry is at most `tolerance` times the largest force term; or, once the iteration
/// has done what it can, at most eight times the rounding error of the elastic forces, below which it cannot get. The
/// guess itself is not judged by rounding: a load smaller than that still moves the structure.
///
/// # Errors
/// [`Error::NewtonFailed`] without convergence, [`Error::Singular`] for a singular tangent.
pub fn solve(
    structure: &Structure,
    tolerance: f64,
    step: Step,
    equation: Equation<impl Fn(&DVector<f64>) -> Residual, impl Fn(&DVector<f64>) -> BandMatrix>,
    du: &mut DVector<f64>,
    counts: &mut Counts,
) -> Result<()> {
    let time = step.t_1;
    let rounding = 8.0 * structure.rounding(step.u_0);
    let mut iterations = 0;
    loop {
        let Residual { mut value, largest_term } = (equation.residual)(du);
        counts.force_calls += 1;
        let size = structure.largest(&value);
        let finite = size.is_finite() && largest_term.is_finite();
        if finite && (size <= tolerance * largest_term || iterations > 0 && size <= rounding) {
            return Ok(());
        }
        if !finite || iterations == MOST_ITERATIONS {
            return Err(Error::NewtonFailed { time, iterations, residual: size / largest_term, tolerance });
        }
        iterations += 1;
        let factors = (equation.tangent)(du).lu().map_err(|SingularAt(pivot)| Error::Singular {
            time,
            iteration: iterations,
            pivot,
        })?;
        factors.solve(&mut value);
        *du -= value;
        counts.newton_iterations += 1;
        counts.tangent_calls += 1;
        counts.factorizations += 1;
        counts.solves += 1;
    }
}
