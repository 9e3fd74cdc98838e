//! What a run gives at the sample times, and how far two runs are apart.

use serde::{Deserialize, Serialize};

use super::case::Case;
use ancf::run::Run;

/// Positions of the probe at the sample times, m, and its velocities, m/s, where they are recorded.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Samples {
    /// Positions.
    pub position: Vec<[f64; 2]>,
    /// Velocities; empty where they do not converge.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub velocity: Vec<[f64; 2]>,
}

impl Samples {
    /// The samples of a run: its last rows.
    pub fn of(case: &Case, run: &Run) -> Samples {
        let read = |suffix: &str| run.trajectory.column(&format!("{}.{suffix}", case.probe));
        let pairs = |x: &str, y: &str| match (read(x), read(y)) {
            (Some(x), Some(y)) => {
                let pairs: Vec<[f64; 2]> = x.into_iter().zip(y).map(|(x, y)| [x, y]).collect();
                pairs[pairs.len().saturating_sub(case.samples)..].to_vec()
            }
            _ => Vec::new(),
        };
        Samples { position: pairs("x", "y"), velocity: pairs("vx", "vy") }
    }

    /// Largest distance of the positions, m; not a number where one has others than the other.
    pub fn distance(&self, other: &Samples) -> f64 {
        largest(&self.position, &other.position)
    }

    /// Root of the mean square of the difference of the velocities, m/s, where both have them.
    pub fn velocity_difference(&self, other: &Samples) -> Option<f64> {
        let there = !self.velocity.is_empty() && self.velocity.len() == other.velocity.len();
        let squares = self.velocity.iter().zip(&other.velocity).map(|(a, b)| apart(a, b).powi(2));
        there.then(|| (squares.sum::<f64>() / self.velocity.len() as f64).sqrt())
    }

    /// What `finer`, a run with half the step by a method of this order, and this one say of a step of nothing (Richardson).
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

/// Largest distance of two lists of points; not a number where one of them is longer, empty, or has no numbers.
pub fn largest(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    if a.len() != b.len() {
        return f64::NAN;
    }
    // In the total order NaN is the largest, and is not lost.
    a.iter().zip(b).map(|(a, b)| apart(a, b)).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

fn apart(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
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
        assert!(largest(&[[0.0; 2], [f64::NAN, 0.0], [9.0, 0.0]], &[[0.0; 2]; 3]).is_nan());
    }

    #[test]
    fn extrapolation_is_exact_for_an_error_of_the_order() {
        let (step, limit) = (0.5, 7.0);
        let run = |step: f64| samples(limit + 3.0 * step * step);
        let found = run(step).extrapolated(&run(0.5 * step), 2);
        assert!(found.distance(&samples(limit)) < 1e-14);
    }
}
