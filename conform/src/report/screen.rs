//! The first screen: what a reader can act on, at most 25 lines.

use std::collections::{BTreeMap, BTreeSet};

use super::findings::ancestor_lines;
use super::marks::Marks;
use super::record::{Conclusion, CulpritResult, FailingCase, Failure, QuantityResult, RefusalVerdict, Report};
use super::words::{capitalised, exact, listed, short};
use crate::diagnosis::Diagnosis;
use crate::quotation::quoted;

/// Largest number of groups of quantities without numbers that are listed.
const MOST_FAULTS: usize = 3;
/// Largest number of lines about earlier quantities.
const MOST_ANCESTORS: usize = 4;
/// Largest number of troubles with the form of answers that are listed.
const MOST_REMARKS: usize = 4;

impl Report {
    /// The verdict in a few words.
    pub fn headline(&self) -> String {
        self.marked_headline(Marks::None)
    }

    pub(super) fn marked_headline(&self, marks: Marks) -> String {
        let refuses = match self.refusal.verdict {
            RefusalVerdict::ShouldRefuse => {
                format!(
                    "; should refuse {} of {} invalid states",
                    self.refusal.accepted + self.refusal.no_answer,
                    self.refusal.of
                )
            }
            RefusalVerdict::Acceptable | RefusalVerdict::NotAsked => String::new(),
        };
        let part = if self.asked_in_part { ", asked in part by your choice" } else { "" };
        match (self.verdict, &self.first_wrong) {
            (Conclusion::NoAnswer, _) => "No answer to hello".into(),
            (Conclusion::NothingChecked, _) => {
                format!("Nothing checked: it implements nothing of what was asked{part}")
            }
            (Conclusion::Wrong, Some(culprit)) if culprit.blame.numbers => {
                let before = if culprit.ancestors.is_empty() { "" } else { ", or one before it," };
                let quantity = marks.code(culprit.blame.quantity);
                format!("Wrong: ({}), {quantity}{before} first{part}{refuses}", culprit.equation)
            }
            (Conclusion::Wrong, None) if self.memory.is_some() => {
                format!("Not right: answers depend on what was asked before{part}{refuses}")
            }
            (Conclusion::Wrong, None) if !self.precision.fewer.is_empty() => {
                format!("Not right: fewer digits than demanded{part}{refuses}")
            }
            (Conclusion::Wrong, _) => format!("Not right: numbers are missing{part}{refuses}"),
            (Conclusion::PartlyChecked, _) => {
                format!("Partly checked: {}{part}{refuses}", self.what_is_left_out(marks))
            }
            (Conclusion::Right, _) => format!("Right{part}{refuses}"),
        }
    }

    /// What a program that is partly checked leaves out.
    fn what_is_left_out(&self, marks: Marks) -> String {
        let tags: Vec<String> = self.left_out.iter().map(|tag| marks.code(tag)).collect();
        match &tags[..] {
            [] => "right where it answers, but it leaves out some states".into(),
            tags => format!("right where it answers, but it leaves out every state tagged {}", listed(tags)),
        }
    }

    /// Lines of the first screen below its headline.
    pub(super) fn screen(&self, marks: Marks) -> Vec<String> {
        let mut lines = Vec::new();
        lines.extend(self.hello_lines(marks));
        if self.quantities.iter().any(|row| row.counts.digits.is_some()) {
            lines.push(self.precision.line(marks));
        }
        lines.extend(self.convention_lines(marks));
        lines.extend(self.memory_lines(marks));
        lines.extend(self.silent_lines(marks));
        lines.extend(self.first_wrong_lines(marks));
        lines.extend(self.others_line(marks));
        lines.extend(self.refusal_line());
        lines.extend(self.form_lines(marks));
        lines.extend(self.not_implemented_line(marks));
        lines
    }

    /// What is wrong with the answer to hello.
    fn hello_lines(&self, marks: Marks) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(fault) = &self.program.no_hello {
            lines.push(format!(
                "{} Nothing was asked. The program must answer each line of JSON on its standard input with one on its standard output, \
                 the first with {}, and flush its output.",
                marks.strong(&format!("It did not answer hello: {}.", marks.plain(fault))),
                marks.code(r#"{"hello": {"name": "mine"}}"#)
            ));
        }
        if !self.program.unknown.is_empty() {
            let unknown: Vec<String> = self.program.unknown.iter().map(|id| marks.code(&quoted(id))).collect();
            lines.push(format!(
                "Its hello lists names that are not asked for: {}. Use the names of the fixtures, letter by letter.",
                listed(&unknown)
            ));
        }
        lines
    }

    /// Quantities without numbers, by fault.
    fn silent_lines(&self, marks: Marks) -> Vec<String> {
        let mut by_fault: BTreeMap<Vec<&str>, Vec<&QuantityResult>> = BTreeMap::new();
        let silent = |row: &&QuantityResult| self.silent.contains(&row.quantity) && self.program.no_hello.is_none();
        for row in self.quantities.iter().filter(silent) {
            by_fault.entry(row.fault_words.iter().copied().collect()).or_default().push(row);
        }
        let implemented = self.quantities.iter().filter(|row| row.counts.pass + row.counts.fail > 0).count();
        let line = |(faults, rows): (Vec<&str>, Vec<&QuantityResult>)| {
            let names: Vec<String> = rows.iter().map(|row| marks.code(row.quantity)).collect();
            let (of, pronoun) = match rows.len() {
                1 => (listed(&names), "its equation is"),
                n if n == implemented => (format!("any of {n} quantities"), "their equations are"),
                _ => (format!("any of {}", listed(&names)), "their equations are"),
            };
            let example = rows.first().map(|row| row.example(marks)).unwrap_or_default();
            format!(
                "{} The first: {example}. Whether {pronoun} wrong is unknown.",
                marks.strong(&format!("It answers no numbers for {of}: {}.", faults.join(", ")))
            )
        };
        by_fault.into_iter().take(MOST_FAULTS).map(line).collect()
    }

    /// The first wrong equation: which, why, what kind of mistake, evidence, and what to look at.
    fn first_wrong_lines(&self, marks: Marks) -> Vec<String> {
        let Some(culprit) = &self.first_wrong else { return Vec::new() };
        let mut lines = vec![self.culprit_line(culprit, marks)];
        lines.push(diagnosis_text(&culprit.diagnosis));
        lines.extend(ancestor_lines(&culprit.ancestors, marks).into_iter().take(MOST_ANCESTORS));
        if let Some(row) = self.quantities.iter().find(|row| row.quantity == culprit.blame.quantity) {
            lines.extend(row.smallest_failing.as_ref().map(|case| evidence(case, row, marks)));
        }
        lines.push(format!("Look at: {}.", culprit.look_at));
        lines
    }

    /// Which equation is wrong, and why it is the one.
    pub(super) fn culprit_line(&self, culprit: &CulpritResult, marks: Marks) -> String {
        let first = self.first_wrong.as_ref().map(|first| first.blame.quantity);
        let which = match culprit.blame.numbers {
            true if first == Some(culprit.blame.quantity) => "First wrong equation",
            true => "Also wrong by itself",
            false => "No wrong number, but none in some cases",
        };
        let before = if culprit.ancestors.is_empty() { "" } else { " or one before it" };
        let what = format!("{which}: ({}){before}, {}.", culprit.equation, marks.code(culprit.blame.quantity));
        format!("{} {}.", marks.strong(&what), capitalised(&culprit.blame.because))
    }

    /// Other wrong quantities.
    fn others_line(&self, marks: Marks) -> Option<String> {
        let first = self.first_wrong.as_ref().map(|first| first.blame.quantity);
        let others = self.culprits.iter().map(|culprit| culprit.blame.quantity).filter(|name| Some(*name) != first);
        let names =
            |names: &mut dyn Iterator<Item = &'static str>| names.map(|name| marks.code(name)).collect::<Vec<_>>();
        let (others, follow) = (names(&mut others.into_iter()), names(&mut self.follow.iter().map(|row| row.quantity)));
        let parts = [("Also wrong by themselves", others), ("Wrong, but so are their inputs", follow)];
        let parts: Vec<String> = parts
            .iter()
            .filter(|(_, names)| !names.is_empty())
            .map(|(what, names)| format!("{what}: {}.", listed(names)))
            .collect();
        (!parts.is_empty()).then(|| parts.join(" "))
    }

    /// Whether invalid states are refused.
    fn refusal_line(&self) -> Option<String> {
        let refusal = &self.refusal;
        let count = |n: usize, what: &str| match n {
            0 => String::new(),
            n => format!(" {n} of {} states that must be refused got {what}.", refusal.of),
        };
        match refusal.verdict {
            RefusalVerdict::NotAsked => None,
            RefusalVerdict::Acceptable => Some(format!("Invalid states: acceptable. {} refused.", refusal.refused)),
            RefusalVerdict::ShouldRefuse => Some(format!(
                "Invalid states: should refuse.{}{}",
                count(refusal.accepted, "a value"),
                count(refusal.no_answer, "no answer")
            )),
        }
    }

    /// Troubles with the form of answers, and what to do about them.
    fn form_lines(&self, marks: Marks) -> Vec<String> {
        let mut lines = Vec::new();
        if self.chatter.lines > 0 {
            lines.push(format!(
                "It printed {} line(s) on standard output that are not JSON, the first: {}. They were skipped where an answer followed; \
                 write messages to standard error.",
                self.chatter.lines,
                marks.code(&self.chatter.first)
            ));
        }
        for remark in self.remarks.iter().take(MOST_REMARKS) {
            let line = format!(
                "Form: {}, {} time(s), the first: {}. {}.",
                remark.trouble.what(),
                remark.lines,
                marks.code(&remark.first),
                remark.trouble.advice()
            );
            lines.push(if marks == Marks::Markdown { line } else { line.replace('`', "") });
        }
        if self.remarks.len() > MOST_REMARKS {
            lines.push(format!(
                "Form: {} more troubles, under `remarks` in conformance.json.",
                self.remarks.len() - MOST_REMARKS
            ));
        }
        lines
    }

    /// Quantities that the program does not have: whole equations by their number, others by name.
    fn not_implemented_line(&self, marks: Marks) -> Option<String> {
        let missing = |row: &&QuantityResult| row.counts.pass + row.counts.fail == 0 && row.counts.not_implemented > 0;
        let count = self.quantities.iter().filter(missing).count();
        if count == 0 || self.verdict == Conclusion::NothingChecked {
            return None;
        }
        let there: BTreeSet<&str> =
            self.quantities.iter().filter(|row| !missing(row)).map(|row| row.equation).collect();
        let mut names: Vec<String> = Vec::new();
        for row in self.quantities.iter().filter(missing) {
            let name = match there.contains(row.equation) {
                true => marks.code(row.quantity),
                false => format!("({})", row.equation),
            };
            if !names.contains(&name) {
                names.push(name);
            }
        }
        Some(format!("Not implemented: {count} quantities: {}.", names.join(", ")))
    }
}

/// The smallest failing case as evidence.
fn evidence(case: &FailingCase, row: &QuantityResult, marks: Marks) -> String {
    let failing = format!("{} of {} states", row.counts.fail, row.counts.fail + row.counts.pass);
    let state = marks.code(&case.case);
    match &case.failure {
        Failure::Fault { fault } => format!("Evidence: state {state}: {}. So in {failing}.", marks.plain(fault)),
        Failure::Wrong { index, answered, expected, .. } => {
            let place: String = index.iter().map(|n| format!("[{n}]")).collect();
            let entry = if place.is_empty() { String::new() } else { format!(", entry {}", marks.code(&place)) };
            let ratio = answered / expected;
            let ratio = if ratio.is_finite() { format!(", ratio {}", short(ratio)) } else { String::new() };
            format!(
                "Evidence: state {state}{entry}: {}, expected {}{ratio}. Wrong in {failing}.",
                exact(*answered),
                exact(*expected)
            )
        }
    }
}

/// A diagnosis in sentences.
pub fn diagnosis_text(diagnosis: &Diagnosis) -> String {
    let mut sentences = Vec::new();
    let Diagnosis { failing, without_numbers, .. } = diagnosis;
    let silent: usize = without_numbers.values().sum();
    let faults = without_numbers.iter().map(|(word, n)| format!("{word} in {n}")).collect::<Vec<_>>().join(", ");
    if silent > 0 && silent == *failing {
        sentences.push(format!("It answers no numbers in any of {silent} failing case(s): {faults}."));
    } else if silent > 0 {
        sentences.push(format!("It answers no numbers in {silent} of {failing} failing cases: {faults}."));
    }
    let mistakes: Vec<String> =
        (diagnosis.mistakes.iter()).map(|mistake| format!("{} ({})", mistake.kind.word(), mistake.what)).collect();
    if !mistakes.is_empty() {
        let (how, between) =
            if diagnosis.together { ("Explained by two mistakes", "; and ") } else { ("Explained by", "; or ") };
        sentences.push(format!("{how}: {}.", mistakes.join(between)));
    } else if silent < *failing {
        sentences.push("No known mistake gives these answers.".into());
    }
    if !diagnosis.entries.is_empty() {
        sentences.push(format!("Wrong entries: {}.", diagnosis.entries.join(", ")));
    }
    if !diagnosis.only_where.is_empty() {
        sentences.push(format!("Only in states tagged {}.", diagnosis.only_where.join(", ")));
    }
    sentences.join(" ")
}

impl QuantityResult {
    /// The smallest failing case; empty if none fails.
    pub(super) fn example(&self, marks: Marks) -> String {
        let text = |FailingCase { case, failure, .. }: &FailingCase| match failure {
            Failure::Wrong { answered, expected, .. } => {
                format!("{}: {}, expected {}", marks.code(case), exact(*answered), exact(*expected))
            }
            Failure::Fault { fault } => format!("{}: {}", marks.code(case), marks.plain(fault)),
        };
        self.smallest_failing.as_ref().map(text).unwrap_or_default()
    }
}
