//! Equations (18)–(21): strain energy, elastic forces and stiffness; and the tangent ∂Q_e/∂e, which the paper leaves out.
//!
//! All in global axes. The volume integrals are exact for a straight initial configuration (`volume.rs`). Where
//! J₀ is singular the results are not finite.
//!
//! Derived step by step: `oracle/DERIVATION.md#5-energy-and-forces`, there (18) and E3 `#18-strain-energy`,
//! (19) `#19-elastic-forces`, (20) `#20-the-stiffness-matrix`, (21) and E2 `#21-its-parts`, ∂Q_e/∂e `#the-tangent`,
//! at rest `#at-rest`.
//!
//! (18)–(21) of one state: a rod is held at its initial length and heated, so that both stresses are −2(λ + μ) α_T ΔT.
//!
//! ```
//! # #![allow(non_snake_case)]
//! use ancf::equations::element::Element;
//! use ancf::equations::material::{LameConstants, YoungPoisson};
//! use ancf::equations::{force, strain};
//!
//! let element = Element::straight(2.0, 0.1, 0.05, 0.0);
//! let lame = LameConstants::from(YoungPoisson { E: 2e8, nu: 0.3 });
//! let (e, eps_T) = (element.e_0, strain::eps_T(1e-5, 100.0));
//!
//! let U = force::U(&e, &eps_T, lame, &element); // (18)
//! let K_1 = force::K_1(&e, &eps_T, &element); // (21)
//! let K_2 = force::K_2(&e, &eps_T, &element);
//! let K_3 = force::K_3(&e, &eps_T, &element);
//! let K = force::K(lame, &K_1, &K_2, &K_3); // (20)
//! let Q_e = force::Q_e(&e, &K); // (19)
//!
//! let stress = -2.0 * (lame.lambda + lame.mu) * 1e-3;
//! let (area, volume) = (0.1 * 0.05, 2.0 * 0.1 * 0.05);
//! assert!((U / (-1e-3 * stress * volume) - 1.0).abs() < 1e-12);
//! assert!((Q_e[10] / (stress * area) - 1.0).abs() < 1e-12); // on rᵏ, along the rod
//! ```

use super::element::{Element, Matrix14};
use super::material::{D, LameConstants, sigma};
use super::shape::Vector14;
use super::strain::{S_abc, eps, eps_1, eps_2, eps_3, eps_f};
use super::volume::gauss_points;
use nalgebra::Vector3;

/// The metrics matrices at one Gauss point, and its share of the volume.
struct Metrics {
    S_a: Matrix14,
    S_b: Matrix14,
    S_c: Matrix14,
    dV: f64,
}

fn metrics(element: &Element) -> impl Iterator<Item = Metrics> {
    gauss_points(element.l, element.h, element.w).into_iter().map(|p| {
        let (S_a, S_b, S_c) = S_abc(p.x, p.y, element);
        Metrics { S_a, S_b, S_c, dV: p.dV }
    })
}

/// (18) Strain energy, J, **consistent**: U = ½ ∫_V (ε₁σ₁ + ε₂σ₂ + 2 ε₃σ₃) dV.
///
/// The double contraction ε : σ contains ε₁₂σ₁₂ and ε₂₁σ₂₁. Only with both is U the same in every frame (E3).
pub fn U(e: &Vector14, eps_T: &Vector3<f64>, lame: LameConstants, element: &Element) -> f64 {
    let D = D(lame);
    let mut U = 0.0;
    for Metrics { S_a, S_b, S_c, dV } in metrics(element) {
        let eps = eps(&eps_f(eps_1(e, &S_a), eps_2(e, &S_b), eps_3(e, &S_c)), eps_T);
        let sigma = sigma(&D, &eps);
        U += 0.5 * (eps[0] * sigma[0] + eps[1] * sigma[1] + 2.0 * eps[2] * sigma[2]) * dV;
    }
    U
}

/// (18) Strain energy **as printed**, J: U = ½ ∫_V εᵀσ dV, which counts the shear once (E3).
///
/// It changes with the frame in which a rod is described, so it is defined in global axes only.
pub fn U_printed(e: &Vector14, eps_T: &Vector3<f64>, lame: LameConstants, element: &Element) -> f64 {
    let D = D(lame);
    let mut U = 0.0;
    for Metrics { S_a, S_b, S_c, dV } in metrics(element) {
        let eps = eps(&eps_f(eps_1(e, &S_a), eps_2(e, &S_b), eps_3(e, &S_c)), eps_T);
        U += 0.5 * eps.dot(&sigma(&D, &eps)) * dV;
    }
    U
}

/// (19) Elastic forces: Q_eᵀ = ∂U/∂e = eᵀK, so Q_e = Kᵀe; N on positions, N m on slopes.
///
/// Consistent with K of [`K`], as printed with K of [`K_printed`].
pub fn Q_e(e: &Vector14, K: &Matrix14) -> Vector14 {
    K.tr_mul(e)
}

/// (20) Stiffness matrix, **consistent**: K = (λ + 2μ) K₁ + λ K₂ + 4μ K₃, for the energy [`U`] (E3).
///
/// K₁, K₂, K₃ are those of (21). In N/m between positions, N and N m with slopes.
pub fn K(LameConstants { lambda, mu }: LameConstants, K_1: &Matrix14, K_2: &Matrix14, K_3: &Matrix14) -> Matrix14 {
    (lambda + 2.0 * mu) * K_1 + lambda * K_2 + 4.0 * mu * K_3
}

/// (20) Stiffness matrix **as printed**: K = (λ + 2μ) K₁ + λ K₂ + 2μ K₃, for the energy [`U_printed`] (E3).
///
/// Units as of [`K`].
pub fn K_printed(
    LameConstants { lambda, mu }: LameConstants,
    K_1: &Matrix14,
    K_2: &Matrix14,
    K_3: &Matrix14,
) -> Matrix14 {
    (lambda + 2.0 * mu) * K_1 + lambda * K_2 + 2.0 * mu * K_3
}

/// (21) S_a1 = S_aᵀ + S_a, and likewise S_b1 and S_c1: the symmetric matrices with ∂(eᵀS e)/∂e = S₁e.
pub fn S_1(S: &Matrix14) -> Matrix14 {
    S.transpose() + S
}

/// (21) K₁ = ¼ ∫_V \[S_a1 (eᵀS_a e − 1 − 2ε_T1) + S_b1 (eᵀS_b e − 1 − 2ε_T2)\] dV; m for positions, m² and m³ for slopes.
///
/// The paper writes α_T ΔT, which is ε_T1 = ε_T2 of (8). With ε_T the formula covers the 1D model as well.
pub fn K_1(e: &Vector14, eps_T: &Vector3<f64>, element: &Element) -> Matrix14 {
    let mut K_1 = Matrix14::zeros();
    for Metrics { S_a, S_b, dV, .. } in metrics(element) {
        let a = e.dot(&(S_a * e)) - 1.0 - 2.0 * eps_T[0];
        let b = e.dot(&(S_b * e)) - 1.0 - 2.0 * eps_T[1];
        K_1 += 0.25 * (S_1(&S_a) * a + S_1(&S_b) * b) * dV;
    }
    K_1
}

/// (21) K₂ = ¼ ∫_V \[S_a1 (eᵀS_b e − 1 − 2ε_T2) + S_b1 (eᵀS_a e − 1 − 2ε_T1)\] dV; m for positions, m² and m³ for slopes.
pub fn K_2(e: &Vector14, eps_T: &Vector3<f64>, element: &Element) -> Matrix14 {
    let mut K_2 = Matrix14::zeros();
    for Metrics { S_a, S_b, dV, .. } in metrics(element) {
        let a = e.dot(&(S_a * e)) - 1.0 - 2.0 * eps_T[0];
        let b = e.dot(&(S_b * e)) - 1.0 - 2.0 * eps_T[1];
        K_2 += 0.25 * (S_1(&S_a) * b + S_1(&S_b) * a) * dV;
    }
    K_2
}

/// (21) K₃, **consistent**: K₃ = ¼ ∫_V S_c1 (eᵀS_c e − 2ε_T3) dV; m for positions, m² and m³ for slopes.
///
/// Without the printed "− 1" (E2): ε₃ of (13) has none, and with it the undeformed element would not be in equilibrium.
/// ε_T3 is zero in (8), and α_T ΔT sin θ cos θ in the 1D model.
pub fn K_3(e: &Vector14, eps_T: &Vector3<f64>, element: &Element) -> Matrix14 {
    let mut K_3 = Matrix14::zeros();
    for Metrics { S_c, dV, .. } in metrics(element) {
        K_3 += 0.25 * S_1(&S_c) * (e.dot(&(S_c * e)) - 2.0 * eps_T[2]) * dV;
    }
    K_3
}

/// (21) K₃ **as printed**: ¼ ∫_V S_c1 (eᵀS_c e − 1) dV (E2). It shows how the printed form fails; nothing else uses it.
pub fn K_3_printed(e: &Vector14, element: &Element) -> Matrix14 {
    let mut K_3 = Matrix14::zeros();
    for Metrics { S_c, dV, .. } in metrics(element) {
        K_3 += 0.25 * S_1(&S_c) * (e.dot(&(S_c * e)) - 1.0) * dV;
    }
    K_3
}

/// Tangent ∂Q_e/∂e, **consistent**, symmetric. The paper leaves it out; Newton's iteration needs it. Units as of [`K`].
///
/// Q_e = K e, and K depends on e through eᵀS_a e, eᵀS_b e, eᵀS_c e alone, whose derivatives are eᵀS_a1, eᵀS_b1, eᵀS_c1.
/// The product rule gives ∂(K₁e)/∂e = K₁ + ¼ ∫ \[(S_a1 e)(S_a1 e)ᵀ + (S_b1 e)(S_b1 e)ᵀ\] dV, and K₂, K₃ likewise. Together:
///
/// ∂Q_e/∂e = K + ¼ ∫_V { (λ + 2μ) \[aaᵀ + bbᵀ\] + λ \[abᵀ + baᵀ\] + 4μ ccᵀ } dV,  a = S_a1 e, b = S_b1 e, c = S_c1 e.
///
/// K is the geometric part (from the stresses), the integral the material part (from the elasticity).
pub fn tangent(e: &Vector14, eps_T: &Vector3<f64>, lame: LameConstants, element: &Element) -> Matrix14 {
    let (K_1, K_2, K_3) = (K_1(e, eps_T, element), K_2(e, eps_T, element), K_3(e, eps_T, element));
    K(lame, &K_1, &K_2, &K_3) + tangent_material(e, lame, 4.0 * lame.mu, element)
}

/// Tangent ∂Q_e/∂e of the energy **as printed** (E3): [`tangent`] with 2μ in place of 4μ.
pub fn tangent_printed(e: &Vector14, eps_T: &Vector3<f64>, lame: LameConstants, element: &Element) -> Matrix14 {
    let (K_1, K_2, K_3) = (K_1(e, eps_T, element), K_2(e, eps_T, element), K_3(e, eps_T, element));
    K_printed(lame, &K_1, &K_2, &K_3) + tangent_material(e, lame, 2.0 * lame.mu, element)
}

/// The material part of [`tangent`]; `shear` is the factor of ccᵀ, Pa.
fn tangent_material(
    e: &Vector14,
    LameConstants { lambda, mu }: LameConstants,
    shear: f64,
    element: &Element,
) -> Matrix14 {
    let mut K_m = Matrix14::zeros();
    for Metrics { S_a, S_b, S_c, dV } in metrics(element) {
        let (a, b, c) = (S_1(&S_a) * e, S_1(&S_b) * e, S_1(&S_c) * e);
        let normal = a * a.transpose() + b * b.transpose();
        let cross = a * b.transpose() + b * a.transpose();
        K_m += 0.25 * ((lambda + 2.0 * mu) * normal + lambda * cross + shear * c * c.transpose()) * dV;
    }
    K_m
}
