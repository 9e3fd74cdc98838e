//! Mistakes in the inclination θ.

use std::f64::consts::FRAC_PI_2;

use super::candidate::{Candidate, possible};
use super::mistake::MistakeKind::{self, Other, Sign, SinCos};
use ancf::state::{ElementState, evaluate};

type Change = fn(f64) -> f64;

const CHANGES: [(MistakeKind, &str, Change); 5] = [
    (SinCos, "cos θ and sin θ exchanged", |theta| FRAC_PI_2 - theta),
    (Sign, "sin θ with the wrong sign: a transposed rotation", |theta| -theta),
    (Other, "θ omitted: the element taken as horizontal", |_| 0.0),
    (Other, "θ converted to degrees before sine and cosine", f64::to_degrees),
    (Other, "θ read as degrees", f64::to_radians),
];

/// Candidates with another angle.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let quantity = if quantity == "9.J_0" { "9.J_0/theta" } else { quantity };
    let with = |change: Change| evaluate(quantity, &ElementState { theta: change(state.theta), ..state.clone() });
    CHANGES.into_iter().map(|(kind, what, change)| possible(kind, what, move || with(change))).collect()
}
