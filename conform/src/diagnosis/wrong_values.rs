//! Values that an earlier quantity has with each known mistake in it, case by case.
//!
//! Candidates are built for all mistakes that are wanted of a root at once, and their values kept: those of one case are asked for by
//! many combinations, and by each culprit.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::chain::{Chain, Values};
use super::diagnose::candidates;
use super::mistake::{Mistake, MistakeKind};
use super::power::{PowerLaw, numbers_of};
use super::terms;
use super::terms::term::Term;
use crate::graph::find;
use crate::suite::{Case, Reference, State};

/// Factors that terms of an earlier quantity are often wrong by.
const FACTORS: [f64; 12] = [-1.0, 0.0, 2.0, 0.5, 4.0, 0.25, 3.0, 1.0 / 3.0, 1.5, 2.0 / 3.0, -2.0, -0.5];
/// Lengths and other numbers that are often forgotten, or one too many: place in the list of [`PowerLaw`] and exponent.
const POWERS: [(usize, i32); 6] = [(0, 1), (0, -1), (1, 1), (1, -1), (2, -1), (3, -1)];
/// A wrong value counts as right if it differs by this share of its largest entry at most.
const NEUTRAL: f64 = 1e-12;

/// A mistake in a root: the quantities whose values it changes, and whether it acts in another way. For shape functions: J_0 is computed
/// from θ. For J: the inverse of J_0 is wrong where the strains' derivatives use it, too.
pub(super) type Key = (&'static [&'static str], bool, Mistake);

/// Wrong values in all cases.
#[derive(Default)]
pub struct Upstream(BTreeMap<String, Option<InCase>>);

impl Upstream {
    /// Wrong values in a case; `None` in cases without a chain.
    pub(super) fn in_case(&mut self, case: &Case) -> Option<&mut InCase> {
        self.0.entry(case.id.clone()).or_insert_with(|| InCase::new(case)).as_mut()
    }
}

/// Value of a root with a mistake in it.
#[derive(Clone)]
enum Wrong {
    /// The mistake leaves no value.
    None,
    /// The mistake changes nothing.
    Neutral,
    /// Another value than the right one.
    Value(Rc<Vec<f64>>),
}

/// Wrong values of a root by mistake.
type WrongValues = BTreeMap<Mistake, Wrong>;

/// Wrong values of roots in one case.
pub(super) struct InCase {
    /// The chain in this case.
    pub chain: Chain,
    wrong: BTreeMap<&'static str, WrongValues>,
}

impl InCase {
    fn new(case: &Case) -> Option<InCase> {
        match &case.state {
            State::Element(state) => Some(InCase { chain: Chain::new(state), wrong: BTreeMap::new() }),
            _ => None,
        }
    }

    /// Mistakes that all members have in common.
    pub fn mistakes_of(&mut self, case: &Case, members: &'static [&'static str]) -> Vec<Mistake> {
        for member in members {
            if !self.wrong.contains_key(member) {
                let wrong = self.wrong_values(case, member, |_| true);
                self.wrong.insert(member, wrong);
            }
        }
        let Some(first) = members.first().and_then(|member| self.wrong.get(member)) else { return Vec::new() };
        let is_common = |mistake: &&Mistake| {
            members.iter().all(|member| self.wrong.get(member).is_some_and(|wrong| wrong.contains_key(mistake)))
        };
        first.keys().filter(is_common).cloned().collect()
    }

    /// Computes the values of mistakes in a root that are not known yet.
    pub fn prepare(&mut self, case: &Case, root: &'static str, mistakes: &BTreeSet<&Mistake>) {
        let known = self.wrong.get(root);
        let unknown: BTreeSet<&Mistake> = (mistakes.iter().copied())
            .filter(|mistake| known.is_none_or(|known| !known.contains_key(mistake)))
            .collect();
        if unknown.is_empty() {
            return;
        }
        let mut computed = self.wrong_values(case, root, |mistake| unknown.contains(mistake));
        for mistake in unknown {
            computed.entry(mistake.clone()).or_insert(Wrong::None);
        }
        self.wrong.entry(root).or_default().extend(computed);
    }

    /// Wrong values of a mistake, empty where it changes nothing; `None` if it has no value.
    pub fn values(&mut self, case: &Case, (members, other_way, mistake): &Key) -> Option<Values> {
        let mut values = Values::new();
        for member in *members {
            self.prepare(case, member, &BTreeSet::from([mistake]));
            match self.wrong.get(member)?.get(mistake)? {
                Wrong::None => return None,
                Wrong::Neutral => {}
                Wrong::Value(value) => {
                    values.insert(member, Rc::clone(value));
                }
            }
        }
        if *other_way && !values.is_empty() {
            let J_0 = match values.get("9.J") {
                Some(J) => Rc::new(self.chain.multiplied_from_the_right(J)?),
                None => self.chain.right("9.J_0")?,
            };
            values.insert("9.J_0", J_0);
        }
        Some(values)
    }

    /// Wrong values of a root, at all points.
    fn wrong_values(&self, case: &Case, root: &'static str, is_wanted: impl Fn(&Mistake) -> bool) -> WrongValues {
        let mut wrong = WrongValues::new();
        let Some(case) = self.everywhere(case, root) else { return wrong };
        let Some(reference) = case.values.get(root) else { return wrong };
        let right = &reference.numbers;
        let size = right.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        let mut add = |mistake: Mistake, value: Vec<f64>| {
            let usable = value.len() == right.len() && value.iter().all(|value| value.is_finite());
            let differs = value.iter().zip(right).any(|(wrong, right)| (wrong - right).abs() > NEUTRAL * size);
            if usable {
                wrong.insert(mistake, if differs { Wrong::Value(Rc::new(value)) } else { Wrong::Neutral });
            }
        };
        for candidate in candidates(root, &case, reference) {
            if is_wanted(&candidate.mistake)
                && let Some(value) = (candidate.value)()
            {
                add(candidate.mistake, value);
            }
        }
        for term in terms::of(root, &case).into_iter().chain(terms::parts(reference)) {
            for (mistake, by) in scaled(&term, &case) {
                if is_wanted(&mistake) {
                    add(mistake, right.iter().zip(&term.numbers).map(|(right, term)| right + by * term).collect());
                }
            }
        }
        wrong
    }

    /// The case with the root's reference value at all points of the chain, and what may be mistaken for it.
    fn everywhere(&self, case: &Case, root: &'static str) -> Option<Case> {
        let state = &self.chain.everywhere;
        let own = case.values.get(root)?;
        let mut values: BTreeMap<String, Reference> = (case.values.iter())
            .filter(|(_, value)| !value.per_point)
            .map(|(name, value)| (name.clone(), value.clone()))
            .collect();
        let alike = case.values.iter().filter(|(_, value)| value.per_point && value.shape == own.shape);
        for (name, value) in alike {
            let Some(node) = find(name) else { continue };
            let numbers = self.chain.right(node.quantity)?.to_vec();
            let mut shape = value.shape.clone();
            if let Some(points) = shape.first_mut() {
                *points = state.points.len();
            }
            let absolute = vec![value.relative; numbers.len()];
            values.insert(name.clone(), Reference { shape, numbers, absolute, ..value.clone() });
        }
        Some(Case {
            id: case.id.clone(),
            tags: case.tags.clone(),
            state_json: case.state_json.clone(),
            state: State::Element(Box::new(state.clone())),
            values,
            terms: BTreeMap::new(),
        })
    }
}

/// Mistakes that multiply a term by a usual factor, and what each adds in terms of it.
fn scaled(term: &Term, case: &Case) -> Vec<(Mistake, f64)> {
    if !term.belongs {
        let what = |sign: &str| format!("{sign} {}, which does not belong there", term.name);
        let kind = MistakeKind::Other;
        return vec![(Mistake { kind, what: what("plus") }, 1.0), (Mistake { kind, what: what("minus") }, -1.0)];
    }
    let of = numbers_of(case);
    let by = |law: PowerLaw| {
        let (kind, words) = law.words();
        (Mistake { kind, what: format!("{} {words}", term.name) }, law.value(&of) - 1.0)
    };
    let constants = FACTORS.into_iter().map(PowerLaw::constant);
    constants.chain(POWERS.into_iter().map(|(place, n)| PowerLaw::power(place, n))).map(by).collect()
}
