//! Numbering of the unknowns: each rod's own, then the shared ones or the multipliers.

use std::collections::BTreeMap;

use nalgebra::{Matrix2, Rotation2, Vector2};

use super::constraint_row::ConstraintRow;
use super::constraints::{Constraint, clamped, held_directions};
use super::node_dofs::NodeDofs;
use super::numbering::order;
use super::point::Point;
use super::rod::Rod;
use super::unknown_kind::UnknownKind;
use crate::linear::{BlockLayout, Layout};
use crate::model::Scene;

/// Order and kinds of the unknowns.
pub(super) struct Numbering {
    pub layout: Layout,
    pub kinds: Vec<UnknownKind>,
    pub rows: Vec<ConstraintRow>,
}

/// Numbers each rod's own unknowns: all but those of the `shared` vectors of its chain.
fn number_own(rods: &mut [Rod], shared: impl Fn(usize, usize) -> bool, held: &HeldDirections) -> Numbering {
    let (mut layout, mut kinds) = (Layout::default(), Vec::new());
    for (n, rod) in rods.iter_mut().enumerate() {
        let first = kinds.len();
        for vector in (0..rod.chain.len()).filter(|&vector| !shared(n, vector)) {
            rod.chain[vector] = held.new_dofs(n, vector, rod.kind(vector), &mut kinds);
        }
        let band = (0..rod.elements).map(|element| spread(rod.vectors(element), first)).max().unwrap_or(0);
        layout.blocks.push(BlockLayout { first, size: kinds.len() - first, band, touches: Vec::new() });
    }
    layout.border = kinds.len();
    Numbering { layout, kinds, rows: Vec::new() }
}

/// Numbers the unknowns of the condensed form: rods that meet at a point share its position, held components have no
/// unknown.
pub(super) fn condensed(scene: &Scene, points: &BTreeMap<String, Point>, rods: &mut [Rod]) -> Numbering {
    let held = HeldDirections::of(scene, points);
    let shared: Vec<&Point> = points.values().filter(|point| point.nodes.len() > 1).collect();
    let mut touches = vec![Vec::new(); rods.len()];
    let mut at = BTreeMap::new();
    for (n, node) in shared.iter().enumerate().flat_map(|(n, point)| point.nodes.iter().map(move |node| (n, node))) {
        touches[node.rod].push(n);
        at.insert((node.rod, node.position), n);
    }
    let mut numbering = number_own(rods, |rod, vector| at.contains_key(&(rod, vector)), &held);
    for point in order(shared.len(), &touches).into_iter().map(|n| shared[n]) {
        let first = point.nodes[0];
        let dofs = held.new_dofs(first.rod, first.position, UnknownKind::Position, &mut numbering.kinds);
        for node in &point.nodes {
            rods[node.rod].chain[node.position] = dofs;
            numbering.layout.blocks[node.rod].touches.extend(dofs.unknowns.iter().flatten());
        }
    }
    numbering.finish()
}

/// Numbers the unknowns of the form with multipliers: every rod has all of its own, and the border holds the
/// multipliers.
pub(super) fn with_multipliers(rows: Vec<Constraint>, rods: &mut [Rod]) -> Numbering {
    let mut numbering = number_own(rods, |_, _| false, &HeldDirections::default());
    let mut touches = vec![Vec::new(); rods.len()];
    for (n, term) in rows.iter().enumerate().flat_map(|(n, row)| row.terms.iter().map(move |term| (n, term))) {
        touches[term.rod].push(n);
    }
    let mut numbered = BTreeMap::new();
    for n in order(rows.len(), &touches) {
        let multiplier = numbering.kinds.len();
        numbering.kinds.push(UnknownKind::Multiplier);
        let mut terms = Vec::new();
        for term in &rows[n].terms {
            numbering.layout.blocks[term.rod].touches.push(multiplier);
            let unknowns = rods[term.rod].chain[term.vector].unknowns.iter().flatten().zip(&term.weight);
            terms.extend(unknowns.filter(|(_, weight)| **weight != 0.0).map(|(u, weight)| (term.rod, *u, *weight)));
        }
        numbered.insert(n, ConstraintRow { multiplier, terms });
    }
    numbering.rows = numbered.into_values().collect();
    numbering.finish()
}

impl Numbering {
    /// Sets size and band of the border, once all unknowns are numbered.
    fn finish(mut self) -> Numbering {
        self.layout.border_size = self.kinds.len() - self.layout.border;
        for block in &mut self.layout.blocks {
            block.touches.sort_unstable();
            block.touches.dedup();
        }
        let spread = |block: &BlockLayout| Some(block.touches.last()? - block.touches.first()?);
        self.layout.border_band = self.layout.blocks.iter().filter_map(spread).max().unwrap_or(0);
        self
    }
}

/// Directions in which supports hold nodal vectors, by rod and index in its chain: one, or both.
#[derive(Default)]
struct HeldDirections(BTreeMap<(usize, usize), Vec<Vector2<f64>>>);

impl HeldDirections {
    fn of(scene: &Scene, points: &BTreeMap<String, Point>) -> HeldDirections {
        let mut held: BTreeMap<(usize, usize), Vec<Vector2<f64>>> = BTreeMap::new();
        for support in &scene.supports {
            for node in &points[&support.point].nodes {
                held.entry((node.rod, node.position)).or_default().extend(held_directions(support));
            }
            if let Some((node, direction)) = clamped(scene, points, support) {
                held.entry((node.rod, node.slope)).or_default().push(direction);
            }
        }
        HeldDirections(held)
    }

    /// New unknowns for the free components of a nodal vector; its axes are rotated if one oblique direction is held.
    fn new_dofs(&self, rod: usize, vector: usize, kind: UnknownKind, kinds: &mut Vec<UnknownKind>) -> NodeDofs {
        let directions = self.0.get(&(rod, vector)).map_or(&[][..], Vec::as_slice);
        let (held, turn) = match directions {
            [] => ([false; 2], None),
            [direction] if direction.y == 0.0 => ([true, false], None),
            [direction] if direction.x == 0.0 => ([false, true], None),
            [n] => ([false, true], Some(Rotation2::from_matrix_unchecked(Matrix2::new(n.y, n.x, -n.x, n.y)))),
            _ => ([true; 2], None),
        };
        let unknowns = held.map(|held| {
            (!held).then(|| {
                kinds.push(kind);
                kinds.len() - 1
            })
        });
        NodeDofs { unknowns, turn }
    }
}

/// Range of the numbers of an element's own unknowns, those from `first` on. Shared ones have no number yet.
fn spread(vectors: &[NodeDofs], first: usize) -> usize {
    let numbers = || vectors.iter().flat_map(|vector| vector.unknowns).flatten().filter(|&unknown| unknown >= first);
    numbers().max().zip(numbers().min()).map_or(0, |(last, first)| last - first)
}
