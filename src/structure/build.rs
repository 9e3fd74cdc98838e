//! From a scene to a structure: numbering, loads, the relaxed start.

use std::collections::BTreeMap;

use nalgebra::{DVector, Vector2};

use super::{Heat, Kind, Place, RodElement, Structure};
use crate::equations::force::Element;
use crate::equations::shape::{self, Nodes};
use crate::equations::{inertia, material};
use crate::kernel::Kernel;
use crate::linear::BandMatrix;
use crate::scene::{Direction, Scene, Start};

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
