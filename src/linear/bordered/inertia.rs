//! Number of negative eigenvalues of a symmetric matrix, by L D Lᵀ (Sylvester's law of inertia).

use nalgebra::DVector;

use super::{Block, Bordered};
use crate::linear::{BandMatrix, BlockLayout};

/// Memory of an elimination, to be used again for the next matrix of the same layout.
#[derive(Debug, Default)]
pub struct InertiaMemory {
    /// What the blocks leave of the corner.
    corner: Option<BandMatrix>,
    factors: Factors,
    /// Columns L⁻¹ B of a block, one after the other.
    sides: Vec<f64>,
}

/// L D Lᵀ factors of a band matrix.
#[derive(Debug, Default)]
struct Factors {
    /// Rows of L, each of the band's width plus one: row i holds its columns up to i, flush right.
    lower: Vec<f64>,
    /// Pivots D.
    pivots: Vec<f64>,
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
        Some(negative + factors.of(corner, self.layout.border_size, self.layout.border_band, &mut [])?)
    }
}

impl Block {
    /// Eliminates the block's own unknowns and adds the remainder to the corner; returns the number of negative pivots.
    fn eliminate(
        &self,
        layout: &BlockLayout,
        border: usize,
        factors: &mut Factors,
        sides: &mut Vec<f64>,
        corner: &mut BandMatrix,
    ) -> Option<usize> {
        sides.clear();
        sides.extend_from_slice(self.right.as_slice());
        let negative = factors.of(&self.own, layout.size, layout.band, sides)?;
        let side = |n: usize| &sides[n * layout.size..(n + 1) * layout.size];
        for (m, a) in layout.touches.iter().enumerate() {
            for (n, b) in layout.touches.iter().enumerate() {
                let left: f64 = side(m).iter().zip(side(n)).zip(&factors.pivots).map(|((x, y), d)| x * y / d).sum();
                corner.add(a - border, b - border, -left);
            }
        }
        Some(negative)
    }
}

impl Factors {
    /// Factorises L D Lᵀ and replaces the columns `sides` by L⁻¹ `sides`; returns the number of negative pivots.
    fn of(&mut self, matrix: &BandMatrix, size: usize, band: usize, sides: &mut [f64]) -> Option<usize> {
        let Factors { lower, pivots } = self;
        let width = band + 1;
        lower.clear();
        lower.resize(size * width, 0.0);
        pivots.clear();
        for i in 0..size {
            let first = i.saturating_sub(band);
            let (done, rest) = lower.split_at_mut(i * width);
            // Columns first … i.
            let row = &mut rest[width - (i - first + 1)..width];
            matrix.row(i).filter(|(column, _)| *column <= i).for_each(|(column, value)| row[column - first] = value);
            // row[j] becomes L[i, j] · d[j], and the last entry d[i].
            for j in first..i {
                let from = first.max(j.saturating_sub(band));
                // Columns from … j − 1 of row j, whose last entry is that of column j.
                let of_j = &done[(j + 1) * width - 1 - (j - from)..(j + 1) * width - 1];
                let known: f64 = row[from - first..j - first].iter().zip(of_j).map(|(a, b)| a * b).sum();
                row[j - first] -= known;
            }
            let mut pivot = row[i - first];
            for (entry, d) in row.iter_mut().zip(&pivots[first..i]) {
                let scaled = *entry / d;
                pivot -= *entry * scaled;
                *entry = scaled;
            }
            if pivot == 0.0 || !pivot.is_finite() {
                return None;
            }
            row[i - first] = 1.0;
            for side in sides.chunks_mut(size) {
                let known: f64 = row[..i - first].iter().zip(&side[first..i]).map(|(a, b)| a * b).sum();
                side[i] -= known;
            }
            pivots.push(pivot);
        }
        Some(pivots.iter().filter(|pivot| **pivot < 0.0).count())
    }
}
