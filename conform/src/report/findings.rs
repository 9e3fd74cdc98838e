//! What was found beside wrong equations: precision, conventions, memory, and earlier quantities that may be wrong.

use std::collections::BTreeMap;

use super::marks::Marks;
use super::record::{FewerDigits, LeastAttainable, OtherPrecision, PrecisionResult, Report};
use super::words::{capitalised, listed};
use crate::convention::{Convention, How};
use crate::diagnosis::Ancestor;
use crate::memory::{ChangedAnswer, EarlierQuestion, Memory};

impl PrecisionResult {
    /// The precision in a line.
    pub(super) fn line(&self, marks: Marks) -> String {
        let by = if self.by_errors { ", as the size of its errors shows" } else { "" };
        let attained = match (self.least_digits, self.median_digits) {
            (Some(least), Some(median)) => {
                format!("right answers have at least {least:.1} correct digits, {median:.1} in the median")
            }
            _ => "no answer is right".into(),
        };
        let mut sentences = vec![format!("{}{by}: {attained}.", marks.strong(&capitalised(&self.kind)))];
        for OtherPrecision { kind, quantities } in &self.others {
            sentences.push(format!("{}: {}.", capitalised(kind), listed(&codes(quantities, marks))));
        }
        if let Some(LeastAttainable { quantity, case, digits, because }) = &self.least_attainable {
            let [quantity, case] = [*quantity, case.as_str()].map(|name| marks.code(name));
            sentences.push(format!("The least can be attained in {quantity}, {case}: {digits:.1} digits ({because})."));
        }
        match self.invisible.len() {
            0 => {}
            n => sentences.push(format!("{n} known mistakes are invisible at this precision.")),
        }
        if let (Some(demanded), Some(worst)) = (self.demanded, self.fewest()) {
            let FewerDigits { quantity, case, digits } = worst;
            sentences.push(format!(
                "{} quantities have fewer than the {demanded} digits that are demanded, {} the fewest: {digits:.1} in {}.",
                self.fewer.len(),
                marks.code(quantity),
                marks.code(case)
            ));
        }
        sentences.join(" ")
    }

    /// Quantity with the fewest digits of those that have fewer than demanded.
    fn fewest(&self) -> Option<&FewerDigits> {
        self.fewer.iter().min_by(|a, b| a.digits.total_cmp(&b.digits))
    }
}

impl Report {
    /// Conventions of the program, and what is wrong with those that it declares.
    pub(super) fn convention_lines(&self, marks: Marks) -> Vec<String> {
        let conventions: Vec<String> = self.conventions.iter().map(convention_text).collect();
        let named = format!("Conventions, which are not mistakes: {}.", marks.plain(&conventions.join("; ")));
        let errors = self.convention_errors.iter().map(|error| format!("In its hello: {}.", marks.plain(error)));
        (!conventions.is_empty()).then_some(named).into_iter().chain(errors).collect()
    }

    /// Answers that depend on what was asked before, and given values that are not read.
    pub(super) fn memory_lines(&self, marks: Marks) -> Vec<String> {
        let mut lines: Vec<String> = self.memory.iter().map(|memory| memory_text(memory, marks)).collect();
        if !self.given_ignored.is_empty() {
            let quantities = listed(&codes(&self.given_ignored, marks));
            lines.push(format!("It says it reads {}, but does not for {quantities}.", marks.code("given")));
        }
        lines
    }
}

/// Earlier quantities that a mistake may be in: a line for each with a mistake that fits, and one for all others.
pub(super) fn ancestor_lines(ancestors: &[Ancestor], marks: Marks) -> Vec<String> {
    let (fitting, others): (Vec<&Ancestor>, Vec<&Ancestor>) =
        ancestors.iter().partition(|ancestor| !ancestor.mistakes.is_empty());
    let line = |Ancestor { quantity, equation, mistakes, speaks }: &Ancestor| {
        let mistakes = mistakes.iter().map(|mistake| format!("{} ({})", mistake.kind.word(), mistake.what));
        let mistakes = marks.plain(&mistakes.collect::<Vec<_>>().join("; or "));
        format!("Before it, not answered: ({equation}), {}: {mistakes} {speaks}.", marks.code(quantity))
    };
    let mut lines: Vec<String> = fitting.into_iter().map(line).collect();
    let mut by_evidence: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for Ancestor { quantity, speaks, .. } in others {
        by_evidence.entry(speaks).or_default().push(quantity);
    }
    lines.extend(by_evidence.iter().map(|(speaks, names)| format!("{}: {speaks}.", listed(&codes(names, marks)))));
    lines
}

fn codes(names: &[&str], marks: Marks) -> Vec<String> {
    names.iter().map(|name| marks.code(name)).collect()
}

/// Evidence of memory in sentences.
fn memory_text(memory: &Memory, marks: Marks) -> String {
    let what = match memory.random {
        true => "Your answers differ although the question is equal: random numbers, or memory that was never set.",
        false => "Your answers depend on what was asked before.",
    };
    let mut sentences = vec![marks.strong(what)];
    if let Some(change) = memory.changed.first() {
        let ChangedAnswer { quantity, case, first_answer, second_answer, second_is_right, again } = change;
        let [first, second] = [first_answer, second_answer].map(|text| marks.plain(text));
        let right = if *second_is_right { ", which is right" } else { "" };
        let [quantity, case] = [*quantity, case.as_str()].map(|name| marks.code(name));
        sentences.push(format!("{quantity} in {case}: {first} at first, {second} {}{right}.", again.words()));
    }
    if let Some(EarlierQuestion { quantity, case, questions_before, exact }) = &memory.after {
        let [quantity, case] = [*quantity, case.as_str()].map(|name| marks.code(name));
        sentences.push(match (*questions_before, exact) {
            (1, _) => format!("It goes wrong just after {quantity} in {case}."),
            (n, true) => format!("It goes wrong from {quantity} in {case} on, {n} questions before."),
            (n, false) => format!("It goes wrong within {n} questions, from {quantity} in {case} on."),
        });
    }
    if !memory.quantities.is_empty() {
        sentences.push(format!("No equation is blamed for {}.", listed(&codes(&memory.quantities, marks))));
    }
    sentences.push("Look for static variables, caches and buffers that are not cleared.".into());
    sentences.join(" ")
}

/// A convention with its evidence.
fn convention_text(Convention { words, how, evidence, ambiguous_with, .. }: &Convention) -> String {
    let known = match how {
        How::Declared => "declared".into(),
        How::Inferred => format!("inferred: {evidence}"),
    };
    let ambiguous = match &ambiguous_with[..] {
        [] => String::new(),
        [one] => format!("; cannot be told from: {one}"),
        [first, others @ ..] => format!("; cannot be told from: {first}, and {} more", others.len()),
    };
    format!("{words} ({known}{ambiguous})")
}
