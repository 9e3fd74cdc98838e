//! The report as Markdown.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::findings::ancestor_lines;
use super::marks::{Marks, cell, plain};
use super::record::{Counts, QuantityResult, Report};
use super::screen::diagnosis_text;
use crate::examination::InvalidOutcome;

impl Report {
    /// The report as Markdown, to read and to paste. Its first 25 lines say what to do.
    pub fn markdown(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = self.write_markdown(&mut text);
        text
    }

    /// The result in one line.
    pub fn summary(&self) -> String {
        if let Some(fault) = &self.program.no_hello {
            return format!("it did not answer hello: {}", plain(fault));
        }
        let mut text = self.counts_text();
        if let (Some(demanded), false) = (self.precision.demanded, self.precision.fewer.is_empty()) {
            let names: Vec<&str> = self.precision.fewer.iter().map(|fewer| fewer.quantity).collect();
            text += &format!(" Fewer than the {demanded} digits demanded: {}.", names.join(", "));
        }
        text
    }

    /// Numbers of quantities that pass, fail and are missing; empty if nothing was asked.
    pub(super) fn counts_text(&self) -> String {
        if self.program.no_hello.is_some() {
            return String::new();
        }
        let count = |word: &str| self.quantities.iter().filter(|row| row.counts.word() == word).count();
        let (pass, fail, missing) = (count("pass") + count(PARTLY), count("**fail**"), count(NOT_IMPLEMENTED));
        let mut text = format!("{pass} quantities pass, {fail} fail, {missing} are not implemented.");
        let partly = self.partly_checked_text();
        if !partly.is_empty() {
            text += &format!(" Partly checked: {partly}.");
        }
        text
    }

    /// What was checked in part, in words; empty if all of it was.
    pub fn partly_checked_text(&self) -> String {
        let mut groups: BTreeMap<(usize, usize), Vec<&str>> = BTreeMap::new();
        for row in &self.partly_checked {
            groups.entry((row.checked, row.of)).or_default().push(row.quantity);
        }
        let group = |((checked, of), quantities): (&(usize, usize), &Vec<&str>)| match &quantities[..] {
            [first, others @ ..] if !others.is_empty() => {
                format!("{checked} of {of} cases of `{first}` and of {} more", others.len())
            }
            all => format!("{checked} of {of} cases of `{}`", all.join(", ")),
        };
        groups.iter().map(group).collect::<Vec<_>>().join("; ")
    }

    fn write_markdown(&self, out: &mut String) -> std::fmt::Result {
        let marks = Marks::Markdown;
        writeln!(out, "## Conformance of {}\n", plain(&self.program.name))?;
        writeln!(out, "{}\n", format!("**{}.** {}", self.marked_headline(marks), self.counts_text()).trim_end())?;
        self.screen(marks).iter().try_for_each(|line| writeln!(out, "- {line}"))?;
        self.write_others(out)?;
        writeln!(
            out,
            "\n| quantity | | right / asked / in the fixture | digits | smallest failing case |\n|---|---|---|---|---|"
        )?;
        for row in self.asked_rows() {
            let (word, digits) = (row.counts.word(), row.counts.digits_text());
            writeln!(out, "| {} | {word} | {} | {digits} | {} |", row.quantity, row.counts_text(), row.example(marks))?;
        }
        writeln!(out, "\n| tag | right | wrong | not implemented | digits |\n|---|---|---|---|---|")?;
        for (tag, counts) in &self.tags {
            let Counts { pass, fail, not_implemented, .. } = counts;
            let tag = plain(tag);
            writeln!(out, "| {tag} | {pass} | {fail} | {not_implemented} | {} |", counts.digits_text())?;
        }
        self.write_invalid(out)?;
        writeln!(out, "\n{}", self.about(marks))
    }

    /// What the numbers mean, and what they come from.
    pub(super) fn about(&self, marks: Marks) -> String {
        let versions: Vec<String> = self
            .fixtures
            .iter()
            .map(|(file, version)| format!("{} {}", marks.plain(file), marks.plain(version)))
            .collect();
        format!(
            "Correct digits are −log₁₀ of the worst error, relative to the size of the terms that are added up. {} questions, {:.1} s, \
             {} start(s). Reference values: {}.",
            self.questions,
            self.seconds,
            self.starts,
            versions.join(", ")
        )
    }

    /// Rows of the quantities that were asked and are implemented.
    pub(super) fn asked_rows(&self) -> impl Iterator<Item = &QuantityResult> {
        let is_asked = |row: &&QuantityResult| row.counts.pass + row.counts.fail > 0 && self.program.no_hello.is_none();
        self.quantities.iter().filter(is_asked)
    }

    /// Wrong quantities behind the first: each with its diagnosis, then those that follow from others.
    fn write_others(&self, out: &mut String) -> std::fmt::Result {
        let first_wrong = self.first_wrong.as_ref().map(|culprit| culprit.blame.quantity);
        for culprit in self.culprits.iter().filter(|culprit| culprit.same_as.is_none()) {
            let mut same: BTreeMap<&str, Vec<String>> = BTreeMap::new();
            for other in self.culprits.iter().filter(|other| other.same_as == Some(culprit.blame.quantity)) {
                if let Some(mistake) = culprit.shared_mistake(other) {
                    same.entry(&mistake.what).or_default().push(format!("`{}`", other.blame.quantity));
                }
            }
            let is_first = Some(culprit.blame.quantity) == first_wrong;
            if !is_first {
                writeln!(out, "\n{}", self.culprit_line(culprit, Marks::Markdown))?;
                writeln!(out, "{}", diagnosis_text(&culprit.diagnosis))?;
                ancestor_lines(&culprit.ancestors, Marks::Markdown)
                    .iter()
                    .try_for_each(|line| writeln!(out, "{line}"))?;
                writeln!(out, "Look at: {}.", culprit.look_at)?;
            } else if !same.is_empty() {
                writeln!(out)?;
            }
            for (what, others) in same {
                writeln!(out, "Also in {}: {}. One cause if they share a function.", others.join(", "), cell(what))?;
            }
        }
        let mut by_input: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for follower in &self.follow {
            by_input.entry(follower.from).or_default().push(follower.quantity);
        }
        let follow: Vec<String> =
            by_input.iter().map(|(input, followers)| format!("{} from {input}", followers.join(", "))).collect();
        if !follow.is_empty() {
            writeln!(out, "\nWhere these mistakes come from: {}.", follow.join("; "))?;
        }
        Ok(())
    }

    fn write_invalid(&self, out: &mut String) -> std::fmt::Result {
        for row in self.invalid.iter().filter(|_| self.program.no_hello.is_none()) {
            let (what, came) = match row.verdict.outcome {
                InvalidOutcome::Accepted => ("Not refused", "it answered a value".into()),
                InvalidOutcome::Fault => {
                    ("Neither refused nor answered", plain(row.verdict.detail.as_deref().unwrap_or_default()))
                }
                InvalidOutcome::Refused | InvalidOutcome::NotImplemented => continue,
            };
            let [id, equation, key] = [&row.case.id, &row.case.equation, &row.case.key].map(|text| cell(text));
            let because = plain(&row.case.because);
            writeln!(out, "\n{what}: `{id}`, asked for {equation}: {came}; `{key}` is invalid: {because}.")?;
        }
        Ok(())
    }
}

impl Counts {
    pub(super) fn word(&self) -> &'static str {
        match (self.fail, self.pass, self.not_implemented) {
            (1.., ..) => "**fail**",
            (0, 1.., 0) => "pass",
            (0, 1.., 1..) => PARTLY,
            (0, 0, 1..) => NOT_IMPLEMENTED,
            (0, 0, 0) => "not asked",
        }
    }

    pub(super) fn digits_text(&self) -> String {
        self.digits.map_or("–".into(), |digits| format!("{digits:.1}"))
    }
}

impl QuantityResult {
    /// Right, asked, and in the fixture.
    pub(super) fn counts_text(&self) -> String {
        let Counts { pass, fail, .. } = self.counts;
        format!("{pass} / {} / {}", pass + fail, self.in_fixture)
    }
}

/// Word for a quantity that passes where it was checked.
const PARTLY: &str = "**partly checked**";
/// Word for a quantity without any answer.
const NOT_IMPLEMENTED: &str = "not implemented";
