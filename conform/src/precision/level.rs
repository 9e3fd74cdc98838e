//! Single precision that the form of the numbers hides: the level of the errors shows it.

use std::collections::BTreeMap;

use super::answered::Answered;
use super::form::{Form, Printing};
use crate::graph::find;

/// Quantity that copies numbers of the state: it has all digits in any precision.
const COPIED: &str = "4.nodes";
/// Correct digits of answers in single precision, relative to the terms.
const DIGITS_OF_SINGLE: std::ops::RangeInclusive<f64> = 5.0..=10.0;
/// Least number of quantities that show the level.
const LEAST_QUANTITIES: usize = 8;
/// Least number of quantities that have errors of single precision although their inputs have none.
const LEAST_ROOTS: usize = 3;
/// Most significant digits that hide single precision.
const HIDING: i32 = 8;

/// Whether errors show single precision in numbers of a form that does not.
///
/// With all digits: every quantity has a case with ten correct digits at most, and half of the quantities have five in all cases.
/// With few digits printed: three quantities have errors that single precision explains and printing does not, their inputs none.
pub fn is_single(form: Form, quantities: &[Answered]) -> bool {
    match form.printing {
        Printing::Full => no_answer_is_double(quantities),
        Printing::Significant(significant) if significant > HIDING => false,
        Printing::Significant(_) | Printing::Decimals(_) => roots_are_single(form, quantities),
    }
}

fn no_answer_is_double(quantities: &[Answered]) -> bool {
    let digits: Vec<f64> =
        quantities.iter().filter(|of| of.quantity != COPIED).filter_map(Answered::least_digits).collect();
    let single = digits.iter().filter(|digits| DIGITS_OF_SINGLE.contains(digits)).count();
    digits.len() >= LEAST_QUANTITIES
        && digits.iter().all(|digits| digits <= DIGITS_OF_SINGLE.end())
        && 2 * single >= digits.len()
}

/// Errors of a quantity.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Errors {
    /// None beyond those of double precision.
    Double,
    /// Some that single precision explains.
    Single,
    /// Some that it does not explain.
    Mistake,
}

fn roots_are_single(form: Form, quantities: &[Answered]) -> bool {
    let single = Form { single: true, ..form };
    let errors = |of: &Answered| {
        if of.share_within(|reference| form.tolerance(reference)) >= 1.0 {
            Errors::Double
        } else if of.share_within(|reference| single.tolerance(reference)) >= 1.0 {
            Errors::Single
        } else {
            Errors::Mistake
        }
    };
    let errors: BTreeMap<&str, Errors> = quantities.iter().map(|of| (of.quantity, errors(of))).collect();
    let is_root = |quantity: &str| {
        let mut inputs = find(quantity).into_iter().flat_map(|node| node.inputs());
        inputs.all(|input| errors.get(input) == Some(&Errors::Double))
    };
    let roots = errors.iter().filter(|(quantity, errors)| **errors == Errors::Single && is_root(quantity));
    roots.count() >= LEAST_ROOTS
}

impl Answered<'_> {
    /// Fewest correct digits in the cases that tell.
    fn least_digits(&self) -> Option<f64> {
        let telling = self.cases.iter().filter(|case| case.is_telling());
        telling.map(|case| case.reference.digits(&case.answer)).reduce(f64::min)
    }
}
