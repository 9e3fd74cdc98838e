//! LU factors of a rod's matrix by the frontal method: a chain of elements, each sharing its last coordinates with the
//! next.
//!
//! Elements are added one after the other to a front of `N` coordinates. Coordinates that no later element touches are
//! eliminated there: all interior nodes, and the node shared with the element before. What remains of the last node
//! starts the next front. Nothing outside a front is stored or multiplied, and the compiler knows the length of every
//! loop.
//!
//! Coordinates shared between rods, the *border*, are not eliminated. They are extra columns and rows of the front,
//! from the first element that touches them on.

mod element_unknowns;
mod front;

use std::fmt::Debug;

use element_unknowns::{ElementUnknowns, MOST_BORDER_UNKNOWNS, SHARED};
use front::{Border, Front, Side, subtract};

use super::number::Number;
use super::{BandMatrix, SingularAt};

pub use element_unknowns::NO_UNKNOWN;

/// LU factors of one rod's matrix, for any element type.
pub trait Chain<F: Number>: Debug + Send + Sync {
    /// Factorises a matrix and adds the remainder of the border to the corner; `fill` writes an element's matrix, by
    /// columns, given its number.
    ///
    /// # Errors
    /// Unknown of a pivot that is zero or not a number.
    fn factorize(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<(), SingularAt>;

    /// Forward elimination of a right-hand side in place, including the border's part.
    fn forward(&self, b: &mut [F]);

    /// Eliminates a symmetric matrix without row swaps, adds the remainder of the border to the corner, and returns the
    /// number of negative pivots: of negative eigenvalues (Sylvester's law of inertia). The factors are of no other use.
    ///
    /// # Errors
    /// Those of [`factorize`](Chain::factorize).
    fn negative_pivots(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<usize, SingularAt>;

    /// Back substitution, once the border's unknowns are known.
    fn backward(&self, b: &mut [F]);

    /// Memory of the factors, bytes.
    fn bytes(&self) -> usize;
}

/// LU factors of a chain of elements with `N` coordinates each.
#[derive(Clone, Debug)]
pub struct FrontalChain<F, const N: usize> {
    element_unknowns: Vec<ElementUnknowns<N>>,
    fronts: Vec<Front<F, N>>,
    /// Sides of all fronts: one for each border unknown that the chain has reached by then.
    sides: Vec<Side<F, N>>,
    /// Border unknowns of the chain, in the order in which it reaches them.
    touches: Vec<usize>,
    /// First unknown of the border.
    border: usize,
}

impl<F: Number, const N: usize> FrontalChain<F, N> {
    /// Allocates the factors of elements with these unknowns ([`NO_UNKNOWN`] where a coordinate is held); those from `border`
    /// on belong to the border.
    pub fn new(elements: impl Iterator<Item = [u32; N]>, border: usize) -> FrontalChain<F, N> {
        let (mut element_unknowns, mut touches, mut sides) = (Vec::new(), Vec::new(), 0);
        for unknowns in elements {
            let unknowns = ElementUnknowns::new(unknowns, border, &mut touches, sides);
            sides += unknowns.reached;
            element_unknowns.push(unknowns);
        }
        let front = Front { lu: [[F::zero(); N]; N], swaps: [0; N] };
        let none = [F::zero(); N];
        FrontalChain {
            fronts: vec![front; element_unknowns.len()],
            sides: vec![Side { right: none, below: none }; sides],
            touches,
            border,
            element_unknowns,
        }
    }

    /// Largest memory of the factors per element, bytes.
    pub const fn bytes_each() -> usize {
        size_of::<Front<F, N>>() + MOST_BORDER_UNKNOWNS * size_of::<Side<F, N>>()
    }

    /// Number of coordinates eliminated in a front: all in the last one.
    fn pivots(&self, element: usize) -> usize {
        if element + 1 == self.element_unknowns.len() { N } else { N - SHARED }
    }

    /// Sides of an element's front, with their border unknowns.
    fn sides(&self, unknowns: &ElementUnknowns<N>) -> impl Iterator<Item = (&Side<F, N>, usize)> {
        self.sides[unknowns.first_side..][..unknowns.reached].iter().zip(self.touches.iter().copied())
    }

    /// Eliminates the chain's own coordinates front by front, and adds the remainder of the border to the corner.
    fn eliminate<const SWAPS: bool>(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<(), SingularAt> {
        let mut border = Border::zeros();
        for element in 0..self.element_unknowns.len() {
            let pivots = self.pivots(element);
            let unknowns = &self.element_unknowns[element];
            let (before, front) = self.fronts.split_at_mut(element);
            let front = &mut front[0];
            fill(element, front.lu.as_flattened_mut());
            border.advance(unknowns.reached);
            if !unknowns.others.is_empty() {
                border.separate(unknowns, &mut front.lu);
            }
            if let Some(before) = before.last() {
                front.add_rest(before);
            }
            front
                .eliminate::<SWAPS>(pivots, unknowns.reached, &mut border)
                .map_err(|k| SingularAt(unknowns.own[k] as usize))?;
            self.sides[unknowns.first_side..][..unknowns.reached].copy_from_slice(&border.sides[..unknowns.reached]);
        }
        for (row, s) in self.touches.iter().zip(&border.corner) {
            for (column, value) in self.touches.iter().zip(s) {
                corner.add(row - self.border, column - self.border, *value);
            }
        }
        Ok(())
    }
}

impl<F: Number, const N: usize> Chain<F> for FrontalChain<F, N> {
    fn factorize(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<(), SingularAt> {
        self.eliminate::<true>(fill, corner)
    }

    fn negative_pivots(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<usize, SingularAt> {
        self.eliminate::<false>(fill, corner)?;
        let negative = |(element, front): (usize, &Front<F, N>)| {
            (0..self.pivots(element)).filter(|&k| front.lu[k][k].real() < 0.0).count()
        };
        Ok(self.fronts.iter().enumerate().map(negative).sum())
    }

    fn forward(&self, b: &mut [F]) {
        let mut shared = [F::zero(); SHARED];
        for (element, (unknowns, front)) in self.element_unknowns.iter().zip(&self.fronts).enumerate() {
            let pivots = self.pivots(element);
            let mut y = [F::zero(); N];
            y[..SHARED].copy_from_slice(&shared);
            for (y, own) in y[..pivots].iter_mut().zip(unknowns.own) {
                *y += b.get(own as usize).copied().unwrap_or(F::zero());
            }
            for (k, swap) in front.swaps[..pivots].iter().enumerate() {
                y.swap(k, *swap as usize);
            }
            // Each pass takes a whole column, for speed. It spoils the rows down to k, which are saved before.
            let mut solved = y;
            for k in 0..pivots {
                solved[k] = y[k];
                subtract(y[k], &front.lu[k], &mut y);
            }
            for (side, touched) in self.sides(unknowns) {
                let known = side.below[..pivots].iter().zip(&solved).fold(F::zero(), |sum, (a, b)| sum + *a * *b);
                b[touched] -= known;
            }
            for (solved, own) in solved[..pivots].iter().zip(unknowns.own) {
                if let Some(b) = b.get_mut(own as usize) {
                    *b = *solved;
                }
            }
            shared.copy_from_slice(&y[N - SHARED..]);
        }
    }

    fn backward(&self, b: &mut [F]) {
        let mut shared = [F::zero(); SHARED];
        for (element, (unknowns, front)) in self.element_unknowns.iter().zip(&self.fronts).enumerate().rev() {
            let pivots = self.pivots(element);
            let mut y = [F::zero(); N];
            for (y, own) in y[..pivots].iter_mut().zip(unknowns.own) {
                *y = b.get(own as usize).copied().unwrap_or(F::zero());
            }
            for (side, touched) in self.sides(unknowns) {
                subtract(b[touched], &side.right, &mut y);
            }
            if pivots < N {
                for (column, known) in front.lu[N - SHARED..].iter().zip(shared) {
                    subtract(known, column, &mut y);
                }
            }
            // As in forward elimination, with the rows from k on.
            let mut solved = y;
            for k in (0..pivots).rev() {
                solved[k] = y[k] * front.lu[k][k];
                subtract(solved[k], &front.lu[k], &mut y);
            }
            for (solved, own) in solved[..pivots].iter().zip(unknowns.own) {
                if let Some(b) = b.get_mut(own as usize) {
                    *b = *solved;
                }
            }
            shared.copy_from_slice(&solved[..SHARED]);
        }
    }

    fn bytes(&self) -> usize {
        self.element_unknowns.len() * size_of::<Front<F, N>>() + self.sides.len() * size_of::<Side<F, N>>()
    }
}

#[cfg(test)]
mod tests;
