//! The finalists of a scene: candidates for the fastest point of each accuracy, ours and another program's, timed in turns.

use std::cell::RefCell;

use super::pareto::DECADES;
use super::peer::{Answer, Peer};
use super::peers::PeerPoint;
use super::point::{Point, Status};
use super::setup::Setup;
use super::timing::{Lap, timed};
use super::turns::{Runner, take_turns};
use crate::error::{Error, Result};

/// A candidate may take this many times as long as the fastest one in its first runs: those may have been disturbed.
const CANDIDATE: f64 = 1.25;

/// Candidates for each accuracy.
const MOST: usize = 2;

/// Times the finalists of all families in turns, and gives their points the new times. A family is an element of a program: candidates are
/// the fastest of its points.
///
/// # Errors
/// Those of the runs.
pub fn hold(
    unit: f64,
    ours: &mut [Vec<(Setup, Point)>],
    theirs: &mut [PeerPoint],
    peer: Option<&mut Peer>,
) -> Result<()> {
    let peer = RefCell::new(peer);
    let mut runners: Vec<Runner> = Vec::new();
    let mut points: Vec<&mut Point> = Vec::new();
    let chosen: Vec<Vec<usize>> =
        ours.iter().map(|family| candidates(unit, family.iter().map(|(_, point)| point))).collect();
    for (family, chosen) in ours.iter_mut().zip(&chosen) {
        for (setup, point) in pick(family, chosen) {
            let setup = *setup;
            runners.push(Box::new(move || {
                let (run, lap) = timed(&setup);
                run.map(|_| lap)
            }));
            points.push(point);
        }
    }
    let mut elements: Vec<String> = theirs.iter().map(|peer| peer.point.element.clone()).collect();
    elements.dedup();
    let mut chosen = Vec::new();
    for element in elements {
        let family: Vec<(usize, &Point)> = theirs
            .iter()
            .enumerate()
            .map(|(n, peer)| (n, &peer.point))
            .filter(|(_, point)| point.element == element)
            .collect();
        let found = candidates(unit, family.iter().map(|(_, point)| *point));
        chosen.extend(found.into_iter().map(|n| family[n].0));
    }
    for PeerPoint { id, point } in pick(theirs, &chosen) {
        let (id, peer) = (*id, &peer);
        runners.push(Box::new(move || lap(peer.borrow_mut().as_deref_mut(), id)));
        points.push(point);
    }
    for (point, timing) in points.into_iter().zip(take_turns(&mut runners)?) {
        point.time = timing;
    }
    Ok(())
}

/// Places of the candidates.
fn candidates<'a>(unit: f64, family: impl Iterator<Item = &'a Point>) -> Vec<usize> {
    let known: Vec<(usize, f64, f64)> = family
        .enumerate()
        .filter(|(_, point)| point.status != Status::Outclassed)
        .filter_map(|(n, point)| Some((n, point.bound()?, point.seconds()?)))
        .collect();
    let mut chosen = Vec::new();
    for decade in DECADES.map(|decade| decade * unit) {
        let mut able: Vec<_> = known.iter().filter(|(_, bound, _)| *bound <= decade).collect();
        able.sort_by(|a, b| a.2.total_cmp(&b.2));
        let fastest = able.first().map_or(0.0, |(.., time)| *time);
        chosen.extend(
            able.into_iter().take_while(|(.., time)| *time <= CANDIDATE * fastest).take(MOST).map(|(n, ..)| *n),
        );
    }
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

fn pick<'a, T>(all: &'a mut [T], chosen: &'a [usize]) -> impl Iterator<Item = &'a mut T> {
    all.iter_mut().enumerate().filter(|(n, _)| chosen.contains(n)).map(|(_, one)| one)
}

fn lap(peer: Option<&mut Peer>, id: usize) -> Result<Lap> {
    let gone = |reason: &str| Error::Peer { command: super::peer::COMMAND.into(), reason: reason.into() };
    match peer.ok_or_else(|| gone("it has ended"))?.run(id, false)? {
        Answer::Done { lap, .. } => Ok(lap),
        Answer::Failed { failed } => Err(gone(&failed)),
    }
}
