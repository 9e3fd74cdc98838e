//! Matrix of independent bands that are coupled by a border:
//!
//! ```text
//! ⎡ A₁            B₁ ⎤
//! ⎢     A₂        B₂ ⎥
//! ⎢         …     …  ⎥
//! ⎣ C₁  C₂  …     D  ⎦
//! ```
//!
//! A block is a rod; the border holds what rods share, pinned points or multipliers. Each block is eliminated by itself
//! and leaves its part of a small band matrix D − Σ Cᵢ Aᵢ⁻¹ Bᵢ. The cost is linear in the number of rods and of their
//! elements.

mod block_mut;
mod inertia;

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

pub use block_mut::BlockMut;
pub use inertia::InertiaMemory;

use super::{BandLu, BandMatrix, BlockLayout, Layout, SingularAt, flush_negligible};

/// Bordered block-diagonal matrix.
#[derive(Clone, Debug)]
pub struct Bordered {
    layout: Arc<Layout>,
    blocks: Vec<Block>,
    /// Corner D, over all unknowns of the border.
    corner: BandMatrix,
}

#[derive(Clone, Debug)]
struct Block {
    /// Band matrix A.
    own: BandMatrix,
    /// Matrix B: rows of the block, columns of the border unknowns that it touches.
    right: DMatrix<f64>,
    /// Transpose Cᵀ, shaped like B and stored by columns, so that a column is a row of C.
    below: DMatrix<f64>,
}

/// LU factors of a [`Bordered`] matrix.
#[derive(Clone, Debug)]
pub struct BorderedLu {
    layout: Arc<Layout>,
    blocks: Vec<BlockLu>,
    corner: BandLu,
    scales: Option<Scales>,
}

#[derive(Clone, Debug)]
struct BlockLu {
    own: BandLu,
    /// Product A⁻¹ B.
    right: DMatrix<f64>,
    /// Transpose Cᵀ.
    below: DMatrix<f64>,
}

/// Scale factors of rows and columns of an equilibrated matrix.
#[derive(Clone, Debug)]
struct Scales {
    rows: DVector<f64>,
    columns: DVector<f64>,
}

impl Bordered {
    /// Zero matrix.
    pub fn zeros(layout: &Arc<Layout>) -> Bordered {
        Bordered {
            blocks: layout.blocks.iter().map(Block::zeros).collect(),
            corner: BandMatrix::zeros(layout.border_size, layout.border_band),
            layout: layout.clone(),
        }
    }

    /// Sets every entry to zero.
    pub fn clear(&mut self) {
        for Block { own, right, below } in &mut self.blocks {
            own.clear();
            right.fill(0.0);
            below.fill(0.0);
        }
        self.corner.clear();
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.layout.size()
    }

    /// Access to block `number`, for adding entries.
    pub fn block(&mut self, number: usize) -> BlockMut<'_> {
        BlockMut {
            border: self.layout.border,
            layout: &self.layout.blocks[number],
            block: &mut self.blocks[number],
            corner: &mut self.corner,
        }
    }

    /// Dense copy, for looking at small matrices.
    pub fn dense(&self) -> DMatrix<f64> {
        let mut dense = DMatrix::zeros(self.size(), self.size());
        self.each(|row, column, value| dense[(row, column)] = value);
        dense
    }

    /// Adds `factor` · `other`, a matrix of the same layout.
    pub fn add_scaled(&mut self, factor: f64, other: &Bordered) {
        for (block, other) in self.blocks.iter_mut().zip(&other.blocks) {
            block.own.add_scaled(factor, &other.own);
            block.right.zip_apply(&other.right, |a, b| *a += factor * b);
            block.below.zip_apply(&other.below, |a, b| *a += factor * b);
        }
        self.corner.add_scaled(factor, &other.corner);
    }

    /// Product with a vector.
    pub fn product(&self, x: &DVector<f64>) -> DVector<f64> {
        let mut product = DVector::zeros(self.size());
        self.each(|row, column, value| product[row] += value * x[column]);
        product
    }

    /// LU factors: each block, then the remaining corner.
    ///
    /// # Errors
    /// Unknown of a pivot that is zero or not a number.
    pub fn lu(self) -> Result<BorderedLu, SingularAt> {
        let Bordered { layout, blocks, corner } = self;
        BorderedLu::of(&layout, corner, blocks)
    }

    /// LU factors after scaling rows, then columns, to a largest entry near 1. Scales are powers of two, so that
    /// scaling causes no rounding. One pass preserves the digits as long as columns of a block differ by at most 10⁸;
    /// those of a rod are slopes and positions, which differ by its slenderness.
    ///
    /// # Errors
    /// Those of [`lu`](Bordered::lu).
    pub fn equilibrated_lu(mut self) -> Result<BorderedLu, SingularAt> {
        let rows = self.largest(|row, _, value| (row, value)).map(power_of_two);
        let columns = self.largest(|row, column, value| (column, value * rows[row])).map(power_of_two);
        self.scale_each(&rows, &columns);
        Ok(BorderedLu { scales: Some(Scales { rows, columns }), ..self.lu()? })
    }

    /// Largest magnitudes by index: `of` maps row, column and value of each entry to an index and a value.
    fn largest(&self, of: impl Fn(usize, usize, f64) -> (usize, f64)) -> DVector<f64> {
        let mut largest = DVector::zeros(self.size());
        self.each(|row, column, value| {
            let (index, value) = of(row, column, value);
            largest[index] = value.abs().max(largest[index]);
        });
        largest
    }

    /// Calls `f` with row, column and value of every entry.
    fn each(&self, mut f: impl FnMut(usize, usize, f64)) {
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            for row in 0..layout.size {
                block.own.row(row).for_each(|(column, value)| f(layout.first + row, layout.first + column, value));
            }
            for (n, &touched) in layout.touches.iter().enumerate() {
                let sides = block.right.column(n);
                for (row, (right, below)) in sides.iter().zip(&block.below.column(n)).enumerate() {
                    f(layout.first + row, touched, *right);
                    f(touched, layout.first + row, *below);
                }
            }
        }
        let border = self.layout.border;
        for row in 0..self.layout.border_size {
            self.corner.row(row).for_each(|(column, value)| f(border + row, border + column, value));
        }
    }

    fn scale_each(&mut self, rows: &DVector<f64>, columns: &DVector<f64>) {
        let (rows, columns) = (rows.as_slice(), columns.as_slice());
        for (layout, block) in self.layout.blocks.iter().zip(&mut self.blocks) {
            let own = layout.first..layout.first + layout.size;
            block.own.scale_each(&rows[own.clone()], &columns[own]);
            for (n, &touched) in layout.touches.iter().enumerate() {
                for row in 0..layout.size {
                    block.right[(row, n)] *= rows[layout.first + row] * columns[touched];
                    block.below[(row, n)] *= rows[touched] * columns[layout.first + row];
                }
            }
        }
        let border = self.layout.border;
        self.corner.scale_each(&rows[border..], &columns[border..]);
    }
}

/// Power of two that scales `size` into [½, 1); 1 for zero, infinity and NaN.
fn power_of_two(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() { (-size.log2().floor() - 1.0).exp2() } else { 1.0 }
}

impl Block {
    fn zeros(layout: &BlockLayout) -> Block {
        Block {
            own: BandMatrix::zeros(layout.size, layout.band),
            right: DMatrix::zeros(layout.size, layout.touches.len()),
            below: DMatrix::zeros(layout.size, layout.touches.len()),
        }
    }
}

impl BorderedLu {
    /// Eliminates block by block.
    fn of(layout: &Arc<Layout>, mut corner: BandMatrix, blocks: Vec<Block>) -> Result<BorderedLu, SingularAt> {
        let mut eliminated = Vec::with_capacity(blocks.len());
        for (block, Block { own, mut right, below }) in layout.blocks.iter().zip(blocks) {
            let own = own.lu().map_err(|SingularAt(pivot)| SingularAt(block.first + pivot))?;
            own.solve_columns(right.as_mut_slice());
            for (m, row) in block.touches.iter().enumerate() {
                for (n, column) in block.touches.iter().enumerate() {
                    let taken = below.column(m).dot(&right.column(n));
                    corner.add(row - layout.border, column - layout.border, -taken);
                }
            }
            eliminated.push(BlockLu { own, right, below });
        }
        let corner = corner.lu().map_err(|SingularAt(pivot)| SingularAt(layout.border + pivot))?;
        Ok(BorderedLu { layout: layout.clone(), blocks: eliminated, corner, scales: None })
    }

    /// Solves A x = b in place; negligible entries of a long vector become zero ([`flush_negligible`]).
    pub fn solve(&self, b: &mut DVector<f64>) {
        if let Some(Scales { rows, .. }) = &self.scales {
            b.component_mul_assign(rows);
        }
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            block.own.solve(&mut b.as_mut_slice()[layout.first..layout.first + layout.size]);
            for (n, &touched) in layout.touches.iter().enumerate() {
                let taken = block.below.column(n).dot(&b.rows(layout.first, layout.size));
                b[touched] -= taken;
            }
        }
        self.corner.solve(&mut b.as_mut_slice()[self.layout.border..]);
        flush_negligible(b);
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            for (n, &touched) in layout.touches.iter().enumerate() {
                let border = b[touched];
                b.rows_mut(layout.first, layout.size).axpy(-border, &block.right.column(n), 1.0);
            }
        }
        flush_negligible(b);
        if let Some(Scales { columns, .. }) = &self.scales {
            b.component_mul_assign(columns);
        }
    }
}

#[cfg(test)]
mod tests;
