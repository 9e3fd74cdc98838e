//! Initial velocities as a rigid motion: every nodal vector starts with it, and supports have to allow it.
//!
//! Source: rigid bodies. A free rod keeps the velocity of its centre and its angular momentum; at t = 0 its energy is that of a rigid one,
//! ½ m v² + ½ I ω², I = m(L² + h²)/12, of Euler–Bernoulli elements without h².

mod common;

use ancf::model::{Constraints, Element, Method, Model, Motion, Quantity, Scene, Start, Temperature, ThermalModel};
use common::motion::{must_run, positions, probe, velocities};

fn free_rod(element: Element, elements: usize, motion: Motion) -> Scene {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    (scene.supports, scene.gravity, scene.motion) = (Vec::new(), [0.0; 2], Some(motion));
    // Not along an axis, and not at the origin.
    scene.points = [("o".to_string(), [3.0, -1.0]), ("a".to_string(), [3.6, -0.2])].into();
    (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
    scene.probes = ["o", "a"].map(|point| probe(point, &[Quantity::Position, Quantity::Velocity])).to_vec();
    (scene.time.step, scene.time.end, scene.output.interval) = (1e-3, 0.1, None);
    scene
}

const SPIN: Motion = Motion { velocity: [0.7, -0.4], omega: 2.0, about: [1.0, 2.0] };

#[test]
fn the_start_is_that_of_a_rigid_body() {
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for elements in [1, 2, 5] {
            let scene = free_rod(element, elements, SPIN);
            let run = must_run(&scene);
            for (point, start) in &scene.points {
                let expected = [0.7 - 2.0 * (start[1] - 2.0), -0.4 + 2.0 * (start[0] - 1.0)];
                let found = velocities(&run, point)[0];
                assert!((found[0] - expected[0]).hypot(found[1] - expected[1]) < 1e-14, "{found:?}, {expected:?}");
            }
            let centre = SPIN.at([3.3, -0.6]);
            let (mass, h) = (7750.0 * 4e-4, if element == Element::Ancf { 0.02 } else { 0.0 });
            let expected =
                0.5 * mass * (centre[0].powi(2) + centre[1].powi(2)) + 0.5 * mass * (1.0 + h * h) / 12.0 * 4.0;
            let kinetic = run.trajectory.column("energy.kinetic").unwrap();
            assert!((kinetic[0] / expected - 1.0).abs() < 1e-14, "{} J, {expected} J", kinetic[0]);
            // What is there at the start was not created.
            let balance = run.trajectory.column("energy.balance").unwrap();
            assert!(balance[0] == 0.0 && balance.iter().all(|b| b.abs() < 1e-12 * expected), "{balance:?}");
        }
    }
}

/// Without a rotation nothing strains the rod: it moves on as a whole, by every method.
#[test]
fn a_free_rod_moves_on() {
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Gauss, Method::Explicit, Method::Nystrom] {
        let mut scene = free_rod(Element::Ancf, 3, Motion { velocity: [2.0, -1.0], ..Motion::default() });
        scene.time.method = method;
        (scene.time.step, scene.output.interval) = (2e-5, Some(0.05));
        let run = must_run(&scene);
        for (point, start) in &scene.points {
            let [x, y] = *positions(&run, point).last().unwrap();
            assert!((x - start[0] - 0.2).hypot(y - start[1] + 0.1) < 1e-12, "{method}: ({x}, {y})");
        }
    }
}

/// A pendulum swings up from its lowest point by pins as shared coordinates and by multipliers alike, and from a relaxed start.
#[test]
fn forms_of_constraints_agree_and_a_relaxed_start_spins() {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.points.insert("a".into(), [0.0, -1.0]);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega: 5.0, about: [0.0; 2] });
    (scene.time.method, scene.time.step, scene.time.end) = (Method::GeneralizedAlpha, 1e-3, 0.2);
    scene.rods[0].elements = 2;
    let condensed = positions(&must_run(&scene), "tip");
    let mut multiplied = scene.clone();
    multiplied.constraints = Constraints::Multipliers;
    let off = common::motion::farthest(&condensed, &positions(&must_run(&multiplied), "tip"));
    assert!(off < 1e-9 && condensed.last().unwrap()[0] > 0.7, "{off:e}, {:?}", condensed.last());

    let history = vec![[0.0, 200.0]];
    scene.temperature = Some(Temperature { model: ThermalModel::TwoD, start: Start::Relaxed, history });
    let run = must_run(&scene);
    let length = (1.0f64 + 2.0 * 2.85e-5 * 200.0).sqrt();
    let [x, y] = velocities(&run, "tip")[0];
    assert!((x - 5.0 * length).abs() < 1e-14 && y.abs() < 1e-14, "({x}, {y})");
}

#[test]
fn a_motion_survives_its_file() {
    let scene = free_rod(Element::Ancf, 2, SPIN);
    assert_eq!(Model::parse(&scene.to_text(), "printed").unwrap().into_scene(), scene);
    let text = Scene::builtin("pendulum-flexible").unwrap().to_text();
    assert!(!text.contains("motion"), "at rest is said by nothing");
}

/// What supports hold may not move, clamps may not turn, and statics does neither.
#[test]
fn motions_that_do_not_fit_are_refused_by_name() {
    let refused = |change: &dyn Fn(&mut Scene), parts: &[&str]| {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        change(&mut scene);
        let message = Model::parse(&scene.to_text(), "mine.json").unwrap_err().to_string();
        for part in parts {
            assert!(message.contains(part), "no {part:?} in: {message}");
        }
    };
    let motion = |velocity, omega, about| Some(Motion { velocity, omega, about });
    refused(&|scene| scene.motion = motion([0.0, 1.0], 0.0, [0.0; 2]), &["`motion`", "`o`", "supports[0]", "1e0 m/s"]);
    refused(&|scene| scene.motion = motion([0.0; 2], 1.0, [0.5, 0.0]), &["`motion`", "`o`", "supports[0]"]);
    let clamped = |scene: &mut Scene| {
        scene.motion = motion([0.0; 2], 1.0, [0.0; 2]);
        scene.supports[0].clamp = Some("rod".into());
    };
    refused(&clamped, &["`motion.omega` is 1.0", "0, as supports[0] clamps a rod at `o`"]);
    let still = |scene: &mut Scene| {
        *scene = Scene::builtin("cantilever").unwrap();
        scene.motion = motion([0.0; 2], 0.0, [0.0; 2]);
    };
    refused(&still, &["`motion`", "nothing moves"]);
    let text = Scene::builtin("pendulum-flexible").unwrap().to_text();
    let with = |motion: &str| {
        let text = text.replacen("\"time\"", &format!("\"motion\": {motion}, \"time\""), 1);
        Model::parse(&text, "mine.json").unwrap_err().to_string()
    };
    assert!(with("{\"omga\": 1}").contains("nearest: `omega`"), "{}", with("{\"omga\": 1}"));
    assert!(with("null").contains("an object"), "{}", with("null"));
    assert!(with("{\"velocity\": [1e999, 0]}").contains("motion.velocity"), "{}", with("{\"velocity\": [1e999, 0]}"));
    assert!(with("{\"omega\": 1e300, \"about\": [1e300, 0]}").contains("motion"));
}
