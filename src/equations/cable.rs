//! **The paper's competitor**: a planar Euler–Bernoulli ANCF element with axial heat. A comparison model, no part of
//! (1)–(23).
//!
//! The paper compares its element with "the 1D thermo-structural model \[30\]" of Li and Wang (2009). That model, it says,
//! "is based on a simple Euler–Bernoulli beam element and only the axial thermal effect is pondered". None of the model's
//! equations are printed, so this is the standard element of that description, the gradient-deficient one:
//!
//! * interpolation of Berzeri and Shabana (2000): a cubic axis with r and r_x at two nodes,
//!   e = \[rⁱ r_xⁱ rᵏ r_xᵏ\], i at x = 0, k at x = l;
//! * strains of Gerstmayr and Irschik (2008): axial strain |r_x| − 1 and the *material* measure of curvature
//!   κ = (r_x × r_xx)/|r_x|², the rotation of the section per initial length. (The *geometric* curvature divides by |r_x|³
//!   and couples stretch and bending wrongly.)
//! * thermal strain αΔT subtracted from the axial strain, so that the stress-free stretch is 1 + αΔT; in the paper's measure
//!   it is √(1 + 2αΔT) (M2);
//! * Gauss rules with five points for the axial strain and three for the curvature. The rules are part of the definition,
//!   as the integrands are not polynomials.
//!
//! The section neither shears nor changes its size. The stiffnesses EA and EI contain Young's modulus itself, as for a rod that
//! is free to contract across. There is no rotary inertia.
//!
//! ```
//! # #![allow(non_snake_case)]
//! use ancf::equations::cable;
//!
//! // A straight element along x, 2 m long, at its initial length and heated: the axial force is −EA αΔT.
//! let (l, EA, EI, eps_T) = (2.0, 1e6, 800.0, 1e-3);
//! let e = cable::Vector8::from([0.0, 0.0, 1.0, 0.0, l, 0.0, 1.0, 0.0]);
//! let Q_e = cable::Q_e(&e, eps_T, EA, EI, l);
//! assert!((Q_e[4] + EA * eps_T).abs() < 1e-9); // on rᵏ, along x
//! ```

use super::volume::{GAUSS_3, GAUSS_5, axis_points};
use nalgebra::{Matrix2, SMatrix, SVector, Vector2};

/// A column of 8 entries, such as the nodal coordinates e = \[rⁱ r_xⁱ rᵏ r_xᵏ\].
pub type Vector8 = SVector<f64, 8>;
/// An 8 × 8 matrix, such as M.
pub type Matrix8 = SMatrix<f64, 8, 8>;
/// A 2 × 8 matrix, such as the shape matrix S and its derivatives.
pub type Matrix2x8 = SMatrix<f64, 2, 8>;

/// Shape functions S₁…S₄ of the cable: Hermite's cubics with a = x/l; those of slopes (2 and 4) in m.
pub fn S_i(x: f64, l: f64) -> [f64; 4] {
    let a = x / l;
    [
        1.0 - 3.0 * a.powi(2) + 2.0 * a.powi(3),
        l * (a - 2.0 * a.powi(2) + a.powi(3)),
        3.0 * a.powi(2) - 2.0 * a.powi(3),
        l * (-a.powi(2) + a.powi(3)),
    ]
}

/// Derivatives of the cable's shape functions with respect to x, by da/dx = 1/l; 1/m for positions.
pub fn S_i_x(x: f64, l: f64) -> [f64; 4] {
    let a = x / l;
    [
        (-6.0 * a + 6.0 * a.powi(2)) / l,
        1.0 - 4.0 * a + 3.0 * a.powi(2),
        (6.0 * a - 6.0 * a.powi(2)) / l,
        -2.0 * a + 3.0 * a.powi(2),
    ]
}

/// Second derivatives of the cable's shape functions with respect to x; 1/m² for positions, 1/m for slopes.
pub fn S_i_xx(x: f64, l: f64) -> [f64; 4] {
    let a = x / l;
    [(-6.0 + 12.0 * a) / l.powi(2), (-4.0 + 6.0 * a) / l, (6.0 - 12.0 * a) / l.powi(2), (-2.0 + 6.0 * a) / l]
}

/// Matrix S = \[S₁I S₂I S₃I S₄I\] with r = S e, or S_x, S_xx, of their functions.
fn row_of_identities(s: [f64; 4]) -> Matrix2x8 {
    Matrix2x8::from_fn(|row, column| if column % 2 == row { s[column / 2] } else { 0.0 })
}

/// Position of the cable's axis, m: r = S e.
pub fn r(x: f64, e: &Vector8, l: f64) -> Vector2<f64> {
    row_of_identities(S_i(x, l)) * e
}

/// Slope of the cable's axis: r_x = S_x e.
pub fn r_x(x: f64, e: &Vector8, l: f64) -> Vector2<f64> {
    row_of_identities(S_i_x(x, l)) * e
}

/// Second derivative of the cable's axis, 1/m: r_xx = S_xx e.
pub fn r_xx(x: f64, e: &Vector8, l: f64) -> Vector2<f64> {
    row_of_identities(S_i_xx(x, l)) * e
}

/// Elastic axial strain: ε = |r_x| − 1 − ε_T, with the thermal strain ε_T = αΔT.
pub fn epsilon(r_x: &Vector2<f64>, eps_T: f64) -> f64 {
    r_x.norm() - 1.0 - eps_T
}

/// Material measure of curvature, 1/m: κ = (r_x × r_xx)/|r_x|². Not finite where r_x = 0.
pub fn kappa(r_x: &Vector2<f64>, r_xx: &Vector2<f64>) -> f64 {
    r_x.perp(r_xx) / r_x.norm_squared()
}

/// Kinetic energy of the cable, J: T = ½ ėᵀ M ė.
pub fn T(M: &Matrix8, e_dot: &Vector8) -> f64 {
    0.5 * e_dot.dot(&(M * e_dot))
}

/// Mass matrix of the cable: M = ∫ ρA SᵀS dx, 8 × 8; kg between positions, kg m and kg m² with slopes.
///
/// `rho_A` is the mass per length, kg/m. Five points integrate its degree 6 exactly.
pub fn M(rho_A: f64, l: f64) -> Matrix8 {
    let mut M = Matrix8::zeros();
    for (x, dx) in axis_points(&GAUSS_5, l) {
        let S = row_of_identities(S_i(x, l));
        M += rho_A * S.transpose() * S * dx;
    }
    M
}

/// Strain energy of the cable, J: U = ½ ∫ EA ε² dx + ½ ∫ EI κ² dx, by five points and by three.
///
/// `EA` in N, `EI` in N m².
pub fn U(e: &Vector8, eps_T: f64, EA: f64, EI: f64, l: f64) -> f64 {
    let mut U = 0.0;
    for (x, dx) in axis_points(&GAUSS_5, l) {
        U += 0.5 * EA * epsilon(&r_x(x, e, l), eps_T).powi(2) * dx;
    }
    for (x, dx) in axis_points(&GAUSS_3, l) {
        U += 0.5 * EI * kappa(&r_x(x, e, l), &r_xx(x, e, l)).powi(2) * dx;
    }
    U
}

/// Gradient of the axial strain: ∂ε/∂e = S_xᵀ n, with n = r_x/|r_x|.
fn epsilon_e(x: f64, e: &Vector8, l: f64) -> Vector8 {
    row_of_identities(S_i_x(x, l)).tr_mul(&r_x(x, e, l).normalize())
}

/// Gradient of the curvature: ∂κ/∂e = \[S_xᵀ (−J r_xx) + S_xxᵀ J r_x\]/|r_x|² − 2κ S_xᵀ r_x/|r_x|².
///
/// J rotates by a right angle: a × b = (J a)·b = −a·(J b).
fn kappa_e(x: f64, e: &Vector8, l: f64) -> Vector8 {
    let (S_x, S_xx) = (row_of_identities(S_i_x(x, l)), row_of_identities(S_i_xx(x, l)));
    let (r_x, r_xx) = (S_x * e, S_xx * e);
    let cross_e = S_xx.tr_mul(&(J() * r_x)) - S_x.tr_mul(&(J() * r_xx));
    (cross_e - 2.0 * kappa(&r_x, &r_xx) * S_x.tr_mul(&r_x)) / r_x.norm_squared()
}

/// Rotation by a right angle, counterclockwise.
fn J() -> Matrix2<f64> {
    Matrix2::new(0.0, -1.0, 1.0, 0.0)
}

/// Elastic forces of the cable: Q_e = ∂U/∂e = ∫ EA ε ∂ε/∂e dx + ∫ EI κ ∂κ/∂e dx; N on positions, N m on slopes.
pub fn Q_e(e: &Vector8, eps_T: f64, EA: f64, EI: f64, l: f64) -> Vector8 {
    let mut Q_e = Vector8::zeros();
    for (x, dx) in axis_points(&GAUSS_5, l) {
        Q_e += EA * epsilon(&r_x(x, e, l), eps_T) * epsilon_e(x, e, l) * dx;
    }
    for (x, dx) in axis_points(&GAUSS_3, l) {
        Q_e += EI * kappa(&r_x(x, e, l), &r_xx(x, e, l)) * kappa_e(x, e, l) * dx;
    }
    Q_e
}

/// Tangent ∂Q_e/∂e of the cable, symmetric: ∫ EA \[∂ε/∂e ∂ε/∂eᵀ + ε ∂²ε/∂e²\] dx, and likewise with EI and κ.
///
/// With n = r_x/|r_x|
///
/// ∂²ε/∂e² = S_xᵀ (I − n nᵀ) S_x / |r_x|,
///
/// and, from κ |r_x|² = r_x × r_xx differentiated twice,
///
/// |r_x|² ∂²κ/∂e² = S_xxᵀ J S_x + (S_xxᵀ J S_x)ᵀ − 2κ S_xᵀS_x − 2 \[S_xᵀr_x ∂κ/∂eᵀ + ∂κ/∂e (S_xᵀr_x)ᵀ\].
pub fn tangent(e: &Vector8, eps_T: f64, EA: f64, EI: f64, l: f64) -> Matrix8 {
    let mut K = Matrix8::zeros();
    for (x, dx) in axis_points(&GAUSS_5, l) {
        let S_x = row_of_identities(S_i_x(x, l));
        let r_x = S_x * e;
        let n = r_x.normalize();
        let epsilon_e = epsilon_e(x, e, l);
        let epsilon_ee = S_x.tr_mul(&((Matrix2::identity() - n * n.transpose()) * S_x)) / r_x.norm();
        K += EA * (epsilon_e * epsilon_e.transpose() + epsilon(&r_x, eps_T) * epsilon_ee) * dx;
    }
    for (x, dx) in axis_points(&GAUSS_3, l) {
        let (S_x, S_xx) = (row_of_identities(S_i_x(x, l)), row_of_identities(S_i_xx(x, l)));
        let r_x = S_x * e;
        let (kappa, kappa_e) = (kappa(&r_x, &(S_xx * e)), kappa_e(x, e, l));
        let cross_ee = S_xx.tr_mul(&(J() * S_x));
        let product = S_x.tr_mul(&r_x) * kappa_e.transpose();
        let kappa_ee =
            (cross_ee + cross_ee.transpose() - 2.0 * kappa * S_x.tr_mul(&S_x) - 2.0 * (product + product.transpose()))
                / r_x.norm_squared();
        K += EI * (kappa_e * kappa_e.transpose() + kappa * kappa_ee) * dx;
    }
    K
}

/// Generalized force of gravity on the cable: Q_w = ∫ ρA Sᵀg dx, for g in m/s²; N on positions, N m on slopes.
pub fn Q_w_gravity(g: &Vector2<f64>, rho_A: f64, l: f64) -> Vector8 {
    let mut Q_w = Vector8::zeros();
    for (x, dx) in axis_points(&GAUSS_5, l) {
        Q_w += rho_A * row_of_identities(S_i(x, l)).tr_mul(g) * dx;
    }
    Q_w
}
