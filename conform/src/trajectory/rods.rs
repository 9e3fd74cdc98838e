//! Pinned rods as equations of motion, q̈ = A (f − Q_e), with room for mistakes.
//!
//! The library's own structures have none, so that this is a second program: Gauss sums of the energy's derivative over shape
//! functions, dense matrices, and constraints Φ = Φ_q (q − q_0) eliminated by A = M⁻¹ − M⁻¹Φ_qᵀ(Φ_q M⁻¹Φ_qᵀ)⁻¹Φ_q M⁻¹.
//! Coordinates are those of `structure.json`: rod by rod, vector by vector, x before y.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeMap;

use ancf::equations::{cable, shape};
use ancf::model::{Direction, Element, Law as RodLaw, Start, Temperature, ThermalModel};
use nalgebra::{DMatrix, DVector, SymmetricEigen, Vector2};

use super::setup::{Blocks, Joint, Law, Mass, Setup, StartStretch, Weight};

/// Nodes and weights of Gauss rules on [−1, 1], by the number of points.
const GAUSS: [&[(f64, f64)]; 5] = [
    &[(0.0, 2.0)],
    &[(-0.577_350_269_189_625_8, 1.0), (0.577_350_269_189_625_8, 1.0)],
    &[
        (-0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
        (0.0, 0.888_888_888_888_888_8),
        (0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
    ],
    &[
        (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
        (-0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
        (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
        (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    ],
    &[
        (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ],
];

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
}

#[derive(Debug)]
struct PointForce {
    at: usize,
    force: [f64; 2],
    history: Option<Vec<[f64; 2]>>,
}

/// A rod: its elements' Gauss points, law and heat.
#[derive(Debug)]
struct Rod {
    /// Its first coordinate.
    first: usize,
    elements: usize,
    element: ElementData,
    /// Direction at first.
    t: [f64; 2],
    alpha: f64,
    heat: Option<Temperature>,
    heat_factors: [f64; 2],
    ramp: f64,
    blocks: Blocks,
}

#[derive(Debug)]
enum ElementData {
    Ancf { points: Vec<Point<7>>, law: Stiffness },
    Cable { axial: Vec<Point<4>>, bending: Vec<Point<4>>, EA: f64, EI: f64 },
}

/// A Gauss point: derivatives of the shape functions by x and by y (of a cable r_x and r_xx), and its share of the volume (length).
#[derive(Clone, Debug)]
struct Point<const N: usize> {
    a: [f64; N],
    b: [f64; N],
    weight: f64,
}

/// Stresses per strain in the rod's own axes.
#[derive(Clone, Copy, Debug)]
struct Stiffness {
    along: f64,
    across: f64,
    coupling: f64,
    /// Stress S_12 per strain ε_12.
    shear: f64,
    /// Of E3: taken from the shear of the global axes.
    printed: f64,
    linear: bool,
    retardation: f64,
}

/// Vectors of an element, and those by which neighbours are apart.
const fn vectors(element: Element) -> (usize, usize) {
    match element {
        Element::Ancf => (7, 5),
        Element::EulerBernoulli => (4, 2),
    }
}

impl Rods {
    /// Rods of a setup; `None` if the masses do not determine the accelerations.
    pub fn new(setup: &Setup) -> Option<Rods> {
        let scene = &setup.scene;
        let (mut rods, mut size) = (Vec::new(), 0);
        let mut points: BTreeMap<String, usize> = BTreeMap::new();
        // Position of each rod at each of its points, and its section's vector there.
        let mut places: BTreeMap<&str, Vec<(usize, usize, usize)>> = BTreeMap::new();
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
        let mut rows = Vec::new();
        for (name, meeting) in &places {
            let joint = setup.joint.as_ref().filter(|(point, _)| point == name).map(|(_, joint)| *joint);
            for pair in meeting.windows(2) {
                let [(one, at, section), (two, at_2, section_2)] = *pair else { continue };
                for component in 0..2 {
                    if matches!(
                        (joint, component),
                        (Some(Joint::Open), _) | (Some(Joint::OnlyX), 1) | (Some(Joint::OnlyY), 0)
                    ) {
                        continue;
                    }
                    rows.push(vec![(at_2 + component, 1.0), (at + component, -1.0)]);
                }
                if joint == Some(Joint::Welded) {
                    let (Some(a), Some(b)) = (all.rods.get(one), all.rods.get(two)) else { continue };
                    // r_y of the second rod is that of the first, turned by the initial angle between them.
                    let (c, s) = (a.t[0] * b.t[0] + a.t[1] * b.t[1], a.t[0] * b.t[1] - a.t[1] * b.t[0]);
                    rows.push(vec![(section_2, 1.0), (section, -c), (section + 1, s)]);
                    rows.push(vec![(section_2 + 1, 1.0), (section, -s), (section + 1, -c)]);
                }
            }
        }
        for support in &scene.supports {
            let at = *all.points.get(&support.point)?;
            for direction in &support.fix {
                rows.push(vec![(at + usize::from(*direction == Direction::Y), 1.0)]);
            }
            if let Some([x, y]) = support.slide {
                rows.push(vec![(at, -y / x.hypot(y)), (at + 1, x / x.hypot(y))]);
            }
            if let Some(name) = &support.clamp {
                let number = scene.rods.iter().position(|rod| rod.name == *name)?;
                let (_, _, section) = places.get(support.point.as_str())?.iter().find(|(n, ..)| *n == number)?;
                let rod = all.rods.get(number)?;
                // The section's direction: r_y stays across t, a cable's r_x along it.
                let [t_x, t_y] = rod.t;
                let [x, y] = if rod.is_cable() { [-t_y, t_x] } else { [t_x, t_y] };
                rows.push(vec![(*section, x), (section + 1, y)]);
            }
        }
        if let Some(point) = &setup.held_section {
            let (_, _, section) = places.get(point.as_str())?.first()?;
            rows.extend([vec![(*section, 1.0)], vec![(section + 1, 1.0)]]);
        }
        all.to_acceleration = constrained(&all.mass, &rows)?;
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
        force.copy_from(&self.weight);
        for PointForce { at, force: [x, y], history } in &self.forces {
            let factor = history.as_ref().map_or(1.0, |history| interpolate(history, t));
            force[*at] += factor * x;
            force[at + 1] += factor * y;
        }
        for rod in &self.rods {
            rod.subtract_force(t, q.as_slice(), v.as_slice(), force.as_mut_slice());
        }
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

/// A of masses and constraint rows, each a list of coordinates with factors. Rows that follow from others are passed over.
fn constrained(mass: &DMatrix<f64>, rows: &[Vec<(usize, f64)>]) -> Option<DMatrix<f64>> {
    let inverse = mass.clone().try_inverse()?;
    if SymmetricEigen::new(mass.clone()).eigenvalues.min() <= 0.0 {
        return None;
    }
    if rows.is_empty() {
        return Some(inverse);
    }
    let mut Phi_q = DMatrix::zeros(rows.len(), mass.nrows());
    for (n, row) in rows.iter().enumerate() {
        row.iter().for_each(|(at, factor)| Phi_q[(n, *at)] = *factor);
    }
    let by_mass = &inverse * Phi_q.transpose();
    let within = (&Phi_q * &by_mass).pseudo_inverse(1e-9).ok()?;
    Some(inverse - &by_mass * within * by_mass.transpose())
}

impl Rod {
    fn new(setup: &Setup, rod: &ancf::model::Rod, first: usize) -> Rod {
        let scene = &setup.scene;
        let (material, section) = (scene.material(rod), scene.section(rod));
        let ends = [&rod.from, &rod.to].map(|name| Vector2::from(scene.points.get(name).copied().unwrap_or_default()));
        let along = ends[1] - ends[0];
        let length = along.norm() / rod.elements as f64;
        let element = match rod.element {
            Element::Ancf => ElementData::ancf(&setup.law, rod, material, section, length, setup.retardation),
            Element::EulerBernoulli => ElementData::cable(&setup.law, material, section, length),
        };
        Rod {
            first,
            elements: rod.elements,
            element,
            t: (along / along.norm()).into(),
            alpha: material.alpha,
            heat: scene.heat(rod).cloned(),
            heat_factors: setup.heat,
            ramp: setup.ramp,
            blocks: setup.force_blocks,
        }
    }

    fn is_cable(&self) -> bool {
        matches!(self.element, ElementData::Cable { .. })
    }

    /// Vectors of an element, and those by which neighbours are apart.
    fn vectors(&self) -> (usize, usize) {
        vectors(if self.is_cable() { Element::EulerBernoulli } else { Element::Ancf })
    }

    /// Thermal strain (along, across).
    fn thermal_strain(&self, t: f64) -> [f64; 2] {
        let Some(heat) = &self.heat else { return [0.0; 2] };
        let part = if t < self.ramp { t / self.ramp } else { 1.0 };
        let strain = self.alpha * heat.at(t) * part;
        match heat.model {
            ThermalModel::TwoD => self.heat_factors.map(|factor| factor * strain),
            ThermalModel::OneD => [self.heat_factors[0] * strain, 0.0],
            _ => [0.0; 2],
        }
    }

    /// Coordinates of the straight rod, unstretched.
    fn place(&self, element: Element, from: Vector2<f64>, to: Vector2<f64>, q: &mut DVector<f64>) {
        let t = Vector2::from(self.t);
        let n = Vector2::new(-t.y, t.x);
        let (of_element, stride) = vectors(element);
        for vector in 0..stride * self.elements + of_element - stride {
            let (at, within) = (vector / stride, vector % stride);
            let on_axis = |place: f64| from + (to - from) * (place / self.elements as f64);
            let value = match (element, within) {
                (_, 0) => on_axis(at as f64),
                (Element::EulerBernoulli, _) | (Element::Ancf, 3) => t,
                (Element::Ancf, 2) => on_axis(at as f64 + 0.5),
                (Element::Ancf, _) => n,
            };
            q[self.first + 2 * vector] = value.x;
            q[self.first + 2 * vector + 1] = value.y;
        }
    }

    /// Stretches a rod that starts free of stress, from its first point.
    fn stretch(&self, element: Element, start: StartStretch, q: &mut DVector<f64>) {
        if !self.heat.as_ref().is_some_and(|heat| heat.start == Start::Relaxed) {
            return;
        }
        let [along, across] = self.thermal_strain(self.ramp);
        let (of_element, stride) = vectors(element);
        let free = |strain: f64| if self.is_cable() { 1.0 + strain } else { (1.0 + 2.0 * strain).max(0.0).sqrt() };
        let across = if start == StartStretch::AlongOnly { 0.0 } else { across };
        let from = [q[self.first], q[self.first + 1]];
        for vector in 0..stride * self.elements + of_element - stride {
            let within = vector % stride;
            for (component, from) in from.into_iter().enumerate() {
                let value = &mut q[self.first + 2 * vector + component];
                *value = match (element, within) {
                    (_, 0) | (Element::Ancf, 2) => from + (*value - from) * free(along),
                    (Element::EulerBernoulli, _) | (Element::Ancf, 3) => *value * free(along),
                    (Element::Ancf, _) => *value * free(across),
                };
            }
        }
    }

    /// Subtracts Q_e from a force.
    fn subtract_force(&self, t: f64, q: &[f64], v: &[f64], force: &mut [f64]) {
        let heat = self.thermal_strain(t);
        let (of_element, stride) = self.vectors();
        for element in 0..self.elements {
            let first = self.first + 2 * stride * element;
            let own = first..first + 2 * of_element;
            let (Some(q), Some(v)) = (q.get(own.clone()), v.get(own.clone())) else { continue };
            let mut Q_e = [0.0; 14];
            self.element.force(q, v, heat, self.t, &mut Q_e);
            let Some(target) = force.get_mut(own) else { continue };
            for (n, (target, Q_e)) in target.iter_mut().zip(Q_e).enumerate() {
                *target -= self.blocks.share(element, self.elements, n, 2 * of_element) * Q_e;
            }
        }
    }

    fn energy(&self, t: f64, q: &[f64]) -> f64 {
        let heat = self.thermal_strain(t);
        let (of_element, stride) = self.vectors();
        let elements = (0..self.elements).filter_map(|element| {
            let first = self.first + 2 * stride * element;
            Some(self.element.energy(q.get(first..first + 2 * of_element)?, heat, self.t))
        });
        elements.sum()
    }
}

impl Blocks {
    /// Factor of an element's entry `n` of `size`. The first and the last four are shared with the neighbours.
    fn share(self, element: usize, elements: usize, n: usize, size: usize) -> f64 {
        let with_last = element > 0 && n < 4;
        let with_next = element + 1 < elements && n + 4 >= size;
        match self {
            Blocks::Last if with_next => 0.0,
            Blocks::First if with_last => 0.0,
            Blocks::Twice if with_last => 2.0,
            Blocks::Without(left_out) if left_out == element => 0.0,
            _ => 1.0,
        }
    }

    /// Factor of an entry of an element's matrix: blocks between different nodes are shared with nobody.
    fn share_of_matrix(self, element: usize, elements: usize, [i, j]: [usize; 2], size: usize) -> f64 {
        let same_node = i < 4 && j < 4 || i + 4 >= size && j + 4 >= size;
        let left_out = self == Blocks::Without(element);
        if same_node || left_out { self.share(element, elements, i, size) } else { 1.0 }
    }
}

/// Sizes of an element that its mass depends on.
struct Body {
    element: Element,
    length: f64,
    height: f64,
    area: f64,
    rho: f64,
}

impl Body {
    /// Adds the rod's mass matrix and weight.
    fn assemble(&self, setup: &Setup, rod: &Rod, mass: &mut DMatrix<f64>, weight: &mut DVector<f64>) {
        let (of_element, stride) = vectors(self.element);
        let (m, integral) = self.element(setup);
        let gravity = setup.scene.gravity;
        let (elements, size) = (rod.elements, 2 * of_element);
        for element in 0..elements {
            let first = rod.first + 2 * stride * element;
            for i in 0..size {
                for j in (i % 2..size).step_by(2) {
                    let share = setup.mass_blocks.share_of_matrix(element, elements, [i, j], size);
                    mass[(first + i, first + j)] += share * m[(i / 2, j / 2)];
                }
                let share = setup.weight_blocks.share(element, elements, i, size);
                weight[first + i] += share * integral[i / 2] * gravity[i % 2];
            }
        }
        if setup.weight == Weight::AtTheEnd {
            let end = rod.first + 2 * stride * elements;
            for component in 0..2 {
                weight[end + component] += self.rho * self.area * self.length * elements as f64 * gravity[component];
            }
        }
    }

    /// Mass matrix of an element for one component, and the integral of ρ S.
    fn element(&self, setup: &Setup) -> (DMatrix<f64>, Vec<f64>) {
        let (of_element, _) = vectors(self.element);
        let (mut m, mut integral) = (DMatrix::zeros(of_element, of_element), vec![0.0; of_element]);
        let [along, across] = match self.element {
            Element::Ancf => [GAUSS[4], GAUSS[2]],
            Element::EulerBernoulli => [GAUSS[4], GAUSS[0]],
        };
        for (xi, w_xi) in along {
            for (eta, w_eta) in across {
                let x = self.length / 2.0 * (1.0 + xi);
                let y = setup.law.depth_of_mass * self.height / 2.0 * eta;
                let share = self.rho * self.area * self.length * w_xi * w_eta / 4.0;
                let S: Vec<f64> = match self.element {
                    Element::Ancf => shape::S_i(x, y, self.length).into(),
                    Element::EulerBernoulli => cable::S_i(x, self.length).into(),
                };
                for i in 0..of_element {
                    integral[i] += share * S[i];
                    for j in 0..of_element {
                        m[(i, j)] += share * S[i] * S[j];
                    }
                }
            }
        }
        let of_positions: &[usize] = if self.element == Element::Ancf { &[0, 2, 5] } else { &[0, 2] };
        if setup.mass != Mass::Consistent {
            let whole = self.rho * self.area * self.length;
            let carried: f64 = of_positions.iter().map(|n| m[(*n, *n)]).sum();
            let factor = if setup.mass == Mass::ScaledDiagonal { whole / carried } else { 1.0 };
            m = DMatrix::from_diagonal(&m.diagonal()) * factor;
        }
        match setup.weight {
            Weight::Consistent => {}
            Weight::HalfOnEnds => {
                let ends = [0, of_positions.last().copied().unwrap_or_default()];
                let half = 0.5 * self.rho * self.area * self.length;
                integral
                    .iter_mut()
                    .enumerate()
                    .for_each(|(n, share)| *share = if ends.contains(&n) { half } else { 0.0 });
            }
            Weight::AtTheEnd => integral.fill(0.0),
        }
        (m, integral)
    }
}

impl ElementData {
    /// The paper's element.
    fn ancf(
        law: &Law,
        rod: &ancf::model::Rod,
        material: &ancf::model::Material,
        section: &ancf::model::Section,
        l: f64,
        retardation: f64,
    ) -> ElementData {
        let [along, across] = law.points.map(|count| GAUSS.get(count.saturating_sub(1)).copied().unwrap_or(GAUSS[4]));
        let mut points = Vec::new();
        for (xi, w_xi) in along {
            for (eta, w_eta) in across {
                let (x, y) = (l / 2.0 * (1.0 + xi), law.depth * section.height / 2.0 * eta);
                let weight = l * section.height * section.width * w_xi * w_eta / 4.0;
                points.push(Point { a: shape::S_i_x(x, y, l), b: shape::S_i_y(x, y, l), weight });
            }
        }
        let (E, nu) = (material.youngs_modulus, material.nu);
        let mu = E / (2.0 * (1.0 + nu));
        let (direct, lambda) = match rod.law {
            RodLaw::Uniaxial => (E, 0.0),
            _ => {
                let lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
                (lambda + 2.0 * mu, lambda)
            }
        };
        let law = Stiffness {
            along: law.along * direct,
            across: law.across * direct,
            coupling: law.coupling * lambda,
            shear: law.shear * 2.0 * mu,
            printed: if law.printed_shear { 2.0 * mu } else { 0.0 },
            linear: law.linear,
            retardation,
        };
        ElementData::Ancf { points, law }
    }

    /// The Euler–Bernoulli element.
    fn cable(law: &Law, material: &ancf::model::Material, section: &ancf::model::Section, l: f64) -> ElementData {
        let points = |rule: &[(f64, f64)]| {
            let place = |(xi, w_xi): &(f64, f64)| {
                let x = l / 2.0 * (1.0 + xi);
                Point { a: cable::S_i_x(x, l), b: cable::S_i_xx(x, l), weight: l / 2.0 * w_xi }
            };
            rule.iter().map(place).collect()
        };
        let EA = material.youngs_modulus * section.height * section.width;
        let EI = EA * (law.depth * section.height).powi(2) / 12.0;
        ElementData::Cable {
            axial: points(GAUSS[4]),
            bending: points(GAUSS[2]),
            EA: law.along * EA,
            EI: law.along * EI,
        }
    }

    /// Q_e of an element with coordinates `q` and rates `v`.
    fn force(&self, q: &[f64], v: &[f64], heat: [f64; 2], t: [f64; 2], Q_e: &mut [f64; 14]) {
        match self {
            ElementData::Ancf { points, law } => {
                for point in points {
                    let [r_x, r_y] = point.slopes(q);
                    let rates = (law.retardation != 0.0).then(|| point.slopes(v));
                    let [on_x, on_y] = law.forces(r_x, r_y, rates, heat, t);
                    point.add(on_x, on_y, Q_e);
                }
            }
            ElementData::Cable { axial, bending, EA, EI } => {
                for point in axial {
                    let [g, _] = point.slopes(q);
                    let norm = g[0].hypot(g[1]);
                    let factor = EA * (norm - 1.0 - heat[0]) / norm;
                    point.add(g.map(|g| factor * g), [0.0; 2], Q_e);
                }
                for point in bending {
                    let [g, c] = point.slopes(q);
                    let metric = g[0] * g[0] + g[1] * g[1];
                    let kappa = (g[0] * c[1] - g[1] * c[0]) / metric;
                    let factor = EI * kappa / metric;
                    let on_g = [factor * (c[1] - 2.0 * kappa * g[0]), factor * (-c[0] - 2.0 * kappa * g[1])];
                    point.add(on_g, [-factor * g[1], factor * g[0]], Q_e);
                }
            }
        }
    }

    /// Strain energy of an element.
    fn energy(&self, q: &[f64], heat: [f64; 2], t: [f64; 2]) -> f64 {
        match self {
            ElementData::Ancf { points, law } => {
                let of = |point: &Point<7>| {
                    let [r_x, r_y] = point.slopes(q);
                    let strains = law.strains(r_x, r_y, heat, t);
                    let stresses = law.stresses(strains, t);
                    0.5 * point.weight * (0..3).map(|n| strains[n] * stresses[n]).sum::<f64>()
                };
                points.iter().map(of).sum()
            }
            ElementData::Cable { axial, bending, EA, EI } => {
                let stretch = axial.iter().map(|point| {
                    let [g, _] = point.slopes(q);
                    0.5 * EA * point.weight * (g[0].hypot(g[1]) - 1.0 - heat[0]).powi(2)
                });
                let bend = bending.iter().map(|point| {
                    let [g, c] = point.slopes(q);
                    let kappa = (g[0] * c[1] - g[1] * c[0]) / (g[0] * g[0] + g[1] * g[1]);
                    0.5 * EI * point.weight * kappa * kappa
                });
                stretch.sum::<f64>() + bend.sum::<f64>()
            }
        }
    }
}

impl<const N: usize> Point<N> {
    /// Derivatives of the position at the point.
    #[inline]
    fn slopes(&self, q: &[f64]) -> [[f64; 2]; 2] {
        let mut slopes = [[0.0; 2]; 2];
        for ((a, b), r) in self.a.iter().zip(&self.b).zip(q.chunks_exact(2)) {
            slopes[0][0] += a * r[0];
            slopes[0][1] += a * r[1];
            slopes[1][0] += b * r[0];
            slopes[1][1] += b * r[1];
        }
        slopes
    }

    /// Adds the forces that do work in changes of the two derivatives.
    #[inline]
    fn add(&self, on_a: [f64; 2], on_b: [f64; 2], Q_e: &mut [f64; 14]) {
        for ((a, b), Q) in self.a.iter().zip(&self.b).zip(Q_e.chunks_exact_mut(2)) {
            let (a, b) = (self.weight * a, self.weight * b);
            Q[0] += a * on_a[0] + b * on_b[0];
            Q[1] += a * on_a[1] + b * on_b[1];
        }
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a x + b y.
fn sum(a: f64, x: [f64; 2], b: f64, y: [f64; 2]) -> [f64; 2] {
    [a * x[0] + b * y[0], a * x[1] + b * y[1]]
}

impl Stiffness {
    /// Strains (11, 22, 12) in the rod's own axes, less the thermal ones.
    #[inline]
    fn strains(&self, r_x: [f64; 2], r_y: [f64; 2], heat: [f64; 2], t: [f64; 2]) -> [f64; 3] {
        if self.linear {
            let n = [-t[1], t[0]];
            return [dot(t, r_x) - 1.0 - heat[0], dot(n, r_y) - 1.0 - heat[1], 0.5 * (dot(n, r_x) + dot(t, r_y))];
        }
        [0.5 * (dot(r_x, r_x) - 1.0) - heat[0], 0.5 * (dot(r_y, r_y) - 1.0) - heat[1], 0.5 * dot(r_x, r_y)]
    }

    /// Derivatives of the energy density by the strains (11, 22, 12).
    #[inline]
    fn stresses(&self, [e_1, e_2, e_12]: [f64; 3], t: [f64; 2]) -> [f64; 3] {
        let mut stresses =
            [self.along * e_1 + self.coupling * e_2, self.across * e_2 + self.coupling * e_1, 2.0 * self.shear * e_12];
        if self.printed != 0.0 {
            // Half of the shear ε_12 of the global axes is missing.
            let (product, difference) = (t[0] * t[1], t[0] * t[0] - t[1] * t[1]);
            let missing = self.printed * (product * (e_1 - e_2) + difference * e_12);
            stresses[0] -= missing * product;
            stresses[1] += missing * product;
            stresses[2] -= missing * difference;
        }
        stresses
    }

    /// Forces that do work in changes of r_x and of r_y.
    #[inline]
    fn forces(
        &self,
        r_x: [f64; 2],
        r_y: [f64; 2],
        rates: Option<[[f64; 2]; 2]>,
        heat: [f64; 2],
        t: [f64; 2],
    ) -> [[f64; 2]; 2] {
        let mut strains = self.strains(r_x, r_y, heat, t);
        if let Some([v_x, v_y]) = rates {
            let rates = [dot(r_x, v_x), dot(r_y, v_y), 0.5 * (dot(v_x, r_y) + dot(r_x, v_y))];
            strains.iter_mut().zip(rates).for_each(|(strain, rate)| *strain += self.retardation * rate);
        }
        let [s_1, s_2, s_12] = self.stresses(strains, t);
        let (x, y) = if self.linear { (t, [-t[1], t[0]]) } else { (r_x, r_y) };
        [sum(s_1, x, 0.5 * s_12, y), sum(s_2, y, 0.5 * s_12, x)]
    }
}
