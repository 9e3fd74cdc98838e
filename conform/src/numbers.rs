//! Nested lists of numbers, as JSON has them.

use schemars::JsonSchema;
use serde_json::Value;

/// A number, or nested lists of numbers; the lists of one level have equal lengths.
#[derive(JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "its schema is used, never its values")]
pub enum Numbers {
    /// A number.
    Number(f64),
    /// A list; rows come first in a matrix.
    List(Vec<Numbers>),
}

/// Appends the numbers of nested lists, row by row, and returns the lengths of the lists. `None` if lists are ragged or hold anything but
/// numbers.
pub fn flatten(value: &Value, numbers: &mut Vec<f64>) -> Option<Vec<usize>> {
    match value {
        Value::Number(number) => {
            numbers.push(number.as_f64()?);
            Some(Vec::new())
        }
        Value::Array(items) => {
            let shapes: Vec<_> = items.iter().map(|item| flatten(item, numbers)).collect::<Option<_>>()?;
            let first = shapes.first().cloned().unwrap_or_default();
            shapes.iter().all(|shape| *shape == first).then(|| [vec![items.len()], first].concat())
        }
        _ => None,
    }
}
