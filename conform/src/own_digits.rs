//! Tolerances of printed numbers in a program's own conventions.
//!
//! A program rounds the numbers that it prints. Where its conventions scale them, half a unit of their last digit is scaled, too: six
//! digits of l/2 r_x are not six digits of r_x.

use serde_json::Value;

use crate::convention::Conventions;
use crate::precision::{Precision, Printing};
use crate::protocol::{self, Answer};
use crate::suite::{Case, Reference, Suite, Tolerance};

/// Half a unit of the last digit, and a trifle for the rounding of the decimal itself.
const HALF: f64 = 0.501;
/// The answer may have a digit more before the point than the reference value.
const MORE: f64 = 1.0 + 1e-6;

/// The suite with tolerances that also allow for the digits of the program's own numbers; `None` if they are those of the fixtures.
pub fn widened(suite: &Suite, precision: &Precision, conventions: &Conventions) -> Option<Suite> {
    if conventions.are_usual() {
        return None;
    }
    let mut wide = suite.clone();
    for (n, case) in suite.cases.iter().enumerate() {
        for (quantity, reference) in &case.values {
            let printing = precision.of(quantity).printing;
            let (true, Some(known)) = (printing != Printing::Full, reference.attainable.as_ref()) else { continue };
            let Some(own) = of_own_digits(suite, conventions, printing, (quantity, n, case), reference) else {
                continue;
            };
            let absolute = known.absolute.iter().zip(own).map(|(known, own)| known + own).collect();
            let attainable = Some(Tolerance { absolute, ..known.clone() });
            if let Some(wide) = wide.cases.get_mut(n).and_then(|case| case.values.get_mut(quantity)) {
                wide.attainable = attainable;
            }
        }
    }
    Some(wide)
}

/// What half a unit in the program's own numbers changes of each entry.
fn of_own_digits(
    suite: &Suite,
    conventions: &Conventions,
    printing: Printing,
    (quantity, n, case): (&str, usize, &Case),
    reference: &Reference,
) -> Option<Vec<f64>> {
    let theirs = conventions.given(quantity, case, reference);
    let ours = |value: Value| match conventions.answer(suite, quantity, n, Answer::Value(value)) {
        Answer::Value(value) => protocol::numbers(&value, &reference.shape).ok(),
        _ => None,
    };
    let (exact, rounded) = (ours(theirs.clone())?, ours(raised(&theirs, printing))?);
    Some(exact.iter().zip(&rounded).map(|(exact, rounded)| (rounded - exact).abs()).collect())
}

/// The value with every number raised by half a unit of its last printed digit.
fn raised(value: &Value, printing: Printing) -> Value {
    match value {
        Value::Array(items) => items.iter().map(|item| raised(item, printing)).collect(),
        other => match other.as_f64() {
            Some(number) => (number + HALF * printing.unit(MORE * number.abs())).into(),
            None => other.clone(),
        },
    }
}
