//! Rows of the constraint equations.

use nalgebra::DVector;

/// A row of Φ(q) = 0: Σ weight · displacement, the multiplier that keeps it, and whose unknowns it holds.
#[derive(Clone, Debug)]
pub struct ConstraintRow {
    pub multiplier: usize,
    /// Rod, unknown, weight.
    pub terms: Vec<(usize, usize, f64)>,
}

impl ConstraintRow {
    /// Its Φ_q x.
    pub fn of(&self, x: &DVector<f64>) -> f64 {
        self.terms.iter().map(|&(_, unknown, weight)| weight * x[unknown]).sum()
    }
}
