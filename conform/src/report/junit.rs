//! The report as JUnit XML, which servers of continuous integration show.
//!
//! A suite is a quantity, a case a state: servers list failing cases by name, and the smallest failing state is what to try.

use std::fmt::Write;

use super::record::{Conclusion, RefusalVerdict, Report};
use super::words::exact;
use crate::examination::{Examination, InvalidOutcome};
use crate::formula::formula;
use crate::suite::Suite;
use crate::verdict::{Verdict, Wrong};

/// A case, and how it went.
struct TestCase<'a> {
    name: &'a str,
    outcome: Outcome,
}

enum Outcome {
    Passed,
    Skipped(String),
    Failed { message: String, text: String },
}

/// JUnit XML of an examination and its report. An invalid state that is not refused is skipped with a message, not failed, unless
/// `must_refuse`.
pub fn junit(suite: &Suite, examination: &Examination, report: &Report, must_refuse: bool) -> String {
    let mut suites = vec![conversation(report)];
    for (quantity, cases) in examination.verdicts.iter().filter(|(_, cases)| !cases.is_empty()) {
        let case = |(n, verdict): &(usize, Verdict)| {
            Some(TestCase { name: &suite.cases.get(*n)?.id, outcome: Outcome::of(quantity, verdict) })
        };
        suites.push(((*quantity).to_string(), cases.iter().filter_map(case).collect()));
    }
    let invalid = suite.invalid.iter().zip(&examination.invalid).map(|(case, verdict)| {
        let detail = verdict.detail.clone().unwrap_or_default();
        let not_refused = |what: &str| {
            let message = format!("should refuse, but {what}: {} is invalid: {}", case.key, case.because);
            match must_refuse {
                true => Outcome::Failed { message, text: detail.clone() },
                false => Outcome::Skipped(message),
            }
        };
        let outcome = match verdict.outcome {
            InvalidOutcome::Refused => Outcome::Passed,
            InvalidOutcome::NotImplemented => Outcome::Skipped("not implemented".into()),
            InvalidOutcome::Accepted => not_refused("it answered a value"),
            InvalidOutcome::Fault => not_refused(&format!("it gave no answer ({detail})")),
        };
        TestCase { name: &case.id, outcome }
    });
    if report.refusal.verdict != RefusalVerdict::NotAsked {
        suites.push(("invalid".into(), invalid.collect()));
    }
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write(&mut text, &suites, report);
    text
}

/// Whether the program can be asked at all.
fn conversation(report: &Report) -> (String, Vec<TestCase<'static>>) {
    let outcome = match report.verdict {
        Conclusion::NoAnswer | Conclusion::NothingChecked => {
            Outcome::Failed { message: report.headline(), text: report.program.no_hello.clone().unwrap_or_default() }
        }
        _ => Outcome::Passed,
    };
    ("conversation".into(), vec![TestCase { name: "hello", outcome }])
}

impl Outcome {
    fn of(quantity: &str, verdict: &Verdict) -> Outcome {
        let text = format!("look at: {}", formula(quantity));
        match verdict {
            Verdict::Pass { .. } => Outcome::Passed,
            Verdict::NotImplemented => Outcome::Skipped("not implemented".into()),
            Verdict::Fault(fault) => Outcome::Failed { message: fault.to_string(), text },
            Verdict::Wrong(Wrong { entry, answered, expected, digits, .. }) => Outcome::Failed {
                message: format!(
                    "entry {entry}: {}, expected {}; {digits:.1} correct digits",
                    exact(*answered),
                    exact(*expected)
                ),
                text,
            },
        }
    }
}

fn write(out: &mut String, suites: &[(String, Vec<TestCase>)], report: &Report) -> std::fmt::Result {
    let all = || suites.iter().flat_map(|(_, cases)| cases);
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    writeln!(
        out,
        "<testsuites name=\"{}\" {} time=\"{:.3}\">",
        xml(&format!("ancf conform: {}", report.program.name)),
        counts(all()),
        report.seconds
    )?;
    for (name, cases) in suites {
        writeln!(out, " <testsuite name=\"{}\" {}>", xml(name), counts(cases))?;
        for TestCase { name: case, outcome } in cases {
            let head = format!("  <testcase classname=\"{}\" name=\"{}\"", xml(name), xml(case));
            match outcome {
                Outcome::Passed => writeln!(out, "{head}/>")?,
                Outcome::Skipped(why) => writeln!(out, "{head}><skipped message=\"{}\"/></testcase>", xml(why))?,
                Outcome::Failed { message, text } => {
                    writeln!(out, "{head}><failure message=\"{}\">{}</failure></testcase>", xml(message), xml(text))?;
                }
            }
        }
        writeln!(out, " </testsuite>")?;
    }
    writeln!(out, "</testsuites>")
}

fn counts<'a>(cases: impl IntoIterator<Item = &'a TestCase<'a>>) -> String {
    let (mut tests, mut failures, mut skipped) = (0, 0, 0);
    for case in cases {
        tests += 1;
        failures += usize::from(matches!(case.outcome, Outcome::Failed { .. }));
        skipped += usize::from(matches!(case.outcome, Outcome::Skipped(_)));
    }
    format!("tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" skipped=\"{skipped}\"")
}

/// Text within XML. Characters that XML has no place for become a question mark.
fn xml(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(' '),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push('?'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #[test]
    fn text_within_xml_ends_no_attribute() {
        assert_eq!(super::xml("a\"<b>&\u{1b}\u{0}\n"), "a&quot;&lt;b&gt;&amp;?? ");
    }
}
