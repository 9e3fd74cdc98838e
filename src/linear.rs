//! Linear systems: chains of elements that are coupled by a border, for pinned rods; bands that are, where multipliers stand
//! beside the coordinates.

mod band;
mod banded_ldlt;
mod bordered;
mod condensed;
mod frontal;
mod lanczos;
mod layout;
mod number;

pub use band::{BandLu, BandMatrix};
pub use banded_ldlt::BandedLdlt;
pub use bordered::{Bordered, BorderedLu, Filling};
pub use condensed::CondensedFactors;
pub use frontal::{Chain, FrontalChain, MOST_BORDER_UNKNOWNS, NONE};
pub use lanczos::{Pencil, largest_eigenvalue};
pub use layout::{BlockLayout, Layout};
pub use number::Number;

use nalgebra::DVector;

/// The matrix is singular to working precision at this pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularAt(pub usize);

/// Part of the largest entry of a solution below which an entry is nothing.
const NOTHING: f64 = 1e-100;

/// In a shorter vector entries would have to fall to a third of the one before, all along, to become so small.
const LONG: usize = 200;

/// Sets to zero what is less than 10⁻¹⁰⁰ of the largest entry of a long vector: what acts on one end of a long structure dies out
/// exponentially along it, and numbers that underflow are computed a hundred times slower than zeros.
pub fn flush<F: Number>(b: &mut DVector<F>) {
    if b.len() < LONG {
        return;
    }
    // Four at a time: one after the other they would wait for one another.
    let (mut largest, mut least) = ([0.0; 4], [f64::INFINITY; 4]);
    let (chunks, last) = b.as_slice().as_chunks::<4>();
    for values in chunks.iter().map(<[F; 4]>::as_slice).chain([last]) {
        for ((x, largest), least) in values.iter().zip(&mut largest).zip(&mut least) {
            let size = x.norm1();
            *largest = if size > *largest { size } else { *largest };
            *least = if size < *least { size } else { *least };
        }
    }
    let nothing = NOTHING * largest.into_iter().fold(0.0, f64::max);
    if least.into_iter().any(|least| least < nothing) {
        b.iter_mut().filter(|x| x.norm1() < nothing).for_each(|x| *x = F::zero());
    }
}
