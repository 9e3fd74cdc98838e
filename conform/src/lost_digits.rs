//! Digits that quantities lose, case by case: whether the error of an input explains that of a quantity.

use std::collections::BTreeMap;

use crate::suite::Suite;
use crate::verdict::CaseVerdict;

/// Digits of f64.
const ALL: f64 = 16.0;
/// Digits that a quantity may lose beyond its worst input. Digits are relative to the terms, so that few more are lost.
const MORE: f64 = 3.0;
/// The same for the solution of a system of equations.
const MORE_IN_SOLUTIONS: f64 = 6.0;
/// Solutions of a system of equations.
const SOLUTIONS: [&str; 2] = ["22.eddot", "cable.eddot"];

/// Digits that were lost, by quantity and name of the case. Answers without numbers have no entry.
#[derive(Debug, Default)]
pub struct LostDigits(BTreeMap<&'static str, BTreeMap<String, Lost>>);

#[derive(Clone, Copy, Debug)]
struct Lost {
    digits: f64,
    fails: bool,
}

/// Input of a quantity with wrong numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongInput {
    /// Name of the input.
    pub quantity: &'static str,
    /// Whether it is needed elsewhere than at the state's points, so that cases cannot be compared one by one.
    pub inner: bool,
}

/// Case in which the errors of its inputs do not explain that of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Unexplained {
    /// Name of the case.
    pub case: String,
    /// Input that lost most.
    pub input: &'static str,
    /// Digits that this input lost.
    pub input_lost: f64,
    /// Digits that the quantity lost.
    pub lost: f64,
}

impl LostDigits {
    /// Digits lost in each verdict.
    pub fn of(suite: &Suite, verdicts: &[(&'static str, Vec<CaseVerdict>)]) -> LostDigits {
        let lost = |(n, verdict): &CaseVerdict| {
            let lost = Lost { digits: ALL - verdict.digits()?, fails: verdict.fails() };
            Some((suite.cases.get(*n)?.id.clone(), lost))
        };
        LostDigits(verdicts.iter().map(|(id, cases)| (*id, cases.iter().filter_map(lost).collect())).collect())
    }

    /// Case in which the errors of wrong inputs explain that of a quantity least; `None` if they do in all cases.
    pub fn unexplained(&self, quantity: &str, inputs: &[WrongInput]) -> Option<Unexplained> {
        let more = if SOLUTIONS.contains(&quantity) { MORE_IN_SOLUTIONS } else { MORE };
        let failing = self.0.get(quantity)?.iter().filter(|(_, lost)| lost.fails);
        let cases = failing.filter_map(|(case, lost)| {
            let by_input = inputs.iter().map(|input| Some((input.quantity, self.lost_by(*input, case)?)));
            // An input without numbers explains anything.
            let by_input: Vec<(&'static str, f64)> = by_input.collect::<Option<_>>()?;
            let (input, input_lost) = by_input.into_iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
            let found = Unexplained { case: case.clone(), input, input_lost, lost: lost.digits };
            (lost.digits > input_lost + more).then_some(found)
        });
        cases.max_by(|a, b| (a.lost - a.input_lost).total_cmp(&(b.lost - b.input_lost)))
    }

    /// Whether some of the inputs fails in every case in which a quantity fails.
    pub fn fails_only_with(&self, quantity: &str, inputs: &[&str]) -> bool {
        let fails =
            |input: &&str, case: &str| self.0.get(*input).and_then(|of| of.get(case)).is_some_and(|lost| lost.fails);
        let Some(cases) = self.0.get(quantity) else { return false };
        let mut failing = cases.iter().filter(|(_, lost)| lost.fails).peekable();
        failing.peek().is_some() && failing.all(|(case, _)| inputs.iter().any(|input| fails(input, case)))
    }

    /// Digits that an input lost, as far as it matters in a case; `None` without numbers.
    fn lost_by(&self, input: WrongInput, case: &str) -> Option<f64> {
        let cases = self.0.get(input.quantity)?;
        match input.inner {
            true => cases.values().map(|lost| lost.digits).reduce(f64::max),
            false => cases.get(case).map(|lost| lost.digits),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::{Verdict, Wrong};

    fn verdict(digits: f64) -> Verdict {
        if digits > 13.0 {
            return Verdict::Pass { digits };
        }
        Verdict::Wrong(Wrong { digits, entry: 0, answered: 0.0, expected: 1.0, answer: vec![0.0] })
    }

    fn lost(input: [f64; 2], quantity: &'static str, digits: [f64; 2]) -> LostDigits {
        let suite = Suite::embedded().unwrap();
        let verdicts = |digits: [f64; 2]| digits.into_iter().map(verdict).enumerate().collect::<Vec<_>>();
        LostDigits::of(&suite, &[("9.J", verdicts(input)), (quantity, verdicts(digits))])
    }

    #[test]
    fn an_input_explains_few_digits_more_than_it_lost() {
        let at_points = [WrongInput { quantity: "9.J", inner: false }];
        assert_eq!(lost([8.0, 15.0], "10.epsilon_m", [6.0, 15.0]).unexplained("10.epsilon_m", &at_points), None);
        let more = lost([8.0, 15.0], "10.epsilon_m", [1.0, 15.0]).unexplained("10.epsilon_m", &at_points).unwrap();
        assert_eq!((more.input, more.input_lost, more.lost), ("9.J", 8.0, 15.0));
        // The input is wrong in another case.
        let elsewhere = lost([8.0, 15.0], "10.epsilon_m", [15.0, 6.0]);
        assert!(elsewhere.unexplained("10.epsilon_m", &at_points).is_some());
        let inner = [WrongInput { quantity: "9.J", inner: true }];
        assert_eq!(elsewhere.unexplained("10.epsilon_m", &inner), None);
        assert_eq!(lost([8.0, 15.0], "22.eddot", [2.5, 15.0]).unexplained("22.eddot", &at_points), None);
    }

    #[test]
    fn an_input_without_numbers_explains_anything() {
        let unknown = [WrongInput { quantity: "9.J_0", inner: false }];
        assert_eq!(lost([8.0, 15.0], "10.epsilon_m", [0.0, 0.0]).unexplained("10.epsilon_m", &unknown), None);
    }
}
