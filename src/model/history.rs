//! Histories: pairs [t, value] in order of time, linear in between.

/// Times from 0 to `end` between which all these histories are linear: both ends and the corners inside, in order.
pub fn times_of<'a>(histories: impl IntoIterator<Item = &'a [[f64; 2]]>, end: f64) -> Vec<f64> {
    let corners = histories.into_iter().flatten().map(|&[t, _]| t).filter(|t| *t > 0.0 && *t < end);
    let mut times: Vec<f64> = corners.chain([0.0, end]).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Value of a history at time `t`: linear between its pairs [t, value], constant outside; `None` if it is empty.
pub fn interpolate(history: &[[f64; 2]], t: f64) -> Option<f64> {
    let next = history.partition_point(|&[time, _]| time <= t);
    let before = next.checked_sub(1).and_then(|last| history.get(last));
    match (before, history.get(next)) {
        (Some(&[t0, from]), Some(&[t1, to])) => Some(from + (to - from) * ((t - t0) / (t1 - t0))),
        (Some(&[_, outside]), None) | (None, Some(&[_, outside])) => Some(outside),
        (None, None) => None,
    }
}
