//! Numbers in words, and the study as a table on the standard output.

use super::economies::Economy;
use super::group::Group;
use super::pareto::{Lead, Ratio};
use super::point::{Point, Status};
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

/// A median with its spread.
pub fn timing(time: Option<&Timing>) -> String {
    let words = |time: &Timing| format!("{} ({} … {})", seconds(time.median), seconds(time.min), seconds(time.max));
    time.map_or("–".into(), words)
}

/// A ratio with its spread.
pub fn ratio(ratio: &Ratio) -> String {
    let Ratio { ratio, least, most, .. } = ratio;
    format!("{} × ({} … {})", digits(*ratio), digits(*least), digits(*most))
}

fn digits(ratio: f64) -> String {
    if ratio < 10.0 { format!("{ratio:.2}") } else { format!("{ratio:.0}") }
}

/// Where explicit methods lead, in sentences.
pub fn leads(leads: &[Lead]) -> Vec<String> {
    let sentence = |lead: &Lead| {
        let (faster, slower) = if lead.explicit { ("explicit", "implicit") } else { ("implicit", "explicit") };
        let [from, to] = [lead.from, lead.to].map(|error| format!("{error:.1e}"));
        let range = if from == to { format!("errors of {from} m") } else { format!("errors of {from} … {to} m") };
        match lead.ratio {
            Some([least, most]) if most < 1.05 * least => format!("{range}: {faster} is faster, by {most:.1}"),
            Some([least, most]) => format!("{range}: {faster} is faster, by {least:.1} … {most:.1}"),
            None => format!("{range}: only {faster} methods get there, no {slower} one does in the grid"),
        }
    };
    leads.iter().map(sentence).collect()
}

/// Why there is no point for a decade.
pub fn nothing(group: &Group, error: f64) -> String {
    if error < group.reference.uncertainty {
        format!("the reference is known to {:.0e} m only", group.reference.uncertainty)
    } else {
        "no point of the grid proves to be as accurate".into()
    }
}

/// What economies save.
pub fn economies(economies: &[Economy]) -> String {
    let mut text = String::from(
        "What is left out, and how many times as long a run takes with it (shortest over longest run, and the other way round):\n",
    );
    for economy in economies {
        let Economy { what, scene, pruned, full, difference } = economy;
        text += &format!(
            "   {what:52} {:5.2} × ({:.2} … {:.2}; {} → {}); changes {difference:.0e} m; {scene}\n",
            economy.ratio(),
            full.min / pruned.max,
            full.max / pruned.min,
            seconds(full.median),
            seconds(pruned.median),
        );
    }
    text + "\n"
}

/// The compact table of one group.
pub fn group(group: &Group) -> String {
    let reference = &group.reference;
    let mut text = format!(
        "{}: {} points, {} outclassed, {} at the reference's limit, {} failed; reference {} elements ± {:.1e} m",
        group.name(),
        group.points.len(),
        group.count(Status::Outclassed),
        group.count(Status::AtLimit),
        group.count(Status::Failed),
        reference.elements,
        reference.uncertainty
    );
    if let Some(model) = &group.model {
        text += &format!(", {:.1e} ± {:.0e} m from {}", model.distance, model.uncertainty, model.continuum);
    }
    text += "\n";
    for (error, point) in group.decades() {
        let words = |point: &Point| format!("{:68} {}", point.what(), timing(point.time.as_ref()));
        text += &format!("   ≤ {error:.0e} m  {}\n", point.map_or_else(|| nothing(group, error), words));
        if let Some(peer) = group.peer(error) {
            let what = format!("{}: {}", peer.program, peer.what());
            let compared = group.ratio(error).map_or(String::new(), |found| format!("; {}", ratio(&found)));
            text += &format!("             {what:68} {}{compared}\n", timing(peer.time.as_ref()));
        }
    }
    for sentence in leads(&group.leads()).iter().filter(|_| group.points.iter().any(|point| point.explicit)) {
        text += &format!("   {sentence}\n");
    }
    text + "\n"
}
