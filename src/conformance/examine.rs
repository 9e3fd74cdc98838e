//! Every question asked, and what came of it.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use super::blame::{Blame, Standing, WithGiven, blame};
use super::graph::{GRAPH, Node};
use super::mistakes::{Finding, Observation, diagnose};
use super::program::Program;
use super::protocol::{self, Answer, Hello, hello_line, question_line};
use super::suite::{Case, Reference, Suite};
use super::verdict::{Fault, Verdict, Wrong};
use crate::error::Result;

/// A quantity is given up after it hung or crashed this often.
const PATIENCE: usize = 3;

/// What a program is asked, and how.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Time limit of a question.
    pub time_limit: Duration,
    /// Whether the reference's intermediate values are handed over to a program that takes them.
    pub given: bool,
}

/// All that was found out about a program.
#[derive(Debug)]
pub struct Examination {
    /// What it says of itself.
    pub hello: Hello,
    /// Verdicts by quantity and case, in the order of asking.
    pub verdicts: Vec<(&'static str, Vec<(usize, Verdict)>)>,
    /// What became of the states that have to be refused, by their place in the suite.
    pub refusals: Vec<(usize, Refusal)>,
    /// Which equation is wrong.
    pub blame: Blame,
    /// What kind of mistake fits, for each of the culprits.
    pub findings: Vec<(&'static str, Finding)>,
    /// How often the program was started.
    pub starts: usize,
    /// Questions.
    pub questions: usize,
    /// How long all of it took, s.
    pub seconds: f64,
}

/// What became of a state that has to be refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// An error, as it has to be.
    Refused(String),
    /// A value, as if nothing was wrong.
    Accepted,
    /// The quantity is not implemented.
    NotImplemented,
    /// Something else.
    Fault(Fault),
}

impl Examination {
    /// Whether nothing failed.
    pub fn passes(&self) -> bool {
        let failing = |(_, cases): &(&str, Vec<(usize, Verdict)>)| cases.iter().any(|(_, verdict)| verdict.fails());
        let kept = |(_, refusal): &(usize, Refusal)| !matches!(refusal, Refusal::Refused(_) | Refusal::NotImplemented);
        !self.verdicts.iter().any(failing) && !self.refusals.iter().any(kept) && self.implemented() > 0
    }

    /// How many quantities the program has.
    pub fn implemented(&self) -> usize {
        let has = |(_, cases): &&(&str, Vec<(usize, Verdict)>)| {
            cases.iter().any(|(_, verdict)| *verdict != Verdict::NotImplemented)
        };
        self.verdicts.iter().filter(has).count()
    }
}

/// Asks everything; `progress` is told the share that is done.
///
/// # Errors
/// Those of [`Program::start`]; whatever goes wrong later is a result.
pub fn examine(suite: &Suite, command: &[String], options: Options, progress: impl Fn(f64)) -> Result<Examination> {
    let started = Instant::now();
    let program = Program::start(command, options.time_limit, hello_line(suite))?;
    let mut examiner = Examiner { suite, program, questions: 0 };
    let has = |node: &Node, hello: &Hello| {
        hello.quantities.as_ref().is_none_or(|list| list.iter().any(|id| id == node.quantity))
    };
    let mut verdicts = Vec::new();
    for (n, node) in GRAPH.iter().enumerate() {
        let asked = has(node, &examiner.program.hello);
        verdicts.push((node.quantity, examiner.verdicts(node.quantity, asked)));
        progress((n + 1) as f64 / (GRAPH.len() + 1) as f64);
    }
    let refusals = examiner.refusals();
    let hands_over = options.given && examiner.program.hello.given;
    let again: BTreeMap<&str, Vec<(usize, Verdict)>> = verdicts
        .iter()
        .zip(GRAPH)
        .filter(|_| hands_over)
        .filter(|((_, cases), node)| !node.given.is_empty() && cases.iter().any(|(_, verdict)| verdict.fails()))
        .map(|((quantity, cases), node)| (*quantity, examiner.with_given(node, cases)))
        .collect();
    let standings =
        verdicts.iter().map(|(quantity, cases)| (*quantity, standing(cases, again.get(quantity)))).collect();
    let blame = blame(&standings);
    let culprits = blame.culprits.iter().filter_map(|culprit| {
        let (quantity, cases) = verdicts.iter().find(|(quantity, _)| *quantity == culprit.quantity)?;
        // What was answered to the reference's inputs shows the quantity's own mistake alone.
        let own = again.get(quantity).filter(|own| own.iter().any(|(_, verdict)| verdict.fails()));
        Some((*quantity, diagnose(quantity, &observations(suite, cases, own))))
    });
    let findings = culprits.collect();
    progress(1.0);
    Ok(Examination {
        hello: examiner.program.hello.clone(),
        findings,
        blame,
        refusals,
        starts: examiner.program.starts,
        questions: examiner.questions,
        seconds: started.elapsed().as_secs_f64(),
        verdicts,
    })
}

/// The cases of a quantity with their answers; those that were asked again stand for the first ones.
fn observations<'a>(
    suite: &'a Suite,
    cases: &'a [(usize, Verdict)],
    again: Option<&'a Vec<(usize, Verdict)>>,
) -> Vec<Observation<'a>> {
    let second = |n: usize| again?.iter().find(|(case, _)| *case == n).map(|(_, verdict)| verdict);
    let seen = |(n, verdict): &'a (usize, Verdict)| {
        let case = suite.cases.get(*n)?;
        match second(*n).unwrap_or(verdict) {
            Verdict::Pass { .. } => Some(Observation { case, answer: Some(None) }),
            Verdict::Wrong(Wrong { answer, .. }) => Some(Observation { case, answer: Some(Some(answer)) }),
            Verdict::Fault(Fault::Error(_) | Fault::Shape(_)) => Some(Observation { case, answer: None }),
            Verdict::NotImplemented | Verdict::Fault(_) => None,
        }
    };
    cases.iter().filter_map(seen).collect()
}

fn standing(cases: &[(usize, Verdict)], again: Option<&Vec<(usize, Verdict)>>) -> Standing {
    if cases.iter().any(|(_, verdict)| verdict.fails()) {
        let Some(again) = again else { return Standing::Wrong { with_given: WithGiven::NotTried } };
        let first = |n: usize| cases.iter().find(|(case, _)| *case == n).map(|(_, verdict)| verdict);
        let with_given = if again.iter().all(|(_, verdict)| !verdict.fails()) {
            WithGiven::Right
        } else if again.iter().all(|(n, verdict)| first(*n) == Some(verdict)) {
            WithGiven::Same
        } else {
            WithGiven::Wrong
        };
        return Standing::Wrong { with_given };
    }
    let passed = cases.iter().any(|(_, verdict)| matches!(verdict, Verdict::Pass { .. }));
    if passed { Standing::Right } else { Standing::Unknown }
}

struct Examiner<'a> {
    suite: &'a Suite,
    program: Program,
    questions: usize,
}

impl Examiner<'_> {
    /// One quantity in every case that has a value of it.
    fn verdicts(&mut self, quantity: &str, asked: bool) -> Vec<(usize, Verdict)> {
        let suite = self.suite;
        let (mut verdicts, mut ended) = (Vec::new(), 0);
        for (n, case) in suite.cases.iter().enumerate() {
            let Some(reference) = case.values.get(quantity) else { continue };
            let verdict = if !asked {
                Verdict::NotImplemented
            } else if ended >= PATIENCE {
                Verdict::Fault(Fault::NotAsked(format!("it hung or crashed {PATIENCE} times before")))
            } else {
                self.verdict(quantity, case, reference, &[])
            };
            ended += usize::from(matches!(verdict, Verdict::Fault(Fault::TimeLimit(_) | Fault::Crash(_))));
            verdicts.push((n, verdict));
        }
        verdicts
    }

    /// The failing cases again, with the reference's values of the quantity's inputs.
    fn with_given(&mut self, node: &Node, cases: &[(usize, Verdict)]) -> Vec<(usize, Verdict)> {
        let suite = self.suite;
        let failing = cases.iter().filter(|(_, verdict)| match verdict {
            Verdict::Wrong(_) => true,
            // What hung or crashed would do so again.
            Verdict::Fault(fault) => matches!(fault, Fault::Error(_) | Fault::Shape(_) | Fault::NotFinite(_)),
            _ => false,
        });
        let mut again = Vec::new();
        for (n, _) in failing {
            let Some(case) = suite.cases.get(*n) else { continue };
            let Some(reference) = case.values.get(node.quantity) else { continue };
            again.push((*n, self.verdict(node.quantity, case, reference, node.given)));
        }
        again
    }

    fn verdict(&mut self, quantity: &str, case: &Case, reference: &Reference, given: &[&str]) -> Verdict {
        let id = self.next_id();
        let line = question_line(&id, quantity, case, given.iter().copied());
        match self.program.ask(&id, line) {
            Ok(Answer::Value(value)) => match protocol::numbers(&value, &reference.shape) {
                Ok(numbers) => Verdict::of(numbers, reference),
                Err(fault) => Verdict::Fault(fault),
            },
            Ok(Answer::NotImplemented) => Verdict::NotImplemented,
            Ok(Answer::Error(message)) => Verdict::Fault(Fault::Error(message)),
            Err(fault) => Verdict::Fault(fault),
        }
    }

    /// The states that have to be refused.
    fn refusals(&mut self) -> Vec<(usize, Refusal)> {
        let suite = self.suite;
        let mut refusals = Vec::new();
        for (n, invalid) in suite.invalid.iter().enumerate() {
            let listed = self.program.hello.quantities.as_ref();
            if listed.is_some_and(|list| !list.contains(&invalid.equation)) {
                refusals.push((n, Refusal::NotImplemented));
                continue;
            }
            let id = self.next_id();
            let line = serde_json::json!({"id": id, "equation": invalid.equation, "state": invalid.state});
            refusals.push((
                n,
                match self.program.ask(&id, line.to_string()) {
                    Ok(Answer::Error(message)) => Refusal::Refused(message),
                    Ok(Answer::Value(_)) => Refusal::Accepted,
                    Ok(Answer::NotImplemented) => Refusal::NotImplemented,
                    Err(fault) => Refusal::Fault(fault),
                },
            ));
        }
        refusals
    }

    fn next_id(&mut self) -> String {
        self.questions += 1;
        self.questions.to_string()
    }
}
