//! Newton's iteration, the one loop that every implicit method uses.

use nalgebra::DVector;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::linear::{BorderedLu, SingularAt};
use crate::structure::Structure;

/// More iterations than this never helped: where Newton converges at all it takes three to eight.
const MOST_ITERATIONS: usize = 30;

/// How many times the rounding error of one force a residual of several may be.
const ROUNDINGS: f64 = 8.0;

/// A residual and the largest of the forces it is made of, N, by which it is judged.
pub struct Residual {
    /// What should vanish.
    pub value: DVector<f64>,
    /// [`Structure::largest`] over its terms.
    pub largest_term: f64,
}

/// An equation for the increment `du` of the displacement over a step; multipliers stand in their places of it.
pub struct Equation<R, T> {
    /// What should vanish, as a function of `du`.
    pub residual: R,
    /// LU factors of its derivative; old ones give their memory.
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

/// What an iteration works on.
pub struct Iterate<'a> {
    /// The guess, then the solution.
    pub du: &'a mut DVector<f64>,
    /// The last factors, whose memory is used again.
    pub factors: &'a mut Option<BorderedLu>,
}

/// Solves an equation of a step from the guess in `du`.
///
/// Done when the residual's largest entry is at most `tolerance` times the largest force term; or, once the iteration
/// has done what it can, at most eight times the rounding error of the elastic forces, below which it cannot get. The
/// guess itself is not judged by rounding: a load smaller than that still moves the structure. Constraint rows are not
/// judged: they are linear, so that every iterate fulfils them.
///
/// # Errors
/// [`Error::NewtonFailed`] without convergence, [`Error::Singular`] for a singular tangent.
pub fn solve(
    structure: &Structure,
    tolerance: f64,
    step: Step,
    mut equation: Equation<
        impl Fn(&DVector<f64>) -> Residual,
        impl FnMut(&DVector<f64>, Option<BorderedLu>) -> std::result::Result<BorderedLu, SingularAt>,
    >,
    Iterate { du, factors }: Iterate,
    counts: &mut Counts,
) -> Result<()> {
    let time = step.t_1;
    let mut iterations = 0;
    loop {
        let Residual { mut value, largest_term } = (equation.residual)(du);
        counts.force_calls += 1;
        let size = structure.largest(&value);
        let finite = size.is_finite() && largest_term.is_finite();
        let at_rounding = || iterations > 0 && structure.within_rounding(&value, &(step.u_0 + &*du), time, ROUNDINGS);
        if finite && (size <= tolerance * largest_term || at_rounding()) {
            return Ok(());
        }
        if !finite || iterations == MOST_ITERATIONS {
            return Err(Error::NewtonFailed { time, iterations, residual: size / largest_term, tolerance });
        }
        iterations += 1;
        let new = (equation.tangent)(du, factors.take()).map_err(|SingularAt(unknown)| Error::Singular {
            time,
            iteration: iterations,
            place: structure.place(unknown),
        })?;
        factors.insert(new).solve(&mut value);
        *du -= value;
        counts.newton_iterations += 1;
        counts.tangent_calls += 1;
        counts.factorizations += 1;
        counts.solves += 1;
    }
}
