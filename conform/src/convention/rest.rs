//! Values at rest.

use ancf::state::{CableState, ElementState, evaluate, evaluate_cable};

use crate::suite::State;

/// Value of a quantity of an element whose e is e0.
pub(super) fn value_at_rest(quantity: &str, state: &State) -> Option<Vec<f64>> {
    match state {
        State::Element(state) => evaluate(quantity, &ElementState { e: state.e0, ..(**state).clone() }),
        State::Cable(state) => evaluate_cable(quantity, &CableState { e: state.e0, ..(**state).clone() }),
        State::System(_) => None,
    }
}
