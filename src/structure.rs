//! Rods, pins and supports → numbering, assembly, loads.
//!
//! The unknowns are the displacements u = q − q₀ of the nodal coordinates from the initial configuration. Rods that name
//! the same point share its position (a pin) and keep their own slopes; a supported component is no unknown at all.

mod build;
mod frequency;
mod numbering;

use std::collections::BTreeMap;

use nalgebra::DVector;

use crate::equations::force::{Element, Matrix14};
use crate::equations::shape::Vector14;
use crate::kernel::{Ends, Kernel, ThermalStrain};
use crate::linear::BandMatrix;
use crate::scene::{Temperature, ThermalModel};

/// What one unknown measures; its force is compared with others as a force over this length.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Position,
    /// A slope, with the length (m) over which its moment acts: h for r_y, l for r_x.
    Slope(f64),
}

/// What all elements of one rod share.
#[derive(Clone, Debug)]
struct RodElement {
    element: Element,
    kernel: Kernel,
    mass: Matrix14,
    gravity: Vector14,
}

/// An element's place in the structure.
#[derive(Clone, Debug)]
struct Place {
    rod: usize,
    /// Unknown of each of the 14 coordinates, `None` where a support holds it.
    unknowns: [Option<usize>; 14],
}

/// A structure ready for statics and dynamics.
#[derive(Clone, Debug)]
pub struct Structure {
    rods: Vec<RodElement>,
    places: Vec<Place>,
    kinds: Vec<Kind>,
    points: BTreeMap<String, ([f64; 2], [Option<usize>; 2])>,
    band: usize,
    mass: BandMatrix,
    gravity: DVector<f64>,
    start: DVector<f64>,
    heat: Option<Heat>,
    /// Force of a unit strain, N, moments over their own length.
    unit_force: f64,
    /// Length of the shortest element, m.
    shortest: f64,
}

#[derive(Clone, Debug)]
struct Heat {
    temperature: Temperature,
    alpha: f64,
}

impl Structure {
    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.kinds.len()
    }

    /// Displacement at t = 0: zero, or the stress-free one of a relaxed start.
    pub fn start(&self) -> &DVector<f64> {
        &self.start
    }

    /// Mass matrix of the unknowns.
    pub fn mass(&self) -> &BandMatrix {
        &self.mass
    }

    /// Generalized force of gravity, constant.
    pub fn gravity(&self) -> &DVector<f64> {
        &self.gravity
    }

    /// Thermal strain (along, across) at time `t`.
    pub fn thermal_strain(&self, t: f64) -> ThermalStrain {
        let Some(Heat { temperature, alpha }) = &self.heat else { return [0.0; 2] };
        let strain = alpha * temperature.at(t);
        match temperature.model {
            ThermalModel::TwoD => [strain, strain],
            ThermalModel::OneD => [strain, 0.0],
            ThermalModel::None => [0.0; 2],
        }
    }

    /// A force vector's largest entry, N, moments taken over their own length (h or l).
    pub fn largest(&self, force: &DVector<f64>) -> f64 {
        let entries = force.iter().zip(&self.kinds).map(|(value, kind)| match kind {
            Kind::Position => value.abs(),
            Kind::Slope(length) => value.abs() / length,
        });
        // `f64::max` would drop a NaN.
        entries.fold(0.0, |largest, value| if value > largest || value.is_nan() { value } else { largest })
    }

    /// Rounding error of the elastic forces at `u`, N, moments over their own length.
    ///
    /// A strain is made of differences of u over an element's length l, and u carries ε_mach |u|: the error is that strain,
    /// ε_mach (1 + |u|/l), times the force of a unit strain.
    pub fn rounding(&self, u: &DVector<f64>) -> f64 {
        let largest = u.iter().zip(&self.kinds).filter(|(_, kind)| **kind == Kind::Position).map(|(u, _)| u.abs());
        self.unit_force * f64::EPSILON * (1.0 + largest.fold(0.0, f64::max) / self.shortest)
    }

    /// Position of a point of the scene.
    pub fn position(&self, point: &str, u: &DVector<f64>) -> [f64; 2] {
        let (start, _) = self.points[point];
        let [x, y] = self.at_point(point, u);
        [start[0] + x, start[1] + y]
    }

    /// A point's entries of a vector of unknowns, such as its velocity; zero where it is held.
    pub fn at_point(&self, point: &str, vector: &DVector<f64>) -> [f64; 2] {
        let (_, unknowns) = self.points[point];
        unknowns.map(|unknown| unknown.map_or(0.0, |unknown| vector[unknown]))
    }

    /// Elastic forces into `sum`.
    pub fn force(&self, u: &DVector<f64>, thermal: ThermalStrain, sum: &mut DVector<f64>) {
        sum.fill(0.0);
        for place in &self.places {
            let force = self.rods[place.rod].kernel.force(&place.gather(u), thermal);
            place.scatter(&force, sum);
        }
    }

    /// Tangent ∂Q/∂u.
    pub fn tangent(&self, u: &DVector<f64>, thermal: ThermalStrain) -> BandMatrix {
        self.assemble_matrix(|place, rod| rod.kernel.tangent(&place.gather(u), thermal))
    }

    /// Step-averaged elastic forces of the energy–momentum rule into `sum`.
    pub fn mean_force(&self, step: &Ends<DVector<f64>>, sum: &mut DVector<f64>) {
        sum.fill(0.0);
        for place in &self.places {
            let force = place.over(step, |ends| self.rods[place.rod].kernel.mean_force(&ends));
            place.scatter(&force, sum);
        }
    }

    /// Derivative of [`mean_force`](Structure::mean_force) with respect to `u_1`.
    pub fn mean_tangent(&self, step: &Ends<DVector<f64>>) -> BandMatrix {
        self.assemble_matrix(|place, rod| place.over(step, |ends| rod.kernel.mean_tangent(&ends)))
    }

    /// Strain energy, J.
    pub fn strain_energy(&self, u: &DVector<f64>, thermal: ThermalStrain) -> f64 {
        self.places.iter().map(|place| self.rods[place.rod].kernel.energy(&place.gather(u), thermal)).sum()
    }

    /// Kinetic energy, J.
    pub fn kinetic_energy(&self, v: &DVector<f64>) -> f64 {
        0.5 * v.dot(&self.mass.mul(v))
    }

    /// Energy that heating puts in over a step, J.
    pub fn heating_work(&self, step: &Ends<DVector<f64>>) -> f64 {
        let work = |place: &Place| place.over(step, |ends| self.rods[place.rod].kernel.heating_work(&ends));
        self.places.iter().map(work).sum()
    }

    fn assemble_vector(&self, f: impl Fn(&Place, &RodElement) -> Vector14) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        for place in &self.places {
            place.scatter(&f(place, &self.rods[place.rod]), &mut sum);
        }
        sum
    }

    fn assemble_matrix(&self, f: impl Fn(&Place, &RodElement) -> Matrix14) -> BandMatrix {
        let mut sum = BandMatrix::zeros(self.size(), self.band);
        for place in &self.places {
            let matrix = f(place, &self.rods[place.rod]);
            for (j, column) in place.unknowns.iter().enumerate() {
                for (i, row) in place.unknowns.iter().enumerate() {
                    if let (Some(row), Some(column)) = (*row, *column) {
                        sum.add(row, column, matrix[(i, j)]);
                    }
                }
            }
        }
        sum
    }
}

impl Place {
    fn gather(&self, u: &DVector<f64>) -> Vector14 {
        Vector14::from_fn(|i, _| self.unknowns[i].map_or(0.0, |unknown| u[unknown]))
    }

    fn scatter(&self, element: &Vector14, sum: &mut DVector<f64>) {
        for (unknown, value) in self.unknowns.iter().zip(element) {
            if let Some(unknown) = *unknown {
                sum[unknown] += value;
            }
        }
    }

    fn over<T>(&self, step: &Ends<DVector<f64>>, f: impl Fn(Ends<Vector14>) -> T) -> T {
        let (u_0, u_1) = (self.gather(step.u_0), self.gather(step.u_1));
        f(Ends { u_0: &u_0, u_1: &u_1, thermal_0: step.thermal_0, thermal_1: step.thermal_1 })
    }
}
