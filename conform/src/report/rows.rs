//! Counts of a report: by quantity and by tag.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::examination::{Examination, Refusal};
use crate::suite::Suite;
use crate::verdict::{Fault, Verdict};

/// Counts of one quantity, or of one tag.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    pub pass: usize,
    pub fail: usize,
    pub not_implemented: usize,
    /// Correct digits of the worst answer that is a number.
    pub digits: Option<f64>,
}

impl Row {
    fn add(&mut self, verdict: &Verdict) {
        match verdict {
            Verdict::Pass { .. } => self.pass += 1,
            Verdict::NotImplemented => self.not_implemented += 1,
            Verdict::Wrong(_) | Verdict::Fault(_) => self.fail += 1,
        }
        if let Some(digits) = verdict.digits() {
            self.digits = Some(self.digits.map_or(digits, |least| least.min(digits)));
        }
    }

    pub(super) fn word(&self) -> &'static str {
        match (self.fail, self.pass) {
            (1.., _) => "**fail**",
            (0, 1..) => "pass",
            (0, 0) => "not implemented",
        }
    }

    pub(super) fn json(&self) -> Value {
        let Row { pass, fail, not_implemented, digits } = self;
        json!({"pass": pass, "fail": fail, "not_implemented": not_implemented, "digits": digits.map(rounded)})
    }
}

pub(super) fn rounded(digits: f64) -> f64 {
    (digits * 10.0).round() / 10.0
}

/// The failing case with the fewest tags: the fewest things that can be wrong. One that was asked for comes before those that were not.
pub(super) fn smallest<'a>(suite: &Suite, cases: &'a [(usize, Verdict)]) -> Option<&'a (usize, Verdict)> {
    let tags = |n: usize| suite.cases.get(n).map_or(usize::MAX, |case| case.tags.len());
    cases.iter().filter(|(_, verdict)| verdict.fails()).min_by_key(|(n, verdict)| {
        let unasked = matches!(verdict, Verdict::Fault(Fault::NotAsked(_)));
        (unasked, tags(*n), *n)
    })
}

pub(super) fn of_quantity(cases: &[(usize, Verdict)]) -> Row {
    let mut row = Row::default();
    cases.iter().for_each(|(_, verdict)| row.add(verdict));
    row
}

/// Rows by tag.
pub(super) fn by_tag(suite: &Suite, examination: &Examination) -> BTreeMap<String, Row> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_not_asked_is_no_smallest_case() {
        let suite = Suite::embedded().unwrap();
        let tags = |n: &usize| suite.cases[*n].tags.len();
        let (few, many) = ((0..36).min_by_key(tags).unwrap(), (0..36).max_by_key(tags).unwrap());
        let fault = |n, fault: fn(String) -> Fault| (n, Verdict::Fault(fault(String::new())));
        let cases = [fault(few, Fault::NotAsked), fault(many, Fault::Crash)];
        assert_eq!(smallest(&suite, &cases), Some(&cases[1]));
        assert_eq!(smallest(&suite, &cases[..1]), Some(&cases[0]));
    }
}
