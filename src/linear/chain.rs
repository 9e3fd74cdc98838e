//! LU factors of a chain of elements, each of which shares its last coordinates with the next: a rod.
//!
//! One element after the other is added to a front of its `N` coordinates. Those that no later element touches, which are
//! all of its interior nodes and the node that it shares with the element before, are eliminated there; what they leave of the
//! last node is the beginning of the next front. No zero is stored or multiplied, and every loop is as long as the compiler
//! knows it to be.
//!
//! Coordinates that rods share, the *border*, are not eliminated: they stand beside the front in columns and rows of their own.

use std::fmt::Debug;

use nalgebra::ComplexField;

use super::{BandMatrix, SingularAt};

/// Coordinates that an element shares with the next: two vectors.
const SHARED: usize = 4;

/// Most border unknowns of a chain: two components of two ends and of a pivot.
pub const MOST_TOUCHED: usize = 6;

/// Stands for a coordinate that is no unknown of the chain's own.
pub const NONE: u32 = u32::MAX;

/// A number that matrices are made of: real, or complex for methods whose stages are coupled.
pub trait Number: ComplexField<RealField = f64> + Copy {}
impl<F: ComplexField<RealField = f64> + Copy> Number for F {}

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
pub struct Elements<F, const N: usize> {
    places: Vec<Place<N>>,
    fronts: Vec<Front<F, N>>,
    /// There if the chain touches the border: one for each front.
    sides: Vec<Sides<F, N>>,
    /// The border's unknowns that it touches.
    touches: Vec<usize>,
    /// The border's first unknown.
    border: usize,
}

/// Where an element's coordinates stand.
#[derive(Clone, Debug)]
struct Place<const N: usize> {
    /// Unknowns of the chain's own, [`NONE`] for others.
    own: [u32; N],
    /// Those others: the coordinate, and its place among the touched unknowns of the border; held ones have none.
    others: Vec<(usize, Option<usize>)>,
}

/// What is left of a front.
#[derive(Clone, Debug)]
struct Front<F, const N: usize> {
    /// Column k: the multipliers of pivot k, zero down to it.
    lower: [[F; N]; N],
    /// Column k of the upper factor, without the diagonal; zero from it on.
    upper: [[F; N]; N],
    /// The diagonal's inverse.
    inverse: [F; N],
    /// Row that changed places with row k at step k.
    swaps: [u8; N],
}

/// What the border adds to a front, by its touched unknowns.
#[derive(Clone, Debug)]
struct Sides<F, const N: usize> {
    /// Columns of the border in the front's rows.
    right: [[F; N]; MOST_TOUCHED],
    /// Rows of the border in the front's columns, divided by the pivots.
    below: [[F; N]; MOST_TOUCHED],
}

impl<F: Number, const N: usize> Elements<F, N> {
    /// The chain of elements with these unknowns ([`NONE`] where a coordinate is held), of which those from `border` on are the
    /// border's, and `touches` the ones of them that it touches.
    pub fn new(elements: impl Iterator<Item = [u32; N]>, border: usize, touches: &[usize]) -> Elements<F, N> {
        let places: Vec<Place<N>> = elements.map(|unknowns| Place::new(unknowns, border, touches)).collect();
        let zeros = [[F::zero(); N]; N];
        let front = Front { lower: zeros, upper: zeros, inverse: [F::zero(); N], swaps: [0; N] };
        let none = [[F::zero(); N]; MOST_TOUCHED];
        let sides = if touches.is_empty() { 0 } else { places.len() };
        Elements {
            fronts: vec![front; places.len()],
            sides: vec![Sides { right: none, below: none }; sides],
            touches: touches.to_vec(),
            border,
            places,
        }
    }

    /// Memory that the factors take for each element, bytes.
    pub const fn bytes_each(touches: bool) -> usize {
        size_of::<Front<F, N>>() + if touches { size_of::<Sides<F, N>>() } else { 0 }
    }

    /// Coordinates that are eliminated in a front: in the last one all.
    fn pivots(&self, element: usize) -> usize {
        if element + 1 == self.places.len() { N } else { N - SHARED }
    }
}

impl<const N: usize> Place<N> {
    fn new(unknowns: [u32; N], border: usize, touches: &[usize]) -> Place<N> {
        let own = unknowns.map(|unknown| if (unknown as usize) < border { unknown } else { NONE });
        let others = (0..N).filter(|&n| own[n] == NONE);
        let touch = |n: usize| touches.iter().position(|&touched| touched == unknowns[n] as usize);
        Place { own, others: others.map(|n| (n, touch(n))).collect() }
    }
}

/// The matrix of a front while it is being eliminated, with the border's share.
struct Working<F, const N: usize> {
    own: [[F; N]; N],
    right: [[F; N]; MOST_TOUCHED],
    below: [[F; N]; MOST_TOUCHED],
    corner: [[F; MOST_TOUCHED]; MOST_TOUCHED],
}

impl<F: Number, const N: usize> Working<F, N> {
    fn zeros() -> Working<F, N> {
        Working {
            own: [[F::zero(); N]; N],
            right: [[F::zero(); N]; MOST_TOUCHED],
            below: [[F::zero(); N]; MOST_TOUCHED],
            corner: [[F::zero(); MOST_TOUCHED]; MOST_TOUCHED],
        }
    }

    /// Moves what the last node has left to the first one's place.
    fn advance(&mut self, touched: usize) {
        let first = N - SHARED;
        let shared = |column: &[F; N]| std::array::from_fn(|n| if n < SHARED { column[first + n] } else { F::zero() });
        let old = self.own;
        self.own = std::array::from_fn(|n| if n < SHARED { shared(&old[first + n]) } else { [F::zero(); N] });
        for t in 0..touched {
            (self.right[t], self.below[t]) = (shared(&self.right[t]), shared(&self.below[t]));
        }
    }

    /// Takes what is not the chain's own out of an element's matrix: a coordinate of the border goes beside the front, and a
    /// held one away. An equation x = 0 stays in its place.
    fn separate(&mut self, place: &Place<N>, element: &mut [[F; N]; N]) {
        for &(n, touch) in &place.others {
            if let Some(t) = touch {
                for (m, other) in &place.others {
                    if let Some(s) = other {
                        self.corner[t][*s] += element[*m][n];
                    }
                }
                for m in (0..N).filter(|&m| place.own[m] != NONE) {
                    self.right[t][m] += element[n][m];
                    self.below[t][m] += element[m][n];
                }
            }
        }
        for &(n, _) in &place.others {
            element[n] = [F::zero(); N];
            element.iter_mut().for_each(|column| column[n] = F::zero());
            element[n][n] = F::one();
        }
    }

    fn add(&mut self, element: &[[F; N]; N]) {
        for (column, other) in self.own.iter_mut().zip(element) {
            column.iter_mut().zip(other).for_each(|(entry, other)| *entry += *other);
        }
    }

    /// Brings the largest entry of column k among the rows that are eliminated here to the diagonal.
    fn pivot(&mut self, k: usize, pivots: usize, touched: usize, front: &mut Front<F, N>) {
        let size = |row: usize| self.own[k][row].norm1();
        let largest = (k + 1..pivots).fold(k, |best, row| if size(row) > size(best) { row } else { best });
        front.swaps[k] = largest as u8;
        if largest != k {
            self.own.iter_mut().for_each(|column| column.swap(k, largest));
            front.lower[..k].iter_mut().for_each(|column| column.swap(k, largest));
            self.right[..touched].iter_mut().for_each(|column| column.swap(k, largest));
        }
    }

    /// Eliminates the first `pivots` coordinates.
    #[inline(always)]
    fn eliminate(&mut self, pivots: usize, touched: usize, front: &mut Front<F, N>) -> Result<(), usize> {
        for k in 0..pivots {
            self.pivot(k, pivots, touched, front);
            let diagonal = self.own[k][k];
            let inverse = F::one() / diagonal;
            if diagonal.is_zero() || !inverse.is_finite() {
                return Err(k);
            }
            let mut lower = self.own[k].map(|entry| entry * inverse);
            lower[..=k].fill(F::zero());
            for column in &mut self.own[k + 1..] {
                subtract(column[k], &lower, column);
            }
            if touched > 0 {
                self.eliminate_sides(k, touched, inverse, &lower);
            }
            (front.lower[k], front.inverse[k]) = (lower, inverse);
        }
        for (k, column) in self.own.iter().enumerate() {
            front.upper[k] = std::array::from_fn(|row| if row < k.min(pivots) { column[row] } else { F::zero() });
        }
        Ok(())
    }

    fn eliminate_sides(&mut self, k: usize, touched: usize, inverse: F, lower: &[F; N]) {
        let row: [F; N] = std::array::from_fn(|column| if column > k { self.own[column][k] } else { F::zero() });
        let pivots_right: [F; MOST_TOUCHED] = std::array::from_fn(|t| self.right[t][k]);
        for t in 0..touched {
            subtract(pivots_right[t], lower, &mut self.right[t]);
            let factor = self.below[t][k] * inverse;
            subtract(factor, &row, &mut self.below[t]);
            self.below[t][k] = factor;
            subtract(factor, &pivots_right, &mut self.corner[t]);
        }
    }
}

/// Takes `factor` · `column` off `from`.
#[inline(always)]
fn subtract<F: Number, const N: usize>(factor: F, column: &[F; N], from: &mut [F; N]) {
    for (from, entry) in from.iter_mut().zip(column) {
        *from -= factor * *entry;
    }
}

impl<F: Number, const N: usize> Chain<F> for Elements<F, N> {
    fn factorize(
        &mut self,
        fill: &mut dyn FnMut(usize, &mut [F]),
        corner: &mut BandMatrix<F>,
    ) -> Result<(), SingularAt> {
        let touched = self.touches.len();
        let mut working = Working::zeros();
        let mut matrix = [[F::zero(); N]; N];
        for element in 0..self.places.len() {
            let pivots = self.pivots(element);
            let place = &self.places[element];
            if element > 0 {
                working.advance(touched);
            }
            fill(element, matrix.as_flattened_mut());
            if !place.others.is_empty() {
                working.separate(place, &mut matrix);
            }
            working.add(&matrix);
            working
                .eliminate(pivots, touched, &mut self.fronts[element])
                .map_err(|k| SingularAt(place.own[k] as usize))?;
            if let Some(sides) = self.sides.get_mut(element) {
                (sides.right, sides.below) = (working.right, working.below);
            }
        }
        for (row, s) in self.touches.iter().zip(&working.corner) {
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
            for k in 0..pivots {
                subtract(y[k], &front.lower[k], &mut y);
            }
            if let Some(sides) = self.sides.get(element) {
                for (below, &touched) in sides.below.iter().zip(&self.touches) {
                    let known = below[..pivots].iter().zip(&y).fold(F::zero(), |sum, (a, b)| sum + *a * *b);
                    b[touched] -= known;
                }
            }
            for (y, own) in y[..pivots].iter().zip(place.own) {
                if let Some(b) = b.get_mut(own as usize) {
                    *b = *y;
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
            if let Some(sides) = self.sides.get(element) {
                for (right, &touched) in sides.right.iter().zip(&self.touches) {
                    subtract(b[touched], right, &mut y);
                }
            }
            if pivots < N {
                y[N - SHARED..].copy_from_slice(&shared);
                for k in N - SHARED..N {
                    subtract(y[k], &front.upper[k], &mut y);
                }
            }
            for k in (0..pivots).rev() {
                y[k] *= front.inverse[k];
                subtract(y[k], &front.upper[k], &mut y);
            }
            for (y, own) in y[..pivots].iter().zip(place.own) {
                if let Some(b) = b.get_mut(own as usize) {
                    *b = *y;
                }
            }
            shared.copy_from_slice(&y[..SHARED]);
        }
    }

    fn bytes(&self) -> usize {
        self.places.len() * Self::bytes_each(!self.touches.is_empty())
    }
}

#[cfg(test)]
mod tests;
