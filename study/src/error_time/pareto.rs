//! Pareto fronts, and the fastest points for an error.

use serde::Serialize;

use super::point::{Point, Status};
use super::timing::Timing;

/// Errors for which the fastest point is shown, as parts of a benchmark's unit.
pub const DECADES: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// The Pareto front: points that no other beats in both error and time, from the fastest to the most accurate. Failures and points at the
/// reference's limit are not on it.
pub fn pareto_front<'a>(points: &[&'a Point]) -> Vec<&'a Point> {
    let known = points.iter().copied().filter(|point| point.status == Status::Ok);
    let mut sorted: Vec<(f64, f64, &Point)> =
        known.filter_map(|point| Some((point.seconds()?, point.error()?, point))).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut least = f64::INFINITY;
    sorted.retain(|&(_, error, _)| {
        let better = error < least;
        least = least.min(error);
        better
    });
    sorted.into_iter().map(|(_, _, point)| point).collect()
}

/// The points that were timed in turns; all, if none was.
pub fn in_turns<'a>(points: &[&'a Point]) -> Vec<&'a Point> {
    let finalists: Vec<&Point> = points.iter().copied().filter(|point| point.in_turns()).collect();
    if finalists.is_empty() { points.to_vec() } else { finalists }
}

/// The fastest point whose [bound](Point::bound) is at most this error; points that were timed only once do not count.
pub fn fastest<'a>(points: &[&'a Point], error: f64) -> Option<&'a Point> {
    let timed_well = points.iter().copied().filter(|point| point.status != Status::Outclassed);
    let enough = timed_well.filter(|point| point.bound().is_some_and(|bound| bound <= error));
    let timed = enough.filter_map(|point| Some((point.seconds()?, point)));
    timed.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, point)| point)
}

/// Times within this factor are equal, as far as a busy machine can measure.
const TIE: f64 = 1.1;

/// A range of errors in which one family of methods is faster, m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lead {
    /// The largest error of the range.
    pub from: f64,
    /// Its least error.
    pub to: f64,
    /// Whether the explicit methods are faster.
    pub explicit: bool,
    /// Least and largest ratio of the slower family's times to the faster one's; `None` if the slower one was never as accurate.
    pub ratio: Option<[f64; 2]>,
}

/// The faster family of methods, explicit or implicit, from large errors to small: compares the fastest points of both at every measured
/// error.
pub fn leads(points: &[&Point]) -> Vec<Lead> {
    let (explicit, implicit): (Vec<&Point>, Vec<&Point>) = points.iter().partition(|point| point.explicit);
    let mut errors: Vec<f64> = points.iter().filter_map(|point| point.bound()).collect();
    errors.sort_by(|a, b| b.total_cmp(a));
    let mut leads: Vec<Lead> = Vec::new();
    for error in errors {
        let [ours, theirs] = [&explicit, &implicit].map(|family| fastest(family, error).and_then(Point::seconds));
        let (leader, ratio) = match (ours, theirs) {
            (Some(a), Some(b)) if a < TIE * b && b < TIE * a => continue,
            (Some(a), Some(b)) => (a < b, Some(f64::max(a, b) / f64::min(a, b))),
            (Some(_), None) => (true, None),
            (None, Some(_)) => (false, None),
            (None, None) => continue,
        };
        match leads.last_mut() {
            Some(lead) if lead.explicit == leader && lead.ratio.is_some() == ratio.is_some() => {
                lead.to = error;
                lead.ratio = lead.ratio.zip(ratio).map(|([least, most], ratio)| [least.min(ratio), most.max(ratio)]);
            }
            _ => leads.push(Lead { from: error, to: error, explicit: leader, ratio: ratio.map(|ratio| [ratio; 2]) }),
        }
    }
    leads
}

/// Run time of another program over ours at equal error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ratio {
    /// The error that bounds both, m.
    pub error: f64,
    /// Ratio of the medians.
    pub ratio: f64,
    /// Their lower quartile over our upper one.
    pub least: f64,
    /// Their upper quartile over our lower one.
    pub most: f64,
}

impl Ratio {
    /// One run time over another.
    pub fn of(error: f64, time: &Timing, other: &Timing) -> Ratio {
        let ratio = time.median / other.median;
        Ratio { error, ratio, least: time.lower / other.upper, most: time.upper / other.lower }
    }
}

/// Ratio of the fastest points of two programs at this error; `None` if one of them has none.
pub fn ratio(ours: &[&Point], theirs: &[&Point], error: f64) -> Option<Ratio> {
    Some(Ratio::of(error, fastest(theirs, error)?.time.as_ref()?, fastest(ours, error)?.time.as_ref()?))
}
