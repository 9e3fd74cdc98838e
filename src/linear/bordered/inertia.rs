//! Number of negative eigenvalues of a symmetric matrix, by L D Lᵀ (Sylvester's law of inertia).

use nalgebra::DVector;

use super::{Block, Bordered};
use crate::linear::ldlt::Ldlt;
use crate::linear::{BandMatrix, BlockLayout};

/// Memory of an elimination, to be used again for the next matrix of the same layout.
#[derive(Debug, Default)]
pub struct InertiaMemory {
    /// What the blocks leave of the corner.
    corner: Option<BandMatrix>,
    factors: Ldlt,
    /// Columns L⁻¹ B of a block, one after the other.
    sides: Vec<f64>,
}

impl Bordered {
    /// Number of negative eigenvalues, as [`negative_eigenvalues`](Bordered::negative_eigenvalues). Where that meets a
    /// zero pivot, the larger of the counts with `shift` added to the diagonal and taken from it: an eigenvalue within
    /// the shift of zero counts as negative. The matrix is changed then.
    pub fn negative_eigenvalues_near(&mut self, shift: &DVector<f64>, memory: &mut InertiaMemory) -> Option<usize> {
        let exact = self.negative_eigenvalues(memory);
        if exact.is_some() {
            return exact;
        }
        let mut shifted = |factor| {
            self.add_diagonal(factor, shift);
            self.negative_eigenvalues(memory)
        };
        let counts = [shifted(1.0), shifted(-2.0)];
        counts.into_iter().flatten().max()
    }

    /// Adds `factor` · `diagonal` to the diagonal.
    fn add_diagonal(&mut self, factor: f64, diagonal: &DVector<f64>) {
        for (block, layout) in self.blocks.iter_mut().zip(&self.layout.blocks) {
            (0..layout.size).for_each(|i| block.own.add(i, i, factor * diagonal[layout.first + i]));
        }
        (0..self.layout.border_size).for_each(|i| self.corner.add(i, i, factor * diagonal[self.layout.border + i]));
    }

    /// Number of negative eigenvalues of this matrix, which must be symmetric. `None` where elimination without row
    /// swaps meets a pivot that is zero or not a number.
    pub fn negative_eigenvalues(&self, memory: &mut InertiaMemory) -> Option<usize> {
        let InertiaMemory { corner, factors, sides } = memory;
        let corner = match corner {
            Some(corner) => {
                corner.copy_from(&self.corner);
                corner
            }
            none => none.insert(self.corner.clone()),
        };
        let mut negative = 0;
        for (block, layout) in self.blocks.iter().zip(&self.layout.blocks) {
            negative += block.eliminate(layout, self.layout.border, factors, sides, corner)?;
        }
        Some(negative + factors.factorize(corner, self.layout.border_size, self.layout.border_band, &mut [])?)
    }
}

impl Block {
    /// Eliminates the block's own unknowns and adds the remainder to the corner; returns the number of negative pivots.
    fn eliminate(
        &self,
        layout: &BlockLayout,
        border: usize,
        factors: &mut Ldlt,
        sides: &mut Vec<f64>,
        corner: &mut BandMatrix,
    ) -> Option<usize> {
        sides.clear();
        sides.extend_from_slice(self.right.as_slice());
        let negative = factors.factorize(&self.own, layout.size, layout.band, sides)?;
        let side = |n: usize| &sides[n * layout.size..(n + 1) * layout.size];
        for (m, a) in layout.touches.iter().enumerate() {
            for (n, b) in layout.touches.iter().enumerate() {
                let left: f64 = side(m).iter().zip(side(n)).zip(factors.pivots()).map(|((x, y), d)| x * y / d).sum();
                corner.add(a - border, b - border, -left);
            }
        }
        Some(negative)
    }
}
