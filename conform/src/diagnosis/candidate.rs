//! Deliberate mistakes and the values that they give.

use super::mistake::{Mistake, MistakeKind};

/// A mistake made deliberately, and its value in one case, computed on demand.
pub(super) struct Candidate<'a> {
    /// The mistake.
    pub mistake: Mistake,
    /// Value of the quantity with the mistake, row by row; `None` if the mistake leaves no value.
    pub value: Box<dyn Fn() -> Option<Vec<f64>> + 'a>,
}

/// Candidate that has a value in every case.
pub(super) fn candidate<'a>(
    kind: MistakeKind,
    what: impl Into<String>,
    value: impl Fn() -> Vec<f64> + 'a,
) -> Candidate<'a> {
    possible(kind, what, move || Some(value()))
}

/// Candidate that may have no value. Where it has none, a program cannot have one either.
pub(super) fn possible<'a>(
    kind: MistakeKind,
    what: impl Into<String>,
    value: impl Fn() -> Option<Vec<f64>> + 'a,
) -> Candidate<'a> {
    Candidate { mistake: Mistake { kind, what: what.into() }, value: Box::new(value) }
}
