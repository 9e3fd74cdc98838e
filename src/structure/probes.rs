//! Readings of a structure: positions, nodal coordinates, reactions, deflections.

use nalgebra::{DVector, Vector2};

use super::Structure;
use super::node_dofs::NodeDofs;
use super::point::Node;
use super::rod_elements::RodInstant;
use crate::elements::Meaning;
use crate::error::{Error, Result};
use crate::model::or_nearest;

/// State of a structure at an instant, for forces.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a> {
    /// Displacement.
    pub u: &'a DVector<f64>,
    /// Acceleration; zero in statics.
    pub a: &'a DVector<f64>,
    /// Time, s; the load factor in statics.
    pub t: f64,
    /// Multipliers λ in their entries; read only in the form with multipliers.
    pub multipliers: &'a DVector<f64>,
}

/// Point of a structure, found by [`Structure::point`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointId(usize);

/// Rod of a structure, found by [`Structure::rod`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RodId(pub(super) usize);

impl Structure {
    /// Finds a point by name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn point(&self, name: &str) -> Result<PointId> {
        let known = || self.points.iter().map(|(known, _)| known.as_str());
        known().position(|known| known == name).map(PointId).ok_or_else(|| unknown("point", name, known()))
    }

    /// Finds a rod by name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn rod(&self, name: &str) -> Result<RodId> {
        let known = || self.rods.iter().map(|rod| rod.name.as_str());
        known().position(|known| known == name).map(RodId).ok_or_else(|| unknown("rod", name, known()))
    }

    /// Position of a point, m.
    pub fn position(&self, point: PointId, u: &DVector<f64>) -> [f64; 2] {
        let [x, y] = self.at_point(point, u);
        let initial = self.points[point.0].1.initial;
        [initial[0] + x, initial[1] + y]
    }

    /// Entries of a point in a vector of unknowns, such as its velocity; zero where held.
    pub fn at_point(&self, point: PointId, vector: &DVector<f64>) -> [f64; 2] {
        self.point_dofs(point).get(vector).into()
    }

    /// Unknowns of a point: those of the first rod there.
    pub(super) fn point_dofs(&self, point: PointId) -> NodeDofs {
        let Node { rod, position, .. } = self.points[point.0].1.nodes[0];
        self.rods[rod].chain[position]
    }

    /// Nodal coordinates of a rod at the displacement `u`, vector by vector from its first node: r, r_y, then r_j,
    /// r_xj, r_yj, r_k, r_yk for each of the paper's elements; or r, r_x, then r_k, r_xk for each Euler–Bernoulli
    /// element. Positions in m, slopes without unit.
    pub fn nodal_coordinates(&self, rod: RodId, u: &DVector<f64>) -> Vec<[f64; 2]> {
        let rod = &self.rods[rod.0];
        let t = rod.along.normalize();
        let initial = |(meaning, place): (Meaning, f64)| match meaning {
            Meaning::Position => rod.from + place * rod.along,
            Meaning::SlopeX => t,
            Meaning::SlopeY => Vector2::new(-t.y, t.x),
        };
        rod.chain.iter().enumerate().map(|(n, vector)| (initial(rod.nodal(n)) + vector.get(u)).into()).collect()
    }

    /// Unknown of a component (0: x, 1: y) of a rod's nodal vector, by its index in the order of
    /// [`nodal_coordinates`](Structure::nodal_coordinates). `None` if it is held, or if there is no such rod or vector.
    pub fn unknown(&self, rod: &str, vector: usize, component: usize) -> Option<usize> {
        let rod = self.rods.iter().find(|known| known.name == rod)?;
        rod.chain.get(vector)?.unknowns.get(component).copied()?
    }

    /// Deflection of a rod, m: distance of its axis, at a fraction of its length, from the chord through its ends;
    /// positive to the left.
    ///
    /// With the chord c, and the displacements δ there and Δ of the end, both relative to the first point, it is c × (δ
    /// − fraction · Δ)/|c|. A small deflection is not a difference of large numbers.
    pub fn deflection(&self, rod: RodId, fraction: f64, u: &DVector<f64>) -> f64 {
        let rod = &self.rods[rod.0];
        let axis = rod.mesh.axis(fraction * rod.elements as f64, u);
        let [start, end] = [0, rod.chain.len() - 2].map(|vector| rod.chain[vector].get(u));
        let chord = rod.along * rod.elements as f64 + end - start;
        chord.perp(&(axis - start - fraction * (end - start))) / chord.norm()
    }

    /// Force of the supports on the structure at a point, N.
    pub fn reaction(&self, point: PointId, now: Instant) -> [f64; 2] {
        let point_force = if self.rows.is_empty() { self.point_force(point, now.t) } else { Vector2::zeros() };
        let on_rods = self.points[point.0].1.nodes.iter().map(|node| self.node_force(*node, now));
        (on_rods.sum::<Vector2<f64>>() - point_force).into()
    }

    /// Force on one rod at a point, without its weight, N: of other rods, supports and point forces. With multipliers a
    /// point force acts on the point's first rod. Zero where the rod does not meet the point.
    pub fn force_on_rod(&self, point: PointId, rod: RodId, now: Instant) -> [f64; 2] {
        let nodes = &self.points[point.0].1.nodes;
        let Some(node) = nodes.iter().find(|node| node.rod == rod.0) else { return [0.0; 2] };
        let multiplied = !self.rows.is_empty() && *node == nodes[0];
        let point_force = if multiplied { self.point_force(point, now.t) } else { Vector2::zeros() };
        (self.node_force(*node, now) + point_force).into()
    }

    /// Force that a rod's node receives from its constraints: −Φ_qᵀ λ with multipliers, M a + Q_e − Q_w otherwise.
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
        let weight = if self.is_static { now.t } else { 1.0 };
        rod.mesh.force_at(node.position, &RodInstant { u: now.u, a: now.a, eps_t, weight })
    }

    fn point_force(&self, point: PointId, t: f64) -> Vector2<f64> {
        let its = self.forces.iter().filter(|force| force.point == self.points[point.0].0);
        its.map(|force| self.force_at(force, t)).sum()
    }
}

fn unknown<'a>(what: &'static str, name: &str, known: impl Iterator<Item = &'a str>) -> Error {
    Error::Unknown { what, name: name.into(), nearest: or_nearest(name, known) }
}
