//! Result of a run.

use super::accuracy::Accuracy;
use super::trajectory::Trajectory;
use crate::integrators::Counts;

/// Result of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Run {
    /// Recorded rows.
    pub trajectory: Trajectory,
    /// Counters of the work done.
    pub counts: Counts,
    /// Warnings to read before trusting the result.
    pub warnings: Vec<String>,
    /// Statics: most independent directions in which the equilibrium of a row is unstable; 0 in motion. Rows whose
    /// stability could not be told are warned of.
    pub unstable_directions: usize,
    /// Estimated errors; only from [`run_estimated`](super::run_estimated).
    pub accuracy: Accuracy,
}
