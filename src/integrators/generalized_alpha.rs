//! Generalized-α (Chung and Hulbert 1993), with forces weighted between the ends of the step.
//!
//! M \[(1 − α_m) a₁ + α_m a₀\] + (1 − α_f)(Q_e + Φ_qᵀ λ − f)₁ + α_f (Q_e + Φ_qᵀ λ − f)₀ = 0,  Φ_q (u₁ − u₀) = 0,
//! with Newmark's u₁ and v₁:
//!
//! u₁ = u₀ + Δt v₀ + Δt² \[(½ − β) a₀ + β a₁\],  v₁ = v₀ + Δt \[(1 − γ) a₀ + γ a₁\],
//!
//! α_m = (2ρ∞ − 1)/(ρ∞ + 1), α_f = ρ∞/(ρ∞ + 1), γ = ½ − α_m + α_f, β = ¼(1 − α_m + α_f)²: of second order, and waves that
//! a step does not resolve lose the fraction 1 − ρ∞ of their amplitude a step. Before they do they overshoot: an acceleration
//! that a sudden load gives to a wave of angular frequency ω moves the first step by (ωΔt)² times what is right.
//!
//! **Multipliers**, if there are any, make (23) a differential-algebraic equation of index 3, for which this is the scheme of
//! Arnold and Brüls (2007): the forces' weighted mean takes the place of their auxiliary acceleration. It starts from a₀ and
//! λ₀ that fulfil (23) and Φ_q a₀ = 0. Constraints here are linear in q, so that Φ_q v and Φ_q a vanish as well, step by step.
//! What usually spoils λ at small steps is that a rounding error of the positions in Φ(q₁) = 0 becomes a force M ε/Δt²; here
//! the constraint is one of the increment, Φ_q (u₁ − u₀) = 0, whose rounding error shrinks with the step.

use nalgebra::DVector;

use super::{Integrator, State, acceleration, mass_factors};
use crate::counts::Counts;
use crate::error::Result;
use crate::linear::BorderedLu;
use crate::newton::{self, Equation, Iterate, Residual, Step};
use crate::structure::Structure;

/// The method with its parameters and the acceleration that it carries along.
#[derive(Clone, Debug)]
pub struct GeneralizedAlpha {
    step: f64,
    tolerance: f64,
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
    /// a₀ at the start of the step.
    a: DVector<f64>,
    /// λ₀ at the start of the step, in their places.
    multipliers: DVector<f64>,
    /// (Q_e + Φ_qᵀ λ − f)₀ at the start of the step.
    unbalanced: DVector<f64>,
    factors: Option<BorderedLu>,
}

impl GeneralizedAlpha {
    /// A method with step `step` (s) and spectral radius `rho_inf`, starting from the acceleration of the equation of
    /// motion at `state`.
    ///
    /// # Errors
    /// [`Error::Singular`](crate::error::Error::Singular) for a singular mass matrix.
    pub fn new(
        structure: &Structure,
        state: &State,
        step: f64,
        rho_inf: f64,
        tolerance: f64,
        counts: &mut Counts,
    ) -> Result<GeneralizedAlpha> {
        let alpha_m = (2.0 * rho_inf - 1.0) / (rho_inf + 1.0);
        let alpha_f = rho_inf / (rho_inf + 1.0);
        let mass = mass_factors(structure, counts)?;
        let mut a = acceleration(structure, &mass, &state.u, state.t, counts);
        let multipliers = structure.take_multipliers(&mut a);
        Ok(GeneralizedAlpha {
            step,
            tolerance,
            alpha_m,
            alpha_f,
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
            gamma: 0.5 - alpha_m + alpha_f,
            unbalanced: -structure.inertia(&a),
            a,
            multipliers,
            factors: None,
        })
    }
}

impl Integrator for GeneralizedAlpha {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let GeneralizedAlpha { step: dt, alpha_m, alpha_f, beta, gamma, .. } = *self;
        let (u_0, v_0, a_0, unbalanced_0) = (&state.u, &state.v, &self.a, &self.unbalanced);
        let thermal = structure.thermal_strains(t_1);
        let load = structure.load(t_1);

        // The unknowns are the increment du and, in their places, λ₁; a₁ follows from du.
        let a_1 = |du: &DVector<f64>| (du - v_0 * dt) / (beta * dt * dt) - a_0 * (0.5 / beta - 1.0);
        let elastic = |du: &DVector<f64>| {
            let mut force = DVector::zeros(structure.size());
            structure.force(&(u_0 + du), &thermal, &mut force);
            structure.add_constraint_forces(du, &mut force);
            force
        };
        let residual = |du: &DVector<f64>| {
            let inertia = structure.inertia(&(a_1(du) * (1.0 - alpha_m) + a_0 * alpha_m));
            let elastic = elastic(du);
            let terms = [&inertia, &elastic, unbalanced_0, &load];
            let largest_term = terms.map(|term| structure.largest(term)).into_iter().fold(0.0, f64::max);
            let mut value = inertia + (elastic - &load) * (1.0 - alpha_f) + unbalanced_0 * alpha_f;
            structure.set_constraint_rows(du, &mut value);
            Residual { value, largest_term }
        };
        let weights = [1.0 - alpha_f, (1.0 - alpha_m) / (beta * dt * dt)];
        let tangent = |du: &DVector<f64>, old| structure.tangent_factors(&(u_0 + du), &thermal, weights, old);
        let mut du = v_0 * dt + &self.multipliers;
        newton::solve(
            structure,
            self.tolerance,
            Step { u_0, t_1 },
            Equation { residual, tangent },
            Iterate { du: &mut du, factors: &mut self.factors },
            counts,
        )?;

        let unbalanced = elastic(&du) - &load;
        let multipliers = structure.take_multipliers(&mut du);
        let a_1 = a_1(&du);
        state.v += a_0 * (dt * (1.0 - gamma)) + &a_1 * (dt * gamma);
        state.u += du;
        (self.a, self.multipliers, self.unbalanced) = (a_1, multipliers, unbalanced);
        Ok(())
    }

    fn multipliers(&self) -> Option<&DVector<f64>> {
        Some(&self.multipliers)
    }
}
