//! Run times: the median of several runs after one that does not count.

use std::time::Instant;

use serde::Serialize;

use super::trial::{Record, Trial};
use crate::error::Result;
use ancf::run::{Run, run};

/// Runs that are timed at least.
pub const RUNS: usize = 5;

/// Short runs are repeated up to this number of times, or for this long, s: a single tick of the system is a good part of
/// them.
const MORE_RUNS: (usize, f64) = (25, 0.02);

/// Wall times of equal runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// Number of runs.
    pub runs: usize,
    /// Their median, s.
    pub median: f64,
    /// The shortest, s.
    pub min: f64,
    /// The longest, s.
    pub max: f64,
}

impl Timing {
    /// Of these times, s. `None` if there are none.
    pub fn of(times: &[f64]) -> Option<Timing> {
        let mut times = times.to_vec();
        times.sort_by(f64::total_cmp);
        let (&min, &max) = (times.first()?, times.last()?);
        let middle = times.len() / 2;
        let median =
            if times.len().is_multiple_of(2) { 0.5 * (times[middle - 1] + times[middle]) } else { times[middle] };
        Some(Timing { runs: times.len(), median, min, max })
    }
}

/// One run with what the error needs, and its time, s. The scene is built outside of the time, the structure inside.
///
/// # Errors
/// Those of the run.
pub fn timed(trial: &Trial) -> (Result<Run>, f64) {
    let scene = match trial.scene(Record::Position) {
        Ok(scene) => scene,
        Err(error) => return (Err(error), 0.0),
    };
    let clock = Instant::now();
    let run = run(&scene);
    (run.map_err(Into::into), clock.elapsed().as_secs_f64())
}

/// Times of a run that is known to succeed: one that does not count, then [`RUNS`] or more.
///
/// # Errors
/// Those of the run.
pub fn repeated(trial: &Trial) -> Result<Vec<f64>> {
    timed(trial).0?;
    let (most, enough) = MORE_RUNS;
    let mut times = Vec::new();
    while times.len() < RUNS || (times.len() < most && times.iter().sum::<f64>() < enough) {
        let (run, time) = timed(trial);
        run?;
        times.push(time);
    }
    Ok(times)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_with_its_spread() {
        let timing = Timing::of(&[3.0, 1.0, 9.0, 2.0, 4.0]).unwrap();
        assert_eq!((timing.runs, timing.median, timing.min, timing.max), (5, 3.0, 1.0, 9.0));
        assert_eq!(Timing::of(&[4.0, 1.0]).unwrap().median, 2.5);
        assert_eq!(Timing::of(&[]), None);
    }
}
