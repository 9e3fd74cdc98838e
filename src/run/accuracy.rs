//! What is known of a run's errors.

use serde::Serialize;

/// An estimated error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Largest over all instants that are compared, m.
    pub value: f64,
    /// "m".
    pub unit: &'static str,
    /// How it was found.
    pub method: String,
}

/// What is known of a run's errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// The step's part; `None` where nobody asked.
    pub time: Option<Estimate>,
    /// The mesh's part.
    pub space: Option<Estimate>,
    /// Both together as they are at the rows alone, m: what is comparable with errors that are known there only.
    pub at_rows: Option<f64>,
}

impl Accuracy {
    /// Both parts together, m; `None` where one is not known.
    pub fn total(&self) -> Option<f64> {
        Some(self.time.as_ref()?.value + self.space.as_ref()?.value)
    }
}
