//! Answers as evidence of conventions: which quantities are right under which conventions.

use std::collections::BTreeSet;

use super::Conventions;
use super::translation::{Shaped, is_close};
use crate::answers::CaseAnswer;
use crate::graph::GRAPH;
use crate::protocol::Answer;
use crate::suite::Suite;

/// An answer as far as it tells a convention.
#[derive(Clone, Debug)]
pub(super) enum Seen {
    Numbers(Shaped),
    NotImplemented,
    /// An error, or a fault of the program.
    Nothing,
}

/// Answers to one quantity, by index of the case.
pub(super) struct Row {
    pub quantity: &'static str,
    pub cases: Vec<(usize, Seen)>,
}

/// Answers to all quantities.
pub(super) struct Evidence<'a> {
    pub suite: &'a Suite,
    pub rows: Vec<Row>,
}

/// What other conventions change.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Weight {
    /// Quantities that become right in every case.
    pub cured: Vec<&'static str>,
    /// Quantities that become wrong.
    pub spoilt: Vec<&'static str>,
}

impl<'a> Evidence<'a> {
    pub(super) fn new(suite: &'a Suite, answers: &[(&'static str, Vec<CaseAnswer>)]) -> Evidence<'a> {
        let rows = answers.iter().map(|(quantity, cases)| Row {
            quantity,
            cases: cases.iter().map(|(n, answer)| (*n, seen(answer))).collect(),
        });
        Evidence { suite, rows: rows.collect() }
    }

    pub(super) fn row(&self, quantity: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.quantity == quantity)
    }

    /// Replaces the answer in one case.
    pub(super) fn replace(&mut self, quantity: &str, n: usize, answer: &CaseAnswer) {
        let row = self.rows.iter_mut().find(|row| row.quantity == quantity);
        if let Some((_, own)) = row.and_then(|row| row.cases.iter_mut().find(|(case, _)| *case == n)) {
            *own = seen(&answer.1);
        }
    }

    /// Whether one answer is right under these conventions.
    fn is_close(&self, quantity: &str, n: usize, answer: &Seen, conventions: &Conventions) -> bool {
        let Some(case) = self.suite.cases.get(n) else { return false };
        let (Some(reference), Seen::Numbers(answer)) = (case.values.get(quantity), answer) else { return false };
        let numbers = conventions.numbers(quantity, case, reference, answer);
        numbers.is_some_and(|numbers| is_close(&numbers, reference))
    }

    /// Whether one answer, which need not be among the evidence, is right under these conventions.
    pub(super) fn agrees(&self, quantity: &str, answer: &CaseAnswer, conventions: &Conventions) -> bool {
        self.is_close(quantity, answer.0, &seen(&answer.1), conventions)
    }

    /// Whether a quantity is right in every case under these conventions; `None` if it is not implemented.
    pub(super) fn is_right(&self, row: &Row, conventions: &Conventions) -> Option<bool> {
        let mut answered = row.cases.iter().filter(|(_, seen)| !matches!(seen, Seen::NotImplemented)).peekable();
        answered.peek()?;
        Some(answered.all(|(n, seen)| self.is_close(row.quantity, *n, seen, conventions)))
    }

    /// Cases in which a quantity is wrong under these conventions.
    pub(super) fn failing(&self, row: &Row, conventions: &Conventions) -> Vec<usize> {
        let fails = |(n, seen): &&(usize, Seen)| {
            !matches!(seen, Seen::NotImplemented) && !self.is_close(row.quantity, *n, seen, conventions)
        };
        row.cases.iter().filter(fails).map(|(n, _)| *n).collect()
    }

    /// Quantities that are right, and those that are wrong.
    pub(super) fn right_and_wrong(
        &self,
        conventions: &Conventions,
    ) -> (BTreeSet<&'static str>, BTreeSet<&'static str>) {
        let (mut right, mut wrong) = (BTreeSet::new(), BTreeSet::new());
        for row in &self.rows {
            match self.is_right(row, conventions) {
                Some(true) => right.insert(row.quantity),
                Some(false) => wrong.insert(row.quantity),
                None => continue,
            };
        }
        (right, wrong)
    }

    /// What `after` changes in the quantities that are right or wrong before.
    pub(super) fn weigh(
        &self,
        (right, wrong): &(BTreeSet<&'static str>, BTreeSet<&'static str>),
        after: &Conventions,
    ) -> Weight {
        let of = |names: &BTreeSet<&'static str>, wanted: bool| {
            let becomes = |row: &&Row| names.contains(row.quantity) && self.is_right(row, after) == Some(wanted);
            self.rows.iter().filter(becomes).map(|row| row.quantity).collect::<Vec<_>>()
        };
        let spoilt = of(right, false);
        // What spoils an answer is not accepted, whatever it cures.
        let cured = if spoilt.is_empty() { of(wrong, true) } else { Vec::new() };
        Weight { cured, spoilt }
    }

    /// The nearest answered quantities that follow from `quantities`, without these.
    pub(super) fn followers(&self, quantities: &[&'static str]) -> BTreeSet<&'static str> {
        let is_answered = |name: &str| {
            self.row(name).is_some_and(|row| row.cases.iter().any(|(_, seen)| !matches!(seen, Seen::NotImplemented)))
        };
        let (mut found, mut open, mut done) = (BTreeSet::new(), quantities.to_vec(), BTreeSet::new());
        while let Some(quantity) = open.pop() {
            for node in GRAPH.iter().filter(|node| node.inputs().any(|input| input == quantity)) {
                if !done.insert(node.quantity) || quantities.contains(&node.quantity) {
                    continue;
                }
                if is_answered(node.quantity) {
                    found.insert(node.quantity);
                } else {
                    open.push(node.quantity);
                }
            }
        }
        found
    }
}

fn seen(answer: &Result<Answer, crate::verdict::Fault>) -> Seen {
    match answer {
        Ok(Answer::Value(value)) => Shaped::read(value).map_or(Seen::Nothing, Seen::Numbers),
        Ok(Answer::NotImplemented) => Seen::NotImplemented,
        Ok(Answer::Error(_)) | Err(_) => Seen::Nothing,
    }
}
