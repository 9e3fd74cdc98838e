//! The report as Markdown.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::record::{
    Counts, FailingCase, Failure, FewerDigits, LeastAttainable, OtherPrecision, PrecisionResult, QuantityResult, Report,
};
use crate::convention::{Convention, How};
use crate::diagnosis::{Ancestor, Diagnosis};
use crate::examination::InvalidOutcome;
use crate::memory::{ChangedAnswer, EarlierQuestion, Memory};
use crate::protocol::quoted;

impl Report {
    /// The report as Markdown, to read and to paste.
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
        let count = |word: &str| self.quantities.iter().filter(|row| row.counts.word() == word).count();
        let (pass, fail, missing) = (count("pass") + count(PARTLY), count("**fail**"), count("not implemented"));
        let mut text = format!("{pass} quantities pass, {fail} fail, {missing} are not implemented.");
        let partly = self.partly_checked_text();
        if !partly.is_empty() {
            text += &format!(" Partly checked: {partly}.");
        }
        if let Some(digits) = self.quantities.iter().filter_map(|row| row.counts.digits).reduce(f64::min) {
            text += &format!(" At least {digits:.1} correct digits.");
        }
        if let (Some(demanded), false) = (self.precision.demanded, self.precision.fewer.is_empty()) {
            let names: Vec<&str> = self.precision.fewer.iter().map(|fewer| fewer.quantity).collect();
            text += &format!(" Fewer than the {demanded} digits demanded: {}.", names.join(", "));
        }
        let all = self.invalid.len();
        let states = |outcome| self.invalid.iter().filter(|row| row.verdict.outcome == outcome).count();
        match states(InvalidOutcome::Accepted) {
            0 => {}
            n => text += &format!(" {n} of {all} states that must be refused got a value."),
        }
        match states(InvalidOutcome::Fault) {
            0 => {}
            n => text += &format!(" {n} of {all} states that must be refused got no answer."),
        }
        text
    }

    /// What was checked in part, in words; empty if all of it was.
    pub fn partly_checked_text(&self) -> String {
        let mut groups: BTreeMap<(usize, usize), Vec<&str>> = BTreeMap::new();
        for row in &self.partly_checked {
            groups.entry((row.checked, row.of)).or_default().extend(row.quantity);
        }
        let group = |((checked, of), quantities): (&(usize, usize), &Vec<&str>)| match &quantities[..] {
            [] => format!("{checked} of {of} states that must be refused"),
            [one] => format!("{checked} of {of} cases of `{one}`"),
            [first, others @ ..] => format!("{checked} of {of} cases of `{first}` and of {} more", others.len()),
        };
        // Quantities first, then the states that must be refused.
        let (refused, quantities): (Vec<_>, Vec<_>) = groups.iter().partition(|(_, quantities)| quantities.is_empty());
        quantities.into_iter().chain(refused).map(group).collect::<Vec<_>>().join("; ")
    }

    fn write_markdown(&self, out: &mut String) -> std::fmt::Result {
        writeln!(out, "## Conformance of {}\n", plain(&self.program.name))?;
        let precision = self.precision.text();
        if !precision.is_empty() {
            writeln!(out, "{precision}\n")?;
        }
        writeln!(out, "{}\n", self.summary())?;
        self.write_conversation(out)?;
        self.write_memory(out)?;
        self.write_silent(out)?;
        self.write_culprits(out)?;
        writeln!(out, "| quantity | | right / asked | digits | smallest failing case |\n|---|---|---|---|---|")?;
        for row in &self.quantities {
            let Counts { pass, fail, not_implemented, .. } = row.counts;
            let counts = match (pass + fail, not_implemented) {
                (0, _) => "–".into(),
                (asked, 0) => format!("{pass} / {asked}"),
                (asked, missing) => format!("{pass} / {asked} of {}", asked + missing),
            };
            let (word, digits) = (row.counts.word(), row.counts.digits_text());
            writeln!(out, "| {} | {word} | {counts} | {digits} | {} |", row.quantity, row.example())?;
        }
        writeln!(out, "\n| tag | right | wrong | not implemented | digits |\n|---|---|---|---|---|")?;
        for (tag, counts) in &self.tags {
            let Counts { pass, fail, not_implemented, .. } = counts;
            let tag = plain(tag);
            writeln!(out, "| {tag} | {pass} | {fail} | {not_implemented} | {} |", counts.digits_text())?;
        }
        self.write_invalid(out)?;
        let versions: Vec<String> =
            self.fixtures.iter().map(|(file, version)| format!("{} {}", plain(file), plain(version))).collect();
        writeln!(
            out,
            "\nCorrect digits are −log₁₀ of the worst error, relative to the size of the terms that are added up. {} questions, {:.1} s, \
             {} start(s). Reference values: {}.",
            self.questions,
            self.seconds,
            self.starts,
            versions.join(", ")
        )
    }

    /// Faults of the conversation itself.
    fn write_conversation(&self, out: &mut String) -> std::fmt::Result {
        if let Some(fault) = &self.program.no_hello {
            writeln!(
                out,
                "**It did not answer hello: {}.** Nothing was asked. The program must answer each line of JSON on its standard input with \
                 one on its standard output, the first with `{{\"hello\": {{\"name\": \"mine\"}}}}`.\n",
                plain(fault)
            )?;
        }
        if !self.program.unknown.is_empty() {
            let unknown: Vec<String> =
                self.program.unknown.iter().map(|id| format!("`{}`", cell(&quoted(id)))).collect();
            writeln!(
                out,
                "Its hello lists names that are not asked for: {}. Use the names of the table below, letter by letter.\n",
                unknown.join(", ")
            )?;
        }
        if !self.conventions.is_empty() {
            let conventions: Vec<String> = self.conventions.iter().map(convention_text).collect();
            writeln!(out, "Conventions, which are not mistakes: {}.\n", conventions.join("; "))?;
        }
        for error in &self.convention_errors {
            writeln!(out, "In the conventions of its hello: {}.\n", plain(error))?;
        }
        if self.chatter.lines > 0 {
            writeln!(
                out,
                "It printed {} line(s) on standard output that are not JSON, the first: `{}`. They were skipped where an answer followed; \
                 write messages to standard error.\n",
                self.chatter.lines,
                cell(&self.chatter.first)
            )?;
        }
        Ok(())
    }

    /// Answers that depend on what was asked before, and given values that are not read.
    fn write_memory(&self, out: &mut String) -> std::fmt::Result {
        if let Some(memory) = &self.memory {
            writeln!(out, "{}\n", memory_text(memory))?;
        }
        if !self.given_ignored.is_empty() {
            let quantities: Vec<String> = self.given_ignored.iter().map(|name| format!("`{name}`")).collect();
            writeln!(out, "It says it reads `given`, but does not for {}.\n", quantities.join(", "))?;
        }
        Ok(())
    }

    /// Quantities without numbers, by fault.
    fn write_silent(&self, out: &mut String) -> std::fmt::Result {
        let mut by_fault: BTreeMap<Vec<&str>, Vec<&QuantityResult>> = BTreeMap::new();
        for row in self.quantities.iter().filter(|row| self.silent.contains(&row.quantity)) {
            by_fault.entry(row.fault_words.iter().copied().collect()).or_default().push(row);
        }
        let implemented = self.quantities.iter().filter(|row| row.counts.pass + row.counts.fail > 0).count();
        for (faults, rows) in by_fault {
            let names = rows.iter().map(|row| format!("`{}`", row.quantity)).collect::<Vec<_>>().join(", ");
            let (of, pronoun) = match rows.len() {
                1 => (names, "its equation is"),
                n if n == implemented => (format!("any of {n} quantities"), "their equations are"),
                _ => (format!("any of {names}"), "their equations are"),
            };
            let example = rows.first().map(|row| row.example()).unwrap_or_default();
            writeln!(
                out,
                "**It answers no numbers for {of}: {}.** The first: {example}. Whether {pronoun} wrong is unknown.\n",
                faults.join(", ")
            )?;
        }
        Ok(())
    }

    fn write_culprits(&self, out: &mut String) -> std::fmt::Result {
        let first_wrong = self.first_wrong.as_ref().map(|culprit| culprit.blame.quantity);
        for culprit in self.culprits.iter().filter(|culprit| culprit.same_as.is_none()) {
            let which = match culprit.blame.numbers {
                true if first_wrong == Some(culprit.blame.quantity) => "First wrong equation",
                true => "Also wrong by itself",
                false => "No wrong number, but none in some cases",
            };
            let because = capitalised(&culprit.blame.because);
            let before = if culprit.ancestors.is_empty() { "" } else { " or one before it" };
            writeln!(out, "**{which}: ({}){before}, `{}`.** {because}.", culprit.equation, culprit.blame.quantity)?;
            writeln!(out, "{}", diagnosis_text(&culprit.diagnosis))?;
            write_ancestors(out, &culprit.ancestors)?;
            let mut same: BTreeMap<&str, Vec<String>> = BTreeMap::new();
            for other in self.culprits.iter().filter(|other| other.same_as == Some(culprit.blame.quantity)) {
                if let Some(mistake) = culprit.shared_mistake(other) {
                    same.entry(&mistake.what).or_default().push(format!("`{}`", other.blame.quantity));
                }
            }
            for (what, others) in same {
                writeln!(out, "Also in {}: {}. One cause if they share a function.", others.join(", "), cell(what))?;
            }
            writeln!(out)?;
        }
        let mut by_input: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for follower in &self.follow {
            by_input.entry(follower.from).or_default().push(follower.quantity);
        }
        let follow: Vec<String> =
            by_input.iter().map(|(input, followers)| format!("{} from {input}", followers.join(", "))).collect();
        if !follow.is_empty() {
            writeln!(out, "Wrong, but so are their inputs: {}.\n", follow.join("; "))?;
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

impl PrecisionResult {
    /// The precision in words; empty in double precision if no digits are demanded.
    pub fn text(&self) -> String {
        let mut sentences = Vec::new();
        if let Some(least) = &self.least_attainable {
            let attained = |digits: Option<f64>| digits.map_or("no".into(), |digits| format!("{digits:.1}"));
            let by = if self.by_errors { ", as the size of its errors shows" } else { "" };
            sentences.push(format!(
                "**{}**{by}: right answers have {} correct digits at least, {} in the median.",
                capitalised(&self.kind),
                attained(self.least_digits),
                attained(self.median_digits)
            ));
            for OtherPrecision { kind, quantities } in &self.others {
                let names: Vec<String> = quantities.iter().map(|quantity| format!("`{quantity}`")).collect();
                sentences.push(format!("{}: {}.", capitalised(kind), names.join(", ")));
            }
            let LeastAttainable { quantity, case, digits, because } = least;
            sentences.push(format!(
                "The least can be attained in `{quantity}`, `{}`: {digits:.1} digits ({because}).",
                cell(case)
            ));
        }
        match self.invisible.len() {
            0 => {}
            n => sentences.push(format!("{n} known mistakes are invisible at this precision.")),
        }
        if let (Some(demanded), Some(worst)) = (self.demanded, self.fewest()) {
            let FewerDigits { quantity, case, digits } = worst;
            sentences.push(format!(
                "{} quantities have fewer than the {demanded} digits that are demanded, `{quantity}` the fewest: {digits:.1} in `{}`.",
                self.fewer.len(),
                cell(case)
            ));
        }
        sentences.join(" ")
    }

    /// Quantity with the fewest digits of those that have fewer than demanded.
    fn fewest(&self) -> Option<&FewerDigits> {
        self.fewer.iter().min_by(|a, b| a.digits.total_cmp(&b.digits))
    }
}

impl Counts {
    fn word(&self) -> &'static str {
        match (self.fail, self.pass, self.not_implemented) {
            (1.., ..) => "**fail**",
            (0, 1.., 0) => "pass",
            (0, 1.., 1..) => PARTLY,
            (0, 0, _) => "not implemented",
        }
    }

    fn digits_text(&self) -> String {
        self.digits.map_or("–".into(), |digits| format!("{digits:.1}"))
    }
}

impl QuantityResult {
    /// The smallest failing case; empty if none fails.
    fn example(&self) -> String {
        let text = |FailingCase { case, failure, .. }: &FailingCase| match failure {
            Failure::Wrong { answered, expected, .. } => {
                format!("`{}`: {answered:e}, expected {expected:e}", cell(case))
            }
            Failure::Fault { fault } => format!("`{}`: {}", cell(case), plain(fault)),
        };
        self.smallest_failing.as_ref().map(text).unwrap_or_default()
    }
}

/// Evidence of memory in sentences.
fn memory_text(memory: &Memory) -> String {
    let mut sentences =
        vec![match memory.random {
        true => "**Your answers differ although the question is equal: random numbers, or memory that was never set.**",
        false => "**Your answers depend on what was asked before.**",
    }
    .to_string()];
    if let Some(change) = memory.changed.first() {
        let ChangedAnswer { quantity, first_answer, second_answer, second_is_right, again, .. } = change;
        let [case, first, second] = [&change.case, first_answer, second_answer].map(|text| cell(text));
        let right = if *second_is_right { ", which is right" } else { "" };
        sentences.push(format!("`{quantity}` in `{case}`: {first} at first, {second} {}{right}.", again.words()));
    }
    if let Some(EarlierQuestion { quantity, case, questions_before, exact }) = &memory.after {
        let case = cell(case);
        sentences.push(match (*questions_before, exact) {
            (1, _) => format!("It goes wrong just after `{quantity}` in `{case}`."),
            (n, true) => format!("It goes wrong from `{quantity}` in `{case}` on, {n} questions before."),
            (n, false) => format!("It goes wrong within {n} questions, from `{quantity}` in `{case}` on."),
        });
    }
    if !memory.quantities.is_empty() {
        let quantities: Vec<String> = memory.quantities.iter().map(|name| format!("`{name}`")).collect();
        sentences.push(format!("No equation is blamed for {}.", quantities.join(", ")));
    }
    sentences.push("Look for static variables, caches and buffers that are not cleared.".into());
    sentences.join(" ")
}

/// Earlier quantities that the mistake may be in, a line for each with evidence.
fn write_ancestors(out: &mut String, ancestors: &[Ancestor]) -> std::fmt::Result {
    let (fitting, others): (Vec<&Ancestor>, Vec<&Ancestor>) =
        ancestors.iter().partition(|ancestor| !ancestor.mistakes.is_empty());
    for Ancestor { quantity, equation, mistakes, speaks } in fitting {
        let mistakes = mistakes.iter().map(|mistake| format!("{} ({})", mistake.kind.word(), cell(&mistake.what)));
        let mistakes = mistakes.collect::<Vec<_>>().join("; or ");
        writeln!(out, "\n- ({equation}), `{quantity}`, which is not answered: {mistakes} {speaks}.")?;
    }
    let mut by_evidence: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for Ancestor { quantity, speaks, .. } in others {
        by_evidence.entry(speaks).or_default().push(format!("`{quantity}`"));
    }
    for (speaks, quantities) in by_evidence {
        writeln!(out, "\n- {}: {speaks}.", quantities.join(", "))?;
    }
    Ok(())
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

/// A diagnosis in sentences.
fn diagnosis_text(diagnosis: &Diagnosis) -> String {
    let mut sentences = Vec::new();
    let Diagnosis { failing, without_numbers, .. } = diagnosis;
    let silent: usize = without_numbers.values().sum();
    let faults = without_numbers.iter().map(|(word, n)| format!("{word} in {n}")).collect::<Vec<_>>().join(", ");
    if silent > 0 && silent == *failing {
        sentences.push(format!("It answers no numbers in any of {silent} failing case(s): {faults}."));
    } else if silent > 0 {
        sentences.push(format!("It answers no numbers in {silent} of {failing} failing cases: {faults}."));
    }
    let mistakes: Vec<String> = (diagnosis.mistakes.iter())
        .map(|mistake| format!("{} ({})", mistake.kind.word(), cell(&mistake.what)))
        .collect();
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

/// Word for a quantity that passes where it was checked.
const PARTLY: &str = "**partly checked**";

/// Text that stays within a cell of a table, or within a span of code there. Neither a terminal nor a browser obeys it.
fn cell(text: &str) -> String {
    let is_command = |c: char| {
        c.is_control() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    text.replace('|', "\\|").replace('`', "'").replace(is_command, " ")
}

/// Text outside of a span of code, where HTML and links have a meaning, too.
fn plain(text: &str) -> String {
    cell(text).replace('&', "&amp;").replace('<', "&lt;").replace('[', "\\[")
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_name_stays_in_its_cell_and_line() {
        assert_eq!(super::cell("a|b\n# `c`"), "a\\|b # 'c'");
        assert_eq!(super::plain("\u{1b}[2J<img src=x>\u{202e}&"), " \\[2J&lt;img src=x> &amp;");
    }
}
