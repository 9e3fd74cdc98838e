//! The plan: what it leaves out of each scene, and that nothing of it shows in the results.

mod common;
#[path = "common/states.rs"]
mod states;

use ancf::internals::model::Plan;
use ancf::internals::model::builtin_names;
use ancf::internals::run::run_planned;
use ancf::internals::structure::{Factors, Matrix, Structure};
use ancf::model::{Element, Law, Method, Quantity, Scene, Start, Temperature, ThermalModel};
use ancf::run::{Run, run};
use common::evidence;
use common::motion::probe;
use nalgebra::DVector;
use proptest::prelude::*;
use states::cases;

/// A built-in scene that is over soon.
fn short(name: &str) -> Scene {
    let mut scene = Scene::builtin(name).unwrap();
    if scene.time.method == Method::Static {
        scene.time.load_steps = scene.time.load_steps.min(3);
        return scene;
    }
    scene.time.end = 0.05;
    // The explicit method is stable below 7e-5 s.
    scene.time.step = if scene.time.method == Method::Explicit { 5e-5 } else { 1e-3 };
    scene.output.interval = Some(5e-3);
    scene
}

/// Columns of positions and deflections.
fn places(run: &Run) -> Vec<f64> {
    let names = &run.trajectory.columns;
    let place = |name: &str| name.ends_with(".x") || name.ends_with(".y") || name.ends_with(".w");
    let columns: Vec<usize> = (0..names.len()).filter(|&n| place(&names[n])).collect();
    assert!(!columns.is_empty());
    run.trajectory.rows.iter().flat_map(|row| columns.iter().map(|&n| row[n])).collect()
}

/// Largest difference of two lists; a NaN is infinite.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let of = |(a, b): (&f64, &f64)| if (a - b).is_nan() { f64::INFINITY } else { (a - b).abs() };
    a.iter().zip(b).map(of).fold(0.0, f64::max)
}

/// All built-in scenes, by their own methods and by two that reuse matrices, 0.05 s at 1 ms.
#[test]
fn pruned_runs_are_full_runs() {
    let mut number = 0;
    for name in builtin_names() {
        let scene = short(name);
        let mut methods = vec![scene.time.method];
        if scene.time.method != Method::Static {
            methods.extend([Method::GeneralizedAlpha, Method::Gauss]);
        }
        for method in methods {
            let mut scene = scene.clone();
            // Sudden heat and 1 ms are too much for implicit methods.
            let sudden = scene.time.method == Method::Explicit || name == "scissors-3-thermal";
            if method != scene.time.method && sudden {
                scene.time.step = 1e-4;
            }
            scene.time.method = method;
            let pruned = run(&scene).unwrap_or_else(|error| panic!("{name}, {method}: {error}"));
            let full = run_planned(&scene, &Plan::full(&scene), |_| ()).unwrap();
            assert_eq!(pruned.trajectory.columns, full.trajectory.columns);
            let distance = difference(&places(&pruned), &places(&full));
            println!("{name}, {method}: {distance:.1e} m");
            evidence::at_most("plan.position", distance);
            assert!(distance <= 1e-8, "{name}, {method}: {distance:.1e} m");
            number += 1;
        }
    }
    assert_eq!(number, 8 * 3 + 2);
}

/// What is left out of a built-in scene: heat, Poisson's terms, weight, energy, accelerations, multipliers, matrices.
#[test]
fn what_is_left_out() {
    // Heat, Poisson, weight, energy, acceleration, multipliers, new matrices.
    let rows: [(&str, [bool; 7]); 10] = [
        ("pendulum-flexible", [false, false, true, true, false, false, true]),
        ("pendulum-1d", [true, false, true, true, false, false, false]),
        ("pendulum-2d", [true, false, true, true, false, false, false]),
        ("pendulum-1d-relaxed", [true, false, true, true, false, false, true]),
        ("pendulum-2d-relaxed", [true, false, true, true, false, false, true]),
        ("free-rod-heated", [true, false, false, true, false, false, true]),
        ("scissors-3", [false, false, false, true, true, false, true]),
        ("scissors-3-thermal", [true, false, false, true, true, false, true]),
        ("cantilever", [false, false, false, false, false, false, true]),
        ("scissor-static", [false, false, false, false, false, false, true]),
    ];
    assert!(builtin_names().eq(rows.iter().map(|(name, _)| *name)), "a built-in scene has no row");
    for (name, [heat, poisson, weight, energy, acceleration, multipliers, new_matrices]) in rows {
        let expected = Plan { heat, poisson, weight, energy, acceleration, multipliers, new_matrices };
        assert_eq!(Plan::of(&Scene::builtin(name).unwrap()), expected, "{name}");
    }
}

/// One change to a scene, and the part of the plan that it changes.
#[test]
fn what_a_change_asks_for() {
    let base = {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        (scene.time.method, scene.output.energy, scene.gravity) = (Method::GeneralizedAlpha, false, [0.0; 2]);
        scene
    };
    let nothing = Plan::of(&base);
    let none = Plan {
        heat: false,
        poisson: false,
        weight: false,
        energy: false,
        acceleration: false,
        multipliers: false,
        new_matrices: false,
    };
    assert_eq!(nothing, none);
    let changed = |change: &dyn Fn(&mut Scene)| {
        let mut scene = base.clone();
        change(&mut scene);
        scene.clone().build().unwrap();
        Plan::of(&scene)
    };
    let heat = |model| Temperature { model, start: Start::Sudden, history: vec![[0.0, 10.0]] };
    assert_eq!(changed(&|scene| scene.temperature = Some(heat(ThermalModel::OneD))), Plan { heat: true, ..none });
    assert_eq!(
        changed(&|scene| scene.rods[0].temperature = Some(heat(ThermalModel::TwoD))),
        Plan { heat: true, ..none }
    );
    assert_eq!(changed(&|scene| scene.temperature = Some(heat(ThermalModel::None))), none);
    assert_eq!(changed(&|scene| scene.material.nu = 0.3), Plan { poisson: true, ..none });
    assert_eq!(changed(&|scene| scene.material.nu = -0.1), Plan { poisson: true, ..none });
    let of_strut = |scene: &mut Scene| (scene.material.nu, scene.rods[0].law) = (0.3, Law::Uniaxial);
    assert_eq!(changed(&of_strut), none);
    let own = |scene: &mut Scene| {
        scene.rods[0].material = Some(scene.material.clone());
        scene.material.nu = 0.3;
    };
    assert_eq!(changed(&own), none);
    assert_eq!(changed(&|scene| scene.gravity = [1e-3, 0.0]), Plan { weight: true, ..none });
    assert_eq!(changed(&|scene| scene.output.energy = true), Plan { energy: true, ..none });
    for quantity in [Quantity::Acceleration, Quantity::Reaction] {
        let asks = |scene: &mut Scene| scene.probes.push(probe("o", &[quantity]));
        assert_eq!(changed(&asks), Plan { acceleration: true, ..none }, "{quantity}");
    }
    let multipliers = |scene: &mut Scene| scene.constraints = ancf::model::Constraints::Multipliers;
    assert_eq!(changed(&multipliers), Plan { multipliers: true, ..none });
    for method in [Method::Explicit, Method::Gauss, Method::Nystrom, Method::GaussAdaptive, Method::NystromAdaptive] {
        assert_eq!(changed(&|scene| scene.time.method = method), none, "{method}");
    }
    assert_eq!(changed(&|scene| scene.time.method = Method::EnergyMomentum), Plan { new_matrices: true, ..none });
}

/// Every part is told of, and those that are computed are those of the plan.
#[test]
fn parts_say_what_is_computed() {
    for name in builtin_names() {
        let scene = Scene::builtin(name).unwrap();
        let plan = Plan::of(&scene);
        let computed: Vec<bool> = plan.parts(&scene).iter().map(|part| part.computed).collect();
        let Plan { heat, poisson, weight, energy, acceleration, multipliers, new_matrices } = plan;
        let tangents = !scene.time.method.is_explicit();
        let expected = [heat, poisson, weight, multipliers, energy, acceleration, true, tangents, new_matrices];
        assert_eq!(computed, expected, "{name}");
    }
}

/// Scenes for which something is left out of forces: heat, Poisson's terms, or both.
fn elastic_scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for name in ["pendulum-flexible", "pendulum-2d", "scissors-3", "scissors-3-thermal"] {
        for element in [Element::Ancf, Element::EulerBernoulli] {
            let mut scene = Scene::builtin(name).unwrap();
            scene.rods.iter_mut().for_each(|rod| (rod.elements, rod.element) = (2, element));
            scenes.push(scene);
        }
    }
    let mut axis = Scene::builtin("pendulum-flexible").unwrap();
    (axis.rods[0].poisson, axis.rods[0].elements) = (ancf::model::Poisson::Axis, 2);
    scenes.push(axis);
    // Plane strain beside a strut.
    let mut mixed = Scene::builtin("scissors-3").unwrap();
    mixed.material.nu = 0.3;
    mixed.rods.iter_mut().for_each(|rod| rod.elements = 2);
    mixed.rods[1].law = Law::Uniaxial;
    scenes.push(mixed);
    scenes
}

proptest! {
    #![proptest_config(cases(64))]

    /// Forces and tangents of both plans, at random states: entries to 1e-13 of the largest in the vector or matrix.
    #[test]
    fn forces_and_tangents_are_those_of_the_full_plan(values in prop::collection::vec(-0.2..0.2, 97), t in 0.0..2.0) {
        for scene in elastic_scenes() {
            let (pruned, full) = (Structure::new(&scene).unwrap(), Structure::planned(&scene, &Plan::full(&scene)).unwrap());
            let u = DVector::from_fn(pruned.size(), |i, _| values[i % values.len()]);
            let of = |structure: &Structure| {
                let (thermal, mut force) = (structure.thermal_strains(t), DVector::zeros(structure.size()));
                structure.force(&u, &thermal, &mut force);
                let mut load = DVector::zeros(structure.size());
                structure.load_into(t, &mut load);
                (force, structure.tangent(&u, &thermal).dense(), load, structure.strain_energy(&u, &thermal))
            };
            let ((force, tangent, load, energy), (full_force, full_tangent, full_load, full_energy)) = (of(&pruned), of(&full));
            let close = |a: &[f64], b: &[f64]| {
                let size = b.iter().fold(0.0, |most: f64, b| most.max(b.abs()));
                difference(a, b) <= 1e-13 * size && size > 0.0
            };
            prop_assert!(close(force.as_slice(), full_force.as_slice()), "{}", scene.title);
            prop_assert!(close(tangent.as_slice(), full_tangent.as_slice()), "{}", scene.title);
            prop_assert!(close(&[energy], &[full_energy]), "{}", scene.title);
            prop_assert_eq!(load, full_load);
        }
    }
}

/// Factors of the pruned tangent solve the full tangent's equations.
#[test]
fn factors_are_those_of_the_full_plan() {
    for scene in elastic_scenes() {
        let structure = Structure::new(&scene).unwrap();
        let u = DVector::from_fn(structure.size(), |i, _| 0.01 * ((i * 7 % 11) as f64 - 5.0) / 11.0);
        let thermal = structure.thermal_strains(0.5);
        let mut factors: Factors = structure.factors();
        let mass = 1e7;
        structure.factorize(Matrix::Tangent { u: &u, thermal: &thermal, stiffness: 1.0, mass }, &mut factors).unwrap();
        let b = DVector::from_fn(structure.size(), |i, _| (i as f64).cos());
        let mut x = b.clone();
        factors.solve(&mut x);
        let full = Structure::planned(&scene, &Plan::full(&scene)).unwrap();
        let matrix = full.tangent(&u, &full.thermal_strains(0.5)).dense() + mass * full.mass().dense();
        let terms = matrix.abs() * x.abs() + b.abs();
        let residual = &matrix * &x - &b;
        let worst = residual.iter().zip(&terms).map(|(r, s)| r.abs() / s).fold(0.0, f64::max);
        assert!(worst.is_finite() && worst <= 1e-10, "{}: {worst:.1e}", scene.title);
    }
}
