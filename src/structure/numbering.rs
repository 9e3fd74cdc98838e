//! Which unknown each coordinate is: elements that meet are numbered close together, so that the matrices' band is narrow.

use std::collections::VecDeque;

use super::Kind;

/// A nodal vector of the structure: what it measures, and which components a support holds.
pub(super) struct NodalVector {
    pub kind: Kind,
    pub held: [bool; 2],
}

/// An element's seven nodal vectors, in the order of (4), by their places in the list of all.
pub(super) type Vectors = [usize; 7];

/// Unknowns of the components of each nodal vector, and what each unknown measures.
pub(super) fn number(vectors: &[NodalVector], elements: &[Vectors]) -> (Vec<[Option<usize>; 2]>, Vec<Kind>) {
    let mut meeting = vec![Vec::new(); vectors.len()];
    for (element, its) in elements.iter().enumerate() {
        its.iter().for_each(|&vector| meeting[vector].push(element));
    }
    let mut unknowns = vec![None; vectors.len()];
    let mut kinds = Vec::new();
    for element in outwards(elements, &meeting) {
        let mut its = elements[element];
        // What it shares with the next elements comes last, nearest to them.
        its.sort_by_key(|&vector| meeting[vector].len());
        for vector in its {
            unknowns[vector].get_or_insert_with(|| {
                vectors[vector].held.map(|held| {
                    (!held).then(|| {
                        kinds.push(vectors[vector].kind);
                        kinds.len() - 1
                    })
                })
            });
        }
    }
    (unknowns.into_iter().map(Option::unwrap_or_default).collect(), kinds)
}

/// The elements in the order of their distance from one at the structure's edge (Cuthill and McKee 1969): the band is
/// then as wide as the structure is across, however long it is.
fn outwards(elements: &[Vectors], meeting: &[Vec<usize>]) -> Vec<usize> {
    let mut order = Vec::new();
    let mut done = vec![false; elements.len()];
    for first in 0..elements.len() {
        if !done[first] {
            let any = outwards_from(first, elements, meeting, &mut done.clone());
            let edge = any.last().copied().unwrap_or(first);
            order.extend(outwards_from(edge, elements, meeting, &mut done));
        }
    }
    order
}

/// The elements connected with `first`, the nearest first; they are `done` then.
fn outwards_from(first: usize, elements: &[Vectors], meeting: &[Vec<usize>], done: &mut [bool]) -> Vec<usize> {
    let mut order = Vec::new();
    let mut queue = VecDeque::from([first]);
    done[first] = true;
    while let Some(element) = queue.pop_front() {
        order.push(element);
        for &neighbour in elements[element].iter().flat_map(|&vector| &meeting[vector]) {
            if !done[neighbour] {
                done[neighbour] = true;
                queue.push_back(neighbour);
            }
        }
    }
    order
}
