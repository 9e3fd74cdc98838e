//! How often each kind of work was done.

use serde::Serialize;

/// Counters that come with every result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Time steps.
    pub steps: usize,
    /// Steps made again, shorter, as their estimated error was too large or they could not be made.
    pub rejected: usize,
    /// Newton iterations over all steps.
    pub newton_iterations: usize,
    /// Evaluations of the elastic forces of the whole structure.
    pub force_calls: usize,
    /// Evaluations of the tangent of the whole structure.
    pub tangent_calls: usize,
    /// LU factorisations.
    pub factorizations: usize,
    /// Solutions with given factors.
    pub solves: usize,
}
