//! One answer compared with its reference value.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::suite::Reference;

/// Largest number of correct digits that is reported: the precision of f64.
const MOST_DIGITS: f64 = 16.0;

/// Index of a case in [`Suite::cases`](crate::Suite::cases), and the verdict on the answer in it.
pub type CaseVerdict = (usize, Verdict);

/// Judgement of one answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every entry is within its tolerance at the precision of the program.
    Pass {
        /// Correct digits of the worst entry, relative to its terms.
        digits: f64,
    },
    /// At least one number is out of tolerance.
    Wrong(Wrong),
    /// The program does not implement the quantity.
    NotImplemented,
    /// There are no numbers to compare.
    Fault(Fault),
}

/// An answer that is out of tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Correct digits of the worst entry; 0 if there are none.
    pub digits: f64,
    /// Index of the worst entry, row by row, counted from 0.
    pub entry: usize,
    /// Answer in the worst entry.
    pub answered: f64,
    /// Reference value of the worst entry.
    pub expected: f64,
    /// All numbers of the answer, row by row.
    pub answer: Vec<f64>,
}

/// Why an answer has no numbers to compare.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "fault", content = "detail")]
pub enum Fault {
    /// The program reported an error; `detail` is its message.
    Error(String),
    /// The nested lists have the wrong lengths; `detail` names both.
    Shape(String),
    /// An entry is NaN, infinite or null; `detail` counts them.
    NotFinite(String),
    /// A line that is not an answer; `detail` quotes it.
    Garbage(String),
    /// A line that does not end; the program was killed. `detail` is the length.
    Endless(String),
    /// No answer within the time limit; the program was killed. `detail` is the limit.
    TimeLimit(String),
    /// The answer came only when the program's input was closed; `detail` says why, and what to do.
    Buffered(String),
    /// The program ended; `detail` is its exit status and last message.
    Crash(String),
    /// The question was not asked; `detail` is the reason.
    NotAsked(String),
}

impl Fault {
    /// Short name for tables.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Fault::Error(_) => "an error",
            Fault::Shape(_) => "another shape",
            Fault::NotFinite(_) => "NaN or infinite",
            Fault::Garbage(_) => "no answer but another line",
            Fault::Endless(_) => "a line without an end",
            Fault::TimeLimit(_) => "no answer in time",
            Fault::Buffered(_) => "no answer until its input was closed",
            Fault::Crash(_) => "ended",
            Fault::NotAsked(_) => "not asked any more",
        }
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Fault::Error(message) => write!(f, "error: {message}"),
            Fault::Shape(detail) => write!(f, "wrong shape: {detail}"),
            Fault::NotFinite(detail) => write!(f, "not finite: {detail}"),
            Fault::Garbage(line) => write!(f, "not an answer: {line}"),
            Fault::Endless(length) => write!(f, "a line that does not end: {length}; the program was killed"),
            Fault::TimeLimit(limit) => write!(f, "no answer within {limit}"),
            Fault::Buffered(why) => write!(f, "no answer until its input was closed: {why}"),
            Fault::Crash(how) => write!(f, "the program ended: {how}"),
            Fault::NotAsked(why) => write!(f, "not asked: {why}"),
        }
    }
}

impl Verdict {
    /// Compares the numbers of an answer, row by row, with a reference value.
    pub fn of(answer: Vec<f64>, reference: &Reference) -> Verdict {
        if answer.len() != reference.numbers.len() {
            let (found, expected) = (answer.len(), reference.numbers.len());
            return Verdict::Fault(Fault::Shape(format!("{found} numbers; expected {expected}")));
        }
        let (entry, worst) = reference.worst_entry(&answer);
        let digits = reference.digits(&answer).clamp(0.0, MOST_DIGITS);
        if worst <= 1.0 {
            return Verdict::Pass { digits };
        }
        let at = |numbers: &[f64]| numbers.get(entry).copied().unwrap_or(f64::NAN);
        let (answered, expected) = (at(&answer), at(&reference.numbers));
        Verdict::Wrong(Wrong { digits, entry, answered, expected, answer })
    }

    /// Whether the answer passes.
    pub fn passes(&self) -> bool {
        matches!(self, Verdict::Pass { .. })
    }

    /// Whether the answer is wrong or has no numbers. A quantity that is not implemented does not fail.
    pub fn fails(&self) -> bool {
        matches!(self, Verdict::Wrong(_) | Verdict::Fault(_))
    }

    /// Correct digits of the worst entry; `None` without numbers.
    pub fn digits(&self) -> Option<f64> {
        match self {
            Verdict::Pass { digits } | Verdict::Wrong(Wrong { digits, .. }) => Some(*digits),
            Verdict::NotImplemented | Verdict::Fault(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn reference() -> Reference {
        let (numbers, absolute) = (vec![1.0, 200.0], vec![1e-13, 1e-11]);
        let json = Value::Null;
        Reference { json, per_point: false, shape: vec![2], numbers, absolute, relative: 1e-13, attainable: None }
    }

    #[test]
    fn digits_are_those_of_the_worst_entry_relative_to_its_own_tolerance() {
        // Half of the bound of the second entry, a tenth of that of the first.
        let verdict = Verdict::of(vec![1.0 + 1e-14, 200.0 + 5e-12], &reference());
        let Verdict::Pass { digits } = verdict else { panic!("{verdict:?}") };
        assert!((digits - 13.3).abs() < 0.01, "{digits}");
        assert_eq!(Verdict::of(vec![1.0, 200.0], &reference()), Verdict::Pass { digits: MOST_DIGITS });
    }

    #[test]
    fn one_entry_out_of_tolerance_is_wrong() {
        let verdict = Verdict::of(vec![1.0, 200.0 + 1e-4], &reference());
        let Verdict::Wrong(wrong) = verdict else { panic!("{verdict:?}") };
        assert_eq!((wrong.entry, wrong.expected), (1, 200.0));
        assert!((wrong.digits - 6.0).abs() < 0.01, "{}", wrong.digits);
        assert!(Verdict::of(vec![-1.0, 200.0], &reference()).fails());
    }

    #[test]
    fn missing_numbers_fail() {
        let verdict = Verdict::of(vec![1.0], &reference());
        assert_eq!(verdict, Verdict::Fault(Fault::Shape("1 numbers; expected 2".into())));
    }

    #[test]
    fn nan_and_infinity_fail() {
        for bad in [f64::NAN, f64::INFINITY] {
            for answer in [vec![bad, 200.0], vec![1.0, bad]] {
                assert!(Verdict::of(answer.clone(), &reference()).fails(), "{answer:?}");
            }
        }
    }
}
