//! L D Lᵀ factors of a symmetric band matrix without row swaps: the signs of D are those of the eigenvalues (Sylvester's
//! law of inertia).

use super::BandMatrix;

/// L D Lᵀ factors, or memory for them.
#[derive(Clone, Debug, Default)]
pub struct Ldlt {
    /// Row i of L, from column i − band on; columns before the first one are zero.
    lower: Vec<f64>,
    pivots: Vec<f64>,
    /// Row that is being eliminated.
    row: Vec<f64>,
}

impl Ldlt {
    /// Diagonal D.
    pub fn pivots(&self) -> &[f64] {
        &self.pivots
    }

    /// Factorises a matrix and replaces the columns `sides` by L⁻¹ `sides`; returns the number of negative pivots. `None` at a pivot
    /// that is zero or not a number.
    pub fn factorize(&mut self, matrix: &BandMatrix, size: usize, band: usize, sides: &mut [f64]) -> Option<usize> {
        let Ldlt { lower, pivots, row } = self;
        lower.clear();
        lower.resize(size * band, 0.0);
        pivots.clear();
        row.clear();
        row.resize(band, 0.0);
        for i in 0..size {
            let first = i.saturating_sub(band);
            let mut pivot = 0.0;
            for (column, value) in matrix.row(i).take_while(|(column, _)| *column <= i) {
                match row.get_mut(column + band - i) {
                    Some(entry) => *entry = value,
                    None => pivot = value,
                }
            }
            // Entry j becomes L[i, j] · d[j].
            for j in first..i {
                let own = j + band - i;
                // Over the columns that both rows reach.
                let done = dot(&row[..own], &lower[(j + 1) * band - own..][..own]);
                row[own] -= done;
            }
            for j in first..i {
                let entry = &mut row[j + band - i];
                let scaled = *entry / pivots[j];
                pivot -= *entry * scaled;
                *entry = scaled;
            }
            if pivot == 0.0 || !pivot.is_finite() {
                return None;
            }
            for side in sides.chunks_mut(size) {
                side[i] -= dot(&row[first + band - i..], &side[first..i]);
            }
            pivots.push(pivot);
            lower[i * band..][..band].copy_from_slice(row);
            row.fill(0.0);
        }
        Some(pivots.iter().filter(|pivot| **pivot < 0.0).count())
    }
}

/// Scalar product; four sums at a time, so that no addition waits for the one before.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_last), (b, b_last)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        sums.iter_mut().zip(a.iter().zip(b)).for_each(|(sum, (a, b))| *sum += a * b);
    }
    sums.iter().sum::<f64>() + a_last.iter().zip(b_last).map(|(a, b)| a * b).sum::<f64>()
}
