//! The energy–momentum rule (Simo and Tarnow 1992): the mid-point rule with stresses averaged over the step.
//!
//! M (v₁ − v₀)/Δt + Q̄ = ½(f₀ + f₁),  (u₁ − u₀)/Δt = (v₀ + v₁)/2,  Q̄ = ∫ (∂ε/∂e at the middle)ᵀ ½(σ₀ + σ₁) dV.
//!
//! Strains are quadratic in u, so Q̄·(u₁ − u₀) is exactly the change of strain energy less the work of heating: energy is
//! kept at every step size, up to Newton's tolerance. That says nothing about accuracy, which is of second order.

use nalgebra::DVector;

use super::{Integrator, State};
use crate::counts::Counts;
use crate::error::Result;
use crate::linear::BorderedLu;
use crate::newton::{self, Equation, Iterate, Residual, Step};
use crate::structure::{StepEnds, Structure};

/// The method with its step and Newton's tolerance.
#[derive(Clone, Debug)]
pub struct EnergyMomentum {
    step: f64,
    tolerance: f64,
    factors: Option<BorderedLu>,
}

impl EnergyMomentum {
    /// A method with step `step` (s).
    pub fn new(step: f64, tolerance: f64) -> EnergyMomentum {
        EnergyMomentum { step, tolerance, factors: None }
    }
}

impl Integrator for EnergyMomentum {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let dt = self.step;
        let (u_0, v_0) = (&state.u, &state.v);
        let (thermal_0, thermal_1) = (&*structure.thermal_strains(state.t), &*structure.thermal_strains(t_1));
        let load = mean_load(structure, state.t, t_1);

        // The unknown is the increment du: M (v₁ − v₀)/Δt = 2/Δt² M (du − Δt v₀) then keeps its digits at small steps.
        let residual = |du: &DVector<f64>| {
            let mut value = DVector::zeros(structure.size());
            structure.mean_force(&StepEnds { u_0, u_1: &(u_0 + du), thermal_0, thermal_1 }, &mut value);
            let inertia = structure.inertia(&((du - v_0 * dt) * (2.0 / (dt * dt))));
            let terms = [&value, &inertia, &load];
            let largest_term = terms.map(|term| structure.largest(term)).into_iter().fold(0.0, f64::max);
            value += inertia - &load;
            Residual { value, largest_term }
        };
        let tangent = |du: &DVector<f64>, old| {
            let ends = StepEnds { u_0, u_1: &(u_0 + du), thermal_0, thermal_1 };
            structure.mean_tangent_factors(&ends, 2.0 / (dt * dt), old)
        };
        let mut du = v_0 * dt;
        newton::solve(
            structure,
            self.tolerance,
            Step { u_0, t_1 },
            Equation { residual, tangent },
            Iterate { du: &mut du, factors: &mut self.factors },
            counts,
        )?;

        state.v = &du * (2.0 / dt) - v_0;
        state.u += du;
        Ok(())
    }
}

/// External force averaged over a step: its work over the step is then that average times the displacement.
fn mean_load(structure: &Structure, t_0: f64, t_1: f64) -> DVector<f64> {
    0.5 * (structure.load(t_0) + structure.load(t_1))
}
