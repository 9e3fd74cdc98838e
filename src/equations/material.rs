//! Equations (15)–(17): the St Venant–Kirchhoff law in the plane, and its moduli.
//!
//! The moduli are types. E, ν and λ, μ are pairs of plain numbers on paper; here [`YoungPoisson`] cannot be passed for
//! [`LameConstants`], nor one modulus for the other.
//!
//! Derived step by step: `oracle/DERIVATION.md#4-stress-hookes-law-for-large-motions`, there (15) `#15-stress-from-strain`,
//! (16) `#16-the-elasticity-matrix`, (17) `#17-lamés-constants`.

use nalgebra::{Matrix3, Vector3};

/// Lamé's constants λ and μ: the moduli of (16), (18) and (20).
///
/// Physical where μ > 0 and λ + 2μ/3 > 0.
///
/// ```
/// use ancf::equations::material::{D, LameConstants, YoungPoisson};
///
/// let lame = LameConstants::from(YoungPoisson { E: 2e11, nu: 0.25 });
/// assert_eq!(lame, LameConstants { lambda: 8e10, mu: 8e10 });
/// assert_eq!(D(lame)[(0, 0)], 2.4e11); // λ + 2μ
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LameConstants {
    /// First constant λ, Pa.
    pub lambda: f64,
    /// Second constant μ, the shear modulus, Pa.
    pub mu: f64,
}

/// Young's modulus E and Poisson's ratio ν: the moduli that (17) starts from.
///
/// Physical where E > 0 and −1 < ν < ½.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct YoungPoisson {
    /// Young's modulus, Pa.
    pub E: f64,
    /// Poisson's ratio.
    pub nu: f64,
}

/// By (17).
impl From<YoungPoisson> for LameConstants {
    fn from(moduli: YoungPoisson) -> LameConstants {
        LameConstants { lambda: lambda(moduli), mu: mu(moduli) }
    }
}

/// By (17) solved for E = μ (3λ + 2μ)/(λ + μ) and ν = λ/\[2(λ + μ)\].
impl From<LameConstants> for YoungPoisson {
    fn from(LameConstants { lambda, mu }: LameConstants) -> YoungPoisson {
        YoungPoisson { E: mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu), nu: lambda / (2.0 * (lambda + mu)) }
    }
}

/// (15) Stress \[σ₁₁, σ₂₂, σ₁₂\] (second Piola–Kirchhoff), Pa: σ = D ε.
pub fn sigma(D: &Matrix3<f64>, eps: &Vector3<f64>) -> Vector3<f64> {
    D * eps
}

/// (16) Elasticity matrix D of plane strain (M1), 3 × 3, Pa.
///
/// Its entry 2μ is right for the stress: ε₃ = ε₁₂ in (12), and σ₁₂ = 2μ ε₁₂. As the matrix of the energy it is wrong:
/// see [`U`](super::force::U) and E3.
pub fn D(LameConstants { lambda, mu }: LameConstants) -> Matrix3<f64> {
    Matrix3::new(lambda + 2.0 * mu, lambda, 0.0, lambda, lambda + 2.0 * mu, 0.0, 0.0, 0.0, 2.0 * mu)
}

/// (17) Lamé's first constant, Pa: λ = E ν / \[(1 + ν)(1 − 2ν)\], for −1 < ν < ½.
///
/// As ν → ½ the rounding of ν alone costs digits in proportion to 1/(1 − 2ν).
pub fn lambda(YoungPoisson { E, nu }: YoungPoisson) -> f64 {
    E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
}

/// (17) Shear modulus, Pa: μ = E / \[2(1 + ν)\], for −1 < ν < ½.
pub fn mu(YoungPoisson { E, nu }: YoungPoisson) -> f64 {
    E / (2.0 * (1.0 + nu))
}
