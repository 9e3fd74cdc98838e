//! The scenes of the study.

use super::benchmark::{Benchmark, ContinuumSolution};
use super::reference::Reference;
use crate::error::{Error, Result};
use crate::scene::ELEMENTS;
use ancf::model::Method;

/// Its motion is smooth unless it is heated suddenly.
const PENDULUM: Benchmark = Benchmark {
    scene: "pendulum-flexible",
    probe: "tip",
    own: None,
    unit: 1.0,
    interval: 0.25,
    rows: 8,
    instants: 50,
    meshes: &[1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64],
    smooth: true,
    coarsest: 8,
    witnesses: [(Method::Explicit, 1), (Method::Gauss, 100)],
    continuum: Some(ContinuumSolution::Solid("flexible")),
};

/// The waves of the sudden force are undamped; an explicit run of millions of steps resolves them.
const SCISSORS: Benchmark = Benchmark {
    scene: "scissors-3",
    probe: "a4",
    own: None,
    unit: 1.0,
    interval: 0.5,
    rows: 6,
    instants: 50,
    meshes: &[2, 4, 8, 16],
    smooth: false,
    coarsest: 16,
    witnesses: [(Method::Explicit, 1), (Method::Gauss, 250)],
    continuum: None,
};

/// All scenes of the study.
pub const BENCHMARKS: [Benchmark; 6] = [
    PENDULUM,
    Benchmark {
        scene: "pendulum-2d",
        meshes: &[1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128],
        smooth: false,
        coarsest: 64,
        // On some meshes undamped waves of the shock stop Newton's iteration: the witnesses are explicit, of different order.
        witnesses: [(Method::Explicit, 1), (Method::Nystrom, 1)],
        continuum: Some(ContinuumSolution::Solid("2d-sudden")),
        ..PENDULUM
    },
    Benchmark { scene: "pendulum-2d-relaxed", continuum: Some(ContinuumSolution::Solid("2d-relaxed")), ..PENDULUM },
    SCISSORS,
    Benchmark { scene: "scissors-3-thermal", ..SCISSORS },
    Benchmark {
        scene: "cantilever",
        probe: "tip",
        own: None,
        unit: 1.0,
        interval: 1.0,
        rows: 1,
        instants: 1,
        meshes: &[1, 2, 4, 8, 16, 32, 64, 128, 256],
        smooth: false,
        coarsest: 1,
        // The loads keep their direction: the equilibrium does not depend on the path, and two paths are two witnesses.
        witnesses: [(Method::Static, 50), (Method::Static, 75)],
        continuum: Some(ContinuumSolution::Elastica("elastica-10")),
    },
];

/// The benchmarks that have references for both elements.
pub fn complete() -> impl Iterator<Item = &'static Benchmark> {
    BENCHMARKS.iter().filter(|benchmark| ELEMENTS.iter().all(|e| Reference::is_embedded(benchmark, *e)))
}

/// The benchmarks of these scenes; all that have references for both elements if none is named.
///
/// # Errors
/// [`Error::Name`] for a scene that is not in the study.
pub fn named(scenes: &[String]) -> Result<Vec<&'static Benchmark>> {
    if scenes.is_empty() {
        return Ok(complete().collect());
    }
    scenes.iter().map(|name| of(name)).collect()
}

/// The benchmark of a scene.
///
/// # Errors
/// [`Error::Name`] for a scene that is not in the study.
pub fn of(name: &str) -> Result<&'static Benchmark> {
    BENCHMARKS.iter().find(|benchmark| benchmark.scene == name).ok_or_else(|| Error::Name {
        file: "ancf error-time".into(),
        key: "SCENE".into(),
        value: format!("`{name}`"),
        allowed: format!("{}, or the file of a scene", scene_names()),
    })
}

/// Names of all scenes, in a list.
fn scene_names() -> String {
    BENCHMARKS.map(|benchmark| benchmark.scene).join(", ")
}
