//! Rods, pins and supports → numbering, assembly, loads.
//!
//! The unknowns are the displacements u = q − q₀ of the nodal coordinates from the initial configuration. Rods that name
//! the same point share its position (a pin) and keep their own slopes; a supported component is no unknown at all.

use std::collections::BTreeMap;

use nalgebra::{DVector, Vector2};

use crate::equations::force::{Element, Matrix14};
use crate::equations::shape::{self, Nodes, Vector14};
use crate::equations::{inertia, material};
use crate::kernel::{Ends, Kernel, ThermalStrain};
use crate::linear::BandMatrix;
use crate::scene::{Direction, Rod, Scene, Start, Temperature, ThermalModel};

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

/// Hands out unknowns, one nodal vector after the other.
#[derive(Default)]
struct Numbering {
    kinds: Vec<Kind>,
}

impl Numbering {
    fn vector(&mut self, kind: Kind, held: [bool; 2]) -> [Option<usize>; 2] {
        held.map(|held| {
            (!held).then(|| {
                self.kinds.push(kind);
                self.kinds.len() - 1
            })
        })
    }
}

impl Structure {
    /// Builds the structure of a (validated) scene.
    pub fn new(scene: &Scene) -> Structure {
        let (lambda, mu) = (
            material::lambda(scene.material.youngs_modulus, scene.material.nu),
            material::mu(scene.material.youngs_modulus, scene.material.nu),
        );
        let (h, w) = (scene.section.height, scene.section.width);
        let gravity = Vector2::from(scene.gravity);

        let mut numbering = Numbering::default();
        let mut points = BTreeMap::new();
        let (mut rods, mut places) = (Vec::new(), Vec::new());
        for (number, rod) in scene.rods.iter().enumerate() {
            let (from, to) = (Vector2::from(scene.points[&rod.from]), Vector2::from(scene.points[&rod.to]));
            let element = straight_element(from, (to - from) / rod.elements as f64, h, w);
            let l = element.l;
            let mut at_point = |name: &str, numbering: &mut Numbering| {
                let new = || (scene.points[name], numbering.vector(Kind::Position, held(scene, name)));
                points.entry(name.to_string()).or_insert_with(new).1
            };
            let free = [false; 2];
            let mut r = at_point(&rod.from, &mut numbering);
            let mut r_y = numbering.vector(Kind::Slope(h), free);
            for n in 1..=rod.elements {
                let (r_i, r_y_i) = (r, r_y);
                let r_j = numbering.vector(Kind::Position, free);
                let r_x_j = numbering.vector(Kind::Slope(l), free);
                let r_y_j = numbering.vector(Kind::Slope(h), free);
                r = if n == rod.elements {
                    at_point(&rod.to, &mut numbering)
                } else {
                    numbering.vector(Kind::Position, free)
                };
                r_y = numbering.vector(Kind::Slope(h), free);
                let vectors = [r_i, r_y_i, r_j, r_x_j, r_y_j, r, r_y];
                places.push(Place { rod: number, unknowns: std::array::from_fn(|i| vectors[i / 2][i % 2]) });
            }
            let direction = to - from;
            rods.push(RodElement {
                element,
                kernel: Kernel::new(l, h, w, direction.y.atan2(direction.x), lambda, mu),
                mass: inertia::M(scene.material.rho, &element),
                gravity: inertia::Q_w_gravity(&gravity, scene.material.rho, &element),
            });
        }

        let size = numbering.kinds.len();
        let band = places.iter().map(|place| spread(&place.unknowns)).max().unwrap_or(0);
        let lengths = || rods.iter().map(|rod: &RodElement| rod.element.l);
        let longest = lengths().fold(0.0, f64::max);
        let mut structure = Structure {
            kinds: numbering.kinds,
            points,
            band,
            mass: BandMatrix::zeros(size, band),
            gravity: DVector::zeros(size),
            start: DVector::zeros(size),
            heat: scene
                .heat()
                .map(|temperature| Heat { temperature: temperature.clone(), alpha: scene.material.alpha }),
            unit_force: (lambda + 2.0 * mu) * h * w * (longest / h).max(1.0),
            shortest: lengths().fold(f64::INFINITY, f64::min),
            rods,
            places,
        };
        structure.mass = structure.assemble_matrix(|_, rod| rod.mass);
        structure.gravity = structure.assemble_vector(|_, rod| rod.gravity);
        if let Some(Heat { temperature, .. }) = &structure.heat
            && temperature.start == Start::Relaxed
        {
            structure.start = structure.relaxed(scene);
        }
        structure
    }

    /// Displacement from the initial to the stress-free configuration at ΔT(0): a stretch √(1 + 2ε) in each heated
    /// direction, about the supported point (or the beginning of the rod).
    fn relaxed(&self, scene: &Scene) -> DVector<f64> {
        let [along, across] = self.thermal_strain(0.0).map(|eps| (1.0 + 2.0 * eps).sqrt() - 1.0);
        let mut u = DVector::zeros(self.size());
        let mut first = 0;
        for (rod, data) in scene.rods.iter().zip(&self.rods) {
            let about = scene.supports.first().map_or(&rod.from, |support| &support.point);
            let (from, about) = (Vector2::from(scene.points[&rod.from]), Vector2::from(scene.points[about]));
            let direction = Vector2::from(scene.points[&rod.to]) - from;
            for n in 0..rod.elements {
                let origin = from - about + direction * (n as f64 / rod.elements as f64);
                let e_0 = shape::nodes(&data.element.e_0);
                let position = |r: Vector2<f64>| along * (origin + r - e_0.r_i);
                let u_e = shape::e(&Nodes {
                    r_i: position(e_0.r_i),
                    r_y_i: across * e_0.r_y_i,
                    r_j: position(e_0.r_j),
                    r_x_j: along * e_0.r_x_j,
                    r_y_j: across * e_0.r_y_j,
                    r_k: position(e_0.r_k),
                    r_y_k: across * e_0.r_y_k,
                });
                for (unknown, value) in self.places[first + n].unknowns.iter().zip(&u_e) {
                    if let Some(unknown) = *unknown {
                        u[unknown] = *value;
                    }
                }
            }
            first += rod.elements;
        }
        u
    }

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

    /// Thermal strains at the start and at the corners of the temperature's history, between which they are linear.
    fn thermal_extremes(&self) -> Vec<ThermalStrain> {
        let times = self.heat.iter().flat_map(|heat| heat.temperature.history.iter().map(|&[t, _]| t));
        std::iter::once(0.0).chain(times).map(|t| self.thermal_strain(t)).collect()
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

    /// An upper bound of the largest angular frequency, rad/s, at the start and every corner of the heat's history.
    ///
    /// A structure's largest frequency is not above the largest of its elements taken free (Irons and Treharne 1971):
    /// Rayleigh's quotient of the whole is a weighted mean of its elements'.
    pub fn largest_frequency(&self) -> f64 {
        let mut largest: f64 = 0.0;
        let mut first = 0;
        while let Some(place) = self.places.get(first) {
            let rod = &self.rods[place.rod];
            for thermal in self.thermal_extremes() {
                // All elements of a rod start alike but for a translation, which does not matter.
                let stiffness = rod.kernel.tangent(&place.gather(&self.start), thermal);
                largest = largest.max(largest_eigenvalue(&stiffness, &rod.mass));
            }
            first += self.places[first..].iter().take_while(|other| other.rod == place.rod).count();
        }
        largest.max(0.0).sqrt()
    }

    /// The shortest time in which an axial wave, √((λ + 2μ)/ρ) fast, crosses an element, s.
    pub fn wave_crossing_time(scene: &Scene) -> f64 {
        let (youngs_modulus, nu) = (scene.material.youngs_modulus, scene.material.nu);
        let stiff = material::lambda(youngs_modulus, nu) + 2.0 * material::mu(youngs_modulus, nu);
        let speed = (stiff / scene.material.rho).sqrt();
        let length = |rod: &Rod| {
            let ends = Vector2::from(scene.points[&rod.to]) - Vector2::from(scene.points[&rod.from]);
            ends.norm() / rod.elements as f64
        };
        scene.rods.iter().map(length).fold(f64::INFINITY, f64::min) / speed
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

/// Which components of a point the scene's supports hold.
fn held(scene: &Scene, point: &str) -> [bool; 2] {
    let fixed = |direction| scene.supports.iter().any(|s| s.point == point && s.fix.contains(&direction));
    [fixed(Direction::X), fixed(Direction::Y)]
}

/// How far apart an element's unknowns are numbered.
fn spread(unknowns: &[Option<usize>; 14]) -> usize {
    let numbers = || unknowns.iter().flatten();
    numbers().max().zip(numbers().min()).map_or(0, |(last, first)| last - first)
}

/// The largest ω² of K φ = ω² M φ: with M = L Lᵀ the largest eigenvalue of L⁻¹ K L⁻ᵀ. NaN where M is not positive definite.
fn largest_eigenvalue(stiffness: &Matrix14, mass: &Matrix14) -> f64 {
    let reduced = mass.cholesky().and_then(|cholesky| {
        let lower = cholesky.l();
        let half = lower.solve_lower_triangular(stiffness)?;
        lower.solve_lower_triangular(&half.transpose())
    });
    reduced.map_or(f64::NAN, |matrix| matrix.symmetric_eigenvalues().max())
}
