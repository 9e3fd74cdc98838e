//! A run next to its reference, with a bound for their distance.

use std::fmt;

use serde::Serialize;

/// A run of ours and its reference.
#[derive(Serialize)]
pub struct Comparison {
    pub run: String,
    pub step: f64,
    /// Over all times of the reference, m.
    pub largest_distance: f64,
    pub oracle_error: f64,
    pub bound: f64,
}

impl Comparison {
    /// Whether the distance is within its bound; a NaN is not.
    pub fn holds(&self) -> bool {
        self.largest_distance <= self.bound
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {:.1e} m from the oracle, bound {:.0e} m", self.run, self.largest_distance, self.bound)
    }
}
