//! Equation (22): the motion of one element.

use super::force::Matrix14;
use super::shape::Vector14;

/// (22) What is left of M ë + Q_e(ΔT) = Q_w: the residual M ë + Q_e − Q_w, zero on a motion; N and N m.
pub fn residual(M: &Matrix14, e_ddot: &Vector14, Q_e: &Vector14, Q_w: &Vector14) -> Vector14 {
    M * e_ddot + Q_e - Q_w
}

/// (22) solved for the acceleration: ë = M⁻¹ (Q_w − Q_e); m/s² for positions, 1/s² for slopes.
///
/// By Cholesky's factors, whose accuracy does not suffer from the different units of positions and slopes. `None`
/// where M is not positive definite.
pub fn acceleration(M: &Matrix14, Q_e: &Vector14, Q_w: &Vector14) -> Option<Vector14> {
    Some(M.cholesky()?.solve(&(Q_w - Q_e)))
}
