//! Straight elements, random states of them, and the size of the terms that are added up for a result.

#![allow(non_snake_case)] // The paper's symbols are names here.
#![allow(dead_code)] // Each test binary uses its own part.

use crate::common::{TOLERANCE, within, worst_ratio};
use ancf::equations::element::{Element, Matrix14};
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::shape::{self, Nodes, Vector14};
use ancf::equations::{force, strain};
use ancf::state::ThermalModel;
use nalgebra::{Rotation2, Vector2, Vector3};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use std::ops::{Mul, Range, Sub};

/// Cases a property; one that fails is kept beside its test file and tried first from then on.
pub fn cases(number: u32) -> ProptestConfig {
    let file = FileFailurePersistence::WithSource("proptest-regressions");
    ProptestConfig { failure_persistence: Some(Box::new(file)), ..ProptestConfig::with_cases(number) }
}

/// Every entry within [`TOLERANCE`] of its own scale.
#[track_caller]
pub fn assert_within(what: &str, actual: &[f64], expected: &[f64], scale: &[f64]) {
    let ratio = worst_ratio(actual, expected, scale);
    let close = within(TOLERANCE, actual, expected, scale);
    assert!(close, "{what}: off by {ratio:.1e} of its scale; allowed {TOLERANCE:.1e}");
}

/// Forces and tangent within 1e-13 of their scales; how far they are, of their scales and of the largest entry.
#[track_caller]
pub fn compared(actual: [&[f64]; 2], expected: [&[f64]; 2], scale: [&[f64]; 2]) -> [f64; 4] {
    let mut ratios = [0.0; 4];
    for n in 0..2 {
        assert!(within(1e-13, actual[n], expected[n], scale[n]), "{:?} for {:?}", actual[n], expected[n]);
        let largest = expected[n].iter().fold(f64::MIN_POSITIVE, |most, entry| most.max(entry.abs()));
        ratios[n] = worst_ratio(actual[n], expected[n], scale[n]);
        ratios[n + 2] = worst_ratio(actual[n], expected[n], &vec![largest; actual[n].len()]);
    }
    ratios
}

/// Places of the positions among the seven vectors of (4); the others are slopes.
pub const POSITIONS: [usize; 3] = [0, 2, 5];

/// The field r(x, y) = x a + y b as nodal coordinates: an element of uniform strain. With a and b the unit vectors
/// along and across the rod it is the unstretched element.
pub fn uniform(l: f64, a: Vector2<f64>, b: Vector2<f64>) -> Vector14 {
    shape::e(&Nodes { r_i: 0.0 * a, r_y_i: b, r_j: l / 2.0 * a, r_x_j: a, r_y_j: b, r_k: l * a, r_y_k: b })
}

/// The unit vectors along and across a rod of inclination `theta`.
pub fn axes(theta: f64) -> (Vector2<f64>, Vector2<f64>) {
    let (sin, cos) = theta.sin_cos();
    (Vector2::new(cos, sin), Vector2::new(-sin, cos))
}

/// Turns all seven vectors about the origin.
pub fn turned(e: &Vector14, angle: f64) -> Vector14 {
    let R = Rotation2::new(angle);
    let vector = |n: usize| R * Vector2::new(e[2 * n], e[2 * n + 1]);
    Vector14::from_fn(|row, _| vector(row / 2)[row % 2])
}

/// Moves the three positions.
pub fn moved(e: &Vector14, by: &Vector2<f64>) -> Vector14 {
    Vector14::from_fn(|row, _| e[row] + if POSITIONS.contains(&(row / 2)) { by[row % 2] } else { 0.0 })
}

/// [`force::U`] or [`force::U_printed`].
pub type Energy = fn(&Vector14, &Vector3<f64>, LameConstants, &Element) -> f64;
/// [`force::K`] or [`force::K_printed`].
pub type Stiffness = fn(LameConstants, &Matrix14, &Matrix14, &Matrix14) -> Matrix14;

/// (20) and (21), in the form of `sum`, with the consistent K₃.
pub fn K(sum: Stiffness, e: &Vector14, eps_T: &Vector3<f64>, lame: LameConstants, element: &Element) -> Matrix14 {
    let (K_1, K_2, K_3) = (force::K_1(e, eps_T, element), force::K_2(e, eps_T, element), force::K_3(e, eps_T, element));
    sum(lame, &K_1, &K_2, &K_3)
}

/// An element, a motion and a heating of it. The numbers are those in the rod's own axes, so that the state turns
/// as a whole with `theta`.
#[derive(Clone, Debug)]
pub struct State {
    pub l: f64,
    pub h: f64,
    pub w: f64,
    pub theta: f64,
    pub E: f64,
    pub nu: f64,
    pub rho: f64,
    pub model: ThermalModel,
    /// α_T ΔT, now and a step later.
    pub heat: [f64; 2],
    /// Position of node i of the initial configuration.
    pub start: Vector2<f64>,
    /// Displacement from the initial configuration, now and a step later.
    pub u: [Vector14; 2],
    /// Rates.
    pub e_dot: Vector14,
}

/// Uniform in the logarithm: small and large are as likely.
fn logarithmic(range: Range<f64>) -> impl Strategy<Value = f64> {
    (range.start.ln()..range.end.ln()).prop_map(f64::exp)
}

/// Positions within ± `position`, slopes within ± `slope`.
fn coordinates(position: f64, slope: f64) -> impl Strategy<Value = Vector14> {
    prop::array::uniform14(-1.0..1.0).prop_map(move |unit: [f64; 14]| {
        Vector14::from_fn(|row, _| unit[row] * if POSITIONS.contains(&(row / 2)) { position } else { slope })
    })
}

/// Any inclination, from stubby to slender, displacements of the element's own size, hot and cold.
pub fn states() -> impl Strategy<Value = State> {
    let model = prop::sample::select(vec![
        ThermalModel::TwoD,
        ThermalModel::OneD,
        ThermalModel::Transverse,
        ThermalModel::None,
    ]);
    let geometry = (logarithmic(0.1..5.0), logarithmic(1.0..100.0), logarithmic(1e-3..1.0), -3.2..3.2);
    let material = (logarithmic(1.0..1e11), -0.9..0.49, logarithmic(1.0..1e4), model);
    (geometry, material).prop_flat_map(|((l, slenderness, w, theta), (E, nu, rho, model))| {
        let motion = ((-l..l, -l..l), [coordinates(0.3 * l, 0.5), coordinates(0.3 * l, 0.5)], coordinates(l, 1.0));
        (motion, [-0.3..0.3, -0.3..0.3]).prop_map(move |(((x, y), u, e_dot), heat)| {
            let start = Vector2::new(x, y);
            State { l, h: l / slenderness, w, theta, E, nu, rho, model, heat, start, u, e_dot }
        })
    })
}

impl State {
    pub fn element(&self) -> Element {
        let own = Element::straight(self.l, self.h, self.w, 0.0);
        Element { e_0: turned(&moved(&own.e_0, &self.start), self.theta), ..own }
    }

    /// Nodal coordinates: now (0), a step later (1).
    pub fn e(&self, time: usize) -> Vector14 {
        self.element().e_0 + turned(&self.u[time], self.theta)
    }

    /// The same state described in a frame that is turned by −`angle`.
    pub fn turned(&self, angle: f64) -> State {
        State { theta: self.theta + angle, ..self.clone() }
    }

    pub fn moduli(&self) -> YoungPoisson {
        YoungPoisson { E: self.E, nu: self.nu }
    }

    pub fn lame(&self) -> LameConstants {
        self.moduli().into()
    }

    /// Thermal strain in global axes.
    pub fn eps_T(&self, time: usize) -> Vector3<f64> {
        match self.model {
            ThermalModel::TwoD => strain::eps_T(1.0, self.heat[time]),
            ThermalModel::OneD => strain::eps_T_1d(1.0, self.heat[time], self.theta),
            ThermalModel::Transverse => {
                let (sin, cos) = self.theta.sin_cos();
                self.heat[time] * Vector3::new(sin * sin, cos * cos, -sin * cos)
            }
            _ => Vector3::zeros(),
        }
    }

    /// Thermal strain along and across the rod.
    pub fn eps_T_own(&self, time: usize) -> [f64; 2] {
        match self.model {
            ThermalModel::TwoD => [self.heat[time], self.heat[time]],
            ThermalModel::OneD => [self.heat[time], 0.0],
            ThermalModel::Transverse => [0.0, self.heat[time]],
            _ => [0.0, 0.0],
        }
    }

    /// (18), consistent, of any `e` at the temperature of now.
    pub fn U(&self, e: &Vector14) -> f64 {
        force::U(e, &self.eps_T(0), self.lame(), &self.element())
    }

    /// (20), consistent.
    pub fn K(&self, e: &Vector14, time: usize) -> Matrix14 {
        K(force::K, e, &self.eps_T(time), self.lame(), &self.element())
    }

    /// (19), consistent, of any `e` at the temperature of now.
    pub fn Q_e(&self, e: &Vector14) -> Vector14 {
        force::Q_e(e, &self.K(e, 0))
    }

    pub fn sizes(&self, e: &Vector14) -> Sizes {
        let heat = self.heat[0].abs().max(self.heat[1].abs());
        Sizes::of(&self.element(), self.lame(), heat, e)
    }
}

/// Sizes of results before anything cancels in them, on which their rounding depends; the reasoning of `scale.rs`,
/// by hand from (3).
pub struct Sizes {
    /// Largest |∂S/∂x| + |∂S/∂y| over the element, by coordinate.
    pub D: [f64; 14],
    /// Terms of r_x and r_y: Σ D |e|.
    gradient: f64,
    /// Terms of the stress's virtual work: (|λ| + 2μ) V.
    stiff: f64,
    heat: f64,
}

impl Sizes {
    pub fn of(element: &Element, LameConstants { lambda, mu }: LameConstants, heat: f64, e: &Vector14) -> Sizes {
        let Element { l, h, w, .. } = *element;
        let b = h / 2.0 / l;
        let x = [5.0 / l, 3.0 * b, 4.0 / l, 2.0, 4.0 * b, 5.0 / l, 3.0 * b];
        let y = [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
        let D = std::array::from_fn(|i| x[i / 2] + y[i / 2]);
        let gradient = e.iter().zip(D).map(|(e, d): (&f64, f64)| d * e.abs()).sum();
        Sizes { D, gradient, stiff: (lambda.abs() + 2.0 * mu) * l * h * w, heat }
    }

    /// The same for nodal coordinates that add `more` to the terms of the gradient.
    pub fn beyond(self, more: f64) -> Sizes {
        Sizes { gradient: self.gradient + more, ..self }
    }

    /// ½ (eᵀS_a e − 1) − ε_T.
    fn strain(&self) -> f64 {
        0.5 * (self.gradient.powi(2) + 1.0) + self.heat
    }

    /// ½ ∫ ε : σ dV.
    pub fn energy(&self) -> f64 {
        0.5 * self.stiff * self.strain().powi(2)
    }

    /// ∫ (∂ε/∂e)ᵀσ dV.
    pub fn force(&self) -> Vec<f64> {
        self.D.iter().map(|d| self.stiff * d * self.gradient * self.strain()).collect()
    }

    /// What multiplies σ and C in ∂Q_e/∂e; row by row.
    pub fn tangent(&self) -> Vec<f64> {
        let size = self.stiff * self.strain();
        self.D.iter().flat_map(|a| self.D.iter().map(move |b| size * a * b)).collect()
    }
}

/// Five-point derivative of f at 0. Its error is s⁴ f⁽⁵⁾/30: none for a polynomial of degree four, whatever the step,
/// so the step can be as large as the argument and nothing cancels.
pub fn five_point<T: Sub<Output = T> + Mul<f64, Output = T>>(f: impl Fn(f64) -> T, s: f64) -> T {
    ((f(s) - f(-s)) * 8.0 - (f(2.0 * s) - f(-2.0 * s))) * (1.0 / (12.0 * s))
}

/// The column with `s` in the row `i`.
pub fn unit(i: usize, s: f64) -> Vector14 {
    Vector14::from_fn(|row, _| if row == i { s } else { 0.0 })
}

/// The numbers of a matrix, row by row.
pub fn rows(matrix: &Matrix14) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}
