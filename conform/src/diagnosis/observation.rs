//! Answers to one quantity, case by case.

use crate::suite::{Case, Reference};
use crate::verdict::Fault;

/// A mistake explains an answer if their distance is at most this many tolerances.
pub(super) const LOOSE: f64 = 1e3;

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

/// Distance between a value and an answer, in tolerances of the worst entry.
pub(super) fn distance(value: &[f64], answer: &[f64], reference: &Reference) -> f64 {
    if value.len() != answer.len() || value.len() != reference.numbers.len() {
        return f64::INFINITY;
    }
    let entries = value.iter().zip(answer).zip(reference.absolute.iter().zip(&reference.numbers));
    entries.fold(0.0, |worst: f64, ((a, b), (bound, right))| {
        // Terms that a mistake makes larger have larger rounding errors.
        let larger = reference.relative * (a.abs() - right.abs()).max(0.0);
        let away = (a - b).abs() / (bound + larger);
        if away.is_nan() { f64::INFINITY } else { worst.max(away) }
    })
}
