//! Rods, pins and supports → numbering, assembly, loads, constraint rows.
//!
//! The unknowns are the displacements u = q − q₀ of the nodal coordinates from the initial configuration. Two ways to keep
//! rods together ([`Constraints`](crate::model::Constraints)):
//!
//! * **condensed**: rods that meet at a point share its position and keep their own slopes; what a support holds is no
//!   unknown at all. Supports in an oblique direction turn the axes of their nodal vector.
//! * **multipliers**: every rod has all of its coordinates, and (23)'s multipliers λ stand among the unknowns. They have
//!   no mass, no elastic force and no displacement: their entries of u, v and a are zero, those of a load or a residual
//!   are constraint rows, and those of a solution are λ.
//!
//! Either way the matrices have one block a rod, bordered by what rods share: eliminated element by element in the condensed
//! form ([`Chains`](crate::linear::Chains)), as a whole beside multipliers ([`Bordered`](crate::linear::Bordered)).

mod build;
mod collapse;
mod constraint_row;
mod constraints;
mod element_dofs;
mod frequency;
mod load;
mod mass;
mod matrix;
mod memory;
mod mobility;
mod node_dofs;
mod numbering;
mod point;
mod probes;
mod rod;
mod rod_elements;
mod rounding;
mod uniform_elements;
mod unknown_kind;
mod unknowns;

use std::sync::Arc;

use nalgebra::DVector;

use self::constraint_row::ConstraintRow;
use self::node_dofs::NodeDofs;
use self::point::{Node, Point};
use self::rod::Rod;
use self::unknown_kind::UnknownKind;
use crate::elements::{Ends, ThermalStrain};
use crate::linear::Layout;
use crate::model::Force;
use crate::model::plan::Plan;

pub use mass::MassFactors;
pub use matrix::{Factors, Matrix};
pub use probes::{Instant, PointId, RodId};

/// A structure ready for statics and dynamics.
#[derive(Clone, Debug)]
pub struct Structure {
    plan: Plan,
    rods: Arc<[Rod]>,
    kinds: Vec<UnknownKind>,
    /// One over the length over which an unknown's force is judged; 0 for multipliers.
    weights: DVector<f64>,
    /// One over the length of its elements for a position; for a slope 1, of r_y in elements higher than long h/l; 0 for a multiplier.
    shares: DVector<f64>,
    /// Sorted by name.
    points: Vec<(String, Point)>,
    /// There are none in the condensed form.
    rows: Vec<ConstraintRow>,
    layout: Arc<Layout>,
    gravity: DVector<f64>,
    forces: Vec<Force>,
    /// Where they act.
    force_places: Vec<NodeDofs>,
    start: DVector<f64>,
    start_velocity: DVector<f64>,
    /// Statics: loads and heat grow with a factor in place of time.
    is_static: bool,
    /// Start and end, s, and between them the times at which a temperature or a force has a corner.
    times: Vec<f64>,
    /// Force or moment of a unit strain on each unknown, N and N m.
    unit_forces: DVector<f64>,
    /// Length of the shortest element, m.
    shortest: f64,
    /// Least size of the numbers that a strain is the difference of.
    rounded: f64,
}

/// Both ends of a step, with the thermal strains of the rods.
pub type StepEnds<'a> = Ends<'a, DVector<f64>, &'a [ThermalStrain]>;

impl Structure {
    /// Number of unknowns, multipliers among them.
    pub fn size(&self) -> usize {
        self.kinds.len()
    }

    /// Displacement at t = 0: zero, or the stress-free one of a relaxed start.
    pub fn start(&self) -> &DVector<f64> {
        &self.start
    }

    /// Velocity at t = 0: zero, or that of the scene's motion.
    pub fn start_velocity(&self) -> &DVector<f64> {
        &self.start_velocity
    }

    /// Times between start and end at which a temperature or a force has a corner, s, in order.
    pub fn corners(&self) -> &[f64] {
        self.times.get(1..self.times.len().saturating_sub(1)).unwrap_or_default()
    }

    /// The mass matrix times an acceleration (or a velocity), without the matrix.
    pub fn inertia(&self, a: &DVector<f64>) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        self.inertia_into(a, &mut sum);
        sum
    }

    /// The same into `sum`.
    pub fn inertia_into(&self, a: &DVector<f64>, sum: &mut DVector<f64>) {
        sum.fill(0.0);
        self.rods.iter().for_each(|rod| rod.mesh.add_inertia(a, sum));
    }

    /// A force vector's largest entry, N, moments taken over their own length (h or l); constraint rows are no forces.
    pub fn largest(&self, force: &DVector<f64>) -> f64 {
        // Four at a time: one after the other they would wait for one another.
        let (mut largest, mut sum) = ([0.0; 4], [0.0; 4]);
        let mut look_at = |values: &[f64], weights: &[f64]| {
            for (n, (value, weight)) in values.iter().zip(weights).enumerate() {
                let value = (value * weight).abs();
                largest[n] = if value > largest[n] { value } else { largest[n] };
                sum[n] += value;
            }
        };
        let (values, last) = force.as_slice().as_chunks::<4>();
        let (weights, last_weights) = self.weights.as_slice().as_chunks::<4>();
        values.iter().zip(weights).for_each(|(values, weights)| look_at(values, weights));
        look_at(last, last_weights);
        // A comparison drops a NaN; a sum does not.
        let sum = sum.iter().sum::<f64>();
        if sum.is_nan() { sum } else { largest.into_iter().fold(0.0, f64::max) }
    }

    /// A displacement's largest entry, m: of positions, and of slopes times the length over which they act.
    pub fn farthest(&self, u: &DVector<f64>) -> f64 {
        let size = |(u, kind): (&f64, &UnknownKind)| match kind {
            UnknownKind::Position => u.abs(),
            UnknownKind::Slope(length) => u.abs() * length,
            UnknownKind::Multiplier => 0.0,
        };
        u.iter().zip(&self.kinds).map(size).fold(0.0, |largest, size| if size <= largest { largest } else { size })
    }

    /// Elastic forces into `sum`, at the rods' thermal strains.
    pub fn force(&self, u: &DVector<f64>, thermal: &[ThermalStrain], sum: &mut DVector<f64>) {
        sum.fill(0.0);
        for (rod, eps_t) in self.rods.iter().zip(thermal) {
            rod.mesh.add_force(u, *eps_t, sum);
        }
    }

    /// Step-averaged elastic forces of the energy–momentum rule into `sum`.
    pub fn mean_force(&self, step: &StepEnds, sum: &mut DVector<f64>) {
        sum.fill(0.0);
        for (n, rod) in self.rods.iter().enumerate() {
            rod.mesh.add_mean_force(&of_rod(step, n), sum);
        }
    }

    /// Strain energy, J.
    pub fn strain_energy(&self, u: &DVector<f64>, thermal: &[ThermalStrain]) -> f64 {
        self.rods.iter().zip(thermal).map(|(rod, eps_t)| rod.mesh.energy(u, *eps_t)).sum()
    }

    /// Kinetic energy of velocities `v`, J; `momentum` is memory.
    pub fn kinetic_energy(&self, v: &DVector<f64>, momentum: &mut DVector<f64>) -> f64 {
        self.inertia_into(v, momentum);
        0.5 * v.dot(momentum)
    }

    /// Energy that heating puts in over a step, J.
    pub fn heating_work(&self, step: &StepEnds) -> f64 {
        self.rods.iter().enumerate().map(|(n, rod)| rod.mesh.heating_work(&of_rod(step, n))).sum()
    }

    /// Where an unknown is, in words.
    pub fn place(&self, unknown: usize) -> String {
        let is_it = |vector: &NodeDofs, unknown| vector.unknowns.contains(&Some(unknown));
        let point_of = |unknown| {
            let its_node = |node: &Node| is_it(&self.rods[node.rod].chain[node.position], unknown);
            self.points.iter().find(|(_, point)| point.nodes.iter().any(its_node)).map(|(name, _)| name)
        };
        if let Some(row) = self.rows.iter().find(|row| row.multiplier == unknown) {
            let at = row.terms.iter().find_map(|&(_, unknown, _)| point_of(unknown));
            return at.map_or("a clamp".into(), |name| format!("a pin or support of the point `{name}`"));
        }
        let rod = || self.rods.iter().find(|rod| rod.chain.iter().any(|vector| is_it(vector, unknown)));
        match point_of(unknown) {
            Some(name) => format!("the point `{name}`"),
            None => rod().map_or("no unknown".into(), |rod| format!("the rod `{}`", rod.name)),
        }
    }
}

/// A step with the thermal strains of one rod.
fn of_rod<'a>(step: &StepEnds<'a>, rod: usize) -> Ends<'a, DVector<f64>> {
    Ends { u_0: step.u_0, u_1: step.u_1, thermal_0: step.thermal_0[rod], thermal_1: step.thermal_1[rod] }
}
