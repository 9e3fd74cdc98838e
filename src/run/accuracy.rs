//! Estimated errors of a run.

use serde::Serialize;

/// Estimated error, with how it was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Estimate {
    /// Largest error over all compared instants, m.
    pub value: f64,
    /// Unit of the error: "m".
    pub unit: &'static str,
    /// How the error was estimated.
    pub method: String,
}

/// Whether the values of a column approach a limit as steps and elements are halved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Convergence {
    /// At least the first digit of the largest value is sure.
    Sure,
    /// No digit is sure; a finer run may help.
    Unsure,
    /// No digit is sure, and halving again changes the column by no less than halving once: instantaneous forces after
    /// a shock, for example.
    None,
}

/// Decimal digits of an f64.
const MOST_DIGITS: usize = 15;

/// Estimated error of a column of the trajectory, over all rows; in the column's unit.
///
/// ```
/// use ancf::run::{ColumnAccuracy, Convergence};
///
/// let convergence = Convergence::Sure;
/// let column = ColumnAccuracy { column: "tip.x".into(), time: 2e-5, space: 1e-5, largest: 1.0, convergence };
/// assert_eq!((column.sure_digits(0.7), column.sure_digits(1e-6)), (4, 0));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ColumnAccuracy {
    /// Name of the column.
    pub column: String,
    /// Error due to the step: 2 (positions) or 3.4 times the largest change in a finer run.
    pub time: f64,
    /// Error due to the mesh: 2 (positions) or 3.4 times the largest change in a run with more elements.
    pub space: f64,
    /// Largest magnitude in the run, of both components of a vector and of all energies.
    pub largest: f64,
    /// Whether the column converges.
    pub convergence: Convergence,
}

impl ColumnAccuracy {
    /// Sum of both errors.
    pub fn total(&self) -> f64 {
        self.time + self.space
    }

    /// Number of decimal digits of a value that are sure: those before its error.
    pub fn sure_digits(&self, value: f64) -> usize {
        if self.total() == 0.0 {
            return MOST_DIGITS;
        }
        let digits = (value.abs() / self.total()).log10().floor();
        // Not more than an f64 has; a NaN has none.
        if digits > 0.0 { (digits as usize).min(MOST_DIGITS) } else { 0 }
    }
}

/// Estimated errors of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Error of positions due to the step; `None` if not estimated.
    pub time: Option<Estimate>,
    /// Error of positions due to the mesh; `None` if not estimated.
    pub space: Option<Estimate>,
    /// Sum of both errors at the output rows alone, m: comparable with errors known only there.
    pub at_rows: Option<f64>,
    /// Errors of all columns but the time; empty if not estimated.
    pub columns: Vec<ColumnAccuracy>,
    /// Factor by which a deviation of 10⁻⁸ of the structure's size has grown; `None` if not estimated, and in statics.
    pub amplification: Option<f64>,
}

impl Accuracy {
    /// Sum of both errors of positions, m; `None` if one is unknown.
    pub fn total(&self) -> Option<f64> {
        Some(self.time.as_ref()?.value + self.space.as_ref()?.value)
    }

    /// Error of a column; `None` if it is unknown.
    pub fn column(&self, name: &str) -> Option<&ColumnAccuracy> {
        self.columns.iter().find(|column| column.column == name)
    }
}
