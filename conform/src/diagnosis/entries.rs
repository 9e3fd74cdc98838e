//! Entries of a quantity: their order, their names, and which of them are wrong.

use std::collections::BTreeSet;

use nalgebra::{Dim, Matrix, RawStorage};

use super::observation::{Observation, Outcome};

/// Largest number of wrong entries that are named.
const MOST_NAMED: usize = 4;

/// Entries of a matrix, row by row.
pub(super) fn rows<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(matrix: &Matrix<f64, R, C, S>) -> Vec<f64> {
    let mut entries = Vec::with_capacity(matrix.len());
    for row in 0..matrix.nrows() {
        entries.extend((0..matrix.ncols()).map(|column| matrix[(row, column)]));
    }
    entries
}

/// Name of an entry by its indices, such as (3, 7), counted from 1.
pub(super) fn entry_name(entry: usize, shape: &[usize]) -> String {
    let mut rest = entry;
    let mut indices: Vec<String> = Vec::new();
    for length in shape.iter().rev().map(|length| length.max(&1)) {
        indices.insert(0, (rest % length + 1).to_string());
        rest /= length;
    }
    format!("({})", indices.join(", "))
}

/// Names of the entries that are wrong in some case. Empty for a number, and if there are too many.
pub(super) fn wrong_entries(quantity: &str, observations: &[Observation]) -> Vec<String> {
    let mut names = BTreeSet::new();
    for observation in observations {
        let Some(reference) = observation.case.values.get(quantity) else { continue };
        let Outcome::Wrong(answer) = observation.outcome else { continue };
        let shape = reference.shape_at_a_point();
        let size = shape.iter().product::<usize>().max(1);
        if size == 1 {
            return Vec::new();
        }
        let entries = answer.iter().zip(&reference.numbers).zip(reference.tolerances()).enumerate();
        let wrong = entries.filter(|(_, ((a, b), bound))| (*a - *b).abs() > **bound);
        names.extend(wrong.map(|(n, _)| entry_name(n % size, shape)));
    }
    if names.len() > MOST_NAMED { Vec::new() } else { names.into_iter().collect() }
}
