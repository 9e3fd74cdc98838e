//! Rods, pins and supports → numbering, assembly, loads, constraint rows.
//!
//! The unknowns are the displacements u = q − q₀ of the nodal coordinates from the initial configuration. Two ways to keep
//! rods together ([`Constraints`](crate::scene::Constraints)):
//!
//! * **condensed**: rods that meet at a point share its position and keep their own slopes; what a support holds is no
//!   unknown at all. Supports in an oblique direction turn the axes of their nodal vector.
//! * **multipliers**: every rod has all of its coordinates, and (23)'s multipliers λ stand among the unknowns. They have
//!   no mass, no elastic force and no displacement: their entries of u, v and a are zero, those of a load or a residual
//!   are constraint rows, and those of a solution are λ.
//!
//! Either way the matrices have one block a rod, bordered by what rods share ([`Bordered`]).

mod build;
mod constraints;
mod frequency;
mod mesh;
mod mobility;
mod numbering;
mod probes;
mod rod;
mod unknowns;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{DVector, Vector2};

use self::mesh::{Components, ElementMatrix};
use self::rod::Rod;
use crate::kernel::{Ends, ThermalStrain};
use crate::linear::{Bordered, BorderedLu, Filling, Layout, SingularAt};
use crate::scene::Force;

pub use probes::Instant;

/// What one unknown measures; its force is compared with others as a force over this length.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Position,
    /// A slope, with the length (m) over which its moment acts: h for r_y, l for r_x.
    Slope(f64),
    /// One of λ.
    Multiplier,
}

/// A named point of the scene.
#[derive(Clone, Debug)]
struct Point {
    start: [f64; 2],
    /// Its node in each of the rods that meet there, in the scene's order.
    nodes: Vec<Node>,
}

/// A rod's node at a point: places in the rod's chain of its position and of the slope that turns with the section.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    rod: usize,
    position: usize,
    slope: usize,
}

/// A row of Φ(q) = 0: Σ weight · displacement, the multiplier that keeps it, and whose unknowns it holds.
#[derive(Clone, Debug)]
struct ConstraintRow {
    multiplier: usize,
    /// Rod, unknown, weight.
    terms: Vec<(usize, usize, f64)>,
}

/// A structure ready for statics and dynamics.
#[derive(Clone, Debug)]
pub struct Structure {
    rods: Vec<Rod>,
    kinds: Vec<Kind>,
    points: BTreeMap<String, Point>,
    /// There are none in the condensed form.
    rows: Vec<ConstraintRow>,
    layout: Arc<Layout>,
    gravity: DVector<f64>,
    forces: Vec<Force>,
    start: DVector<f64>,
    /// Statics: loads and heat grow with a factor in place of time.
    grows: bool,
    /// Force or moment of a unit strain on each unknown, N and N m.
    unit_forces: DVector<f64>,
    /// Length of the shortest element, m.
    shortest: f64,
}

/// Both ends of a step, with the thermal strains of the rods.
pub type StepEnds<'a> = Ends<'a, DVector<f64>, &'a [ThermalStrain]>;

impl Structure {
    /// Number of unknowns, multipliers among them.
    pub fn size(&self) -> usize {
        self.kinds.len()
    }

    /// Memory that one matrix with its factors takes, bytes.
    pub fn matrix_bytes(&self) -> usize {
        self.layout.bytes()
    }

    /// Displacement at t = 0: zero, or the stress-free one of a relaxed start.
    pub fn start(&self) -> &DVector<f64> {
        &self.start
    }

    /// Mass matrix of the unknowns.
    pub fn mass(&self) -> Bordered {
        self.assemble_matrix(|_| ElementMatrix::Mass)
    }

    /// Its product with an acceleration (or a velocity), without the matrix.
    pub fn inertia(&self, a: &DVector<f64>) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        self.rods.iter().for_each(|rod| rod.mesh.add_inertia(&rod.chain, a, &mut sum));
        sum
    }

    /// Generalized force of gravity, constant.
    pub fn gravity(&self) -> &DVector<f64> {
        &self.gravity
    }

    /// Generalized force of the point forces at time `t`.
    pub fn point_forces(&self, t: f64) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        for force in &self.forces {
            self.components(&force.point).add(&Vector2::from(force.at(t)), &mut sum);
        }
        sum
    }

    /// All external forces at time `t`, in statics at the load factor `t`.
    pub fn load(&self, t: f64) -> DVector<f64> {
        let load = if self.forces.is_empty() { self.gravity.clone() } else { &self.gravity + self.point_forces(t) };
        if self.grows { load * t } else { load }
    }

    /// Thermal strain (along, across) of each rod at time `t`, in statics at the load factor `t`.
    pub fn thermal_strains(&self, t: f64) -> Vec<ThermalStrain> {
        let strain =
            |rod: &Rod| if self.grows { rod.thermal_strain(0.0).map(|full| t * full) } else { rod.thermal_strain(t) };
        self.rods.iter().map(strain).collect()
    }

    /// A force vector's largest entry, N, moments taken over their own length (h or l); constraint rows are no forces.
    pub fn largest(&self, force: &DVector<f64>) -> f64 {
        let entries = force.iter().zip(&self.kinds).map(|(value, kind)| match kind {
            Kind::Position => value.abs(),
            Kind::Slope(length) => value.abs() / length,
            Kind::Multiplier => 0.0,
        });
        // `f64::max` would drop a NaN.
        entries.fold(0.0, |largest, value| if value > largest || value.is_nan() { value } else { largest })
    }

    /// Whether no entry of a residual at `u` and time `t` is above `times` the rounding error of the elastic forces.
    ///
    /// A strain is made of differences of u over an element's length l, of slopes and of the thermal strain: it carries
    /// ε_mach times the largest of |u|/l, |slope| and |ε_T|, and a force that strain's share of the force of a unit strain.
    pub fn within_rounding(&self, residual: &DVector<f64>, u: &DVector<f64>, t: f64, times: f64) -> bool {
        let size = |(u, kind): (&f64, &Kind)| match kind {
            Kind::Position => u.abs() / self.shortest,
            Kind::Slope(_) => u.abs(),
            // During an iteration λ stands in its place: newtons, no strain.
            Kind::Multiplier => 0.0,
        };
        let heat = self.thermal_strains(t).into_iter().flatten().map(f64::abs).fold(0.0, f64::max);
        let size = u.iter().zip(&self.kinds).map(size).fold(heat, f64::max);
        let floor = times * f64::EPSILON * size;
        let mut entries = residual.iter().zip(&self.unit_forces).zip(&self.kinds);
        entries.all(|((value, unit), kind)| *kind == Kind::Multiplier || value.abs() <= floor * unit)
    }

    /// Rounding error of an energy, J: ε_mach times the strain energy of a strain of 1.
    pub fn energy_rounding(&self) -> f64 {
        let positions = self.unit_forces.iter().zip(&self.kinds).filter(|(_, kind)| **kind == Kind::Position);
        let length: f64 = self.rods.iter().map(|rod| rod.elements as f64 * rod.along.norm()).sum();
        f64::EPSILON * length * positions.map(|(force, _)| *force).fold(0.0, f64::max)
    }

    /// Elastic forces into `sum`, at the rods' thermal strains.
    pub fn force(&self, u: &DVector<f64>, thermal: &[ThermalStrain], sum: &mut DVector<f64>) {
        sum.fill(0.0);
        for (rod, eps_t) in self.rods.iter().zip(thermal) {
            rod.mesh.add_force(&rod.chain, u, *eps_t, sum);
        }
    }

    /// Tangent ∂Q/∂u.
    pub fn tangent(&self, u: &DVector<f64>, thermal: &[ThermalStrain]) -> Bordered {
        self.assemble_matrix(|n| ElementMatrix::Tangent { u, eps_t: thermal[n], stiffness: 1.0, mass: 0.0 })
    }

    /// LU factors of `stiffness` · (tangent, with the constraints' forces where there are multipliers) + `mass` · M. `old` ones
    /// give their memory, here and below.
    ///
    /// # Errors
    /// The unknown with a vanishing pivot; [`place`](Structure::place) says where that is.
    pub fn tangent_factors(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        [stiffness, mass]: [f64; 2],
        old: Option<BorderedLu>,
    ) -> Result<BorderedLu, SingularAt> {
        self.factors(|n| ElementMatrix::Tangent { u, eps_t: thermal[n], stiffness, mass }, stiffness, old)
    }

    /// LU factors of the tangent for Newton's iteration with independent stresses: those that the iteration expected when it
    /// went from `before` to `u` ([`Beam::mixed_tangent`](crate::kernel::Beam::mixed_tangent)).
    ///
    /// # Errors
    /// Those of [`tangent_factors`](Structure::tangent_factors).
    pub fn mixed_tangent_factors(
        &self,
        before: &DVector<f64>,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        old: Option<BorderedLu>,
    ) -> Result<BorderedLu, SingularAt> {
        self.factors(|n| ElementMatrix::Mixed { before, u, eps_t: thermal[n] }, 1.0, old)
    }

    /// LU factors of the derivative of [`mean_force`](Structure::mean_force) with respect to `u_1`, + `mass` · M.
    ///
    /// # Errors
    /// Those of [`tangent_factors`](Structure::tangent_factors).
    pub fn mean_tangent_factors(
        &self,
        step: &StepEnds,
        mass: f64,
        old: Option<BorderedLu>,
    ) -> Result<BorderedLu, SingularAt> {
        self.factors(|n| ElementMatrix::Mean { ends: of_rod(step, n), mass }, 1.0, old)
    }

    /// LU factors of the mass matrix, with the constraints where there are multipliers.
    ///
    /// # Errors
    /// Those of [`tangent_factors`](Structure::tangent_factors).
    pub fn mass_factors(&self) -> Result<BorderedLu, SingularAt> {
        self.factors(|_| ElementMatrix::Mass, 1.0, None)
    }

    /// LU factors of a matrix, asked for by the number of a rod; `constraint` is the factor of Φ_qᵀ beside it.
    fn factors<'a>(
        &self,
        matrix: impl Fn(usize) -> ElementMatrix<'a>,
        constraint: f64,
        old: Option<BorderedLu>,
    ) -> Result<BorderedLu, SingularAt> {
        if self.rows.is_empty() {
            return Bordered::lu_block_by_block(&self.layout, old, |n, block| self.fill(n, &matrix(n), block));
        }
        // Where coordinates stand beside multipliers, rows and columns of all blocks have to be scaled first.
        let mut matrix = self.assemble_matrix(matrix);
        self.add_constraints(constraint, &mut matrix);
        matrix.equilibrated_lu()
    }

    /// Adds the matrices of a rod's elements to its block.
    fn fill(&self, n: usize, matrix: &ElementMatrix, block: &mut Filling) {
        self.rods[n].mesh.add_matrix(&self.rods[n].chain, matrix, block);
    }

    /// Step-averaged elastic forces of the energy–momentum rule into `sum`.
    pub fn mean_force(&self, step: &StepEnds, sum: &mut DVector<f64>) {
        sum.fill(0.0);
        for (n, rod) in self.rods.iter().enumerate() {
            rod.mesh.add_mean_force(&rod.chain, &of_rod(step, n), sum);
        }
    }

    /// Strain energy, J.
    pub fn strain_energy(&self, u: &DVector<f64>, thermal: &[ThermalStrain]) -> f64 {
        self.rods.iter().zip(thermal).map(|(rod, eps_t)| rod.mesh.energy(&rod.chain, u, *eps_t)).sum()
    }

    /// Kinetic energy of velocities `v`, J.
    pub fn kinetic_energy(&self, v: &DVector<f64>) -> f64 {
        0.5 * v.dot(&self.inertia(v))
    }

    /// Energy that heating puts in over a step, J.
    pub fn heating_work(&self, step: &StepEnds) -> f64 {
        self.rods.iter().enumerate().map(|(n, rod)| rod.mesh.heating_work(&rod.chain, &of_rod(step, n))).sum()
    }

    /// Where an unknown is, in words.
    pub fn place(&self, unknown: usize) -> String {
        let is_it = |vector: &Components, unknown| vector.unknowns.contains(&Some(unknown));
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

    /// Sum of the elements' matrices, asked for by the number of a rod.
    fn assemble_matrix<'a>(&self, matrix: impl Fn(usize) -> ElementMatrix<'a>) -> Bordered {
        let mut sum = Bordered::zeros(&self.layout);
        for n in 0..self.rods.len() {
            self.fill(n, &matrix(n), &mut sum.block(n));
        }
        sum
    }
}

/// A step with the thermal strains of one rod.
fn of_rod<'a>(step: &StepEnds<'a>, rod: usize) -> Ends<'a, DVector<f64>> {
    Ends { u_0: step.u_0, u_1: step.u_1, thermal_0: step.thermal_0[rod], thermal_1: step.thermal_1[rod] }
}
