//! LU factors of a chain of elements, each of which shares its last coordinates with the next: a rod.
//!
//! One element after the other is added to a front of its `N` coordinates. Those that no later element touches, which are
//! all of its interior nodes and the node that it shares with the element before, are eliminated there; what they leave of the
//! last node is the beginning of the next front. Nothing outside of a front is stored or multiplied, and every loop is as long as
//! the compiler knows it to be.
//!
//! Coordinates that rods share, the *border*, are not eliminated: they stand beside the front in columns and rows of their own,
//! from the first element that touches them on.

mod front;
mod place;

use std::fmt::Debug;

use front::{Border, Front, Side, subtract};
use place::{ElementPlaces, SHARED};

use super::number::Number;
use super::{BandMatrix, SingularAt};

pub use place::{MOST_BORDER_UNKNOWNS, NONE};

/// The factors of one rod's matrix, whatever its elements.
pub trait Chain<F: Number>: Debug + Send + Sync {
    /// Factorises the matrix whose elements `fill` gives by their number, by columns; what the chain leaves of the border is added
    /// to the corner.
    ///
    /// # Errors
    /// The unknown whose pivot is zero, or not a number.
    fn factorize(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<(), SingularAt>;

    /// Forward elimination of a right-hand side in place, the border's part of it too.
    fn forward(&self, b: &mut [F]);

    /// Back substitution, once the border's unknowns are known.
    fn backward(&self, b: &mut [F]);

    /// Memory that the factors take, bytes.
    fn bytes(&self) -> usize;
}

/// A chain of elements with `N` coordinates each.
#[derive(Clone, Debug)]
pub struct FrontalChain<F, const N: usize> {
    places: Vec<ElementPlaces<N>>,
    fronts: Vec<Front<F, N>>,
    /// Of each front one for each of the border's unknowns that the chain has reached there.
    sides: Vec<Side<F, N>>,
    /// The border's unknowns that it touches, in the order in which it reaches them.
    touches: Vec<usize>,
    /// The border's first unknown.
    border: usize,
}

impl<F: Number, const N: usize> FrontalChain<F, N> {
    /// The chain of elements with these unknowns ([`NONE`] where a coordinate is held), of which those from `border` on are the
    /// border's.
    pub fn new(elements: impl Iterator<Item = [u32; N]>, border: usize) -> FrontalChain<F, N> {
        let (mut places, mut touches, mut sides) = (Vec::new(), Vec::new(), 0);
        for unknowns in elements {
            let place = ElementPlaces::new(unknowns, border, &mut touches, sides);
            sides += place.reached;
            places.push(place);
        }
        let front = Front { lu: [[F::zero(); N]; N], swaps: [0; N] };
        let none = [F::zero(); N];
        FrontalChain {
            fronts: vec![front; places.len()],
            sides: vec![Side { right: none, below: none }; sides],
            touches,
            border,
            places,
        }
    }

    /// Memory that the factors take for each element at most, bytes.
    pub const fn bytes_each() -> usize {
        size_of::<Front<F, N>>() + MOST_BORDER_UNKNOWNS * size_of::<Side<F, N>>()
    }

    /// Coordinates that are eliminated in a front: in the last one all.
    fn pivots(&self, element: usize) -> usize {
        if element + 1 == self.places.len() { N } else { N - SHARED }
    }

    /// Sides of an element's front, with the border's unknowns that they belong to.
    fn sides(&self, place: &ElementPlaces<N>) -> impl Iterator<Item = (&Side<F, N>, usize)> {
        self.sides[place.first_side..][..place.reached].iter().zip(self.touches.iter().copied())
    }
}

impl<F: Number, const N: usize> Chain<F> for FrontalChain<F, N> {
    fn factorize(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<(), SingularAt> {
        let mut border = Border::zeros();
        for element in 0..self.places.len() {
            let pivots = self.pivots(element);
            let place = &self.places[element];
            let (before, front) = self.fronts.split_at_mut(element);
            let front = &mut front[0];
            fill(element, front.lu.as_flattened_mut());
            border.advance(place.reached);
            if !place.others.is_empty() {
                border.separate(place, &mut front.lu);
            }
            if let Some(before) = before.last() {
                front.add_rest(before);
            }
            front.eliminate(pivots, place.reached, &mut border).map_err(|k| SingularAt(place.own[k] as usize))?;
            self.sides[place.first_side..][..place.reached].copy_from_slice(&border.sides[..place.reached]);
        }
        for (row, s) in self.touches.iter().zip(&border.corner) {
            for (column, value) in self.touches.iter().zip(s) {
                corner.add(row - self.border, column - self.border, *value);
            }
        }
        Ok(())
    }

    fn forward(&self, b: &mut [F]) {
        let mut shared = [F::zero(); SHARED];
        for (element, (place, front)) in self.places.iter().zip(&self.fronts).enumerate() {
            let pivots = self.pivots(element);
            let mut y = [F::zero(); N];
            y[..SHARED].copy_from_slice(&shared);
            for (y, own) in y[..pivots].iter_mut().zip(place.own) {
                *y += b.get(own as usize).copied().unwrap_or(F::zero());
            }
            for (k, swap) in front.swaps[..pivots].iter().enumerate() {
                y.swap(k, *swap as usize);
            }
            // A whole column each time: what it does to the rows down to k is of no use, and they are put aside before.
            let mut solved = y;
            for k in 0..pivots {
                solved[k] = y[k];
                subtract(y[k], &front.lu[k], &mut y);
            }
            for (side, touched) in self.sides(place) {
                let known = side.below[..pivots].iter().zip(&solved).fold(F::zero(), |sum, (a, b)| sum + *a * *b);
                b[touched] -= known;
            }
            for (solved, own) in solved[..pivots].iter().zip(place.own) {
                if let Some(b) = b.get_mut(own as usize) {
                    *b = *solved;
                }
            }
            shared.copy_from_slice(&y[N - SHARED..]);
        }
    }

    fn backward(&self, b: &mut [F]) {
        let mut shared = [F::zero(); SHARED];
        for (element, (place, front)) in self.places.iter().zip(&self.fronts).enumerate().rev() {
            let pivots = self.pivots(element);
            let mut y = [F::zero(); N];
            for (y, own) in y[..pivots].iter_mut().zip(place.own) {
                *y = b.get(own as usize).copied().unwrap_or(F::zero());
            }
            for (side, touched) in self.sides(place) {
                subtract(b[touched], &side.right, &mut y);
            }
            if pivots < N {
                for (column, known) in front.lu[N - SHARED..].iter().zip(shared) {
                    subtract(known, column, &mut y);
                }
            }
            // As in the forward elimination, with the rows from k on.
            let mut solved = y;
            for k in (0..pivots).rev() {
                solved[k] = y[k] * front.lu[k][k];
                subtract(solved[k], &front.lu[k], &mut y);
            }
            for (solved, own) in solved[..pivots].iter().zip(place.own) {
                if let Some(b) = b.get_mut(own as usize) {
                    *b = *solved;
                }
            }
            shared.copy_from_slice(&solved[..SHARED]);
        }
    }

    fn bytes(&self) -> usize {
        self.places.len() * size_of::<Front<F, N>>() + self.sides.len() * size_of::<Side<F, N>>()
    }
}

#[cfg(test)]
mod tests;
