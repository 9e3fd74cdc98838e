//! The cases: what is swept, against which reference, and what right means.

use serde::Serialize;

use super::row::{Row, Verdict};
use super::{
    bad_structure, collapsed, estimate_check, explicit_with_a_hinge, far_from_origin, fine_mesh, heat, inclined,
    loads_that_move_nothing, long_run, poisson, rotation, shock, singular, slender, soft_and_stiff, step_size, stiff,
    units,
};
use crate::error::{Error, Result};
use ancf::integrators::counts::Counts;

/// A bound above this part of the size of what is measured shows little; and rounding above it makes a result useless, of which the
/// run has to warn.
const USELESS: f64 = 1e-2;

/// One case of the table.
#[derive(Debug, Serialize)]
pub struct Case {
    /// Its name.
    pub name: &'static str,
    /// The swept parameter, with its unit.
    pub parameter: &'static str,
    /// Unit of error and bound.
    pub unit: &'static str,
    /// What the error is measured from, and where that comes from.
    pub reference: &'static str,
    /// What right means, with the derivation of the bound.
    pub right: &'static str,
    /// The trials.
    #[serde(skip)]
    pub trials: fn() -> Result<Vec<Trial>>,
}

/// All cases, in the order of the table.
pub const CASES: &[Case] = &[
    stiff::CASE,
    loads_that_move_nothing::CASE,
    slender::CASE,
    soft_and_stiff::CASE,
    heat::FREE,
    heat::CLAMPED,
    shock::CASE,
    explicit_with_a_hinge::CASE,
    estimate_check::CASE,
    poisson::CASE,
    rotation::SPUN,
    rotation::CIRCLING,
    far_from_origin::CASE,
    units::CASE,
    step_size::CASE,
    long_run::CASE,
    fine_mesh::SMALL,
    fine_mesh::LARGE,
    singular::CASE,
    bad_structure::CASE,
    collapsed::CASE,
    inclined::CASE,
];

impl Case {
    /// The cases with these names; all if there are none.
    ///
    /// # Errors
    /// [`Error::Scene`] for a name that no case has.
    pub fn named(names: &[String]) -> Result<Vec<&'static Case>> {
        let known = || CASES.iter().map(|case| case.name).collect::<Vec<_>>().join("`, `");
        let find = |name: &String| {
            CASES.iter().find(|case| case.name == name).ok_or_else(|| Error::Name {
                file: "ancf stability".into(),
                key: "CASE".into(),
                value: name.clone(),
                allowed: format!("`{}`", known()),
            })
        };
        if names.is_empty() { Ok(CASES.iter().collect()) } else { names.iter().map(find).collect() }
    }
}

/// What a trial gives.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    /// Distance from the reference.
    pub error: f64,
    /// What it may be.
    pub bound: f64,
    /// What the bound is made of.
    pub why: String,
    /// Size of what is measured, beside which the bound shows what the row is worth.
    pub size: f64,
    /// The part of the bound that rounding makes. A run knows of it, and has to warn where it makes the result useless; of steps,
    /// meshes and theories it knows nothing.
    pub rounding: f64,
    /// The work.
    pub counts: Counts,
    /// What the run warns of.
    pub warnings: Vec<String>,
    /// The error of another form.
    pub beside: Option<f64>,
}

/// What has to happen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// A result within the bound.
    Result,
    /// The same, or a refusal: the sweep goes on until there is one.
    ResultOrRefusal,
    /// A refusal in which these words stand; a bar parts words of which one is enough.
    Refusal(&'static [&'static str]),
    /// A result within the bound, with a warning in which these words stand.
    Warning(&'static [&'static str]),
}

/// One value of the parameter.
pub struct Trial {
    /// Method, element, mesh.
    pub variant: String,
    /// The parameter's value.
    pub value: f64,
    /// Whether it belongs to the fast subset.
    pub fast: bool,
    /// What has to happen.
    pub expected: Expected,
    /// The work.
    pub run: Box<dyn Fn() -> Result<Finding> + Send + Sync>,
}

impl Trial {
    /// A trial that needs a result.
    pub fn new(
        variant: impl Into<String>,
        value: f64,
        run: impl Fn() -> Result<Finding> + Send + Sync + 'static,
    ) -> Trial {
        Trial { variant: variant.into(), value, fast: false, expected: Expected::Result, run: Box::new(run) }
    }

    /// The same in the fast subset, if `is` so.
    pub fn fast(self, is: bool) -> Trial {
        Trial { fast: is, ..self }
    }

    /// The same with another expectation.
    pub fn expect(self, expected: Expected) -> Trial {
        Trial { expected, ..self }
    }

    /// Makes it, and judges.
    pub fn row(&self, case: &Case) -> Row {
        let outcome = (self.run)();
        let (verdict, note) = self.judge(&outcome);
        let finding = outcome.ok();
        let has = finding.is_some();
        let Finding { error, bound, why, size, counts, beside, .. } = finding.unwrap_or_default();
        Row {
            case: case.name,
            variant: self.variant.clone(),
            parameter: case.parameter,
            value: self.value,
            error: has.then_some(error),
            bound: has.then_some(bound),
            size: has.then_some(size),
            loose: has && bound > USELESS * size,
            unit: case.unit,
            why,
            beside,
            counts,
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
    fn judge(&self, expected: Expected) -> (Verdict, String) {
        let said = self.warnings.join("; ");
        let useless = self.rounding > USELESS * self.size;
        // Not the same as error > bound: a NaN is not within any.
        let within = self.error <= self.bound && self.bound.is_finite();
        let lacking = match expected {
            Expected::Warning(words) => words.iter().find(|word| !said.contains(**word)),
            _ => None,
        };
        match lacking {
            _ if !within => (Verdict::Wrong, said),
            Some(word) => (Verdict::Wrong, format!("no warning with \"{word}\"; {said}")),
            None if useless && said.is_empty() => (Verdict::Wrong, "useless, and not warned of".into()),
            None if said.is_empty() => (Verdict::Right, said),
            None => (Verdict::Warned, said),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(expected: Expected, outcome: impl Fn() -> Result<Finding> + Send + Sync + 'static) -> Verdict {
        Trial::new("", 1.0, outcome).expect(expected).row(&CASES[0]).verdict
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
        assert!(Trial::new("", 1.0, of_the_step).row(&CASES[0]).loose);
        assert!(!Trial::new("", 1.0, || Ok(finding(1e-9, 1e-8, ""))).row(&CASES[0]).loose);
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
