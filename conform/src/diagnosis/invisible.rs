//! Mistakes that differ from the right value by less than a program can attain.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

use super::diagnose::candidates;
use super::mistake::{Mistake, MistakeKind};
use crate::suite::{Case, Reference, Suite};

/// A mistake that would be seen in double precision, but not at the precision of the program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Invisible {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// The mistake.
    pub mistake: Mistake,
}

/// Mistakes in `quantity` that no case shows at the tolerances of `suite`, though some case does at those of the fixtures.
pub fn invisible(quantity: &'static str, suite: &Suite) -> Vec<Invisible> {
    let mut cases: Vec<(&Case, &Reference)> =
        suite.cases.iter().filter_map(|case| Some((case, case.values.get(quantity)?))).collect();
    // Cases with many tags show most mistakes.
    cases.sort_by_key(|(case, _)| std::cmp::Reverse(case.tags.len()));
    // Whether the fixtures' tolerances show a mistake, for those that the program's own have not shown yet.
    let mut hidden: Option<BTreeMap<Mistake, bool>> = None;
    for (case, reference) in cases {
        let mut still = BTreeMap::new();
        let formulas =
            candidates(quantity, case, reference).into_iter().filter(|other| other.mistake.kind != MistakeKind::Digits);
        for candidate in formulas {
            let before = match &hidden {
                Some(hidden) => hidden.get(&candidate.mistake).copied(),
                None => Some(false),
            };
            let Some(before) = before else { continue };
            let Some(value) = (candidate.value)() else { continue };
            if within(&value, reference, reference.tolerances()) {
                let shown = before || !within(&value, reference, &reference.absolute);
                still.insert(candidate.mistake, shown);
            }
        }
        hidden = Some(still);
    }
    let shown = hidden.into_iter().flatten().filter(|(_, shown)| *shown);
    shown.map(|(mistake, _)| Invisible { quantity, mistake }).collect()
}

/// Whether a value agrees with a reference value within tolerances.
fn within(value: &[f64], reference: &Reference, tolerances: &[f64]) -> bool {
    value.len() == reference.numbers.len()
        && value.iter().zip(&reference.numbers).zip(tolerances).all(|((a, b), bound)| (a - b).abs() <= *bound)
}
