//! Number of negative eigenvalues of a symmetric matrix, by L D Lᵀ (Sylvester's law of inertia).

use super::{Block, Bordered};
use crate::linear::{BandMatrix, BlockLayout};

impl Bordered {
    /// Number of negative eigenvalues of this matrix, which must be symmetric. `None` where elimination without row
    /// swaps meets a pivot that is zero or not a number.
    pub fn negative_eigenvalues(&self) -> Option<usize> {
        let mut corner = self.corner.clone();
        let mut negative = 0;
        for (block, layout) in self.blocks.iter().zip(&self.layout.blocks) {
            negative += block.eliminate(layout, self.layout.border, &mut corner)?;
        }
        let (of_corner, _) = factorize(&corner, self.layout.border_size, self.layout.border_band, &mut [])?;
        Some(negative + of_corner)
    }
}

impl Block {
    /// Eliminates the block's own unknowns and adds the remainder to the corner; returns the number of negative pivots.
    fn eliminate(&self, layout: &BlockLayout, border: usize, corner: &mut BandMatrix) -> Option<usize> {
        let mut sides: Vec<Vec<f64>> =
            self.right.column_iter().map(|column| column.iter().copied().collect()).collect();
        let (negative, pivots) = factorize(&self.own, layout.size, layout.band, &mut sides)?;
        for (a, side_a) in layout.touches.iter().zip(&sides) {
            for (b, side_b) in layout.touches.iter().zip(&sides) {
                let left: f64 = side_a.iter().zip(side_b).zip(&pivots).map(|((x, y), pivot)| x * y / pivot).sum();
                corner.add(a - border, b - border, -left);
            }
        }
        Some(negative)
    }
}

/// Factorises L D Lᵀ and replaces `sides` by L⁻¹ `sides`; returns the number of negative pivots, and the pivots.
fn factorize(matrix: &BandMatrix, size: usize, band: usize, sides: &mut [Vec<f64>]) -> Option<(usize, Vec<f64>)> {
    // Row i of L, from column i − band on.
    let mut lower: Vec<Vec<f64>> = Vec::with_capacity(size);
    let mut pivots: Vec<f64> = Vec::with_capacity(size);
    for i in 0..size {
        let first = i.saturating_sub(band);
        let mut row = vec![0.0; i - first + 1];
        matrix.row(i).filter(|(column, _)| *column <= i).for_each(|(column, value)| row[column - first] = value);
        // row[j] becomes L[i, j] · d[j], and the last entry d[i].
        for j in first..i {
            let first_j = j.saturating_sub(band);
            let from = first.max(first_j);
            let done: f64 = (from..j).map(|k| row[k - first] * lower[j][k - first_j]).sum();
            row[j - first] -= done;
        }
        let mut pivot = row[i - first];
        for j in first..i {
            let scaled = row[j - first] / pivots[j];
            pivot -= row[j - first] * scaled;
            row[j - first] = scaled;
        }
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        for side in sides.iter_mut() {
            let done: f64 = (first..i).map(|j| row[j - first] * side[j]).sum();
            side[i] -= done;
        }
        pivots.push(pivot);
        lower.push(row);
    }
    Some((pivots.iter().filter(|pivot| **pivot < 0.0).count(), pivots))
}
