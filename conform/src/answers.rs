//! Answers as they came, before they are judged.

use crate::protocol::{self, Answer};
use crate::suite::{Reference, Suite};
use crate::verdict::{CaseVerdict, Fault, Verdict};

/// Index of a case in [`Suite::cases`], and the answer in it.
pub type CaseAnswer = (usize, Result<Answer, Fault>);

/// Answers by quantity and case, in the order of the questions.
#[derive(Clone, Debug, Default)]
pub struct Answers(pub Vec<(&'static str, Vec<CaseAnswer>)>);

impl Answers {
    /// Verdict on every answer.
    pub fn judged(&self, suite: &Suite) -> Vec<(&'static str, Vec<CaseVerdict>)> {
        self.0.iter().map(|(quantity, answers)| (*quantity, judged(suite, quantity, answers))).collect()
    }
}

/// Verdicts on the answers to one quantity.
pub fn judged(suite: &Suite, quantity: &str, answers: &[CaseAnswer]) -> Vec<CaseVerdict> {
    let verdict = |(n, answer): &CaseAnswer| {
        let reference = suite.cases.get(*n)?.values.get(quantity)?;
        Some((*n, verdict(answer, reference)))
    };
    answers.iter().filter_map(verdict).collect()
}

fn verdict(answer: &Result<Answer, Fault>, reference: &Reference) -> Verdict {
    match answer {
        Ok(Answer::Value(value)) => match protocol::numbers(value, &reference.shape) {
            Ok(numbers) => Verdict::of(numbers, reference),
            Err(fault) => Verdict::Fault(fault),
        },
        Ok(Answer::NotImplemented) => Verdict::NotImplemented,
        Ok(Answer::Error(message)) => Verdict::Fault(Fault::Error(message.clone())),
        Err(fault) => Verdict::Fault(fault.clone()),
    }
}
