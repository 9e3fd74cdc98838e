//! Counters of the work of a run.

use serde::Serialize;

/// Counters of the work of a run, part of every result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Counts {
    /// Number of time steps, or of load steps.
    pub steps: usize,
    /// Number of rejected steps: repeated, shorter, since the estimated error was too large or the step could not be
    /// made. In statics: number of times that a load step, or a part of it, was halved.
    pub rejected: usize,
    /// Number of Newton iterations over all steps.
    pub newton_iterations: usize,
    /// Number of evaluations of the elastic forces of the whole structure.
    pub force_calls: usize,
    /// Number of evaluations of the tangent of the whole structure.
    pub tangent_calls: usize,
    /// Number of LU factorisations.
    pub factorizations: usize,
    /// Number of solutions with existing factors.
    pub solves: usize,
}
