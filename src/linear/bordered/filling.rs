//! Access to one block of a bordered matrix, for adding entries.

use nalgebra::SMatrix;

use super::Block;
use crate::linear::{BandMatrix, BlockLayout};

/// One block of a bordered matrix with the shared corner, for adding entries.
pub struct Filling<'a> {
    pub(super) border: usize,
    pub(super) place: &'a BlockLayout,
    pub(super) block: &'a mut Block,
    pub(super) corner: &'a mut BandMatrix,
}

/// Location of an unknown relative to a block.
#[derive(Clone, Copy)]
enum Seen {
    /// Index among the block's own unknowns.
    Own(usize),
    /// Index in the border, and index among the border unknowns that the block touches.
    Border { place: usize, touch: usize },
}

impl Filling<'_> {
    fn seen(&self, unknown: usize) -> Seen {
        match unknown.checked_sub(self.border) {
            None => Seen::Own(unknown - self.place.first),
            Some(place) => {
                let touches = &self.place.touches;
                let touch = touches.iter().position(|&touched| touched == unknown).unwrap_or(touches.len());
                Seen::Border { place, touch }
            }
        }
    }

    /// Adds `value` at (row, column), both unknowns of the block or of the border that it touches.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        self.add_seen(self.seen(row), self.seen(column), value);
    }

    /// Adds a dense matrix whose rows and columns are these unknowns of the block or its border; `None` is skipped.
    pub fn add_dense<const N: usize>(&mut self, unknowns: [Option<usize>; N], dense: &SMatrix<f64, N, N>) {
        let seen = unknowns.map(|unknown| unknown.map(|unknown| self.seen(unknown)));
        for (j, column) in seen.iter().enumerate() {
            for (i, row) in seen.iter().enumerate() {
                if let (Some(row), Some(column)) = (*row, *column) {
                    self.add_seen(row, column, dense[(i, j)]);
                }
            }
        }
    }

    fn add_seen(&mut self, row: Seen, column: Seen, value: f64) {
        let Block { own, right, below } = &mut *self.block;
        match (row, column) {
            (Seen::Own(row), Seen::Own(column)) => own.add(row, column, value),
            (Seen::Own(row), Seen::Border { touch, .. }) => right[(row, touch)] += value,
            (Seen::Border { touch, .. }, Seen::Own(column)) => below[(column, touch)] += value,
            (Seen::Border { place: row, .. }, Seen::Border { place: column, .. }) => {
                self.corner.add(row, column, value);
            }
        }
    }
}
