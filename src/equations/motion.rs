//! Equation (22), the motion of one element, and (23), that of elements held together by constraints.
//!
//! (22) has arrays of fixed size, (23) vectors of the structure's n coordinates q and its c constraints Φ(q) = 0.
//!
//! Derived step by step: `oracle/DERIVATION.md#6-motion`, there (22) `#22-one-element`, (23) and E4
//! `#23-elements-held-together`.

use super::force::Matrix14;
use super::shape::Vector14;
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

/// (22) What is left of M ë + Q_e(ΔT) = Q_w: the residual M ë + Q_e − Q_w, zero on a motion; N and N m.
pub fn residual(M: &Matrix14, e_ddot: &Vector14, Q_e: &Vector14, Q_w: &Vector14) -> Vector14 {
    M * e_ddot + Q_e - Q_w
}

/// (22) solved for the acceleration: ë = M⁻¹ (Q_w − Q_e); m/s² for positions, 1/s² for slopes.
///
/// By Cholesky's factors, whose accuracy does not suffer from the different units of positions and slopes. `None`
/// where M is not positive definite. N is 14, or 8 for the [`cable`](super::cable) element.
pub fn acceleration<const N: usize>(
    M: &SMatrix<f64, N, N>,
    Q_e: &SVector<f64, N>,
    Q_w: &SVector<f64, N>,
) -> Option<SVector<f64, N>> {
    Some(M.cholesky()?.solve(&(Q_w - Q_e)))
}

/// (23) The constraints' generalized force Φ_qᵀ λ, n numbers, N and N m; it stands on the left, beside k q.
///
/// Its work δqᵀ Φ_qᵀ λ = λᵀ (Φ_q δq) is zero for every δq that the constraints allow, Φ_q δq = 0, as that of an ideal pin is.
/// Φ_q is ∂Φ/∂q, c × n.
///
/// # Panics
/// Unless λ has c numbers.
pub fn constraint_force(Phi_q: &DMatrix<f64>, lambda: &DVector<f64>) -> DVector<f64> {
    Phi_q.transpose() * lambda
}

/// (23) **as printed** (E4): Φ_q λ, without the transpose.
///
/// c × n times c: `None` unless there are as many constraints as coordinates; and then it does work on motions that the
/// constraints allow.
///
/// # Panics
/// Unless λ has c numbers.
pub fn constraint_force_printed(Phi_q: &DMatrix<f64>, lambda: &DVector<f64>) -> Option<DVector<f64>> {
    Phi_q.is_square().then(|| Phi_q * lambda)
}

/// (23) What is left of m q̈ + k(ΔT) q + Φ_qᵀ λ = f, zero on a motion; n numbers, N and N m.
///
/// `kq` is k(ΔT) q, the elements' Q_e of (19) added up; `Phi_q_lambda` the constraints' force, [`constraint_force`], or what is
/// printed for it.
pub fn system_residual(
    m: &DMatrix<f64>,
    q_ddot: &DVector<f64>,
    kq: &DVector<f64>,
    Phi_q_lambda: &DVector<f64>,
    f: &DVector<f64>,
) -> DVector<f64> {
    m * q_ddot + kq + Phi_q_lambda - f
}

/// (23) solved for the accelerations q̈ and the multipliers λ that it begins with:
///
/// ```text
/// ⎡ m    Φ_qᵀ ⎤ ⎡ q̈ ⎤   ⎡ f − k q ⎤
/// ⎣ Φ_q   0   ⎦ ⎣ λ ⎦ = ⎣    0    ⎦
/// ```
///
/// The second row is Φ̈ = 0 for constraints that are linear in q and do not change in time, as pins and supports are.
/// `None` where the matrix is singular: m has no inverse, or a constraint is there twice.
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
