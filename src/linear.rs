//! Linear systems of structures.
//!
//! In the condensed form each rod is a chain of elements, and a border couples the chains: [`CondensedFactors`]. With
//! multipliers among the unknowns each rod is a band, and a border couples the bands: [`Bordered`].

mod band;
mod block_lanczos;
mod bordered;
mod condensed;
mod frontal;
mod lanczos;
mod layout;
mod ldlt;
mod modes;
mod number;

pub use band::{BandLu, BandMatrix};
pub use block_lanczos::{Eigenpairs, largest_eigenvalues};
pub use bordered::{BlockMut, Bordered, BorderedLu, InertiaMemory};
pub use condensed::CondensedFactors;
pub use frontal::{Chain, FrontalChain, NO_UNKNOWN};
pub use lanczos::{Pencil, largest_eigenvalue};
pub use layout::{BlockLayout, Layout};
pub use modes::{Modes, smallest_modes};
pub use number::Number;

use nalgebra::DVector;

/// Pivot at which a matrix is singular to working precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularAt(pub usize);

/// Size of a negligible entry, relative to the largest of the solution.
const NEGLIGIBLE: f64 = 1e-100;

/// Shortest vector that is checked: in a shorter one each entry would have to be a third of the one before to become so
/// small.
const LONG_VECTOR: usize = 200;

/// Sets entries below 10⁻¹⁰⁰ of the largest to zero, in long vectors. A load at one end of a long structure decays
/// exponentially along it, and arithmetic with underflowing numbers is a hundred times slower than with zeros.
pub fn flush_negligible<F: Number>(b: &mut DVector<F>) {
    if b.len() < LONG_VECTOR {
        return;
    }
    // Eight independent maxima at a time: a single one would make every comparison wait for the one before.
    let (mut largest, mut least) = ([0.0; 8], [f64::INFINITY; 8]);
    let (chunks, last) = b.as_slice().as_chunks::<8>();
    for values in chunks.iter().map(<[F; 8]>::as_slice).chain([last]) {
        for ((x, largest), least) in values.iter().zip(&mut largest).zip(&mut least) {
            let size = x.norm1();
            *largest = if size > *largest { size } else { *largest };
            *least = if size < *least { size } else { *least };
        }
    }
    let limit = NEGLIGIBLE * largest.into_iter().fold(0.0, f64::max);
    if least.into_iter().any(|least| least < limit) {
        b.iter_mut().filter(|x| x.norm1() < limit).for_each(|x| *x = F::zero());
    }
}
