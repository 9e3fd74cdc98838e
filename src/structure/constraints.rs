//! Constraints Φ(q) = 0 of equation (23): rows of pins and supports over nodal vectors.
//!
//! All rows are linear in q, so that Φ_q is constant. Their order: first pins, by point name; for each point, its rods
//! in the scene's order, neighbour by neighbour, r(second) − r(first) = 0. Then supports in the scene's order: `fix`,
//! `slide`, `clamp`, the first two on the point's first rod.

use std::collections::BTreeMap;

use nalgebra::{DVector, Vector2};

use super::Structure;
use super::point::{Node, Point};
use crate::linear::Bordered;
use crate::model::{Element, Scene, Support};

/// Constraint Σ weight · nodal vector = 0.
pub(super) struct Constraint {
    pub terms: Vec<Term>,
}

/// Weighted nodal vector: a rod, the index in its chain, and the weight.
pub(super) struct Term {
    pub rod: usize,
    pub vector: usize,
    pub weight: Vector2<f64>,
}

/// All constraints of a scene.
pub(super) fn rows(scene: &Scene, points: &BTreeMap<String, Point>) -> Vec<Constraint> {
    let pins = points.values().flat_map(|point| point.nodes.windows(2)).flat_map(|pair| pin(pair[0], pair[1]));
    pins.chain(supports(scene, points)).collect()
}

/// Both constraints of a pin between the nodes of two rods.
pub(super) fn pin(first: Node, second: Node) -> [Constraint; 2] {
    [Vector2::x(), Vector2::y()].map(|axis| Constraint { terms: vec![position(second, axis), position(first, -axis)] })
}

/// Constraints of all supports.
pub(super) fn supports(scene: &Scene, points: &BTreeMap<String, Point>) -> impl Iterator<Item = Constraint> {
    scene.supports.iter().flat_map(|support| {
        let node = points[&support.point].nodes[0];
        let held = held_directions(support).into_iter().map(move |direction| position(node, direction));
        let clamp = clamped(scene, points, support);
        let clamp = clamp.map(|(node, weight)| Term { rod: node.rod, vector: node.slope, weight });
        held.chain(clamp).map(|term| Constraint { terms: vec![term] })
    })
}

fn position(node: Node, weight: Vector2<f64>) -> Term {
    Term { rod: node.rod, vector: node.position, weight }
}

/// Unit vectors along which a support holds its point.
pub(super) fn held_directions(support: &Support) -> Vec<Vector2<f64>> {
    support.held().into_iter().map(Vector2::from).collect()
}

/// Node whose section a support clamps, with the direction that its slope must not have a component in: the rod's
/// initial direction for r_y, its initial normal for r_x.
pub(super) fn clamped(
    scene: &Scene,
    points: &BTreeMap<String, Point>,
    support: &Support,
) -> Option<(Node, Vector2<f64>)> {
    let name = support.clamp.as_ref()?;
    let node = points[&support.point].nodes.iter().find(|node| scene.rods[node.rod].name == *name)?;
    let rod = &scene.rods[node.rod];
    let along = Vector2::from(scene.points[&rod.to]) - Vector2::from(scene.points[&rod.from]);
    let t = along.normalize();
    let forbidden = match rod.element {
        Element::Ancf => t,
        Element::EulerBernoulli => Vector2::new(-t.y, t.x),
    };
    Some((*node, forbidden))
}

impl Structure {
    /// Unknown of the multiplier of a constraint row, in the order of rows; `None` after the last, and in the condensed
    /// form.
    pub fn multiplier(&self, row: usize) -> Option<usize> {
        self.rows.get(row).map(|row| row.multiplier)
    }

    /// Adds Φ_qᵀ λ to the forces, with λ from the entries of `x`.
    pub fn add_constraint_forces(&self, x: &DVector<f64>, sum: &mut DVector<f64>) {
        for row in &self.rows {
            row.terms.iter().for_each(|&(_, unknown, weight)| sum[unknown] += weight * x[row.multiplier]);
        }
    }

    /// Writes Φ_q `x` into the constraint rows of `value`.
    pub fn set_constraint_rows(&self, x: &DVector<f64>, value: &mut DVector<f64>) {
        for row in &self.rows {
            value[row.multiplier] = row.apply(x);
        }
    }

    /// Adds `factor` · Φ_qᵀ beside, and Φ_q below, the matrix of the other unknowns.
    pub fn add_constraints(&self, factor: f64, matrix: &mut Bordered) {
        for row in &self.rows {
            for &(rod, unknown, weight) in &row.terms {
                let mut block = matrix.block(rod);
                block.add(unknown, row.multiplier, factor * weight);
                block.add(row.multiplier, unknown, weight);
            }
        }
    }

    /// Moves λ out of a solution, leaving zeros in its entries.
    pub fn take_multipliers(&self, solution: &mut DVector<f64>) -> DVector<f64> {
        let mut multipliers = DVector::zeros(self.size());
        self.take_multipliers_into(solution, &mut multipliers);
        multipliers
    }

    /// Moves λ out of a solution into `multipliers`, whose other entries are zero.
    pub fn take_multipliers_into(&self, solution: &mut DVector<f64>, multipliers: &mut DVector<f64>) {
        for row in &self.rows {
            multipliers[row.multiplier] = std::mem::take(&mut solution[row.multiplier]);
        }
    }

    /// Largest |Φ(q)|, m, and |Φ_q v|, m/s, in the form with multipliers, at displacement `u` and velocity `v`.
    pub fn constraint_residual(&self, u: &DVector<f64>, v: &DVector<f64>) -> [f64; 2] {
        [u, v].map(|x| self.rows.iter().map(|row| row.apply(x).abs()).max_by(f64::total_cmp).unwrap_or(0.0))
    }
}
