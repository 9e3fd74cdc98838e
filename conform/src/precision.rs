//! What a program can attain: double or single precision, and how many digits it prints.
//!
//! The form of the answers decides, not the size of their errors: all of them numbers of single precision, or none with more than N
//! digits. Errors decide only where the form says nothing (`level`). Tolerances then are those of `attainable`.

// Layers, from top to bottom; a module imports only from modules further down this list:
// level, attainable, perturbed, single, form, number, answered.
mod answered;
mod attainable;
mod form;
mod level;
mod number;
mod perturbed;
mod single;

use std::borrow::Cow;
use std::collections::BTreeMap;

use crate::answers::Answers;
use crate::suite::{Reference, Suite};

use self::answered::Answered;
use self::attainable::attainable;
pub use self::form::{Form, Printing};

/// Least share of a quantity's entries that agree with the reference at a form that only some quantities have. Constants returned in
/// place of a value have few digits, too.
const AGREEING: f64 = 0.5;

/// Precision of a program's answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Precision {
    /// Form of the answers.
    pub form: Form,
    /// Whether the size of the errors shows it, and not the form of the numbers.
    pub by_errors: bool,
    /// Quantities with answers of another form.
    pub others: BTreeMap<&'static str, Form>,
    /// Quantity and case in which the least digits can be attained, and why; `None` in double precision.
    pub least: Option<Least>,
}

/// Case in which the least digits can be attained.
#[derive(Clone, Debug, PartialEq)]
pub struct Least {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Name of the case.
    pub case: String,
    /// Digits that can be attained, relative to the terms.
    pub digits: f64,
    /// What takes the others.
    pub because: &'static str,
}

impl Precision {
    /// Finds the precision of a program from its answers.
    pub fn found(suite: &Suite, answers: &Answers) -> Precision {
        let quantities = answered::of(suite, answers);
        let precision = Precision::of_forms(&quantities);
        if !precision.form.single && precision.others.is_empty() && level::is_single(precision.form, &quantities) {
            let form = Form { single: true, ..precision.form };
            return Precision { form, by_errors: true, ..precision };
        }
        precision
    }

    /// Precision as the numbers' own form shows it.
    fn of_forms(quantities: &[Answered]) -> Precision {
        let all = Form::of(quantities.iter().flat_map(Answered::entries));
        if let Some(form) = all.filter(|form| form.is_reduced()) {
            return Precision { form, ..Precision::default() };
        }
        let each: BTreeMap<&'static str, Form> =
            quantities.iter().filter_map(|of| Some((of.quantity, Form::of(of.entries())?))).collect();
        let count = |form: &Form| each.values().filter(|other| *other == form).count();
        // Double precision wins a tie.
        let form = each.values().copied().max_by_key(|form| (count(form), !form.is_reduced())).unwrap_or_default();
        let agrees = |quantity: &str, form: &Form| {
            let of = quantities.iter().find(|of| of.quantity == quantity);
            of.is_some_and(|of| of.share_within(|reference| form.tolerance(reference)) >= AGREEING)
        };
        let differs =
            |(quantity, own): &(&'static str, Form)| *own != form && (!own.is_reduced() || agrees(quantity, own));
        Precision { form, others: each.into_iter().filter(differs).collect(), ..Precision::default() }
    }

    /// Form of a quantity's answers.
    pub fn of(&self, quantity: &str) -> Form {
        self.others.get(quantity).copied().unwrap_or(self.form)
    }

    /// Whether some answers have less than double precision.
    pub fn is_reduced(&self) -> bool {
        self.form.is_reduced() || self.others.values().any(|form| form.is_reduced())
    }

    /// The suite with tolerances that the program can attain, and the case in which it attains the least.
    pub fn applied<'a>(&mut self, suite: &'a Suite, answers: &Answers) -> Cow<'a, Suite> {
        if !self.is_reduced() {
            return Cow::Borrowed(suite);
        }
        let mut suite = suite.clone();
        for (quantity, cases) in &answers.0 {
            let form = self.of(quantity);
            let answered = cases.iter().filter(|(_, answer)| answered::has_value(answer));
            for (n, _) in answered.filter(|_| form.is_reduced()) {
                let Some(case) = suite.cases.get_mut(*n) else { continue };
                let Some((tolerance, least)) = attainable(form, quantity, case) else { continue };
                if let Some((digits, because)) = least
                    && self.least.as_ref().is_none_or(|least| digits < least.digits)
                {
                    self.least = Some(Least { quantity, case: case.id.clone(), digits, because });
                }
                if let Some(reference) = case.values.get_mut(*quantity) {
                    reference.attainable = Some(tolerance);
                }
            }
        }
        Cow::Owned(suite)
    }
}

impl Form {
    /// Tolerance of a reference value without the effect of rounded inputs.
    fn tolerance(self, reference: &Reference) -> Vec<f64> {
        attainable::of_form(self, reference).map(|parts| parts.sum()).collect()
    }
}
