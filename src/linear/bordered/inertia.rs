//! Number of negative eigenvalues of a symmetric matrix, by L D Lᵀ (Sylvester's law of inertia).

use super::{Block, Bordered};
use crate::linear::ldlt::Ldlt;
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
        let of_corner =
            Ldlt::default().factorize(&corner, self.layout.border_size, self.layout.border_band, &mut [])?;
        Some(negative + of_corner)
    }
}

impl Block {
    /// Eliminates the block's own unknowns and adds the remainder to the corner; returns the number of negative pivots.
    fn eliminate(&self, layout: &BlockLayout, border: usize, corner: &mut BandMatrix) -> Option<usize> {
        let mut sides: Vec<Vec<f64>> =
            self.right.column_iter().map(|column| column.iter().copied().collect()).collect();
        let mut ldlt = Ldlt::default();
        let negative = ldlt.factorize(&self.own, layout.size, layout.band, &mut sides)?;
        for (a, side_a) in layout.touches.iter().zip(&sides) {
            for (b, side_b) in layout.touches.iter().zip(&sides) {
                let left: f64 = side_a.iter().zip(side_b).zip(ldlt.pivots()).map(|((x, y), pivot)| x * y / pivot).sum();
                corner.add(a - border, b - border, -left);
            }
        }
        Some(negative)
    }
}
