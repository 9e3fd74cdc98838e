//! Positions, velocities and reactions at the instants of a benchmark, and their distances.

use serde::{Deserialize, Serialize};

use super::benchmark::Benchmark;
use crate::path::{Path, columns, largest_distance};
use ancf::run::Run;

/// Positions of the probe, m, its velocities, m/s, and the forces of a support, N, if recorded.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Samples {
    /// Positions.
    pub position: Path,
    /// Velocities; empty if they do not converge.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub velocity: Path,
    /// Forces of the first support; empty if they do not converge.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reaction: Path,
}

/// Digits behind the point that files have of positions, and of velocities and forces: less than any uncertainty.
const DIGITS: [i32; 2] = [10, 7];

impl Samples {
    /// The samples of a run whose rows are the instants.
    pub fn of(benchmark: &Benchmark, run: &Run) -> Samples {
        let last = |probe, suffixes| -> Path {
            let path = columns(run, probe, suffixes);
            path[path.len().saturating_sub(benchmark.count())..].to_vec()
        };
        Samples {
            position: last(benchmark.probe, ["x", "y"]),
            velocity: last(benchmark.probe, ["vx", "vy"]),
            reaction: last(SUPPORT, ["rx", "ry"]),
        }
    }

    /// Largest distance of the positions, m; NaN if their numbers differ.
    pub fn distance(&self, other: &Samples) -> f64 {
        largest_distance(&self.position, &other.position)
    }

    /// What the distance may be larger between the instants than at them, m: an eighth of its second difference, with which a parabola
    /// through three instants bends.
    pub fn between(&self, other: &Samples) -> f64 {
        let apart: Vec<[f64; 2]> =
            self.position.iter().zip(&other.position).map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).collect();
        let at = apart.iter().map(|e| e[0].hypot(e[1])).fold(0.0, f64::max);
        let with = apart.windows(3).map(|e| {
            let second = [0, 1].map(|n| e[0][n] - 2.0 * e[1][n] + e[2][n]);
            e[1][0].hypot(e[1][1]) + second[0].hypot(second[1]) / 8.0
        });
        with.fold(at, f64::max) - at
    }

    /// Largest difference of the velocities, m/s; `None` unless both have them.
    pub fn velocity_difference(&self, other: &Samples) -> Option<f64> {
        difference(&self.velocity, &other.velocity)
    }

    /// Largest difference of the reactions, N; `None` unless both have them.
    pub fn reaction_difference(&self, other: &Samples) -> Option<f64> {
        difference(&self.reaction, &other.reaction)
    }

    /// Without what no file needs: digits below every uncertainty, and all but the positions unless `whole`.
    pub fn short(&self, whole: bool) -> Samples {
        let rounded = |path: &Path, digits: i32| -> Path {
            let unit = 10f64.powi(digits);
            path.iter().map(|vector| vector.map(|x| (x * unit).round() / unit)).collect()
        };
        let [position, rate] = DIGITS;
        let rest = |path: &Path| if whole { rounded(path, rate) } else { Path::new() };
        Samples {
            position: rounded(&self.position, position),
            velocity: rest(&self.velocity),
            reaction: rest(&self.reaction),
        }
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
            reaction: towards(&self.reaction, &finer.reaction),
        }
    }
}

/// Name of the probe of a support's force.
pub const SUPPORT: &str = "support";

fn difference(a: &Path, b: &Path) -> Option<f64> {
    let there = !a.is_empty() && a.len() == b.len();
    there.then(|| largest_distance(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(x: f64) -> Samples {
        let position = vec![[x, 0.0], [0.0, 2.0 * x]];
        Samples { position, velocity: vec![[x, 0.0], [0.0, x]], reaction: Path::new() }
    }

    /// A distance of 10 − (t − ½)² is 9.75 at whole times and 10 in between.
    #[test]
    fn a_distance_may_be_largest_between_the_instants() {
        let position = [-1.0, 0.0, 1.0, 2.0].map(|t: f64| [10.0 - (t - 0.5).powi(2), 0.0]).to_vec();
        let moving = Samples { position, ..Samples::default() };
        let rest = Samples { position: vec![[0.0; 2]; 4], ..Samples::default() };
        assert_eq!((moving.distance(&rest), moving.between(&rest)), (9.75, 0.25));
    }

    #[test]
    fn distances_and_differences_are_the_largest() {
        let (a, b) = (samples(0.0), samples(3.0));
        assert_eq!((a.distance(&b), a.velocity_difference(&b), a.reaction_difference(&b)), (6.0, Some(3.0), None));
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
