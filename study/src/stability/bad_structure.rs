//! Structures that cannot be computed: refused before the first step, with the names of the faulty parts.

use super::case::{Case, Expected, Finding, Trial};
use crate::scene::builtin;
use ancf::model::{Direction, Method, Scene, Start, Support};
use ancf::run::run_with_progress;

pub const CASE: Case = Case {
    name: "bad-structure",
    parameter: "number of the structure",
    unit: "–",
    reference: "none: there is no answer",
    right: "refused before the first step, with the names of the faulty parts in the message.",
    trials,
};

/// A built-in scene and the change that makes it bad, with the words that its refusal has to contain.
struct BadStructure {
    name: &'static str,
    scene: &'static str,
    spoil: fn(&mut Scene),
    refusal: &'static [&'static str],
}

const BAD: [BadStructure; 9] = [
    BadStructure {
        name: "a direction held twice",
        scene: "pendulum-flexible",
        spoil: |scene| scene.supports.push(Support { fix: vec![Direction::X], ..support("o") }),
        refusal: &["supports[1].fix", "redundant", "`o`"],
    },
    BadStructure {
        name: "a slide along what is fixed",
        scene: "pendulum-flexible",
        spoil: |scene| scene.supports.push(Support { slide: Some([1.0, 1.0]), ..support("o") }),
        refusal: &["supports[1].slide", "contradicts", "`o`"],
    },
    BadStructure {
        name: "a rod clamped twice",
        scene: "cantilever",
        spoil: |scene| scene.supports.push(Support { clamp: Some("rod".into()), ..support("o") }),
        refusal: &["supports[1].clamp", "redundant", "\"rod\""],
    },
    BadStructure {
        name: "statics without supports",
        scene: "cantilever",
        spoil: |scene| (scene.supports, scene.probes) = (Vec::new(), Vec::new()),
        refusal: &["can move without a strain", "`rod`"],
    },
    BadStructure {
        name: "statics on a hinge",
        scene: "cantilever",
        spoil: |scene| scene.supports[0].clamp = None,
        refusal: &["can move without a strain", "`rod`"],
    },
    BadStructure {
        name: "statics of scissors that can fold",
        scene: "scissors-3",
        spoil: |scene| {
            (scene.time.method, scene.time.end) = (Method::Static, 1.0);
            (scene.output.interval, scene.probes) = (None, Vec::new());
        },
        refusal: &["can move without a strain", "`a1b2`", "`b1a2`", "`a2b3`", "`b2a3`"],
    },
    BadStructure {
        name: "pivots apart",
        scene: "scissors-3",
        spoil: |scene| {
            scene.points.entry("b2".into()).and_modify(|point| point[0] += 1e-6);
        },
        refusal: &["rods[1].pivot", "\"m1\"", "rods whose middles are at one place", "`a1b2`", "`b1a2`"],
    },
    BadStructure {
        name: "a relaxed start between two points",
        scene: "pendulum-2d-relaxed",
        spoil: |scene| scene.supports.push(Support { fix: vec![Direction::Y], ..support("a") }),
        refusal: &["temperature.start", "\"relaxed\"", "rods 1, points held 2"],
    },
    BadStructure {
        name: "a relaxed start of pinned rods",
        scene: "scissors-3-thermal",
        spoil: |scene| scene.temperature.iter_mut().for_each(|heat| heat.start = Start::Relaxed),
        refusal: &["temperature.start", "\"relaxed\"", "rods 6"],
    },
];

fn support(point: &str) -> Support {
    Support { point: point.into(), fix: Vec::new(), slide: None, clamp: None }
}

fn trials() -> Vec<Trial> {
    let trial = |(number, bad): (usize, &'static BadStructure)| {
        let run = || {
            let mut steps = 0;
            let mut scene = builtin(bad.scene)?;
            (bad.spoil)(&mut scene);
            // So that every step is reported.
            scene.output.interval = None;
            let outcome = run_with_progress(&scene, |done| steps = done);
            // A refusal after a step is too late, and counts as none.
            if steps > 0 { Ok(Finding::default()) } else { Ok(outcome.map(Finding::of)?) }
        };
        Trial::new(bad.name, (number + 1) as f64, run).fast(true).expect(Expected::Refusal(bad.refusal))
    };
    BAD.iter().enumerate().map(trial).collect()
}
