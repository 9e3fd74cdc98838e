//! Assembles rods, pins and supports: numbering, forces, matrices, loads, constraint rows.
//!
//! The unknowns are the displacements u = q − q₀ of the nodal coordinates from the initial configuration. Rods are
//! connected in one of two ways ([`Constraints`](crate::model::Constraints)):
//!
//! * **condensed**: rods that meet at a point share its position and keep their own slopes; held coordinates are not
//!   unknowns. A support in an oblique direction rotates the axes of its nodal vector.
//! * **multipliers**: every rod keeps all of its coordinates, and the multipliers λ of (23) are unknowns too. They have
//!   no mass, elastic force or displacement. Their entries are zero in u, v and a, constraint rows in a load or a
//!   residual, and λ in a solution.
//!
//! Either way a matrix has one block per rod, bordered by what rods share. In the condensed form it is eliminated
//! element by element ([`CondensedFactors`](crate::linear::CondensedFactors)), with multipliers as a whole
//! ([`Bordered`](crate::linear::Bordered)).

mod axis;
mod buckling;
mod build;
mod collapse;
mod constraint_row;
mod constraints;
mod deviation;
mod element_dofs;
mod frequency;
mod growth;
mod load;
mod mass;
mod matrix;
mod memory;
mod mobility;
mod node_dofs;
mod numbering;
mod point;
mod probes;
mod rigid_motion;
mod rod;
mod rod_elements;
mod rotation;
mod rounding;
mod row;
mod stability;
mod sweep;
mod uniform_elements;
mod unknown_kind;
mod unknowns;
mod vibration;

use std::sync::Arc;

use nalgebra::DVector;

use self::constraint_row::ConstraintRow;
use self::node_dofs::NodeDofs;
use self::point::{Node, Point};
use self::rod::Rod;
use self::unknown_kind::UnknownKind;
use crate::elements::{Ends, ThermalStrain};
use crate::lanes::Path;
use crate::linear::Layout;
use crate::model::Force;
use crate::model::plan::Plan;

pub use mass::MassFactors;
pub use matrix::{Factors, Matrix};
pub use probes::{Instant, PointId, RodId};
pub use stability::StabilityCounter;
pub use vibration::{Kind, Vibration};

/// A model's structure, ready for statics and dynamics.
#[derive(Clone, Debug)]
pub struct Structure {
    plan: Plan,
    /// Instructions of the processor.
    path: Path,
    rods: Arc<[Rod]>,
    kinds: Vec<UnknownKind>,
    /// Reciprocal lengths that convert an unknown's force to newtons; 0 for multipliers.
    force_weights: DVector<f64>,
    /// Factors of [`largest_change`](Structure::largest_change): one over the element length for a position; 1 for a slope, h/l for r_y
    /// in elements higher than long; 0 for a multiplier.
    motion_factors: DVector<f64>,
    /// Points by name, sorted.
    points: Vec<(String, Point)>,
    /// Constraint rows; none in the condensed form.
    rows: Vec<ConstraintRow>,
    layout: Arc<Layout>,
    gravity: DVector<f64>,
    forces: Vec<Force>,
    /// Unknowns of the loaded points.
    force_places: Vec<NodeDofs>,
    start: DVector<f64>,
    start_velocity: DVector<f64>,
    /// Whether loads and heat grow with a load factor instead of time.
    is_static: bool,
    /// Start and end, s, and between them all times at which a temperature or force history has a corner.
    times: Vec<f64>,
    /// Force or moment of a unit strain on each unknown, N or N m.
    unit_forces: DVector<f64>,
    /// Length of the shortest element, m.
    shortest_element: f64,
    /// Least magnitude of the numbers whose differences are strains.
    rounding_scale: f64,
}

/// Both ends of a step, with the rods' thermal strains.
pub type StepEnds<'a> = Ends<'a, DVector<f64>, &'a [ThermalStrain]>;

impl Structure {
    /// Number of unknowns, including multipliers.
    pub fn size(&self) -> usize {
        self.kinds.len()
    }

    /// Displacement at t = 0: zero, the stress-free stretch of a relaxed start, or the deviation of an imperfection.
    pub fn start(&self) -> &DVector<f64> {
        &self.start
    }

    /// Velocity at t = 0: zero, or that of the scene's motion.
    pub fn start_velocity(&self) -> &DVector<f64> {
        &self.start_velocity
    }

    /// Times between start and end at which a temperature or force history has a corner, s, in order.
    pub fn corners(&self) -> &[f64] {
        self.times.get(1..self.times.len().saturating_sub(1)).unwrap_or_default()
    }

    /// Start and end of the stretch, between two corners of histories, in which the load factor `load` lies: there loads
    /// and heat are linear.
    pub fn stretch(&self, load: f64) -> [f64; 2] {
        let next = self.times.partition_point(|time| *time <= load).clamp(1, self.times.len() - 1);
        [self.times[next - 1], self.times[next]]
    }

    /// Product of the mass matrix and an acceleration (or velocity), without forming the matrix.
    pub fn inertia(&self, a: &DVector<f64>) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        self.inertia_into(a, &mut sum);
        sum
    }

    /// Product of the mass matrix and an acceleration (or velocity), into `sum`.
    pub fn inertia_into(&self, a: &DVector<f64>, sum: &mut DVector<f64>) {
        sum.as_mut_slice().fill(0.0);
        self.rods.iter().for_each(|rod| rod.mesh.add_inertia(a, sum));
    }

    /// Largest entry of a force vector, N; moments are divided by their length (h or l), constraint rows are skipped.
    pub fn largest_force(&self, force: &DVector<f64>) -> f64 {
        // Four independent maxima at a time: a single one would make every comparison wait for the one before.
        let (mut largest, mut sum) = ([0.0; 4], [0.0; 4]);
        let mut accumulate = |values: &[f64], weights: &[f64]| {
            for (n, (value, weight)) in values.iter().zip(weights).enumerate() {
                let value = (value * weight).abs();
                largest[n] = if value > largest[n] { value } else { largest[n] };
                sum[n] += value;
            }
        };
        let (values, last) = force.as_slice().as_chunks::<4>();
        let (weights, last_weights) = self.force_weights.as_slice().as_chunks::<4>();
        values.iter().zip(weights).for_each(|(values, weights)| accumulate(values, weights));
        accumulate(last, last_weights);
        // A comparison drops a NaN; a sum does not.
        let sum = sum.iter().sum::<f64>();
        if sum.is_nan() { sum } else { largest.into_iter().fold(0.0, f64::max) }
    }

    /// Largest entry of a displacement, m; slopes are multiplied by the length over which they act.
    pub fn largest_displacement(&self, u: &DVector<f64>) -> f64 {
        let size = |(u, kind): (&f64, &UnknownKind)| match kind {
            UnknownKind::Position => u.abs(),
            UnknownKind::Slope(length) => u.abs() * length,
            UnknownKind::Multiplier => 0.0,
        };
        u.iter().zip(&self.kinds).map(size).fold(0.0, |largest, size| if size <= largest { largest } else { size })
    }

    /// Product of two displacements, m²: the sum of the products of their entries, slopes multiplied by the length over
    /// which they act. It does not change when the structure is turned.
    pub fn displacement_product(&self, a: &DVector<f64>, b: &DVector<f64>) -> f64 {
        let weight = |kind: &UnknownKind| match kind {
            UnknownKind::Position => 1.0,
            UnknownKind::Slope(length) => length * length,
            UnknownKind::Multiplier => 0.0,
        };
        a.iter().zip(b).zip(&self.kinds).map(|((a, b), kind)| weight(kind) * a * b).sum()
    }

    /// [Product](Structure::displacement_product) with itself of a displacement whose every entry is the largest thermal
    /// stretch of the shortest element, m².
    pub fn thermal_stretch(&self, thermal: &[ThermalStrain]) -> f64 {
        let hottest = thermal.iter().flatten().map(|strain| strain.abs()).fold(0.0, f64::max);
        self.size() as f64 * (hottest * self.shortest_element).powi(2)
    }

    /// Elastic forces at the rods' thermal strains, into `sum`.
    pub fn force(&self, u: &DVector<f64>, thermal: &[ThermalStrain], sum: &mut DVector<f64>) {
        sum.as_mut_slice().fill(0.0);
        self.add_force(u, thermal, 1.0, sum);
    }

    /// Adds `factor` times the elastic forces at the rods' thermal strains to `sum`.
    pub fn add_force(&self, u: &DVector<f64>, thermal: &[ThermalStrain], factor: f64, sum: &mut DVector<f64>) {
        for (rod, eps_t) in self.rods.iter().zip(thermal) {
            rod.mesh.add_force(u, *eps_t, factor, sum);
        }
    }

    /// Instructions of the processor that the structure is computed with.
    pub fn path(&self) -> Path {
        self.path
    }

    /// Step-averaged elastic forces of the energy–momentum rule, into `sum`.
    pub fn mean_force(&self, step: &StepEnds, sum: &mut DVector<f64>) {
        sum.as_mut_slice().fill(0.0);
        for (n, rod) in self.rods.iter().enumerate() {
            rod.mesh.add_mean_force(&of_rod(step, n), sum);
        }
    }

    /// Strain energy, J.
    pub fn strain_energy(&self, u: &DVector<f64>, thermal: &[ThermalStrain]) -> f64 {
        self.rods.iter().zip(thermal).map(|(rod, eps_t)| rod.mesh.energy(u, *eps_t)).sum()
    }

    /// Kinetic energy of velocities `v`, J; `momentum` is a buffer.
    pub fn kinetic_energy(&self, v: &DVector<f64>, momentum: &mut DVector<f64>) -> f64 {
        self.inertia_into(v, momentum);
        0.5 * v.dot(momentum)
    }

    /// Energy supplied by heating over a step, J.
    pub fn heating_work(&self, step: &StepEnds) -> f64 {
        self.rods.iter().enumerate().map(|(n, rod)| rod.mesh.heating_work(&of_rod(step, n))).sum()
    }

    /// Location of an unknown, in words.
    pub fn location(&self, unknown: usize) -> String {
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

/// Both ends of a step, with the thermal strains of one rod.
fn of_rod<'a>(step: &StepEnds<'a>, rod: usize) -> Ends<'a, DVector<f64>> {
    Ends { u_0: step.u_0, u_1: step.u_1, thermal_0: step.thermal_0[rod], thermal_1: step.thermal_1[rod] }
}
