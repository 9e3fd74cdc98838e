//! An examination as a Markdown table to read and to paste, and as `conformance.json`.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use serde_json::{Value, json};

use super::examine::{Examination, Refusal};
use super::graph::equation;
use super::mistakes::Finding;
use super::suite::Suite;
use super::verdict::Verdict;

/// Name and version of the report's form.
pub const SCHEMA: &str = "ancf-conformance/1";
/// Failing cases and faults that are told of one quantity.
const SHOWN: usize = 3;

/// Counts of one quantity, or of one tag.
#[derive(Clone, Debug, Default)]
struct Row {
    pass: usize,
    fail: usize,
    not_implemented: usize,
    /// Correct digits of the worst answer that is a number.
    digits: Option<f64>,
    /// Faults among the failing.
    faults: usize,
}

impl Row {
    fn add(&mut self, verdict: &Verdict) {
        match verdict {
            Verdict::Pass { .. } => self.pass += 1,
            Verdict::NotImplemented => self.not_implemented += 1,
            Verdict::Wrong(_) => self.fail += 1,
            Verdict::Fault(_) => (self.fail, self.faults) = (self.fail + 1, self.faults + 1),
        }
        if let Some(digits) = verdict.digits() {
            self.digits = Some(self.digits.map_or(digits, |least| least.min(digits)));
        }
    }

    fn word(&self) -> &'static str {
        match (self.fail, self.pass) {
            (1.., _) => "**fail**",
            (0, 1..) => "pass",
            (0, 0) => "not implemented",
        }
    }

    fn json(&self) -> Value {
        let Row { pass, fail, not_implemented, digits, .. } = self;
        json!({"pass": pass, "fail": fail, "not_implemented": not_implemented, "digits": digits.map(rounded)})
    }
}

fn rounded(digits: f64) -> f64 {
    (digits * 10.0).round() / 10.0
}

/// The failing case with the fewest tags: the fewest things that can be wrong.
fn smallest<'a>(suite: &Suite, cases: &'a [(usize, Verdict)]) -> Option<&'a (usize, Verdict)> {
    let tags = |n: usize| suite.cases.get(n).map_or(usize::MAX, |case| case.tags.len());
    cases.iter().filter(|(_, verdict)| verdict.fails()).min_by_key(|(n, _)| (tags(*n), *n))
}

fn of_quantity(cases: &[(usize, Verdict)]) -> Row {
    let mut row = Row::default();
    cases.iter().for_each(|(_, verdict)| row.add(verdict));
    row
}

/// Rows by tag.
fn by_tag(suite: &Suite, examination: &Examination) -> BTreeMap<String, Row> {
    let mut rows: BTreeMap<String, Row> = BTreeMap::new();
    for (n, verdict) in examination.verdicts.iter().flat_map(|(_, cases)| cases) {
        for tag in suite.cases.get(*n).map_or(&[][..], |case| &case.tags) {
            rows.entry(tag.clone()).or_default().add(verdict);
        }
    }
    for (_, refusal) in &examination.refusals {
        let row = rows.entry("invalid".into()).or_default();
        match refusal {
            Refusal::Refused(_) => row.pass += 1,
            Refusal::NotImplemented => row.not_implemented += 1,
            Refusal::Accepted | Refusal::Fault(_) => row.fail += 1,
        }
    }
    rows
}

/// The report to read.
pub fn markdown(suite: &Suite, examination: &Examination) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_markdown(&mut text, suite, examination);
    text
}

fn write_markdown(out: &mut String, suite: &Suite, examination: &Examination) -> std::fmt::Result {
    let versions: Vec<String> = suite.versions.iter().map(|(file, version)| format!("{file} {version}")).collect();
    writeln!(out, "## Conformance of {}\n", cell(&examination.hello.name))?;
    writeln!(out, "{}\n", summary(examination))?;
    write_blame(out, examination)?;
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
    let rows: Vec<Row> = examination.verdicts.iter().map(|(_, cases)| of_quantity(cases)).collect();
    let count = |word: &str| rows.iter().filter(|row| row.word() == word).count();
    let (pass, fail, left) = (count("pass"), count("**fail**"), count("not implemented"));
    let accepted =
        examination.refusals.iter().filter(|(_, r)| !matches!(r, Refusal::Refused(_) | Refusal::NotImplemented));
    let accepted = match accepted.count() {
        0 => String::new(),
        n => format!(" {n} of {} states that have to be refused are not.", examination.refusals.len()),
    };
    let digits = rows
        .iter()
        .filter_map(|row| row.digits)
        .fold(None, |least: Option<f64>, digits| Some(least.map_or(digits, |least| least.min(digits))));
    let digits = digits.map_or(String::new(), |digits| format!(" At least {digits:.1} correct digits."));
    format!("{pass} quantities pass, {fail} fail, {left} are not implemented.{digits}{accepted}")
}

fn write_blame(out: &mut String, examination: &Examination) -> std::fmt::Result {
    for (n, culprit) in examination.blame.culprits.iter().enumerate() {
        let which = if n == 0 { "First wrong equation" } else { "Wrong by itself too" };
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
    let mut sentences = match &finding.kinds[..] {
        [] => vec!["No known kind of mistake gives these answers.".to_string()],
        kinds => {
            let kinds: Vec<String> =
                kinds.iter().map(|(kind, what)| format!("{} ({})", kind.word(), cell(what))).collect();
            vec![format!("What fits: {}.", kinds.join("; or "))]
        }
    };
    if !finding.entries.is_empty() {
        sentences.push(format!("Wrong entries: {}.", finding.entries.join(", ")));
    }
    if !finding.only_where.is_empty() {
        sentences.push(format!("Only in states tagged {}.", finding.only_where.join(", ")));
    }
    sentences.join(" ")
}

fn write_refusals(out: &mut String, suite: &Suite, examination: &Examination) -> std::fmt::Result {
    for (n, refusal) in &examination.refusals {
        let Some(invalid) = suite.invalid.get(*n) else { continue };
        let what = match refusal {
            Refusal::Accepted => "a value was answered".to_string(),
            Refusal::Fault(fault) => cell(&fault.to_string()),
            Refusal::Refused(_) | Refusal::NotImplemented => continue,
        };
        writeln!(
            out,
            "\nNot refused: `{}`, asked for {}: {what}; `{}` is wrong: {}.",
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
    text.replace('|', "\\|").replace('`', "'")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// The content of `conformance.json`.
pub fn json(suite: &Suite, examination: &Examination) -> Value {
    let quantities: Vec<Value> = examination
        .verdicts
        .iter()
        .map(|(quantity, cases)| {
            let mut row = of_quantity(cases).json();
            row["quantity"] = (*quantity).into();
            row["equation"] = equation(quantity).into();
            row["smallest_failing"] =
                smallest(suite, cases).map_or(Value::Null, |(n, verdict)| failing_json(suite, *n, verdict));
            row["failing"] = failing_ids(suite, cases);
            row["faults"] = faults(suite, cases);
            row
        })
        .collect();
    let tags: BTreeMap<String, Value> =
        by_tag(suite, examination).into_iter().map(|(tag, row)| (tag, row.json())).collect();
    let refusals: Vec<Value> = examination.refusals.iter().filter_map(|(n, refusal)| {
        let invalid = suite.invalid.get(*n)?;
        let (outcome, detail) = match refusal {
            Refusal::Refused(message) => ("refused", Some(message.clone())),
            Refusal::Accepted => ("accepted", None),
            Refusal::NotImplemented => ("not-implemented", None),
            Refusal::Fault(fault) => ("fault", Some(fault.to_string())),
        };
        Some(json!({"id": invalid.id, "equation": invalid.equation, "key": invalid.key, "outcome": outcome, "detail": detail}))
    }).collect();
    json!({
        "schema": SCHEMA,
        "program": {"name": examination.hello.name, "given": examination.hello.given},
        "ancf": env!("CARGO_PKG_VERSION"),
        "fixtures": suite.versions,
        "passes": examination.passes(),
        "first_wrong": culprits(examination).first().cloned().unwrap_or(Value::Null),
        "culprits": culprits(examination),
        "follow": examination.blame.follow.iter().map(|(quantity, input)| json!({"quantity": quantity, "from": input})).collect::<Vec<_>>(),
        "quantities": quantities,
        "tags": tags,
        "invalid": refusals,
        "questions": examination.questions,
        "starts": examination.starts,
        "seconds": examination.seconds,
    })
}

fn culprits(examination: &Examination) -> Vec<Value> {
    let of = |culprit: &super::blame::Culprit| {
        let finding = examination.findings.iter().find(|(quantity, _)| *quantity == culprit.quantity);
        let finding = finding.map(|(_, finding)| finding.clone()).unwrap_or_default();
        let kinds: Vec<Value> = finding.kinds.iter().map(|(kind, what)| json!({"kind": kind, "what": what})).collect();
        json!({
            "quantity": culprit.quantity,
            "equation": equation(culprit.quantity),
            "because": culprit.because,
            "kinds": kinds,
            "entries": finding.entries,
            "only_where": finding.only_where,
        })
    };
    examination.blame.culprits.iter().map(of).collect()
}

fn failing_json(suite: &Suite, n: usize, verdict: &Verdict) -> Value {
    let case = suite.cases.get(n);
    let (id, tags) = (case.map(|case| &case.id), case.map(|case| &case.tags));
    match verdict {
        Verdict::Wrong(wrong) => json!({
            "case": id, "tags": tags, "entry": wrong.entry, "answered": wrong.answered, "expected": wrong.expected,
            "digits": rounded(wrong.digits),
        }),
        Verdict::Fault(fault) => json!({"case": id, "tags": tags, "fault": fault.to_string()}),
        _ => Value::Null,
    }
}

fn failing_ids(suite: &Suite, cases: &[(usize, Verdict)]) -> Value {
    let ids = cases.iter().filter(|(_, verdict)| verdict.fails()).filter_map(|(n, _)| suite.cases.get(*n));
    ids.map(|case| Value::from(case.id.as_str())).collect()
}

/// The first faults of a quantity that are not alike.
fn faults(suite: &Suite, cases: &[(usize, Verdict)]) -> Value {
    let mut seen = BTreeSet::new();
    let told = cases.iter().filter_map(|(n, verdict)| match verdict {
        Verdict::Fault(fault) => {
            let first = seen.insert(fault.to_string());
            let case = suite.cases.get(*n).map(|case| case.id.clone());
            first.then(|| json!({"case": case, "fault": fault}))
        }
        _ => None,
    });
    told.take(SHOWN).collect()
}
