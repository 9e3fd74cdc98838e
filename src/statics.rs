//! Equilibrium Q_e(u, s ΔT) = s f as the load factor s grows from 0 to 1.
//!
//! Newton's iteration with independent stresses (Magisano, Leonetti and Garcea 2017,
//! [`Beam::mixed_tangent`](crate::kernel::Beam::mixed_tangent)): slender rods in large bending, where plain Newton
//! creeps along in steps that stretch the axis too little to matter, take it no longer than stubby ones.
//!
//! What is found is an equilibrium, not always a stable one: a perfect column stays straight above its Euler load.

use nalgebra::DVector;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::integrators::{Integrator, State};
use crate::linear::BorderedLu;
use crate::newton::{self, Equation, Iterate, Residual, Step};
use crate::structure::Structure;

/// Load steps; the load factor takes the place of time.
#[derive(Clone, Debug)]
pub struct Statics {
    tolerance: f64,
    /// Increment of the last load step, the guess for the next.
    du: DVector<f64>,
    factors: Option<BorderedLu>,
}

impl Statics {
    /// Statics of a structure, with Newton's tolerance.
    pub fn new(structure: &Structure, tolerance: f64) -> Statics {
        Statics { tolerance, du: DVector::zeros(structure.size()), factors: None }
    }
}

impl Integrator for Statics {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let u_0 = &state.u;
        let (thermal, load) = (structure.thermal_strains(t_1), structure.load(t_1));
        let residual = |du: &DVector<f64>| {
            let mut value = DVector::zeros(structure.size());
            structure.force(&(u_0 + du), &thermal, &mut value);
            let largest_term = structure.largest(&value).max(structure.largest(&load));
            value -= &load;
            Residual { value, largest_term }
        };
        let mut before = None;
        let tangent = |du: &DVector<f64>, old| {
            let u = u_0 + du;
            let factors = structure.mixed_tangent_factors(before.as_ref().unwrap_or(&u), &u, &thermal, old);
            before = Some(u);
            factors
        };
        let equation = Equation { residual, tangent };
        newton::solve(
            structure,
            self.tolerance,
            Step { u_0, t_1 },
            equation,
            Iterate { du: &mut self.du, factors: &mut self.factors },
            counts,
        )
        .map_err(no_equilibrium)?;
        state.u += &self.du;
        Ok(())
    }
}

/// What Newton's iteration has to say, in terms of loads instead of times.
fn no_equilibrium(error: Error) -> Error {
    match error {
        Error::NewtonFailed { time: factor, iterations, residual, tolerance } => {
            let reason = format!(
                "residual {residual:.3e} of the largest force term after {iterations} iterations (tolerance {tolerance:.1e})"
            );
            Error::NoEquilibrium { factor, reason }
        }
        Error::Singular { time: factor, iteration, place } => Error::NoEquilibrium {
            factor,
            reason: format!("the tangent is singular at {place}, iteration {iteration}"),
        },
        other => other,
    }
}
