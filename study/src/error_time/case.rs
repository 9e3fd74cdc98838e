//! The scenes of the study: what is looked at, when, and on which meshes.

use super::reference::Reference;
use crate::error::{Error, Result};
use ancf::model::{Element, Method, Scene};

/// A scene with what is measured of it.
#[derive(Debug, PartialEq)]
pub struct Case {
    /// Name of the built-in scene.
    pub scene: &'static str,
    /// The probe whose position is compared.
    pub probe: &'static str,
    /// Time from one sample to the next, s; the load factor in statics.
    pub interval: f64,
    /// Number of samples; the start is none, as it is exact.
    pub samples: usize,
    /// Elements of each rod; the last and that with half its elements make the reference, and its uncertainty.
    pub meshes: &'static [usize],
    /// Whether velocities converge: not where a sudden load has started waves without damping.
    pub smooth: bool,
    /// Longest step, as a part of the interval, of methods that may choose it; number of load steps in statics.
    pub coarsest: usize,
    /// Two methods that have to agree on the references, and the parts of the interval they begin with. The first is the
    /// one that is kept. An explicit method begins at its limit.
    pub witnesses: [(Method, usize); 2],
    /// Where the continuum, of which the beam is a model, is known.
    pub continuum: Option<Continuum>,
}

/// A solution that is no beam of ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Continuum {
    /// A run of `fixtures/continuum.json`.
    Solid(&'static str),
    /// An entry of `fixtures/references.json`.
    Elastica(&'static str),
}

/// The pendulum's motion is smooth but for sudden heat.
const PENDULUM: Case = Case {
    scene: "pendulum-flexible",
    probe: "tip",
    interval: 0.25,
    samples: 8,
    meshes: &[1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64],
    smooth: true,
    coarsest: 8,
    witnesses: [(Method::Explicit, 1), (Method::Gauss, 64)],
    continuum: Some(Continuum::Solid("flexible")),
};

/// The waves of the sudden force are not damped; an explicit run of millions of steps resolves them.
const SCISSORS: Case = Case {
    scene: "scissors-3",
    probe: "a4",
    interval: 0.5,
    samples: 6,
    meshes: &[2, 4, 6, 8, 12, 24],
    smooth: false,
    coarsest: 16,
    witnesses: [(Method::Explicit, 1), (Method::Gauss, 250)],
    continuum: None,
};

/// All scenes of the study.
pub const CASES: [Case; 6] = [
    PENDULUM,
    Case {
        scene: "pendulum-2d",
        meshes: &[1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128],
        smooth: false,
        coarsest: 64,
        // Undamped waves of the shock stop Newton's iteration on some meshes: two explicit methods of different order.
        witnesses: [(Method::Explicit, 1), (Method::Nystrom, 1)],
        continuum: Some(Continuum::Solid("2d-sudden")),
        ..PENDULUM
    },
    Case { scene: "pendulum-2d-relaxed", continuum: Some(Continuum::Solid("2d-relaxed")), ..PENDULUM },
    SCISSORS,
    Case { scene: "scissors-3-thermal", meshes: &[2, 4, 8, 16], ..SCISSORS },
    Case {
        scene: "cantilever",
        probe: "tip",
        interval: 1.0,
        samples: 1,
        meshes: &[1, 2, 4, 8, 16, 32, 64, 128, 256],
        smooth: false,
        coarsest: 1,
        // Loads that keep their direction: the equilibrium does not depend on the path, and two paths are two witnesses.
        witnesses: [(Method::Static, 50), (Method::Static, 75)],
        continuum: Some(Continuum::Elastica("elastica-10")),
    },
];

/// Both elements, each of which converges to a limit of its own.
pub const ELEMENTS: [Element; 2] = [Element::Ancf, Element::EulerBernoulli];

impl Case {
    /// The cases of these names; without any, those whose references are there.
    ///
    /// # Errors
    /// [`Error::Scene`] for a scene that is not in the study.
    pub fn named(scenes: &[String]) -> Result<Vec<&'static Case>> {
        if scenes.is_empty() {
            return Ok(CASES.iter().filter(|case| case.has_references()).collect());
        }
        let find = |name: &String| {
            let unknown = || Error::Name {
                file: "ancf error-time".into(),
                key: "SCENE".into(),
                value: format!("`{name}`"),
                allowed: CASES.map(|case| case.scene).join(", "),
            };
            CASES.iter().find(|case| case.scene == name).ok_or_else(unknown)
        };
        scenes.iter().map(find).collect()
    }

    /// Whether there are converged references for both elements.
    pub fn has_references(&self) -> bool {
        ELEMENTS.iter().all(|&element| Reference::is_embedded(self, element))
    }

    /// The built-in scene.
    ///
    /// # Errors
    /// [`Error::Fixture`] if there is none.
    pub fn built_in(&self) -> Result<Scene> {
        match Scene::builtin(self.scene) {
            Some(scene) => Ok(scene),
            None => Err(Error::Fixture { name: self.scene, reason: "there is no such scene".into() }),
        }
    }

    /// Name of the point that the probe looks at.
    ///
    /// # Errors
    /// [`Error::Fixture`] if there is none.
    pub fn point(&self) -> Result<String> {
        let probes = self.built_in()?.probes;
        let point = probes.into_iter().find(|probe| probe.name == self.probe).and_then(|probe| probe.point);
        point.ok_or_else(|| Error::Fixture { name: self.scene, reason: format!("there is no probe {}", self.probe) })
    }

    /// Whether it is loaded slowly in place of moving.
    pub fn is_static(&self) -> bool {
        self.witnesses[0].0 == Method::Static
    }

    /// Times of the samples, s.
    pub fn times(&self) -> Vec<f64> {
        (1..=self.samples).map(|n| n as f64 * self.interval).collect()
    }
}
