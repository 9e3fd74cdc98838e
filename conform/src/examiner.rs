//! Every question asked, and what came of it.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use super::blame::{Blame, Standing, WithGiven, blame};
use super::diagnosis::{Observation, Seen, diagnose};
use super::examination::{Examination, Refusal};
use super::graph::{GRAPH, Node};
use super::protocol::{self, Answer, hello_line, question_line};
use super::subject::Program;
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

/// Asks everything; `progress` is told the share that is done.
///
/// # Errors
/// Those of [`Program::start`]; whatever goes wrong later is a result.
pub fn examine(suite: &Suite, command: &[String], options: Options, progress: impl Fn(f64)) -> Result<Examination> {
    let started = Instant::now();
    let program = Program::start(command, options.time_limit, hello_line(suite))?;
    let (listed, hands_over) = match &program.hello {
        Ok(hello) => (hello.quantities.clone(), options.given && hello.given),
        Err(_) => (None, false),
    };
    let mut examiner = Examiner { suite, program, listed, questions: 0 };
    let mut verdicts = Vec::new();
    for (n, node) in GRAPH.iter().enumerate() {
        verdicts.push((node.quantity, examiner.verdicts(node.quantity)));
        progress((n + 1) as f64 / (GRAPH.len() + 1) as f64);
    }
    let refusals = examiner.refusals();
    let again: BTreeMap<&str, Vec<(usize, Verdict)>> = verdicts
        .iter()
        .zip(GRAPH)
        .filter(|_| hands_over)
        .filter(|((_, cases), node)| !node.given.is_empty() && cases.iter().any(|(_, verdict)| verdict.fails()))
        .map(|((quantity, cases), node)| (*quantity, examiner.with_given(node, cases)))
        .collect();
    let standings =
        verdicts.iter().map(|(quantity, cases)| (*quantity, standing(cases, again.get(quantity)))).collect();
    // Who was not asked has no wrong equation.
    let blame = if examiner.program.hello.is_ok() { blame(&standings) } else { Blame::default() };
    let culprits = blame.culprits.iter().filter_map(|culprit| {
        let (quantity, cases) = verdicts.iter().find(|(quantity, _)| *quantity == culprit.quantity)?;
        // What was answered to the reference's inputs shows the quantity's own mistake alone.
        let own = again.get(quantity).filter(|own| own.iter().any(|(_, verdict)| verdict.fails()));
        Some((*quantity, diagnose(quantity, &observations(suite, cases, own))))
    });
    let findings = culprits.collect();
    progress(1.0);
    Ok(Examination {
        command: command.join(" "),
        hello: examiner.program.hello.clone(),
        chatter: examiner.program.chatter.clone(),
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
        let seen = match second(*n).unwrap_or(verdict) {
            Verdict::Pass { .. } => Seen::Right,
            Verdict::Wrong(Wrong { answer, .. }) => Seen::Numbers(answer),
            Verdict::Fault(fault @ (Fault::Error(_) | Fault::Shape(_))) => Seen::Refused(fault),
            Verdict::Fault(fault) => Seen::Fault(fault),
            Verdict::NotImplemented => return None,
        };
        Some(Observation { case: suite.cases.get(*n)?, seen })
    };
    cases.iter().filter_map(seen).collect()
}

fn standing(cases: &[(usize, Verdict)], again: Option<&Vec<(usize, Verdict)>>) -> Standing {
    let any = |verdicts: &[(usize, Verdict)], wanted: fn(&Verdict) -> bool| verdicts.iter().any(|(_, v)| wanted(v));
    let right: fn(&Verdict) -> bool = |verdict| matches!(verdict, Verdict::Pass { .. });
    let number: fn(&Verdict) -> bool = |verdict| matches!(verdict, Verdict::Pass { .. } | Verdict::Wrong(_));
    if !any(cases, Verdict::fails) {
        return if any(cases, right) { Standing::Right } else { Standing::Unknown };
    }
    if !any(cases, number) && !again.is_some_and(|again| any(again, number)) {
        return Standing::Silent;
    }
    let numbers = any(cases, |verdict| matches!(verdict, Verdict::Wrong(_)));
    Standing::Wrong { numbers, with_given: again.map_or(WithGiven::NotTried, |again| with_given(cases, again)) }
}

/// What became of the cases that were asked again.
fn with_given(cases: &[(usize, Verdict)], again: &[(usize, Verdict)]) -> WithGiven {
    fn of(verdicts: &[(usize, Verdict)], n: usize) -> Option<&Verdict> {
        verdicts.iter().find(|(case, _)| *case == n).map(|(_, verdict)| verdict)
    }
    let right = |verdict: &Verdict| matches!(verdict, Verdict::Pass { .. });
    if again.iter().any(|(_, verdict)| verdict.fails()) {
        let same = |(n, verdict): &(usize, Verdict)| {
            let first = of(cases, *n);
            first == Some(verdict) || (first.is_some_and(right) && right(verdict))
        };
        return if again.iter().all(same) { WithGiven::Same } else { WithGiven::Wrong };
    }
    let failing = cases.iter().filter(|(_, verdict)| verdict.fails());
    let cured = |(n, _): &&(usize, Verdict)| of(again, *n).is_some_and(right);
    let (cured, unasked): (Vec<_>, Vec<_>) = failing.partition(cured);
    match unasked.len() {
        0 => WithGiven::Right,
        unasked => WithGiven::Partly { cured: cured.len(), unasked },
    }
}

struct Examiner<'a> {
    suite: &'a Suite,
    program: Program,
    /// What the program said at first that it has.
    listed: Option<Vec<String>>,
    questions: usize,
}

impl Examiner<'_> {
    /// Whether the program says that it has a quantity, or does not say what it has.
    fn has(&self, quantity: &str) -> bool {
        self.listed.as_ref().is_none_or(|list| list.iter().any(|id| id == quantity))
    }

    /// One quantity in every case that has a value of it.
    fn verdicts(&mut self, quantity: &str) -> Vec<(usize, Verdict)> {
        let (suite, asked) = (self.suite, self.has(quantity));
        let (mut verdicts, mut ended) = (Vec::new(), 0);
        for (n, case) in suite.cases.iter().enumerate() {
            let Some(reference) = case.values.get(quantity) else { continue };
            let verdict = if !asked {
                Verdict::NotImplemented
            } else if ended >= PATIENCE {
                Verdict::Fault(Fault::NotAsked(format!(
                    "it hung or crashed {PATIENCE} times before, or wrote without an end"
                )))
            } else {
                self.verdict(quantity, case, reference, &[])
            };
            ended += match verdict {
                Verdict::Fault(Fault::TimeLimit(_) | Fault::Crash(_)) => 1,
                // Who writes without an end will do so again, and each time is a long one.
                Verdict::Fault(Fault::Endless(_)) => PATIENCE,
                _ => 0,
            };
            verdicts.push((n, verdict));
        }
        verdicts
    }

    /// The cases again, with the reference's values of the quantity's inputs. Those that were right too: two mistakes may have
    /// cancelled there.
    fn with_given(&mut self, node: &Node, cases: &[(usize, Verdict)]) -> Vec<(usize, Verdict)> {
        let suite = self.suite;
        let answered = cases.iter().filter(|(_, verdict)| match verdict {
            Verdict::Pass { .. } | Verdict::Wrong(_) => true,
            // What hung or crashed would do so again.
            Verdict::Fault(fault) => matches!(fault, Fault::Error(_) | Fault::Shape(_) | Fault::NotFinite(_)),
            Verdict::NotImplemented => false,
        });
        let mut again = Vec::new();
        for (n, _) in answered {
            let Some(case) = suite.cases.get(*n) else { continue };
            let Some(reference) = case.values.get(node.quantity) else { continue };
            again.push((*n, self.verdict(node.quantity, case, reference, node.given)));
        }
        again
    }

    fn verdict(&mut self, quantity: &str, case: &Case, reference: &Reference, given: &[&str]) -> Verdict {
        match self.ask(|id| question_line(id, quantity, case, given.iter().copied())) {
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
            let question = |id: &str| {
                serde_json::json!({"id": id, "equation": invalid.equation, "state": invalid.state}).to_string()
            };
            let refusal = if !self.has(&invalid.equation) {
                Refusal::NotImplemented
            } else {
                match self.ask(question) {
                    Ok(Answer::Error(message)) => Refusal::Refused(message),
                    Ok(Answer::Value(_)) => Refusal::Accepted,
                    Ok(Answer::NotImplemented) => Refusal::NotImplemented,
                    Err(fault) => Refusal::Fault(fault),
                }
            };
            refusals.push((n, refusal));
        }
        refusals
    }

    fn ask(&mut self, question: impl Fn(&str) -> String) -> std::result::Result<Answer, Fault> {
        if let Err(fault) = &self.program.hello {
            return Err(Fault::NotAsked(format!("it did not answer hello: {fault}")));
        }
        self.questions += 1;
        let id = self.questions.to_string();
        self.program.ask(&id, question(&id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_with_given_needs_every_failing_case_asked_again() {
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
    fn no_numbers_at_all_is_told_from_some() {
        let (right, crash) = ((0, Verdict::Pass { digits: 15.0 }), (1, Verdict::Fault(Fault::Crash("over".into()))));
        assert_eq!(standing(std::slice::from_ref(&crash), None), Standing::Silent);
        assert_eq!(standing(std::slice::from_ref(&crash), Some(&vec![])), Standing::Silent);
        let faulty = Standing::Wrong { numbers: false, with_given: WithGiven::NotTried };
        assert_eq!(standing(&[right, crash], None), faulty);
    }
}
