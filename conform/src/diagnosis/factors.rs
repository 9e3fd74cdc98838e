//! By how much each term of an equation would have to be multiplied to give the answers.

use std::collections::BTreeMap;

use super::power::{Law, Numbers, Sample, fraction};
use super::terms::{self, Term};
use super::{Kind, LOOSE, Name, Observation, Seen};
use crate::suite::{Case, Reference};

/// Terms that are multiplied in pairs, at most.
const MOST: usize = 24;
/// So many cases have to show a factor that is no constant.
const SHOWN: usize = 3;

/// One case: what was answered less what is right, and the terms, each entry in its tolerance.
struct Scaled {
    excess: Vec<f64>,
    terms: Vec<Vec<f64>>,
}

/// What was answered less what is right, each entry in its tolerance; `None` without numbers.
fn excess(seen: Seen, reference: &Reference) -> Option<Vec<f64>> {
    match seen {
        Seen::Right => Some(vec![0.0; reference.numbers.len()]),
        Seen::Numbers(answer) => {
            let entries = answer.iter().zip(&reference.numbers).zip(&reference.absolute);
            Some(entries.map(|((answer, right), bound)| (answer - right) / bound).collect())
        }
        Seen::Refused(_) | Seen::Fault(_) => None,
    }
}

/// One term with one factor that gives every answer.
pub(super) fn of_one_term(quantity: &str, judged: &[&Observation]) -> Vec<Name> {
    let mut by_name: BTreeMap<String, (bool, Vec<Sample>)> = BTreeMap::new();
    let mut first = true;
    for observation in judged {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let Some(excess) = excess(observation.seen, reference) else { return Vec::new() };
        let mut terms = terms::of(quantity, observation.case);
        terms.extend(terms::parts(quantity, reference));
        let mut still = BTreeMap::new();
        for term in terms {
            let mut samples = match by_name.remove(&term.name) {
                Some((_, samples)) => samples,
                None if first => Vec::new(),
                None => continue,
            };
            match sample(&term, &excess, reference, observation.case) {
                Explained::No => continue,
                Explained::Without => {}
                Explained::By(sample) => samples.push(sample),
            }
            still.insert(term.name, (term.there, samples));
        }
        (by_name, first) = (still, false);
    }
    by_name.into_iter().filter_map(|(name, (there, samples))| name_of(&name, there, &samples)).collect()
}

/// Whether a case can be explained by a factor of a term.
enum Explained {
    No,
    /// Nothing is wrong, and the term is zero.
    Without,
    By(Sample),
}

fn sample(term: &Term, excess: &[f64], reference: &Reference, case: &Case) -> Explained {
    let scaled: Vec<f64> = term.numbers.iter().zip(&reference.absolute).map(|(value, bound)| value / bound).collect();
    let size = scaled.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    let square: f64 = scaled.iter().map(|value| value * value).sum();
    let along = scaled.iter().zip(excess).map(|(term, excess)| term * excess).sum::<f64>();
    let added = if square > 0.0 { along / square } else { 0.0 };
    // Where a mistake makes terms larger, they are rounded accordingly: `relative` of a value is so many of its tolerances.
    let explained = excess
        .iter()
        .zip(&scaled)
        .all(|(excess, term)| (excess - added * term).abs() <= LOOSE * (1.0 + reference.relative * excess.abs()));
    let number = |key: &str| case.state[key].as_f64().unwrap_or(1.0);
    let of: Numbers = ["l", "h", "w", "rho", "E"].map(number);
    let factor = if term.there { 1.0 + added } else { added };
    match explained {
        false => Explained::No,
        true if size <= 10.0 * LOOSE => Explained::Without,
        true => {
            Explained::By(Sample { factor, within: LOOSE * (1.0 + reference.relative * added.abs() * size) / size, of })
        }
    }
}

fn name_of(name: &str, there: bool, samples: &[Sample]) -> Option<Name> {
    let neutral = if there { 1.0 } else { 0.0 };
    let shows = |sample: &&Sample| (sample.factor - neutral).abs() > sample.within.max(1e-9);
    let shown = samples.iter().filter(shows).count();
    let law = Law::of(samples).filter(|law| law.is_constant() || shown >= SHOWN)?;
    if shown == 0 {
        return None;
    }
    let (kind, words) = law.words();
    let of_foreign = if name.contains("ε_T") { Kind::Heat } else { Kind::Other };
    match (there, kind) {
        (true, _) => Some((kind, format!("{name} {words}"))),
        (false, Kind::Sign) => Some((of_foreign, format!("less {name}, which is not there"))),
        (false, _) => Some((of_foreign, format!("plus {name}, which is not there"))),
    }
}

/// Two terms with a factor each, both simple fractions, that give every answer.
pub(super) fn of_two_terms(quantity: &str, judged: &[&Observation]) -> Vec<Name> {
    let mut names: Vec<String> = Vec::new();
    let mut cases: Vec<Scaled> = Vec::new();
    for observation in judged {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let Some(excess) = excess(observation.seen, reference) else { return Vec::new() };
        let terms: Vec<Term> = terms::of(quantity, observation.case).into_iter().filter(|term| term.there).collect();
        names = terms.iter().map(|term| term.name.clone()).collect();
        if names.len() > MOST {
            return Vec::new();
        }
        let scaled = |term: Term| term.numbers.iter().zip(&reference.absolute).map(|(a, bound)| a / bound).collect();
        cases.push(Scaled { excess, terms: terms.into_iter().map(scaled).collect() });
    }
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let of_terms = |k: usize, n: usize| cases.iter().map(|case| dot(&case.terms[k], &case.terms[n])).sum::<f64>();
    let of_excess = |k: usize| cases.iter().map(|case| dot(&case.terms[k], &case.excess)).sum::<f64>();
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
            let [Some(of_k), Some(of_n)] = factors.map(|factor| fraction(factor, 1e-6)) else { continue };
            let [by_k, by_n] = [of_k, of_n].map(|(p, q)| f64::from(p) / f64::from(q) - 1.0);
            let explained = by_k != 0.0
                && by_n != 0.0
                && cases.iter().all(|Scaled { excess, terms }| {
                    let entries = excess.iter().zip(terms[k].iter().zip(&terms[n]));
                    entries
                        .into_iter()
                        .all(|(d, (a, b))| (d - by_k * a - by_n * b).abs() <= LOOSE * (1.0 + 1e-13 * d.abs()))
                });
            if explained {
                let words = |by: f64| Law::constant(1.0 + by).words();
                let ((kind, of_n), (_, of_k)) = (words(by_n), words(by_k));
                found.push((kind, format!("{} {of_n} and {} {of_k}", names[n], names[k])));
            }
        }
    }
    found
}
