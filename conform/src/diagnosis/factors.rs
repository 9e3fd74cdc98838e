//! Factors of an equation's terms that explain the answers.

use std::collections::BTreeMap;

use super::mistake::Mistake;
use super::mistake::MistakeKind::{Heat, Other, Sign};
use super::observation::{Observation, Outcome, largest, matching, matching_relative};
use super::power::{PowerLaw, Sample, fraction, numbers_of};
use super::terms;
use super::terms::term::Term;
use crate::suite::{Case, Reference};

/// Largest number of terms of which pairs are tried.
const MOST_TERMS: usize = 24;
/// Smallest number of cases that must show a factor that is not constant.
const LEAST_CASES: usize = 3;
/// Relative distance of two factors at once from simple fractions, in double precision.
const FRACTION: f64 = 1e-6;

/// Error of the answer and the terms in one case, in units of what is explained.
struct Scaled {
    excess: Vec<f64>,
    terms: Vec<Vec<f64>>,
    relative: f64,
}

/// Answer minus reference value, each entry in units of the distance that is explained; `None` without numbers.
fn excess(outcome: Outcome, reference: &Reference) -> Option<Vec<f64>> {
    match outcome {
        Outcome::Right => Some(vec![0.0; reference.numbers.len()]),
        Outcome::Wrong(answer) => {
            let entries = answer.iter().zip(&reference.numbers).zip(matching(reference));
            Some(entries.map(|((answer, right), bound)| (answer - right) / bound).collect())
        }
        Outcome::Refused(_) | Outcome::Fault(_) => None,
    }
}

/// Mistakes that multiply one term by one factor, each with the largest distance that it leaves.
pub(super) fn of_one_term(quantity: &str, judged: &[&Observation]) -> Vec<(Mistake, f64)> {
    let mut by_name: BTreeMap<String, Factors> = BTreeMap::new();
    let mut first = true;
    for observation in judged {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let Some(excess) = excess(observation.outcome, reference) else { return Vec::new() };
        let mut terms = terms::of(quantity, observation.case);
        terms.extend(terms::parts(reference));
        terms.extend(terms::of_points(quantity, observation.case));
        let mut explained_by = BTreeMap::new();
        for term in terms {
            let mut factors = match by_name.remove(&term.name) {
                Some(factors) => factors,
                None if first => Factors { belongs: term.belongs, samples: Vec::new(), left: 0.0 },
                None => continue,
            };
            match sample(&term, &excess, reference, observation.case) {
                Explained::No => continue,
                Explained::Always => {}
                Explained::By(sample, left) => {
                    factors.samples.push(sample);
                    factors.left = factors.left.max(left);
                }
            }
            explained_by.insert(term.name, factors);
        }
        (by_name, first) = (explained_by, false);
    }
    let explains = |(name, factors): (String, Factors)| Some((mistake(&name, &factors)?, factors.left));
    by_name.into_iter().filter_map(explains).collect()
}

/// Factors of one term, case by case.
struct Factors {
    belongs: bool,
    samples: Vec<Sample>,
    /// Largest distance that the factors leave unexplained.
    left: f64,
}

/// Whether a factor of a term explains the answer in one case.
enum Explained {
    /// No factor explains the answer.
    No,
    /// Any factor does: the answer is right and the term is zero.
    Always,
    /// One factor does, up to a distance.
    By(Sample, f64),
}

fn sample(term: &Term, excess: &[f64], reference: &Reference, case: &Case) -> Explained {
    let scaled: Vec<f64> = term.numbers.iter().zip(matching(reference)).map(|(value, bound)| value / bound).collect();
    let relative = matching_relative(reference);
    let size = scaled.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    let square: f64 = scaled.iter().map(|value| value * value).sum();
    let along = scaled.iter().zip(excess).map(|(term, excess)| term * excess).sum::<f64>();
    let added = if square > 0.0 { along / square } else { 0.0 };
    // Terms that a mistake makes larger have larger rounding errors.
    let unexplained = |(excess, term): (&f64, &f64)| (excess - added * term).abs() / (1.0 + relative * excess.abs());
    let left = largest(excess.iter().zip(&scaled).map(unexplained));
    let of = numbers_of(case);
    let factor = if term.belongs { 1.0 + added } else { added };
    match left <= 1.0 {
        false => Explained::No,
        true if size <= 10.0 => Explained::Always,
        true => Explained::By(Sample { factor, within: (1.0 + relative * added.abs() * size) / size, of }, left),
    }
}

/// The mistake that a term's factors show; `None` if they follow no law, or are all neutral.
fn mistake(name: &str, Factors { belongs, samples, .. }: &Factors) -> Option<Mistake> {
    let neutral = if *belongs { 1.0 } else { 0.0 };
    let shows = |sample: &&Sample| (sample.factor - neutral).abs() > sample.within.max(1e-9);
    let shown = samples.iter().filter(shows).count();
    let law = PowerLaw::of(samples).filter(|law| law.is_constant() || shown >= LEAST_CASES)?;
    if shown == 0 {
        return None;
    }
    let (kind, words) = law.words();
    if *belongs {
        return Some(Mistake { kind, what: format!("{name} {words}") });
    }
    let sign = if kind == Sign { "minus" } else { "plus" };
    let kind = if name.contains("ε_T") { Heat } else { Other };
    Some(Mistake { kind, what: format!("{sign} {name}, which does not belong there") })
}

/// Mistakes that multiply two terms by a simple fraction each, each with the largest distance that it leaves.
pub(super) fn of_two_terms(quantity: &str, judged: &[&Observation]) -> Vec<(Mistake, f64)> {
    let mut names: Vec<String> = Vec::new();
    let mut cases: Vec<Scaled> = Vec::new();
    for observation in judged {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let Some(excess) = excess(observation.outcome, reference) else { return Vec::new() };
        let terms: Vec<Term> = terms::of(quantity, observation.case).into_iter().filter(|term| term.belongs).collect();
        names = terms.iter().map(|term| term.name.clone()).collect();
        if names.len() > MOST_TERMS {
            return Vec::new();
        }
        let scaled = |term: Term| term.numbers.iter().zip(matching(reference)).map(|(a, bound)| a / bound).collect();
        let terms = terms.into_iter().map(scaled).collect();
        cases.push(Scaled { excess, terms, relative: matching_relative(reference) });
    }
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let of_terms = |k: usize, n: usize| cases.iter().map(|case| dot(&case.terms[k], &case.terms[n])).sum::<f64>();
    let of_excess = |k: usize| cases.iter().map(|case| dot(&case.terms[k], &case.excess)).sum::<f64>();
    let within = cases.iter().fold(FRACTION, |within: f64, case| within.max(case.relative));
    let mut found = Vec::new();
    for k in 0..names.len() {
        for n in 0..k {
            let (kk, nn, kn) = (of_terms(k, k), of_terms(n, n), of_terms(k, n));
            let (kd, nd) = (of_excess(k), of_excess(n));
            let determinant = kk * nn - kn * kn;
            if determinant <= 1e-9 * kk * nn {
                continue;
            }
            let factors = [1.0 + (nn * kd - kn * nd) / determinant, 1.0 + (kk * nd - kn * kd) / determinant];
            let [Some(of_k), Some(of_n)] = factors.map(|factor| fraction(factor, within)) else { continue };
            let [by_k, by_n] = [of_k, of_n].map(|(p, q)| f64::from(p) / f64::from(q) - 1.0);
            let left = largest(cases.iter().map(|Scaled { excess, terms, relative }| {
                let entries = excess.iter().zip(terms[k].iter().zip(&terms[n]));
                largest(entries.map(|(d, (a, b))| (d - by_k * a - by_n * b).abs() / (1.0 + relative * d.abs())))
            }));
            if by_k != 0.0 && by_n != 0.0 && left <= 1.0 {
                let words = |by: f64| PowerLaw::constant(1.0 + by).words();
                let ((kind, of_n), (_, of_k)) = (words(by_n), words(by_k));
                let what = format!("{} {of_n} and {} {of_k}", names[n], names[k]);
                found.push((Mistake { kind, what }, left));
            }
        }
    }
    found
}
