//! `conformance.json`.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};

use super::rows::{by_tag, of_quantity, rounded, smallest};
use crate::blame::Culprit;
use crate::examination::{Examination, Refusal};
use crate::graph::equation;
use crate::protocol::Hello;
use crate::suite::Suite;
use crate::verdict::Verdict;

/// Name and version of the report's form.
pub const SCHEMA: &str = "ancf-conformance/1";
/// Faults that are told of one quantity.
const SHOWN: usize = 3;

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
    let culprits = culprits(examination);
    json!({
        "schema": SCHEMA,
        "program": {
            "name": examination.name(),
            "given": examination.hello.as_ref().is_ok_and(|hello| hello.given),
            "no_hello": examination.hello.as_ref().err().map(ToString::to_string),
            "unknown": examination.hello.iter().flat_map(Hello::unknown).collect::<Vec<_>>(),
        },
        "chatter": {"lines": examination.chatter.lines, "first": examination.chatter.first},
        "ancf": env!("CARGO_PKG_VERSION"),
        "fixtures": suite.versions,
        "passes": examination.passes(),
        "first_wrong": examination.blame.first_wrong().and_then(|place| culprits.get(place)),
        "culprits": culprits,
        "silent": examination.blame.silent,
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
    let alike = examination.alike();
    let of = |culprit: &Culprit| {
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
            "failing": finding.failing,
            "without_numbers": finding.without_numbers,
            "same_as": alike.get(culprit.quantity).map(|(quantity, _)| quantity),
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
