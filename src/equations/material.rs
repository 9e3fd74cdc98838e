//! Equations (15)–(17): St Venant–Kirchhoff's law in the plane.
//!
//! Derived step by step: `oracle/DERIVATION.md#4-stress-hookes-law-for-large-motions`, there (15) `#15-stress-from-strain`,
//! (16) `#16-the-elasticity-matrix`, (17) `#17-lamés-constants`.

use nalgebra::{Matrix3, Vector3};

/// (15) Stress (second Piola–Kirchhoff) \[σ₁₁, σ₂₂, σ₁₂\], Pa: σ = D ε.
pub fn sigma(D: &Matrix3<f64>, eps: &Vector3<f64>) -> Vector3<f64> {
    D * eps
}

/// (16) Elasticity matrix, Pa, that of plane strain (M1).
///
/// With ε₃ = ε₁₂ its 2μ is right for the stress, σ₁₂ = 2μ ε₁₂. It is wrong as the matrix of the energy: see
/// [`U`](super::force::U) and E3.
pub fn D(lambda: f64, mu: f64) -> Matrix3<f64> {
    Matrix3::new(lambda + 2.0 * mu, lambda, 0.0, lambda, lambda + 2.0 * mu, 0.0, 0.0, 0.0, 2.0 * mu)
}

/// (17) Lamé's first constant, Pa: λ = E ν / \[(1 + ν)(1 − 2ν)\], for −1 < ν < ½.
///
/// It loses digits like 1/(1 − 2ν) as ν → ½, by the rounding of ν alone.
pub fn lambda(E: f64, nu: f64) -> f64 {
    E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
}

/// (17) Shear modulus, Pa: μ = E / \[2(1 + ν)\].
pub fn mu(E: f64, nu: f64) -> f64 {
    E / (2.0 * (1.0 + nu))
}
