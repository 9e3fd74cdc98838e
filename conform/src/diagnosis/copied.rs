//! Another value in the place of the right one: a line that was copied and not changed, a letter for another.

use super::{Candidate, Kind, candidate};
use crate::suite::{Case, Reference};

/// Numbers of a state that can be taken for another.
const NUMBERS: [&str; 8] = ["l", "h", "w", "theta", "E", "nu", "rho", "alpha"];

/// The values of all other quantities of the same shape, and of a number the state's own numbers.
pub(super) fn of<'a>(quantity: &str, case: &'a Case, reference: &Reference) -> Vec<Candidate<'a>> {
    let same_shape = |(name, value): &(&String, &Reference)| {
        name.as_str() != quantity && !name.contains('/') && value.shape == reference.shape
    };
    let mut all: Vec<Candidate> = (case.values.iter())
        .filter(same_shape)
        .map(|(name, value)| candidate(Kind::Other, format!("the value of {name}"), || value.numbers.clone()))
        .collect();
    if reference.shape.is_empty() {
        let known = NUMBERS.into_iter().filter_map(|name| Some((name, case.state[name].as_f64()?)));
        all.extend(known.map(|(name, value)| candidate(Kind::Other, format!("{name} itself"), move || vec![value])));
    }
    all
}
