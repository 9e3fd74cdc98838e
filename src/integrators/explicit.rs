//! Velocity Verlet method with the consistent mass matrix, factorised once.
//!
//! v½ = v₀ + ½Δt a₀,  u₁ = u₀ + Δt v½,  a₁ = M⁻¹(Q_w − Q_e(u₁, ΔT₁)),  v₁ = v½ + ½Δt a₁: second order, stable up to Δt
//! = 2/ω for the largest angular frequency ω.

use super::counts::Counts;
use super::equation_of_motion::EquationOfMotion;
use super::equation_of_motion::check_step;
use super::integrator::{Integrator, check_end};
use super::state::State;
use crate::error::{Error, Result};
use crate::structure::Structure;

/// Velocity Verlet method with a fixed step and the last acceleration.
#[derive(Debug)]
pub struct Explicit {
    step: f64,
    motion: EquationOfMotion,
}

impl Explicit {
    /// Method with step `step` (s), starting at `state`.
    ///
    /// # Errors
    /// [`Error::StepTooLarge`] above the stability limit of the initial largest frequency (an upper bound, see
    /// [`Structure::largest_frequency`]); [`Error::Singular`] for a singular mass matrix.
    pub fn new(structure: &Structure, state: &State, step: f64, counts: &mut Counts) -> Result<Explicit> {
        check_step(structure, "explicit", step, 2.0)?;
        let mut motion = EquationOfMotion::new(structure, counts)?;
        motion.accelerate(structure, &state.u, state.t, counts);
        Ok(Explicit { step, motion })
    }
}

impl Integrator for Explicit {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let dt = self.step;
        check_end(state.t, dt, t_1)?;
        state.v.axpy(0.5 * dt, &self.motion.a, 1.0);
        state.u.axpy(dt, &state.v, 1.0);
        self.motion.accelerate(structure, &state.u, t_1, counts);
        state.v.axpy(0.5 * dt, &self.motion.a, 1.0);
        // A sum drops no NaN.
        if !self.motion.a.sum().is_finite() {
            return Err(Error::NotFinite { quantity: "the acceleration", time: t_1, step: state.step + 1 });
        }
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}
