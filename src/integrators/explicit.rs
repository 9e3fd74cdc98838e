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
        let (u, v) = (state.u.as_mut_slice(), state.v.as_mut_slice());
        for ((u, v), a) in u.iter_mut().zip(v).zip(self.motion.a.as_slice()) {
            *v += 0.5 * dt * a;
            *u += dt * *v;
        }
        self.motion.accelerate(structure, &state.u, t_1, counts);
        // A sum drops no NaN.
        if !kick(0.5 * dt, self.motion.a.as_slice(), state.v.as_mut_slice()).is_finite() {
            return Err(Error::NotFinite { quantity: "the acceleration", time: t_1, step: state.step + 1 });
        }
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}

/// Adds `dt` · a to the velocity; returns the sum of all accelerations.
fn kick(dt: f64, a: &[f64], v: &mut [f64]) -> f64 {
    // Four sums at a time: in a single one every addition would wait for the one before.
    let mut sums = [0.0; 4];
    let ((a, last_a), (v, last_v)) = (a.as_chunks::<4>(), v.as_chunks_mut::<4>());
    for (a, v) in a.iter().zip(v) {
        for n in 0..4 {
            v[n] += dt * a[n];
            sums[n] += a[n];
        }
    }
    for (a, v) in last_a.iter().zip(last_v) {
        *v += dt * a;
        sums[0] += a;
    }
    sums.iter().sum()
}
