//! Equations (6)–(7): kinetic energy and the constant mass matrix; the generalized force of gravity.
//!
//! Derived step by step: `oracle/DERIVATION.md#2-inertia-a-mass-matrix-that-never-changes`, there (6) `#6-kinetic-energy`,
//! (7) `#7-the-mass-matrix`, gravity `#the-weight`.

use super::element::{Element, Matrix14};
use super::shape::{S, Vector14, r_dot};
use super::volume::gauss_points;
use nalgebra::Vector2;

/// (6) Kinetic energy, first form, J: T = ½ ∫_V ρ ṙᵀṙ dV, with the density `rho` in kg/m³.
pub fn T_integral(e_dot: &Vector14, rho: f64, element: &Element) -> f64 {
    let Element { l, h, w, .. } = *element;
    let mut T = 0.0;
    for p in gauss_points(l, h, w) {
        let r_dot = r_dot(p.x, p.y, e_dot, l);
        T += 0.5 * rho * r_dot.dot(&r_dot) * p.dV;
    }
    T
}

/// (6) Kinetic energy, second form, J: T = ½ ėᵀ M ė, with M of (7).
pub fn T(M: &Matrix14, e_dot: &Vector14) -> f64 {
    0.5 * e_dot.dot(&(M * e_dot))
}

/// (7) Mass matrix: M = ∫_V ρ SᵀS dV, 14 × 14; kg between positions, kg m and kg m² with slopes.
///
/// Constant, symmetric and positive definite; `rho` is the density, kg/m³.
pub fn M(rho: f64, element: &Element) -> Matrix14 {
    let Element { l, h, w, .. } = *element;
    let mut M = Matrix14::zeros();
    for p in gauss_points(l, h, w) {
        let S = S(p.x, p.y, l);
        M += rho * S.transpose() * S * p.dV;
    }
    M
}

/// Generalized force of gravity: Q_w = ∫_V ρ Sᵀg dV, a part of Q_w in (22); N on positions, N m on slopes.
///
/// The derivative of the work ∫_V ρ g·r dV with respect to e; `g` in m/s², `rho` in kg/m³. Not in the paper.
pub fn Q_w_gravity(g: &Vector2<f64>, rho: f64, element: &Element) -> Vector14 {
    let Element { l, h, w, .. } = *element;
    let mut Q_w = Vector14::zeros();
    for p in gauss_points(l, h, w) {
        Q_w += rho * S(p.x, p.y, l).transpose() * g * p.dV;
    }
    Q_w
}
