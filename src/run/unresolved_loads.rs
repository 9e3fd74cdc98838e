//! Loads that steps do not resolve: what comes and goes within a step is seen at neither of its ends.
//!
//! A history is cut into stretches on which it rises, falls or stays constant. A ramp shorter than a step still shows
//! afterwards by its effect, but a second short stretch next to it may undo it before the step ends. Fixed-step methods
//! then miss a pulse altogether, and take a fast wave for a constant load. They also may if stretches are as long as a
//! step and turn within steps: a wave half a step out of phase is zero at each end. Adaptive methods end a step at each
//! corner, unless corners are closer than rounding of times. A change that begins within the last step is missed
//! likewise: the end takes the place of the second stretch.

use crate::integrators::same_time;
use crate::model::{Method, Scene, Start, interpolate, times_of};

/// Relative difference of lengths that count as equal: digits lost in writing times.
const LENGTH_TOLERANCE: f64 = 1e-6;

/// Largest distance of a corner from the end of a step, in steps, at which it is resolved: the error of a scene's
/// times.
const END_TOLERANCE: f64 = 1e-3;

/// Stretch of a history that steps may miss.
#[derive(Clone, Debug, PartialEq)]
pub struct UnresolvedLoad {
    /// Name of the history, in words.
    pub what: String,
    /// Length of the shortest such stretch, s.
    pub length: f64,
}

/// History with the shortest stretch that steps of length `step` (s) may miss; `None` if they miss none. Adaptive
/// methods miss only what is within rounding of times.
pub fn unresolved_load(scene: &Scene, step: f64) -> Option<UnresolvedLoad> {
    let step = match scene.time.method {
        Method::Static => return None,
        method if method.is_adaptive() => same_time(scene.time.end),
        _ => step,
    };
    let forces = scene.forces.iter().filter_map(|force| {
        let history = force.history.as_deref()?;
        Some((format!("the force at `{}`", force.point), history, false))
    });
    let heats = scene.rods.iter().filter_map(|rod| {
        let heat = scene.heat(rod)?;
        Some((
            format!("the temperature of the rod `{}`", rod.name),
            heat.history.as_slice(),
            heat.start == Start::Relaxed,
        ))
    });
    let short = forces.chain(heats).filter_map(|(what, history, relaxed)| {
        let mut turns = turning_times(history, scene.time.end, relaxed);
        if begins_last(history, &turns) {
            turns.push(scene.time.end);
        }
        let pairs = turns.windows(3).filter(|turns| is_missed(turns, step));
        // The jump at the start has no length.
        let length = pairs.flat_map(lengths).filter(|length| *length > 0.0).reduce(f64::min)?;
        Some(UnresolvedLoad { what, length })
    });
    short.min_by(|a, b| a.length.total_cmp(&b.length))
}

/// Whether the last stretch before the end is a change: within the last step nothing of its effect would show.
fn begins_last(history: &[[f64; 2]], turns: &[f64]) -> bool {
    let value = |t: &f64| interpolate(history, *t).unwrap_or(0.0);
    turns.len() > 2 && turns.windows(2).next_back().is_some_and(|ends| value(&ends[0]) != value(&ends[1]))
}

/// Whether two adjacent stretches, between these times, come and go unseen.
fn is_missed(turns: &[f64], step: f64) -> bool {
    let all_below = |share: f64| lengths(turns).all(|length| length < share * step);
    let within = |t: &f64| (t / step - (t / step).round()).abs() > END_TOLERANCE;
    all_below(1.0 - LENGTH_TOLERANCE) || all_below(1.0 + LENGTH_TOLERANCE) && turns.iter().any(within)
}

fn lengths(turns: &[f64]) -> impl Iterator<Item = f64> {
    turns.windows(2).map(|ends| ends[1] - ends[0])
}

/// Times between which a history rises, falls or stays constant, from start to end, s. The initial value is a jump of
/// no duration, except for the heat of a relaxed start.
fn turning_times(history: &[[f64; 2]], end: f64, relaxed: bool) -> Vec<f64> {
    let value = |t: f64| interpolate(history, t).unwrap_or(0.0);
    let times = times_of([history], end);
    let jump = if relaxed { 0.0 } else { value(0.0) };
    let changes = times.windows(2).map(|ends| (value(ends[1]) - value(ends[0]), ends[1]));
    let (mut turns, mut before) = (vec![0.0], None);
    for (change, t) in [(jump, 0.0)].into_iter().filter(|(jump, _)| *jump != 0.0).chain(changes) {
        let trend = change.partial_cmp(&0.0);
        match turns.last_mut() {
            Some(last) if before == Some(trend) => *last = t,
            _ => turns.push(t),
        }
        before = Some(trend);
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::{begins_last, is_missed, lengths, turning_times};

    #[test]
    fn a_load_that_begins_with_the_end_is_missed() {
        let begins = |history: &[[f64; 2]]| begins_last(history, &turning_times(history, 1.0, false));
        assert!(begins(&[[0.9, 0.0], [1.1, 1.0]]) && begins(&[[0.0, 0.0], [0.9, 0.0], [1.0, 1.0]]));
        // One that grows all the time, one that has come to rest, one after the end.
        assert!(
            !begins(&[[0.0, 0.0], [1.0, 1.0]])
                && !begins(&[[0.8, 0.0], [0.9, 1.0]])
                && !begins(&[[1.0, 0.0], [2.0, 1.0]])
        );
    }

    #[test]
    fn histories_are_cut_where_they_turn() {
        let stretches =
            |history: &[[f64; 2]], relaxed| -> Vec<f64> { lengths(&turning_times(history, 1.0, relaxed)).collect() };
        let cut = |history: &[[f64; 2]]| stretches(history, false);
        assert_eq!(cut(&[[0.25, 0.0], [0.5, 1.0], [0.75, 0.0]]), [0.25, 0.25, 0.25, 0.25]);
        // A rise that continues is one stretch; what is after the end is none.
        assert_eq!(cut(&[[0.25, 0.0], [0.5, 1.0], [0.75, 3.0], [2.0, 8.0], [3.0, 0.0]]), [0.25, 0.75]);
        assert_eq!(cut(&[[0.0, 1.0], [0.25, 0.0]]), [0.0, 0.25, 0.75]);
        assert_eq!(stretches(&[[0.0, 1.0], [0.25, 0.0]], true), [0.25, 0.75]);
        // A load that grows from the start on.
        assert_eq!(cut(&[[0.0, 0.0], [0.25, 1.0]]), [0.25, 0.75]);
        assert_eq!(cut(&[[0.0, 1.0], [0.25, 2.0]]), [0.25, 0.75]);
    }

    #[test]
    fn stretches_of_a_step_are_missed_between_its_ends_only() {
        assert!(is_missed(&[0.5, 1.5, 2.5], 1.0) && !is_missed(&[1.0, 2.0, 3.0], 1.0));
        // As written with few digits, and after many steps.
        assert!(is_missed(&[0.5, 1.500_000_1, 2.5], 1.0) && !is_missed(&[1e6 + 1e-4, 1e6 + 1.0, 1e6 + 2.0], 1.0));
        assert!(!is_missed(&[0.5, 1.5, 2.6], 1.0));
        // Gone before the step ends, although it turns at the end of one.
        assert!(is_missed(&[1.0, 1.0005, 1.001], 1.0) && is_missed(&[0.0, 0.0, 0.5], 1.0));
        assert!(!is_missed(&[0.0, 0.0, 1.0], 1.0));
    }
}
