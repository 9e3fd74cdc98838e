//! Newton's iteration with factors of earlier iterations and steps: they are reused, and it changes nothing.

mod common;

use ancf::integrators::Counts;
use ancf::internals::model::Plan;
use ancf::internals::run::run_planned;
use ancf::model::{Method, Scene};
use ancf::run::Run;
use common::evidence;
use common::motion::{farthest, must_run, positions};

/// With a new matrix for every iteration.
fn plain(scene: &Scene) -> Run {
    run_planned(scene, &Plan { new_matrices: true, ..Plan::of(scene) }, |_| ()).unwrap()
}

fn pendulum(method: Method, end: f64) -> Scene {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    assert_eq!(scene.rods[0].elements, 8);
    (scene.time.method, scene.time.step, scene.time.end) = (method, 1e-3, end);
    scene
}

/// One matrix for each iteration, and one solution.
fn assert_one_each(what: &str, counts: &Counts) {
    assert!(counts.newton_iterations > counts.steps, "{what}: {counts:?}");
    assert_eq!(counts.factorizations, counts.newton_iterations, "{what}: {counts:?}");
    assert_eq!(counts.tangent_calls, counts.factorizations, "{what}: {counts:?}");
    assert_eq!(counts.solves, counts.newton_iterations, "{what}: {counts:?}");
}

/// Generalized-α needs 949 matrices and 2235 iterations for 1000 steps, plain Newton 2001 and 2000; Gauss 902 and 4128,
/// plain 3859 and 3859. The motion is that of plain Newton: 8.9e-13 m and 2.4e-13 m are measured.
#[test]
fn a_matrix_serves_many_steps() {
    for method in [Method::GeneralizedAlpha, Method::Gauss] {
        let scene = pendulum(method, 1.0);
        let (reused, plain) = (must_run(&scene), plain(&scene));
        let distance = farthest(&positions(&reused, "tip"), &positions(&plain, "tip"));
        let (counts, of_plain) = (reused.counts, plain.counts);
        println!("{method}: {distance:.1e} m; {counts:?}; plain {of_plain:?}");
        evidence::number(&format!("reuse.{method}.reused"), counts.factorizations);
        evidence::number(&format!("reuse.{method}.plain"), of_plain.factorizations);
        evidence::at_most("reuse.position", distance);
        assert_eq!((counts.steps, of_plain.steps), (1000, 1000));
        assert!(counts.factorizations < counts.steps, "{method}: {counts:?}");
        assert!(counts.newton_iterations > 2 * counts.factorizations, "{method}: {counts:?}");
        assert!(of_plain.factorizations >= of_plain.steps, "{method}: {of_plain:?}");
        assert!(counts.factorizations < of_plain.factorizations / 2, "{method}: {counts:?}, {of_plain:?}");
        // Every matrix is counted, the tangents among them.
        assert!(counts.factorizations - counts.tangent_calls <= 1, "{method}: {counts:?}");
        assert!(distance <= 1e-8, "{method}: {distance:.1e} m");
    }
}

/// Energy–momentum and statics make one for each iteration. Statics makes one more for the rate of each equilibrium, from
/// which the next load step begins in place of an iteration: 31 for ten steps, where there were 30 iterations without rates.
#[test]
fn others_make_one_each() {
    assert_one_each("energy-momentum", &must_run(&pendulum(Method::EnergyMomentum, 0.2)).counts);
    let statics = must_run(&Scene::builtin("scissor-static").unwrap()).counts;
    let rates = statics.steps + 1;
    assert_eq!((statics.steps, statics.rejected, statics.factorizations), (10, 0, 31));
    let iterations = Counts {
        factorizations: statics.factorizations - rates,
        tangent_calls: statics.tangent_calls - rates,
        solves: statics.solves - rates,
        ..statics
    };
    assert_one_each("statics", &iterations);
}

/// Scissors at full speed with steps of 10 ms: where an old matrix does harm the iteration goes back and makes a new one, and
/// ends where plain Newton ends: 3.3e-11 m over 3 s with generalized-α. Gauss to 2 s, after which the step is too long for plain
/// Newton as well.
#[test]
fn where_reuse_fails_it_is_plain_newton() {
    for (method, end) in [(Method::GeneralizedAlpha, 3.0), (Method::Gauss, 2.0)] {
        let mut scene = Scene::builtin("scissors-3").unwrap();
        scene.rods.iter_mut().for_each(|rod| rod.elements = 2);
        (scene.time.method, scene.time.step, scene.time.end) = (method, 1e-2, end);
        (scene.output.energy, scene.output.interval) = (false, Some(1e-2));
        scene.time.newton_tolerance = 1e-12;
        let (reused, plain) = (must_run(&scene), plain(&scene));
        let distance = farthest(&positions(&reused, "a4"), &positions(&plain, "a4"));
        println!("{method}: {distance:.1e} m; {:?}; plain {:?}", reused.counts, plain.counts);
        assert_eq!(reused.counts.steps, (100.0 * end) as usize);
        assert!(reused.counts.newton_iterations < 2 * plain.counts.newton_iterations, "{method}");
        assert!(distance <= 1e-8, "{method}: {distance:.1e} m");
    }
}
