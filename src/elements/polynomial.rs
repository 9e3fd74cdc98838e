//! Quadratic polynomials along an element, and the forces on their coefficients.
//!
//! With ζ = −1 … 1 along the element, vectors along it are c₀ + c₁ζ + c₂ζ². Forces f and stiffnesses at the Gauss points enter
//! an element by their *moments* Σ w ζⁿ f: the forces on the coefficients.

#![allow(non_snake_case)] // Q is a generalized force, as in the equations.

use super::plane::{Block, Linear};

/// Coefficients c₀, c₁, c₂ of a quadratic polynomial.
pub(super) type Quadratic<T> = [T; 3];

/// Gauss point of the axis: weight (m) and place ζ.
#[derive(Clone, Copy, Debug)]
pub(super) struct GaussPoint {
    pub weight: f64,
    pub zeta: f64,
}

/// Gauss points of a rule on an element of length `l`.
pub(super) fn gauss_points<const Q: usize>(rule: &[(f64, f64); Q], l: f64) -> [GaussPoint; Q] {
    rule.map(|(zeta, weight)| GaussPoint { weight: l / 2.0 * weight, zeta })
}

/// Value of a polynomial at ζ.
#[inline(always)]
pub(super) fn at<T: Linear>(zeta: f64, c: &Quadratic<T>) -> T {
    c[0] + (c[1] + c[2] * zeta) * zeta
}

/// Derivative of a polynomial with respect to ζ.
#[inline(always)]
pub(super) fn slope_at<T: Linear>(zeta: f64, c: &Quadratic<T>) -> T {
    c[1] + c[2] * (2.0 * zeta)
}

/// Adds a force on a polynomial's value at ζ to the forces on its coefficients.
#[inline(always)]
pub(super) fn add_at<T: Linear>(zeta: f64, f: T, Q: &mut Quadratic<T>) {
    Q[0] = Q[0] + f;
    Q[1] = Q[1] + f * zeta;
    Q[2] = Q[2] + f * (zeta * zeta);
}

/// Adds a force on a polynomial's derivative at ζ to the forces on its coefficients.
#[inline(always)]
pub(super) fn add_slope_at<T: Linear>(zeta: f64, f: T, Q: &mut Quadratic<T>) {
    Q[1] = Q[1] + f;
    Q[2] = Q[2] + f * (2.0 * zeta);
}

/// Adds the stiffness of a section to the moments: times ζⁿ to the n-th.
#[inline(always)]
pub(super) fn add_moments(zeta: f64, section: Block, moments: &mut [Block; 5]) {
    let zeta_2 = zeta * zeta;
    moments[0] = moments[0] + section;
    moments[1] = moments[1] + section * zeta;
    moments[2] = moments[2] + section * zeta_2;
    moments[3] = moments[3] + section * (zeta * zeta_2);
    moments[4] = moments[4] + section * (zeta_2 * zeta_2);
}
