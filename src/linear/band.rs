//! Band matrix, and its LU factorisation with partial pivoting.
//!
//! A rod's matrices couple only neighbours, so that elimination inside the band costs O(n b²) for n unknowns.

use super::SingularAt;
use super::number::Number;

/// Right-hand sides solved together: a rod with two pinned ends and a pivot shares six coordinates.
const SIDE_BY_SIDE: usize = 6;

/// Square matrix whose entries (i, j) vanish for |i − j| > `band`.
#[derive(Clone, Debug)]
pub struct BandMatrix<F = f64> {
    size: usize,
    band: usize,
    /// Row i holds columns i − band … i + 2 band; the last `band` of them are space for pivoting.
    entries: Vec<F>,
    /// Buffers of the last factors, for reuse.
    pivots: Vec<usize>,
    ends: Vec<usize>,
}

/// LU factors of a [`BandMatrix`].
#[derive(Clone, Debug)]
pub struct BandLu<F = f64> {
    factors: BandMatrix<F>,
    /// Row swapped with row k in step k.
    pivots: Vec<usize>,
    /// End of row k of the upper factor: k + band + 1, or further after row swaps.
    ends: Vec<usize>,
}

impl<F: Number> BandMatrix<F> {
    /// Zero matrix of `size` rows with `band` diagonals on either side of the main one.
    pub fn zeros(size: usize, band: usize) -> BandMatrix<F> {
        let entries = vec![F::zero(); size * (3 * band + 1)];
        BandMatrix { size, band, entries, pivots: Vec::with_capacity(size), ends: Vec::with_capacity(size) }
    }

    /// Memory of a matrix of this shape, bytes.
    pub fn bytes(size: usize, band: usize) -> usize {
        size.saturating_mul(3 * band + 1).saturating_mul(size_of::<F>())
    }

    /// Copies another matrix of the same shape.
    pub fn copy_from(&mut self, other: &BandMatrix<F>) {
        self.entries.copy_from_slice(&other.entries);
    }

    fn index(&self, row: usize, column: usize) -> usize {
        row * (3 * self.band + 1) + column + self.band - row
    }

    /// Adds `value` to the entry (row, column), which must lie inside the band.
    pub fn add(&mut self, row: usize, column: usize, value: F) {
        debug_assert!(row.abs_diff(column) <= self.band, "({row}, {column}) lies outside the band");
        let index = self.index(row, column);
        self.entries[index] += value;
    }

    /// Adds `factor` · `other`, a matrix of the same shape.
    pub fn add_scaled(&mut self, factor: F, other: &BandMatrix<F>) {
        debug_assert_eq!((self.size, self.band), (other.size, other.band));
        for row in 0..self.size {
            // Skips the space for pivoting, a third of the entries.
            let entries = self.entries_of(row);
            for (a, b) in self.entries[entries.clone()].iter_mut().zip(&other.entries[entries]) {
                *a += factor * *b;
            }
        }
    }

    /// Columns of a row inside the band.
    fn columns(&self, row: usize) -> std::ops::Range<usize> {
        row.saturating_sub(self.band)..(row + self.band + 1).min(self.size)
    }

    /// Storage of a row's entries inside the band.
    fn entries_of(&self, row: usize) -> std::ops::Range<usize> {
        let columns = self.columns(row);
        let start = self.index(row, columns.start);
        start..start + columns.len()
    }

    /// Entries of a row inside the band, with their columns.
    pub fn row(&self, row: usize) -> impl Iterator<Item = (usize, F)> {
        self.columns(row).zip(self.entries[self.entries_of(row)].iter().copied())
    }

    /// Sets every entry to zero.
    pub fn clear(&mut self) {
        self.entries.fill(F::zero());
    }

    /// Multiplies row i by `rows[i]` and column j by `columns[j]`.
    pub fn scale_each(&mut self, rows: &[F], columns: &[F]) {
        for (row, factor) in rows.iter().enumerate() {
            let (range, entries) = (self.columns(row), self.entries_of(row));
            for (entry, column) in self.entries[entries].iter_mut().zip(&columns[range]) {
                *entry *= *factor * *column;
            }
        }
    }

    /// LU factors by Gaussian elimination; the pivot is the largest entry of each column.
    ///
    /// # Errors
    /// Index of a pivot that is zero or not a number.
    pub fn lu(mut self) -> Result<BandLu<F>, SingularAt> {
        let (size, band) = (self.size, self.band);
        let (mut pivots, mut ends) = (std::mem::take(&mut self.pivots), std::mem::take(&mut self.ends));
        pivots.clear();
        ends.clear();
        let mut right = 0;
        for k in 0..size {
            let below = (k + band + 1).min(size);
            let mut pivot = k;
            for row in k + 1..below {
                if self.entries[self.index(row, k)].norm1() > self.entries[self.index(pivot, k)].norm1() {
                    pivot = row;
                }
            }
            right = right.max(pivot + band + 1).min(size);
            if pivot != k {
                for column in k..right {
                    let (a, b) = (self.index(k, column), self.index(pivot, column));
                    self.entries.swap(a, b);
                }
            }
            let diagonal = self.entries[self.index(k, k)];
            if diagonal.is_zero() || !diagonal.is_finite() {
                return Err(SingularAt(k));
            }
            let (source, width) = (self.index(k, k), right - k);
            for row in k + 1..below {
                let target = self.index(row, k);
                let factor = self.entries[target] / diagonal;
                self.entries[target] = factor;
                if !factor.is_zero() {
                    let (upper, lower) = self.entries.split_at_mut(target);
                    for (a, b) in lower[1..width].iter_mut().zip(&upper[source + 1..source + width]) {
                        *a -= factor * *b;
                    }
                }
            }
            pivots.push(pivot);
            ends.push(right);
        }
        Ok(BandLu { factors: self, pivots, ends })
    }
}

impl<F: Number> BandLu<F> {
    /// Zero matrix of the same shape in the same memory.
    pub fn into_zeros(self) -> BandMatrix<F> {
        let BandLu { mut factors, pivots, ends } = self;
        factors.entries.fill(F::zero());
        BandMatrix { pivots, ends, ..factors }
    }

    /// Solves A x = b in place.
    pub fn solve(&self, b: &mut [F]) {
        self.solve_side_by_side(b.as_chunks_mut::<1>().0);
    }

    /// Solves A X = B in place for a matrix B stored by columns. Each column gets the same bits as from
    /// [`solve`](BandLu::solve), in less time.
    pub fn solve_columns(&self, columns: &mut [F]) {
        let size = self.factors.size;
        if size == 0 {
            return;
        }
        let mut rows = vec![[F::zero(); SIDE_BY_SIDE]; size];
        for columns in columns.chunks_mut(SIDE_BY_SIDE * size) {
            rows.fill([F::zero(); SIDE_BY_SIDE]);
            for (n, column) in columns.chunks(size).enumerate() {
                rows.iter_mut().zip(column).for_each(|(row, value)| row[n] = *value);
            }
            self.solve_side_by_side(&mut rows);
            for (n, column) in columns.chunks_mut(size).enumerate() {
                column.iter_mut().zip(&rows).for_each(|(value, row)| *value = row[n]);
            }
        }
    }

    fn solve_side_by_side<const N: usize>(&self, b: &mut [[F; N]]) {
        let BandMatrix { size, band, entries, .. } = &self.factors;
        for k in 0..*size {
            b.swap(k, self.pivots[k]);
            let known = b[k];
            for row in k + 1..(k + band + 1).min(*size) {
                let factor = entries[self.factors.index(row, k)];
                b[row].iter_mut().zip(known).for_each(|(b, known)| *b -= factor * known);
            }
        }
        for k in (0..*size).rev() {
            let start = self.factors.index(k, k);
            let width = self.ends[k] - k;
            // Sums begin at −0, as those of iterators do.
            let mut known = [-F::zero(); N];
            for (factor, b) in entries[start + 1..start + width].iter().zip(&b[k + 1..k + width]) {
                known.iter_mut().zip(b).for_each(|(known, b)| *known += *factor * *b);
            }
            b[k].iter_mut().zip(known).for_each(|(b, known)| *b = (*b - known) / entries[start]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use proptest::prelude::*;

    fn band_and_dense(size: usize, band: usize, values: &[f64]) -> (BandMatrix, DMatrix<f64>) {
        let mut matrix = BandMatrix::zeros(size, band);
        let mut dense = DMatrix::zeros(size, size);
        let mut values = values.iter().cycle();
        for row in 0..size {
            for column in row.saturating_sub(band)..(row + band + 1).min(size) {
                let value = *values.next().unwrap();
                matrix.add(row, column, value);
                dense[(row, column)] += value;
            }
        }
        (matrix, dense)
    }

    proptest! {
        #[test]
        fn solves_like_a_dense_lu(size in 1usize..25, band in 1usize..6, values in prop::collection::vec(-1.0..1.0, 400)) {
            let (matrix, dense) = band_and_dense(size, band, &values);
            let x = DVector::from_fn(size, |i, _| values[i] + 2.0);
            let b = &dense * &x;
            let condition = dense.clone().svd(false, false).singular_values;
            prop_assume!(condition.min() > 1e-6 * condition.max());
            let mut solution = b;
            matrix.lu().unwrap().solve(solution.as_mut_slice());
            prop_assert!((solution - x).amax() <= 1e-8);
        }
    }

    proptest! {
        #[test]
        fn columns_are_solved_to_the_same_bits_as_one_by_one(
            size in 0usize..12, band in 0usize..5, count in 0usize..15, values in prop::collection::vec(-1.0..1.0, 400),
        ) {
            let factors = band_and_dense(size, band, &values).0.lu();
            prop_assume!(factors.is_ok());
            let mut columns: Vec<f64> = values.iter().copied().rev().take(size * count).collect();
            let mut one_by_one = columns.clone();
            let factors = factors.unwrap();
            factors.solve_columns(&mut columns);
            one_by_one.chunks_mut(size.max(1)).for_each(|column| factors.solve(column));
            prop_assert!(columns.iter().zip(&one_by_one).all(|(a, b)| a.to_bits() == b.to_bits()));
        }
    }

    #[test]
    fn a_zero_diagonal_is_pivoted_and_a_zero_column_is_named() {
        let mut swap = BandMatrix::zeros(2, 1);
        swap.add(0, 1, 2.0);
        swap.add(1, 0, 4.0);
        let mut b = [2.0, 4.0];
        swap.lu().unwrap().solve(&mut b);
        assert_eq!(b, [1.0, 1.0]);

        let mut singular = BandMatrix::zeros(3, 1);
        singular.add(0, 0, 1.0);
        singular.add(2, 2, 1.0);
        assert_eq!(singular.lu().unwrap_err(), SingularAt(1));
    }
}
