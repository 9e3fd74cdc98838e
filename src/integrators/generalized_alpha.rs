//! Generalized-α (Chung and Hulbert 1993), with forces weighted between the ends of the step.
//!
//! M \[(1 − α_m) a₁ + α_m a₀\] + (1 − α_f)(Q_e − Q_w)₁ + α_f (Q_e − Q_w)₀ = 0 with Newmark's u₁ and v₁:
//!
//! u₁ = u₀ + Δt v₀ + Δt² \[(½ − β) a₀ + β a₁\],  v₁ = v₀ + Δt \[(1 − γ) a₀ + γ a₁\],
//!
//! α_m = (2ρ∞ − 1)/(ρ∞ + 1), α_f = ρ∞/(ρ∞ + 1), γ = ½ − α_m + α_f, β = ¼(1 − α_m + α_f)²: of second order, and waves that
//! a step does not resolve lose the fraction 1 − ρ∞ of their amplitude a step.

use nalgebra::DVector;

use super::{Integrator, State, acceleration, mass_factors};
use crate::counts::Counts;
use crate::error::Result;
use crate::newton::{self, Equation, Residual, Step};
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
    /// (Q_e − Q_w)₀ at the start of the step.
    load: DVector<f64>,
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
        let a = acceleration(structure, &mass, &state.u, state.t, counts);
        Ok(GeneralizedAlpha {
            step,
            tolerance,
            alpha_m,
            alpha_f,
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
            gamma: 0.5 - alpha_m + alpha_f,
            load: -structure.mass().mul(&a),
            a,
        })
    }
}

impl Integrator for GeneralizedAlpha {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let GeneralizedAlpha { step: dt, alpha_m, alpha_f, beta, gamma, .. } = *self;
        let (u_0, v_0, a_0, load_0) = (&state.u, &state.v, &self.a, &self.load);
        let thermal = structure.thermal_strain(t_1);
        let mass = structure.mass();

        // The unknown is the increment du, and a₁ follows from it.
        let a_1 = |du: &DVector<f64>| (du - v_0 * dt) / (beta * dt * dt) - a_0 * (0.5 / beta - 1.0);
        let load_1 = |du: &DVector<f64>| {
            let mut load = DVector::zeros(structure.size());
            structure.force(&(u_0 + du), thermal, &mut load);
            load - structure.gravity()
        };
        let residual = |du: &DVector<f64>| {
            let inertia = mass.mul(&(a_1(du) * (1.0 - alpha_m) + a_0 * alpha_m));
            let load = load_1(du);
            let terms = [&inertia, &load, load_0, structure.gravity()];
            let largest_term = terms.map(|term| structure.largest(term)).into_iter().fold(0.0, f64::max);
            Residual { value: inertia + load * (1.0 - alpha_f) + load_0 * alpha_f, largest_term }
        };
        let tangent = |du: &DVector<f64>| {
            let mut matrix = structure.tangent(&(u_0 + du), thermal);
            matrix.scale(1.0 - alpha_f);
            matrix.add_scaled((1.0 - alpha_m) / (beta * dt * dt), mass);
            matrix
        };
        let mut du = v_0 * dt;
        newton::solve(structure, self.tolerance, Step { u_0, t_1 }, Equation { residual, tangent }, &mut du, counts)?;

        let a_1 = a_1(&du);
        state.v += a_0 * (dt * (1.0 - gamma)) + &a_1 * (dt * gamma);
        let load_1 = load_1(&du);
        state.u += du;
        (self.a, self.load) = (a_1, load_1);
        Ok(())
    }
}
