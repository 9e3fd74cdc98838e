//! Rows of the constraint equations.

use nalgebra::DVector;

/// Row of Φ(q) = 0: Σ weight · displacement, and the multiplier that enforces it.
#[derive(Clone, Debug)]
pub struct ConstraintRow {
    pub multiplier: usize,
    /// Rod, unknown and weight of each term.
    pub terms: Vec<(usize, usize, f64)>,
}

impl ConstraintRow {
    /// Value of the row of Φ_q x.
    pub fn apply(&self, x: &DVector<f64>) -> f64 {
        self.terms.iter().map(|&(_, unknown, weight)| weight * x[unknown]).sum()
    }
}
