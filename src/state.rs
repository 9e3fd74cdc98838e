//! States to evaluate the equations for: of one element, of one [`cable`](crate::equations::cable) element.
//!
//! | state | read by | evaluated by |
//! |---|---|---|
//! | [`ElementState`] | [`ElementState::parse`] | [`evaluate`] |
//! | [`CableState`] | [`CableState::parse`] | [`evaluate_cable`] |
//!
//! The JSON form of a state is a contract: the fixtures and other programs use it.

mod beam;
mod cable;
mod element;
mod entries;
mod parse;
mod system;

pub use crate::model::ThermalModel;
pub use beam::{BeamState, CableState, ElementState};
pub use cable::evaluate_cable;
pub use element::evaluate;

/// The terms of (23), which only the conformance kit evaluates by name.
pub(crate) mod inside {
    pub use crate::state::system::{SystemState, evaluate_system};
}
