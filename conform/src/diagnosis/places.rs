//! Where answers are wrong: in which entries, and in which states.

use std::collections::BTreeSet;

use super::{Observation, Seen};
use crate::graph::is_of_a_point;
use crate::suite::Reference;

/// Entries that are named at most.
const SHOWN: usize = 4;

/// Tags that all failing cases have and no right one.
pub(super) fn only_where(observations: &[Observation]) -> Vec<String> {
    let (right, failing): (Vec<&Observation>, Vec<&Observation>) =
        observations.iter().partition(|o| o.seen == Seen::Right);
    let Some(first) = failing.first() else { return Vec::new() };
    let everywhere = |tag: &&String| failing.iter().all(|o| o.case.tags.contains(tag));
    let nowhere_else = |tag: &&String| !right.is_empty() && !right.iter().any(|o| o.case.tags.contains(tag));
    first.case.tags.iter().filter(everywhere).filter(nowhere_else).cloned().collect()
}

/// Places of the entries that are wrong in some case, unless there are too many to name.
pub(super) fn wrong_entries(quantity: &str, observations: &[Observation]) -> Vec<String> {
    let mut places = BTreeSet::new();
    for observation in observations {
        let (Seen::Numbers(answer), Some(reference)) = (observation.seen, observation.case.values.get(quantity)) else {
            continue;
        };
        let shape = own_shape(quantity, reference);
        let size = shape.iter().product::<usize>().max(1);
        let wrong = |n: usize| Some((answer.get(n)? - reference.numbers.get(n)?).abs() > *reference.absolute.get(n)?);
        places.extend((0..answer.len()).filter(|n| wrong(*n) == Some(true)).map(|n| place(n % size, shape)));
        if size == 1 {
            return Vec::new();
        }
    }
    if places.len() > SHOWN { Vec::new() } else { places.into_iter().collect() }
}

/// An entry's place, such as (3, 7), counted from 1.
pub(super) fn place(entry: usize, shape: &[usize]) -> String {
    let mut rest = entry;
    let mut indices: Vec<String> = shape
        .iter()
        .rev()
        .map(|length| {
            let index = rest % length.max(&1);
            rest /= length.max(&1);
            (index + 1).to_string()
        })
        .collect();
    indices.reverse();
    format!("({})", indices.join(", "))
}

/// The shape of a quantity at one point.
pub(super) fn own_shape<'a>(quantity: &str, reference: &'a Reference) -> &'a [usize] {
    match is_of_a_point(quantity) {
        true => reference.shape.get(1..).unwrap_or_default(),
        false => &reference.shape,
    }
}
