//! Conventions, read off a program's answers.
//!
//! Quantities that depend on the conventions alone come first: S, M, D and ε_T. What depends on e or θ as well shows in which layout and
//! unit the program reads its state: it is asked again with the state rewritten.

mod layouts;

use std::collections::BTreeMap;

use super::Conventions;
use super::angle::Angle;
use super::axes::{Axis, axes};
use super::declared::Declared;
use super::energy::{ENERGIES, MULTIPLES};
use super::evidence::{Evidence, Seen, Weight};
use super::heat::STRAINS;
use super::layout::Layout;
use super::named::{Convention, How};
use super::reading::Reading;
use super::shear::Shear;
use super::symmetrised::Metrics;
use super::voigt::Voigt;
use crate::answers::{Answers, CaseAnswer};
use crate::protocol::Answer;
use crate::suite::{State, Suite};
use crate::verdict::Fault;

/// Largest number of failing quantities that are asked again to find how the state is read.
const PROBES: usize = 12;
/// Number of times that a program may hang or crash at a quantity that is asked again.
const PATIENCE: usize = 3;
/// Most rounds: what is asked again in one may show a convention in the next.
const ROUNDS: usize = 3;
/// Largest number of names in a list of evidence.
const MOST_NAMED: usize = 4;

/// Asks for a quantity in the case of an index, with the state as these conventions have it.
type Ask<'a> = dyn FnMut(&'static str, usize, &Conventions) -> Result<Answer, Fault> + 'a;

/// Conventions of a program, and its answers translated into those of the fixtures.
#[derive(Debug)]
pub struct Found {
    /// The conventions.
    pub conventions: Conventions,
    /// Those that differ from the fixtures, for the report.
    pub named: Vec<Convention>,
    /// The answers in the conventions of the fixtures.
    pub answers: Answers,
}

/// Finds the conventions of a program. `declared` holds those of its `hello`, with which the questions were asked.
pub fn infer<'a>(suite: &'a Suite, declared: &'a Declared, answers: Answers, ask: &'a mut Ask<'a>) -> Found {
    let mut inference = Inference {
        evidence: Evidence::new(suite, &answers.0),
        conventions: declared.conventions.clone(),
        keys: &declared.keys,
        answers,
        alternatives: Vec::new(),
        shown_by: BTreeMap::new(),
        ambiguous: BTreeMap::new(),
        refuted: Vec::new(),
        declared: declared.conventions.clone(),
        ask,
    };
    inference.run();
    let (named, conventions) = (inference.named(), inference.conventions.clone());
    Found { conventions, named, answers: inference.translated() }
}

/// Which element a layout belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Family {
    Element,
    Cable,
}

impl Family {
    const ALL: [Family; 2] = [Family::Element, Family::Cable];

    fn of(quantity: &str) -> Option<Family> {
        match quantity {
            _ if quantity.starts_with("cable.") => Some(Family::Cable),
            _ if quantity.starts_with("23.") => None,
            _ => Some(Family::Element),
        }
    }

    fn layout(self, conventions: &Conventions) -> &Layout {
        match self {
            Family::Element => &conventions.element,
            Family::Cable => &conventions.cable,
        }
    }

    fn with(self, conventions: &Conventions, layout: Layout) -> Conventions {
        match self {
            Family::Element => Conventions { element: layout, ..conventions.clone() },
            Family::Cable => Conventions { cable: layout, ..conventions.clone() },
        }
    }
}

struct Inference<'a> {
    evidence: Evidence<'a>,
    answers: Answers,
    conventions: Conventions,
    /// Keys that the program declared.
    keys: &'a [&'static str],
    /// Other conventions that explain the layout as well.
    alternatives: Vec<Conventions>,
    /// What shows a convention, by key.
    shown_by: BTreeMap<&'static str, String>,
    /// What a convention cannot be told from, by key.
    ambiguous: BTreeMap<&'static str, Vec<String>>,
    /// Families whose layout is that of the fixtures, although it seemed another one.
    refuted: Vec<Family>,
    declared: Conventions,
    ask: &'a mut Ask<'a>,
}

impl Inference<'_> {
    fn run(&mut self) {
        if self.evidence.right_and_wrong(&self.conventions).1.is_empty() {
            return;
        }
        Family::ALL.into_iter().for_each(|family| self.refusals(family));
        for _ in 0..ROUNDS {
            let before = self.conventions.clone();
            Family::ALL.into_iter().for_each(|family| self.layout(family));
            self.strains();
            self.metrics();
            self.energies();
            self.heat();
            self.reading();
            Family::ALL.into_iter().for_each(|family| self.refute(family));
            self.angle();
            if self.conventions == before {
                return;
            }
        }
    }

    /// Whether the program declared a convention. Then it is not read off.
    fn is_declared(&self, key: &str) -> bool {
        self.keys.contains(&key)
    }

    /// Whether no quantity that follows from these is wrong.
    fn followers_are_right(&self, quantities: &[&'static str], conventions: &Conventions) -> bool {
        let followers = self.evidence.followers(quantities);
        let wrong = |name: &&str| {
            self.evidence.row(name).and_then(|row| self.evidence.is_right(row, conventions)) == Some(false)
        };
        !followers.iter().any(wrong)
    }

    /// Order of the strain components and measure of the shear.
    fn strains(&mut self) {
        let voigts = if self.is_declared("voigt") { vec![self.conventions.voigt] } else { Voigt::ALL.to_vec() };
        let declared = self.conventions.shear;
        let is_fixed = self.is_declared("shear");
        let same_measure = |shear: &Shear| !is_fixed || (*shear == Shear::Tensor) == (declared == Shear::Tensor);
        let shears: Vec<Shear> = Shear::all().into_iter().filter(same_measure).collect();
        let tried = voigts.iter().flat_map(|voigt| {
            shears.iter().map(|shear| Conventions { voigt: *voigt, shear: *shear, ..self.conventions.clone() })
        });
        let tried: Vec<Conventions> = tried.collect();
        let (mut right, mut wrong) = self.evidence.right_and_wrong(&self.conventions);
        right.retain(|name| is_of_strain(name));
        wrong.retain(|name| is_of_strain(name));
        let status = (right, wrong);
        let weighed: Vec<(&Conventions, Weight)> =
            tried.iter().map(|with| (with, self.evidence.weigh(&status, with))).collect();
        let most = weighed.iter().map(|(_, weight)| weight.cured.len()).max().unwrap_or_default();
        if most == 0 {
            return;
        }
        let best: Vec<_> = weighed.into_iter().filter(|(_, weight)| weight.cured.len() == most).collect();
        let Some((chosen, weight)) = best.first() else { return };
        // Strain or law alone is no convention where the stress that follows is wrong.
        let cures = |name: &str| weight.cured.contains(&name);
        let both = cures("15.sigma") || cures("8.epsilon_T") && cures("12.epsilon_f");
        let both = both || cures("16.D") && weight.cured.len() > 1;
        if !both && !self.followers_are_right(&weight.cured, chosen) {
            return;
        }
        let words = right_under_it(&weight.cured);
        let measure = |shear: Shear| shear == Shear::Tensor;
        let mut others: Vec<(&'static str, String)> = Vec::new();
        for (other, _) in best.iter().skip(1) {
            if other.voigt != chosen.voigt {
                others.push(("voigt", other.voigt.words()));
            }
            if measure(other.shear) != measure(chosen.shear) {
                others.push(("shear", other.shear.words()));
            }
        }
        if chosen.voigt != self.conventions.voigt {
            self.shown_by.insert("voigt", words.clone());
        }
        if chosen.shear != self.conventions.shear {
            self.shown_by.insert("shear", words);
        }
        let chosen = (*chosen).clone();
        for (key, words) in others {
            let list = self.ambiguous.entry(key).or_default();
            if !list.contains(&words) {
                list.push(words);
            }
        }
        self.conventions = chosen;
    }

    /// S_c, symmetrised or not.
    fn metrics(&mut self) {
        if self.is_declared("S_c") {
            return;
        }
        let mut shears = vec![self.conventions.shear];
        if let Shear::Engineering { K_3, .. } = self.conventions.shear {
            shears.extend([1.0, 2.0].map(|S_c| Shear::Engineering { S_c, K_3 }));
        }
        for shear in shears {
            let with = Conventions { S_c: Metrics::Symmetrised, shear, ..self.conventions.clone() };
            // Its quadratic form and S_c1 tell; what follows from them may have a mistake of its own.
            let nearest = ["13.epsilon_3", "21.S_c1"]
                .map(|name| self.evidence.row(name).and_then(|row| self.evidence.is_right(row, &with)));
            let follow = match nearest {
                [None, None] => self.followers_are_right(&["11.S_c"], &with),
                nearest => !nearest.contains(&Some(false)),
            };
            if self.cures("11.S_c", &with) && follow {
                self.shown_by.insert("S_c", "11.S_c is right under it, and what follows from it".into());
                self.conventions = with;
                return;
            }
        }
    }

    /// Constants of the strain energies.
    fn energies(&mut self) {
        if self.is_declared("U") {
            return;
        }
        for (n, energy) in ENERGIES.into_iter().enumerate() {
            for multiple in MULTIPLES {
                let mut with = self.conventions.clone();
                if let Some(of) = with.energy.0.get_mut(n) {
                    *of = multiple;
                }
                if self.cures(energy, &with) {
                    self.shown_by.insert("U", "the difference is this constant in every state".into());
                    self.conventions = with;
                    break;
                }
            }
        }
    }

    /// Heat inside the law: a strain that keeps its heat, while all that follows is right.
    fn heat(&mut self) {
        if self.is_declared("heat") {
            return;
        }
        for (n, (strain, users)) in STRAINS.into_iter().enumerate() {
            let mut with = self.conventions.clone();
            if let Some(whole) = with.heat.0.get_mut(n) {
                *whole = true;
            }
            let right = |name: &&&str| self.evidence.row(name).and_then(|row| self.evidence.is_right(row, &with));
            let judged: Vec<(&str, bool)> =
                users.iter().filter_map(|name| right(&name).map(|right| (*name, right))).collect();
            // The stress decides; forces and energy where it is not answered.
            let decides = judged.first().is_some_and(|(name, right)| *right && *name == "15.sigma");
            let follow = !judged.is_empty() && judged.iter().all(|(_, right)| *right);
            if self.cures(strain, &with) && (decides || follow) {
                let names: Vec<&str> = judged.iter().filter(|(_, right)| *right).map(|(name, _)| *name).collect();
                self.shown_by.insert("heat", format!("{strain} differs by ε_T alone, and {} right", are(&names)));
                self.conventions = with;
            }
        }
    }

    /// Whether a quantity is wrong, and right under other conventions.
    fn cures(&self, quantity: &str, with: &Conventions) -> bool {
        let right = |conventions: &Conventions| {
            self.evidence.row(quantity).and_then(|row| self.evidence.is_right(row, conventions))
        };
        right(&self.conventions) == Some(false) && right(with) == Some(true)
    }

    /// Whether the program reads e0, e and ė in its own layout.
    fn reading(&mut self) {
        let conventions = self.conventions.clone();
        let is_usual = conventions.element.is_usual() && conventions.cable.is_usual();
        if self.is_declared("state") || conventions.reading == Reading::Own || is_usual {
            return;
        }
        let layouts = [conventions].into_iter().chain(self.alternatives.clone());
        for layout in layouts.collect::<Vec<_>>() {
            let own = Conventions { reading: Reading::Own, ..layout };
            let concerned = |quantity: &str| Family::of(quantity).is_some_and(|family| !family.layout(&own).is_usual());
            if let Some(shown) = self.reads_as(&own, &concerned, &|_| true) {
                self.conventions = own;
                self.shown_by.insert("state", format!("with e0, e and ė rewritten, {} right", are(&shown)));
                self.ask_again(&mut |_| true);
                return;
            }
        }
    }

    /// Whether the program reads θ in degrees.
    fn angle(&mut self) {
        if self.is_declared("theta") || self.conventions.angle == Angle::Degrees {
            return;
        }
        let degrees = Conventions { angle: Angle::Degrees, ..self.conventions.clone() };
        let suite = self.evidence.suite;
        let is_inclined = |n: usize| suite.cases.get(n).is_some_and(|case| inclination(&case.state) != Some(0.0));
        if let Some(shown) = self.reads_as(&degrees, &|quantity| Family::of(quantity).is_some(), &is_inclined) {
            self.conventions = degrees;
            self.shown_by.insert("theta", format!("with θ in degrees, {} right", are(&shown)));
            self.ask_again(&mut |_| true);
        }
    }

    /// Quantities that become right where the state is sent as `with` has it; `None` if there are none, or if another becomes wrong.
    fn reads_as(
        &mut self,
        with: &Conventions,
        concerned: &dyn Fn(&str) -> bool,
        is_telling: &dyn Fn(usize) -> bool,
    ) -> Option<Vec<&'static str>> {
        let (mut failing, mut right) = (Vec::new(), Vec::new());
        for row in self.evidence.rows.iter().filter(|row| concerned(row.quantity)) {
            let cases = self.evidence.failing(row, &self.conventions);
            let telling = |cases: &mut dyn Iterator<Item = usize>| self.plainest(cases.filter(|n| is_telling(*n)));
            if let Some(n) = telling(&mut cases.iter().copied()) {
                failing.push((row.quantity, n));
            } else if cases.is_empty() {
                let answered = row.cases.iter().filter(|(_, seen)| matches!(seen, Seen::Numbers(_))).map(|(n, _)| *n);
                right.extend(telling(&mut answered.into_iter()).map(|n| (row.quantity, n)));
            }
        }
        let mut cured = Vec::new();
        // Every third of many, as neighbours often share a mistake.
        let step = failing.len().div_ceil(PROBES).max(1);
        for (quantity, n) in failing.into_iter().step_by(step) {
            if self.is_right_as(quantity, n, with) {
                cured.push(quantity);
            }
        }
        if cured.is_empty() || !right.into_iter().all(|(quantity, n)| self.is_right_as(quantity, n, with)) {
            return None;
        }
        Some(cured)
    }

    fn is_right_as(&mut self, quantity: &'static str, n: usize, with: &Conventions) -> bool {
        let answer = (self.ask)(quantity, n, with);
        self.evidence.agrees(quantity, &(n, answer), with)
    }

    /// The case that tells most, of these: not inclined, as its θ does not matter, and moved at random.
    fn plainest(&self, cases: impl Iterator<Item = usize>) -> Option<usize> {
        let suite = self.evidence.suite;
        let rank = |n: &usize| {
            let case = suite.cases.get(*n);
            let is_flat = case.is_some_and(|case| inclination(&case.state) == Some(0.0));
            let is_random = case.is_some_and(|case| case.tags.iter().any(|tag| tag == "random"));
            (!is_flat, !is_random)
        };
        cases.min_by_key(rank)
    }

    /// Asks for all failing quantities again, with the states of the present conventions.
    fn ask_again(&mut self, concerned: &mut dyn FnMut(&str) -> bool) {
        let failing: Vec<&'static str> = (self.evidence.rows.iter())
            .filter(|row| concerned(row.quantity) && Family::of(row.quantity).is_some())
            .filter(|row| !self.evidence.failing(row, &self.conventions).is_empty())
            .map(|row| row.quantity)
            .collect();
        for (quantity, cases) in self.answers.0.iter_mut().filter(|(quantity, _)| failing.contains(quantity)) {
            let mut ended = 0;
            for own in cases.iter_mut().filter(|(_, answer)| !matches!(answer, Ok(Answer::NotImplemented))) {
                if ended >= PATIENCE {
                    break;
                }
                own.1 = (self.ask)(quantity, own.0, &self.conventions);
                ended += usize::from(matches!(own.1, Err(Fault::TimeLimit(_) | Fault::Crash(_) | Fault::Endless(_))));
                self.evidence.replace(quantity, own.0, own);
            }
        }
    }

    /// Conventions that differ from the fixtures, in words.
    fn named(&self) -> Vec<Convention> {
        let (of, usual) = (&self.conventions, Conventions::default());
        let mut all = of.element.differences();
        all.extend(of.cable.differences());
        if of.reading != usual.reading {
            all.push(("state", "the state's e0, e and ė are read in the program's own layout".into()));
        }
        if of.matrices != usual.matrices {
            all.push(("matrices", of.matrices.words().into()));
        }
        if of.voigt != usual.voigt {
            all.push(("voigt", of.voigt.words()));
        }
        if of.shear != usual.shear {
            all.push(("shear", of.shear.words()));
        }
        if of.S_c != usual.S_c {
            all.push(("S_c", "S_c symmetrised: ½ (S_c + S_cᵀ)".into()));
        }
        if of.energy != usual.energy {
            all.push(("U", of.energy.words()));
        }
        if of.heat != usual.heat {
            all.push(("heat", of.heat.words()));
        }
        if of.angle != usual.angle {
            all.push(("theta", "θ in degrees".into()));
        }
        let named = |(name, words): (&'static str, String)| {
            let how = if self.is_declared(name) { How::Declared } else { How::Inferred };
            let evidence = match how {
                How::Declared => "its hello says so".into(),
                How::Inferred => self.shown_by.get(name).cloned().unwrap_or_default(),
            };
            let ambiguous_with = self.ambiguous.get(name).cloned().unwrap_or_default();
            Convention { name, words, how, evidence, ambiguous_with }
        };
        all.into_iter().map(named).collect()
    }

    /// All answers in the conventions of the fixtures.
    fn translated(self) -> Answers {
        let (conventions, suite) = (&self.conventions, self.evidence.suite);
        if conventions.are_usual() {
            return self.answers;
        }
        let ours = |quantity: &'static str, (n, answer): CaseAnswer| {
            (n, answer.map(|answer| conventions.answer(suite, quantity, n, answer)))
        };
        let rows = self.answers.0.into_iter();
        let rows = rows.map(|(quantity, cases)| (quantity, cases.into_iter().map(|own| ours(quantity, own)).collect()));
        Answers(rows.collect())
    }
}

/// Whether a quantity's value depends on the order of strains or on the measure of shear.
fn is_of_strain(quantity: &str) -> bool {
    let of_strain = |axis: &Axis| matches!(axis, Axis::Strain | Axis::ByStrain | Axis::Stress);
    let is_of_shear = matches!(quantity, "13.epsilon_3" | "11.S_c" | "21.S_c1" | "21.K_3");
    is_of_shear || axes(quantity).iter().any(of_strain)
}

/// Inclination of a state's element, rad.
fn inclination(state: &State) -> Option<f64> {
    match state {
        State::Element(state) => Some(state.theta),
        State::Cable(state) => Some(state.theta),
        State::System(_) => None,
    }
}

fn list(names: &[&str]) -> String {
    let shown = names.iter().take(MOST_NAMED).copied().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(MOST_NAMED) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

fn right_under_it(names: &[&str]) -> String {
    format!("{} right under it in every state", are(names))
}

/// A list of names with its verb.
fn are(names: &[&str]) -> String {
    format!("{} {}", list(names), if names.len() == 1 { "is" } else { "are" })
}
