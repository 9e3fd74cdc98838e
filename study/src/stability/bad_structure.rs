//! Structures that cannot be computed: refused before the first step, with the names of the faulty parts.

use super::prelude::*;
use ancf::model::Start;
use ancf::run::run_with_progress;

pub const CASE: Case = Case {
    name: "bad-structure",
    parameter: "number of the structure",
    unit: "–",
    reference: "none: there is no answer",
    right: "refused before the first step, with the names of the faulty parts in the message.",
    trials,
};

/// A built-in scene, the change that makes it bad, and the words of its refusal.
type BadStructure = (&'static str, &'static str, fn(&mut Scene), &'static [&'static str]);

#[rustfmt::skip]
const BAD: [BadStructure; 9] = [
    ("a direction held twice", "pendulum-flexible",
        |scene| scene.supports.push(Support { fix: vec![Direction::X], ..support("o") }),
        &["supports[1].fix", "redundant", "`o`"]),
    ("a slide along what is fixed", "pendulum-flexible",
        |scene| scene.supports.push(Support { slide: Some([1.0, 1.0]), ..support("o") }),
        &["supports[1].slide", "contradicts", "`o`"]),
    ("a rod clamped twice", "cantilever",
        |scene| scene.supports.push(Support { clamp: Some("rod".into()), ..support("o") }),
        &["supports[1].clamp", "redundant", "\"rod\""]),
    ("statics without supports", "cantilever",
        |scene| (scene.supports, scene.probes) = (Vec::new(), Vec::new()),
        &["can move without a strain", "`rod`"]),
    ("statics on a hinge", "cantilever",
        |scene| scene.supports[0].clamp = None,
        &["can move without a strain", "`rod`"]),
    ("statics of scissors that can fold", "scissors-3",
        |scene| {
            *scene = scene.clone().method(Method::Static, 1e-3).until(1.0);
            (scene.output.interval, scene.probes) = (None, Vec::new());
        },
        &["can move without a strain", "`a1b2`", "`b1a2`", "`a2b3`", "`b2a3`"]),
    ("pivots apart", "scissors-3",
        |scene| scene.points.iter_mut().filter(|(name, _)| *name == "b2").for_each(|(_, point)| point[0] += 1e-6),
        &["rods[1].pivot", "\"m1\"", "rods whose middles are at one place", "`a1b2`", "`b1a2`"]),
    ("a relaxed start between two points", "pendulum-2d-relaxed",
        |scene| scene.supports.push(Support { fix: vec![Direction::Y], ..support("a") }),
        &["temperature.start", "\"relaxed\"", "rods 1, points held 2"]),
    ("a relaxed start of pinned rods", "scissors-3-thermal",
        |scene| scene.temperature.iter_mut().for_each(|heat| heat.start = Start::Relaxed),
        &["temperature.start", "\"relaxed\"", "rods 6"]),
];

fn support(point: &str) -> Support {
    Support { point: point.into(), fix: Vec::new(), slide: None, clamp: None }
}

fn trials() -> Vec<Trial> {
    let trial = |(number, &(name, scene, spoil, refusal)): (usize, &'static BadStructure)| {
        let run = move || {
            let mut steps = 0;
            let mut scene = builtin(scene)?;
            spoil(&mut scene);
            // So that every step is reported.
            scene.output.interval = None;
            let outcome = run_with_progress(&scene, |now| steps = now.steps_done());
            // A refusal after a step is too late, and counts as none.
            if steps > 0 { Ok(Finding::default()) } else { Ok(outcome.map(Finding::of)?) }
        };
        Trial::new(name, (number + 1) as f64, run).fast(true).expect(Expected::Refusal(refusal))
    };
    BAD.iter().enumerate().map(trial).collect()
}
