//! The energy–momentum rule (Simo and Tarnow 1992): the mid-point rule with stresses averaged over the step.
//!
//! M (v₁ − v₀)/Δt + Q̄ = ½(f₀ + f₁),  (u₁ − u₀)/Δt = (v₀ + v₁)/2,  Q̄ = ∫ (∂ε/∂e at the middle)ᵀ ½(σ₀ + σ₁) dV.
//!
//! Strains are quadratic in u, so that Q̄·(u₁ − u₀) is exactly the change of strain energy minus the work of heating.
//! Energy is conserved at any step size, up to Newton's tolerance. That is no statement about accuracy, which is of
//! second order.

use nalgebra::DVector;

use super::counts::Counts;
use super::increment::{Increment, step_failed};
use super::integrator::{Integrator, check_end};
use super::newton::{Equations, Newton, Residual};
use super::state::State;
use crate::elements::ThermalStrain;
use crate::error::Result;
use crate::linear::SingularAt;
use crate::structure::{Matrix, StepEnds, Structure};

/// Energy–momentum method with a fixed step.
#[derive(Debug)]
pub struct EnergyMomentum {
    step: f64,
    newton: Newton,
    workspace: Workspace,
}

/// Buffers of a step.
#[derive(Debug)]
struct Workspace {
    /// Unknown δ: increment of u beyond Δt v₀.
    increment: Increment,
    /// Predicted displacement u₀ + Δt v₀.
    predicted_u: DVector<f64>,
    /// Step-averaged elastic force Q̄.
    elastic: DVector<f64>,
    /// Mean acceleration (v₁ − v₀)/Δt = 2δ/Δt².
    a: DVector<f64>,
    /// External force averaged over the step: its work is this average times the displacement.
    load: DVector<f64>,
    thermal: [Vec<ThermalStrain>; 2],
}

impl EnergyMomentum {
    /// Method with step `step` (s).
    pub fn new(structure: &Structure, step: f64, newton: Newton) -> EnergyMomentum {
        let zeros = || DVector::zeros(structure.size());
        let workspace = Workspace {
            increment: Increment::new(structure),
            predicted_u: zeros(),
            elastic: zeros(),
            a: zeros(),
            load: zeros(),
            thermal: [structure.thermal_strains(0.0), structure.thermal_strains(0.0)],
        };
        EnergyMomentum { step, newton, workspace }
    }
}

/// Equations of one step.
struct StepEquations<'a> {
    structure: &'a Structure,
    dt: f64,
    state: &'a State,
    workspace: &'a mut Workspace,
    largest_load: f64,
}

/// Both ends of a step.
fn ends<'a>(u_0: &'a DVector<f64>, u_1: &'a DVector<f64>, thermal: &'a [Vec<ThermalStrain>; 2]) -> StepEnds<'a> {
    let [thermal_0, thermal_1] = thermal;
    StepEnds { u_0, u_1, thermal_0, thermal_1 }
}

impl Equations for StepEquations<'_> {
    fn residual(&mut self, counts: &mut Counts) -> Residual {
        let Workspace { increment, predicted_u, elastic, a, load, thermal } = &mut *self.workspace;
        increment.move_from(predicted_u);
        let Increment { du, u, residual, .. } = increment;
        self.structure.mean_force(&ends(&self.state.u, u, thermal), elastic);
        counts.force_calls += 1;
        // Not as a difference of the whole increment and Δt v₀, which would lose digits at small steps.
        a.copy_from(du);
        *a *= 2.0 / (self.dt * self.dt);
        self.structure.inertia_into(a, residual);
        let largest_term =
            self.structure.largest_force(residual).max(self.structure.largest_force(elastic)).max(self.largest_load);
        *residual += &*elastic;
        *residual -= &*load;
        Residual { size: self.structure.largest_force(residual), largest_term }
    }

    fn at_rounding(&self, times: f64) -> bool {
        let Workspace { increment, thermal: [thermal_0, thermal_1], .. } = &*self.workspace;
        // Stresses are averaged over both ends, and so are their rounding errors.
        increment.at_rounding(self.structure, thermal_1, times)
            || self.structure.within_rounding(&increment.residual, &self.state.u, thermal_0, times)
    }

    fn factorize(&mut self) -> std::result::Result<(), SingularAt> {
        let Workspace { increment: Increment { u, factors, .. }, thermal, .. } = &mut *self.workspace;
        let mass = 2.0 / (self.dt * self.dt);
        self.structure.factorize(Matrix::Mean { ends: ends(&self.state.u, u, thermal), mass }, factors)
    }

    fn improve(&mut self) {
        self.workspace.increment.improve();
    }

    fn undo(&mut self) {
        self.workspace.increment.undo();
    }
}

impl Integrator for EnergyMomentum {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let EnergyMomentum { step: dt, newton, workspace } = self;
        check_end(state.t, *dt, t_1)?;
        structure.thermal_strains_into(state.t, &mut workspace.thermal[0]);
        structure.thermal_strains_into(t_1, &mut workspace.thermal[1]);
        structure.load_into(state.t, &mut workspace.load);
        structure.load_into(t_1, &mut workspace.increment.residual);
        workspace.load += &workspace.increment.residual;
        workspace.load *= 0.5;
        workspace.increment.du.fill(0.0);
        workspace.predicted_u.copy_from(&state.u);
        workspace.predicted_u.axpy(*dt, &state.v, 1.0);
        let largest_load = structure.largest_force(&workspace.load);
        let mut step = StepEquations { structure, dt: *dt, state, workspace, largest_load };
        newton.solve(&mut step, counts).map_err(|failure| step_failed(failure, structure, t_1, false))?;

        // u₁ = u₀ + Δt v₀ + δ, v₁ = v₀ + 2δ/Δt.
        state.v.axpy(2.0 / *dt, &workspace.increment.du, 1.0);
        state.u.copy_from(&workspace.predicted_u);
        state.u += &workspace.increment.du;
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}
