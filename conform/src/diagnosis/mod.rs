//! What kind of mistake a wrong equation shows.
//!
//! Known mistakes are made on purpose, each kind in a file of its own, and what they give is compared with what was answered, in the
//! failing cases and in those that are right. Factors and signs are not guessed but found: `factors` asks by how much each term of an
//! equation would have to be multiplied.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use super::suite::{Case, Parsed, Reference};
use super::verdict::Fault;
use ancf::state::ElementState;

mod angle;
mod copied;
mod errata;
mod factors;
mod gradient;
mod heat;
mod inertia;
mod integral;
mod kind;
mod law;
mod layout;
mod places;
mod power;
mod reading;
mod stations;
mod terms;

pub use kind::Kind;

/// A mistake that is made on purpose has to give the answer to this many tolerances.
const LOOSE: f64 = 1e3;
/// So many kinds are named at most.
const NAMED: usize = 3;
/// Digits from which on a wrong answer is taken for the right formula, carelessly computed.
const ROUGH: f64 = 6.0;

/// A kind, and what is done wrong in words.
pub type Name = (Kind, String);

/// A mistake made on purpose, and what it gives in one case; computed when it is asked for.
struct Candidate<'a> {
    name: Name,
    value: Box<dyn Fn() -> Option<Vec<f64>> + 'a>,
}

/// A candidate with a value.
fn candidate<'a>(kind: Kind, what: impl Into<String>, value: impl Fn() -> Vec<f64> + 'a) -> Candidate<'a> {
    possible(kind, what, move || Some(value()))
}

/// A candidate that may have none: then the program cannot have one either.
fn possible<'a>(kind: Kind, what: impl Into<String>, value: impl Fn() -> Option<Vec<f64>> + 'a) -> Candidate<'a> {
    Candidate { name: (kind, what.into()), value: Box::new(value) }
}

/// A case, and what was answered in it.
#[derive(Clone, Copy, Debug)]
pub struct Observation<'a> {
    /// The state with its reference values.
    pub case: &'a Case,
    /// What came.
    pub seen: Seen<'a>,
}

/// What was answered in one case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Seen<'a> {
    /// The right numbers.
    Right,
    /// Wrong ones.
    Numbers(&'a [f64]),
    /// The program's own error, or another shape: as where a mistake leaves nothing to be computed.
    Refused(&'a Fault),
    /// No numbers for other reasons: no mistake in a formula gives these.
    Fault(&'a Fault),
}

/// What is known of a mistake.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Kind and what is done wrong, the likeliest first; none if no known kind fits.
    pub kinds: Vec<Name>,
    /// Where the failing cases differ from the others.
    pub only_where: Vec<String>,
    /// Entries that are wrong in some case, if they are not all.
    pub entries: Vec<String>,
    /// Failing cases.
    pub failing: usize,
    /// How many of them have no numbers, by what came.
    pub without_numbers: BTreeMap<&'static str, usize>,
}

/// Looks for the kinds that give every answer to the quantity.
pub fn diagnose(quantity: &str, observations: &[Observation]) -> Finding {
    let mut without_numbers = BTreeMap::new();
    for observation in observations {
        if let Seen::Refused(fault) | Seen::Fault(fault) = observation.seen {
            *without_numbers.entry(fault.word()).or_default() += 1;
        }
    }
    Finding {
        kinds: kinds(quantity, observations),
        only_where: places::only_where(observations),
        entries: places::wrong_entries(quantity, observations),
        failing: observations.iter().filter(|o| o.seen != Seen::Right).count(),
        without_numbers,
    }
}

/// The kinds that give every answer and at least one wrong one. What came in place of numbers speaks neither for a kind nor against it.
fn kinds(quantity: &str, observations: &[Observation]) -> Vec<Name> {
    let answered = |o: &&Observation| !matches!(o.seen, Seen::Fault(_)) && o.case.values.contains_key(quantity);
    let (right, failing): (Vec<&Observation>, Vec<&Observation>) =
        observations.iter().filter(answered).partition(|o| o.seen == Seen::Right);
    // Where nothing but errors and other shapes came, there is nothing that a kind could explain.
    if !failing.iter().any(|o| matches!(o.seen, Seen::Numbers(_))) {
        return Vec::new();
    }
    // Failing ones first: they leave the fewest to be compared with the others.
    let judged = [failing, right].concat();
    let mut kinds: Vec<Name> = made_on_purpose(quantity, &judged).into_iter().collect();
    kinds.extend(factors::of_one_term(quantity, &judged));
    if kinds.is_empty() {
        kinds.extend(factors::of_two_terms(quantity, &judged));
    }
    if kinds.is_empty() && carelessly_computed(quantity, &judged) {
        kinds.push((
            Kind::Digits,
            "the right formula: single precision, a difference quotient or a coarse quadrature".into(),
        ));
    }
    kinds.sort();
    kinds.dedup();
    kinds.truncate(NAMED);
    kinds
}

/// The candidates that give every answer.
fn made_on_purpose(quantity: &str, judged: &[&Observation]) -> BTreeSet<Name> {
    let mut alive: Option<BTreeSet<Name>> = None;
    for observation in judged {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let fitting: BTreeSet<Name> = candidates(quantity, observation.case, reference)
            .into_iter()
            .filter(|candidate| alive.as_ref().is_none_or(|alive| alive.contains(&candidate.name)))
            .filter(|candidate| fits(candidate, observation.seen, reference))
            .map(|candidate| candidate.name)
            .collect();
        if fitting.is_empty() {
            return fitting;
        }
        alive = Some(fitting);
    }
    alive.unwrap_or_default()
}

/// Everything that could have been done wrong but for factors.
fn candidates<'a>(quantity: &'a str, case: &'a Case, reference: &'a Reference) -> Vec<Candidate<'a>> {
    let mut all = errata::of(quantity, case);
    all.extend(layout::of(quantity, reference));
    all.extend(copied::of(quantity, case, reference));
    if let Parsed::Element(state) = &case.parsed {
        all.extend(of_element(quantity, state));
    }
    all
}

fn of_element<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let mut all = angle::of(quantity, state);
    all.extend(heat::of(quantity, state));
    all.extend(law::of(quantity, state));
    all.extend(gradient::of(quantity, state));
    all.extend(inertia::of(quantity, state));
    all.extend(integral::of(quantity, state));
    all.extend(reading::of(quantity, state));
    all
}

/// Whether a candidate explains what was seen: a wrong answer only if it is much nearer than the right value.
fn fits(candidate: &Candidate, seen: Seen, reference: &Reference) -> bool {
    let value = (candidate.value)();
    match (seen, value) {
        (Seen::Right, Some(value)) => distance(&value, &reference.numbers, reference) <= LOOSE,
        (Seen::Numbers(answer), Some(value)) => {
            let away = distance(&value, answer, reference);
            away <= LOOSE && 2.0 * away < distance(&reference.numbers, answer, reference)
        }
        (Seen::Refused(_), None) => true,
        _ => false,
    }
}

/// How far a value is from an answer, in tolerances of the worst entry.
fn distance(value: &[f64], answer: &[f64], reference: &Reference) -> f64 {
    if value.len() != answer.len() || value.len() != reference.numbers.len() {
        return f64::INFINITY;
    }
    let entries = value.iter().zip(answer).zip(reference.absolute.iter().zip(&reference.numbers));
    entries.fold(0.0, |worst: f64, ((a, b), (bound, right))| {
        // Where a mistake makes terms larger, they are rounded accordingly.
        let larger = reference.relative * (a.abs() - right.abs()).max(0.0);
        let away = (a - b).abs() / (bound + larger);
        if away.is_nan() { f64::INFINITY } else { worst.max(away) }
    })
}

/// Whether every answer is the right one to some digits.
fn carelessly_computed(quantity: &str, judged: &[&Observation]) -> bool {
    judged.iter().all(|observation| match (observation.seen, observation.case.values.get(quantity)) {
        (Seen::Right, _) => true,
        (Seen::Numbers(answer), Some(reference)) => {
            let pairs = answer.iter().zip(&reference.numbers).zip(&reference.absolute);
            pairs.fold(0.0_f64, |worst, ((a, b), bound)| worst.max((a - b).abs() / bound)) * reference.relative
                <= 10f64.powf(-ROUGH)
        }
        _ => false,
    })
}

/// The numbers of a matrix, row by row.
fn rows<R: nalgebra::Dim, C: nalgebra::Dim, S: nalgebra::RawStorage<f64, R, C>>(
    matrix: &nalgebra::Matrix<f64, R, C, S>,
) -> Vec<f64> {
    matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect()
}

#[cfg(test)]
mod tests;
