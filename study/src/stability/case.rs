//! A case of the table, its trials and how their findings are judged.

use serde::Serialize;

use super::row::{StabilityRow, Verdict};
use crate::error::Result;
use ancf::integrators::Counts;
use ancf::run::Run;

/// Part of the measured size above which a bound shows little. Rounding above it makes a result useless, and the run has to warn.
const USELESS: f64 = 1e-2;

/// A sweep of one parameter, with its reference and the meaning of right.
#[derive(Debug, Serialize)]
pub struct Case {
    /// Its name.
    pub name: &'static str,
    /// The swept parameter, with its unit.
    pub parameter: &'static str,
    /// Unit of error and bound.
    pub unit: &'static str,
    /// The reference, and its source.
    pub reference: &'static str,
    /// The condition of a right row, with the derivation of the bound.
    pub right: &'static str,
    /// The trials.
    #[serde(skip)]
    pub(crate) trials: fn() -> Vec<Trial>,
}

/// Result of a trial.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    /// Distance from the reference.
    pub error: f64,
    /// Largest error that is right.
    pub bound: f64,
    /// Parts of the bound, in numbers.
    pub why: String,
    /// Size of the measured quantity.
    pub size: f64,
    /// The part of the bound that rounding makes. A run can know of it, and has to warn where it makes the result useless; it knows nothing
    /// of the errors of steps, meshes and theories.
    pub rounding: f64,
    /// Work of the run.
    pub counts: Counts,
    /// Warnings of the run.
    pub warnings: Vec<String>,
    /// Error of another form, for comparison.
    pub beside: Option<f64>,
}

/// Outcome that a trial has to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// A result within the bound.
    Result,
    /// A result within the bound, or a refusal: the sweep continues until there is one.
    ResultOrRefusal,
    /// A refusal with all of these words; bars separate alternatives.
    Refusal(&'static [&'static str]),
    /// A result within the bound, with a warning that has all of these words.
    Warning(&'static [&'static str]),
}

/// One value of the parameter for one variant.
pub struct Trial {
    /// Method, element, mesh.
    pub variant: String,
    /// The parameter's value.
    pub value: f64,
    /// Whether it belongs to the fast subset.
    pub fast: bool,
    expected: Expected,
    run: Box<dyn Fn() -> Result<Finding> + Send + Sync>,
}

impl Expected {
    /// A result if it is promised; else a refusal is right too.
    pub fn result_if(promised: bool) -> Expected {
        if promised { Expected::Result } else { Expected::ResultOrRefusal }
    }
}

impl Trial {
    /// A trial that needs a result, not in the fast subset.
    pub fn new(
        variant: impl Into<String>,
        value: f64,
        run: impl Fn() -> Result<Finding> + Send + Sync + 'static,
    ) -> Trial {
        Trial { variant: variant.into(), value, fast: false, expected: Expected::Result, run: Box::new(run) }
    }

    /// In the fast subset, or not.
    pub fn fast(self, fast: bool) -> Trial {
        Trial { fast, ..self }
    }

    /// With another expected outcome.
    pub fn expect(self, expected: Expected) -> Trial {
        Trial { expected, ..self }
    }

    /// Runs and judges it.
    pub fn row(&self, case: &Case) -> StabilityRow {
        let outcome = (self.run)();
        let (verdict, note) = self.judge(&outcome);
        let finding = outcome.ok();
        let number = |of: fn(&Finding) -> f64| finding.as_ref().map(of);
        StabilityRow {
            case: case.name,
            variant: self.variant.clone(),
            parameter: case.parameter,
            value: self.value,
            error: number(|finding| finding.error),
            bound: number(|finding| finding.bound),
            size: number(|finding| finding.size),
            loose: finding.as_ref().is_some_and(|finding| finding.bound > USELESS * finding.size),
            unit: case.unit,
            beside: finding.as_ref().and_then(|finding| finding.beside),
            counts: finding.as_ref().map(|finding| finding.counts).unwrap_or_default(),
            why: finding.map(|finding| finding.why).unwrap_or_default(),
            verdict,
            note,
        }
    }

    fn judge(&self, outcome: &Result<Finding>) -> (Verdict, String) {
        match (outcome, self.expected) {
            (Err(error), Expected::Result | Expected::Warning(_)) => (Verdict::Wrong, format!("no result: {error}")),
            (Err(error), Expected::ResultOrRefusal) => (Verdict::Refused, error.to_string()),
            (Err(error), Expected::Refusal(words)) => {
                let message = error.to_string();
                match words.iter().find(|word| !word.split('|').any(|word| message.contains(word))) {
                    None => (Verdict::Refused, message),
                    Some(word) => (Verdict::Wrong, format!("refused without \"{word}\": {message}")),
                }
            }
            (Ok(_), Expected::Refusal(words)) => {
                (Verdict::Wrong, format!("not refused; expected: {}", words.join(", ")))
            }
            (Ok(finding), expected) => finding.judge(expected),
        }
    }
}

impl Finding {
    /// Work and warnings of a run, of a quantity of size 1; the rest is to be filled in.
    pub fn of(run: Run) -> Finding {
        Finding { counts: run.counts, warnings: run.warnings, size: 1.0, ..Finding::default() }
    }

    fn judge(&self, expected: Expected) -> (Verdict, String) {
        let warnings = self.warnings.join("; ");
        let useless = self.rounding > USELESS * self.size;
        // Not the negation of error > bound: a NaN is within no bound.
        let within = self.error <= self.bound && self.bound.is_finite();
        let lacking = match expected {
            Expected::Warning(words) => words.iter().find(|word| !warnings.contains(**word)),
            _ => None,
        };
        match lacking {
            _ if !within => (Verdict::Wrong, warnings),
            Some(word) => (Verdict::Wrong, format!("no warning with \"{word}\"; {warnings}")),
            None if useless && warnings.is_empty() => (Verdict::Wrong, "useless, without a warning".into()),
            None if warnings.is_empty() => (Verdict::Right, warnings),
            None => (Verdict::Warned, warnings),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    const CASE: Case = Case { name: "", parameter: "", unit: "", reference: "", right: "", trials: Vec::new };

    fn judged(expected: Expected, outcome: impl Fn() -> Result<Finding> + Send + Sync + 'static) -> Verdict {
        Trial::new("", 1.0, outcome).expect(expected).row(&CASE).verdict
    }

    fn finding(error: f64, bound: f64, warning: &str) -> Finding {
        let warnings = if warning.is_empty() { Vec::new() } else { vec![warning.into()] };
        Finding { error, bound, size: 1.0, rounding: bound, warnings, ..Finding::default() }
    }

    #[test]
    fn verdicts() {
        use Expected::{Refusal, Result, ResultOrRefusal, Warning};
        let refused = || Err(Error::Run(ancf::error::Error::Drifts { rods: "`a`".into() }));
        assert_eq!(judged(Result, || Ok(finding(1e-9, 1e-8, ""))), Verdict::Right);
        assert_eq!(judged(Result, || Ok(finding(1e-9, 1e-8, "hm"))), Verdict::Warned);
        assert_eq!(judged(Result, || Ok(finding(2e-8, 1e-8, "hm"))), Verdict::Wrong);
        assert_eq!(judged(Result, || Ok(finding(f64::NAN, 1e-8, ""))), Verdict::Wrong);
        assert_eq!(judged(Result, || Ok(finding(1.0, f64::INFINITY, "hm"))), Verdict::Wrong);
        assert_eq!(judged(Result, || Ok(finding(1e-9, 0.1, ""))), Verdict::Wrong);
        assert_eq!(judged(Result, || Ok(finding(1e-9, 0.1, "hm"))), Verdict::Warned);
        let of_the_step = || Ok(Finding { rounding: 1e-12, ..finding(1e-9, 0.1, "") });
        assert_eq!(judged(Result, of_the_step), Verdict::Right);
        assert!(Trial::new("", 1.0, of_the_step).row(&CASE).loose);
        assert!(!Trial::new("", 1.0, || Ok(finding(1e-9, 1e-8, ""))).row(&CASE).loose);
        assert_eq!(judged(Result, refused), Verdict::Wrong);
        assert_eq!(judged(ResultOrRefusal, refused), Verdict::Refused);
        assert_eq!(judged(ResultOrRefusal, || Ok(finding(2e-8, 1e-8, "hm"))), Verdict::Wrong);
        assert_eq!(judged(Refusal(&["`a`", "statics"]), refused), Verdict::Refused);
        assert_eq!(judged(Refusal(&["`b`"]), refused), Verdict::Wrong);
        assert_eq!(judged(Refusal(&["`a`"]), || Ok(finding(0.0, 1.0, "`a`"))), Verdict::Wrong);
        assert_eq!(judged(Warning(&["hm"]), || Ok(finding(1e-9, 1e-8, "hm"))), Verdict::Warned);
        assert_eq!(judged(Warning(&["ha"]), || Ok(finding(1e-9, 1e-8, "hm"))), Verdict::Wrong);
    }
}
