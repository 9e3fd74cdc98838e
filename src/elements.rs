//! The elements of [`equations`](crate::equations), arranged for speed: [`Ancf`] is the paper's, [`Cable`] its competitor.
//! [`PrintedShear`] is the paper's element as printed, not arranged for speed.
//!
//! A structure uses all of them through [`Beam`]. They take displacements u = e − e₀ and thermal strains in the rod's own axes.
//! [`Ancf`] and [`Cable`] never subtract 1 from a number near 1, so small strains keep their digits.
//!
//! Each is written twice: for one element, and for four side by side (`side_by_side.rs`, [`lanes`](crate::lanes)), which a structure uses
//! for what every step needs. The tests hold the latter to the former.

mod ancf;
mod beam;
mod cable;
mod collapse;
mod deviation;
mod layout;
mod nodal_vector;
mod one_by_one;
mod pair;
mod plane;
mod polynomial;
mod printed;
mod section_state;

pub use ancf::{Ancf, Law};
pub use beam::{Beam, Ends, FourEnds, ThermalStrain};
pub use cable::Cable;
pub use deviation::Deviation;
pub use nodal_vector::{Meaning, NodalVector};
pub use printed::PrintedShear;
pub use section_state::SectionState;
