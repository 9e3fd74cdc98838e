//! Linear systems: chains of elements that are coupled by a border, for pinned rods; bands that are, where multipliers stand
//! beside the coordinates.

mod band;
mod bordered;
mod chain;
mod chains;
mod layout;

pub use band::{BandLu, BandMatrix};
pub use bordered::{Bordered, BorderedLu, Filling};
pub use chain::{Chain, Elements, MOST_TOUCHED, NONE, Number};
pub use chains::Chains;
pub use layout::{BlockLayout, Layout};

/// The matrix is singular to working precision at this pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularAt(pub usize);
