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

/// Estimated errors of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Error due to the step; `None` if not estimated.
    pub time: Option<Estimate>,
    /// Error due to the mesh; `None` if not estimated.
    pub space: Option<Estimate>,
    /// Sum of both errors at the output rows alone, m: comparable with errors known only there.
    pub at_rows: Option<f64>,
}

impl Accuracy {
    /// Sum of both errors, m; `None` if one is unknown.
    pub fn total(&self) -> Option<f64> {
        Some(self.time.as_ref()?.value + self.space.as_ref()?.value)
    }
}
