//! Generalized-α (Chung and Hulbert 1993), with forces weighted between the ends of the step.
//!
//! M \[(1 − α_m) a₁ + α_m a₀\] + (1 − α_f)(Q_e + Φ_qᵀ λ − f)₁ + α_f (Q_e + Φ_qᵀ λ − f)₀ = 0,  Φ_q (u₁ − u₀) = 0,
//! with Newmark's u₁ and v₁:
//!
//! u₁ = u₀ + Δt v₀ + Δt² \[(½ − β) a₀ + β a₁\],  v₁ = v₀ + Δt \[(1 − γ) a₀ + γ a₁\],
//!
//! α_m = (2ρ∞ − 1)/(ρ∞ + 1), α_f = ρ∞/(ρ∞ + 1), γ = ½ − α_m + α_f, β = ¼(1 − α_m + α_f)²: second order. Waves that a
//! step does not resolve lose the fraction 1 − ρ∞ of their amplitude per step. Before that they overshoot: if a sudden
//! load accelerates a wave of angular frequency ω, the first step moves it (ωΔt)² times too far.
//!
//! **Multipliers**, if there are any, make (23) a differential-algebraic equation of index 3; this is then the scheme
//! of Arnold and Brüls (2007), with the forces' weighted mean in place of their auxiliary acceleration. It starts from
//! a₀ and λ₀ that fulfil (23) and Φ_q a₀ = 0. Constraints here are linear in q, so that Φ_q v and Φ_q a vanish as well
//! in every step. Usually λ degrades at small steps, since a rounding error ε of the positions in Φ(q₁) = 0 becomes a
//! force M ε/Δt². Here the constraint acts on the increment, Φ_q (u₁ − u₀) = 0, whose rounding error shrinks with the
//! step.

use nalgebra::DVector;

use super::counts::Counts;
use super::equation_of_motion::EquationOfMotion;
use super::increment::{Increment, step_failed};
use super::integrator::{Integrator, check_end};
use super::newton::{Equations, Newton, Residual};
use super::state::State;
use crate::elements::ThermalStrain;
use crate::error::Result;
use crate::linear::SingularAt;
use crate::structure::{Matrix, Structure};

/// Generalized-α method with its parameters and the last acceleration.
#[derive(Debug)]
pub struct GeneralizedAlpha {
    weights: Weights,
    newton: Newton,
    /// Acceleration a₀ at the start of the step.
    a: DVector<f64>,
    /// Multipliers λ₀ at the start of the step, in their entries.
    multipliers: DVector<f64>,
    workspace: Workspace,
}

/// Step, and weights of its two ends.
#[derive(Clone, Copy, Debug)]
struct Weights {
    step: f64,
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
}

/// Buffers of a step.
#[derive(Debug)]
struct Workspace {
    /// Unknowns: δ, the increment of u beyond Δt v₀, and λ₁ in its entries.
    increment: Increment,
    /// Predicted displacement u₀ + Δt v₀.
    predicted_u: DVector<f64>,
    /// Weighted acceleration (1 − α_m) a₁ + α_m a₀.
    a: DVector<f64>,
    /// Elastic and constraint forces (Q_e + Φ_qᵀ λ)₁ at the end of the step.
    elastic: DVector<f64>,
    /// Unbalanced force (Q_e + Φ_qᵀ λ − f)₀ at the start of the step.
    unbalanced: DVector<f64>,
    /// External force f₁ at the end of the step.
    load: DVector<f64>,
    thermal: Vec<ThermalStrain>,
}

impl GeneralizedAlpha {
    /// Method with step `step` (s) and spectral radius `rho_inf`. It starts from the acceleration of the equation of
    /// motion at `state`.
    ///
    /// # Errors
    /// [`Error::Singular`](crate::error::Error::Singular) for a singular mass matrix.
    pub fn new(
        structure: &Structure,
        state: &State,
        step: f64,
        rho_inf: f64,
        newton: Newton,
        counts: &mut Counts,
    ) -> Result<GeneralizedAlpha> {
        let alpha_m = (2.0 * rho_inf - 1.0) / (rho_inf + 1.0);
        let alpha_f = rho_inf / (rho_inf + 1.0);
        let (beta, gamma) = (0.25 * (1.0 - alpha_m + alpha_f).powi(2), 0.5 - alpha_m + alpha_f);
        let mut motion = EquationOfMotion::new(structure, counts)?;
        motion.accelerate(structure, &state.u, state.t, counts);
        let mut a = motion.a;
        let multipliers = structure.take_multipliers(&mut a);
        let zeros = || DVector::zeros(structure.size());
        let workspace = Workspace {
            increment: Increment::new(structure),
            predicted_u: zeros(),
            a: zeros(),
            elastic: zeros(),
            unbalanced: -structure.inertia(&a),
            load: zeros(),
            thermal: structure.thermal_strains(state.t),
        };
        let weights = Weights { step, alpha_m, alpha_f, beta, gamma };
        Ok(GeneralizedAlpha { weights, newton, a, multipliers, workspace })
    }
}

/// Equations of one step.
struct StepEquations<'a> {
    structure: &'a Structure,
    weights: Weights,
    state: &'a State,
    a_0: &'a DVector<f64>,
    workspace: &'a mut Workspace,
    /// Largest of the terms that are constant in the step.
    largest_given: f64,
}

impl Equations for StepEquations<'_> {
    fn residual(&mut self, counts: &mut Counts) -> Residual {
        let Weights { step: dt, alpha_m, alpha_f, beta, .. } = self.weights;
        let Workspace { increment, predicted_u, a, elastic, unbalanced, load, thermal } = &mut *self.workspace;
        increment.move_from(predicted_u);
        let Increment { du, u, residual, .. } = increment;
        self.structure.force(u, thermal, elastic);
        counts.force_calls += 1;
        self.structure.add_constraint_forces(du, elastic);
        // a₁ = δ/(βΔt²) − (1/(2β) − 1) a₀: not a difference of the whole increment and Δt v₀.
        let from_du = (1.0 - alpha_m) / (beta * dt * dt);
        a.copy_from(du);
        a.axpy(alpha_m - (1.0 - alpha_m) * (0.5 / beta - 1.0), self.a_0, from_du);
        self.structure.inertia_into(a, residual);
        let largest_term =
            self.structure.largest_force(residual).max(self.structure.largest_force(elastic)).max(self.largest_given);
        residual.axpy(1.0 - alpha_f, elastic, 1.0);
        residual.axpy(alpha_f - 1.0, load, 1.0);
        residual.axpy(alpha_f, unbalanced, 1.0);
        a.copy_from(du);
        a.axpy(dt, &self.state.v, 1.0);
        self.structure.set_constraint_rows(a, residual);
        Residual { size: self.structure.largest_force(residual), largest_term }
    }

    fn at_rounding(&self, times: f64) -> bool {
        let Workspace { increment, predicted_u, thermal, .. } = &*self.workspace;
        // u may be a small sum of large terms, as when a vibration passes its middle.
        let within = |u| self.structure.within_rounding(&increment.residual, u, thermal, times);
        within(&increment.u) || within(predicted_u) || within(&self.state.u)
    }

    fn factorize(&mut self) -> std::result::Result<(), SingularAt> {
        let Weights { step: dt, alpha_m, alpha_f, beta, .. } = self.weights;
        let Workspace { increment: Increment { u, factors, .. }, thermal, .. } = &mut *self.workspace;
        let (stiffness, mass) = (1.0 - alpha_f, (1.0 - alpha_m) / (beta * dt * dt));
        self.structure.factorize(Matrix::Tangent { u, thermal, stiffness, mass }, factors)
    }

    fn improve(&mut self) {
        self.workspace.increment.improve();
    }

    fn undo(&mut self) {
        self.workspace.increment.undo();
    }
}

impl Integrator for GeneralizedAlpha {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let Weights { step: dt, beta, gamma, .. } = self.weights;
        check_end(state.t, dt, t_1)?;
        let GeneralizedAlpha { newton, a: a_0, multipliers, workspace, weights } = self;
        structure.thermal_strains_into(t_1, &mut workspace.thermal);
        structure.load_into(t_1, &mut workspace.load);
        workspace.increment.du.copy_from(multipliers);
        workspace.increment.du.axpy(0.5 * dt * dt, a_0, 1.0);
        workspace.predicted_u.copy_from(&state.u);
        workspace.predicted_u.axpy(dt, &state.v, 1.0);
        let largest_given =
            structure.largest_force(&workspace.unbalanced).max(structure.largest_force(&workspace.load));
        let mut step = StepEquations { structure, weights: *weights, state, a_0, workspace, largest_given };
        newton.solve(&mut step, counts).map_err(|failure| step_failed(failure, structure, t_1, false))?;

        // The last residual's forces are those of the solution.
        workspace.unbalanced.copy_from(&workspace.elastic);
        workspace.unbalanced -= &workspace.load;
        structure.take_multipliers_into(&mut workspace.increment.du, multipliers);
        // v₁ = v₀ + Δt [(1 − γ) a₀ + γ a₁], a₁ as above.
        let delta = &workspace.increment.du;
        state.v.axpy(dt * (1.0 - gamma), a_0, 1.0);
        *a_0 *= 1.0 - 0.5 / beta;
        a_0.axpy(1.0 / (beta * dt * dt), delta, 1.0);
        state.v.axpy(dt * gamma, a_0, 1.0);
        state.u.copy_from(&workspace.predicted_u);
        state.u += delta;
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }

    fn multipliers(&self) -> Option<&DVector<f64>> {
        Some(&self.multipliers)
    }
}
