//! Run times: processor time of one core, the median of several runs.

use std::hint::black_box;
use std::time::Instant;

use serde::{Deserialize, Serialize};

use super::clock;
use super::setup::{Record, Setup};
use crate::error::Result;
use ancf::run::{Run, run};

/// Number of timed runs of a point that is no finalist.
const RUNS: usize = 3;

/// Wall time over processor time from which on another program has used the core meanwhile, and what starting a clock takes, s.
const SHARED: (f64, f64) = (1.2, 2e-4);

/// Times of identical runs, s.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// Number of runs.
    pub runs: usize,
    /// Their median.
    pub median: f64,
    /// Lower quartile.
    pub lower: f64,
    /// Upper quartile.
    pub upper: f64,
    /// Runs that were disturbed every time.
    pub disturbed: usize,
    /// Whether the runs took turns with those they are compared with.
    pub in_turns: bool,
}

/// One run's time.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
pub struct Lap {
    /// By the wall, s.
    pub seconds: f64,
    /// Of the core, s: what counts, as others on the core do not lengthen it.
    pub computed: f64,
}

impl Lap {
    /// Time of a job on this thread.
    pub fn of<T>(job: impl FnOnce() -> T) -> (T, Lap) {
        let (wall, core) = (Instant::now(), clock::seconds());
        let result = job();
        let computed = clock::seconds() - core;
        (result, Lap { seconds: wall.elapsed().as_secs_f64(), computed })
    }

    /// Whether another program has used the core meanwhile.
    pub fn is_shared(&self) -> bool {
        let (factor, start) = SHARED;
        self.seconds > factor * self.computed + start
    }
}

impl Timing {
    /// Median and quartiles of these times, s; `None` if there are none.
    pub fn of(times: &[f64]) -> Option<Timing> {
        let mut times = times.to_vec();
        times.sort_by(f64::total_cmp);
        let last = times.len().checked_sub(1)?;
        let at = |part: f64| {
            let place = part * last as f64;
            let below = place.floor() as usize;
            times[below] + (place - place.floor()) * (times[last.min(below + 1)] - times[below])
        };
        let [lower, median, upper] = [0.25, 0.5, 0.75].map(at);
        Some(Timing { runs: times.len(), median, lower, upper, disturbed: 0, in_turns: false })
    }
}

/// Time of a fixed piece of work, s: it takes longer when the core is slower than usual, which no clock of the core's own time shows.
pub fn yardstick() -> f64 {
    const ROUNDS: u32 = 100_000;
    let work = || (0..ROUNDS).fold(1.0f64, |sum, n| black_box(sum * 0.999_999 + f64::from(n)));
    Lap::of(|| black_box(work())).1.computed
}

/// One run that records positions only, and its time. The time includes building the structure, but not the scene.
///
/// # Errors
/// Those of the run.
pub fn timed(setup: &Setup) -> (Result<Run>, Lap) {
    let scene = setup.scene(Record::Position);
    Lap::of(|| scene.and_then(|scene| Ok(run(&scene)?)))
}

/// Times of a run that is known to succeed, s.
///
/// # Errors
/// Those of the run.
pub fn repeated(setup: &Setup) -> Result<Vec<f64>> {
    let once = |_| {
        let (run, lap) = timed(setup);
        run.map(|_| lap.computed)
    };
    (0..RUNS).map(once).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_with_its_quartiles() {
        let timing = Timing::of(&[3.0, 1.0, 9.0, 2.0, 4.0]).unwrap();
        assert_eq!((timing.runs, timing.lower, timing.median, timing.upper), (5, 2.0, 3.0, 4.0));
        assert_eq!(Timing::of(&[4.0, 1.0]).unwrap().median, 2.5);
        assert_eq!(Timing::of(&[]), None);
    }

    #[test]
    fn a_shared_core_is_noticed() {
        assert!(Lap { seconds: 2.0, computed: 1.0 }.is_shared() && !Lap { seconds: 1.1, computed: 1.0 }.is_shared());
        let (_, lap) = Lap::of(|| std::thread::sleep(std::time::Duration::from_millis(20)));
        assert!(lap.seconds >= 0.02 && (cfg!(not(target_os = "linux")) || lap.is_shared()));
        assert!(yardstick() > 0.0);
    }
}
