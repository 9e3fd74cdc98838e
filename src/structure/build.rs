//! From a scene to a structure: numbering, loads, the relaxed start.

use std::collections::BTreeMap;

use nalgebra::{DVector, Vector2};

use super::numbering::{NodalVector, Vectors, number};
use super::{Heat, Kind, Place, RodElement, Structure};
use crate::equations::force::Element;
use crate::equations::shape::{self, Nodes, Vector14};
use crate::equations::{inertia, material};
use crate::error::{Error, Result};
use crate::kernel::{Kernel, ThermalStrain};
use crate::linear::BandMatrix;
use crate::scene::{Direction, Scene, Start};

/// More memory than this for one matrix, in bytes, is refused: a structure that needs it is not a few rods.
const MOST_BYTES: usize = 2 << 30;

impl Structure {
    /// Builds the structure of a (validated) scene.
    ///
    /// # Errors
    /// [`Error::TooLarge`] where the matrices would not fit into memory.
    pub fn new(scene: &Scene) -> Result<Structure> {
        let (youngs_modulus, nu) = (scene.material.youngs_modulus, scene.material.nu);
        let (lambda, mu) = (material::lambda(youngs_modulus, nu), material::mu(youngs_modulus, nu));
        let (h, w) = (scene.section.height, scene.section.width);
        let gravity = Vector2::from(scene.gravity);

        let (mut vectors, mut elements, mut at_point) = (Vec::new(), Vec::new(), BTreeMap::new());
        let (mut rods, mut rod_of) = (Vec::new(), Vec::new());
        for (number, rod) in scene.rods.iter().enumerate() {
            let from = Vector2::from(scene.points[&rod.from]);
            let along = Vector2::from(scene.points[&rod.to]) - from;
            let element = straight_element(from, along / rod.elements as f64, h, w);
            let l = element.l;
            let mut new = |kind, held| {
                vectors.push(NodalVector { kind, held });
                vectors.len() - 1
            };
            let mut point = |name: &str, new: &mut dyn FnMut(Kind, [bool; 2]) -> usize| {
                *at_point.entry(name.to_string()).or_insert_with(|| new(Kind::Position, held(scene, name)))
            };
            let free = [false; 2];
            let mut r = point(&rod.from, &mut new);
            let mut r_y = new(Kind::Slope(h), free);
            for n in 1..=rod.elements {
                let (r_i, r_y_i) = (r, r_y);
                let middle = [Kind::Position, Kind::Slope(l), Kind::Slope(h)];
                let [r_j, r_x_j, r_y_j] = middle.map(|kind| new(kind, free));
                r = if n == rod.elements { point(&rod.to, &mut new) } else { new(Kind::Position, free) };
                r_y = new(Kind::Slope(h), free);
                elements.push([r_i, r_y_i, r_j, r_x_j, r_y_j, r, r_y]);
                rod_of.push(number);
            }
            rods.push(RodElement {
                element,
                kernel: Kernel::new(l, h, w, along.y.atan2(along.x), lambda, mu),
                mass: inertia::M(scene.material.rho, &element),
                gravity: inertia::Q_w_gravity(&gravity, scene.material.rho, &element),
            });
        }

        let (unknowns, kinds) = number(&vectors, &elements);
        let place = |(vectors, rod): (&Vectors, usize)| Place {
            rod,
            unknowns: std::array::from_fn(|i| unknowns[vectors[i / 2]][i % 2]),
        };
        let places: Vec<Place> = elements.iter().zip(rod_of).map(place).collect();
        let size = kinds.len();
        let band = places.iter().map(|place| spread(&place.unknowns)).max().unwrap_or(0);
        let bytes = BandMatrix::bytes(size, band);
        if bytes > MOST_BYTES {
            return Err(Error::TooLarge { unknowns: size, band, gigabytes: bytes as f64 / 1e9 });
        }
        let lengths = || rods.iter().map(|rod: &RodElement| rod.element.l);
        let mut structure = Structure {
            points: at_point
                .into_iter()
                .map(|(name, vector)| {
                    let start = scene.points[&name];
                    (name, (start, unknowns[vector]))
                })
                .collect(),
            kinds,
            band,
            mass: BandMatrix::zeros(size, band),
            gravity: DVector::zeros(size),
            start: DVector::zeros(size),
            heat: scene
                .heat()
                .map(|temperature| Heat { temperature: temperature.clone(), alpha: scene.material.alpha }),
            unit_force: (lambda + 2.0 * mu) * h * w * (lengths().fold(0.0, f64::max) / h).max(1.0),
            shortest: lengths().fold(f64::INFINITY, f64::min),
            rods,
            places,
        };
        structure.mass = structure.assemble_matrix(|_, rod| rod.mass);
        structure.gravity = structure.assemble_vector(|_, rod| rod.gravity);
        if structure.heat.as_ref().is_some_and(|heat| heat.temperature.start == Start::Relaxed) {
            structure.start = structure.relaxed(scene);
        }
        Ok(structure)
    }

    /// Displacement from the initial to the stress-free configuration at ΔT(0): a stretch √(1 + 2ε) in each heated
    /// direction, about the supported point (or the beginning of the rod).
    fn relaxed(&self, scene: &Scene) -> DVector<f64> {
        let stretch = stress_free(self.thermal_strain(0.0));
        let mut u = DVector::zeros(self.size());
        let mut first = 0;
        for (rod, data) in scene.rods.iter().zip(&self.rods) {
            let about = scene.supports.first().map_or(&rod.from, |support| &support.point);
            let (from, about) = (Vector2::from(scene.points[&rod.from]), Vector2::from(scene.points[about]));
            let direction = Vector2::from(scene.points[&rod.to]) - from;
            for n in 0..rod.elements {
                let origin = from - about + direction * (n as f64 / rod.elements as f64);
                let u_e = stretched(&data.element, stretch, origin);
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
