//! One answer beside its reference value.

use serde::Serialize;

use super::suite::Reference;

/// Digits that are shown at most: what f64 has.
pub const MOST_DIGITS: f64 = 16.0;

/// What came of one question.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every entry is as near as it has to be.
    Pass {
        /// Correct digits of the worst entry.
        digits: f64,
    },
    /// Numbers, but wrong ones.
    Wrong(Wrong),
    /// The program says that it does not have this.
    NotImplemented,
    /// No numbers that could be compared.
    Fault(Fault),
}

/// An answer that is too far from its reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Correct digits of the worst entry; 0 if there are none.
    pub digits: f64,
    /// Place of the worst entry, row by row.
    pub entry: usize,
    /// What was answered there.
    pub answered: f64,
    /// What is right there.
    pub expected: f64,
    /// All numbers.
    pub answer: Vec<f64>,
}

/// Why there are no numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "fault", content = "detail")]
pub enum Fault {
    /// The program's own error message.
    Error(String),
    /// Lists of other lengths.
    Shape(String),
    /// NaN, infinite or null.
    NotFinite(String),
    /// A line that is no answer.
    Garbage(String),
    /// A line that does not end; the program was ended.
    Endless(String),
    /// No answer in time; the program was ended.
    TimeLimit(String),
    /// The program ended.
    Crash(String),
    /// The program was ended too often before.
    NotAsked(String),
}

impl Fault {
    /// What it is, in a word or two.
    pub fn word(&self) -> &'static str {
        match self {
            Fault::Error(_) => "an error",
            Fault::Shape(_) => "another shape",
            Fault::NotFinite(_) => "NaN or infinite",
            Fault::Garbage(_) => "no answer but another line",
            Fault::Endless(_) => "a line without an end",
            Fault::TimeLimit(_) => "no answer in time",
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
            Fault::Garbage(line) => write!(f, "no answer but {line}"),
            Fault::Endless(length) => write!(f, "a line without an end: {length}; the program was ended"),
            Fault::TimeLimit(limit) => write!(f, "no answer within {limit}"),
            Fault::Crash(how) => write!(f, "the program ended: {how}"),
            Fault::NotAsked(why) => write!(f, "not asked: {why}"),
        }
    }
}

impl Verdict {
    /// Of an answer's numbers.
    pub fn of(answer: Vec<f64>, reference: &Reference) -> Verdict {
        let entries = answer.iter().zip(&reference.numbers).zip(&reference.absolute).enumerate();
        let distance = |((a, b), bound): ((&f64, &f64), &f64)| (a - b).abs() / bound;
        let (entry, worst) = entries.map(|(n, pair)| (n, distance(pair))).fold((0, 0.0), |worst, next| {
            // A NaN is as far as can be.
            if next.1 > worst.1 || next.1.is_nan() { (next.0, next.1) } else { worst }
        });
        let digits = (-(worst * reference.relative).log10()).clamp(0.0, MOST_DIGITS);
        if worst <= 1.0 {
            return Verdict::Pass { digits };
        }
        let at = |numbers: &[f64]| numbers.get(entry).copied().unwrap_or(f64::NAN);
        let (answered, expected) = (at(&answer), at(&reference.numbers));
        Verdict::Wrong(Wrong { digits, entry, answered, expected, answer })
    }

    /// Whether it is neither right nor left out.
    pub fn fails(&self) -> bool {
        matches!(self, Verdict::Wrong(_) | Verdict::Fault(_))
    }

    /// Correct digits, where there are numbers.
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
        Reference { json: Value::Null, shape: vec![2], numbers, absolute, relative: 1e-13 }
    }

    #[test]
    fn digits_are_those_of_the_worst_entry_in_its_own_size() {
        // Half of the bound of the second entry, a tenth of that of the first.
        let verdict = Verdict::of(vec![1.0 + 1e-14, 200.0 + 5e-12], &reference());
        let Verdict::Pass { digits } = verdict else { panic!("{verdict:?}") };
        assert!((digits - 13.3).abs() < 0.01, "{digits}");
        assert_eq!(Verdict::of(vec![1.0, 200.0], &reference()), Verdict::Pass { digits: MOST_DIGITS });
    }

    #[test]
    fn one_entry_beyond_its_bound_is_wrong() {
        let verdict = Verdict::of(vec![1.0, 200.0 + 1e-4], &reference());
        let Verdict::Wrong(wrong) = verdict else { panic!("{verdict:?}") };
        assert_eq!((wrong.entry, wrong.expected), (1, 200.0));
        assert!((wrong.digits - 6.0).abs() < 0.01, "{}", wrong.digits);
        assert!(Verdict::of(vec![-1.0, 200.0], &reference()).fails());
    }

    #[test]
    fn no_number_is_never_right() {
        for bad in [f64::NAN, f64::INFINITY] {
            for answer in [vec![bad, 200.0], vec![1.0, bad]] {
                assert!(Verdict::of(answer.clone(), &reference()).fails(), "{answer:?}");
            }
        }
    }
}
