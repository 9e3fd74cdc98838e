//! Front of one element: its coordinates, with extra columns and rows of the border. Coordinates that no later element
//! touches are eliminated.

use super::element_unknowns::{ElementUnknowns, MOST_BORDER_UNKNOWNS, NO_UNKNOWN, SHARED};
use crate::linear::number::Number;

/// Threshold of partial pivoting: the diagonal is kept if it is at least this fraction of the largest entry. A row swap
/// costs more than the digit that may be lost.
const PIVOT_THRESHOLD: f64 = 0.1;

/// Factors of a front.
#[derive(Clone, Debug)]
pub(super) struct Front<F, const N: usize> {
    /// Column k: upper factor above the diagonal, reciprocal pivot on it, multipliers of pivot k below it.
    pub lu: [[F; N]; N],
    /// Row swapped with row k in step k.
    pub swaps: [u8; N],
}

/// Extra column and row of a front, of one border unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<F, const N: usize> {
    /// Column of the border unknown, in the front's rows.
    pub right: [F; N],
    /// Row of the border unknown, in the front's columns, divided by the pivots.
    pub below: [F; N],
}

/// Extra columns and rows of the present front, and the corner that earlier fronts have left.
pub(super) struct Border<F, const N: usize> {
    pub sides: [Side<F, N>; MOST_BORDER_UNKNOWNS],
    pub corner: [[F; MOST_BORDER_UNKNOWNS]; MOST_BORDER_UNKNOWNS],
}

impl<F: Number, const N: usize> Border<F, N> {
    pub fn zeros() -> Border<F, N> {
        let none = [F::zero(); N];
        Border {
            sides: [Side { right: none, below: none }; MOST_BORDER_UNKNOWNS],
            corner: [[F::zero(); MOST_BORDER_UNKNOWNS]; MOST_BORDER_UNKNOWNS],
        }
    }

    /// Moves the remainder of the last node to the place of the first.
    pub fn advance(&mut self, reached: usize) {
        let shared = |row: &mut [F; N]| {
            row.copy_within(N - SHARED.., 0);
            row[SHARED..].fill(F::zero());
        };
        for side in &mut self.sides[..reached] {
            shared(&mut side.right);
            shared(&mut side.below);
        }
    }

    /// Separates the coordinates that are not the chain's own from an element's matrix: a border coordinate becomes an
    /// extra column and row, a held one is dropped. Either leaves an equation x = 0.
    pub fn separate(&mut self, unknowns: &ElementUnknowns<N>, element: &mut [[F; N]; N]) {
        for &(n, touch) in &unknowns.others {
            if let Some(t) = touch {
                for (m, other) in &unknowns.others {
                    if let Some(s) = other {
                        self.corner[t][*s] += element[*m][n];
                    }
                }
                for m in (0..N).filter(|&m| unknowns.own[m] != NO_UNKNOWN) {
                    self.sides[t].right[m] += element[n][m];
                    self.sides[t].below[m] += element[m][n];
                }
            }
        }
        for &(n, _) in &unknowns.others {
            element[n] = [F::zero(); N];
            element.iter_mut().for_each(|column| column[n] = F::zero());
            element[n][n] = F::one();
        }
    }

    #[inline(always)]
    pub fn eliminate(&mut self, k: usize, lower: &[F; N], front: &[[F; N]; N], reached: usize) {
        let row: [F; N] = std::array::from_fn(|column| if column > k { front[column][k] } else { F::zero() });
        let pivots_right: [F; MOST_BORDER_UNKNOWNS] = std::array::from_fn(|t| self.sides[t].right[k]);
        for (side, corner) in self.sides[..reached].iter_mut().zip(&mut self.corner) {
            subtract(side.right[k], lower, &mut side.right);
            let factor = side.below[k] * front[k][k];
            subtract(factor, &row, &mut side.below);
            side.below[k] = factor;
            subtract(factor, &pivots_right, corner);
        }
    }
}

impl<F: Number, const N: usize> Front<F, N> {
    /// Adds what the front before has left of the shared node.
    pub fn add_rest(&mut self, before: &Front<F, N>) {
        for (column, rest) in self.lu.iter_mut().zip(&before.lu[N - SHARED..]) {
            column.iter_mut().zip(&rest[N - SHARED..]).for_each(|(entry, rest)| *entry += *rest);
        }
    }

    /// Swaps a large entry of column k, among the rows eliminated here, to the diagonal. The diagonal stays if it is at
    /// least a [`PIVOT_THRESHOLD`] fraction of the largest.
    #[inline(always)]
    fn pivot(&mut self, k: usize, pivots: usize, sides: &mut [Side<F, N>]) {
        let (mut row, mut most) = (k, self.lu[k][k].norm1() / PIVOT_THRESHOLD);
        for (below, entry) in self.lu[k][..pivots].iter().enumerate().skip(k + 1) {
            if entry.norm1() > most {
                (row, most) = (below, entry.norm1());
            }
        }
        self.swaps[k] = row as u8;
        if row != k {
            self.lu.iter_mut().for_each(|column| column.swap(k, row));
            sides.iter_mut().for_each(|side| side.right.swap(k, row));
        }
    }

    /// Eliminates the first `pivots` coordinates; with `SWAPS` of rows where that saves digits.
    #[inline(always)]
    pub fn eliminate<const SWAPS: bool>(
        &mut self,
        pivots: usize,
        reached: usize,
        border: &mut Border<F, N>,
    ) -> Result<(), usize> {
        for k in 0..pivots {
            if SWAPS {
                self.pivot(k, pivots, &mut border.sides[..reached]);
            }
            let diagonal = self.lu[k][k];
            let inverse = F::one() / diagonal;
            if diagonal.is_zero() || !inverse.is_finite() {
                return Err(k);
            }
            let mut lower = self.lu[k].map(|entry| entry * inverse);
            lower[..=k].fill(F::zero());
            for column in &mut self.lu[k + 1..] {
                subtract(column[k], &lower, column);
            }
            self.lu[k][k] = inverse;
            self.lu[k][k + 1..].copy_from_slice(&lower[k + 1..]);
            if reached > 0 {
                border.eliminate(k, &lower, &self.lu, reached);
            }
        }
        Ok(())
    }
}

/// Subtracts `factor` · `column` from `from`.
#[inline(always)]
pub(super) fn subtract<F: Number, const N: usize>(factor: F, column: &[F; N], from: &mut [F; N]) {
    for (from, entry) in from.iter_mut().zip(column) {
        *from -= factor * *entry;
    }
}
