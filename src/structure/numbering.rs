//! Numbering of what rods share: connected rods get close numbers, so that the border's band is narrow.

use std::collections::VecDeque;

/// Order of the shared items 0 … `count` − 1; `touches` lists the items of each rod.
pub(super) fn order(count: usize, touches: &[Vec<usize>]) -> Vec<usize> {
    let mut order = Vec::with_capacity(count);
    let mut done = vec![false; count];
    for rod in cuthill_mckee(count, touches) {
        for &shared in &touches[rod] {
            if !std::mem::replace(&mut done[shared], true) {
                order.push(shared);
            }
        }
    }
    order
}

/// Rods in order of distance from one at the structure's edge (Cuthill and McKee 1969). The band is then as wide as the
/// structure is across, however long it is.
pub(super) fn cuthill_mckee(count: usize, touches: &[Vec<usize>]) -> Vec<usize> {
    let mut meeting = vec![Vec::new(); count];
    for (rod, its) in touches.iter().enumerate() {
        its.iter().for_each(|&shared| meeting[shared].push(rod));
    }
    let meeting = &meeting;
    let mut order = Vec::new();
    let mut done = vec![false; touches.len()];
    for first in 0..touches.len() {
        if !done[first] {
            let any = breadth_first(first, touches, meeting, &mut done.clone());
            let edge = any.last().copied().unwrap_or(first);
            order.extend(breadth_first(edge, touches, meeting, &mut done));
        }
    }
    order
}

/// Rods connected with `first`, nearest first; marks them `done`.
fn breadth_first(first: usize, touches: &[Vec<usize>], meeting: &[Vec<usize>], done: &mut [bool]) -> Vec<usize> {
    let mut order = Vec::new();
    let mut queue = VecDeque::from([first]);
    done[first] = true;
    while let Some(rod) = queue.pop_front() {
        order.push(rod);
        for &neighbour in touches[rod].iter().flat_map(|&shared| &meeting[shared]) {
            if !done[neighbour] {
                done[neighbour] = true;
                queue.push_back(neighbour);
            }
        }
    }
    order
}
