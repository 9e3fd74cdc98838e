//! A file of the program with its samples at the reference's times.

use super::sampling::Sampled;
use super::written::Written;

/// Longest distance of samples that is taken for the step, s.
const LONGEST_STEP: f64 = 5e-3;
/// Shortest step that right methods are run with, s: half a million of them end in seconds, and are as good as exact.
const SHORTEST_STEP: f64 = 1e-6;

/// A file with its samples at the reference's times.
#[derive(Debug)]
pub struct Run {
    /// The file.
    pub written: Written,
    /// Its samples.
    pub sampled: Sampled,
}

impl Run {
    /// The step of its method, or what its samples let it be at most, s; not below the shortest that is run.
    pub fn step(&self) -> Option<f64> {
        let step = self.written.step.or((self.sampled.interval <= LONGEST_STEP).then_some(self.sampled.interval));
        step.map(|step| step.max(SHORTEST_STEP))
    }
}
