//! Ancestors of a wrong quantity that the program does not answer: which of them a mistake may be in.
//!
//! A program that answers mass matrix, force and tangent only is a black box. Each known mistake in an earlier quantity is pushed through
//! the [`Chain`] to all that is answered. One that explains it all, right answers too, is named with its root.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use schemars::JsonSchema;
use serde::Serialize;

use super::chain::{self, Chain, Values};
use super::diagnose::{candidates, common_tags, explains};
use super::mistake::{Mistake, MistakeKind};
use super::observation::{Observation, Outcome};
use super::power::PowerLaw;
use super::terms;
use super::terms::term::Term;
use crate::graph::{equation, find};
use crate::suite::{Case, Reference, State};

/// Largest number of mistakes that are named for an ancestor.
const MOST_NAMED: usize = 3;
/// Factors that terms of an earlier quantity are often wrong by.
const FACTORS: [f64; 12] = [-1.0, 0.0, 2.0, 0.5, 4.0, 0.25, 3.0, 1.0 / 3.0, 1.5, 2.0 / 3.0, -2.0, -0.5];
/// A wrong value counts as right if it differs by this share of its largest entry at most.
const NEUTRAL: f64 = 1e-12;

/// Quantities with a common cause: one function, or lines that are copied from one another.
const FAMILIES: [&[&str]; 5] = [
    &["3.S", "3.S_x", "3.S_y"],
    &["3.S_x", "3.S_y"],
    &["11.S_a", "11.S_b", "11.S_c"],
    &["21.S_a1", "21.S_b1", "21.S_c1"],
    &["21.K_1", "21.K_2", "21.K_3"],
];

/// Tags of states in which a mistake in a quantity shows.
const SHOWN_BY: [(&str, &[&str]); 6] = [
    ("8.epsilon_T", &["heated", "1d", "2d"]),
    ("17.lambda", &["nu", "auxetic", "near-singular"]),
    ("9.J_0", &["rotated"]),
    ("11.S_a", &["rotated"]),
    ("11.S_b", &["rotated"]),
    ("11.S_c", &["rotated", "sheared"]),
];

/// An earlier quantity that is not answered and may be wrong.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Ancestor {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Number of its equation in the paper, or a word for an equation that the paper omits.
    pub equation: &'static str,
    /// Mistakes in this quantity that explain what is answered, likelier ones first; at most three.
    #[serde(rename = "kinds")]
    pub mistakes: Vec<Mistake>,
    /// What speaks for this quantity.
    pub speaks: String,
}

/// Answers by quantity.
pub type Seen<'a> = BTreeMap<&'static str, Vec<Observation<'a>>>;

/// A mistake in a root: the quantities whose values it changes, and whether J_0 is computed from θ.
type Key = (&'static [&'static str], bool, Mistake);

/// Ancestors of a culprit that may be wrong, likeliest first. `is_right` tells quantities that are right in all their cases.
pub fn ancestors(culprit: &'static str, seen: &Seen, is_right: impl Fn(&str) -> bool) -> Vec<Ancestor> {
    let is_answered = |quantity: &str| seen.get(quantity).is_some_and(|answers| !answers.is_empty());
    let Some(observations) = seen.get(culprit) else { return Vec::new() };
    let shown_right: BTreeSet<&str> = (seen.keys())
        .filter(|quantity| is_right(quantity))
        .flat_map(|quantity| chain::ancestors(quantity).into_iter().chain(before(quantity, &|_| true)))
        .collect();
    let is_possible = |quantity: &&'static str| !is_answered(quantity) && !shown_right.contains(quantity);
    let in_graph: Vec<&'static str> =
        before(culprit, &|quantity| !is_answered(quantity)).into_iter().filter(is_possible).collect();
    if in_graph.is_empty() {
        return Vec::new();
    }
    // The force may also be computed from stresses, which the paper does not do.
    let by_stress = chain::ancestors(culprit).into_iter().filter(is_possible);
    let roots: BTreeSet<&'static str> = in_graph.iter().copied().chain(by_stress).collect();
    let mut found = fitting(culprit, &roots, seen);
    let tags = common_tags(observations);
    let mut all: Vec<Ancestor> = Vec::new();
    for quantity in &roots {
        let mistakes = found.remove(quantity).unwrap_or_default();
        let shown: Vec<&str> = (SHOWN_BY.iter())
            .filter(|(name, _)| name == quantity)
            .flat_map(|(_, tags)| tags.iter().copied())
            .filter(|tag| tags.iter().any(|common| common == tag))
            .collect();
        let speaks = if !mistakes.is_empty() {
            format!("explains all {} answers of {culprit} and what else is answered", observations.len())
        } else if !shown.is_empty() {
            format!("only states tagged {} fail, where it matters", shown.join(", "))
        } else if in_graph.contains(quantity) && !is_excluded(quantity, observations) {
            "not answered; nothing excludes it".into()
        } else {
            continue;
        };
        all.push(Ancestor { quantity, equation: equation(quantity), mistakes, speaks });
    }
    let rank = |ancestor: &Ancestor| {
        let kind = ancestor.mistakes.first().map_or(MistakeKind::Digits, |mistake| mistake.kind);
        let place = crate::graph::GRAPH.iter().position(|node| node.quantity == ancestor.quantity);
        (ancestor.mistakes.is_empty(), ancestor.speaks.starts_with("not answered"), kind, std::cmp::Reverse(place))
    };
    all.sort_by_key(rank);
    all
}

/// Quantities before another one in the graph. Those that `passes` refuses are not entered.
fn before(quantity: &str, passes: &dyn Fn(&str) -> bool) -> BTreeSet<&'static str> {
    let mut all = BTreeSet::new();
    for input in find(quantity).into_iter().flat_map(|node| node.inputs()).filter(|input| passes(input)) {
        if all.insert(input) {
            all.extend(before(input, passes));
        }
    }
    all
}

/// Whether a failing state does not show a mistake in the quantity: without heat no thermal strain is wrong.
fn is_excluded(quantity: &str, observations: &[Observation]) -> bool {
    let unheated = |observation: &Observation| match &observation.case.state {
        State::Element(state) => state.alpha == 0.0 || state.dT == 0.0,
        _ => true,
    };
    let failing = |observation: &&Observation| matches!(observation.outcome, Outcome::Wrong(_));
    quantity == "8.epsilon_T" && observations.iter().filter(failing).any(unheated)
}

/// Mistakes by root that explain all answers to the culprit, and to all other quantities that they change.
fn fitting(culprit: &'static str, roots: &BTreeSet<&'static str>, seen: &Seen) -> BTreeMap<&'static str, Vec<Mistake>> {
    let families: Vec<&'static [&'static str]> =
        FAMILIES.into_iter().filter(|family| family.iter().all(|root| roots.contains(root))).collect();
    let mut judged: Vec<(&'static str, &Observation)> = Vec::new();
    for (quantity, observations) in seen {
        if find(quantity).is_some() {
            judged.extend(observations.iter().map(|observation| (*quantity, observation)));
        }
    }
    // Failing answers to the culprit come first because they exclude most mistakes; those with many tags show most.
    judged.sort_by_key(|(quantity, observation)| {
        let wrong = matches!(observation.outcome, Outcome::Wrong(_));
        (*quantity != culprit, !wrong, std::cmp::Reverse(observation.case.tags.len()), *quantity)
    });
    let mut wanted: Option<BTreeSet<Key>> = None;
    let mut chains: BTreeMap<&str, Option<InCase>> = BTreeMap::new();
    for (quantity, observation) in judged {
        // Answers without numbers are no evidence.
        if matches!(observation.outcome, Outcome::Fault(_) | Outcome::Refused(_)) {
            continue;
        }
        let in_case = chains.entry(&observation.case.id).or_insert_with(|| InCase::new(observation.case));
        let (Some(in_case), Some(reference)) = (in_case, observation.case.values.get(quantity)) else { continue };
        if wanted.as_ref().is_none_or(|wanted| !in_case.knows(wanted)) {
            in_case.add(roots, &families, wanted.as_ref());
        }
        let keys: Vec<&Key> = match &wanted {
            Some(wanted) => wanted.iter().collect(),
            None => in_case.changes.keys().collect(),
        };
        let fits = |key: &&&Key| {
            let values = in_case.changes.get(key).and_then(Option::as_ref);
            let value = values.and_then(|values| in_case.chain.value(quantity, values));
            let is_changed = quantity == culprit || value.is_some();
            !is_changed || explains(value.as_deref().or(Some(&reference.numbers)), observation.outcome, reference)
        };
        let fitting: BTreeSet<Key> = keys.iter().filter(fits).map(|key| (*key).clone()).collect();
        if fitting.is_empty() {
            return BTreeMap::new();
        }
        wanted = Some(fitting);
    }
    let mut by_root: BTreeMap<&'static str, Vec<Mistake>> = BTreeMap::new();
    for (members, _, mistake) in wanted.into_iter().flatten() {
        if let Some(root) = members.first() {
            by_root.entry(root).or_default().push(mistake);
        }
    }
    for mistakes in by_root.values_mut() {
        mistakes.sort();
        mistakes.dedup();
        mistakes.truncate(MOST_NAMED);
    }
    by_root
}

/// Wrong values of roots in one case.
struct InCase<'a> {
    case: &'a Case,
    chain: Chain,
    /// Changed values by mistake; `None` for a mistake that changes nothing here.
    changes: BTreeMap<Key, Option<Values>>,
}

impl<'a> InCase<'a> {
    fn new(case: &'a Case) -> Option<InCase<'a>> {
        match &case.state {
            State::Element(state) => Some(InCase { case, chain: Chain::new(state), changes: BTreeMap::new() }),
            _ => None,
        }
    }

    fn knows(&self, wanted: &BTreeSet<Key>) -> bool {
        wanted.iter().all(|key| self.changes.contains_key(key))
    }

    /// Adds the wrong values of all roots and families, or of the wanted mistakes only.
    fn add(
        &mut self,
        roots: &BTreeSet<&'static str>,
        families: &[&'static [&'static str]],
        wanted: Option<&BTreeSet<Key>>,
    ) {
        let mut of_root: BTreeMap<&'static str, BTreeMap<Mistake, Option<Rc<Vec<f64>>>>> = BTreeMap::new();
        for root in roots {
            let is_wanted = |mistake: &Mistake| {
                wanted.is_none_or(|wanted| wanted.iter().any(|(of, _, m)| of.contains(root) && m == mistake))
            };
            of_root.insert(root, self.wrong_values(root, is_wanted));
        }
        let mut changes: Vec<(Key, Option<Values>)> = Vec::new();
        for (root, wrong) in &of_root {
            let Some(members) = singleton(root) else { continue };
            for (mistake, value) in wrong {
                let values = value.as_ref().map(|value| Values::from([(*root, Rc::clone(value))]));
                changes.push(((members, false, mistake.clone()), values));
            }
        }
        for family in families {
            let Some(first) = family.first().and_then(|root| of_root.get(root)) else { continue };
            for mistake in first.keys() {
                let of_all: Option<Vec<_>> =
                    family.iter().map(|root| Some((*root, of_root.get(root)?.get(mistake)?.clone()))).collect();
                let Some(of_all) = of_all else { continue };
                let values: Values = of_all.into_iter().filter_map(|(root, value)| Some((root, value?))).collect();
                changes.push(((family, false, mistake.clone()), (!values.is_empty()).then_some(values)));
            }
        }
        for ((members, _, mistake), values) in changes {
            // J_0 follows from the shape functions, or θ is used in its place.
            if members.iter().any(|member| member.starts_with("3.S_")) {
                let by_angle = values.clone().and_then(|mut values| {
                    values.insert("9.J_0", self.chain.right("9.J_0")?);
                    Some(values)
                });
                self.changes.insert((members, true, mistake.clone()), by_angle);
            }
            self.changes.insert((members, false, mistake), values);
        }
    }

    /// Wrong values of a root, at all points; `None` where a mistake changes nothing.
    fn wrong_values(
        &self,
        root: &'static str,
        is_wanted: impl Fn(&Mistake) -> bool,
    ) -> BTreeMap<Mistake, Option<Rc<Vec<f64>>>> {
        let mut wrong = BTreeMap::new();
        let Some(case) = self.everywhere(root) else { return wrong };
        let Some(reference) = case.values.get(root) else { return wrong };
        let right = &reference.numbers;
        let size = right.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        let mut add = |mistake: Mistake, value: Vec<f64>| {
            let usable = value.len() == right.len() && value.iter().all(|value| value.is_finite());
            let differs = value.iter().zip(right).any(|(wrong, right)| (wrong - right).abs() > NEUTRAL * size);
            if usable {
                wrong.insert(mistake, differs.then(|| Rc::new(value)));
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
            for (mistake, by) in scaled(&term) {
                if is_wanted(&mistake) {
                    add(mistake, right.iter().zip(&term.numbers).map(|(right, term)| right + by * term).collect());
                }
            }
        }
        wrong
    }

    /// The case with the root's reference value at all points of the chain, and what may be mistaken for it.
    fn everywhere(&self, root: &'static str) -> Option<Case> {
        let state = &self.chain.everywhere;
        let own = self.case.values.get(root)?;
        let mut values: BTreeMap<String, Reference> = (self.case.values.iter())
            .filter(|(_, value)| !value.per_point)
            .map(|(name, value)| (name.clone(), value.clone()))
            .collect();
        let alike = self.case.values.iter().filter(|(_, value)| value.per_point && value.shape == own.shape);
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
            id: self.case.id.clone(),
            tags: self.case.tags.clone(),
            state_json: self.case.state_json.clone(),
            state: State::Element(Box::new(state.clone())),
            values,
        })
    }
}

/// The static list with this root alone.
fn singleton(root: &str) -> Option<&'static [&'static str]> {
    find(root).map(|node| std::slice::from_ref(&node.quantity))
}

/// Mistakes that multiply a term by a usual factor, and what each adds in terms of it.
fn scaled(term: &Term) -> Vec<(Mistake, f64)> {
    if !term.belongs {
        let what = |sign: &str| format!("{sign} {}, which does not belong there", term.name);
        let kind = MistakeKind::Other;
        return vec![(Mistake { kind, what: what("plus") }, 1.0), (Mistake { kind, what: what("minus") }, -1.0)];
    }
    let by = |factor: f64| {
        let (kind, words) = PowerLaw::constant(factor).words();
        (Mistake { kind, what: format!("{} {words}", term.name) }, factor - 1.0)
    };
    FACTORS.into_iter().map(by).collect()
}
