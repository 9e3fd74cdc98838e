//! The matrix S_c of (11), whose quadratic form depends on its symmetric part alone.

/// S_c as a program answers it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Metrics {
    /// As (11) defines it; not symmetric.
    #[default]
    AsPrinted,
    /// ½ (S_c + S_cᵀ).
    Symmetrised,
}

/// ½ (A − Aᵀ) of a square matrix, row by row.
pub(super) fn skew(matrix: &[f64]) -> Vec<f64> {
    let n = matrix.len().isqrt();
    let at = |row: usize, column: usize| matrix.get(row * n + column).copied().unwrap_or(f64::NAN);
    (0..matrix.len()).map(|entry| 0.5 * (at(entry / n, entry % n) - at(entry % n, entry / n))).collect()
}
