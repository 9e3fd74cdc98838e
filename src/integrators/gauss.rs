//! Gauss collocation with two stages: implicit, fourth order, symmetric and symplectic. Every wave keeps its energy,
//! resolved or not.
//!
//! The equation of motion holds at the stages c = ½ ∓ √3/6 for the polynomial that interpolates their accelerations:
//!
//! M aᵢ + Q_e(u₀ + zᵢ) = fᵢ,  zᵢ = cᵢ Δt v₀ + Δt² Σ (A²)ᵢⱼ aⱼ,
//!
//! u₁ = u₀ + Δt v₀ + Δt² Σ bᵢ(1 − cᵢ) aᵢ,  v₁ = v₀ + Δt Σ bᵢ aᵢ,  b = (½, ½). The unknowns are the increments z, with a
//! = A⁻²(z − c Δt v₀)/Δt².
//!
//! Newton's iteration uses one tangent K for both stages. A has the eigenvalues λ = ¼ + i√3/12 and its conjugate. Both
//! stages together are therefore one complex system of the structure's size, M + Δt²λ² K (Butcher 1976).
//!
//! **Error estimate**, of order 3: the acceleration at the start of the step minus the stages' polynomial there, as a
//! force r on the left of that system: Δt²/12 · Re (M + Δt²λ² K)⁻¹ r. The system filters what stiff waves would make of
//! it.

use nalgebra::{Complex, DVector};

use super::adaptive::Embedded;
use super::counts::Counts;
use super::increment::step_failed;
use super::integrator::{Integrator, check_end};
use super::newton::{Equations, Newton, Residual};
use super::state::State;
use super::work::{POINTS as C, ROOT_3, Work};
use crate::elements::ThermalStrain;
use crate::error::Result;
use crate::linear::{CondensedFactors, SingularAt};
use crate::structure::Structure;

/// Matrix A by rows: stage velocities are v₀ + Δt Σ Aᵢⱼ aⱼ.
const A: [[f64; 2]; 2] = [[0.25, 0.25 - ROOT_3 / 6.0], [0.25 + ROOT_3 / 6.0, 0.25]];

/// Matrix A⁻² by rows.
const INVERSE: [[f64; 2]; 2] = [[6.0, 6.0 * (2.0 * ROOT_3 - 3.0)], [-6.0 * (2.0 * ROOT_3 + 3.0), 6.0]];

/// Largest row sum of |A⁻²| c.
const INVERSE_SIZE: f64 = 13.0;

/// Eigenvalue λ of A.
const EIGENVALUE: Complex<f64> = Complex::new(0.25, ROOT_3 / 12.0);

/// Right eigenvector of A for λ; below, the left one divided by their product.
const RIGHT: [Complex<f64>; 2] = [Complex::new(0.25 - ROOT_3 / 6.0, 0.0), Complex::new(0.0, ROOT_3 / 12.0)];
const LEFT: [Complex<f64>; 2] = [Complex::new(-6.0 - 4.0 * ROOT_3, 0.0), Complex::new(0.0, -2.0 * ROOT_3)];

/// Gauss method with its step.
#[derive(Debug)]
pub struct Gauss {
    step: f64,
    newton: Newton,
    /// Step for which the last matrix was made, s.
    matrix_step: f64,
    workspace: Workspace,
}

/// Buffers of a step; pairs belong to the two stages.
#[derive(Debug)]
struct Workspace {
    /// Unknown increments z.
    z: [DVector<f64>; 2],
    /// Stage displacements u₀ + z; below, their mean.
    u: [DVector<f64>; 2],
    middle: DVector<f64>,
    /// Last improvement of z.
    improvement: [DVector<f64>; 2],
    /// Residuals.
    residual: [DVector<f64>; 2],
    a: [DVector<f64>; 2],
    /// Acceleration of the last stage of the step before, to restore after a failed attempt.
    a_before: DVector<f64>,
    elastic: DVector<f64>,
    load: [DVector<f64>; 2],
    thermal: [Vec<ThermalStrain>; 2],
    complex: DVector<Complex<f64>>,
    factors: CondensedFactors<Complex<f64>>,
    work: Work,
}

impl Gauss {
    /// Method with step `step` (s).
    pub fn new(structure: &Structure, step: f64, newton: Newton) -> Gauss {
        let zeros = || DVector::zeros(structure.size());
        let pair = || [zeros(), zeros()];
        let thermal = || structure.thermal_strains(0.0);
        let workspace = Workspace {
            z: pair(),
            u: pair(),
            middle: zeros(),
            improvement: pair(),
            residual: pair(),
            a: pair(),
            a_before: zeros(),
            elastic: zeros(),
            load: pair(),
            thermal: [thermal(), thermal()],
            complex: DVector::zeros(structure.size()),
            factors: structure.complex_factors(),
            work: Work::new(structure),
        };
        Gauss { step, newton, matrix_step: step, workspace }
    }
}

/// Equations of one step.
struct StepEquations<'a> {
    structure: &'a Structure,
    dt: f64,
    state: &'a State,
    workspace: &'a mut Workspace,
    largest_load: f64,
    /// Rounding error of the inertia force, N: it is a difference of z and c Δt v₀, divided by Δt².
    inertia_rounding: f64,
}

impl Equations for StepEquations<'_> {
    fn residual(&mut self, counts: &mut Counts) -> Residual {
        let StepEquations { structure, dt, state, largest_load, .. } = *self;
        let Workspace { z, u, residual, a, elastic, load, thermal, .. } = &mut *self.workspace;
        let (mut size, mut largest_term): (f64, f64) = (0.0, largest_load);
        for stage in 0..2 {
            u[stage].copy_from(&state.u);
            u[stage] += &z[stage];
            let a = &mut a[stage];
            a.fill(0.0);
            for other in 0..2 {
                let weight = INVERSE[stage][other] / (dt * dt);
                a.axpy(weight, &z[other], 1.0);
                a.axpy(-weight * C[other] * dt, &state.v, 1.0);
            }
            structure.force(&u[stage], &thermal[stage], elastic);
            structure.inertia_into(a, &mut residual[stage]);
            let terms = structure.largest_force(&residual[stage]).max(structure.largest_force(elastic));
            residual[stage] += &*elastic;
            residual[stage] -= &load[stage];
            // A maximum would drop a NaN; the sum of both magnitudes serves as well.
            size += structure.largest_force(&residual[stage]);
            largest_term = largest_term.max(terms);
        }
        counts.force_calls += 2;
        Residual { size, largest_term }
    }

    fn at_rounding(&self, times: f64) -> bool {
        let Workspace { u, residual, thermal, .. } = &*self.workspace;
        let (structure, floor) = (self.structure, times * self.inertia_rounding);
        (0..2).all(|stage| {
            structure.largest_force(&residual[stage]) <= floor
                || structure.within_rounding(&residual[stage], &u[stage], &thermal[stage], times)
        })
    }

    fn factorize(&mut self) -> std::result::Result<(), SingularAt> {
        let Workspace { u: [first, second], middle, thermal, factors, .. } = &mut *self.workspace;
        middle.copy_from(first);
        *middle += &*second;
        *middle *= 0.5;
        let stiffness = EIGENVALUE * EIGENVALUE * (self.dt * self.dt);
        self.structure.factorize_complex(middle, &thermal[1], stiffness, factors)
    }

    fn improve(&mut self) {
        let Workspace { z, improvement, residual: [first, second], complex, factors, .. } = &mut *self.workspace;
        for ((w, first), second) in complex.iter_mut().zip(&*first).zip(&*second) {
            *w = LEFT[0] * *first + LEFT[1] * *second;
        }
        factors.solve(complex);
        let factor = EIGENVALUE * EIGENVALUE * (2.0 * self.dt * self.dt);
        for ((z, improvement), right) in z.iter_mut().zip(improvement).zip(RIGHT) {
            for (entry, w) in improvement.iter_mut().zip(&*complex) {
                *entry = (right * factor * w).re;
            }
            *z -= &*improvement;
        }
    }

    fn undo(&mut self) {
        let Workspace { z, improvement, .. } = &mut *self.workspace;
        z.iter_mut().zip(improvement).for_each(|(z, improvement)| *z += &*improvement);
    }
}

impl Embedded for Gauss {
    const ORDER: u8 = 3;

    fn make(&mut self, structure: &Structure, state: &mut State, dt: f64, t_1: f64, counts: &mut Counts) -> Result<()> {
        let Gauss { newton, matrix_step, workspace, .. } = self;
        // Equal steps between two times differ by rounding.
        if (dt - *matrix_step).abs() > 1e-9 * dt {
            newton.forget();
            *matrix_step = dt;
        }
        workspace.a_before.copy_from(&workspace.a[1]);
        for (stage, c) in C.into_iter().enumerate() {
            let t = t_1 - (1.0 - c) * dt;
            structure.thermal_strains_into(t, &mut workspace.thermal[stage]);
            structure.load_into(t, &mut workspace.load[stage]);
            // Initial guess c Δt v₀ + ½ (c Δt)² a, with the acceleration of the last stage before.
            let z = &mut workspace.z[stage];
            z.copy_from(&workspace.a[1]);
            z.axpy(c * dt, &state.v, 0.5 * (c * dt).powi(2));
        }
        let largest_load = structure.largest_force(&workspace.load[0]).max(structure.largest_force(&workspace.load[1]));
        structure.inertia_into(&state.v, &mut workspace.elastic);
        let inertia_rounding = f64::EPSILON * INVERSE_SIZE * structure.largest_force(&workspace.elastic) / dt;
        let mut step = StepEquations { structure, dt, state, workspace, largest_load, inertia_rounding };
        newton.solve(&mut step, counts).map_err(|failure| step_failed(failure, structure, t_1, true))?;

        state.u.axpy(dt, &state.v, 1.0);
        for (stage, a) in workspace.a.iter().enumerate() {
            state.u.axpy(0.5 * (1.0 - C[stage]) * dt * dt, a, 1.0);
            state.v.axpy(0.5 * dt, a, 1.0);
        }
        state.advance(t_1);
        Ok(())
    }

    fn error(&mut self, structure: &Structure, before: &State, _: &State, dt: f64, counts: &mut Counts) -> f64 {
        let Workspace {
            middle,
            residual: [force, start],
            a: [first, second],
            elastic,
            load,
            thermal,
            complex,
            factors,
            ..
        } = &mut self.workspace;
        structure.thermal_strains_into(before.t, &mut thermal[0]);
        structure.force(&before.u, &thermal[0], elastic);
        structure.load_into(before.t, &mut load[0]);
        // The stages' polynomial at the start of the step.
        start.copy_from(first);
        start.axpy(0.5 * (1.0 - ROOT_3), second, 0.5 * (1.0 + ROOT_3));
        structure.inertia_into(start, force);
        for (r, ((load, elastic), inertia)) in complex.iter_mut().zip(load[0].iter().zip(&*elastic).zip(&*force)) {
            *r = Complex::new(load - elastic - inertia, 0.0);
        }
        // If the guess was the solution, as for a structure at rest, there was no iteration and there is no matrix.
        if !self.newton.has_matrix() {
            let stiffness = EIGENVALUE * EIGENVALUE * (dt * dt);
            if structure.factorize_complex(&before.u, &thermal[0], stiffness, factors).is_err() {
                return f64::INFINITY;
            }
            self.newton.remember();
            counts.tangent_calls += 1;
            counts.factorizations += 1;
        }
        factors.solve(complex);
        counts.force_calls += 1;
        counts.solves += 1;
        for (error, r) in middle.iter_mut().zip(&*complex) {
            *error = dt * dt / 12.0 * r.re;
        }
        structure.largest_displacement(middle)
    }

    fn undo(&mut self) {
        let Workspace { a: [_, last], a_before, .. } = &mut self.workspace;
        last.copy_from(a_before);
    }

    /// Work by the quadrature rule whose points are the stages. Where forces are linear in the displacement it is
    /// exactly the energy change of the method's step, resolved or not.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> f64 {
        let dt = after.t - before.t;
        let Workspace { u, residual: velocities, a, work, .. } = &mut self.workspace;
        for (v, weights) in velocities.iter_mut().zip(A) {
            v.copy_from(&before.v);
            a.iter().zip(weights).for_each(|(a, weight)| v.axpy(weight * dt, a, 1.0));
        }
        work.over_step(structure, dt, after.t, u, velocities)
    }
}

impl Integrator for Gauss {
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> Option<f64> {
        Some(Embedded::work(self, structure, before, after))
    }

    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        check_end(state.t, self.step, t_1)?;
        self.make(structure, state, self.step, t_1, counts)?;
        counts.steps += 1;
        Ok(())
    }
}
