//! Linear systems: band matrices, and bands that are coupled by a border.

mod band;
mod bordered;
mod layout;

pub use band::{BandLu, BandMatrix};
pub use bordered::{Bordered, BorderedLu, Filling};
pub use layout::{BlockLayout, Layout};

/// The matrix is singular to working precision at this pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularAt(pub usize);
