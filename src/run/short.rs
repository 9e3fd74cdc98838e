//! Loads between the steps: what comes and goes within a step is seen by none of its ends.
//!
//! A history is cut into stretches on which it rises, falls or stays. A ramp shorter than a step is seen afterwards by what it has
//! led to; a second short stretch beside it may take that back before a step ends. Methods of fixed steps then miss a pulse
//! altogether, and take a fast wave for a constant load. Methods that choose their steps make one end at each corner.

use std::cmp::Ordering;

use crate::scene::{Method, Scene, Start, interpolate, times_of};

/// Lengths that differ by less than this part of a step are as long as it: what times lose in writing.
const ROUNDED: f64 = 1e-6;

/// A stretch of a history that steps may miss.
#[derive(Clone, Debug, PartialEq)]
pub struct Short {
    /// Which history.
    pub what: String,
    /// Length of the shortest of such stretches of it, s.
    pub length: f64,
}

/// The history with the shortest stretch that steps of a length (s) may miss; `None` where they miss none.
pub fn missed(scene: &Scene, step: f64) -> Option<Short> {
    if scene.time.method == Method::Static || scene.time.method.is_adaptive() {
        return None;
    }
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
        let stretches = stretches(history, scene.time.end, relaxed);
        let is_short = |length: f64| length < (1.0 - ROUNDED) * step;
        let pairs = stretches.windows(2).filter(|pair| pair.iter().all(|length| is_short(*length)));
        // The jump at the start has no length.
        let length = pairs.flatten().copied().filter(|length| *length > 0.0).reduce(f64::min)?;
        Some(Short { what, length })
    });
    short.min_by(|a, b| a.length.total_cmp(&b.length))
}

/// Lengths of the stretches on which a history rises, falls or stays, from the start to the end, s. What is there at the start has come
/// within no time, but for the heat of a relaxed start.
fn stretches(history: &[[f64; 2]], end: f64, relaxed: bool) -> Vec<f64> {
    let value = |t: f64| interpolate(history, t).unwrap_or(0.0);
    let times = times_of([history], end);
    let jump = if relaxed { 0.0 } else { value(0.0) };
    let changes = times.windows(2).map(|ends| (value(ends[1]) - value(ends[0]), ends[1] - ends[0]));
    let mut stretches: Vec<(Option<Ordering>, f64)> = Vec::new();
    for (change, length) in [(jump, 0.0)].into_iter().filter(|(jump, _)| *jump != 0.0).chain(changes) {
        let way = change.partial_cmp(&0.0);
        match stretches.last_mut() {
            Some((before, whole)) if *before == way => *whole += length,
            _ => stretches.push((way, length)),
        }
    }
    stretches.into_iter().map(|(_, length)| length).collect()
}

#[cfg(test)]
mod tests {
    use super::stretches;

    #[test]
    fn histories_are_cut_where_they_turn() {
        let cut = |history: &[[f64; 2]]| stretches(history, 1.0, false);
        assert_eq!(cut(&[[0.25, 0.0], [0.5, 1.0], [0.75, 0.0]]), [0.25, 0.25, 0.25, 0.25]);
        // What goes on rising is one stretch; what is after the end is none.
        assert_eq!(cut(&[[0.25, 0.0], [0.5, 1.0], [0.75, 3.0], [2.0, 8.0], [3.0, 0.0]]), [0.25, 0.75]);
        assert_eq!(cut(&[[0.0, 1.0], [0.25, 0.0]]), [0.0, 0.25, 0.75]);
        assert_eq!(stretches(&[[0.0, 1.0], [0.25, 0.0]], 1.0, true), [0.25, 0.75]);
        // A load that grows from the start on.
        assert_eq!(cut(&[[0.0, 0.0], [0.25, 1.0]]), [0.25, 0.75]);
        assert_eq!(cut(&[[0.0, 1.0], [0.25, 2.0]]), [0.25, 0.75]);
    }
}
