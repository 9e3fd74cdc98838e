//! Linear systems: a band matrix and its LU factorisation with partial pivoting.
//!
//! A rod's matrices couple neighbours only, so elimination inside the band costs O(n b²) for n unknowns.

use nalgebra::DVector;

/// A square matrix whose entries (i, j) vanish for |i − j| > `band`.
#[derive(Clone, Debug)]
pub struct BandMatrix {
    size: usize,
    band: usize,
    /// Row i holds columns i − band … i + 2 band; the last `band` of them are room for pivoting.
    entries: Vec<f64>,
}

/// The LU factors of a [`BandMatrix`].
#[derive(Clone, Debug)]
pub struct BandLu {
    factors: BandMatrix,
    /// Row that changed places with row k at step k.
    pivots: Vec<usize>,
}

/// The matrix is singular to working precision at this pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularAt(pub usize);

impl BandMatrix {
    /// A zero matrix of `size` rows with `band` diagonals on either side of the main one.
    pub fn zeros(size: usize, band: usize) -> BandMatrix {
        BandMatrix { size, band, entries: vec![0.0; size * (3 * band + 1)] }
    }

    /// Memory that such a matrix takes, bytes.
    pub fn bytes(size: usize, band: usize) -> usize {
        size.saturating_mul(3 * band + 1).saturating_mul(size_of::<f64>())
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    fn place(&self, row: usize, column: usize) -> usize {
        row * (3 * self.band + 1) + column + self.band - row
    }

    /// The entry at (row, column), zero outside the band.
    pub fn get(&self, row: usize, column: usize) -> f64 {
        if row.abs_diff(column) <= self.band { self.entries[self.place(row, column)] } else { 0.0 }
    }

    /// Adds `value` to the entry at (row, column), which must lie inside the band.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        debug_assert!(row.abs_diff(column) <= self.band, "({row}, {column}) lies outside the band");
        let place = self.place(row, column);
        self.entries[place] += value;
    }

    /// Multiplies every entry by `factor`.
    pub fn scale(&mut self, factor: f64) {
        self.entries.iter_mut().for_each(|entry| *entry *= factor);
    }

    /// Adds `factor` · `other`, a matrix of the same shape.
    pub fn add_scaled(&mut self, factor: f64, other: &BandMatrix) {
        debug_assert_eq!((self.size, self.band), (other.size, other.band));
        for (a, b) in self.entries.iter_mut().zip(&other.entries) {
            *a += factor * b;
        }
    }

    /// The product with a vector.
    pub fn mul(&self, x: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(self.size, |row, _| {
            let columns = row.saturating_sub(self.band)..(row + self.band + 1).min(self.size);
            columns.map(|column| self.entries[self.place(row, column)] * x[column]).sum()
        })
    }

    /// LU factors by Gaussian elimination, the largest entry of each column as its pivot.
    ///
    /// # Errors
    /// A pivot that is zero, or not a number.
    pub fn lu(mut self) -> Result<BandLu, SingularAt> {
        let (size, band) = (self.size, self.band);
        let mut pivots = Vec::with_capacity(size);
        for k in 0..size {
            let below = (k + band + 1).min(size);
            let right = (k + 2 * band + 1).min(size);
            let mut pivot = k;
            for row in k + 1..below {
                if self.entries[self.place(row, k)].abs() > self.entries[self.place(pivot, k)].abs() {
                    pivot = row;
                }
            }
            if pivot != k {
                for column in k..right {
                    let (a, b) = (self.place(k, column), self.place(pivot, column));
                    self.entries.swap(a, b);
                }
            }
            let diagonal = self.entries[self.place(k, k)];
            if diagonal == 0.0 || !diagonal.is_finite() {
                return Err(SingularAt(k));
            }
            let (source, width) = (self.place(k, k), right - k);
            for row in k + 1..below {
                let target = self.place(row, k);
                let factor = self.entries[target] / diagonal;
                self.entries[target] = factor;
                if factor != 0.0 {
                    let (upper, lower) = self.entries.split_at_mut(target);
                    for (a, b) in lower[1..width].iter_mut().zip(&upper[source + 1..source + width]) {
                        *a -= factor * b;
                    }
                }
            }
            pivots.push(pivot);
        }
        Ok(BandLu { factors: self, pivots })
    }
}

impl BandLu {
    /// Solves A x = b in place.
    pub fn solve(&self, b: &mut DVector<f64>) {
        let BandMatrix { size, band, entries } = &self.factors;
        for k in 0..*size {
            b.swap_rows(k, self.pivots[k]);
            for row in k + 1..(k + band + 1).min(*size) {
                b[row] -= entries[self.factors.place(row, k)] * b[k];
            }
        }
        for k in (0..*size).rev() {
            let start = self.factors.place(k, k);
            let right = (k + 2 * band + 1).min(*size) - k;
            let known: f64 = (1..right).map(|n| entries[start + n] * b[k + n]).sum();
            b[k] = (b[k] - known) / entries[start];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;
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
            let b = matrix.mul(&x);
            prop_assert!((&b - &dense * &x).amax() <= 1e-14 * (1.0 + b.amax()) * size as f64);
            let condition = dense.clone().svd(false, false).singular_values;
            prop_assume!(condition.min() > 1e-6 * condition.max());
            let mut solution = b;
            matrix.lu().unwrap().solve(&mut solution);
            prop_assert!((solution - x).amax() <= 1e-8);
        }
    }

    #[test]
    fn a_zero_diagonal_is_pivoted_and_a_zero_column_is_named() {
        let mut swap = BandMatrix::zeros(2, 1);
        swap.add(0, 1, 2.0);
        swap.add(1, 0, 4.0);
        let mut b = DVector::from_vec(vec![2.0, 4.0]);
        swap.lu().unwrap().solve(&mut b);
        assert_eq!(b.as_slice(), [1.0, 1.0]);

        let mut singular = BandMatrix::zeros(3, 1);
        singular.add(0, 0, 1.0);
        singular.add(2, 2, 1.0);
        assert_eq!(singular.lu().unwrap_err(), SingularAt(1));
    }
}
