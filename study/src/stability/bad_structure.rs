//! Structures that cannot be computed: refused before the first step, with what is wrong by name.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::builtin;
use crate::error::Result;
use ancf::model::{Direction, Method, Scene, Start, Support};
use ancf::run::run_with_progress;

pub const CASE: Case = Case {
    name: "bad-structure",
    parameter: "number of the structure",
    unit: "–",
    reference: "none: there is no answer",
    right: "refused before the first step, with the names of what is wrong in the message.",
    trials,
};

type Made = fn() -> Result<Scene>;

fn support(point: &str) -> Support {
    Support { point: point.into(), fix: Vec::new(), slide: None, clamp: None }
}

const BAD: [(&str, Made, &[&str]); 9] = [
    (
        "a direction held twice",
        || with_support(Support { fix: vec![Direction::X], ..support("o") }),
        &["supports[1].fix", "redundant", "`o`"],
    ),
    (
        "a slide along what is fixed",
        || with_support(Support { slide: Some([1.0, 1.0]), ..support("o") }),
        &["supports[1].slide", "contradicts", "`o`"],
    ),
    (
        "a rod clamped twice",
        || {
            let mut scene = builtin("cantilever")?;
            scene.supports.push(Support { clamp: Some("rod".into()), ..support("o") });
            Ok(scene)
        },
        &["supports[1].clamp", "redundant", "\"rod\""],
    ),
    (
        "statics without supports",
        || {
            let mut scene = builtin("cantilever")?;
            (scene.supports, scene.probes) = (Vec::new(), Vec::new());
            Ok(scene)
        },
        &["can move without a strain", "`rod`"],
    ),
    (
        "statics on a hinge",
        || {
            let mut scene = builtin("cantilever")?;
            scene.supports[0].clamp = None;
            Ok(scene)
        },
        &["can move without a strain", "`rod`"],
    ),
    (
        "statics of scissors that can fold",
        || {
            let mut scene = builtin("scissors-3")?;
            scene.time.method = Method::Static;
            scene.time.end = 1.0;
            (scene.output.interval, scene.probes) = (None, Vec::new());
            Ok(scene)
        },
        &["can move without a strain", "`a1b2`", "`b1a2`", "`a2b3`", "`b2a3`"],
    ),
    (
        "pivots apart",
        || {
            let mut scene = builtin("scissors-3")?;
            scene.points.entry("b2".into()).and_modify(|point| point[0] += 1e-6);
            Ok(scene)
        },
        &["rods[1].pivot", "\"m1\"", "rods whose middles are at one place", "`a1b2`", "`b1a2`"],
    ),
    (
        "a relaxed start between two points",
        || {
            let mut scene = builtin("pendulum-2d-relaxed")?;
            scene.supports.push(Support { fix: vec![Direction::Y], ..support("a") });
            Ok(scene)
        },
        &["temperature.start", "\"relaxed\"", "rods 1, points held 2"],
    ),
    (
        "a relaxed start of pinned rods",
        || {
            let mut scene = builtin("scissors-3-thermal")?;
            scene.temperature.iter_mut().for_each(|heat| heat.start = Start::Relaxed);
            Ok(scene)
        },
        &["temperature.start", "\"relaxed\"", "rods 6"],
    ),
];

fn with_support(new: Support) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    scene.supports.push(new);
    Ok(scene)
}

fn trials() -> Result<Vec<Trial>> {
    let trials = BAD.iter().enumerate().map(|(number, (name, made, words))| {
        let result = move || {
            let mut steps = 0;
            let mut scene = made()?;
            // So that each step is told of.
            scene.output.interval = None;
            let outcome = run_with_progress(&scene, |done| steps = done);
            // A refusal after a step is too late, and counts as none.
            if steps > 0 { Ok(Finding::default()) } else { Ok(outcome.map(|_| Finding::default())?) }
        };
        Trial::new(*name, (number + 1) as f64, result).fast(true).expect(Expected::Refusal(words))
    });
    Ok(trials.collect())
}
