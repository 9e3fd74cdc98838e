//! Memory: answers that depend on what was asked before.
//!
//! A program that keeps the mass matrix of its first state, or adds up in a buffer that it never clears, is wrong in a sequence of
//! questions and right when asked first. Its equations are not to blame. Some questions are therefore asked twice: after all others, in
//! another order, and in a fresh process.

use schemars::JsonSchema;
use serde::Serialize;

use crate::answers::Answers;
use crate::blame::Blame;
use crate::convention::Conventions;
use crate::protocol::{self, AGAIN, Answer, Asked};
use crate::quotation::quoted;
use crate::subject::Subject;
use crate::suite::{Reference, Suite};
use crate::verdict::Fault;

/// Number of questions that are asked again in another order.
const SAMPLE: usize = 32;
/// Largest number of fresh processes for a program with memory.
const MOST_FRESH: usize = 16;
/// Largest number of fresh processes in which the question after which it goes wrong is searched.
const MOST_SEARCHES: usize = 9;
/// Largest number of changed answers that are reported.
const MOST_CHANGES: usize = 3;
/// Two answers differ if one is right and they are this many tolerances apart: threads may add up in another order.
const ROUNDING: f64 = 1e3;
/// Two wrong answers differ if they differ by this share of the terms' size: beyond rounding in single precision.
const COARSE: f64 = 1e-4;

/// Evidence that answers depend on what was asked before.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Memory {
    /// Whether the answer differs although each time the question was the first one of a fresh process: random numbers, the clock, or
    /// memory that was never set.
    pub random: bool,
    /// Answers that changed when the question was asked again, at most three.
    pub changed: Vec<ChangedAnswer>,
    /// Failing quantities whose answer is another one in a fresh process. Their equations are not blamed.
    pub quantities: Vec<&'static str>,
    /// The earlier question after which the first changed answer goes wrong; null if it was not found.
    pub after: Option<EarlierQuestion>,
}

/// An answer that changed when the question was asked again.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ChangedAnswer {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Name of the case.
    pub case: String,
    /// When the question was asked again.
    pub again: When,
    /// First answer: the number in the entry that differs most, or the fault.
    pub first_answer: String,
    /// Second answer.
    pub second_answer: String,
    /// Whether the second answer is right.
    pub second_is_right: bool,
}

/// When a question was asked again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum When {
    /// After all other questions.
    AfterAllOthers,
    /// As the first question of a fresh process.
    FirstInAFreshProcess,
    /// In a fresh process, in another order.
    InAnotherOrder,
}

impl When {
    /// Words for the report.
    pub(crate) fn words(self) -> &'static str {
        match self {
            When::AfterAllOthers => "asked again after all others",
            When::FirstInAFreshProcess => "asked first in a fresh process",
            When::InAnotherOrder => "asked in another order in a fresh process",
        }
    }
}

/// An earlier question after which an answer goes wrong.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EarlierQuestion {
    /// Name of its quantity.
    pub quantity: &'static str,
    /// Name of its case.
    pub case: String,
    /// Number of questions from it to the answer that goes wrong: 1 is the question just before.
    pub questions_before: usize,
    /// Whether the answer is right if the sequence begins one question later. Otherwise the search ended before.
    pub exact: bool,
}

/// A question by its quantity and its case, and the first answer to it.
struct First<'a> {
    quantity: &'static str,
    case: usize,
    answer: &'a Result<Answer, Fault>,
}

/// Asks questions again and compares the answers.
pub struct Repetition<'a> {
    suite: &'a Suite,
    subject: &'a mut dyn Subject,
    conventions: &'a Conventions,
    /// Questions in their order, without those that left no process to ask.
    sequence: Vec<First<'a>>,
    questions: usize,
    fresh: usize,
}

impl<'a> Repetition<'a> {
    /// Repetition of questions whose first answers are known, translated from the program's conventions.
    pub fn of(
        suite: &'a Suite,
        subject: &'a mut dyn Subject,
        conventions: &'a Conventions,
        answers: &'a Answers,
    ) -> Repetition<'a> {
        let all = answers.0.iter().flat_map(|(quantity, answers)| {
            answers.iter().map(|(case, answer)| First { quantity, case: *case, answer })
        });
        let has_answer = |first: &First| match first.answer {
            Ok(answer) => *answer != Answer::NotImplemented,
            Err(_) => false,
        };
        let sequence = all.filter(has_answer).collect();
        Repetition { suite, subject, conventions, sequence, questions: 0, fresh: 0 }
    }

    /// Number of questions that were asked again.
    pub fn questions(&self) -> usize {
        self.questions
    }

    /// Looks for answers that change. `failing` has the first failing case of each quantity that fails, in the order of the questions.
    pub fn memory(&mut self, failing: &[(&'static str, usize)]) -> Option<Memory> {
        let mut changed: Vec<ChangedAnswer> = Vec::new();
        let mut quantities = Vec::new();
        let sample = self.sample();
        for n in &sample {
            changed.extend(self.again(*n, When::AfterAllOthers));
        }
        let failing: Vec<usize> = failing.iter().filter_map(|(quantity, case)| self.find(quantity, *case)).collect();
        if self.restart() {
            for (place, n) in failing.iter().enumerate() {
                let when = if place == 0 { When::FirstInAFreshProcess } else { When::InAnotherOrder };
                if let Some(change) = self.again(*n, when) {
                    quantities.push(change.quantity);
                    changed.push(change);
                }
            }
            for n in &sample {
                changed.extend(self.again(*n, When::InAnotherOrder));
            }
        }
        if changed.is_empty() {
            return None;
        }
        // An answer that is right in a fresh process says most.
        changed.sort_by_key(|change| (!change.second_is_right, change.again != When::FirstInAFreshProcess));
        let first = changed.first().and_then(|change| {
            let case = self.suite.cases.iter().position(|case| case.id == change.case)?;
            self.find(change.quantity, case)
        });
        let random = first.is_some_and(|n| self.is_random(n));
        let after = first.filter(|_| !random).and_then(|n| self.earlier_question(n));
        changed.truncate(MOST_CHANGES);
        Some(Memory { random, changed, quantities, after })
    }

    /// Takes the blame from quantities that answer otherwise in a fresh process.
    pub fn acquit(&mut self, memory: &mut Memory, blame: &mut Blame, failing: &[(&'static str, usize)]) {
        let first_failing = |quantity: &str| failing.iter().find(|(name, _)| *name == quantity).copied();
        for culprit in &blame.culprits {
            let Some((quantity, case)) = first_failing(culprit.quantity) else { continue };
            let Some(n) = self.find(quantity, case) else { continue };
            if !memory.quantities.contains(&quantity)
                && self.restart()
                && self.again(n, When::FirstInAFreshProcess).is_some()
            {
                memory.quantities.push(quantity);
            }
        }
        blame.culprits.retain(|culprit| !memory.quantities.contains(&culprit.quantity));
    }

    /// Questions from all parts of the sequence, backwards. The step shares no factor with the numbers of cases, so that neighbours
    /// differ in their state as well.
    fn sample(&self) -> Vec<usize> {
        let least = self.sequence.len() / SAMPLE + 1;
        let step = (least..).find(|step| step % 2 == 1 && step % 3 != 0).unwrap_or(1);
        let mut sample: Vec<usize> = (0..self.sequence.len()).step_by(step).collect();
        sample.reverse();
        sample
    }

    fn find(&self, quantity: &str, case: usize) -> Option<usize> {
        self.sequence.iter().position(|first| first.quantity == quantity && first.case == case)
    }

    /// A fresh process; `false` if there is none.
    fn restart(&mut self) -> bool {
        self.fresh += 1;
        self.fresh <= MOST_FRESH && self.subject.restart()
    }

    /// Asks question `n` of the sequence.
    fn ask(&mut self, n: usize) -> Option<Result<Answer, Fault>> {
        let First { quantity: equation, case: place, .. } = *self.sequence.get(n)?;
        let (suite, conventions) = (self.suite, self.conventions);
        let case = suite.cases.get(place)?;
        self.questions += 1;
        let id = format!("{AGAIN}{}", self.questions);
        let rewritten = conventions.state(&case.state_json);
        let theirs = conventions.all_given(case, equation, &[]);
        let given = theirs.iter().map(|(name, value)| (*name, value)).collect();
        let state = rewritten.as_ref().unwrap_or(&case.state_json);
        let answer = self.subject.ask(&Asked { equation, given, id: &id, state });
        Some(answer.map(|answer| conventions.answer(suite, equation, place, answer)))
    }

    /// Asks question `n` again; the change if the answer differs.
    fn again(&mut self, n: usize, again: When) -> Option<ChangedAnswer> {
        let second = self.ask(n)?;
        let First { quantity, case, answer } = self.sequence.get(n)?;
        let case = self.suite.cases.get(*case)?;
        let reference = case.values.get(*quantity)?;
        let (first_answer, second_answer) = difference(answer, &second, reference)?;
        let second_is_right = numbers(&second, reference).is_some_and(|numbers| is_right(&numbers, reference));
        Some(ChangedAnswer { quantity, case: case.id.clone(), again, first_answer, second_answer, second_is_right })
    }

    /// Whether two fresh processes differ in question `n`, asked first.
    fn is_random(&mut self, n: usize) -> bool {
        let first_of_a_process = |this: &mut Self| if this.restart() { this.ask(n) } else { None };
        let (Some(one), Some(two)) = (first_of_a_process(self), first_of_a_process(self)) else { return false };
        self.reference(n).is_some_and(|reference| difference(&one, &two, reference).is_some())
    }

    fn reference(&self, n: usize) -> Option<&'a Reference> {
        let First { quantity, case, .. } = self.sequence.get(n)?;
        self.suite.cases.get(*case)?.values.get(*quantity)
    }

    /// The latest earlier question from which on the sequence must be asked to get the first answer to question `n` again.
    ///
    /// Asks longer and longer parts of the sequence, each in a fresh process, then halves the interval. As many questions are asked as
    /// the sequence has, at most.
    fn earlier_question(&mut self, n: usize) -> Option<EarlierQuestion> {
        let reference = self.reference(n)?;
        let (mut allowed, mut right, mut wrong) = (self.sequence.len(), 0, None);
        for _ in 0..MOST_SEARCHES {
            let before = match wrong {
                None if right == n => return None,
                None => (8 * right).clamp(1, n),
                Some(wrong) if wrong == right + 1 => break,
                Some(wrong) => usize::midpoint(right, wrong),
            };
            if before > allowed || !self.restart() {
                break;
            }
            allowed -= before;
            for earlier in n - before..n {
                self.ask(earlier)?.ok()?;
            }
            let answer = self.ask(n)?;
            let first = self.sequence.get(n)?.answer;
            if difference(first, &answer, reference).is_none() {
                wrong = Some(before);
            } else {
                right = before;
            }
        }
        let before = wrong?;
        let First { quantity, case, .. } = self.sequence.get(n - before)?;
        let case = self.suite.cases.get(*case)?.id.clone();
        Some(EarlierQuestion { quantity, case, questions_before: before, exact: before == right + 1 })
    }
}

fn numbers(answer: &Result<Answer, Fault>, reference: &Reference) -> Option<Vec<f64>> {
    match answer {
        Ok(Answer::Value(value)) => protocol::numbers(value, &reference.shape).ok(),
        _ => None,
    }
}

fn is_right(numbers: &[f64], reference: &Reference) -> bool {
    reference.worst_entry(numbers).1 <= 1.0
}

/// Two answers in words if they differ by more than rounding.
fn difference(
    first: &Result<Answer, Fault>,
    second: &Result<Answer, Fault>,
    reference: &Reference,
) -> Option<(String, String)> {
    let words = |answer: &Result<Answer, Fault>| match answer {
        Ok(Answer::Value(value)) => quoted(&value.to_string()),
        Ok(Answer::NotImplemented) => "not implemented".into(),
        Ok(Answer::Error(message)) => format!("error: {message}"),
        Err(fault) => fault.to_string(),
    };
    // A question that was not asked has no answer to compare.
    if first == second || [first, second].iter().any(|answer| matches!(answer, Err(Fault::NotAsked(_)))) {
        return None;
    }
    let (Some(one), Some(two)) = (numbers(first, reference), numbers(second, reference)) else {
        // Messages may contain an address or a time.
        let both_errors = matches!((first, second), (Ok(Answer::Error(_)), Ok(Answer::Error(_))));
        return (!both_errors).then(|| (words(first), words(second)));
    };
    let apart = one.iter().zip(&two).zip(&reference.absolute).map(|((one, two), bound)| (one - two).abs() / bound);
    let (entry, most) = apart.enumerate().fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
    let one_is_right = is_right(&one, reference) || is_right(&two, reference);
    let differs = most > if one_is_right { ROUNDING } else { COARSE / reference.relative };
    differs.then(|| (format!("{:e}", one[entry]), format!("{:e}", two[entry])))
}
