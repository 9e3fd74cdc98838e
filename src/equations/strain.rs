//! Equations (8)–(14): thermal strain, deformation gradient and Green–Lagrange strain, all in global axes.
//!
//! Strains have no unit. What depends on J₀⁻¹ is not finite where J₀ is singular: an initial configuration without volume.
//!
//! Derived step by step: `oracle/DERIVATION.md#3-strain-what-deformation-is`, there (8) `#8-thermal-strain`, θ
//! `#the-initial-direction`, (9) `#9-deformation-gradient`, (10) `#10-the-strain-tensor`, (11) `#11-the-metrics-matrices`,
//! (12) `#12-strain-as-a-column`, (13) `#13-the-three-strains`, (14) `#14-the-strain-that-makes-stress`.
//!
//! Strain at a point of a rod that is stretched to 1.1 of its length:
//!
//! ```
//! # #![allow(non_snake_case)]
//! use ancf::equations::element::Element;
//! use ancf::equations::strain;
//!
//! let element = Element::straight(2.0, 0.1, 0.05, 0.0);
//! let mut e = element.e_0;
//! (e[4], e[6], e[10]) = (1.1, 1.1, 2.2); // rʲ, r_xʲ and rᵏ of (4), along x
//!
//! let (S_a, S_b, S_c) = strain::S_abc(0.5, 0.02, &element); // (11)
//! let eps_f = strain::eps_f(strain::eps_1(&e, &S_a), strain::eps_2(&e, &S_b), strain::eps_3(&e, &S_c)); // (12), (13)
//! let eps = strain::eps(&eps_f, &strain::eps_T(1e-5, 100.0)); // (8), (14)
//!
//! let expected = [0.5 * (1.1 * 1.1 - 1.0) - 1e-3, -1e-3, 0.0];
//! assert!(eps.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-14));
//! ```

use super::element::{Element, Matrix14};
use super::shape::{Matrix2x14, S_x, S_y, Vector14};
use nalgebra::{Matrix2, Vector3};

/// (8) Thermal strain of the 2D model: ε_T = \[α_T ΔT, α_T ΔT, 0\]ᵀ, equal in every direction of the plane.
///
/// `alpha_T` in 1/K, `dT` in K. The paper prints a row; (14) needs the column (E5). ε_T is subtracted from a Green–Lagrange
/// strain. So the stress-free stretch is √(1 + 2α_T ΔT), and 1 + 2α_T ΔT must stay positive (M2). With (16) there is no strain
/// out of the plane (M1).
pub fn eps_T(alpha_T: f64, dT: f64) -> Vector3<f64> {
    Vector3::new(alpha_T * dT, alpha_T * dT, 0.0)
}

/// Thermal strain of the 1D model, with which the paper compares: ε_T = α_T ΔT t⊗t, t = (cos θ, sin θ) along the rod.
///
/// `alpha_T` in 1/K, `dT` in K, `theta` in rad. In global axes, like (9)–(13):
/// \[α_T ΔT cos²θ, α_T ΔT sin²θ, α_T ΔT sin θ cos θ\]ᵀ (M7). With θ + π/2 it is the heat across the rod only,
/// α_T ΔT n⊗n: what the 2D model adds, as t⊗t + n⊗n = I.
pub fn eps_T_1d(alpha_T: f64, dT: f64, theta: f64) -> Vector3<f64> {
    let (sin, cos) = theta.sin_cos();
    alpha_T * dT * Vector3::new(cos * cos, sin * sin, sin * cos)
}

/// Gradient ∂r/∂(x, y) = \[r_x r_y\] of the nodal coordinates `e`, 2 × 2.
fn gradient(x: f64, y: f64, e: &Vector14, l: f64) -> Matrix2<f64> {
    Matrix2::from_columns(&[S_x(x, y, l) * e, S_y(x, y, l) * e])
}

/// (9) Gradient of the initial configuration: J₀ = ∂(S e₀)/∂x, 2 × 2.
pub fn J_0(x: f64, y: f64, element: &Element) -> Matrix2<f64> {
    gradient(x, y, &element.e_0, element.l)
}

/// (11) J₀ of a straight, unstretched element of inclination θ: \[cos θ, −sin θ; sin θ, cos θ\], 2 × 2.
///
/// The closed form (11) rests on it. The paper never defines θ (E5): it is the angle from the global x axis to the element's
/// initial axis, in rad.
pub fn J_0_theta(theta: f64) -> Matrix2<f64> {
    let (sin, cos) = theta.sin_cos();
    Matrix2::new(cos, -sin, sin, cos)
}

/// J₀⁻¹; not finite where J₀ is singular.
fn inverse(J_0: &Matrix2<f64>) -> Matrix2<f64> {
    let det = J_0[(0, 0)] * J_0[(1, 1)] - J_0[(0, 1)] * J_0[(1, 0)];
    Matrix2::new(J_0[(1, 1)], -J_0[(0, 1)], -J_0[(1, 0)], J_0[(0, 0)]) / det
}

/// (9) Deformation gradient: J = ∂r/∂r₀ = \[S_x e, S_y e\] J₀⁻¹, 2 × 2. Not finite where J₀ is singular.
pub fn J(x: f64, y: f64, e: &Vector14, element: &Element) -> Matrix2<f64> {
    gradient(x, y, e, element.l) * inverse(&J_0(x, y, element))
}

/// (10) Green–Lagrange strain tensor in global axes: ε_m = ½ (JᵀJ − I), 2 × 2.
pub fn eps_m(J: &Matrix2<f64>) -> Matrix2<f64> {
    0.5 * (J.transpose() * J - Matrix2::identity())
}

/// (11) Metrics matrices S_a, S_b, S_c for any invertible J₀, each 14 × 14, 1/m² between positions.
///
/// With P = J₀⁻¹ the columns of J are G₁e and G₂e, where G_m = S_x P₁ₘ + S_y P₂ₘ. So (JᵀJ)₁₁ = eᵀS_a e with S_a = G₁ᵀG₁,
/// and likewise S_b = G₂ᵀG₂ and S_c = G₁ᵀG₂, which is not symmetric. Not finite where J₀ is singular.
pub fn S_abc(x: f64, y: f64, element: &Element) -> (Matrix14, Matrix14, Matrix14) {
    let (S_x, S_y) = (S_x(x, y, element.l), S_y(x, y, element.l));
    let P = inverse(&J_0(x, y, element));
    let G_1: Matrix2x14 = S_x * P[(0, 0)] + S_y * P[(1, 0)];
    let G_2: Matrix2x14 = S_x * P[(0, 1)] + S_y * P[(1, 1)];
    (G_1.transpose() * G_1, G_2.transpose() * G_2, G_1.transpose() * G_2)
}

/// (11) Metrics matrices S_a, S_b, S_c of a straight element of inclination θ (rad), in the printed closed form.
///
/// The printed sum Σᵢ S_ixᵀS_ix over the two rows i of S is the product S_xᵀS_x. (S_i is a function in (2) and a row here: E5.)
/// [`S_abc`] gives equal matrices from J₀.
pub fn S_abc_theta(x: f64, y: f64, l: f64, theta: f64) -> (Matrix14, Matrix14, Matrix14) {
    let (sin, cos) = theta.sin_cos();
    let (S_x, S_y) = (S_x(x, y, l), S_y(x, y, l));
    let (xx, xy) = (S_x.transpose() * S_x, S_x.transpose() * S_y);
    let (yx, yy) = (S_y.transpose() * S_x, S_y.transpose() * S_y);
    let S_a = xx * cos.powi(2) - xy * (sin * cos) - yx * (sin * cos) + yy * sin.powi(2);
    let S_b = xx * sin.powi(2) + xy * (sin * cos) + yx * (sin * cos) + yy * cos.powi(2);
    let S_c = xx * (sin * cos) + xy * cos.powi(2) - yx * sin.powi(2) - yy * (sin * cos);
    (S_a, S_b, S_c)
}

/// (12) Strain tensor as a column: ε_f = \[ε₁, ε₂, ε₃\]ᵀ, with ε₃ = ε₁₂, half the engineering shear.
pub fn eps_f(eps_1: f64, eps_2: f64, eps_3: f64) -> Vector3<f64> {
    Vector3::new(eps_1, eps_2, eps_3)
}

/// (13) Normal strain along global x: ε₁ = ½ (eᵀS_a e − 1).
pub fn eps_1(e: &Vector14, S_a: &Matrix14) -> f64 {
    0.5 * (e.dot(&(S_a * e)) - 1.0)
}

/// (13) Normal strain along global y: ε₂ = ½ (eᵀS_b e − 1).
pub fn eps_2(e: &Vector14, S_b: &Matrix14) -> f64 {
    0.5 * (e.dot(&(S_b * e)) - 1.0)
}

/// (13) Shear strain ε₁₂: ε₃ = ½ eᵀS_c e.
pub fn eps_3(e: &Vector14, S_c: &Matrix14) -> f64 {
    0.5 * e.dot(&(S_c * e))
}

/// (14) Elastic strain, which causes the stress: ε = ε_f − ε_T.
pub fn eps(eps_f: &Vector3<f64>, eps_T: &Vector3<f64>) -> Vector3<f64> {
    eps_f - eps_T
}
