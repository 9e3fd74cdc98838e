//! Rod of equal elements: its nodal vectors among the unknowns, its elements, its heat.

use std::fmt::Debug;

use nalgebra::Vector2;

use super::node_dofs::NodeDofs;
use super::rod_elements::RodElements;
use super::uniform_elements::UniformElements;
use super::unknown_kind::UnknownKind;
use crate::elements::{Ancf, Beam, Cable, Law, Meaning, NodalVector, PrintedShear, ThermalStrain};
use crate::equations::element::Element;
use crate::equations::material::YoungPoisson;
use crate::equations::shape::Vector14;
use crate::equations::{cable, inertia};
use crate::lanes::Path;
use crate::model::plan::Plan;
use crate::model::{self, Form, Scene, Temperature};

/// Rod, with what all of its elements share.
#[derive(Debug)]
pub(super) struct Rod {
    pub name: String,
    pub elements: usize,
    /// Initial position of its first point, m.
    pub from: Vector2<f64>,
    /// Vector from node i to node k of an element, m.
    pub along: Vector2<f64>,
    /// Height of the section, m.
    pub height: f64,
    pub mesh: Box<dyn RodElements>,
    pub heat: Option<Heat>,
    /// Nodal vectors: those of node i of the first element, then the further ones of each element.
    pub chain: Vec<NodeDofs>,
}

#[derive(Clone, Debug)]
pub(super) struct Heat {
    pub temperature: Temperature,
    pub alpha: f64,
}

impl Rod {
    /// Rod by itself; its unknowns are not numbered yet.
    pub fn new(scene: &Scene, rod: &model::Rod, plan: &Plan, path: Path) -> Rod {
        let from = Vector2::from(scene.points[&rod.from]);
        let along = (Vector2::from(scene.points[&rod.to]) - from) / rod.elements as f64;
        let mesh = match rod.element {
            model::Element::Ancf => ancf(scene, rod, along, plan, path),
            model::Element::EulerBernoulli => euler_bernoulli(scene, rod, along, path),
        };
        Rod {
            name: rod.name.clone(),
            elements: rod.elements,
            from,
            along,
            height: scene.section(rod).height,
            heat: scene.heat(rod).map(|heat| Heat { temperature: heat.clone(), alpha: scene.material(rod).alpha }),
            chain: vec![NodeDofs::default(); (mesh.vectors().len() - 2) * rod.elements + 2],
            mesh,
        }
    }

    /// Number of nodal vectors from an element to the next: they share the two of a node.
    pub fn stride(&self) -> usize {
        self.mesh.vectors().len() - 2
    }

    /// Thermal strain (along, across) at time `t`.
    pub fn thermal_strain(&self, t: f64) -> ThermalStrain {
        let Some(Heat { temperature, alpha }) = &self.heat else { return [0.0; 2] };
        temperature.model.strains(alpha * temperature.at(t))
    }

    /// Nodal vectors of an element.
    pub fn vectors(&self, element: usize) -> &[NodeDofs] {
        &self.chain[self.stride() * element..][..self.mesh.vectors().len()]
    }

    /// Meaning of a vector of the chain, and its distance from the rod's first point, in elements.
    pub fn nodal(&self, vector: usize) -> NodalVector {
        let element = (vector / self.stride()).min(self.elements - 1);
        let (meaning, at) = self.mesh.vectors()[vector - self.stride() * element];
        (meaning, element as f64 + at)
    }

    /// Positions of the rod's nodes.
    pub fn positions(&self) -> impl Iterator<Item = &NodeDofs> {
        let is_position = |vector: usize| self.nodal(vector).0 == Meaning::Position;
        self.chain.iter().enumerate().filter(move |(vector, _)| is_position(*vector)).map(|(_, dofs)| dofs)
    }

    /// Indices in the chain of a node's position and of the slope that turns with its section, r_y or else r_x; the
    /// node is `place` elements from the first point.
    pub fn node(&self, place: f64) -> Option<(usize, usize)> {
        let find = |wanted| (0..self.chain.len()).find(|&vector| self.nodal(vector) == (wanted, place));
        Some((find(Meaning::Position)?, find(Meaning::SlopeY).or_else(|| find(Meaning::SlopeX))?))
    }

    /// Kind of a chain vector's unknowns.
    pub fn kind(&self, vector: usize) -> UnknownKind {
        match self.nodal(vector).0 {
            Meaning::Position => UnknownKind::Position,
            Meaning::SlopeX => UnknownKind::Slope(self.along.norm()),
            Meaning::SlopeY => UnknownKind::Slope(self.height),
        }
    }
}

/// The paper's elements of a rod.
fn ancf(scene: &Scene, rod: &model::Rod, along: Vector2<f64>, plan: &Plan, path: Path) -> Box<dyn RodElements> {
    let (material, section) = (scene.material(rod), scene.section(rod));
    let (l, h, w, theta) = (along.norm(), section.height, section.width, along.y.atan2(along.x));
    match scene.form {
        Form::Consistent => {
            let law = law(rod, material);
            let beam = Ancf::new(l, h, w, theta, law);
            uniform(if plan.poisson { beam.with_poissons_terms(law, h, w) } else { beam }, scene, rod, along, path)
        }
        Form::PrintedShear => {
            uniform(PrintedShear::new(l, h, w, theta, moduli(material).into()), scene, rod, along, path)
        }
    }
}

/// Elements of the paper, all equal, in the consistent or the printed form.
fn uniform<B: Beam<14> + Debug + Send + Sync + 'static>(
    beam: B,
    scene: &Scene,
    rod: &model::Rod,
    along: Vector2<f64>,
    path: Path,
) -> Box<dyn RodElements> {
    let (material, section) = (scene.material(rod), scene.section(rod));
    // Mass and weight do not depend on e₀.
    let element = Element { l: along.norm(), h: section.height, w: section.width, e_0: Vector14::zeros() };
    Box::new(UniformElements {
        beam,
        along,
        mass: inertia::M(material.rho, &element),
        gravity: inertia::Q_w_gravity(&Vector2::from(scene.gravity), material.rho, &element),
        unit_force: law(rod, material).stiff() * section.height * section.width,
        places: Vec::new(),
        rows: Vec::new(),
        path,
        deviations: Vec::new(),
    })
}

/// Law of a rod of the paper's elements.
pub(super) fn law(rod: &model::Rod, material: &model::Material) -> Law {
    match rod.law {
        model::Law::PlaneStrain => Law::PlaneStrain { lame: moduli(material).into(), poisson: rod.poisson },
        model::Law::Uniaxial => Law::Uniaxial(moduli(material)),
    }
}

fn moduli(material: &model::Material) -> YoungPoisson {
    YoungPoisson { E: material.youngs_modulus, nu: material.nu }
}

/// Euler–Bernoulli elements of a rod.
fn euler_bernoulli(scene: &Scene, rod: &model::Rod, along: Vector2<f64>, path: Path) -> Box<dyn RodElements> {
    let (material, section) = (scene.material(rod), scene.section(rod));
    let area = section.height * section.width;
    let tension = material.youngs_modulus * area;
    let bending = material.youngs_modulus * section.width * section.height.powi(3) / 12.0;
    let l = along.norm();
    Box::new(UniformElements {
        beam: Cable::new(l, along.y.atan2(along.x), tension, bending),
        along,
        mass: cable::M(material.rho * area, l),
        gravity: cable::Q_w_gravity(&Vector2::from(scene.gravity), material.rho * area, l),
        // Moving an end across by l also bends an element, with more force than its tension if it is higher than long.
        unit_force: tension + 12.0 * bending / (l * l),
        places: Vec::new(),
        rows: Vec::new(),
        path,
        deviations: Vec::new(),
    })
}
