//! Ancestors of a wrong quantity that the program does not answer: which of them a mistake may be in.
//!
//! A program that answers mass matrix, force and tangent only is a black box. Each known mistake in an earlier quantity is pushed through
//! the [`Chain`] to all that is answered. One that explains it all, right answers too, is named with its root.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::Serialize;

use super::chain::{self, Values};
use super::diagnose::{common_tags, explains};
use super::mistake::{Mistake, MistakeKind};
use super::observation::{Observation, Outcome};
use super::wrong_values::{Key, Upstream};
use crate::graph::{GRAPH, equation, find};
use crate::suite::{Case, State};

/// Largest number of mistakes that are named for an ancestor.
const MOST_NAMED: usize = 3;
/// Largest number of mistakes that are tried as the first of two.
const MOST_FIRST: usize = 6;
/// Quantities with a common cause: one function, or lines that are copied from one another.
const FAMILIES: [&[&str]; 6] = [
    &["3.S", "3.S_x", "3.S_y"],
    &["3.S_x", "3.S_y"],
    &["17.lambda", "17.mu"],
    &["11.S_a", "11.S_b", "11.S_c"],
    &["21.S_a1", "21.S_b1", "21.S_c1"],
    &["21.K_1", "21.K_2", "21.K_3"],
];

/// Integrals of the shape functions alone: a mistake in a function whose mean is zero does not show.
const MEANS: [&str; 2] = ["gravity.Q_w", "cable.Q_w"];

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

/// Ancestors of a culprit that may be wrong, likeliest first. `is_right` tells quantities that are right in all their cases.
pub fn ancestors(
    culprit: &'static str,
    seen: &Seen,
    is_right: impl Fn(&str) -> bool,
    upstream: &mut Upstream,
) -> Vec<Ancestor> {
    let is_answered = |quantity: &str| seen.get(quantity).is_some_and(|answers| !answers.is_empty());
    let Some(observations) = seen.get(culprit) else { return Vec::new() };
    let shown_right: BTreeSet<&str> = (seen.keys())
        .filter(|quantity| is_right(quantity) && !MEANS.contains(quantity))
        .flat_map(|quantity| chain::ancestors(quantity).into_iter().chain(before(quantity, false, &|_| true)))
        .collect();
    let is_possible = |quantity: &&'static str| !is_answered(quantity) && !shown_right.contains(quantity);
    let in_graph: Vec<&'static str> =
        before(culprit, true, &|quantity| !is_answered(quantity)).into_iter().filter(is_possible).collect();
    if in_graph.is_empty() {
        return Vec::new();
    }
    // The force may also be computed from stresses, which the paper does not do.
    let by_stress = chain::ancestors(culprit).into_iter().filter(is_possible);
    let roots: BTreeSet<&'static str> = in_graph.iter().copied().chain(by_stress).collect();
    let Fitting { mut mistakes, together } = fitting(culprit, &roots, seen, upstream);
    let tags = common_tags(observations);
    let mut all: Vec<Ancestor> = Vec::new();
    for quantity in &roots {
        let mistakes = mistakes.remove(quantity).unwrap_or_default();
        let shown: Vec<&str> = (SHOWN_BY.iter())
            .filter(|(name, _)| name == quantity)
            .flat_map(|(_, tags)| tags.iter().copied())
            .filter(|tag| tags.iter().any(|common| common == tag))
            .collect();
        let speaks = if !mistakes.is_empty() && together {
            format!(
                "explains all {} answers of {culprit} together with a mistake in another ancestor",
                observations.len()
            )
        } else if !mistakes.is_empty() {
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
        let place = GRAPH.iter().position(|node| node.quantity == ancestor.quantity);
        (ancestor.mistakes.is_empty(), ancestor.speaks.starts_with("not answered"), kind, place)
    };
    all.sort_by_key(rank);
    all
}

/// Derivatives that a program may have in lines of their own: they may be right although the function is not.
const DERIVATIVES: [&str; 4] = ["3.S_x", "3.S_y", "cable.S_x", "cable.S_xx"];

/// Quantities before another one in the graph, with functions before their derivatives or without. Those that `passes` refuses are not
/// entered.
fn before(quantity: &str, derivatives: bool, passes: &dyn Fn(&str) -> bool) -> BTreeSet<&'static str> {
    let mut all = BTreeSet::new();
    if !derivatives && DERIVATIVES.contains(&quantity) {
        return all;
    }
    for input in find(quantity).into_iter().flat_map(|node| node.inputs()).filter(|input| passes(input)) {
        if all.insert(input) {
            all.extend(before(input, derivatives, passes));
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

/// Mistakes by root that explain all answers.
#[derive(Default)]
struct Fitting {
    mistakes: BTreeMap<&'static str, Vec<Mistake>>,
    /// Whether they are two mistakes at once.
    together: bool,
}

impl Fitting {
    fn of(keys: impl IntoIterator<Item = Key>, together: bool) -> Fitting {
        let mut mistakes: BTreeMap<&'static str, Vec<Mistake>> = BTreeMap::new();
        for (members, _, mistake) in keys {
            if let Some(root) = members.first() {
                mistakes.entry(root).or_default().push(mistake);
            }
        }
        // The same mistake in a later quantity is what follows from it.
        let mut earlier: BTreeSet<Mistake> = BTreeSet::new();
        for node in GRAPH {
            if let Some(mistakes) = mistakes.get_mut(node.quantity) {
                mistakes.retain(|mistake| !earlier.contains(mistake));
                earlier.extend(mistakes.iter().cloned());
            }
        }
        for mistakes in mistakes.values_mut() {
            mistakes.sort();
            mistakes.dedup();
            mistakes.truncate(MOST_NAMED);
        }
        Fitting { mistakes, together }
    }
}

/// Mistakes that explain all answers to the culprit, and to all other quantities that they change.
fn fitting(culprit: &'static str, roots: &BTreeSet<&'static str>, seen: &Seen, upstream: &mut Upstream) -> Fitting {
    let mut search = Search { culprit, roots, upstream };
    let is_number = |observation: &&Observation| matches!(observation.outcome, Outcome::Right | Outcome::Wrong(_));
    let mut judged: Vec<(&'static str, &Observation)> = (seen.iter())
        .flat_map(|(quantity, all)| all.iter().filter(is_number).map(|observation| (*quantity, observation)))
        .collect();
    // Failing answers to the culprit come first because they exclude most mistakes; those with many tags show most.
    judged.sort_by_key(|(quantity, observation)| {
        let right = observation.outcome == Outcome::Right;
        (*quantity != culprit, right, std::cmp::Reverse(observation.case.tags.len()), *quantity)
    });
    let Some(((_, first), _)) = judged.split_first() else { return Fitting::default() };
    let all = search.keys_of(first.case);
    let mut fitting = all.clone();
    for (quantity, observation) in &judged {
        search.prepare(observation.case, &fitting);
        fitting.retain(|key| search.explains(quantity, observation, &[key]));
        if fitting.is_empty() {
            break;
        }
    }
    if !fitting.is_empty() {
        return Fitting::of(fitting, false);
    }
    // Two mistakes: one alone explains the failing answer with the fewest tags.
    let mut of_culprit: Vec<&Observation> = (judged.iter())
        .filter(|(quantity, observation)| *quantity == culprit && observation.outcome != Outcome::Right)
        .map(|(_, observation)| *observation)
        .collect();
    of_culprit.sort_by_key(|observation| observation.case.tags.len());
    let Some(simplest) = of_culprit.first() else { return Fitting::default() };
    // Of the paper's own route only: a strain and the stress after it are not two causes.
    let mut all: Vec<Key> = all.into_iter().filter(|(members, ..)| !chain::is_by_stress(members)).collect();
    // The same mistake in a later quantity is what follows from it: roots first.
    all.sort_by_key(|(members, ..)| GRAPH.iter().position(|node| members.first() == Some(&node.quantity)));
    search.prepare(simplest.case, &all);
    let alone: Vec<Key> =
        all.iter().filter(|key| search.explains(culprit, simplest, &[*key])).take(MOST_FIRST).cloned().collect();
    for one in &alone {
        let Some(other) = of_culprit.iter().find(|o| !search.explains(culprit, o, &[one])) else { continue };
        search.prepare(other.case, &all);
        let apart = |two: &&Key| two.0.iter().all(|member| !one.0.contains(member));
        let partners: Vec<&Key> =
            all.iter().filter(apart).filter(|two| search.explains(culprit, other, &[one, *two])).collect();
        for two in partners {
            if judged.iter().all(|(quantity, observation)| search.explains(quantity, observation, &[one, two])) {
                return Fitting::of([one.clone(), two.clone()], true);
            }
        }
    }
    Fitting::default()
}

/// Judges mistakes in the roots of a culprit.
struct Search<'a> {
    culprit: &'static str,
    roots: &'a BTreeSet<&'static str>,
    upstream: &'a mut Upstream,
}

impl Search<'_> {
    /// All mistakes that have a value in a case.
    fn keys_of(&mut self, case: &Case) -> BTreeSet<Key> {
        let roots = self.roots;
        let Some(in_case) = self.upstream.in_case(case) else { return BTreeSet::new() };
        let families = FAMILIES.iter().filter(|family| family.iter().all(|root| roots.contains(root)));
        let members: Vec<&'static [&'static str]> =
            roots.iter().filter_map(|root| singleton(root)).chain(families.copied()).collect();
        let mut keys = BTreeSet::new();
        for members in members {
            for mistake in in_case.mistakes_of(case, members) {
                keys.insert((members, false, mistake.clone()));
                // J_0 follows from the shape functions, or θ is used in its place.
                // A wrong J is that of the strains alone, or of their derivatives, too.
                if members.iter().any(|member| member.starts_with("3.S_") || *member == "9.J") {
                    keys.insert((members, true, mistake));
                }
            }
        }
        keys
    }

    /// Computes the wrong values that these mistakes have in a case, all those of a root at once.
    fn prepare<'k>(&mut self, case: &Case, keys: impl IntoIterator<Item = &'k Key>) {
        let mut wanted: BTreeMap<&'static str, BTreeSet<&Mistake>> = BTreeMap::new();
        for (members, _, mistake) in keys {
            for member in *members {
                wanted.entry(member).or_default().insert(mistake);
            }
        }
        if let Some(in_case) = self.upstream.in_case(case) {
            for (root, mistakes) in &wanted {
                in_case.prepare(case, root, mistakes);
            }
        }
    }

    /// Whether mistakes, made at once, explain an answer. Those that do not change the quantity explain any but the culprit's.
    fn explains(&mut self, quantity: &'static str, observation: &Observation, keys: &[&Key]) -> bool {
        let (culprit, case) = (self.culprit, observation.case);
        let Some(reference) = case.values.get(quantity) else { return true };
        let Some(in_case) = self.upstream.in_case(case) else { return quantity != culprit };
        let mut replaced = Values::new();
        for key in keys {
            let Some(values) = in_case.values(case, key) else { return false };
            replaced.extend(values);
        }
        match in_case.chain.value(quantity, &replaced) {
            Some(value) => explains(Some(&value), observation.outcome, reference).is_some(),
            None => quantity != culprit || explains(Some(&reference.numbers), observation.outcome, reference).is_some(),
        }
    }
}

/// The static list with this root alone.
fn singleton(root: &str) -> Option<&'static [&'static str]> {
    find(root).map(|node| std::slice::from_ref(&node.quantity))
}
