//! L D Lᵀ factors of a symmetric band matrix whose entries multiply plane vectors (x, y): both components are solved
//! together.

use wide::f64x2;

use super::SingularAt;

/// L D Lᵀ factors of a positive definite matrix with lower half-bandwidth `W`.
#[derive(Clone, Debug)]
pub struct BandedLdlt<const W: usize> {
    /// Row i of L: multipliers of rows i − W … i − 1.
    lower: Vec<[f64; W]>,
    /// Column i of L: multipliers of row i in rows i + W … i + 1, so that both substitutions read memory in order.
    upper: Vec<[f64; W]>,
    /// Reciprocal pivots 1/D.
    inverse: Vec<f64>,
}

impl<const W: usize> BandedLdlt<W> {
    /// Factorises a matrix of `size` rows; `entry(row, column)` with `column` ≤ `row` gives its entries.
    ///
    /// # Errors
    /// Row of a pivot that is not positive.
    pub fn new(size: usize, entry: impl Fn(usize, usize) -> f64) -> Result<BandedLdlt<W>, SingularAt> {
        let mut band = BandedLdlt { lower: Vec::with_capacity(size), upper: vec![[0.0; W]; size], inverse: Vec::new() };
        let mut diagonal: Vec<f64> = Vec::with_capacity(size);
        for i in 0..size {
            let mut row = [0.0; W];
            let mut pivot = entry(i, i);
            for j in i.saturating_sub(W)..i {
                // L_ij D_j = A_ij − Σ L_ik D_k L_jk over the columns that both rows reach.
                let both = (i.saturating_sub(W)).max(j.saturating_sub(W))..j;
                let known: f64 = both.map(|k| row[k + W - i] * diagonal[k] * band.lower[j][k + W - j]).sum();
                let multiplier = (entry(i, j) - known) / diagonal[j];
                row[j + W - i] = multiplier;
                band.upper[j][j + W - i] = multiplier;
                pivot -= multiplier * multiplier * diagonal[j];
            }
            if pivot <= 0.0 || !pivot.is_finite() {
                return Err(SingularAt(i));
            }
            band.lower.push(row);
            band.inverse.push(1.0 / pivot);
            diagonal.push(pivot);
        }
        Ok(band)
    }

    /// Solves in place for vectors whose x components are at `offsets` in `b`, each followed by its y component.
    pub fn solve(&self, offsets: &[u32], b: &mut [f64]) {
        let mut known = [f64x2::ZERO; W];
        for (row, &offset) in self.lower.iter().zip(offsets) {
            let y = reduced(get(b, offset), row, &known);
            push(y, &mut known);
            set(y, offset, b);
        }
        known = [f64x2::ZERO; W];
        for ((column, inverse), &offset) in self.upper.iter().zip(&self.inverse).zip(offsets).rev() {
            let x = reduced(get(b, offset) * *inverse, column, &known);
            push(x, &mut known);
            set(x, offset, b);
        }
    }
}

/// Subtracts the known terms from `value`. The most recent one comes last: it is the only one not yet available.
#[inline(always)]
fn reduced<const W: usize>(value: f64x2, factors: &[f64; W], known: &[f64x2; W]) -> f64x2 {
    factors.iter().zip(known).fold(value, |value, (factor, known)| value - *known * *factor)
}

/// Shifts the newest known value in and the oldest out.
#[inline(always)]
fn push<const W: usize>(newest: f64x2, known: &mut [f64x2; W]) {
    known.rotate_left(1);
    known[W - 1] = newest;
}

#[inline(always)]
fn get(b: &[f64], offset: u32) -> f64x2 {
    let offset = offset as usize;
    f64x2::new([b[offset], b[offset + 1]])
}

#[inline(always)]
fn set(value: f64x2, offset: u32, b: &mut [f64]) {
    let offset = offset as usize;
    b[offset..offset + 2].copy_from_slice(&value.to_array());
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use proptest::prelude::*;

    proptest! {
        /// Both components match a dense LU solution, wherever they are stored.
        #[test]
        fn solves_like_a_dense_matrix(size in 1usize..20, values in prop::collection::vec(-1.0..1.0, 200)) {
            let entry = |i: usize, j: usize| match i.abs_diff(j) {
                0 => 4.0 + values[i],
                apart if apart <= 3 => values[20 + 8 * i.min(j) + apart],
                _ => 0.0,
            };
            let dense = DMatrix::from_fn(size, size, entry);
            let factors = BandedLdlt::<3>::new(size, entry);
            prop_assume!(dense.clone().cholesky().is_some());
            let offsets: Vec<u32> = (0..size as u32).rev().map(|n| 3 * n + 1).collect();
            let mut b: Vec<f64> = values.iter().copied().cycle().take(3 * size + 1).collect();
            let component = |b: &[f64], c: usize| DVector::from_iterator(size, offsets.iter().map(|&p| b[p as usize + c]));
            let expected = [0, 1].map(|c| dense.clone().lu().solve(&component(&b, c)).unwrap());
            factors.unwrap().solve(&offsets, &mut b);
            for (c, expected) in expected.iter().enumerate() {
                prop_assert!((component(&b, c) - expected).amax() <= 1e-9 * expected.amax());
            }
        }
    }

    #[test]
    fn a_matrix_that_is_not_definite_is_refused_with_its_row() {
        let entry = |i: usize, j: usize| if i == j { [1.0, 1.0, -1.0][i] } else { 0.0 };
        assert_eq!(BandedLdlt::<3>::new(3, entry).unwrap_err(), SingularAt(2));
    }
}
