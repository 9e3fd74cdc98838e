//! Stress-free deviation of an element whose strains are quadratic in its coordinates.
//!
//! Strains are measured from those of the deviated shape: ε = E(e) − E_dev − ε_T. The stress D E_dev that is taken off does not
//! change in time. With E(e) = ½(eᵀS e − δ) and the constant matrix A = ∫ Σ (D E_dev)ₙ ∂²Eₙ/∂e² dV, which is K of (20) at the
//! deviated coordinates without heat,
//!
//! U = U₀ − ½ (eᵀA e − e₀ᵀA e₀) + ε_T · ∫ D E_dev dV + ½ ∫ E_devᵀ D E_dev dV,  Q_e = Q_e0 − A e,  ∂Q_e/∂e = K_0 − A,
//!
//! where U₀, Q_e0, K_0 are those of the straight element (the law of (16) as well as others: A has the element's own moduli).
//! Green–Lagrange strains do not change with a rotation of the moving rod, and so nor does U: the deviated element can be moved
//! rigidly without a force. The mean force of a step with averaged stresses is that of the straight element less A e in the
//! middle of the step, whose work is exactly the change of −½ eᵀA e. `oracle/proofs/imperfection.py` proves each of these.

#![allow(non_snake_case)] // A is the matrix of the derivation.

use nalgebra::{SMatrix, SVector};

/// Terms that a deviation adds to an element with `N` coordinates.
#[derive(Clone, Debug)]
pub struct Deviation<const N: usize> {
    /// A, N/m between positions.
    A: SMatrix<f64, N, N>,
    /// A e₀ of the straight element: N on positions, N m on slopes.
    A_e_0: SVector<f64, N>,
    /// ∫ D E_dev dV along and across, N m.
    stress: [f64; 2],
    /// ½ ∫ E_devᵀ D E_dev dV, J.
    energy: f64,
}

impl<const N: usize> Deviation<N> {
    /// Deviation from A, the initial coordinates, ∫ D E_dev dV (along, across) and ½ ∫ E_devᵀ D E_dev dV.
    pub fn new(A: SMatrix<f64, N, N>, e_0: &SVector<f64, N>, stress: [f64; 2], energy: f64) -> Deviation<N> {
        Deviation { A, A_e_0: A * e_0, stress, energy }
    }

    /// Matrix A, which the tangent has less.
    pub fn stiffness(&self) -> &SMatrix<f64, N, N> {
        &self.A
    }

    /// Additional force −A (e₀ + u).
    pub fn force(&self, u: &SVector<f64, N>) -> SVector<f64, N> {
        -(self.A * u + self.A_e_0)
    }

    /// Additional strain energy at a thermal strain (along, across), J.
    pub fn energy(&self, u: &SVector<f64, N>, [along, across]: [f64; 2]) -> f64 {
        let of_strains = 0.5 * u.dot(&(self.A * u)) + u.dot(&self.A_e_0);
        self.energy - of_strains + self.stress[0] * along + self.stress[1] * across
    }

    /// Additional energy supplied by heating, J: for a change of the thermal strain (along, across).
    pub fn heating_work(&self, [along, across]: [f64; 2]) -> f64 {
        self.stress[0] * along + self.stress[1] * across
    }
}
