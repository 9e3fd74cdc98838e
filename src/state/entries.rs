//! The entries of a matrix as a list.

use nalgebra::{Dim, Matrix, RawStorage};

/// The entries of a matrix, row by row.
pub(super) fn rows<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(matrix: &Matrix<f64, R, C, S>) -> Vec<f64> {
    matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect()
}
