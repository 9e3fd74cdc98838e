//! Answers that are numbers, with their reference values.

use super::number::digits;
use crate::answers::{Answers, CaseAnswer};
use crate::protocol::{self, Answer};
use crate::suite::{Reference, Suite};
use crate::verdict::Fault;

/// Least number of digits of a reference value that tells how precise an answer is: fewer are exact in any form.
const TELLING: i32 = 12;

/// Answers to a quantity that are numbers of the right shape.
pub struct Answered<'a> {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Answers with the reference value of their case.
    pub cases: Vec<CaseNumbers<'a>>,
}

/// Numbers that were answered in one case.
pub struct CaseNumbers<'a> {
    /// Answered numbers, row by row.
    pub answer: Vec<f64>,
    /// Reference value.
    pub reference: &'a Reference,
}

/// Whether an answer has a value.
pub fn has_value(answer: &Result<Answer, Fault>) -> bool {
    matches!(answer, Ok(Answer::Value(_)))
}

/// Answers that are numbers, by quantity.
pub fn of<'a>(suite: &'a Suite, answers: &Answers) -> Vec<Answered<'a>> {
    let quantity = |(quantity, cases): &(&'static str, Vec<CaseAnswer>)| {
        let numbers = |(n, answer): &CaseAnswer| {
            let reference = suite.cases.get(*n)?.values.get(*quantity)?;
            let Ok(Answer::Value(value)) = answer else { return None };
            let answer = protocol::numbers(value, &reference.shape).ok()?;
            Some(CaseNumbers { answer, reference })
        };
        Answered { quantity, cases: cases.iter().filter_map(numbers).collect() }
    };
    answers.0.iter().map(quantity).filter(|answered| !answered.cases.is_empty()).collect()
}

impl Answered<'_> {
    /// Pairs of an answered number and its reference value.
    pub fn entries(&self) -> impl Iterator<Item = (f64, f64)> {
        self.cases.iter().flat_map(|case| case.answer.iter().copied().zip(case.reference.numbers.iter().copied()))
    }

    /// Share of the telling entries that agree with the reference within tolerances.
    pub fn share_within(&self, tolerances: impl Fn(&Reference) -> Vec<f64>) -> f64 {
        let (mut all, mut within) = (0.0, 0.0);
        for case in &self.cases {
            let entries = case.answer.iter().zip(&case.reference.numbers).zip(tolerances(case.reference));
            for ((answer, right), bound) in entries.filter(|((_, right), _)| is_telling(**right)) {
                all += 1.0;
                within += f64::from((answer - right).abs() <= bound);
            }
        }
        if all > 0.0 { within / all } else { 0.0 }
    }
}

impl CaseNumbers<'_> {
    /// Whether an entry tells how precise the answer is.
    pub fn is_telling(&self) -> bool {
        self.reference.numbers.iter().any(|right| is_telling(*right))
    }
}

/// Whether a reference value has so many digits that an answer shows its own precision, in binary form, too.
pub fn is_telling(right: f64) -> bool {
    digits(right).significant >= TELLING && f64::from(right as f32) != right
}
