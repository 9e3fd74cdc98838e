//! Quadrature rules, and the integrals of (18) and (21) with separate parts that can be omitted or changed.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Vector3;

use ancf::equations::element::{Element, Matrix14};
use ancf::equations::force::S_1;
use ancf::equations::shape::Vector14;
use ancf::equations::strain::S_abc;
use ancf::internals::equations::volume::{GAUSS_3, GAUSS_5, Point, gauss_points};
use ancf::state::ElementState;

/// Parts of the integrands of (18) and (21) at one point.
pub(super) struct Integrand {
    /// S_a, S_b, S_c.
    pub S: [Matrix14; 3],
    /// S_a1, S_b1, S_c1 of (21).
    pub S_1: [Matrix14; 3],
    /// eᵀS e of each.
    pub form: [f64; 3],
    /// Volume that belongs to the point.
    pub dV: f64,
}

/// Points of a rule that is exact for (18) and (21).
pub(super) fn exact(state: &ElementState) -> Vec<Point> {
    gauss_points(state.l, state.h, state.w).into()
}

/// Gauss's rules with one, two and four points on \[−1, 1\]: (point, weight).
const GAUSS_1: [(f64, f64); 1] = [(0.0, 2.0)];
const GAUSS_2: [(f64, f64); 2] = [(-0.577_350_269_189_625_8, 1.0), (0.577_350_269_189_625_8, 1.0)];
const GAUSS_4: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Gauss's rule with one to five points.
pub(super) fn gauss(points: usize) -> &'static [(f64, f64)] {
    match points {
        1 => &GAUSS_1,
        2 => &GAUSS_2,
        3 => &GAUSS_3,
        4 => &GAUSS_4,
        _ => &GAUSS_5,
    }
}

/// Points of the product of two rules on an element; `moved` changes the natural coordinates ξ and η first.
pub(super) fn points(
    state: &ElementState,
    along: &[(f64, f64)],
    across: &[(f64, f64)],
    moved: impl Fn(f64, f64) -> (f64, f64),
) -> Vec<Point> {
    let volume = state.l * state.h * state.w / 4.0;
    let pairs = along.iter().flat_map(|a| across.iter().map(move |b| (*a, *b)));
    let point = |((xi, of_xi), (eta, of_eta)): ((f64, f64), (f64, f64))| {
        let (xi, eta) = moved(xi, eta);
        Point { x: state.l / 2.0 * (1.0 + xi), y: state.h / 2.0 * eta, dV: volume * of_xi * of_eta }
    };
    pairs.map(point).collect()
}

/// Parts of the integrands at quadrature points.
pub(super) fn integrands(e: &Vector14, element: &Element, points: &[Point]) -> Vec<Integrand> {
    let at = |p: &Point| {
        let (S_a, S_b, S_c) = S_abc(p.x, p.y, element);
        let S = [S_a, S_b, S_c];
        Integrand { S_1: S.map(|S| S_1(&S)), form: S.map(|S| e.dot(&(S * e))), S, dV: p.dV }
    };
    points.iter().map(at).collect()
}

/// ¼ ∫ Σ weightₖ S_k1 dV.
pub(super) fn K(integrands: &[Integrand], weights: impl Fn(&Integrand) -> [f64; 3]) -> Matrix14 {
    let mut K = Matrix14::zeros();
    for integrand in integrands {
        let weights = weights(integrand);
        for (S_1, weight) in integrand.S_1.iter().zip(weights) {
            if weight != 0.0 {
                K += S_1 * (0.25 * weight * integrand.dV);
            }
        }
    }
    K
}

/// ¼ ∫ Σ weightₖₙ Bₖ Bₙᵀ dV with Bₖ = S_k1 e: the part of the tangent from the derivative of K by e.
pub(super) fn material(
    integrands: &[Integrand],
    B: impl Fn(&Integrand) -> [Vector14; 3],
    weights: [[f64; 3]; 3],
) -> Matrix14 {
    let mut sum = Matrix14::zeros();
    for integrand in integrands {
        let B = B(integrand);
        for (k, row) in weights.iter().enumerate() {
            for (n, weight) in row.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                sum += B[k] * B[n].transpose() * (0.25 * weight * integrand.dV);
            }
        }
    }
    sum
}

/// Bracket k of (21): twice the strain, thermal strain subtracted.
pub(super) fn bracket(integrand: &Integrand, eps_T: &Vector3<f64>, k: usize) -> f64 {
    integrand.form[k] - [1.0, 1.0, 0.0][k] - 2.0 * eps_T[k]
}

/// ∫ εₖ εₙ dV.
pub(super) fn product(integrands: &[Integrand], eps_T: &Vector3<f64>, k: usize, n: usize) -> f64 {
    let eps = |integrand: &Integrand, k: usize| 0.5 * bracket(integrand, eps_T, k);
    integrands.iter().map(|integrand| eps(integrand, k) * eps(integrand, n) * integrand.dV).sum()
}

/// ∫ εₙ dV.
pub(super) fn mean(integrands: &[Integrand], eps_T: &Vector3<f64>, n: usize) -> f64 {
    integrands.iter().map(|integrand| 0.5 * bracket(integrand, eps_T, n) * integrand.dV).sum()
}
