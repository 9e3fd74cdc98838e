//! Which points are worth their time.

use serde::Serialize;

use super::point::{Point, Status};

/// Errors that a person may ask for, m.
pub const DECADES: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// The Pareto front: points that no other beats in both error and time, from the fastest to the most accurate. Failures, and
/// points whose error is the reference's as much as their own, are not on it.
pub fn front<'a>(points: &[&'a Point]) -> Vec<&'a Point> {
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

/// The fastest point that is proved to be at least this accurate, see [`Point::bound`]; those that were timed only once do not
/// count.
pub fn fastest<'a>(points: &[&'a Point], error: f64) -> Option<&'a Point> {
    let timed_well = points.iter().copied().filter(|point| point.status != Status::Outclassed);
    let enough = timed_well.filter(|point| point.bound().is_some_and(|bound| bound <= error));
    let timed = enough.filter_map(|point| Some((point.seconds()?, point)));
    timed.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, point)| point)
}

/// Times closer than this factor are the same as far as a busy machine can tell.
const TIE: f64 = 1.1;

/// A range of errors in which one family of methods is the faster one, m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lead {
    /// The largest error of the range.
    pub from: f64,
    /// Its least error.
    pub to: f64,
    /// Whether the explicit methods are faster.
    pub explicit: bool,
    /// Times of the slower family over those of the faster, least and largest; `None` where the slower one never got there.
    pub ratio: Option<[f64; 2]>,
}

/// Where explicit methods are faster than implicit ones, from large errors to small: at every error that was measured, the
/// fastest of each family that is as accurate.
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

/// How many times faster we are than another program at equal error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ratio {
    /// The error that both are proved to be below, m.
    pub error: f64,
    /// Their median over ours.
    pub ratio: f64,
    /// Their shortest run over our longest.
    pub least: f64,
    /// Their longest run over our shortest.
    pub most: f64,
}

/// The ratio of the fastest points of two programs that are at least this accurate; `None` if one of them has none.
pub fn ratio(ours: &[&Point], theirs: &[&Point], error: f64) -> Option<Ratio> {
    let (ours, theirs) = (fastest(ours, error)?.time.as_ref()?, fastest(theirs, error)?.time.as_ref()?);
    Some(Ratio { error, ratio: theirs.median / ours.median, least: theirs.min / ours.max, most: theirs.max / ours.min })
}
