//! Times, ratios and leads in words.

use super::group::Group;
use super::pareto::{Lead, Ratio};
use super::point::Point;
use super::timing::Timing;

/// A time with its unit, two or three digits.
pub fn seconds(time: f64) -> String {
    match time {
        t if t < 1e-3 => format!("{:.0} µs", 1e6 * t),
        t if t < 1e-2 => format!("{:.2} ms", 1e3 * t),
        t if t < 1e-1 => format!("{:.1} ms", 1e3 * t),
        t if t < 1.0 => format!("{:.0} ms", 1e3 * t),
        t => format!("{t:.2} s"),
    }
}

/// A median with its quartiles.
pub fn timing(time: &Timing) -> String {
    format!("{} ({} … {})", seconds(time.median), seconds(time.lower), seconds(time.upper))
}

/// Run time of a point.
pub fn time_of(point: Option<&Point>) -> Option<String> {
    point?.time.as_ref().map(timing)
}

/// A ratio with its quartiles.
pub fn ratio(ratio: &Ratio) -> String {
    let digits = |ratio: f64| if ratio < 10.0 { format!("{ratio:.2}") } else { format!("{ratio:.0}") };
    format!("{} × ({} … {})", digits(ratio.ratio), digits(ratio.least), digits(ratio.most))
}

/// Ratio of two run times, from the lower over the upper quartile to the upper over the lower.
pub fn ratio_of(time: &Timing, other: &Timing) -> String {
    ratio(&Ratio::of(0.0, time, other))
}

/// A sentence for each lead.
pub fn leads(leads: &[Lead]) -> Vec<String> {
    let sentence = |lead: &Lead| {
        let (faster, slower) = if lead.explicit { ("explicit", "implicit") } else { ("implicit", "explicit") };
        let [from, to] = [lead.from, lead.to].map(|error| format!("{error:.1e}"));
        let range = if from == to { format!("errors of {from} m") } else { format!("errors of {from} … {to} m") };
        match lead.ratio {
            Some([least, most]) if most < 1.05 * least => format!("{range}: {faster} is faster, by {most:.1}"),
            Some([least, most]) => format!("{range}: {faster} is faster, by {least:.1} … {most:.1}"),
            None => format!("{range}: only {faster} methods are as accurate, no {slower} one of the grid is"),
        }
    };
    leads.iter().map(sentence).collect()
}

/// For each decade of error the lines of a scene file that reach it fastest.
pub fn advice(group: &Group) -> Vec<String> {
    let line = |(error, point): (f64, Option<&Point>)| {
        let point = point?;
        let step = match (point.step, point.tolerance) {
            (_, Some(tolerance)) => format!(", \"tolerance\": {tolerance:e}"),
            (Some(step), None) if point.method == "static" => format!(", \"load_steps\": {:.0}", 1.0 / step),
            (step, None) => step.map_or(String::new(), |step| format!(", \"step\": {step:?}")),
        };
        let newton =
            point.newton_tolerance.map_or(String::new(), |newton| format!(", \"newton_tolerance\": {newton:e}"));
        let method = &point.method;
        Some(format!(
            "{}, errors below {error:.0e} m: \"elements\": {} in each rod, \"time\": {{\"method\": \"{method}\"{step}{newton}}}",
            group.name(),
            point.elements
        ))
    };
    group.decades().into_iter().filter_map(line).collect()
}

/// Our fastest point for an error, or the reason why there is none.
pub fn fastest(group: &Group, error: f64, point: Option<&Point>) -> String {
    let uncertainty = group.reference.uncertainty;
    match point {
        Some(point) => point.what(),
        None if error < uncertainty => format!("the reference is known to {uncertainty:.0e} m only"),
        None => "no point of the grid is certain to be as accurate".into(),
    }
}
