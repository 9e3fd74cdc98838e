//! Text of a scene: it is refused with a reason, or runs some steps to a result or an error.

#![no_main]

use ancf::model::{Method, Model};
use ancf::run::Simulation;
use libfuzzer_sys::fuzz_target;

/// Most elements, steps and rows of a scene that is run: others would take the time of a thousand.
const MOST_ELEMENTS: usize = 32;
const MOST_STEPS: usize = 40;

fuzz_target!(|text: &str| {
    let Ok(model) = Model::parse(text, "fuzz") else { return };
    let scene = model.scene();
    let again = Model::parse(&scene.to_text(), "again").expect("what was accepted is accepted when it is written anew");
    assert_eq!(again.scene(), scene);
    let elements: usize = scene.rods.iter().map(|rod| rod.elements).sum();
    // An adaptive method may make a million steps to a row.
    if elements > MOST_ELEMENTS || scene.time.method.is_adaptive() && scene.steps() > MOST_STEPS {
        return;
    }
    // Statics takes all of its load in as many steps.
    if scene.time.method == Method::Static && scene.steps() > MOST_STEPS || scene.steps() > 1_000_000 {
        return;
    }
    let Ok(mut simulation) = Simulation::new(model) else { return };
    for _ in 0..MOST_STEPS {
        if !simulation.step().unwrap_or(false) {
            break;
        }
    }
    assert!(simulation.rows().flatten().all(|number| number.is_finite()));
});
