//! Values of other quantities: a copied line that was not changed, or a wrong letter.

use super::candidate::{Candidate, candidate};
use super::mistake::MistakeKind::Other;
use crate::suite::{Case, Reference};

/// Numbers of a state that can be confused.
const NUMBERS: [&str; 8] = ["l", "h", "w", "theta", "E", "nu", "rho", "alpha"];

/// Candidates with the value of another quantity of equal shape; for a number also with a number of the state.
pub(super) fn of<'a>(quantity: &str, case: &'a Case, reference: &Reference) -> Vec<Candidate<'a>> {
    let same_shape = |(name, value): &(&String, &Reference)| {
        name.as_str() != quantity && !name.contains('/') && value.shape == reference.shape
    };
    let mut all: Vec<Candidate> = (case.values.iter())
        .filter(same_shape)
        .map(|(name, value)| candidate(Other, format!("the value of {name}"), || value.numbers.clone()))
        .collect();
    if reference.shape.is_empty() {
        let known = NUMBERS.into_iter().filter_map(|name| Some((name, case.state_json[name].as_f64()?)));
        all.extend(known.map(|(name, value)| candidate(Other, format!("{name} itself"), move || vec![value])));
    }
    all
}
