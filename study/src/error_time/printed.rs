//! The study as text on the standard output.

use super::economies::Economy;
use super::group::Group;
use super::point::{Point, Status};
use super::wording::{fastest, leads, ratio, seconds, time_of};
use crate::table::Format::{Fixed, Power, Words};
use crate::table::{Cell, Table, cells};

/// The economies.
pub fn economies(economies: &[Economy]) -> String {
    let columns = [
        ("left out", Words),
        ("ratio", Fixed(2)),
        ("least", Fixed(2)),
        ("most", Fixed(2)),
        ("without", Words),
        ("with", Words),
        ("change, m", Power(0)),
        ("scene", Words),
    ];
    let cells = |economy: &Economy| {
        let Economy { what, scene, pruned, full, difference } = economy;
        let (least, most) = (full.min / pruned.max, full.max / pruned.min);
        let times = [pruned, full].map(|time| seconds(time.median));
        cells![*what, economy.ratio(), least, most, &*times[0], &*times[1], *difference, &**scene]
    };
    let table = Table::new(columns, economies.iter().map(cells)).text();
    format!(
        "Economies: run time with the part over run time without it; least: shortest run with it over longest without, most: longest over \
         shortest\n{table}\n"
    )
}

/// A group: its counts, its reference, and the fastest point for each decade of error.
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
    let time = |point: Option<&Point>| Cell::from(time_of(point).unwrap_or_default());
    let cells = |(error, point): (f64, Option<&Point>)| {
        let ours = [cells![format!("≤ {error:.0e} m"), fastest(group, error, point)], vec![time(point), "".into()]];
        let theirs = group.peer(error).map(|peer| {
            let compared = group.ratio(error).map_or(String::new(), |found| ratio(&found));
            [cells!["", format!("{}: {}", peer.program, peer.what())], vec![time(Some(peer)), compared.into()]].concat()
        });
        std::iter::once(ours.concat()).chain(theirs)
    };
    let columns = [("error", Words), ("fastest", Words), ("time", Words), ("their time over ours", Words)];
    let columns = columns.into_iter().take(if group.peers.is_empty() { 3 } else { 4 });
    text += "\n";
    text += &Table::new(columns, group.decades().into_iter().flat_map(cells)).text();
    leads(&group.leads()).iter().for_each(|sentence| text += &format!("   {sentence}\n"));
    text + "\n"
}
