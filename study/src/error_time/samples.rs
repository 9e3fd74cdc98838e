//! Positions and velocities at the sample times, and their distances.

use serde::{Deserialize, Serialize};

use super::benchmark::Benchmark;
use crate::path::{Path, columns, distance, largest_distance};
use ancf::run::Run;

/// Positions of the probe at the sample times, m, and its velocities, m/s, if recorded.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Samples {
    /// Positions.
    pub position: Path,
    /// Velocities; empty if they do not converge.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub velocity: Path,
}

impl Samples {
    /// The samples of a run: its last rows.
    pub fn of(benchmark: &Benchmark, run: &Run) -> Samples {
        let last = |suffixes| -> Path {
            let path = columns(run, benchmark.probe, suffixes);
            path[path.len().saturating_sub(benchmark.samples)..].to_vec()
        };
        Samples { position: last(["x", "y"]), velocity: last(["vx", "vy"]) }
    }

    /// Largest distance of the positions, m; NaN if their numbers differ.
    pub fn distance(&self, other: &Samples) -> f64 {
        largest_distance(&self.position, &other.position)
    }

    /// Root mean square of the difference of the velocities, m/s; `None` unless both have them.
    pub fn velocity_difference(&self, other: &Samples) -> Option<f64> {
        let there = !self.velocity.is_empty() && self.velocity.len() == other.velocity.len();
        let squares = self.velocity.iter().zip(&other.velocity).map(|(a, b)| distance(*a, *b).powi(2));
        there.then(|| (squares.sum::<f64>() / self.velocity.len() as f64).sqrt())
    }

    /// Extrapolation to a step of zero (Richardson) from this run and `finer`, one with half the step, by a method of this order.
    pub fn extrapolated(&self, finer: &Samples, order: i32) -> Samples {
        let weight = 1.0 / (2f64.powi(order) - 1.0);
        let towards = |coarse: &[[f64; 2]], fine: &[[f64; 2]]| {
            let pairs = coarse.iter().zip(fine);
            pairs.map(|(c, f)| [f[0] + weight * (f[0] - c[0]), f[1] + weight * (f[1] - c[1])]).collect()
        };
        Samples {
            position: towards(&self.position, &finer.position),
            velocity: towards(&self.velocity, &finer.velocity),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(x: f64) -> Samples {
        Samples { position: vec![[x, 0.0], [0.0, 2.0 * x]], velocity: vec![[x, 0.0], [0.0, x]] }
    }

    #[test]
    fn distances_are_the_largest_and_differences_the_mean() {
        let (a, b) = (samples(0.0), samples(3.0));
        assert_eq!((a.distance(&b), a.velocity_difference(&b)), (6.0, Some(3.0)));
        assert!(a.distance(&Samples::default()).is_nan() && Samples::default().distance(&Samples::default()).is_nan());
        assert_eq!(a.velocity_difference(&Samples::default()), None);
    }

    #[test]
    fn extrapolation_is_exact_for_an_error_of_the_order() {
        let (step, limit) = (0.5, 7.0);
        let run = |step: f64| samples(limit + 3.0 * step * step);
        let found = run(step).extrapolated(&run(0.5 * step), 2);
        assert!(found.distance(&samples(limit)) < 1e-14);
    }
}
