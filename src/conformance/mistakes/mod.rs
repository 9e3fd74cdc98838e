//! What kind of mistake a wrong equation shows: every kind that is known is made on purpose, and what it gives is compared
//! with what was answered, in the failing cases and in those that are right.

use std::collections::BTreeMap;

use serde::Serialize;

use super::suite::{Case, Reference};

mod layout;
mod stations;
mod terms;
mod variants;

/// A mistake that is made on purpose has to give the answer to this many tolerances.
const LOOSE: f64 = 1e3;
/// So many kinds are named at most.
const NAMED: usize = 3;
/// Digits from which on a wrong answer is taken for the right formula, carelessly computed.
const ROUGH: f64 = 6.0;

/// One kind of mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A printed error of the paper, copied.
    Erratum,
    /// Heat on the shear component.
    HeatOnShear,
    /// Heat along the global x axis, not along the rod.
    HeatAlongX,
    /// Another mistake in the thermal strain.
    Heat,
    /// Poisson's ratio in the wrong place.
    Poisson,
    /// Sine and cosine exchanged.
    SinCos,
    /// The nodal vectors in another order.
    NodeOrder,
    /// x and y in another order.
    XyOrder,
    /// A transpose is missing, or one too many.
    Transpose,
    /// The sign, or that of a term.
    Sign,
    /// A factor ½ or 2, or another one.
    Factor,
    /// A term is missing.
    Missing,
    /// Another formula.
    Other,
    /// The right formula with too few digits.
    Digits,
}

impl Kind {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Erratum => "printed error copied",
            Kind::HeatOnShear => "heat on the shear component",
            Kind::HeatAlongX => "heat along the global x",
            Kind::Heat => "heat",
            Kind::Poisson => "ν in the wrong place",
            Kind::SinCos => "sin and cos exchanged",
            Kind::NodeOrder => "node order",
            Kind::XyOrder => "order of x and y in e",
            Kind::Transpose => "transpose",
            Kind::Sign => "sign",
            Kind::Factor => "factor",
            Kind::Missing => "missing term",
            Kind::Other => "another formula",
            Kind::Digits => "too few digits",
        }
    }
}

/// What a mistake made on purpose gives in one case.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Its kind.
    pub kind: Kind,
    /// What is done wrong, in words; the same in every case.
    pub what: String,
    /// What comes out; `None` where nothing can.
    pub value: Option<Vec<f64>>,
}

/// A candidate of a value.
fn candidate(kind: Kind, what: impl Into<String>, value: Vec<f64>) -> Candidate {
    Candidate { kind, what: what.into(), value: Some(value) }
}

/// A case, and what was answered in it.
#[derive(Clone, Copy, Debug)]
pub struct Observation<'a> {
    /// The state with its reference values.
    pub case: &'a Case,
    /// `None`: no numbers; `Some(None)`: the right ones; otherwise the wrong ones.
    pub answer: Option<Option<&'a [f64]>>,
}

/// Which kinds fit.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Kind and what is done wrong, the likeliest first; none if no known kind fits.
    pub kinds: Vec<(Kind, String)>,
    /// Where the failing cases differ from the others.
    pub only_where: Vec<String>,
    /// Entries that are wrong in some case, if they are not all.
    pub entries: Vec<String>,
}

/// Looks for the kinds that give every answer to the quantity.
pub fn diagnose(quantity: &str, observations: &[Observation]) -> Finding {
    let mut fits: BTreeMap<(Kind, String), usize> = BTreeMap::new();
    let mut cases = 0;
    for observation in observations {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        cases += 1;
        let mut counted = std::collections::BTreeSet::new();
        for Candidate { kind, what, value } in candidates(quantity, observation.case, reference) {
            let fit = match (observation.answer, value) {
                (Some(None), Some(value)) => near(&value, &reference.numbers, reference),
                (Some(Some(answer)), Some(value)) => near(&value, answer, reference),
                (None, None) => true,
                _ => false,
            };
            if fit && counted.insert((kind, what.clone())) {
                *fits.entry((kind, what)).or_default() += 1;
            }
        }
    }
    let mut kinds: Vec<(Kind, String)> = fits.into_iter().filter(|(_, n)| *n == cases).map(|(kind, _)| kind).collect();
    if kinds.is_empty() && carelessly_computed(quantity, observations) {
        kinds.push((
            Kind::Digits,
            "the right formula: single precision, a difference quotient or a coarse quadrature".into(),
        ));
    }
    kinds.truncate(NAMED);
    Finding { kinds, only_where: only_where(observations), entries: wrong_entries(quantity, observations) }
}

/// Everything that could have been done wrong. A mistake that changes nothing in any case fits none that fails.
fn candidates(quantity: &str, case: &Case, reference: &Reference) -> Vec<Candidate> {
    let mut all = variants::of(quantity, case);
    all.extend(layout::of(quantity, case, reference));
    all.extend(terms::of(quantity, case));
    all.extend(terms::whole(reference));
    all.extend(terms::components(quantity, reference));
    all
}

/// Whether every entry is as near as a mistake made on purpose has to be.
fn near(value: &[f64], answer: &[f64], reference: &Reference) -> bool {
    value.len() == answer.len()
        && value.iter().zip(answer).zip(&reference.absolute).zip(&reference.numbers).all(|(((a, b), bound), right)| {
            // Where a mistake makes terms larger, they are rounded accordingly.
            let larger = reference.relative * (a.abs() - right.abs()).max(0.0);
            (a - b).abs() <= LOOSE * (bound + larger)
        })
}

fn carelessly_computed(quantity: &str, observations: &[Observation]) -> bool {
    observations.iter().all(|observation| match (observation.answer, observation.case.values.get(quantity)) {
        (Some(None), _) => true,
        (Some(Some(answer)), Some(reference)) => {
            let pairs = answer.iter().zip(&reference.numbers).zip(&reference.absolute);
            pairs.fold(0.0_f64, |worst, ((a, b), bound)| worst.max((a - b).abs() / bound)) * reference.relative
                <= 10f64.powf(-ROUGH)
        }
        _ => false,
    })
}

/// Tags that all failing cases have and no right one.
fn only_where(observations: &[Observation]) -> Vec<String> {
    let (right, failing): (Vec<&Observation>, Vec<&Observation>) =
        observations.iter().partition(|o| o.answer == Some(None));
    let Some(first) = failing.first() else { return Vec::new() };
    let everywhere = |tag: &&String| failing.iter().all(|o| o.case.tags.contains(tag));
    let nowhere_else = |tag: &&String| !right.is_empty() && !right.iter().any(|o| o.case.tags.contains(tag));
    first.case.tags.iter().filter(everywhere).filter(nowhere_else).cloned().collect()
}

/// Places of the entries that are wrong in some case, unless there are too many to name.
fn wrong_entries(quantity: &str, observations: &[Observation]) -> Vec<String> {
    const SHOWN: usize = 4;
    let mut places = std::collections::BTreeSet::new();
    for observation in observations {
        let (Some(Some(answer)), Some(reference)) = (observation.answer, observation.case.values.get(quantity)) else {
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
fn place(entry: usize, shape: &[usize]) -> String {
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
fn own_shape<'a>(quantity: &str, reference: &'a Reference) -> &'a [usize] {
    match super::graph::is_of_a_point(quantity) {
        true => reference.shape.get(1..).unwrap_or_default(),
        false => &reference.shape,
    }
}

#[cfg(test)]
mod tests;
