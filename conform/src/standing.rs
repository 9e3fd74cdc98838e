//! Standing of a quantity, from the verdicts on its cases: its status, and its answers as evidence.

use crate::blame::{Status, WithGiven};
use crate::diagnosis::{Observation, Outcome};
use crate::examination::CaseVerdict;
use crate::suite::Suite;
use crate::verdict::{Fault, Verdict, Wrong};

/// An answer with fewer correct digits is wrong by more than rounding.
const CLEARLY_WRONG: f64 = 8.0;

/// First failing case of each quantity that fails; one that fails by more than rounding if there is one.
pub fn first_failing(verdicts: &[(&'static str, Vec<CaseVerdict>)]) -> Vec<(&'static str, usize)> {
    let clearly = |verdict: &Verdict| verdict.fails() && verdict.digits().is_none_or(|digits| digits < CLEARLY_WRONG);
    let failing = |(quantity, cases): &(&'static str, Vec<CaseVerdict>)| {
        let clear = cases.iter().find(|(_, verdict)| clearly(verdict));
        let (n, _) = clear.or_else(|| cases.iter().find(|(_, verdict)| verdict.fails()))?;
        Some((*quantity, *n))
    };
    verdicts.iter().filter_map(failing).collect()
}

/// Whether some verdict is the wanted one.
pub fn any(cases: &[CaseVerdict], wanted: fn(&Verdict) -> bool) -> bool {
    cases.iter().any(|(_, verdict)| wanted(verdict))
}

/// Verdict in the case with index `n`.
fn verdict_in(cases: &[CaseVerdict], n: usize) -> Option<&Verdict> {
    cases.iter().find(|(case, _)| *case == n).map(|(_, verdict)| verdict)
}

/// Answers to a quantity as evidence. Second answers, `again`, replace the first ones.
pub fn observations<'a>(suite: &'a Suite, cases: &'a [CaseVerdict], again: &'a [CaseVerdict]) -> Vec<Observation<'a>> {
    let observation = |(n, verdict): &'a CaseVerdict| {
        let outcome = match verdict_in(again, *n).unwrap_or(verdict) {
            Verdict::Pass { .. } => Outcome::Right,
            Verdict::Wrong(Wrong { answer, .. }) => Outcome::Wrong(answer),
            Verdict::Fault(fault @ (Fault::Error(_) | Fault::Shape(_))) => Outcome::Refused(fault),
            Verdict::Fault(fault) => Outcome::Fault(fault),
            Verdict::NotImplemented => return None,
        };
        Some(Observation { case: suite.cases.get(*n)?, outcome })
    };
    cases.iter().filter_map(observation).collect()
}

/// Status of a quantity from its first answers, and from those with reference inputs.
pub fn status(cases: &[CaseVerdict], again: Option<&[CaseVerdict]>) -> Status {
    let number: fn(&Verdict) -> bool = |verdict| verdict.digits().is_some();
    if !any(cases, Verdict::fails) {
        return if any(cases, Verdict::passes) { Status::Right } else { Status::Unknown };
    }
    if !any(cases, number) && !any(again.unwrap_or_default(), number) {
        return Status::Silent;
    }
    let numbers = any(cases, |verdict| matches!(verdict, Verdict::Wrong(_)));
    Status::Wrong { numbers, with_given: again.map_or(WithGiven::NotTried, |again| with_given(cases, again)) }
}

/// Effect of reference inputs: compares the second answers with the first ones.
pub fn with_given(cases: &[CaseVerdict], again: &[CaseVerdict]) -> WithGiven {
    if any(again, Verdict::fails) {
        let same = |(n, second): &CaseVerdict| {
            let equal = |first: &Verdict| first == second || first.passes() && second.passes();
            verdict_in(cases, *n).is_some_and(equal)
        };
        return if again.iter().all(same) { WithGiven::Same } else { WithGiven::Wrong };
    }
    let failing = cases.iter().filter(|(_, verdict)| verdict.fails());
    let (cured, unasked): (Vec<_>, Vec<_>) =
        failing.partition(|(n, _)| verdict_in(again, *n).is_some_and(Verdict::passes));
    match unasked.len() {
        0 => WithGiven::Right,
        unasked => WithGiven::Partly { cured: cured.len(), unasked },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_with_given_requires_every_failing_case_to_be_asked_again() {
        let (right, crash) = (Verdict::Pass { digits: 15.0 }, Verdict::Fault(Fault::Crash("exit status: 1".into())));
        let off = Verdict::Fault(Fault::Error("too large".into()));
        let of = |verdicts: &[&Verdict]| verdicts.iter().map(|v| (*v).clone()).enumerate().collect::<Vec<_>>();
        let first = of(&[&right, &off, &crash]);
        assert_eq!(with_given(&first, &of(&[&right])), WithGiven::Partly { cured: 0, unasked: 2 });
        assert_eq!(with_given(&first, &of(&[&right, &right])), WithGiven::Partly { cured: 1, unasked: 1 });
        assert_eq!(with_given(&first, &of(&[&right, &right, &right])), WithGiven::Right);
        assert_eq!(
            with_given(&first, &of(&[&right, &Verdict::NotImplemented, &right])),
            WithGiven::Partly { cured: 1, unasked: 1 }
        );
        assert_eq!(with_given(&first, &of(&[&right, &off])), WithGiven::Same);
        assert_eq!(with_given(&first, &of(&[&off, &off])), WithGiven::Wrong);
    }

    #[test]
    fn silence_differs_from_missing_numbers_in_some_cases() {
        let (right, crash) = ((0, Verdict::Pass { digits: 15.0 }), (1, Verdict::Fault(Fault::Crash("over".into()))));
        assert_eq!(status(std::slice::from_ref(&crash), None), Status::Silent);
        assert_eq!(status(std::slice::from_ref(&crash), Some(&[])), Status::Silent);
        let faulty = Status::Wrong { numbers: false, with_given: WithGiven::NotTried };
        assert_eq!(status(&[right, crash], None), faulty);
    }
}
