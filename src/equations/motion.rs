//! Equations (22), the motion of one element, and (23), the motion of elements held together by constraints.
//!
//! (22) works on arrays of fixed size, (23) on a structure's n coordinates q and its c constraints Φ(q) = 0.
//!
//! Derived step by step: `oracle/DERIVATION.md#6-motion`, there (22) `#22-one-element`, (23) and E4
//! `#23-elements-held-together`, a first step in numbers `#9-in-numbers-the-first-step-of-a-pendulum`.

use super::element::Matrix14;
use super::shape::Vector14;
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

/// (22) Residual of the motion of one element: M ë + Q_e(ΔT) − Q_w, zero on a motion; N on positions, N m on slopes.
pub fn residual(M: &Matrix14, e_ddot: &Vector14, Q_e: &Vector14, Q_w: &Vector14) -> Vector14 {
    M * e_ddot + Q_e - Q_w
}

/// (22) Acceleration of one element: ë = M⁻¹ (Q_w − Q_e); m/s² for positions, 1/s² for slopes.
///
/// By Cholesky factors, whose accuracy does not suffer from the different units of positions and slopes. `None`
/// where M is not positive definite. N is 14, or 8 for the [`cable`](super::cable) element.
///
/// ```
/// # #![allow(non_snake_case)]
/// use ancf::equations::element::Element;
/// use ancf::equations::{inertia, motion, shape};
/// use ancf::nalgebra::Vector2;
///
/// // A free element falls without strain: every point is accelerated by g.
/// let (element, rho) = (Element::straight(2.0, 0.1, 0.05, 0.3), 7200.0);
/// let g = Vector2::new(0.0, -9.81);
/// let Q_w = inertia::Q_w_gravity(&g, rho, &element);
/// let e_ddot = motion::acceleration(&inertia::M(rho, &element), &shape::Vector14::zeros(), &Q_w).unwrap();
/// assert!((shape::r(0.7, 0.02, &e_ddot, element.l) - g).amax() < 1e-10);
/// ```
pub fn acceleration<const N: usize>(
    M: &SMatrix<f64, N, N>,
    Q_e: &SVector<f64, N>,
    Q_w: &SVector<f64, N>,
) -> Option<SVector<f64, N>> {
    Some(M.cholesky()?.solve(&(Q_w - Q_e)))
}

/// (23) Generalized force of the constraints, **consistent**: Φ_qᵀ λ, n entries; N on positions, N m on slopes.
///
/// It stands on the left of (23), beside k q. Φ_q is ∂Φ/∂q, c × n. The force does no work where the constraints are kept, like
/// that of an ideal pin: δqᵀ Φ_qᵀ λ = λᵀ (Φ_q δq) = 0 for every δq with Φ_q δq = 0.
///
/// # Panics
/// Unless λ has c numbers.
pub fn constraint_force(Phi_q: &DMatrix<f64>, lambda: &DVector<f64>) -> DVector<f64> {
    Phi_q.transpose() * lambda
}

/// (23) Generalized force of the constraints **as printed** (E4): Φ_q λ, without the transpose.
///
/// A c × n matrix times c multipliers: `None` unless c = n. Where it exists, it does work on motions that the constraints
/// allow.
///
/// # Panics
/// Unless λ has c numbers.
pub fn constraint_force_printed(Phi_q: &DMatrix<f64>, lambda: &DVector<f64>) -> Option<DVector<f64>> {
    Phi_q.is_square().then(|| Phi_q * lambda)
}

/// (23) Residual of the motion of a structure: m q̈ + k(ΔT) q + Φ_qᵀ λ − f, n entries, zero on a motion; N and N m.
///
/// `kq` is k(ΔT) q, the assembled Q_e of (19). `Phi_q_lambda` is the force of the constraints: [`constraint_force`], or
/// [`constraint_force_printed`] for the printed form.
///
/// # Panics
/// Unless the shapes agree.
pub fn system_residual(
    m: &DMatrix<f64>,
    q_ddot: &DVector<f64>,
    kq: &DVector<f64>,
    Phi_q_lambda: &DVector<f64>,
    f: &DVector<f64>,
) -> DVector<f64> {
    m * q_ddot + kq + Phi_q_lambda - f
}

/// (23) Accelerations q̈ (m/s², 1/s²) and multipliers λ (N for pins) of a structure, from
///
/// ```text
/// ⎡ m    Φ_qᵀ ⎤ ⎡ q̈ ⎤   ⎡ f − k q ⎤
/// ⎣ Φ_q   0   ⎦ ⎣ λ ⎦ = ⎣    0    ⎦
/// ```
///
/// The second row is Φ̈ = 0 for constraints that are linear in q and constant in time, as pins and supports are.
/// `None` where the matrix is singular: m has no inverse, or a constraint occurs twice.
///
/// # Panics
/// Unless the shapes agree.
pub fn system_acceleration(
    m: &DMatrix<f64>,
    kq: &DVector<f64>,
    Phi_q: &DMatrix<f64>,
    f: &DVector<f64>,
) -> Option<(DVector<f64>, DVector<f64>)> {
    let (n, c) = (m.nrows(), Phi_q.nrows());
    let mut matrix = DMatrix::zeros(n + c, n + c);
    matrix.view_mut((0, 0), (n, n)).copy_from(m);
    matrix.view_mut((0, n), (n, c)).copy_from(&Phi_q.transpose());
    matrix.view_mut((n, 0), (c, n)).copy_from(Phi_q);
    let mut load = DVector::zeros(n + c);
    load.rows_mut(0, n).copy_from(&(f - kq));
    let solution = matrix.lu().solve(&load)?;
    Some((solution.rows(0, n).into_owned(), solution.rows(n, c).into_owned()))
}
