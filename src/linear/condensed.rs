//! LU factors of chains of elements coupled by a border: rods, and the points that they share.
//!
//! Each chain is eliminated by itself ([`FrontalChain`](super::FrontalChain)) and leaves its part of a small band
//! matrix over the border. The cost is linear in the number of rods and of their elements. The whole matrix is never
//! stored.

use nalgebra::DVector;

use super::frontal::Chain;
use super::ldlt::Ldlt;
use super::number::Number;
use super::{BandLu, BandMatrix, SingularAt, flush_negligible};

/// LU factors of the chains and of the border, or memory for them.
#[derive(Debug)]
pub struct CondensedFactors<F: Number = f64> {
    chains: Vec<Box<dyn Chain<F>>>,
    corner: Option<BandLu<F>>,
    /// Memory for counting negative eigenvalues.
    inertia: Option<(BandMatrix<F>, Ldlt)>,
    /// First unknown of the border; below, its size and the half-width of its band.
    border: usize,
    border_size: usize,
    border_band: usize,
}

impl<F: Number> CondensedFactors<F> {
    /// Allocates memory for the factors of these chains, with a border that begins at the unknown `border`.
    pub fn new(
        chains: Vec<Box<dyn Chain<F>>>,
        border: usize,
        border_size: usize,
        border_band: usize,
    ) -> CondensedFactors<F> {
        CondensedFactors { chains, corner: None, inertia: None, border, border_size, border_band }
    }

    /// Factorises a matrix; `fill` writes an element's matrix, by columns, given the numbers of the chain and of the
    /// element in it.
    ///
    /// # Errors
    /// Unknown of a pivot that is zero or not a number; there are no factors then.
    pub fn factorize(&mut self, mut fill: impl FnMut(usize, usize, &mut [F])) -> Result<(), SingularAt> {
        let zeros = || BandMatrix::zeros(self.border_size, self.border_band);
        let mut corner = self.corner.take().map_or_else(zeros, BandLu::into_zeros);
        for (number, chain) in self.chains.iter_mut().enumerate() {
            chain.factorize(&mut |element, matrix| fill(number, element, matrix), &mut corner)?;
        }
        self.corner = Some(corner.lu().map_err(|SingularAt(pivot)| SingularAt(self.border + pivot))?);
        Ok(())
    }

    /// Solves A x = b in place; negligible entries of a long vector become zero ([`flush_negligible`]).
    ///
    /// Without factors the solution is NaN.
    pub fn solve(&self, b: &mut DVector<F>) {
        let Some(corner) = &self.corner else {
            b.fill(F::from_real(f64::NAN));
            return;
        };
        self.chains.iter().for_each(|chain| chain.forward(b.as_mut_slice()));
        corner.solve(&mut b.as_mut_slice()[self.border..]);
        flush_negligible(b);
        self.chains.iter().for_each(|chain| chain.backward(b.as_mut_slice()));
        flush_negligible(b);
    }

    /// Memory of the factors, bytes.
    pub fn bytes(&self) -> usize {
        let corner = BandMatrix::<F>::bytes(self.border_size, self.border_band);
        self.chains.iter().map(|chain| chain.bytes()).sum::<usize>() + corner
    }
}

impl CondensedFactors {
    /// Number of negative eigenvalues of a symmetric matrix; `fill` as for [`factorize`](CondensedFactors::factorize).
    /// `None` where elimination without row swaps meets a pivot that is zero or not a number. The factors are lost.
    pub fn negative_eigenvalues(&mut self, mut fill: impl FnMut(usize, usize, &mut [f64])) -> Option<usize> {
        let CondensedFactors { chains, inertia, .. } = self;
        let (corner, ldlt) =
            inertia.get_or_insert_with(|| (BandMatrix::zeros(self.border_size, self.border_band), Ldlt::default()));
        corner.clear();
        let mut negative = 0;
        for (number, chain) in chains.iter_mut().enumerate() {
            negative += chain.negative_pivots(&mut |element, matrix| fill(number, element, matrix), corner).ok()?;
        }
        Some(negative + ldlt.factorize(corner, self.border_size, self.border_band, &mut [])?)
    }
}
