//! The examiner: asks every question and judges the answers.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::blame::{Blame, Status, WithGiven, blame};
use crate::diagnosis::{Observation, Outcome, diagnose};
use crate::error::Result;
use crate::examination::{CaseVerdict, Examination, InvalidOutcome, InvalidVerdict};
use crate::graph::{GRAPH, Node};
use crate::protocol::{self, Answer, Question, hello_line};
use crate::subject::Subject;
use crate::suite::{Case, InvalidCase, Reference, Suite};
use crate::verdict::{Fault, Verdict, Wrong};

/// Number of times that a program may hang or crash at a quantity before the rest of its cases is skipped.
const PATIENCE: usize = 3;

/// Options of an examination.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Time limit of an answer.
    pub time_limit: Duration,
    /// Whether reference values of intermediate quantities are sent to a program that accepts them.
    pub given: bool,
}

/// Examines a program: starts it, asks every question, and finds the equations that are wrong.
///
/// `command` is the program and its arguments. `progress` receives the share that is done, from 0 to 1.
///
/// # Errors
/// [`Error::Command`](crate::Error::Command) if the program cannot be started. Any later fault of the program is a result.
pub fn examine(suite: &Suite, command: &[String], options: Options, progress: impl Fn(f64)) -> Result<Examination> {
    let started = Instant::now();
    let subject = Subject::start(command, options.time_limit, hello_line(suite))?;
    let listed = subject.hello.as_ref().ok().and_then(|hello| hello.quantities.clone());
    let accepts_given = options.given && subject.hello.as_ref().is_ok_and(|hello| hello.given);
    let mut examiner = Examiner { suite, subject, listed, questions: 0 };
    let mut verdicts = Vec::new();
    for (n, node) in GRAPH.iter().enumerate() {
        verdicts.push((node.quantity, examiner.verdicts(node.quantity)));
        progress((n + 1) as f64 / (GRAPH.len() + 1) as f64);
    }
    let invalid = examiner.invalid();
    let again: BTreeMap<&str, Vec<CaseVerdict>> = (verdicts.iter().zip(GRAPH))
        .filter(|((_, cases), node)| accepts_given && !node.given.is_empty() && any(cases, Verdict::fails))
        .map(|((quantity, cases), node)| (*quantity, examiner.with_given(node, cases)))
        .collect();
    let again = |quantity: &str| again.get(quantity).map(Vec::as_slice);
    let statuses = verdicts.iter().map(|(quantity, cases)| (*quantity, status(cases, again(quantity)))).collect();
    // A program that was not asked has no wrong equation.
    let blame = if examiner.subject.hello.is_ok() { blame(&statuses) } else { Blame::default() };
    let culprits = blame.culprits.iter().filter_map(|culprit| {
        let (quantity, cases) = verdicts.iter().find(|(quantity, _)| *quantity == culprit.quantity)?;
        // Answers to reference inputs show the quantity's own mistake alone.
        let own = again(quantity).filter(|own| any(own, Verdict::fails)).unwrap_or_default();
        Some((*quantity, diagnose(quantity, &observations(suite, cases, own))))
    });
    let diagnoses = culprits.collect();
    progress(1.0);
    Ok(Examination {
        command: command.join(" "),
        hello: examiner.subject.hello.clone(),
        chatter: examiner.subject.chatter.clone(),
        starts: examiner.subject.starts,
        questions: examiner.questions,
        seconds: started.elapsed().as_secs_f64(),
        verdicts,
        invalid,
        blame,
        diagnoses,
    })
}

fn any(cases: &[CaseVerdict], wanted: fn(&Verdict) -> bool) -> bool {
    cases.iter().any(|(_, verdict)| wanted(verdict))
}

/// Verdict in the case with index `n`.
fn verdict_in(cases: &[CaseVerdict], n: usize) -> Option<&Verdict> {
    cases.iter().find(|(case, _)| *case == n).map(|(_, verdict)| verdict)
}

/// Answers to a quantity as evidence. Second answers, `again`, replace the first ones.
fn observations<'a>(suite: &'a Suite, cases: &'a [CaseVerdict], again: &'a [CaseVerdict]) -> Vec<Observation<'a>> {
    let observation = |(n, verdict): &'a CaseVerdict| {
        let outcome = match verdict_in(again, *n).unwrap_or(verdict) {
            Verdict::Pass { .. } => Outcome::Right,
            Verdict::Wrong(Wrong { answer, .. }) => Outcome::Wrong(answer),
            Verdict::Fault(fault @ (Fault::Error(_) | Fault::Shape(_))) => Outcome::Refused(fault),
            Verdict::Fault(fault) => Outcome::Fault(fault),
            Verdict::NotImplemented => return None,
        };
        Some(Observation { case: suite.cases.get(*n)?, outcome })
    };
    cases.iter().filter_map(observation).collect()
}

/// Status of a quantity from its first answers, and from those with reference inputs.
fn status(cases: &[CaseVerdict], again: Option<&[CaseVerdict]>) -> Status {
    let number: fn(&Verdict) -> bool = |verdict| verdict.digits().is_some();
    if !any(cases, Verdict::fails) {
        return if any(cases, Verdict::passes) { Status::Right } else { Status::Unknown };
    }
    if !any(cases, number) && !any(again.unwrap_or_default(), number) {
        return Status::Silent;
    }
    let numbers = any(cases, |verdict| matches!(verdict, Verdict::Wrong(_)));
    Status::Wrong { numbers, with_given: again.map_or(WithGiven::NotTried, |again| with_given(cases, again)) }
}

/// Effect of reference inputs: compares the second answers with the first ones.
fn with_given(cases: &[CaseVerdict], again: &[CaseVerdict]) -> WithGiven {
    if any(again, Verdict::fails) {
        let same = |(n, second): &CaseVerdict| {
            let equal = |first: &Verdict| first == second || first.passes() && second.passes();
            verdict_in(cases, *n).is_some_and(equal)
        };
        return if again.iter().all(same) { WithGiven::Same } else { WithGiven::Wrong };
    }
    let failing = cases.iter().filter(|(_, verdict)| verdict.fails());
    let (cured, unasked): (Vec<_>, Vec<_>) =
        failing.partition(|(n, _)| verdict_in(again, *n).is_some_and(Verdict::passes));
    match unasked.len() {
        0 => WithGiven::Right,
        unasked => WithGiven::Partly { cured: cured.len(), unasked },
    }
}

struct Examiner<'a> {
    suite: &'a Suite,
    subject: Subject,
    /// Quantities that the program listed in its first `hello`.
    listed: Option<Vec<String>>,
    questions: usize,
}

impl Examiner<'_> {
    /// Whether the program implements a quantity, as far as it said.
    fn has(&self, quantity: &str) -> bool {
        self.listed.as_ref().is_none_or(|list| list.iter().any(|id| id == quantity))
    }

    /// Asks for a quantity in every case that has a reference value.
    fn verdicts(&mut self, quantity: &str) -> Vec<CaseVerdict> {
        let (suite, has) = (self.suite, self.has(quantity));
        let (mut verdicts, mut ended) = (Vec::new(), 0);
        for (n, case) in suite.cases.iter().enumerate() {
            let Some(reference) = case.values.get(quantity) else { continue };
            let verdict = if !has {
                Verdict::NotImplemented
            } else if ended >= PATIENCE {
                Verdict::Fault(Fault::NotAsked(format!(
                    "it hung or crashed {PATIENCE} times before, or wrote an endless line"
                )))
            } else {
                self.verdict(quantity, case, reference, &[])
            };
            ended += match verdict {
                Verdict::Fault(Fault::TimeLimit(_) | Fault::Crash(_)) => 1,
                // A program that writes an endless line will do so again, and each one takes long.
                Verdict::Fault(Fault::Endless(_)) => PATIENCE,
                _ => 0,
            };
            verdicts.push((n, verdict));
        }
        verdicts
    }

    /// Asks again with reference values of the quantity's inputs. Right cases are included, since two mistakes may have cancelled there.
    fn with_given(&mut self, node: &Node, cases: &[CaseVerdict]) -> Vec<CaseVerdict> {
        let suite = self.suite;
        let answered = cases.iter().filter(|(_, verdict)| match verdict {
            Verdict::Pass { .. } | Verdict::Wrong(_) => true,
            // A program that hung or crashed would do so again.
            Verdict::Fault(fault) => matches!(fault, Fault::Error(_) | Fault::Shape(_) | Fault::NotFinite(_)),
            Verdict::NotImplemented => false,
        });
        let again = answered.filter_map(|(n, _)| {
            let case = suite.cases.get(*n)?;
            Some((*n, self.verdict(node.quantity, case, case.values.get(node.quantity)?, node.given)))
        });
        again.collect()
    }

    fn verdict(&mut self, quantity: &str, case: &Case, reference: &Reference, given: &[&str]) -> Verdict {
        let given = case.given(quantity, given);
        match self.ask(quantity, &case.state_json, given) {
            Ok(Answer::Value(value)) => match protocol::numbers(&value, &reference.shape) {
                Ok(numbers) => Verdict::of(numbers, reference),
                Err(fault) => Verdict::Fault(fault),
            },
            Ok(Answer::NotImplemented) => Verdict::NotImplemented,
            Ok(Answer::Error(message)) => Verdict::Fault(Fault::Error(message)),
            Err(fault) => Verdict::Fault(fault),
        }
    }

    /// Asks for a quantity in every state that must be refused.
    fn invalid(&mut self) -> Vec<InvalidVerdict> {
        let suite = self.suite;
        let verdict = |case: &InvalidCase| {
            let (outcome, detail) = match self.has(&case.equation) {
                false => (InvalidOutcome::NotImplemented, None),
                true => match self.ask(&case.equation, &case.state, BTreeMap::new()) {
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

    fn ask(&mut self, equation: &str, state: &Value, given: BTreeMap<&str, &Value>) -> Result<Answer, Fault> {
        if let Err(fault) = &self.subject.hello {
            return Err(Fault::NotAsked(format!("it did not answer hello: {fault}")));
        }
        self.questions += 1;
        let id = self.questions.to_string();
        self.subject.ask(&id, Question::Quantity { equation, given, id: &id, state }.line())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_with_given_requires_every_failing_case_to_be_asked_again() {
        let (right, crash) = (Verdict::Pass { digits: 15.0 }, Verdict::Fault(Fault::Crash("exit status: 1".into())));
        let off = Verdict::Fault(Fault::Error("too large".into()));
        let of = |verdicts: &[&Verdict]| verdicts.iter().map(|v| (*v).clone()).enumerate().collect::<Vec<_>>();
        let first = of(&[&right, &off, &crash]);
        assert_eq!(with_given(&first, &of(&[&right])), WithGiven::Partly { cured: 0, unasked: 2 });
        assert_eq!(with_given(&first, &of(&[&right, &right])), WithGiven::Partly { cured: 1, unasked: 1 });
        assert_eq!(with_given(&first, &of(&[&right, &right, &right])), WithGiven::Right);
        assert_eq!(
            with_given(&first, &of(&[&right, &Verdict::NotImplemented, &right])),
            WithGiven::Partly { cured: 1, unasked: 1 }
        );
        assert_eq!(with_given(&first, &of(&[&right, &off])), WithGiven::Same);
        assert_eq!(with_given(&first, &of(&[&off, &off])), WithGiven::Wrong);
    }

    #[test]
    fn silence_differs_from_missing_numbers_in_some_cases() {
        let (right, crash) = ((0, Verdict::Pass { digits: 15.0 }), (1, Verdict::Fault(Fault::Crash("over".into()))));
        assert_eq!(status(std::slice::from_ref(&crash), None), Status::Silent);
        assert_eq!(status(std::slice::from_ref(&crash), Some(&[])), Status::Silent);
        let faulty = Status::Wrong { numbers: false, with_given: WithGiven::NotTried };
        assert_eq!(status(&[right, crash], None), faulty);
    }
}
