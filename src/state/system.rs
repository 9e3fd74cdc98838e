//! A structure in one state: the terms of (23), and the values of its equations.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{DMatrix, DVector};

use super::entries::rows;
use crate::equations::motion;

/// State of a structure: the terms of (23), for n coordinates and c constraints. SI units.
///
/// [`evaluate_system`] gives the values of (23) for it.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemState {
    /// Mass matrix, n × n.
    pub m: DMatrix<f64>,
    /// Accelerations q̈, n.
    pub q_ddot: DVector<f64>,
    /// Elastic forces k(ΔT) q, n.
    pub kq: DVector<f64>,
    /// Derivative of the constraints ∂Φ/∂q, c × n.
    pub Phi_q: DMatrix<f64>,
    /// Multipliers λ, c.
    pub lambda: DVector<f64>,
    /// External forces, n.
    pub f: DVector<f64>,
}

/// Value of a `quantity` of (23) in `equations/contents.rs` for the state of a structure.
///
/// `None` for an unknown quantity, where the printed form is not defined, and where the matrix of (23) is singular.
///
/// ```
/// use ancf::nalgebra::{DMatrix, DVector};
/// use ancf::internals::state::{SystemState, evaluate_system};
///
/// // A mass of 2 kg in the plane, held in y, under its weight.
/// let state = SystemState {
///     m: DMatrix::identity(2, 2) * 2.0,
///     q_ddot: DVector::zeros(2),
///     kq: DVector::zeros(2),
///     Phi_q: DMatrix::from_row_slice(1, 2, &[0.0, 1.0]),
///     lambda: DVector::from_vec(vec![-19.62]),
///     f: DVector::from_vec(vec![0.0, -19.62]),
/// };
/// assert_eq!(evaluate_system("23.residual", &state), Some(vec![0.0, 0.0]));
/// assert_eq!(evaluate_system("23.lambda", &state), Some(vec![-19.62]));
/// assert_eq!(evaluate_system("23.residual/printed", &state), None); // Φ_q λ: 1 × 2 times 1
/// ```
///
/// # Panics
/// Unless the shapes agree.
pub fn evaluate_system(quantity: &str, state: &SystemState) -> Option<Vec<f64>> {
    let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = state;
    let force = || motion::constraint_force(Phi_q, lambda);
    let force_printed = || motion::constraint_force_printed(Phi_q, lambda);
    let residual = |force: &DVector<f64>| rows(&motion::system_residual(m, q_ddot, kq, force, f));
    match quantity {
        "23.constraint_force" => Some(rows(&force())),
        "23.constraint_force/printed" => Some(rows(&force_printed()?)),
        "23.residual" => Some(residual(&force())),
        "23.residual/printed" => Some(residual(&force_printed()?)),
        "23.acceleration" => Some(rows(&motion::system_acceleration(m, kq, Phi_q, f)?.0)),
        "23.lambda" => Some(rows(&motion::system_acceleration(m, kq, Phi_q, f)?.1)),
        _ => None,
    }
}
