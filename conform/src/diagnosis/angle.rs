//! Mistakes with the inclination θ.

use std::f64::consts::FRAC_PI_2;

use super::{Candidate, Kind, possible};
use ancf::state::{ElementState, evaluate};

type Change = fn(f64) -> f64;

const CHANGES: [(Kind, &str, Change); 5] = [
    (Kind::SinCos, "cos θ and sin θ exchanged", |theta| FRAC_PI_2 - theta),
    (Kind::Sign, "sin θ with the other sign, as where a rotation is transposed", |theta| -theta),
    (Kind::Other, "θ left out: as if the element lay along x", |_| 0.0),
    (Kind::Other, "θ turned into degrees before the cosine", f64::to_degrees),
    (Kind::Other, "θ taken for degrees", f64::to_radians),
];

/// The value for another angle.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let quantity = if quantity == "9.J_0" { "9.J_0/theta" } else { quantity };
    let with = |change: Change| evaluate(quantity, &ElementState { theta: change(state.theta), ..state.clone() });
    CHANGES.into_iter().map(|(kind, what, change)| possible(kind, what, move || with(change))).collect()
}
