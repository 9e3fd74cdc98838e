//! Runs that take turns on one core, so that slow phases of the machine meet all of them.

use std::time::Instant;

use super::timing::{Lap, Timing, yardstick};
use crate::error::Result;

/// Least and largest number of rounds, and the time after which there is no other one once there were enough, s.
const ROUNDS: (usize, usize) = (7, 15);
const ENOUGH: f64 = 20.0;

/// Times that a disturbed run is made again, and the time after which none is, s: on a machine that is never quiet a study has to end, too.
const AGAIN: usize = 3;
const PATIENCE: f64 = 40.0;

/// The yardstick's time over its least, above which the core is slower than usual.
const SLOW: f64 = 1.1;

/// One that takes turns.
pub type Runner<'a> = Box<dyn FnMut() -> Result<Lap> + 'a>;

/// Times of all runners, after a round that does not count. A run is disturbed if another program used the core meanwhile, or if the yardstick
/// took longer than usual before or after it; it is made again, up to [`AGAIN`] times.
///
/// # Errors
/// Those of the runs.
pub fn take_turns(runners: &mut [Runner]) -> Result<Vec<Option<Timing>>> {
    let mut best = (0..5).map(|_| yardstick()).fold(f64::INFINITY, f64::min);
    runners.iter_mut().try_for_each(|runner| runner().map(|_| ()))?;
    let mut times = vec![(Vec::new(), 0); runners.len()];
    let (least, most) = ROUNDS;
    let begun = Instant::now();
    for round in 0..most {
        if round >= least && begun.elapsed().as_secs_f64() > ENOUGH {
            break;
        }
        for (runner, (laps, disturbed)) in runners.iter_mut().zip(&mut times) {
            let again = if begun.elapsed().as_secs_f64() < PATIENCE { AGAIN } else { 0 };
            for attempt in 0..=again {
                let before = yardstick();
                let lap = runner()?;
                let slower = before.max(yardstick());
                best = best.min(before);
                let is_quiet = !lap.is_shared() && slower <= SLOW * best;
                if is_quiet || attempt == again {
                    *disturbed += usize::from(!is_quiet);
                    laps.push(lap.computed);
                    break;
                }
            }
        }
    }
    let timing = |(laps, disturbed): (Vec<f64>, usize)| {
        Timing::of(&laps).map(|timing| Timing { disturbed, in_turns: true, ..timing })
    };
    Ok(times.into_iter().map(timing).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    #[test]
    fn runners_take_turns_and_disturbed_runs_are_made_again() {
        let order = RefCell::new(Vec::new());
        let runner = |name: char, computed: f64| -> Runner {
            let order = &order;
            Box::new(move || {
                order.borrow_mut().push(name);
                Ok(Lap { seconds: 1.0, computed })
            })
        };
        // The second one has half of the core.
        let timings = take_turns(&mut [runner('a', 1.0), runner('b', 0.5)]).unwrap();
        let [Some(a), Some(b)] = &timings[..] else { panic!("{timings:?}") };
        assert_eq!((a.runs, a.median, b.runs, b.median, b.disturbed), (ROUNDS.1, 1.0, ROUNDS.1, 0.5, ROUNDS.1));
        assert!(a.in_turns && b.in_turns);
        let order: String = order.borrow().iter().collect();
        assert!(order.starts_with("ab") && order.matches('b').count() == 1 + (1 + AGAIN) * ROUNDS.1, "{order}");
        assert!(order.matches("bbbb").count() == ROUNDS.1 && !order.ends_with('a'), "{order}");
    }
}
