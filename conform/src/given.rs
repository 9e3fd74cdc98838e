//! Whether a program computes with the values that it is given.
//!
//! A program that announces `given` may take some values and compute others itself. Wrong values that it computes itself remain an
//! excuse. So each value is altered once, in a state where that must change the answer.

use serde_json::Value;

use crate::examination::CaseVerdict;
use crate::graph::Node;
use crate::protocol::{self, Answer};
use crate::suite::{Case, Reference, Suite};
use crate::verdict::Fault;

/// Factor on a value that is altered.
const ALTERED: f64 = 1.5;
/// Number of states in which each value is altered.
const STATES: usize = 2;
/// An answer has changed if it is this many tolerances away: altered by half, an input that is read moves it much further.
const CHANGED: f64 = 1e3;

/// Asks for a quantity with given values in the case of an index; one of the values may be altered, as [`scaled`] does it.
pub type Ask<'a> = dyn FnMut(usize, Option<&str>) -> Result<Answer, Fault> + 'a;

/// Inputs of a quantity that do not change its answer when they are altered: the program does not read them.
///
/// Answers that are no numbers show nothing: what they are made of counts as read. An input that is zero wherever it could be altered
/// counts as unread: nothing shows that it is read.
pub fn unread(suite: &Suite, node: &Node, cases: &[CaseVerdict], ask: &mut Ask) -> Vec<&'static str> {
    let is_read = |input: &&&'static str| !is_read(suite, node, input, cases, ask);
    node.given.iter().filter(is_read).copied().collect()
}

fn is_read(suite: &Suite, node: &Node, input: &str, cases: &[CaseVerdict], ask: &mut Ask) -> bool {
    let is_zero = |value: &Reference| value.numbers.iter().all(|number| *number == 0.0);
    // Without numbers nothing can change.
    if cases.iter().all(|(_, verdict)| verdict.digits().is_none()) {
        return true;
    }
    let mut usable: Vec<(usize, &Case, &Reference)> = (cases.iter())
        .filter(|(_, verdict)| verdict.digits().is_some())
        .filter_map(|(n, _)| Some((*n, suite.cases.get(*n)?)))
        .filter_map(|(n, case)| Some((n, case, case.values.get(node.quantity)?)))
        .filter(|(_, case, quantity)| !is_zero(quantity) && !case.values.get(input).is_none_or(is_zero))
        .collect();
    // Most tags, most terms.
    usable.sort_by_key(|(_, case, _)| std::cmp::Reverse(case.tags.len()));
    usable.into_iter().take(STATES).any(|(n, _, quantity)| match (ask(n, None), ask(n, Some(input))) {
        (Ok(Answer::Value(before)), Ok(Answer::Value(after))) => differ(&before, &after, quantity),
        (before, after) => before != after,
    })
}

fn differ(before: &Value, after: &Value, reference: &Reference) -> bool {
    let numbers = |value: &Value| protocol::numbers(value, &reference.shape);
    match (numbers(before), numbers(after)) {
        (Ok(before), Ok(after)) => {
            let mut entries = before.iter().zip(&after).zip(&reference.absolute);
            entries.any(|((before, after), bound)| (before - after).abs() > CHANGED * bound)
        }
        _ => before != after,
    }
}

/// The value with all numbers altered.
pub fn scaled(value: &Value) -> Value {
    match value {
        Value::Array(items) => items.iter().map(scaled).collect(),
        other => other.as_f64().map_or(Value::Null, |number| (ALTERED * number).into()),
    }
}
