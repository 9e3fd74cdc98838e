//! Motions of [`Rods`]: finely, or by a method with a step.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};

use super::frames::Frames;
use super::rods::Rods;

/// Longest step of a fine motion, s: the thickness vibration of the fixtures' rods has ω ≈ 3e4 rad/s.
const FINE_STEP: f64 = 2.5e-5;
/// Longest step of the finest motion, s, where sudden heat excites that vibration.
const FINEST_STEP: f64 = 1e-5;
/// Newton's iteration ends at corrections below this.
const NEWTON_TOLERANCE: f64 = 1e-11;
/// Most iterations of a step, the matrix made anew after each sixth one.
const MOST_ITERATIONS: usize = 30;
/// Coordinates beyond this are an explosion.
const FAR: f64 = 1e3;

/// How a motion is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// By steps so short that they leave no error that matters, except that of waves that sudden heat excites.
    Fine,
    /// By steps that leave no error of such waves either.
    Finest,
    /// By q₁ = q₀ + h v₀ + h² (c₀ a₀ + c₁ a₁), v₁ = v₀ + h (d₀ a₀ + d₁ a₁) with steps of at most `step`.
    Steps {
        /// Longest step h, s.
        step: f64,
        /// c₀, c₁.
        c: [f64; 2],
        /// d₀, d₁.
        d: [f64; 2],
    },
}

/// A motion as it goes on.
struct Motion<'a> {
    rods: &'a Rods,
    q: DVector<f64>,
    v: DVector<f64>,
    a: DVector<f64>,
    force: DVector<f64>,
    at: DVector<f64>,
    /// Inverse of Newton's matrix with the step that it is for.
    newton: Option<(f64, DMatrix<f64>)>,
}

/// Frames of a motion at `times`, as far as it goes: it ends early where `enough` says so, or where it explodes.
pub fn frames(rods: &Rods, method: Method, times: &[f64], mut enough: impl FnMut(&Frames) -> bool) -> Frames {
    let size = rods.size();
    let zero = || DVector::zeros(size);
    let mut motion =
        Motion { rods, q: rods.start.clone(), v: zero(), a: zero(), force: zero(), at: zero(), newton: None };
    let mut frames = Frames { t: Vec::new(), position: named(rods), velocity: named(rods), energy: BTreeMap::new() };
    let mut t = 0.0;
    motion.accelerate(0.0);
    for &next in times {
        if next > t && motion.advance(method, t, next).is_none() {
            break;
        }
        t = t.max(next);
        frames.t.push(next);
        for (name, at) in rods.points() {
            let of = |vector: &DVector<f64>| [vector[at], vector[at + 1]];
            frames.position.entry(name.into()).or_default().push(of(&motion.q));
            frames.velocity.entry(name.into()).or_default().push(of(&motion.v));
        }
        let energies = rods.energies(t, &motion.q, &motion.v);
        for (name, energy) in ["kinetic", "strain", "potential"].into_iter().zip(energies) {
            frames.energy.entry(name.into()).or_default().push(energy);
        }
        if enough(&frames) {
            break;
        }
    }
    frames
}

fn named(rods: &Rods) -> BTreeMap<String, Vec<[f64; 2]>> {
    rods.points().map(|(name, _)| (name.to_string(), Vec::new())).collect()
}

/// q̈ at t = 0.
pub fn initial_acceleration(rods: &Rods) -> DVector<f64> {
    let zero = DVector::zeros(rods.size());
    let (mut force, mut a) = (zero.clone(), zero.clone());
    rods.accelerate(0.0, &rods.start, &zero, &mut force, &mut a);
    a
}

impl Motion<'_> {
    /// Acceleration at the present coordinates.
    fn accelerate(&mut self, t: f64) {
        self.rods.accelerate(t, &self.q, &self.v, &mut self.force, &mut self.a);
    }

    /// Goes from one time to another; `None` if it cannot.
    fn advance(&mut self, method: Method, from: f64, to: f64) -> Option<()> {
        let longest = match method {
            Method::Fine => FINE_STEP,
            Method::Finest => FINEST_STEP,
            Method::Steps { step, .. } => step,
        };
        let count = ((to - from) / longest * (1.0 - 1e-9)).ceil().max(1.0);
        let h = (to - from) / count;
        for n in 0..count as usize {
            let t = from + (n + 1) as f64 * h;
            match method {
                Method::Fine | Method::Finest => self.fine_step(t, h),
                Method::Steps { c, d, .. } => self.step(t, h, c, d)?,
            }
            if n % 64 == 0 && !self.is_near() {
                return None;
            }
        }
        self.is_near().then_some(())
    }

    fn is_near(&self) -> bool {
        self.q.iter().all(|q| q.abs() < FAR)
    }

    /// Velocity Verlet with the acceleration taken at q + h²/12 q̈: of order four for linear vibrations.
    fn fine_step(&mut self, t: f64, h: f64) {
        self.v.axpy(0.5 * h, &self.a, 1.0);
        self.q.axpy(h, &self.v, 1.0);
        self.rods.accelerate(t, &self.q, &self.v, &mut self.force, &mut self.a);
        self.at.copy_from(&self.q);
        self.at.axpy(h * h / 12.0, &self.a, 1.0);
        self.rods.accelerate(t, &self.at, &self.v, &mut self.force, &mut self.a);
        self.v.axpy(0.5 * h, &self.a, 1.0);
    }

    /// One step of a method with coefficients.
    fn step(&mut self, t: f64, h: f64, c: [f64; 2], d: [f64; 2]) -> Option<()> {
        let mut q = self.q.clone();
        q.axpy(h, &self.v, 1.0);
        q.axpy(h * h * c[0], &self.a, 1.0);
        self.v.axpy(h * d[0], &self.a, 1.0);
        self.q.copy_from(&q);
        self.q.axpy(h * h * c[1], &self.a, 1.0);
        self.accelerate(t);
        if c[1] != 0.0 {
            for iteration in 0.. {
                let residual = &q + h * h * c[1] * &self.a - &self.q;
                let fits = self.newton.as_ref().is_some_and(|(made_for, _)| (made_for / h - 1.0).abs() < 1e-6);
                if !fits || iteration % 6 == 5 {
                    self.newton = Some((h, self.newton_matrix(t, h * h * c[1])?));
                }
                let (_, inverse) = self.newton.as_ref()?;
                let correction = inverse * residual;
                self.q += &correction;
                self.accelerate(t);
                if correction.amax() < NEWTON_TOLERANCE {
                    break;
                }
                if iteration > MOST_ITERATIONS || !self.is_near() {
                    return None;
                }
            }
        }
        self.v.axpy(h * d[1], &self.a, 1.0);
        Some(())
    }

    /// Inverse of 1 − c ∂a/∂q by differences.
    fn newton_matrix(&mut self, t: f64, c: f64) -> Option<DMatrix<f64>> {
        const DIFFERENCE: f64 = 1e-7;
        let size = self.rods.size();
        let mut matrix = DMatrix::identity(size, size);
        let mut a = DVector::zeros(size);
        self.at.copy_from(&self.q);
        for column in 0..size {
            self.at[column] += DIFFERENCE;
            self.rods.accelerate(t, &self.at, &self.v, &mut self.force, &mut a);
            self.at[column] = self.q[column];
            matrix.column_mut(column).axpy(-c / DIFFERENCE, &(&a - &self.a), 1.0);
        }
        matrix.try_inverse()
    }
}
