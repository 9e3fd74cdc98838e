//! Answers to one quantity, case by case.

use crate::suite::{Case, Reference};
use crate::verdict::Fault;

/// A mistake explains an answer if their distance is at most this many tolerances of the fixtures.
const LOOSE: f64 = 1e3;
/// The same at the precision of the program, where tolerances are wide already.
const TIGHT: f64 = 2.0;

/// A case and the answer in it.
#[derive(Clone, Copy, Debug)]
pub struct Observation<'a> {
    /// State with reference values.
    pub case: &'a Case,
    /// The program's answer.
    pub outcome: Outcome<'a>,
}

/// The program's answer in one case, as evidence of a mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome<'a> {
    /// Numbers within their tolerances.
    Right,
    /// Numbers out of tolerance.
    Wrong(&'a [f64]),
    /// An error of the program or a wrong shape: a mistake may have left no value.
    Refused(&'a Fault),
    /// Any other fault. No mistake in a formula explains it.
    Fault(&'a Fault),
}

/// Distance up to which a mistake explains each entry of an answer.
pub(super) fn matching(reference: &Reference) -> impl Iterator<Item = f64> {
    let entries = reference.absolute.iter().zip(reference.tolerances());
    entries.map(|(fixture, attainable)| (LOOSE * fixture).max(TIGHT * attainable))
}

/// The same for a term, relative to it.
pub(super) fn matching_relative(reference: &Reference) -> f64 {
    let attainable = reference.attainable.as_ref().map_or(0.0, |attainable| attainable.relative);
    (LOOSE * reference.relative).max(TIGHT * attainable)
}

/// Distance between a value and an answer in the worst entry. A mistake explains the answer if it is at most 1.
pub(super) fn distance(value: &[f64], answer: &[f64], reference: &Reference) -> f64 {
    if value.len() != answer.len() || value.len() != reference.numbers.len() {
        return f64::INFINITY;
    }
    let relative = matching_relative(reference);
    let entries = value.iter().zip(answer).zip(matching(reference).zip(&reference.numbers));
    largest(entries.map(|((a, b), (bound, right))| {
        // Terms that a mistake makes larger have larger rounding errors.
        let larger = relative * (a.abs() - right.abs()).max(0.0);
        (a - b).abs() / (bound + larger)
    }))
}

/// Largest distance; infinite if one is NaN.
pub(super) fn largest(distances: impl Iterator<Item = f64>) -> f64 {
    distances.fold(0.0, |worst: f64, next| if next.is_nan() { f64::INFINITY } else { worst.max(next) })
}
