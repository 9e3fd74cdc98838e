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
use crate::lanes::{Lanes, Task};
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
        structure.path().run(KickAndDrift { dt, a: self.motion.a.as_slice(), v, u });
        self.motion.accelerate(structure, &state.u, t_1, counts);
        let sum = structure.path().run(Kick { dt, a: self.motion.a.as_slice(), v: state.v.as_mut_slice() });
        // A sum drops no NaN.
        if !sum.is_finite() {
            return Err(Error::NotFinite { quantity: "the acceleration", time: t_1, step: state.step + 1 });
        }
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}

/// First half of a step: v and then u.
struct KickAndDrift<'a> {
    dt: f64,
    a: &'a [f64],
    v: &'a mut [f64],
    u: &'a mut [f64],
}

impl Task for KickAndDrift<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) {
        let KickAndDrift { dt, a, v, u } = self;
        let (half, whole) = (L::splat(token, 0.5 * dt), L::splat(token, dt));
        let ((a, last_a), (v, last_v), (u, last_u)) = (a.as_chunks(), v.as_chunks_mut(), u.as_chunks_mut());
        for ((a, v), u) in a.iter().zip(v).zip(u) {
            let kicked = L::load(token, a).mul_add(half, L::load(token, v));
            *v = kicked.to_array();
            *u = kicked.mul_add(whole, L::load(token, u)).to_array();
        }
        for ((a, v), u) in last_a.iter().zip(last_v).zip(last_u) {
            *v += 0.5 * dt * a;
            *u += dt * *v;
        }
    }
}

/// Second half of a step, v; the sum of all accelerations.
struct Kick<'a> {
    dt: f64,
    a: &'a [f64],
    v: &'a mut [f64],
}

impl Task for Kick<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) -> f64 {
        let (half, mut sums) = (L::splat(token, 0.5 * self.dt), L::splat(token, 0.0));
        let ((a, last_a), (v, last_v)) = (self.a.as_chunks(), self.v.as_chunks_mut());
        for (a, v) in a.iter().zip(v) {
            let a = L::load(token, a);
            *v = a.mul_add(half, L::load(token, v)).to_array();
            sums = sums + a;
        }
        let [a, b, c, d] = sums.to_array();
        let mut sum = a + b + c + d;
        for (a, v) in last_a.iter().zip(last_v) {
            *v += 0.5 * self.dt * a;
            sum += a;
        }
        sum
    }
}
