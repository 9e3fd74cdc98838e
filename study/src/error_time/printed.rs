//! The study as text on the standard output.

use super::group::Group;
use super::point::{Point, Status};
use super::wording::{advice, fastest, leads, ratio, time_of};
use crate::table::{Cell, Table, cells};

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
    let peers = if group.peers.is_empty() { "" } else { " | their time over ours" };
    let columns = format!("error | fastest | time{peers}");
    text += "\n";
    text += &Table::new(&columns, group.decades().into_iter().flat_map(cells)).text();
    if group.is_own {
        advice(group).iter().for_each(|line| text += &format!("   {line}\n"));
    }
    leads(&group.leads()).iter().for_each(|sentence| text += &format!("   {sentence}\n"));
    text + "\n"
}
