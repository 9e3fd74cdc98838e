//! The report to read and to paste.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::rows::{Row, by_tag, of_quantity, smallest};
use crate::diagnosis::Finding;
use crate::examination::{Examination, Refusal};
use crate::graph::equation;
use crate::protocol::{Hello, quoted};
use crate::suite::Suite;
use crate::verdict::{Fault, Verdict};

/// The report to read.
pub fn markdown(suite: &Suite, examination: &Examination) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_markdown(&mut text, suite, examination);
    text
}

fn write_markdown(out: &mut String, suite: &Suite, examination: &Examination) -> std::fmt::Result {
    let versions: Vec<String> = suite.versions.iter().map(|(file, version)| format!("{file} {version}")).collect();
    writeln!(out, "## Conformance of {}\n", cell(examination.name()))?;
    writeln!(out, "{}\n", summary(examination))?;
    write_conversation(out, examination)?;
    write_blame(out, suite, examination)?;
    writeln!(out, "| quantity | | right / asked | digits | smallest failing case |\n|---|---|---|---|---|")?;
    for (quantity, cases) in &examination.verdicts {
        let row = of_quantity(cases);
        let told = smallest(suite, cases).map(|(n, verdict)| failing(suite, *n, verdict)).unwrap_or_default();
        let digits = row.digits.map_or("–".into(), |digits| format!("{digits:.1}"));
        let asked = row.pass + row.fail;
        let counts = if asked == 0 { "–".into() } else { format!("{} / {asked}", row.pass) };
        writeln!(out, "| {quantity} | {} | {counts} | {digits} | {told} |", row.word())?;
    }
    writeln!(out, "\n| tag | right | wrong | not implemented | digits |\n|---|---|---|---|---|")?;
    for (tag, row) in by_tag(suite, examination) {
        let digits = row.digits.map_or("–".into(), |digits| format!("{digits:.1}"));
        writeln!(out, "| {tag} | {} | {} | {} | {digits} |", row.pass, row.fail, row.not_implemented)?;
    }
    write_refusals(out, suite, examination)?;
    writeln!(
        out,
        "\nCorrect digits are −log₁₀ of the worst error over the size of the terms that are added up. {} questions, {:.1} s, started {} \
         time(s). Values: {}.",
        examination.questions,
        examination.seconds,
        examination.starts,
        versions.join(", ")
    )
}

/// One line on all of it.
pub fn summary(examination: &Examination) -> String {
    if let Err(fault) = &examination.hello {
        return format!("it did not answer hello: {fault}");
    }
    let rows: Vec<Row> = examination.verdicts.iter().map(|(_, cases)| of_quantity(cases)).collect();
    let count = |word: &str| rows.iter().filter(|row| row.word() == word).count();
    let (pass, fail, left) = (count("pass"), count("**fail**"), count("not implemented"));
    let least = |least: Option<f64>, digits: f64| Some(least.map_or(digits, |least| least.min(digits)));
    let digits = rows.iter().filter_map(|row| row.digits).fold(None, least);
    let digits = digits.map_or(String::new(), |digits| format!(" At least {digits:.1} correct digits."));
    let refusals = || examination.refusals.iter().map(|(_, refusal)| refusal);
    let all = examination.refusals.len();
    let accepted = match refusals().filter(|refusal| matches!(refusal, Refusal::Accepted)).count() {
        0 => String::new(),
        n => format!(" Of {all} states that have to be refused {n} got a value."),
    };
    let silent = match refusals().filter(|refusal| matches!(refusal, Refusal::Fault(_))).count() {
        0 => String::new(),
        n => format!(" In {n} of {all} states that have to be refused it gave no answer."),
    };
    format!("{pass} quantities pass, {fail} fail, {left} are not implemented.{digits}{accepted}{silent}")
}

/// What was wrong with the conversation itself.
fn write_conversation(out: &mut String, examination: &Examination) -> std::fmt::Result {
    if let Err(fault) = &examination.hello {
        writeln!(
            out,
            "**It did not answer hello: {}.** So it was not asked anything. It has to answer each line of JSON on its standard input \
             with one on its standard output, the first one with `{{\"hello\": {{\"name\": \"mine\"}}}}`.\n",
            cell(&fault.to_string())
        )?;
    }
    let unknown: Vec<String> =
        examination.hello.iter().flat_map(Hello::unknown).map(|id| format!("`{}`", cell(&quoted(id)))).collect();
    if !unknown.is_empty() {
        writeln!(
            out,
            "Its hello lists what is not asked for: {}. Names are those of the table below, letter by letter.\n",
            unknown.join(", ")
        )?;
    }
    let chatter = &examination.chatter;
    if chatter.lines > 0 {
        writeln!(
            out,
            "It printed {} line(s) on its standard output that are no JSON, the first: `{}`. Where an answer followed they were \
             passed over; messages belong on standard error.\n",
            chatter.lines,
            cell(&chatter.first)
        )?;
    }
    Ok(())
}

/// Quantities without numbers, by what came in their place.
fn write_silent(out: &mut String, suite: &Suite, examination: &Examination) -> std::fmt::Result {
    let mut by_words: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for (quantity, cases) in examination.verdicts.iter().filter(|(name, _)| examination.blame.silent.contains(name)) {
        by_words.entry(fault_words(cases)).or_default().push(quantity);
    }
    for (words, quantities) in by_words {
        let first = examination.verdicts.iter().find(|(quantity, _)| quantities.first() == Some(quantity));
        let example = first.and_then(|(_, cases)| smallest(suite, cases));
        let example = example.map(|(n, verdict)| failing(suite, *n, verdict)).unwrap_or_default();
        let named: Vec<String> = quantities.iter().map(|quantity| format!("`{quantity}`")).collect();
        let (of, pronoun) = match quantities.len() {
            1 => (named.join(", "), "its equation is"),
            n if n == examination.implemented() => (format!("any of {n} quantities"), "their equations are"),
            _ => (format!("any of {}", named.join(", ")), "their equations are"),
        };
        writeln!(
            out,
            "**It answers no numbers for {of}: {words}.** The first: {example}. Whether {pronoun} wrong is not known.\n"
        )?;
    }
    Ok(())
}

/// What came in place of numbers; that it was not asked for any more says something only where it is all.
fn fault_words(cases: &[(usize, Verdict)]) -> String {
    let faults = cases.iter().filter_map(|(_, verdict)| match verdict {
        Verdict::Fault(fault) => Some(fault),
        _ => None,
    });
    let (unasked, came): (Vec<&Fault>, Vec<&Fault>) = faults.partition(|fault| matches!(fault, Fault::NotAsked(_)));
    let told = if came.is_empty() { unasked } else { came };
    let words: BTreeSet<&str> = told.into_iter().map(Fault::word).collect();
    Vec::from_iter(words).join(", ")
}

fn write_blame(out: &mut String, suite: &Suite, examination: &Examination) -> std::fmt::Result {
    let alike = examination.alike();
    write_silent(out, suite, examination)?;
    let first_wrong = examination.blame.first_wrong();
    for (n, culprit) in examination.blame.culprits.iter().enumerate() {
        if alike.contains_key(culprit.quantity) {
            continue;
        }
        let which = match culprit.numbers {
            true if first_wrong == Some(n) => "First wrong equation",
            true => "Wrong by itself too",
            false => "No wrong number, but none in some cases",
        };
        writeln!(
            out,
            "**{which}: ({}), `{}`.** {}.",
            equation(culprit.quantity),
            culprit.quantity,
            capital(&culprit.because)
        )?;
        if let Some((_, finding)) = examination.findings.iter().find(|(quantity, _)| *quantity == culprit.quantity) {
            writeln!(out, "{}", told(finding))?;
        }
        let mut same: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for other in &examination.blame.culprits {
            if let Some((first, (_, what))) = alike.get(other.quantity)
                && *first == culprit.quantity
            {
                same.entry(what).or_default().push(format!("`{}`", other.quantity));
            }
        }
        for (what, others) in same {
            writeln!(out, "The same in {}: {}. One cause, if they share a function.", others.join(", "), cell(what))?;
        }
        writeln!(out)?;
    }
    let mut by_input: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (quantity, input) in &examination.blame.follow {
        by_input.entry(input).or_default().push(quantity);
    }
    let follow: Vec<String> =
        by_input.iter().map(|(input, followers)| format!("{} from {input}", followers.join(", "))).collect();
    if !follow.is_empty() {
        writeln!(out, "Wrong, as what they are computed from is: {}.\n", follow.join("; "))?;
    }
    Ok(())
}

/// What is known of a mistake, in sentences.
fn told(finding: &Finding) -> String {
    let mut sentences = Vec::new();
    let silent: usize = finding.without_numbers.values().sum();
    let faults: Vec<String> = finding.without_numbers.iter().map(|(word, n)| format!("{word} in {n}")).collect();
    if silent > 0 && silent == finding.failing {
        sentences.push(format!("It answers no number in any of {silent} failing case(s): {}.", faults.join(", ")));
    } else if silent > 0 {
        sentences.push(format!(
            "It answers no number in {silent} of {} failing cases: {}.",
            finding.failing,
            faults.join(", ")
        ));
    }
    match &finding.kinds[..] {
        [] if silent == finding.failing => {}
        [] => sentences.push("No known kind of mistake gives these answers.".to_string()),
        kinds => {
            let kinds: Vec<String> =
                kinds.iter().map(|(kind, what)| format!("{} ({})", kind.word(), cell(what))).collect();
            sentences.push(format!("What fits: {}.", kinds.join("; or ")));
        }
    }
    if !finding.entries.is_empty() {
        sentences.push(format!("Wrong entries: {}.", finding.entries.join(", ")));
    }
    if !finding.only_where.is_empty() {
        sentences.push(format!("Only in states tagged {}.", finding.only_where.join(", ")));
    }
    sentences.join(" ")
}

fn write_refusals(out: &mut String, suite: &Suite, examination: &Examination) -> std::fmt::Result {
    if examination.hello.is_err() {
        return Ok(());
    }
    for (n, refusal) in &examination.refusals {
        let Some(invalid) = suite.invalid.get(*n) else { continue };
        let (what, came) = match refusal {
            Refusal::Accepted => ("Not refused", "a value was answered".to_string()),
            Refusal::Fault(fault) => ("Neither refused nor answered", cell(&fault.to_string())),
            Refusal::Refused(_) | Refusal::NotImplemented => continue,
        };
        writeln!(
            out,
            "\n{what}: `{}`, asked for {}: {came}; `{}` is wrong: {}.",
            invalid.id, invalid.equation, invalid.key, invalid.because
        )?;
    }
    Ok(())
}

/// A failing case in a cell of the table.
fn failing(suite: &Suite, n: usize, verdict: &Verdict) -> String {
    let id = suite.cases.get(n).map_or("", |case| &case.id);
    match verdict {
        Verdict::Wrong(wrong) => format!("`{id}`: {:e} where {:e} is right", wrong.answered, wrong.expected),
        Verdict::Fault(fault) => format!("`{id}`: {}", cell(&fault.to_string())),
        _ => String::new(),
    }
}

/// Text that stays inside a cell.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('`', "'").replace(char::is_control, " ")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_name_stays_in_its_cell_and_line() {
        assert_eq!(super::cell("a|b\n# `c`"), "a\\|b # 'c'");
    }
}
