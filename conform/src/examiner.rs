//! The examiner: asks every question and judges the answers.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Instant;

use serde_json::Value;

use crate::answers::{Answers, CaseAnswer, judged};
use crate::blame::{Blame, Status, WithGiven, blame};
use crate::convention::{self, Conventions, Declared};
use crate::diagnosis::{Ancestor, Seen, Upstream, ancestors, diagnose, invisible};
use crate::examination::{CaseVerdict, Examination, InvalidOutcome, InvalidVerdict};
use crate::given::{scaled, unread};
use crate::graph::{GRAPH, Node};
use crate::lost_digits::LostDigits;
use crate::memory::Repetition;
use crate::own_digits;
use crate::precision::Precision;
use crate::protocol::{Answer, Asked, Hello, announcement};
use crate::selection::Selection;
use crate::standing::{any, first_failing, observations, status, with_given};
use crate::subject::Subject;
use crate::suite::{InvalidCase, Suite};
use crate::verdict::{Fault, Verdict};

/// Number of times that a program may hang or crash at a quantity before the rest of its cases is skipped.
const PATIENCE: usize = 3;

/// Options of an examination.
#[derive(Clone, Debug)]
pub struct Options {
    /// Whether reference values of intermediate quantities are sent to a program that accepts them.
    pub given: bool,
    /// What is asked.
    pub asked: Selection,
}

impl Default for Options {
    fn default() -> Options {
        Options { given: true, asked: Selection::default() }
    }
}

/// Examines a program: asks every question, and finds the equations that are wrong.
///
/// `progress` receives the share that is done, from 0 to 1. Any fault of the program is a result.
pub fn examine(suite: &Suite, subject: &mut dyn Subject, options: Options, progress: impl Fn(f64)) -> Examination {
    let started = Instant::now();
    let hello = subject.hello(&announcement(suite));
    let accepts_given = options.given && hello.as_ref().is_ok_and(|hello| hello.given);
    let declared = hello.as_ref().map(|hello| Declared::read(&hello.conventions)).unwrap_or_default();
    let conventions = declared.conventions.clone();
    let (asked, ids) = (options.asked, BTreeSet::new());
    let mut examiner = Examiner { suite, subject, hello, conventions, asked, questions: 0, ids };
    let answers = examiner.answers(&progress);
    // The form of the numbers shows before they are translated.
    let mut precision = Precision::found(suite, &answers);
    let fixtures = suite;
    let at_precision = precision.applied(fixtures, &answers);
    let suite = at_precision.as_ref();
    examiner.suite = suite;
    let found = convention::infer(suite, &declared, answers, &mut |quantity, n, conventions| {
        examiner.ask(quantity, n, &[], conventions)
    });
    // States that were refused at first may have answers now.
    let at_precision = precision.applied(fixtures, &found.answers);
    let suite = at_precision.as_ref();
    let of_own_digits = own_digits::widened(suite, &precision, &found.conventions);
    let suite = of_own_digits.as_ref().unwrap_or(suite);
    examiner.suite = suite;
    examiner.conventions = found.conventions;
    let invalid = examiner.invalid();
    let answers = found.answers;
    let verdicts = answers.judged(suite);
    let failing = first_failing(&verdicts);
    let mut memory = examiner.repeat(&answers, |repetition| repetition.memory(&failing)).flatten();
    // Second answers of a program with memory depend on the first ones.
    let accepts_given = accepts_given && memory.is_none();
    let mut again: BTreeMap<&str, Vec<CaseVerdict>> = (verdicts.iter().zip(GRAPH))
        .filter(|((_, cases), node)| accepts_given && !node.given.is_empty() && any(cases, Verdict::fails))
        .map(|((quantity, cases), node)| (*quantity, examiner.with_given(node, cases)))
        .collect();
    let unread = examiner.unread(&verdicts, &again);
    let given_ignored: Vec<&'static str> = (GRAPH.iter())
        .filter(|node| unread.get(node.quantity).is_some_and(|unread| unread.len() == node.given.len()))
        .map(|node| node.quantity)
        .collect();
    // Values that were not read are no evidence.
    again.retain(|quantity, _| !given_ignored.contains(quantity));
    // Right ones need not be read: the program may well compute them where it needs them, at points of its own.
    let is_wrong =
        |input: &str| verdicts.iter().any(|(quantity, cases)| *quantity == input && any(cases, Verdict::fails));
    let given_ignored: Vec<&'static str> = (GRAPH.iter())
        .filter(|node| given_ignored.contains(&node.quantity) && node.given.iter().any(|input| is_wrong(input)))
        .map(|node| node.quantity)
        .collect();
    let again = |quantity: &str| again.get(quantity).map(Vec::as_slice);
    let statuses: BTreeMap<&str, Status> =
        verdicts.iter().map(|(quantity, cases)| (*quantity, status(cases, again(quantity)))).collect();
    // A program that was not asked has no wrong equation.
    let lost = LostDigits::of(suite, &verdicts);
    let mut blame = if examiner.hello.is_ok() { blame(&statuses, &unread, &lost) } else { Blame::default() };
    if let Some(memory) = &mut memory {
        examiner.repeat(&answers, |repetition| repetition.acquit(memory, &mut blame, &failing));
    }
    let culprits = blame.culprits.iter().filter_map(|culprit| {
        let (quantity, cases) = verdicts.iter().find(|(quantity, _)| *quantity == culprit.quantity)?;
        // Answers to reference inputs show the quantity's own mistake alone.
        let own = again(quantity).filter(|own| any(own, Verdict::fails)).unwrap_or_default();
        Some((*quantity, diagnose(quantity, &observations(suite, cases, own))))
    });
    let diagnoses = culprits.collect();
    let ancestors = ancestors_of(suite, &blame, &verdicts, &statuses);
    let is_reduced = |quantity: &str| precision.of(quantity).is_reduced();
    let reduced =
        verdicts.iter().filter(|(quantity, cases)| is_reduced(quantity) && any(cases, |v| v.digits().is_some()));
    let invisible = reduced.flat_map(|(quantity, _)| invisible(quantity, suite)).collect();
    progress(1.0);
    Examination {
        description: examiner.subject.description(),
        chatter: examiner.subject.chatter(),
        remarks: examiner.subject.remarks(),
        in_part: !examiner.asked.is_everything(),
        starts: examiner.subject.starts(),
        hello: examiner.hello,
        conventions: found.named,
        convention_errors: declared.errors,
        questions: examiner.questions,
        seconds: started.elapsed().as_secs_f64(),
        precision,
        invisible,
        verdicts,
        invalid,
        blame,
        diagnoses,
        ancestors,
        memory,
        given_ignored,
    }
}

/// Earlier quantities that each culprit's mistake may be in, although they are not answered.
fn ancestors_of(
    suite: &Suite,
    blame: &Blame,
    verdicts: &[(&'static str, Vec<CaseVerdict>)],
    statuses: &BTreeMap<&str, Status>,
) -> BTreeMap<&'static str, Vec<Ancestor>> {
    let seen: Seen = (verdicts.iter())
        .map(|(quantity, cases)| (*quantity, observations(suite, cases, &[])))
        .filter(|(_, observations)| !observations.is_empty())
        .collect();
    let is_right = |quantity: &str| statuses.get(quantity) == Some(&Status::Right);
    let numbers = blame.culprits.iter().filter(|culprit| culprit.numbers);
    let mut upstream = Upstream::default();
    numbers.map(|culprit| (culprit.quantity, ancestors(culprit.quantity, &seen, is_right, &mut upstream))).collect()
}

struct Examiner<'a> {
    suite: &'a Suite,
    subject: &'a mut dyn Subject,
    hello: Result<Hello, Fault>,
    /// Conventions of the program: those it declared, then those that its answers show.
    conventions: Conventions,
    asked: Selection,
    questions: usize,
    /// Names of the questions so far.
    ids: BTreeSet<String>,
}

impl<'a> Examiner<'a> {
    /// Whether the program implements a quantity, as far as it said.
    fn has(&self, quantity: &str) -> bool {
        let listed = self.hello.as_ref().ok().and_then(|hello| hello.quantities.as_ref());
        listed.is_none_or(|list| list.iter().any(|id| id == quantity))
    }

    /// Asks every question.
    fn answers(&mut self, progress: &impl Fn(f64)) -> Answers {
        let mut answers = Vec::new();
        for (n, node) in GRAPH.iter().enumerate() {
            answers.push((node.quantity, self.in_every_case(node.quantity)));
            progress((n + 1) as f64 / (GRAPH.len() + 1) as f64);
        }
        Answers(answers)
    }

    /// Asks for a quantity in every case that has a reference value.
    fn in_every_case(&mut self, quantity: &'static str) -> Vec<CaseAnswer> {
        let (suite, has) = (self.suite, self.has(quantity));
        let (mut answers, mut ended) = (Vec::new(), 0);
        let conventions = self.conventions.clone();
        if !self.asked.has_quantity(quantity) {
            return answers;
        }
        for (n, case) in suite.cases.iter().enumerate().filter(|(_, case)| case.values.contains_key(quantity)) {
            if !self.asked.has_state(&case.id) {
                continue;
            }
            let answer = if !has {
                Ok(Answer::NotImplemented)
            } else if ended >= PATIENCE {
                Err(Fault::NotAsked(format!("it hung or crashed {PATIENCE} times before, or wrote an endless line")))
            } else {
                self.ask(quantity, n, &[], &conventions)
            };
            ended += match answer {
                Err(Fault::TimeLimit(_) | Fault::Buffered(_) | Fault::Crash(_)) => 1,
                // A program that writes an endless line will do so again, and each one takes long.
                Err(Fault::Endless(_)) => PATIENCE,
                _ => 0,
            };
            answers.push((n, answer));
        }
        answers
    }

    /// Asks again with reference values of the quantity's inputs. Right cases are included, since two mistakes may have cancelled there.
    fn with_given(&mut self, node: &Node, cases: &[CaseVerdict]) -> Vec<CaseVerdict> {
        let (suite, conventions) = (self.suite, self.conventions.clone());
        let answered = cases.iter().filter(|(_, verdict)| match verdict {
            Verdict::Pass { .. } | Verdict::Wrong(_) => true,
            // A program that hung or crashed would do so again.
            Verdict::Fault(fault) => matches!(fault, Fault::Error(_) | Fault::Shape(_) | Fault::NotFinite(_)),
            Verdict::NotImplemented => false,
        });
        let again = answered.map(|(n, _)| {
            let answer = self.ask(node.quantity, *n, node.given, &conventions);
            (*n, answer.map(|answer| conventions.answer(suite, node.quantity, *n, answer)))
        });
        judged(suite, node.quantity, &again.collect::<Vec<_>>())
    }

    /// Inputs that the program does not read from `given`, for quantities that remain wrong with reference inputs.
    fn unread(
        &mut self,
        verdicts: &[(&'static str, Vec<CaseVerdict>)],
        again: &BTreeMap<&str, Vec<CaseVerdict>>,
    ) -> BTreeMap<&'static str, Vec<&'static str>> {
        let suite = self.suite;
        let mut all = BTreeMap::new();
        if !self.subject.can_repeat() {
            return all;
        }
        for ((quantity, cases), node) in verdicts.iter().zip(GRAPH) {
            let Some(again) = again.get(quantity) else { continue };
            if any(again, Verdict::fails) && matches!(with_given(cases, again), WithGiven::Wrong | WithGiven::Same) {
                let conventions = self.conventions.clone();
                let mut ask = |n: usize, altered: Option<&str>| {
                    let answer = self.ask_altered(quantity, n, node.given, altered, &conventions)?;
                    Ok(conventions.answer(suite, quantity, n, answer))
                };
                all.insert(*quantity, unread(suite, node, again, &mut ask));
            }
        }
        all
    }

    /// Asks questions again, unless nothing was asked.
    fn repeat<T>(&mut self, answers: &Answers, look: impl FnOnce(&mut Repetition) -> T) -> Option<T> {
        if self.hello.is_err() || !self.subject.can_repeat() {
            return None;
        }
        let mut repetition = Repetition::of(self.suite, self.subject, &self.conventions, answers);
        let found = look(&mut repetition);
        self.questions += repetition.questions();
        Some(found)
    }

    /// Asks for a quantity in every state that must be refused.
    fn invalid(&mut self) -> Vec<InvalidVerdict> {
        let (suite, conventions) = (self.suite, self.conventions.clone());
        let verdict = |case: &InvalidCase| {
            let asked = self.asked.has_quantity(&case.equation) && self.asked.has_state(&case.id);
            let (outcome, detail) = match asked && self.has(&case.equation) {
                false => (InvalidOutcome::NotImplemented, None),
                true => match self.send(&case.equation, &case.id, &case.state, BTreeMap::new(), &conventions) {
                    Ok(Answer::Error(message)) => (InvalidOutcome::Refused, Some(message)),
                    Ok(Answer::Value(_)) => (InvalidOutcome::Accepted, None),
                    Ok(Answer::NotImplemented) => (InvalidOutcome::NotImplemented, None),
                    Err(fault) => (InvalidOutcome::Fault, Some(fault.to_string())),
                },
            };
            InvalidVerdict { outcome, detail }
        };
        suite.invalid.iter().map(verdict).collect()
    }

    /// Asks for a quantity in the case with index `n`, with reference values of `given`, all in these conventions.
    fn ask(
        &mut self,
        quantity: &str,
        n: usize,
        given: &[&'static str],
        conventions: &Conventions,
    ) -> Result<Answer, Fault> {
        self.ask_altered(quantity, n, given, None, conventions)
    }

    /// [`ask`](Examiner::ask) with one of the given values altered.
    fn ask_altered(
        &mut self,
        quantity: &str,
        n: usize,
        given: &[&'static str],
        altered: Option<&str>,
        conventions: &Conventions,
    ) -> Result<Answer, Fault> {
        let suite = self.suite;
        let Some(case) = suite.cases.get(n) else { return Ok(Answer::NotImplemented) };
        let mut theirs = conventions.all_given(case, quantity, given);
        if let Some((_, value)) = theirs.iter_mut().find(|(name, _)| Some(*name) == altered) {
            *value = scaled(value);
        }
        let name = match altered {
            _ if given.is_empty() => case.id.clone(),
            None => format!("{}/given", case.id),
            Some(altered) => format!("{}/given/{altered}-altered", case.id),
        };
        let given = theirs.iter().map(|(name, value)| (*name, value)).collect();
        self.send(quantity, &name, &case.state_json, given, conventions)
    }

    /// Sends a question; the state is rewritten as the program reads it. `name` is that of the state, and what is special about the
    /// question.
    fn send(
        &mut self,
        equation: &str,
        name: &str,
        state: &Value,
        given: BTreeMap<&str, &Value>,
        conventions: &Conventions,
    ) -> Result<Answer, Fault> {
        if let Err(fault) = &self.hello {
            return Err(Fault::NotAsked(format!("it did not answer hello: {fault}")));
        }
        self.questions += 1;
        let id = self.id(format!("{equation}/{name}"));
        let rewritten = conventions.state(state);
        self.subject.ask(&Asked { equation, given, id: &id, state: rewritten.as_ref().unwrap_or(state) })
    }

    /// A name that no question had: the same question again gets a number, so that a late answer is none to it.
    fn id(&mut self, name: String) -> String {
        let mut id = name.clone();
        let mut times = 1;
        while !self.ids.insert(id.clone()) {
            times += 1;
            id = format!("{name}#{times}");
        }
        id
    }
}
