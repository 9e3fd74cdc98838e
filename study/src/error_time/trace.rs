//! The motion of the probe at every step of a run, and what it is in between.

use super::samples::Samples;
use super::setup::{Record, Setup};
use crate::error::Result;
use crate::path::{Path, distance};
use ancf::run::{Run, run_with_progress};

/// Position and velocity of the probe's point at the end of every step, with the start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Times, s.
    pub t: Vec<f64>,
    /// Positions, m.
    pub position: Path,
    /// Velocities, m/s.
    pub velocity: Path,
}

impl Trace {
    /// Makes the run that is timed, and reads it after every step: reading changes nothing of it.
    ///
    /// # Errors
    /// Those of the run.
    pub fn of(setup: &Setup) -> Result<(Trace, Run)> {
        let point = setup.benchmark.point()?;
        let mut trace = Trace::default();
        let scene = setup.scene(Record::Position)?;
        let at_rest = ancf::run::Simulation::new(scene.clone())?;
        trace.push(0.0, at_rest.position(&point)?, at_rest.velocity(&point)?);
        let mut failure = None;
        let run =
            run_with_progress(scene, |simulation| match (simulation.position(&point), simulation.velocity(&point)) {
                (Ok(position), Ok(velocity)) => trace.push(simulation.time(), position, velocity),
                (Err(error), _) | (_, Err(error)) => failure = Some(error),
            })?;
        failure.map_or(Ok((trace, run)), |error| Err(error.into()))
    }

    /// Adds an instant.
    pub fn push(&mut self, t: f64, position: [f64; 2], velocity: [f64; 2]) {
        self.t.push(t);
        self.position.push(position);
        self.velocity.push(velocity);
    }

    /// Positions and velocities at these times: cubic polynomials (Hermite) through the positions and velocities at the ends of the step.
    /// Empty if the run does not reach them.
    pub fn at(&self, times: &[f64]) -> Samples {
        let found: Option<Vec<_>> = times.iter().map(|t| self.between(*t)).collect();
        let (position, velocity) = found.unwrap_or_default().into_iter().unzip();
        Samples { position, velocity, reaction: Path::new() }
    }

    /// Estimate of what the cubic polynomials leave, m. Polynomials over two steps miss the position in the middle by sixteen times as much,
    /// as their error has the order four.
    pub fn interpolation_error(&self) -> f64 {
        let missed = (1..self.t.len().saturating_sub(1)).map(|n| {
            let (position, _) = self.hermite(n - 1, n + 1, self.t[n]);
            distance(position, self.position[n])
        });
        missed.max_by(f64::total_cmp).unwrap_or(0.0) / 16.0
    }

    fn between(&self, t: f64) -> Option<([f64; 2], [f64; 2])> {
        // A sum of steps misses its end by roundings.
        let near = 1e-9 * t.abs();
        let after = self.t.partition_point(|step| *step < t - near);
        match self.t.get(after) {
            Some(step) if (step - t).abs() <= near => Some((self.position[after], self.velocity[after])),
            Some(_) if after > 0 => Some(self.hermite(after - 1, after, t)),
            _ => None,
        }
    }

    /// The cubic polynomial between two instants, and its rate.
    fn hermite(&self, from: usize, to: usize, t: f64) -> ([f64; 2], [f64; 2]) {
        let h = self.t[to] - self.t[from];
        let s = (t - self.t[from]) / h;
        let component = |n: usize| {
            let (a, b) = (self.position[from][n], self.position[to][n]);
            let (u, v) = (h * self.velocity[from][n], h * self.velocity[to][n]);
            // a + s u + s² (3 (b − a) − 2 u − v) + s³ (2 (a − b) + u + v)
            let (square, cube) = (3.0 * (b - a) - 2.0 * u - v, 2.0 * (a - b) + u + v);
            (a + s * (u + s * (square + s * cube)), (u + s * (2.0 * square + 3.0 * s * cube)) / h)
        };
        let ((x, vx), (y, vy)) = (component(0), component(1));
        ([x, y], [vx, vy])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(steps: usize) -> Trace {
        let mut trace = Trace::default();
        for n in 0..=steps {
            let t = n as f64 / steps as f64;
            trace.push(t, [t.cos(), t.sin()], [-t.sin(), t.cos()]);
        }
        trace
    }

    /// A point on a circle: ⁴x = x, and the error is h⁴/384.
    #[test]
    fn a_step_is_interpolated_to_the_fourth_order_and_says_how_well() {
        for steps in [8, 16, 32] {
            let trace = circle(steps);
            let times: Vec<f64> = (1..=1000).map(|n| n as f64 * 1e-3).collect();
            let samples = trace.at(&times);
            let errors = times.iter().zip(&samples.position).map(|(t, r)| distance(*r, [t.cos(), t.sin()]));
            let (error, exact) = (errors.fold(0.0, f64::max), (steps as f64).powi(-4) / 384.0);
            assert!((error / exact - 1.0).abs() < 0.05, "{steps}: {error:e}, {exact:e}");
            assert!(
                (trace.interpolation_error() / exact - 1.0).abs() < 0.05,
                "{steps}: {:e}",
                trace.interpolation_error()
            );
            let rates = times.iter().zip(&samples.velocity).map(|(t, v)| distance(*v, [-t.sin(), t.cos()]));
            assert!(rates.fold(0.0, f64::max) < (steps as f64).powi(-3));
        }
    }

    #[test]
    fn ends_of_steps_are_taken_as_they_are_and_nothing_is_extrapolated() {
        let trace = circle(10);
        assert_eq!(trace.at(&[0.3 + 1e-17, 1.0]).position, [trace.position[3], trace.position[10]]);
        assert!(trace.at(&[0.5, 1.1]).position.is_empty() && Trace::default().at(&[0.0]).position.is_empty());
    }
}
