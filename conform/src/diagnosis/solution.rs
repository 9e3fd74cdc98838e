//! Mistakes in the solution of (22), also for the Euler–Bernoulli element.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{DMatrix, DVector};

use super::candidate::{Candidate, candidate};
use super::entries::rows;
use super::mistake::MistakeKind::Other;
use crate::suite::Case;

/// Mass matrix, force and weight of a solution.
fn inputs(quantity: &str) -> Option<[&'static str; 3]> {
    match quantity {
        "22.eddot" => Some(["7.M", "19.Q_e", "gravity.Q_w"]),
        "cable.eddot" => Some(["cable.M", "cable.Q_e", "cable.Q_w"]),
        _ => None,
    }
}

/// Candidates that solve another system.
pub(super) fn of<'a>(quantity: &str, case: &'a Case) -> Vec<Candidate<'a>> {
    let Some([Some(M), Some(Q_e), Some(Q_w)]) =
        inputs(quantity).map(|names| names.map(|name| case.values.get(name).map(|value| value.numbers.as_slice())))
    else {
        return Vec::new();
    };
    let M = move || DMatrix::from_row_slice(Q_e.len(), Q_e.len(), M);
    let load = move || DVector::from_row_slice(Q_w) - DVector::from_row_slice(Q_e);
    vec![
        candidate(Other, "divided by the diagonal of M in place of M", move || {
            rows(&load().component_div(&M().diagonal()))
        }),
        candidate(Other, "divided by the row sums of M in place of M", move || {
            rows(&load().component_div(&M().column_sum()))
        }),
        candidate(Other, "multiplied by M in place of solved", move || rows(&(M() * load()))),
        candidate(Other, "not divided by M", move || rows(&load())),
    ]
}
