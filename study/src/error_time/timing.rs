//! Run times: the median of several runs, after a first one that does not count.

use std::time::Instant;

use serde::Serialize;

use super::setup::{Record, Setup};
use crate::error::Result;
use ancf::run::{Run, run};

/// Least number of timed runs.
pub const RUNS: usize = 5;

/// Short runs are repeated up to this number of times, or for this long, s: a tick of the system clock is a large part of them.
const MORE_RUNS: (usize, f64) = (25, 0.02);

/// Wall times of identical runs.
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
    /// Median and extremes of these times, s; `None` if there are none.
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

/// One run that records positions only, and its time, s. The time includes building the structure, but not the scene.
///
/// # Errors
/// Those of the run.
pub fn timed(setup: &Setup) -> (Result<Run>, f64) {
    let scene = setup.scene(Record::Position);
    let clock = Instant::now();
    let run = scene.and_then(|scene| Ok(run(&scene)?));
    (run, clock.elapsed().as_secs_f64())
}

/// Times of a run that is known to succeed, s: [`RUNS`] or more, after a first one that does not count.
///
/// # Errors
/// Those of the run.
pub fn repeated(setup: &Setup) -> Result<Vec<f64>> {
    timed(setup).0?;
    let (most, enough) = MORE_RUNS;
    let mut times = Vec::new();
    while times.len() < RUNS || (times.len() < most && times.iter().sum::<f64>() < enough) {
        let (run, time) = timed(setup);
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
