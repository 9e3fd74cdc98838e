//! Scenes of the studies: the built-in ones, and the changes that several studies make to them.

use ancf::model::{Element, Method, Probe, Quantity, Scene};

use crate::error::{Error, Result};

/// Both elements.
pub const ELEMENTS: [Element; 2] = [Element::Ancf, Element::EulerBernoulli];

/// A built-in scene.
pub fn builtin(name: &'static str) -> Result<Scene> {
    Scene::builtin(name).ok_or_else(|| Error::fixture(name, "there is no such scene"))
}

/// The pendulum without heat, one rod of 1 m from the hinge `o` to `a`, with its element and mesh.
pub fn pendulum(element: Element, elements: usize) -> Result<Scene> {
    Ok(builtin("pendulum-flexible")?.meshed(element, elements))
}

/// The cantilever of 1 m with its element, its mesh and a square section of this height.
pub fn cantilever(element: Element, elements: usize, height: f64) -> Result<Scene> {
    let mut scene = builtin("cantilever")?.meshed(element, elements);
    (scene.section.height, scene.section.width) = (height, height);
    Ok(scene)
}

/// A cantilever of 1 m and height 1/`slenderness` whose tip moves by `tip` (m) in the theory of its element: Timoshenko's PL³/3EI + PL/GA
/// in plane strain, or Euler's PL³/3EI.
pub fn light_cantilever(element: Element, elements: usize, slenderness: f64, nu: f64, tip: f64) -> Result<Scene> {
    let height = 1.0 / slenderness;
    let mut scene = cantilever(element, elements, height)?;
    scene.material.nu = nu;
    let modulus = scene.material.youngs_modulus;
    let bending = modulus / (1.0 - nu * nu) * height.powi(4) / 12.0;
    let shear = modulus / (2.0 * (1.0 + nu)) * height.powi(2);
    let shear = if element == Element::Ancf { 1.0 / shear } else { 0.0 };
    scene.forces[0].force = [0.0, -tip / (1.0 / (3.0 * bending) + shear)];
    Ok(scene)
}

/// A probe that has the name of its point.
pub fn point_probe(point: &str, of: &[Quantity]) -> Probe {
    Probe { name: point.into(), point: Some(point.into()), rod: None, at: None, of: of.to_vec(), mean: None }
}

/// Changes of a scene.
pub trait Change {
    /// All rods with this element and this many of them.
    fn meshed(self, element: Element, elements: usize) -> Self;

    /// Solved by this method with this step to this time, s.
    fn solved(self, method: Method, step: f64, end: f64) -> Self;

    /// Newton's iteration, where the method has one, to this tolerance relative to the largest force.
    fn newton(self, tolerance: f64) -> Self;

    /// A row every so many seconds.
    fn rows_every(self, interval: f64) -> Self;
}

impl Change for Scene {
    fn meshed(mut self, element: Element, elements: usize) -> Scene {
        self.rods.iter_mut().for_each(|rod| (rod.element, rod.elements) = (element, elements));
        self
    }

    fn solved(self, method: Method, step: f64, end: f64) -> Scene {
        self.method(method, step).until(end)
    }

    fn newton(mut self, tolerance: f64) -> Scene {
        if !self.time.method.is_explicit() {
            self.time.newton_tolerance = tolerance;
        }
        self
    }

    fn rows_every(mut self, interval: f64) -> Scene {
        self.output.interval = Some(interval);
        self
    }
}
