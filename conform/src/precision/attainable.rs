//! Tolerances that a program can attain.

use super::form::{Form, Printing};
use super::perturbed::changes;
use super::single::errors;
use crate::suite::{Case, Reference, Tolerance};

/// Rounding of single precision, relative to a number.
const SINGLE: f64 = f32::EPSILON as f64 / 2.0;
/// Roundings of the terms that are allowed in single precision. Right programs have four at most, and few beyond one; the fixtures' 450
/// would hide mistakes here.
const ROUNDINGS: f64 = 32.0;
/// Number of roundings of each input: the signs that are tried are not the worst ones, and an energy grows with their square.
const INPUTS: f64 = 4.0;
/// Multiple of the error of the kit's own elimination that is allowed: others pivot and add up in another order.
const SOLUTIONS: f64 = 8.0;
/// Half a unit of the last digit, and a trifle for the rounding of the decimal itself.
const HALF: f64 = 0.501;
/// Size up to which terms count as zero.
const NOTHING: f64 = 1e-100;

/// Parts of a tolerance.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    /// Tolerance of the fixtures.
    fixture: f64,
    /// Roundings of the terms.
    roundings: f64,
    /// Rounded inputs.
    inputs: f64,
    /// Half a unit of the last digit that is printed.
    printing: f64,
}

impl Parts {
    /// The tolerance.
    pub fn sum(self) -> f64 {
        self.fixture + self.roundings + self.inputs + self.printing
    }

    /// Largest part in words.
    fn because(self) -> &'static str {
        if self.printing >= self.roundings.max(self.inputs) {
            "half a unit of the last digit printed"
        } else if self.inputs > self.roundings {
            "the inputs, rounded, change it by more than its own roundings do"
        } else {
            "roundings of the terms that are added up"
        }
    }
}

/// Parts of the tolerances of a reference value, without the effect of rounded inputs.
pub fn of_form(form: Form, reference: &Reference) -> impl Iterator<Item = Parts> {
    let entries = reference.numbers.iter().zip(&reference.absolute).zip(reference.terms());
    entries.map(move |((number, fixture), terms)| {
        let roundings = if form.single { ROUNDINGS * SINGLE * terms } else { 0.0 };
        // The answer may have a digit more before the point than the reference value.
        let printing = HALF * form.printing.unit(number.abs() + fixture + roundings);
        Parts { fixture: *fixture, roundings, inputs: 0.0, printing }
    })
}

/// Tolerance that a form can attain for a quantity in a case; with the digits in its worst entry and what takes the others, unless all
/// terms are zero.
pub fn attainable(form: Form, quantity: &str, case: &Case) -> Option<(Tolerance, Option<(f64, &'static str)>)> {
    let reference = case.values.get(quantity)?;
    let inputs = form.single.then(|| changes(quantity, case, INPUTS * SINGLE)).flatten();
    let solution = form.single.then(|| errors(quantity, case)).flatten();
    let mut parts: Vec<Parts> = of_form(form, reference).collect();
    for (part, change) in parts.iter_mut().zip(inputs.into_iter().flatten()) {
        part.inputs = change;
    }
    for (part, error) in parts.iter_mut().zip(solution.into_iter().flatten()) {
        part.roundings = part.roundings.max(SOLUTIONS * error);
    }
    // Where nothing is added up, there are no digits to lose.
    let entries = parts.iter().zip(reference.terms()).filter(|(_, terms)| *terms > NOTHING);
    let worst = entries.map(|(part, terms)| (part.sum() / terms, part.because())).max_by(|a, b| a.0.total_cmp(&b.0));
    let least = worst.map(|(lost, because)| ((-lost.log10()).max(0.0), because));
    let printed = match form.printing {
        Printing::Significant(significant) => HALF * 10f64.powi(1 - significant),
        Printing::Full | Printing::Decimals(_) => 0.0,
    };
    let relative = reference.relative + printed + if form.single { ROUNDINGS * SINGLE } else { 0.0 };
    let absolute = parts.iter().map(|part| part.sum()).collect();
    Some((Tolerance { absolute, relative }, least))
}
