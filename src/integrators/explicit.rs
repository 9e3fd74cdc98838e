//! Velocity Verlet with the consistent mass matrix, factorised once.
//!
//! v½ = v₀ + ½Δt a₀,  u₁ = u₀ + Δt v½,  a₁ = M⁻¹(Q_w − Q_e(u₁, ΔT₁)),  v₁ = v½ + ½Δt a₁: of second order, stable up to
//! Δt = 2/ω for the largest angular frequency ω.

use nalgebra::DVector;

use super::{Integrator, State, acceleration, mass_factors};
use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::linear::BorderedLu;
use crate::scene::Method;
use crate::structure::Structure;

/// The method with its step, the factors of the mass matrix and the acceleration that it carries along.
#[derive(Clone, Debug)]
pub struct Explicit {
    step: f64,
    mass: BorderedLu,
    a: DVector<f64>,
}

impl Explicit {
    /// A method with step `step` (s), starting at `state`.
    ///
    /// # Errors
    /// [`Error::StepTooLarge`] over the stability limit of the start's largest frequency (an upper bound of it, see
    /// [`Structure::largest_frequency`]); [`Error::Singular`] for a singular mass matrix.
    pub fn new(structure: &Structure, state: &State, step: f64, counts: &mut Counts) -> Result<Explicit> {
        let frequency = structure.largest_frequency();
        let largest = 2.0 / frequency;
        // A limit that is not a number is refused too.
        if step > largest || largest.is_nan() {
            return Err(Error::StepTooLarge { method: Method::Explicit.to_string(), step, largest, frequency });
        }
        let mass = mass_factors(structure, counts)?;
        let a = acceleration(structure, &mass, &state.u, state.t, counts);
        Ok(Explicit { step, mass, a })
    }
}

impl Integrator for Explicit {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let dt = self.step;
        state.v.axpy(0.5 * dt, &self.a, 1.0);
        state.u.axpy(dt, &state.v, 1.0);
        self.a = acceleration(structure, &self.mass, &state.u, t_1, counts);
        state.v.axpy(0.5 * dt, &self.a, 1.0);
        if !structure.largest(&self.a).is_finite() {
            return Err(Error::NotFinite { quantity: "the acceleration", time: t_1, step: state.step + 1 });
        }
        Ok(())
    }
}
