//! What a probe looks at: positions, reactions, deflections. A point has to be one of the scene's: other names panic.

use nalgebra::{DVector, Vector2};

use super::node_dofs::Components;
use super::rod_elements::Loaded;
use super::{Node, Structure};

/// What acts at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a> {
    /// Displacement.
    pub u: &'a DVector<f64>,
    /// Acceleration; zero in statics.
    pub a: &'a DVector<f64>,
    /// Time, s; the load factor in statics.
    pub t: f64,
    /// λ in their places; read in the multipliers' form only.
    pub multipliers: &'a DVector<f64>,
}

impl Structure {
    /// Position of a point of the scene.
    pub fn position(&self, point: &str, u: &DVector<f64>) -> [f64; 2] {
        let [x, y] = self.at_point(point, u);
        let start = self.points[point].start;
        [start[0] + x, start[1] + y]
    }

    /// A point's entries of a vector of unknowns, such as its velocity; zero where it is held.
    pub fn at_point(&self, point: &str, vector: &DVector<f64>) -> [f64; 2] {
        self.components(point).get(vector).into()
    }

    /// The point's position among the unknowns: that of the first rod there.
    pub(super) fn components(&self, point: &str) -> Components {
        let Node { rod, position, .. } = self.points[point].nodes[0];
        self.rods[rod].chain[position]
    }

    /// Unknown of a component (0: x, 1: y) of a nodal vector of a rod, by its place in the rod's order: r, r_y, then r_j,
    /// r_xj, r_yj, r_k, r_yk for each element, or r, r_x, then r_k, r_xk; `None` where it is held, or there is no such rod or vector.
    pub fn unknown(&self, rod: &str, vector: usize, component: usize) -> Option<usize> {
        let rod = self.rods.iter().find(|known| known.name == rod)?;
        rod.chain.get(vector)?.unknowns.get(component).copied()?
    }

    /// Distance of a rod's axis, at a fraction of its length, from the chord through its ends, m; positive to the left.
    ///
    /// With the chord c and the displacements δ there and Δ of the end, both from that of the beginning, the distance is
    /// c × (δ − fraction · Δ)/|c|: no difference of large numbers for a small deflection.
    pub fn deflection(&self, rod: &str, fraction: f64, u: &DVector<f64>) -> f64 {
        let Some(rod) = self.rods.iter().find(|known| known.name == rod) else { return f64::NAN };
        let axis = rod.mesh.axis(fraction * rod.elements as f64, u);
        let [start, end] = [0, rod.chain.len() - 2].map(|vector| rod.chain[vector].get(u));
        let chord = rod.along * rod.elements as f64 + end - start;
        chord.perp(&(axis - start - fraction * (end - start))) / chord.norm()
    }

    /// Force of the supports on the structure at a point, N.
    pub fn reaction(&self, point: &str, now: Instant) -> [f64; 2] {
        let point_force = if self.rows.is_empty() { self.point_force(point, now.t) } else { Vector2::zeros() };
        let on_rods = self.points[point].nodes.iter().map(|node| self.node_force(*node, now));
        (on_rods.sum::<Vector2<f64>>() - point_force).into()
    }

    /// All that acts on one rod at a point but for its weight, N: other rods, supports and point forces, which the point's
    /// first rod takes in the multipliers' form.
    pub fn force_on_rod(&self, point: &str, rod: &str, now: Instant) -> [f64; 2] {
        let nodes = &self.points[point].nodes;
        let Some(node) = nodes.iter().find(|node| self.rods[node.rod].name == rod) else { return [f64::NAN; 2] };
        let multiplied = !self.rows.is_empty() && *node == nodes[0];
        let point_force = if multiplied { self.point_force(point, now.t) } else { Vector2::zeros() };
        (self.node_force(*node, now) + point_force).into()
    }

    /// Force of what the point's rod is held by there: −Φ_qᵀ λ where there are multipliers, M a + Q_e − Q_w otherwise.
    fn node_force(&self, node: Node, now: Instant) -> Vector2<f64> {
        let rod = &self.rods[node.rod];
        if !self.rows.is_empty() {
            let [x, y] = rod.chain[node.position].unknowns;
            let terms = self.rows.iter().flat_map(|row| row.terms.iter().map(move |term| (row.multiplier, term)));
            let along = |axis| {
                let its = terms.clone().filter(|(_, (_, unknown, _))| Some(*unknown) == axis);
                its.map(|(multiplier, (_, _, weight))| weight * now.multipliers[multiplier]).sum::<f64>()
            };
            return -Vector2::new(along(x), along(y));
        }
        let eps_t = self.thermal_strain(rod, now.t);
        let weight = if self.grows { now.t } else { 1.0 };
        rod.mesh.force_at(node.position, &Loaded { u: now.u, a: now.a, eps_t, weight })
    }

    fn point_force(&self, point: &str, t: f64) -> Vector2<f64> {
        let its = self.forces.iter().filter(|force| force.point == point);
        let full: Vector2<f64> = its.map(|force| Vector2::from(force.at(t))).sum();
        if self.grows { t * full } else { full }
    }
}
