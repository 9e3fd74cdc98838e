//! A mass matrix of the program beside the right one.

use nalgebra::DMatrix;

use super::outcome::StartResult;

/// A mass matrix beside the right one. It may be that of one component, without coordinates that are held, or with the vectors in another
/// order only if it says so: none is guessed.
pub fn mass_result(own: &[Vec<f64>], right: &DMatrix<f64>) -> StartResult {
    let what = "mass matrix M".to_string();
    let size = right.nrows();
    let stride = match own.len() {
        n if n == size => 1,
        n if 2 * n == size => 2,
        n => {
            let detail = format!("{n} rows; allowed: {size} of all coordinates, or {} of one component", size / 2);
            return StartResult { what, right: false, detail };
        }
    };
    if let Some(row) = own.iter().find(|row| row.len() != own.len()) {
        return StartResult {
            what,
            right: false,
            detail: format!("a row of {} numbers in a matrix of {}", row.len(), own.len()),
        };
    }
    let mut worst = (0.0, (0, 0));
    for (i, row) in own.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let off = (entry - right[(stride * i, stride * j)]).abs();
            if off > worst.0 || off.is_nan() {
                worst = (off, (i, j));
            }
        }
    }
    let (off, (i, j)) = worst;
    let detail = format!("entry ({}, {}) is off by {off:.1e} kg", i + 1, j + 1);
    StartResult { what, right: off <= 1e-9 * right.amax(), detail }
}
