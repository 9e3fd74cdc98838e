//! Access to one block of a bordered matrix, for adding entries.

use nalgebra::SMatrix;

use super::Block;
use crate::linear::{BandMatrix, BlockLayout};

/// One block of a bordered matrix with the shared corner, for adding entries.
pub struct BlockMut<'a> {
    pub(super) border: usize,
    pub(super) layout: &'a BlockLayout,
    pub(super) block: &'a mut Block,
    pub(super) corner: &'a mut BandMatrix,
}

/// Location of an unknown relative to a block.
#[derive(Clone, Copy)]
enum Location {
    /// Index among the block's own unknowns.
    Own(usize),
    /// Index in the border, and index among the border unknowns that the block touches.
    Border { index: usize, touch: usize },
}

impl BlockMut<'_> {
    fn locate(&self, unknown: usize) -> Location {
        match unknown.checked_sub(self.border) {
            None => Location::Own(unknown - self.layout.first),
            Some(index) => {
                let touches = &self.layout.touches;
                let touch = touches.iter().position(|&touched| touched == unknown).unwrap_or(touches.len());
                Location::Border { index, touch }
            }
        }
    }

    /// Adds `value` at (row, column), both unknowns of the block or of the border that it touches.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        self.add_at(self.locate(row), self.locate(column), value);
    }

    /// Adds a dense matrix whose rows and columns are these unknowns of the block or its border; `None` is skipped.
    pub fn add_dense<const N: usize>(&mut self, unknowns: [Option<usize>; N], dense: &SMatrix<f64, N, N>) {
        let locations = unknowns.map(|unknown| unknown.map(|unknown| self.locate(unknown)));
        for (j, column) in locations.iter().enumerate() {
            for (i, row) in locations.iter().enumerate() {
                if let (Some(row), Some(column)) = (*row, *column) {
                    self.add_at(row, column, dense[(i, j)]);
                }
            }
        }
    }

    fn add_at(&mut self, row: Location, column: Location, value: f64) {
        let Block { own, right, below } = &mut *self.block;
        match (row, column) {
            (Location::Own(row), Location::Own(column)) => own.add(row, column, value),
            (Location::Own(row), Location::Border { touch, .. }) => right[(row, touch)] += value,
            (Location::Border { touch, .. }, Location::Own(column)) => below[(column, touch)] += value,
            (Location::Border { index: row, .. }, Location::Border { index: column, .. }) => {
                self.corner.add(row, column, value);
            }
        }
    }
}
