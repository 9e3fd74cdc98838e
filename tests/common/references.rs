//! `fixtures/references.json`: reference solutions of statics and vibration, and the rods that are held against them.

use ancf::integrators::Counts;
use ancf::integrators::State;
use ancf::internals::elements::{Ancf, Beam, Cable, Meaning, NodalVector};
use ancf::internals::structure::Structure;
use ancf::model::{Element, Law, Poisson, Scene};
use nalgebra::{DVector, Vector2};
use serde_json::Value;

/// The fixture.
pub struct References(Value);

/// One entry of it.
#[derive(Clone, Copy)]
pub struct Reference<'a>(&'a Value);

impl References {
    pub fn load() -> References {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/references.json");
        References(serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap())
    }

    pub fn entries(&self) -> impl Iterator<Item = Reference<'_>> {
        self.0["entries"].as_array().unwrap().iter().map(Reference)
    }

    pub fn entry(&self, id: &str) -> Reference<'_> {
        self.entries().find(|entry| entry.id() == id).unwrap_or_else(|| panic!("no entry {id}"))
    }

    /// All with these tags; there are `number` of them, so that none goes missing unseen.
    pub fn tagged(&self, tags: &[&str], number: usize) -> Vec<Reference<'_>> {
        let has = |entry: &Reference, tag: &str| entry.0["tags"].as_array().unwrap().iter().any(|own| own == tag);
        let found: Vec<_> = self.entries().filter(|entry| tags.iter().all(|tag| has(entry, tag))).collect();
        assert_eq!(found.len(), number, "entries tagged {tags:?}");
        found
    }
}

impl<'a> Reference<'a> {
    pub fn id(&self) -> &'a str {
        self.0["id"].as_str().unwrap()
    }

    pub fn parameter(&self, name: &str) -> f64 {
        let value = &self.0["parameters"][name];
        value.as_f64().unwrap_or_else(|| panic!("{}: parameter {name} is {value}", self.id()))
    }

    pub fn has_parameter(&self, name: &str) -> bool {
        self.0["parameters"][name].is_number()
    }

    pub fn text(&self, name: &str) -> &'a str {
        self.0["parameters"][name].as_str().unwrap()
    }

    /// The double nearest to a value.
    pub fn value(&self, name: &str) -> f64 {
        self.0["values"][name]["f64"].as_f64().unwrap_or_else(|| panic!("{}: no value {name}", self.id()))
    }

    pub fn tip(&self) -> [f64; 2] {
        [self.value("tip.x"), self.value("tip.y")]
    }
}

/// The rods that a reference is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Equations (1)–(22), consistent form.
    Paper,
    /// The same with Poisson's terms on the axis.
    Axis,
    /// The same with the uniaxial law.
    Uniaxial,
    /// The paper's competitor.
    EulerBernoulli,
}

impl Kind {
    pub const ALL: [Kind; 4] = [Kind::Paper, Kind::Axis, Kind::Uniaxial, Kind::EulerBernoulli];

    fn apply(self, scene: &mut Scene) {
        let rod = &mut scene.rods[0];
        match self {
            Kind::Paper => {}
            Kind::Axis => rod.poisson = Poisson::Axis,
            Kind::Uniaxial => rod.law = Law::Uniaxial,
            Kind::EulerBernoulli => rod.element = Element::EulerBernoulli,
        }
    }
}

/// A rod from o = (0, 0) to a = (L, 0), clamped at o unless a test says otherwise, in one load step, without its load.
///
/// ```text
///   y                                │ F
/// ▒▒│                                ↓
/// ▒▒o ══════════════════════════════ a ── x
/// ▒▒            L, h × w
/// ```
pub fn rod(kind: Kind, reference: &Reference, elements: usize) -> Scene {
    let mut scene = slender(kind, reference.parameter("h"), elements);
    scene.section.width = reference.parameter("w");
    (scene.material.youngs_modulus, scene.material.nu) = (reference.parameter("E"), reference.parameter("nu"));
    scene.points.insert("a".into(), [length(reference), 0.0]);
    scene
}

/// Entries on heat have none: their results do not depend on it.
pub fn length(reference: &Reference) -> f64 {
    if reference.has_parameter("L") { reference.parameter("L") } else { 1.0 }
}

/// The same with the built-in cantilever's modulus, 1 m long, of a square section.
pub fn slender(kind: Kind, h: f64, elements: usize) -> Scene {
    let mut scene = Scene::builtin("cantilever").unwrap();
    kind.apply(&mut scene);
    (scene.section.height, scene.section.width, scene.rods[0].elements) = (h, h, elements);
    scene.forces.clear();
    // As far as rounding allows.
    scene.time.newton_tolerance = 1e-15;
    scene
}

pub fn push(mut scene: Scene, F: f64) -> Scene {
    scene.forces = Scene::builtin("cantilever").unwrap().forces;
    scene.forces[0].force = [0.0, -F];
    scene
}

/// Bending stiffness.
pub fn EI(scene: &Scene) -> f64 {
    let section = &scene.section;
    scene.material.youngs_modulus * section.width * section.height.powi(3) / 12.0
}

/// A rod's nodal vectors in its order: what each is, and where, in elements from o.
pub fn vectors(scene: &Scene) -> Vec<NodalVector> {
    let rod = &scene.rods[0];
    let own = match rod.element {
        Element::Ancf => Ancf::VECTORS,
        Element::EulerBernoulli => Cable::VECTORS,
    };
    let of_element = |n| own[2..].iter().map(move |&(meaning, at)| (meaning, n as f64 + at));
    own[..2].iter().copied().chain((0..rod.elements).flat_map(of_element)).collect()
}

/// What a nodal vector is at rest, of a rod along x: a slope's own; positions count from there.
pub fn at_rest(meaning: Meaning) -> Vector2<f64> {
    match meaning {
        Meaning::Position => Vector2::zeros(),
        Meaning::SlopeX => Vector2::x(),
        Meaning::SlopeY => Vector2::y(),
    }
}

/// A state of a rod.
pub struct Shape {
    pub structure: Structure,
    pub u: DVector<f64>,
    vectors: Vec<NodalVector>,
}

impl Shape {
    pub fn new(scene: &Scene, structure: Structure, u: DVector<f64>) -> Shape {
        Shape { structure, u, vectors: vectors(scene) }
    }

    /// Displacement of the tip.
    pub fn tip(&self) -> Vector2<f64> {
        self.structure.at_point(self.structure.point("a").unwrap(), &self.u).into()
    }

    /// The nodal vectors of a meaning, one after the other: displacements, or slopes.
    pub fn all(&self, meaning: Meaning) -> Vec<Vector2<f64>> {
        let component = |vector, c| self.structure.unknown("rod", vector, c).map_or(0.0, |unknown| self.u[unknown]);
        let own = self.vectors.iter().enumerate().filter(|(_, known)| known.0 == meaning);
        own.map(|(vector, _)| at_rest(meaning) + Vector2::new(component(vector, 0), component(vector, 1))).collect()
    }

    /// The slope at the tip.
    pub fn last_slope(&self) -> Vector2<f64> {
        let (meaning, _) = self.vectors[self.vectors.len() - 1];
        self.all(meaning)[self.all(meaning).len() - 1]
    }

    /// Angle of the section at the tip; between −π and π.
    pub fn angle(&self) -> f64 {
        let (rest, slope) = (at_rest(self.vectors[self.vectors.len() - 1].0), self.last_slope());
        rest.perp(&slope).atan2(rest.dot(&slope))
    }
}

/// The rod after the last load step.
pub fn solve(scene: &Scene) -> Shape {
    scene.clone().build().unwrap();
    let structure = Structure::new(scene).unwrap();
    let mut counts = Counts::default();
    let mut state =
        State { step: 0, t: 0.0, load: 0.0, u: structure.start().clone(), v: DVector::zeros(structure.size()) };
    let mut method = ancf::internals::integrators::integrator(
        scene,
        &ancf::internals::model::Plan::of(scene),
        &structure,
        &state,
        &mut counts,
    )
    .unwrap();
    for step in 1..=scene.steps() {
        method.step(&structure, &mut state, scene.time_after(step), &mut counts).unwrap();
    }
    Shape::new(scene, structure, state.u)
}

/// Distance of two points; never a signed difference.
pub fn off(a: Vector2<f64>, [x, y]: [f64; 2]) -> f64 {
    (a - Vector2::new(x, y)).norm()
}

/// What was measured once holds within a twentieth, from above and below: what grows better is news as well.
#[track_caller]
pub fn assert_stored(what: &str, measured: f64, stored: f64) {
    assert!((measured / stored - 1.0).abs() <= 0.05, "{what}: {measured:.3e}, stored {stored:.3e}");
}
