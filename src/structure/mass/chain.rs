//! A rod's free nodal vectors, solved for with the mass matrix along the chain of its nodes.

use std::fmt::Debug;

use crate::linear::SingularAt;
use crate::structure::node_dofs::NodeDofs;

/// Factors of M over the free nodal vectors of a rod.
pub(in crate::structure) trait MassChain: Debug + Send + Sync {
    /// Solves in place, for the unknowns that the chain was made with; others stay as they are.
    fn solve(&self, b: &mut [f64]);
}

/// Reciprocal of a pivot, which has to be positive.
pub(super) fn inverse(pivot: f64, vector: usize) -> Result<f64, SingularAt> {
    if pivot > 0.0 && pivot.is_finite() { Ok(1.0 / pivot) } else { Err(SingularAt(vector)) }
}

/// Power of two that takes a mass near 1. Masses are factorised times it, so that only an inverse can leave the range of numbers.
pub(super) fn scale_of(mass: f64) -> f64 {
    if mass > 0.0 && mass.is_finite() { (-mass.log2().floor()).min(1023.0).exp2() } else { 1.0 }
}

/// Inverse of a symmetric matrix \[a b; b d\] of the vectors `vector` and the next: its own a, b and d.
pub(super) fn inverse_of_two([a, b, d]: [f64; 3], vector: usize) -> Result<[f64; 3], SingularAt> {
    let own_a = inverse(a, vector)?;
    let multiplier = b * own_a;
    let own_d = inverse(d - multiplier * b, vector + 1)?;
    Ok([own_a + multiplier * multiplier * own_d, -multiplier * own_d, own_d])
}

/// Whether a vector of the chain is free.
pub(super) fn is_free(vector: &NodeDofs) -> bool {
    vector.unknowns[0].is_some()
}
