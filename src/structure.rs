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
//! Either way the matrices have one block a rod, bordered by what rods share: eliminated element by element in the condensed
//! form ([`Chains`]), as a whole beside multipliers ([`Bordered`]).

mod build;
mod collapse;
mod components;
mod constraints;
mod equal;
mod frequency;
mod mass;
mod matrix;
mod mesh;
mod mobility;
mod numbering;
mod place;
mod probes;
mod rod;
mod rounding;
mod unknowns;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Complex, DVector, Vector2};

use self::components::Components;
use self::mesh::ElementMatrix;
use self::rod::Rod;
use crate::kernel::{Ends, ThermalStrain};
use crate::linear::{Bordered, Chain, Chains, Filling, Layout, Number, SingularAt};
use crate::plan::Plan;
use crate::scene::Force;

pub use mass::MassFactors;
pub use matrix::{Factors, Matrix};
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
    plan: Plan,
    rods: Arc<[Rod]>,
    kinds: Vec<Kind>,
    /// One over the length over which an unknown's force is judged; 0 for multipliers.
    weights: DVector<f64>,
    /// One over the length of its elements for a position; for a slope 1, of r_y in elements higher than long h/l; 0 for a multiplier.
    shares: DVector<f64>,
    points: BTreeMap<String, Point>,
    /// There are none in the condensed form.
    rows: Vec<ConstraintRow>,
    layout: Arc<Layout>,
    gravity: DVector<f64>,
    forces: Vec<Force>,
    /// Where they act.
    force_places: Vec<Components>,
    start: DVector<f64>,
    start_velocity: DVector<f64>,
    /// Statics: loads and heat grow with a factor in place of time.
    grows: bool,
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

/// Entries of the largest element's matrix.
const MOST_ENTRIES: usize = 14 * 14;

impl Structure {
    /// Number of unknowns, multipliers among them.
    pub fn size(&self) -> usize {
        self.kinds.len()
    }

    /// Memory that one matrix with its factors takes, bytes.
    pub fn matrix_bytes(&self) -> usize {
        match self.factors() {
            Factors::Chains(chains) => chains.bytes(),
            Factors::Bordered(_) => self.layout.bytes(),
        }
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

    /// Mass matrix of the unknowns.
    pub fn mass(&self) -> Bordered {
        self.assemble_matrix(|_| ElementMatrix::Mass)
    }

    /// Its product with an acceleration (or a velocity), without the matrix.
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

    /// Generalized force of gravity, constant.
    pub fn gravity(&self) -> &DVector<f64> {
        &self.gravity
    }

    /// Adds `factor` · the generalized force of the point forces at time `t`.
    pub fn add_point_forces(&self, t: f64, factor: f64, sum: &mut DVector<f64>) {
        for (force, place) in self.forces.iter().zip(&self.force_places) {
            place.add(&(factor * Vector2::from(force.at(t))), sum);
        }
    }

    /// All external forces at time `t`, in statics at the load factor `t`.
    pub fn load(&self, t: f64) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        self.load_into(t, &mut sum);
        sum
    }

    /// The same into `sum`.
    pub fn load_into(&self, t: f64, sum: &mut DVector<f64>) {
        if self.plan.weight {
            sum.copy_from(&self.gravity);
        } else {
            sum.fill(0.0);
        }
        self.add_point_forces(t, 1.0, sum);
        if self.grows {
            *sum *= t;
        }
    }

    /// Thermal strain (along, across) of each rod at time `t`, in statics at the load factor `t`.
    pub fn thermal_strains(&self, t: f64) -> Vec<ThermalStrain> {
        self.rods.iter().map(|rod| self.thermal_strain(rod, t)).collect()
    }

    /// The same into `thermal`, which has a place for each rod and was given by [`thermal_strains`](Structure::thermal_strains).
    pub fn thermal_strains_into(&self, t: f64, thermal: &mut [ThermalStrain]) {
        if !self.plan.heat {
            return;
        }
        for (rod, thermal) in self.rods.iter().zip(thermal) {
            *thermal = self.thermal_strain(rod, t);
        }
    }

    fn thermal_strain(&self, rod: &Rod, t: f64) -> ThermalStrain {
        if !self.plan.heat {
            return [0.0; 2];
        }
        if self.grows { rod.thermal_strain(0.0).map(|full| t * full) } else { rod.thermal_strain(t) }
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
        let size = |(u, kind): (&f64, &Kind)| match kind {
            Kind::Position => u.abs(),
            Kind::Slope(length) => u.abs() * length,
            Kind::Multiplier => 0.0,
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

    /// Tangent ∂Q/∂u.
    pub fn tangent(&self, u: &DVector<f64>, thermal: &[ThermalStrain]) -> Bordered {
        self.assemble_matrix(|n| ElementMatrix::Tangent { u, eps_t: thermal[n], stiffness: 1.0, mass: 0.0 })
    }

    /// In how many independent directions the equilibrium at the load factor `t` is unstable: negative eigenvalues of the tangent.
    /// `None` where elimination does not tell.
    pub fn unstable_directions(&self, u: &DVector<f64>, t: f64) -> Option<usize> {
        self.tangent(u, &self.thermal_strains(t)).negative_eigenvalues()
    }

    /// Memory for factors of its matrices.
    pub fn factors(&self) -> Factors {
        if self.rows.is_empty() {
            let chains = self.rods.iter().map(|rod| rod.mesh.chain(self.layout.border)).collect();
            Factors::Chains(self.chains(chains))
        } else {
            Factors::Bordered(None)
        }
    }

    /// Memory for the factors of complex matrices; in the condensed form only.
    pub fn complex_factors(&self) -> Chains<Complex<f64>> {
        self.chains(self.rods.iter().map(|rod| rod.mesh.complex_chain(self.layout.border)).collect())
    }

    fn chains<F: Number>(&self, chains: Vec<Box<dyn Chain<F>>>) -> Chains<F> {
        Chains::new(chains, self.layout.border, self.layout.border_size, self.layout.border_band)
    }

    /// LU factors of a matrix.
    ///
    /// # Errors
    /// The unknown with a vanishing pivot; [`place`](Structure::place) says where that is.
    pub fn factorize(&self, matrix: Matrix, factors: &mut Factors) -> Result<(), SingularAt> {
        match factors {
            Factors::Chains(chains) => chains.factorize(|rod, element, columns| {
                self.rods[rod].mesh.matrix(element, &matrix.of_rod(rod), columns);
            }),
            // Where coordinates stand beside multipliers, rows and columns of all blocks have to be scaled first.
            Factors::Bordered(factors) => {
                let mut sum = self.assemble_matrix(|rod| matrix.of_rod(rod));
                self.add_constraints(matrix.constraint_factor(), &mut sum);
                *factors = Some(sum.equilibrated_lu()?);
                Ok(())
            }
        }
    }

    /// LU factors of M + `stiffness` · tangent for a complex `stiffness`, in the condensed form.
    ///
    /// # Errors
    /// Those of [`factorize`](Structure::factorize).
    pub fn factorize_complex(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        stiffness: Complex<f64>,
        factors: &mut Chains<Complex<f64>>,
    ) -> Result<(), SingularAt> {
        factors.factorize(|rod, element, columns| {
            let mesh = &self.rods[rod].mesh;
            let mut real = [0.0; MOST_ENTRIES];
            let real = &mut real[..columns.len()];
            let tangent = ElementMatrix::Tangent { u, eps_t: thermal[rod], stiffness: 1.0, mass: 0.0 };
            mesh.matrix(element, &tangent, real);
            columns.iter_mut().zip(&*real).for_each(|(entry, real)| *entry = stiffness * *real);
            mesh.matrix(element, &ElementMatrix::Mass, real);
            columns.iter_mut().zip(&*real).for_each(|(entry, real)| *entry += *real);
        })
    }

    /// Adds the matrices of a rod's elements to its block.
    fn fill(&self, n: usize, matrix: &ElementMatrix, block: &mut Filling) {
        self.rods[n].mesh.add_matrix(matrix, block);
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
