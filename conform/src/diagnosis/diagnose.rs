//! Diagnosis of a wrong quantity: which known mistakes explain its answers.

use std::collections::{BTreeMap, BTreeSet};

use ancf::state::ElementState;
use schemars::JsonSchema;
use serde::Serialize;

use super::candidate::Candidate;
use super::entries::wrong_entries;
use super::mistake::{Mistake, MistakeKind};
use super::observation::{Observation, Outcome, distance};
use super::{
    angle, cable, copied, errata, factors, force, functions, gradient, heat, inertia, integral, law, layout, reading,
    solution,
};
use crate::suite::{Case, Reference, State};

/// Largest number of mistakes that are named.
const MOST_NAMED: usize = 3;
/// Smallest number of failing cases from which one of two mistakes is told.
const LEAST_OF_TWO: usize = 2;
/// Number of correct digits from which a wrong answer counts as the right formula, computed imprecisely.
const IMPRECISE_DIGITS: i32 = 6;
/// Distance up to which any mistake explains answers well: the tolerance that the program can attain.
const WELL: f64 = 0.5;
/// Distance up to which values of deliberate mistakes explain answers equally well.
const EQUALLY_WELL: f64 = 0.1;
/// Mistakes that are farther than the nearest by more than this factor explain the answers less well.
const CLEARLY_FARTHER: f64 = 3.0;

/// Diagnosis of a wrong quantity.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Diagnosis {
    /// Mistakes that explain all answers that are numbers, likelier ones first; at most three. Empty if no known mistake does.
    #[serde(rename = "kinds")]
    pub mistakes: Vec<Mistake>,
    /// Whether these are two mistakes at once, in different states. Otherwise each explains all answers.
    pub together: bool,
    /// Tags that all failing cases have and no right one.
    pub only_where: Vec<String>,
    /// Indices of the wrong entries, such as (3, 7), counted from 1. Empty for a number and for more than four entries.
    pub entries: Vec<String>,
    /// Number of failing cases. For cases that were asked again with `given`, the second answer counts.
    pub failing: usize,
    /// Number of failing cases without numbers, by fault.
    pub without_numbers: BTreeMap<&'static str, usize>,
}

/// Finds the mistakes that explain the answers to a quantity.
pub fn diagnose(quantity: &str, observations: &[Observation]) -> Diagnosis {
    let mut without_numbers = BTreeMap::new();
    for observation in observations {
        if let Outcome::Refused(fault) | Outcome::Fault(fault) = observation.outcome {
            *without_numbers.entry(fault.word()).or_default() += 1;
        }
    }
    let (mistakes, together) = match mistakes(quantity, observations) {
        none if none.is_empty() => two_mistakes(quantity, observations).map_or((none, false), |two| (two.into(), true)),
        mistakes => (mistakes, false),
    };
    Diagnosis {
        mistakes,
        together,
        only_where: common_tags(observations),
        entries: wrong_entries(quantity, observations),
        failing: observations.iter().filter(|o| o.outcome != Outcome::Right).count(),
        without_numbers,
    }
}

/// Mistakes that explain every answer, at least one of them wrong. Faults are no evidence.
fn mistakes(quantity: &str, observations: &[Observation]) -> Vec<Mistake> {
    let answered = |o: &&Observation| !matches!(o.outcome, Outcome::Fault(_)) && o.case.values.contains_key(quantity);
    let (right, failing): (Vec<&Observation>, Vec<&Observation>) =
        observations.iter().filter(answered).partition(|o| o.outcome == Outcome::Right);
    // Errors and wrong shapes alone are no evidence of a mistake in a formula.
    if !failing.iter().any(|o| matches!(o.outcome, Outcome::Wrong(_))) {
        return Vec::new();
    }
    // Failing cases come first because they exclude most candidates.
    let judged = [failing, right].concat();
    let mut found = nearest(deliberate_mistakes(quantity, &judged), EQUALLY_WELL);
    found.extend(factors::of_one_term(quantity, &judged));
    if found.is_empty() {
        found.extend(factors::of_two_terms(quantity, &judged));
    }
    // Factors are fitted to the answers, which brings them nearer than a value that is known beforehand.
    let mut found: Vec<Mistake> = nearest(found, WELL).into_iter().map(|(mistake, _)| mistake).collect();
    if found.is_empty() && imprecise(quantity, &judged) {
        let what = "the right formula: single precision, a difference quotient or a coarse quadrature".into();
        found.push(Mistake { kind: MistakeKind::Digits, what });
    }
    found.sort();
    found.dedup();
    found.truncate(MOST_NAMED);
    found
}

/// Two mistakes in different states: one explains the failing cases with some tag, the other one those without it.
fn two_mistakes(quantity: &str, observations: &[Observation]) -> Option<[Mistake; 2]> {
    let (right, failing): (Vec<Observation>, Vec<Observation>) =
        observations.iter().partition(|observation| observation.outcome == Outcome::Right);
    let tags: BTreeSet<&String> = failing.iter().flat_map(|observation| &observation.case.tags).collect();
    tags.into_iter().find_map(|tag| {
        let (with, without): (Vec<Observation>, Vec<Observation>) =
            failing.iter().partition(|observation| observation.case.tags.contains(tag));
        if with.len().min(without.len()) < LEAST_OF_TWO {
            return None;
        }
        let first = |part: &[Observation]| {
            let mistake = mistakes(quantity, &[part, &right].concat()).into_iter().next()?;
            (mistake.kind != MistakeKind::Digits).then_some(mistake)
        };
        let (one, two) = (first(&with)?, first(&without)?);
        let tagged =
            |mistake: Mistake, words: &str| Mistake { what: format!("{}, {words} {tag}", mistake.what), ..mistake };
        Some([tagged(one, "in states tagged"), tagged(two, "in states not tagged")])
    })
}

/// Mistakes that explain the answers about as well as the one that explains them best, or up to a distance.
fn nearest(mut found: Vec<(Mistake, f64)>, enough: f64) -> Vec<(Mistake, f64)> {
    let best = found.iter().map(|(_, away)| *away).fold(f64::INFINITY, f64::min);
    found.retain(|(_, away)| *away <= (CLEARLY_FARTHER * best).max(enough));
    found
}

/// Candidates that explain every answer, each with its largest distance.
fn deliberate_mistakes(quantity: &str, judged: &[&Observation]) -> Vec<(Mistake, f64)> {
    let mut found: Option<BTreeMap<Mistake, f64>> = None;
    for observation in judged {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let mut fitting: BTreeMap<Mistake, f64> = BTreeMap::new();
        for candidate in candidates(quantity, observation.case, reference) {
            let before = match &found {
                Some(found) => found.get(&candidate.mistake).copied(),
                None => Some(0.0),
            };
            let Some(before) = before else { continue };
            let Some(away) = explains((candidate.value)().as_deref(), observation.outcome, reference) else { continue };
            let nearest = fitting.entry(candidate.mistake).or_insert(f64::INFINITY);
            *nearest = nearest.min(away.max(before));
        }
        let none = fitting.is_empty();
        found = Some(fitting);
        if none {
            break;
        }
    }
    found.into_iter().flatten().collect()
}

/// All candidates for a quantity in one case. Wrong factors are not among them.
pub(super) fn candidates<'a>(quantity: &'a str, case: &'a Case, reference: &'a Reference) -> Vec<Candidate<'a>> {
    let mut all = errata::of(quantity, case);
    all.extend(layout::of(reference));
    all.extend(copied::of(quantity, case, reference));
    all.extend(solution::of(quantity, case));
    if let State::Cable(state) = &case.state {
        all.extend(cable::of(quantity, state));
    }
    if let State::Element(state) = &case.state {
        type Of = for<'a> fn(&'a str, &'a ElementState) -> Vec<Candidate<'a>>;
        let all_of: [Of; 9] = [
            angle::of,
            heat::of,
            law::of,
            functions::of,
            gradient::of,
            inertia::of,
            integral::of,
            force::of,
            reading::of,
        ];
        all.extend(all_of.into_iter().flat_map(|of| of(quantity, state)));
    }
    all
}

/// Distance of the value that a mistake gives from an answer that it explains. It explains a wrong one only if it is nearer than half the
/// distance of the reference value.
pub(super) fn explains(value: Option<&[f64]>, outcome: Outcome, reference: &Reference) -> Option<f64> {
    let away = match (outcome, value) {
        (Outcome::Right, Some(value)) => distance(value, &reference.numbers, reference),
        (Outcome::Wrong(answer), Some(value)) => {
            let away = distance(value, answer, reference);
            Some(away).filter(|away| 2.0 * away < distance(&reference.numbers, answer, reference))?
        }
        (Outcome::Refused(_), None) => 0.0,
        _ => return None,
    };
    (away <= 1.0).then_some(away)
}

/// Tags that all failing cases have and no right one.
pub(super) fn common_tags(observations: &[Observation]) -> Vec<String> {
    let (right, failing): (Vec<&Observation>, Vec<&Observation>) =
        observations.iter().partition(|o| o.outcome == Outcome::Right);
    let Some(first) = failing.first() else { return Vec::new() };
    let everywhere = |tag: &&String| failing.iter().all(|o| o.case.tags.contains(tag));
    let nowhere_else = |tag: &&String| !right.is_empty() && !right.iter().any(|o| o.case.tags.contains(tag));
    first.case.tags.iter().filter(everywhere).filter(nowhere_else).cloned().collect()
}

/// Whether every answer has some correct digits.
fn imprecise(quantity: &str, judged: &[&Observation]) -> bool {
    judged.iter().all(|observation| match (observation.outcome, observation.case.values.get(quantity)) {
        (Outcome::Right, _) => true,
        (Outcome::Wrong(answer), Some(reference)) => reference.error(answer) <= 10f64.powi(-IMPRECISE_DIGITS),
        _ => false,
    })
}
