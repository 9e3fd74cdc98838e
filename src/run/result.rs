//! What a run gives.

use super::accuracy::Accuracy;
use super::trajectory::Trajectory;
use crate::integrators::Counts;

/// What a run gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The rows that the scene asks for.
    pub trajectory: Trajectory,
    /// The work that was done.
    pub counts: Counts,
    /// What a person should know before trusting the result.
    pub warnings: Vec<String>,
    /// Statics: in how many independent directions the equilibrium at the end is unstable; 0 in motion, and where that is not told.
    pub unstable_directions: usize,
    /// Estimated errors; those of [`run_estimated`](super::run_estimated) only.
    pub accuracy: Accuracy,
}
