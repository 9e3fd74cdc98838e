//! Pinned rods as equations of motion, q̈ = A (f − Q_e), with room for mistakes.
//!
//! The library's own structures have none, so that this is a second program: Gauss sums of the energy's derivative over shape
//! functions, dense matrices, and constraints Φ = Φ_q (q − q_0) eliminated by A = M⁻¹ − M⁻¹Φ_qᵀ(Φ_q M⁻¹Φ_qᵀ)⁻¹Φ_q M⁻¹.
//! Coordinates are those of `structure.json`: rod by rod, vector by vector, x before y.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeMap;

use ancf::model::Element;
use nalgebra::{DMatrix, DVector, Vector2};

use super::body::Body;
use super::constraint::{Place, eliminated, fixed, rows};
use super::element::vectors;
use super::rod::Rod;
use super::setup::Setup;

/// Rods with masses, loads and constraints.
#[derive(Debug)]
pub struct Rods {
    rods: Vec<Rod>,
    /// Coordinates of the straight rods, unstretched.
    straight: DVector<f64>,
    /// Coordinates at t = 0.
    pub start: DVector<f64>,
    /// Mass matrix m of (23).
    pub mass: DMatrix<f64>,
    /// A: from forces to accelerations that the constraints allow.
    to_acceleration: DMatrix<f64>,
    weight: DVector<f64>,
    forces: Vec<PointForce>,
    /// First coordinate of each point.
    points: BTreeMap<String, usize>,
    mass_damping: f64,
    /// Coordinates held by springs, and their stiffness, N/m.
    springs: (Vec<usize>, f64),
    /// Time by which loads and heat lag, s.
    delay: f64,
}

#[derive(Debug)]
struct PointForce {
    at: usize,
    force: [f64; 2],
    history: Option<Vec<[f64; 2]>>,
}

impl Rods {
    /// Rods of a setup; `None` if the masses do not determine the accelerations.
    pub fn new(setup: &Setup) -> Option<Rods> {
        let scene = &setup.scene;
        let (mut rods, mut size) = (Vec::new(), 0);
        let mut points: BTreeMap<String, usize> = BTreeMap::new();
        // Position of each rod at each of its points, and its section's vector there.
        let mut places: BTreeMap<&str, Vec<Place>> = BTreeMap::new();
        for (number, rod) in scene.rods.iter().enumerate() {
            let (of_element, stride) = vectors(rod.element);
            let first = size;
            let end = first + 2 * stride * rod.elements;
            size = end + 2 * (of_element - stride);
            let mut named = vec![(&rod.from, first, first + 2), (&rod.to, end, end + 2)];
            if let Some(pivot) = &rod.pivot {
                let middle = first + 2 * stride * (rod.elements / 2);
                match (rod.elements % 2, rod.element) {
                    (0, _) => named.push((pivot, middle, middle + 2)),
                    (_, Element::Ancf) => named.push((pivot, middle + 4, middle + 8)),
                    (_, Element::EulerBernoulli) => return None,
                }
            }
            for (name, at, section) in named {
                points.entry(name.to_string()).or_insert(at);
                places.entry(name.as_str()).or_default().push((number, at, section));
            }
            rods.push(Rod::new(setup, rod, first));
        }
        let mut all = Rods {
            straight: DVector::zeros(size),
            start: DVector::zeros(size),
            mass: DMatrix::zeros(size, size),
            to_acceleration: DMatrix::zeros(size, size),
            weight: DVector::zeros(size),
            forces: Vec::new(),
            points,
            mass_damping: setup.mass_damping,
            springs: (Vec::new(), setup.support_springs.unwrap_or(0.0)),
            delay: setup.delay,
            rods,
        };
        for (rod, model) in all.rods.iter().zip(&scene.rods) {
            let from = Vector2::from(scene.points.get(&model.from).copied()?);
            let to = Vector2::from(scene.points.get(&model.to).copied()?);
            rod.place(model.element, from, to, &mut all.straight);
            let (material, section) = (scene.material(model), scene.section(model));
            let body = Body {
                element: model.element,
                length: (to - from).norm() / model.elements as f64,
                height: section.height,
                area: section.height * section.width,
                rho: material.rho,
            };
            body.assemble(setup, rod, &mut all.mass, &mut all.weight);
        }
        all.start = all.straight.clone();
        for (rod, model) in all.rods.iter().zip(&scene.rods) {
            rod.stretch(model.element, setup.start_at_rest, &mut all.start);
        }
        all.forces = (scene.forces.iter())
            .filter_map(|force| {
                let at = *all.points.get(&force.point)?;
                Some(PointForce { at, force: force.force, history: force.history.clone() })
            })
            .collect();
        if setup.support_springs.is_some() {
            all.springs.0 = fixed(setup, &all.points);
        }
        let rows = rows(setup, &all.rods, &all.points, &places)?;
        all.to_acceleration = eliminated(&all.mass, &rows)?;
        Some(all)
    }

    /// Number of coordinates.
    pub fn size(&self) -> usize {
        self.start.len()
    }

    /// q̈ at time `t`.
    pub fn accelerate(
        &self,
        t: f64,
        q: &DVector<f64>,
        v: &DVector<f64>,
        force: &mut DVector<f64>,
        a: &mut DVector<f64>,
    ) {
        let t = (t - self.delay).max(0.0);
        force.copy_from(&self.weight);
        for PointForce { at, force: [x, y], history } in &self.forces {
            let factor = history.as_ref().map_or(1.0, |history| interpolate(history, t));
            force[*at] += factor * x;
            force[at + 1] += factor * y;
        }
        for rod in &self.rods {
            rod.subtract_force(t, q.as_slice(), v.as_slice(), force.as_mut_slice());
        }
        let (held, stiffness) = &self.springs;
        held.iter().for_each(|at| force[*at] -= stiffness * (q[*at] - self.start[*at]));
        if self.mass_damping != 0.0 {
            force.gemv(-self.mass_damping, &self.mass, v, 1.0);
        }
        a.gemv(1.0, &self.to_acceleration, force, 0.0);
    }

    /// Kinetic, strain and potential energy.
    pub fn energies(&self, t: f64, q: &DVector<f64>, v: &DVector<f64>) -> [f64; 3] {
        let kinetic = 0.5 * v.dot(&(&self.mass * v));
        let strain = self.rods.iter().map(|rod| rod.energy(t, q.as_slice())).sum();
        [kinetic, strain, -self.weight.dot(q)]
    }

    /// Strain energy at t = 0.
    pub fn strain_at_the_start(&self) -> f64 {
        self.rods.iter().map(|rod| rod.energy(0.0, self.start.as_slice())).sum()
    }

    /// Names of the points with the first coordinate of each.
    pub fn points(&self) -> impl Iterator<Item = (&str, usize)> {
        self.points.iter().map(|(name, at)| (name.as_str(), *at))
    }
}

/// Value of a history: linear between its entries, constant outside.
fn interpolate(history: &[[f64; 2]], t: f64) -> f64 {
    let next = history.partition_point(|[time, _]| *time <= t);
    let before = next.checked_sub(1).and_then(|last| history.get(last));
    match (before, history.get(next)) {
        (Some([t0, from]), Some([t1, to])) => from + (to - from) * (t - t0) / (t1 - t0),
        (Some([_, value]), None) | (None, Some([_, value])) => *value,
        (None, None) => 0.0,
    }
}
