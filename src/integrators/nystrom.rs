//! Explicit Runge–Kutta–Nyström method RKN4(3)4FM of Dormand, El-Mikkawy and Prince (1987): fourth order, with an
//! embedded third-order solution for an error estimate.
//!
//! aᵢ = M⁻¹(Q_w − Q_e(u₀ + cᵢ Δt v₀ + Δt² Σ αᵢⱼ aⱼ)),  u₁ = u₀ + Δt v₀ + Δt² Σ bᵢ aᵢ,  v₁ = v₀ + Δt Σ b'ᵢ aᵢ. The last
//! stage is the end of the step and the first stage of the next, so that a step costs three force evaluations. It is
//! stable up to Δt ω = 3.7678 for the largest angular frequency ω, and damps: a vibration loses 3·10⁻⁴ of its amplitude
//! per step at Δt ω = 1, and 2 % at 2.

use nalgebra::DVector;

use super::adaptive::Embedded;
use super::counts::Counts;
use super::equation_of_motion::EquationOfMotion;
use super::equation_of_motion::check_step;
use super::integrator::{Integrator, check_end};
use super::state::State;
use super::work::{POINTS, Work};
use crate::error::{Error, Result};
use crate::structure::Structure;

/// Stability limit: largest Δt ω at which no vibration grows.
const LIMIT: f64 = 3.7678;

const STAGES: usize = 4;
const C: [f64; STAGES] = [0.0, 1.0 / 4.0, 7.0 / 10.0, 1.0];
const ALPHA: [[f64; 3]; STAGES] = [
    [0.0; 3],
    [1.0 / 32.0, 0.0, 0.0],
    [7.0 / 1000.0, 119.0 / 500.0, 0.0],
    // The weights of u₁.
    [1.0 / 14.0, 8.0 / 27.0, 25.0 / 189.0],
];
const B_RATE: [f64; STAGES] = [1.0 / 14.0, 32.0 / 81.0, 250.0 / 567.0, 5.0 / 54.0];
/// Weights of the third-order solution for u₁.
const B_LOW: [f64; STAGES] = [-7.0 / 150.0, 67.0 / 150.0, 3.0 / 20.0, -1.0 / 20.0];

/// Runge–Kutta–Nyström method with its step and stage accelerations.
#[derive(Debug)]
pub struct Nystrom {
    step: f64,
    motion: EquationOfMotion,
    /// Accelerations of the stages; the first belongs to the start of the step.
    a: [DVector<f64>; STAGES],
    u: DVector<f64>,
    error: DVector<f64>,
    /// Displacements and velocities at the quadrature points of the work.
    between: [[DVector<f64>; 2]; 2],
    work: Work,
}

impl Nystrom {
    /// Method with step `step` (s), starting at `state`.
    ///
    /// # Errors
    /// [`Error::StepTooLarge`] above the stability limit of the initial largest frequency (an upper bound, see
    /// [`Structure::largest_frequency`]); [`Error::Singular`] for a singular mass matrix.
    pub fn new(structure: &Structure, state: &State, step: f64, counts: &mut Counts) -> Result<Nystrom> {
        check_step(structure, "nystrom", step, LIMIT)?;
        Nystrom::unchecked(structure, state, step, counts)
    }

    /// Method without a check of stability, for adaptive steps: the estimated error grows where it is unstable.
    ///
    /// # Errors
    /// [`Error::Singular`] for a singular mass matrix.
    pub fn unchecked(structure: &Structure, state: &State, step: f64, counts: &mut Counts) -> Result<Nystrom> {
        let mut motion = EquationOfMotion::new(structure, counts)?;
        motion.accelerate(structure, &state.u, state.t, counts);
        let zeros = || DVector::zeros(structure.size());
        let mut a: [DVector<f64>; STAGES] = std::array::from_fn(|_| zeros());
        a[STAGES - 1].copy_from(&motion.a);
        let between = [[zeros(), zeros()], [zeros(), zeros()]];
        Ok(Nystrom { step, motion, a, u: zeros(), error: zeros(), between, work: Work::new(structure) })
    }
}

impl Embedded for Nystrom {
    const ORDER: u8 = 3;

    fn make(&mut self, structure: &Structure, state: &mut State, dt: f64, t_1: f64, counts: &mut Counts) -> Result<()> {
        let Nystrom { motion, a, u, .. } = self;
        // The last stage of the step before is the first of this one.
        a.swap(0, STAGES - 1);
        for stage in 1..STAGES {
            u.copy_from(&state.u);
            u.axpy(C[stage] * dt, &state.v, 1.0);
            for (alpha, a) in ALPHA[stage].iter().zip(&a[..stage]) {
                u.axpy(alpha * dt * dt, a, 1.0);
            }
            motion.accelerate(structure, u, t_1 - (1.0 - C[stage]) * dt, counts);
            a[stage].copy_from(&motion.a);
        }
        state.u.copy_from(u);
        for (weight, a) in B_RATE.iter().zip(&*a) {
            state.v.axpy(weight * dt, a, 1.0);
        }
        // A sum drops no NaN.
        if !a[STAGES - 1].sum().is_finite() {
            return Err(Error::NotFinite { quantity: "the acceleration", time: t_1, step: state.step + 1 });
        }
        state.advance(t_1);
        Ok(())
    }

    fn error(&mut self, structure: &Structure, _: &State, _: &State, dt: f64, _: &mut Counts) -> f64 {
        self.error.fill(0.0);
        for (stage, a) in self.a.iter().enumerate() {
            let high = ALPHA[STAGES - 1].get(stage).unwrap_or(&0.0);
            self.error.axpy((high - B_LOW[stage]) * dt * dt, a, 1.0);
        }
        structure.largest_displacement(&self.error)
    }

    fn undo(&mut self) {
        self.a.swap(0, STAGES - 1);
    }

    /// Work along the cubic through both ends of the step, with their velocities.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> f64 {
        let dt = after.t - before.t;
        let [displacements, velocities] = &mut self.between;
        for ((u, v), s) in displacements.iter_mut().zip(&mut *velocities).zip(POINTS) {
            let r = 1.0 - s;
            u.copy_from(&before.u);
            u.axpy(s * s * (3.0 - 2.0 * s), &after.u, r * r * (3.0 - 2.0 * r));
            u.axpy(dt * s * r * r, &before.v, 1.0);
            u.axpy(-dt * r * s * s, &after.v, 1.0);
            v.copy_from(&after.u);
            v.axpy(-6.0 * s * r / dt, &before.u, 6.0 * s * r / dt);
            v.axpy(r * (1.0 - 3.0 * s), &before.v, 1.0);
            v.axpy(s * (1.0 - 3.0 * r), &after.v, 1.0);
        }
        self.work.over_step(structure, dt, after.t, displacements, velocities)
    }
}

impl Integrator for Nystrom {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest factor by which a step changes the amplitude of a vibration with Δt ω = `z`: spectral radius of the map
    /// of (u, Δt v) over a step.
    fn amplification(z: f64) -> f64 {
        let column = |u: f64, v: f64| {
            let mut a = [0.0; STAGES];
            for stage in 0..STAGES {
                let known: f64 = ALPHA[stage].iter().zip(&a[..stage]).map(|(alpha, a)| alpha * a).sum();
                a[stage] = -z * z * (u + C[stage] * v + known);
            }
            let weighted = |weights: &[f64]| weights.iter().zip(&a).map(|(b, a)| b * a).sum::<f64>();
            (u + v + weighted(&ALPHA[STAGES - 1]), v + weighted(&B_RATE))
        };
        let ((a, c), (b, d)) = (column(1.0, 0.0), column(0.0, 1.0));
        let (mean, determinant) = (0.5 * (a + d), a * d - b * c);
        let root = mean * mean - determinant;
        if root < 0.0 { determinant.sqrt() } else { mean.abs() + root.sqrt() }
    }

    /// Stability and damping are as documented above.
    #[test]
    fn vibrations_do_not_grow_up_to_the_limit_and_grow_beyond() {
        for n in 1..=1000 {
            let z = LIMIT * f64::from(n) / 1000.0;
            assert!(amplification(z) <= 1.0, "{z}: {}", amplification(z));
        }
        assert!(amplification(LIMIT + 1e-4) > 1.0);
        let losses = [1.0, 2.0].map(|z| 1.0 - amplification(z));
        assert!((losses[0] - 3e-4).abs() < 5e-5 && (losses[1] - 0.02).abs() < 2e-3, "{losses:?}");
    }

    /// Σ bᵢ cᵢᵏ = 1/((k + 1)(k + 2)) for u₁ and Σ b'ᵢ cᵢᵏ = 1/(k + 1) for v₁, up to the order; the embedded solution is
    /// of order 3.
    #[test]
    fn weights_integrate_polynomials() {
        let moment = |weights: &[f64], k: i32| weights.iter().zip(C).map(|(b, c)| b * c.powi(k)).sum::<f64>();
        for k in 0..4 {
            let exact = 1.0 / f64::from(k + 1);
            assert!((moment(&B_RATE, k) - exact).abs() < 1e-15, "{k}");
            if k < 3 {
                assert!((moment(&ALPHA[STAGES - 1], k) - exact / f64::from(k + 2)).abs() < 1e-15, "{k}");
            }
        }
        let low = |k: i32| moment(&B_LOW, k) - 1.0 / f64::from((k + 1) * (k + 2));
        assert!(low(0).abs() < 1e-15 && low(1).abs() < 1e-15 && low(2).abs() > 1e-3);
    }
}
