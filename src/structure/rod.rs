//! A rod of equal elements: its nodal vectors among the unknowns, and what all elements share.

use nalgebra::{DVector, Rotation2, Vector2};

use super::StepEnds;
use crate::equations::force::{Element, Matrix14};
use crate::equations::shape::{self, Nodes, Vector14};
use crate::equations::{inertia, material};
use crate::kernel::{Ends, Kernel, ThermalStrain};
use crate::scene::{self, Scene, Temperature, ThermalModel};

/// Where the components of a nodal vector are among the unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Components {
    /// `None` where a support holds the component.
    pub unknowns: [Option<usize>; 2],
    /// From the vector's own axes to the global ones, where they differ.
    pub turn: Option<Rotation2<f64>>,
}

/// A rod with what all of its elements share.
#[derive(Clone, Debug)]
pub(super) struct Rod {
    pub name: String,
    pub elements: usize,
    pub element: Element,
    pub kernel: Kernel,
    pub mass: Matrix14,
    pub gravity: Vector14,
    pub heat: Option<Heat>,
    /// Its nodal vectors in the order r, r_y, then r_j, r_xj, r_yj, r_k, r_yk for each element.
    pub chain: Vec<Components>,
}

#[derive(Clone, Debug)]
pub(super) struct Heat {
    pub temperature: Temperature,
    pub alpha: f64,
}

impl Components {
    /// The nodal vector in a vector of unknowns, in global axes; zero where it is held.
    pub fn get(&self, u: &DVector<f64>) -> Vector2<f64> {
        let own = Vector2::from(self.unknowns.map(|unknown| unknown.map_or(0.0, |unknown| u[unknown])));
        self.turn.map_or(own, |turn| turn * own)
    }

    /// Adds a nodal vector, in global axes, to the unknowns; what is held takes none.
    pub fn add(&self, vector: &Vector2<f64>, sum: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                sum[unknown] += value;
            }
        }
    }

    /// Puts a nodal vector, in global axes, in its place.
    pub fn set(&self, vector: &Vector2<f64>, u: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                u[unknown] = *value;
            }
        }
    }
}

impl Rod {
    /// A rod by itself; its unknowns are not numbered yet.
    pub fn new(scene: &Scene, rod: &scene::Rod) -> Rod {
        let (material, section) = (scene.material(rod), scene.section(rod));
        let lambda = material::lambda(material.youngs_modulus, material.nu);
        let mu = material::mu(material.youngs_modulus, material.nu);
        let from = Vector2::from(scene.points[&rod.from]);
        let along = Vector2::from(scene.points[&rod.to]) - from;
        let element = straight_element(from, along / rod.elements as f64, section.height, section.width);
        Rod {
            name: rod.name.clone(),
            elements: rod.elements,
            kernel: Kernel::new(element.l, element.h, element.w, along.y.atan2(along.x), lambda, mu),
            mass: inertia::M(material.rho, &element),
            gravity: inertia::Q_w_gravity(&Vector2::from(scene.gravity), material.rho, &element),
            heat: scene.heat(rod).map(|heat| Heat { temperature: heat.clone(), alpha: material.alpha }),
            element,
            chain: vec![Components::default(); 5 * rod.elements + 2],
        }
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

    /// An element's nodal vectors.
    pub fn vectors(&self, element: usize) -> &[Components] {
        &self.chain[5 * element..5 * element + 7]
    }

    /// An element's 14 coordinates from a vector of unknowns, in global axes.
    pub fn gather(&self, element: usize, u: &DVector<f64>) -> Vector14 {
        let mut gathered = Vector14::zeros();
        for (n, vector) in self.vectors(element).iter().enumerate() {
            gathered.fixed_rows_mut::<2>(2 * n).copy_from(&vector.get(u));
        }
        gathered
    }

    /// Adds an element's force to the unknowns'.
    pub fn scatter(&self, element: usize, force: &Vector14, sum: &mut DVector<f64>) {
        for (n, vector) in self.vectors(element).iter().enumerate() {
            vector.add(&force.fixed_rows::<2>(2 * n).into_owned(), sum);
        }
    }

    /// An element's matrix in its nodal vectors' own axes.
    pub fn turned(&self, element: usize, mut matrix: Matrix14) -> Matrix14 {
        for (n, vector) in self.vectors(element).iter().enumerate() {
            if let Some(turn) = vector.turn {
                let rows = turn.inverse() * matrix.fixed_rows::<2>(2 * n);
                matrix.fixed_rows_mut::<2>(2 * n).copy_from(&rows);
                let columns = matrix.fixed_columns::<2>(2 * n) * turn;
                matrix.fixed_columns_mut::<2>(2 * n).copy_from(&columns);
            }
        }
        matrix
    }

    /// A function of both ends of a step for one element; `n` is the rod's number.
    pub fn over<T>(&self, step: &StepEnds, n: usize, element: usize, f: impl Fn(Ends<Vector14>) -> T) -> T {
        let (u_0, u_1) = (self.gather(element, step.u_0), self.gather(element, step.u_1));
        f(Ends { u_0: &u_0, u_1: &u_1, thermal_0: step.thermal_0[n], thermal_1: step.thermal_1[n] })
    }
}

/// The first element of a straight, unstretched rod: it begins at `from` and spans `along`.
fn straight_element(from: Vector2<f64>, along: Vector2<f64>, h: f64, w: f64) -> Element {
    let l = along.norm();
    let t = along / l;
    let n = Vector2::new(-t.y, t.x);
    let e_0 = shape::e(&Nodes {
        r_i: from,
        r_y_i: n,
        r_j: from + 0.5 * along,
        r_x_j: t,
        r_y_j: n,
        r_k: from + along,
        r_y_k: n,
    });
    Element { l, h, w, e_0 }
}

/// Stretches less 1 (along, across) at which a thermal strain makes no stress: √(1 + 2ε) − 1.
pub(super) fn stress_free(thermal: ThermalStrain) -> [f64; 2] {
    thermal.map(|strain| (1.0 + 2.0 * strain).sqrt() - 1.0)
}

/// Displacement of an element under the stretches 1 + `along`, 1 + `across`, its node i at `origin` from the fixed point.
pub(super) fn stretched(element: &Element, [along, across]: [f64; 2], origin: Vector2<f64>) -> Vector14 {
    let e_0 = shape::nodes(&element.e_0);
    let position = |r: Vector2<f64>| along * (origin + r - e_0.r_i);
    shape::e(&Nodes {
        r_i: position(e_0.r_i),
        r_y_i: across * e_0.r_y_i,
        r_j: position(e_0.r_j),
        r_x_j: along * e_0.r_x_j,
        r_y_j: across * e_0.r_y_j,
        r_k: position(e_0.r_k),
        r_y_k: across * e_0.r_y_k,
    })
}
