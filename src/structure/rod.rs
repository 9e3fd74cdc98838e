//! A rod of equal elements: its nodal vectors among the unknowns, its elements, its heat.

use std::fmt::Debug;

use nalgebra::Vector2;

use super::node_dofs::NodeDofs;
use super::rod_elements::RodElements;
use super::uniform_elements::UniformElements;
use super::unknown_kind::UnknownKind;
use crate::elements::{Ancf, Beam, Cable, Law, Meaning, NodalVector, PrintedShear, ThermalStrain};
use crate::equations::element::Element;
use crate::equations::material::{LameConstants, YoungPoisson};
use crate::equations::shape::Vector14;
use crate::equations::{cable, inertia};
use crate::model::plan::Plan;
use crate::model::{self, Form, Scene, Temperature, ThermalModel};

/// A rod with what all of its elements share.
#[derive(Debug)]
pub(super) struct Rod {
    pub name: String,
    pub elements: usize,
    /// Initial position of its beginning, m.
    pub from: Vector2<f64>,
    /// From node i to node k of an element, m.
    pub along: Vector2<f64>,
    /// Height of the section, m.
    pub height: f64,
    pub mesh: Box<dyn RodElements>,
    pub heat: Option<Heat>,
    /// Its nodal vectors: node i's of the first element, then the others of each element.
    pub chain: Vec<NodeDofs>,
}

#[derive(Clone, Debug)]
pub(super) struct Heat {
    pub temperature: Temperature,
    pub alpha: f64,
}

impl Rod {
    /// A rod by itself; its unknowns are not numbered yet.
    pub fn new(scene: &Scene, rod: &model::Rod, plan: &Plan) -> Rod {
        let from = Vector2::from(scene.points[&rod.from]);
        let along = (Vector2::from(scene.points[&rod.to]) - from) / rod.elements as f64;
        let mesh = match rod.element {
            model::Element::Ancf => ancf(scene, rod, along, plan),
            model::Element::EulerBernoulli => euler_bernoulli(scene, rod, along),
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

    /// Nodal vectors from an element to the next: two are those of the node that they share.
    pub fn stride(&self) -> usize {
        self.mesh.vectors().len() - 2
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
    pub fn vectors(&self, element: usize) -> &[NodeDofs] {
        &self.chain[self.stride() * element..][..self.mesh.vectors().len()]
    }

    /// What a vector of the chain is, and how many elements from the rod's beginning.
    pub fn nodal(&self, vector: usize) -> NodalVector {
        let element = (vector / self.stride()).min(self.elements - 1);
        let (meaning, at) = self.mesh.vectors()[vector - self.stride() * element];
        (meaning, element as f64 + at)
    }

    /// Places in the chain of the position and of the slope that turns with the section, r_y or else r_x, of a node that
    /// is `place` elements from the beginning.
    pub fn node(&self, place: f64) -> Option<(usize, usize)> {
        let find = |wanted| (0..self.chain.len()).find(|&vector| self.nodal(vector) == (wanted, place));
        Some((find(Meaning::Position)?, find(Meaning::SlopeY).or_else(|| find(Meaning::SlopeX))?))
    }

    /// What the unknowns of a vector of the chain measure.
    pub fn kind(&self, vector: usize) -> UnknownKind {
        match self.nodal(vector).0 {
            Meaning::Position => UnknownKind::Position,
            Meaning::SlopeX => UnknownKind::Slope(self.along.norm()),
            Meaning::SlopeY => UnknownKind::Slope(self.height),
        }
    }
}

/// FrontalChain of the paper.
fn ancf(scene: &Scene, rod: &model::Rod, along: Vector2<f64>, plan: &Plan) -> Box<dyn RodElements> {
    let (material, section) = (scene.material(rod), scene.section(rod));
    let lame = lame(material);
    let (l, h, w, theta) = (along.norm(), section.height, section.width, along.y.atan2(along.x));
    match scene.form {
        Form::Consistent => {
            let law = Law { lame, poisson: rod.poisson };
            let beam = Ancf::new(l, h, w, theta, law);
            equal(if plan.poisson { beam.with_poissons_terms(law, h, w) } else { beam }, scene, rod, along)
        }
        Form::PrintedShear => equal(PrintedShear::new(l, h, w, theta, lame), scene, rod, along),
    }
}

/// UniformElements elements of the paper, in one form or the other.
fn equal<B: Beam<14> + Debug + Send + Sync + 'static>(
    beam: B,
    scene: &Scene,
    rod: &model::Rod,
    along: Vector2<f64>,
) -> Box<dyn RodElements> {
    let (material, section) = (scene.material(rod), scene.section(rod));
    // Mass and weight do not depend on e₀.
    let element = Element { l: along.norm(), h: section.height, w: section.width, e_0: Vector14::zeros() };
    let LameConstants { lambda, mu } = lame(material);
    Box::new(UniformElements {
        beam,
        along,
        mass: inertia::M(material.rho, &element),
        gravity: inertia::Q_w_gravity(&Vector2::from(scene.gravity), material.rho, &element),
        unit_force: (lambda + 2.0 * mu) * section.height * section.width,
        places: Vec::new(),
    })
}

/// Lamé's constants of a material.
fn lame(material: &model::Material) -> LameConstants {
    YoungPoisson { E: material.youngs_modulus, nu: material.nu }.into()
}

/// FrontalChain of the paper's competitor.
fn euler_bernoulli(scene: &Scene, rod: &model::Rod, along: Vector2<f64>) -> Box<dyn RodElements> {
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
        // An end moved across by l bends an element as well: more than its tension where it is higher than long.
        unit_force: tension + 12.0 * bending / (l * l),
        places: Vec::new(),
    })
}
