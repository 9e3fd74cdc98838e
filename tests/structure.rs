//! Structures: assembly, pins, the relaxed start, the stability bound, independence of place and direction; and how runs
//! that cannot be trusted end.

mod common;

use ancf::error::Error;
use ancf::internals::structure::Structure;
use ancf::model::{Constraints, Element, Law, Material, Method, Poisson, Rod, Scene, Support};
use ancf::run::run;
use nalgebra::{DVector, Rotation2, Vector2};

/// The pendulum of a built-in scene, turned by `angle` about the origin with its gravity, and moved by `by`.
fn turned_and_moved(name: &str, angle: f64, by: [f64; 2]) -> Scene {
    let mut scene = Scene::builtin(name).unwrap();
    let turn = Rotation2::new(angle);
    for point in scene.points.values_mut() {
        *point = (turn * Vector2::from(*point) + Vector2::from(by)).into();
    }
    scene.gravity = (turn * Vector2::from(scene.gravity)).into();
    scene
}

/// Two rods of three elements, pinned at a knee: o–a horizontal, a–b upwards.
fn knee() -> Scene {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.points.insert("b".into(), [1.5, 2.0]);
    scene.rods[0].elements = 3;
    let mut second = scene.rods[0].clone();
    (second.name, second.from, second.to) = ("second".into(), "a".into(), "b".into());
    scene.rods.push(second);
    scene
}

/// A displacement without pattern, of about `size`.
fn somewhere(structure: &Structure, size: f64) -> DVector<f64> {
    DVector::from_fn(structure.size(), |i, _| size * (1.7 * i as f64 + 0.3).sin())
}

/// The tangent of two pinned rods is the derivative of their forces: a cubic in u, so five points are exact.
#[test]
fn the_assembled_tangent_is_a_derivative() {
    let structure = Structure::new(knee()).unwrap();
    let (u, heat) = (somewhere(&structure, 0.1), [[0.02, -0.01], [-0.03, 0.0]]);
    let force = |u: &DVector<f64>| {
        let mut sum = DVector::zeros(structure.size());
        structure.force(u, &heat, &mut sum);
        sum
    };
    let tangent = structure.tangent(&u, &heat).dense();
    for i in 0..structure.size() {
        let at = |step: f64| {
            let mut moved = u.clone();
            moved[i] += step;
            force(&moved)
        };
        let derivative = (8.0 * (at(0.5) - at(-0.5)) - (at(1.0) - at(-1.0))) / 6.0;
        let off = (tangent.column(i) - derivative).amax();
        assert!(off <= 1e-11 * tangent.amax(), "column {i}: off by {off:.1e} of {:.1e}", tangent.amax());
    }
}

/// A chain that nothing holds falls like a stone, undeformed: r = r₀ + ½ g t². The knee is one point of both rods.
#[test]
fn a_free_chain_falls_like_a_stone() {
    let mut scene = knee();
    scene.supports.clear();
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 1e-2, 1.0);
    let run = run(&scene).unwrap();
    let y = *run.trajectory.column("tip.y").unwrap().last().unwrap();
    assert!((y + 4.9).abs() < 1e-12, "the knee is at {y} m");
    let strain = run.trajectory.column("energy.strain").unwrap();
    assert!(strain.iter().all(|energy| energy.abs() < 1e-12), "{strain:?}");
}

/// Free heating, 1D and 2D, at any inclination: the relaxed rod has its ends √(1 + 2αΔT) apart and no forces, and stays.
#[test]
fn a_relaxed_free_rod_is_stress_free_at_any_inclination() {
    for (name, angle) in
        ["pendulum-1d-relaxed", "pendulum-2d-relaxed"].iter().flat_map(|n| (0..12).map(move |k| (n, k)))
    {
        let mut scene = turned_and_moved(name, angle as f64 * 0.55, [3.0, -2.0]);
        scene.supports.clear();
        scene.gravity = [0.0, 0.0];
        (scene.time.step, scene.time.end, scene.output.interval) = (1e-3, 0.1, None);
        let structure = Structure::new(&scene).unwrap();
        let u = structure.start();
        let [o, a] = ["o", "a"].map(|point| Vector2::from(structure.position(structure.point(point).unwrap(), u)));
        let expected = (1.0f64 + 2.0 * 2.85e-5 * 200.0).sqrt();
        assert!(((a - o).norm() - expected).abs() <= 1e-13 * expected, "{name}, {angle}: {}", (a - o).norm());

        let mut force = DVector::zeros(structure.size());
        structure.force(u, &structure.thermal_strains(0.0), &mut force);
        let unit_strain = 2e8 * 0.02 * 0.02;
        assert!(force.amax() <= 1e-12 * unit_strain, "{name}, {angle}: {:.1e} N", force.amax());

        let rows = run(&scene).unwrap().trajectory;
        let moved = |name: &str| {
            rows.column(name)
                .unwrap()
                .iter()
                .map(|x| x - rows.column(name).unwrap()[0])
                .fold(0.0, |m: f64, d| m.max(d.abs()))
        };
        assert!(moved("tip.x").max(moved("tip.y")) <= 1e-12, "{name}, {angle}: it moved");
    }
}

/// Unknowns are displacements, so neither a shift of 10⁶ m nor a turn of the scene changes the motion.
#[test]
fn place_and_direction_do_not_matter() {
    let tip = |scene: &mut Scene| {
        (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 5e-4, 0.25);
        let structure = Structure::new(&*scene).unwrap();
        let start = Vector2::from(structure.position(structure.point("a").unwrap(), &DVector::zeros(structure.size())));
        let rows = run(&*scene).unwrap().trajectory;
        let end = |name: &str| *rows.column(name).unwrap().last().unwrap();
        (Vector2::new(end("tip.x"), end("tip.y")) - start, Vector2::new(end("tip.vx"), end("tip.vy")))
    };
    for name in ["pendulum-flexible", "pendulum-1d", "pendulum-2d-relaxed"] {
        let (moved, velocity) = tip(&mut turned_and_moved(name, 0.0, [0.0, 0.0]));
        let (far, far_velocity) = tip(&mut turned_and_moved(name, 0.0, [1e6, -1e6]));
        // Only the printed position is rounded at 10⁶ m, and the coordinates of the scene itself.
        assert!((far - moved).norm() < 1e-8 && (far_velocity - velocity).norm() < 1e-6, "{name}: {far} {moved}");
        let turn = Rotation2::new(0.9);
        let (turned, turned_velocity) = tip(&mut turned_and_moved(name, 0.9, [0.0, 0.0]));
        assert!((turned - turn * moved).norm() < 1e-9, "{name}: {turned} {}", turn * moved);
        assert!((turned_velocity - turn * velocity).norm() < 1e-6, "{name}");
    }
}

/// The stability bound is above the true largest frequency, and not by so much that it costs steps.
#[test]
fn the_frequency_bound_is_a_bound_and_close() {
    for (elements, held, height) in
        [(1, true, 0.02), (3, true, 0.1), (4, true, 0.02), (4, false, 0.02), (16, true, 0.02), (23, false, 0.02)]
    {
        let mut scene = Scene::builtin("pendulum-2d").unwrap();
        (scene.rods[0].elements, scene.section.height) = (elements, height);
        if !held {
            scene.supports = Vec::<Support>::new();
        }
        let structure = Structure::new(&scene).unwrap();
        let stiffness = structure.tangent(structure.start(), &structure.thermal_strains(0.0)).dense();
        let mass = structure.mass().dense();
        let lower = mass.cholesky().unwrap().l();
        let half = lower.solve_lower_triangular(&stiffness).unwrap();
        let largest = lower.solve_lower_triangular(&half.transpose()).unwrap().symmetric_eigenvalues().max().sqrt();
        let bound = structure.largest_frequency().unwrap();
        assert!((0.999_999..1.1).contains(&(bound / largest)), "{elements} elements: {bound:e} for {largest:e} rad/s");
    }
}

/// Heat makes a rod thicker and faster: an explicit step of 0.99 of the limit must bear heat that comes later, and the
/// overshoot of a sudden one.
#[test]
fn the_limit_holds_when_the_rod_is_hot() {
    for history in [vec![[0.0, 0.0], [0.05, 200.0]], vec![[0.0, 200.0]], vec![[0.0, 0.0], [0.05, 5000.0]]] {
        let mut scene = Scene::builtin("pendulum-2d").unwrap();
        scene.rods[0].elements = 2;
        scene.time.method = Method::Explicit;
        scene.temperature.as_mut().unwrap().history = history.clone();
        let limit = 2.0 / Structure::new(&scene).unwrap().largest_frequency().unwrap();
        (scene.time.step, scene.time.end, scene.output.interval) = (0.99 * limit, 3000.0 * 0.99 * limit, None);
        let rows = run(&scene).unwrap_or_else(|error| panic!("{history:?}: {error}")).trajectory;
        let balance = rows.column("energy.balance").unwrap();
        let kinetic = rows.column("energy.kinetic").unwrap().into_iter().fold(0.0, f64::max);
        assert!(balance.iter().all(|b| b.abs() < 0.3 * kinetic), "{history:?}: it grows");
    }
}

/// An explicit step just below the limit stays bounded; just above it is refused with the limit.
#[test]
fn explicit_steps_over_the_limit_are_refused() {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    let limit = 2.0 / Structure::new(&scene).unwrap().largest_frequency().unwrap();
    scene.time.method = Method::Explicit;
    scene.output.interval = None;
    let mut with_step = |step: f64| {
        (scene.time.step, scene.time.end) = (step, 2000.0 * step);
        run(&scene)
    };
    let energy = with_step(0.99 * limit).unwrap().trajectory.column("energy.balance").unwrap();
    assert!(energy.iter().all(|balance| balance.abs() < 1e-2), "unstable below the limit");
    match with_step(1.01 * limit) {
        Err(Error::StepTooLarge { largest, .. }) => assert!((largest - limit).abs() < 1e-12 * limit),
        other => panic!("{other:?}"),
    }
}

/// Where Newton's iteration does not converge the run ends with time, iterations and residual.
#[test]
fn a_newton_failure_names_time_and_residual() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    // By generalized-α elements would collapse before.
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 0.01, 1.0);
    scene.output.interval = None;
    match run(&scene) {
        Err(Error::NewtonFailed { time, iterations, residual, tolerance, .. }) => {
            assert!(time > 0.0 && iterations > 0 && residual > tolerance);
        }
        other => panic!("{:?}", other.map(|run| run.counts)),
    }
}

/// A load below the rounding error of the elastic forces still moves the structure: a steel wire in microgravity.
#[test]
fn a_small_load_is_not_rounded_away() {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.supports.clear();
    (scene.material.youngs_modulus, scene.section.height, scene.section.width) = (2e11, 1e-3, 1e-3);
    scene.gravity = [0.0, -1e-5];
    (scene.time.step, scene.time.end, scene.output.interval) = (1e-2, 10.0, None);
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
        scene.time.method = method;
        let y = *run(&scene).unwrap().trajectory.column("tip.y").unwrap().last().unwrap();
        assert!((y + 5e-4).abs() < 1e-9, "{method}: {y}");
    }
}

/// What a matrix takes grows with the number of elements and of rods, not faster: a chain, a star and scissors.
#[test]
fn memory_is_linear() {
    let bytes = |scene: &Scene| Structure::new(scene).unwrap().matrix_bytes() as f64;
    let mut scene = knee();
    let mut third = scene.rods[1].clone();
    (third.name, third.from, third.to) = ("third".into(), "a".into(), "c".into());
    scene.points.insert("c".into(), [1.5, -2.0]);
    scene.rods.push(third);
    let star = |scene: &mut Scene, elements| {
        scene.rods.iter_mut().for_each(|rod| rod.elements = elements);
        bytes(scene)
    };
    let ratio = star(&mut scene, 2000) / star(&mut scene, 20);
    assert!(ratio < 101.0, "100 times the elements take {ratio} times the memory");
}

/// A scene changed in memory is validated like a file.
#[test]
fn a_scene_that_is_not_valid_is_refused() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    scene.rods[0].to = "nowhere".into();
    assert!(matches!(run(&scene), Err(Error::Scene { key, .. }) if key.contains("rods[0].to")));
}

/// Numbers that overflow end in an error, never in a row.
#[test]
fn numbers_that_overflow_end_in_an_error() {
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        (scene.material.rho, scene.time.method) = (1e308, method);
        let error = run(&scene).unwrap_err();
        assert!(!error.is_bad_input(), "{error}");
    }
}

/// Rounding is no failure: with 32 short elements and displacements of two metres the residual cannot get below
/// ε_mach EA |u|/l, and the iteration knows.
#[test]
fn newton_stops_at_the_rounding_error() {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.rods[0].elements = 32;
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 0.05, 1.0);
    (scene.time.newton_tolerance, scene.output.interval) = (1e-15, None);
    let counts = run(&scene).unwrap().counts;
    assert!(counts.newton_iterations <= 10 * counts.steps, "{counts:?}");
}

/// A step that cannot resolve the wave of a heat shock is reported.
#[test]
fn coarse_steps_under_a_heat_shock_are_warned_of() {
    let warnings = |name: &str, step: f64| {
        let mut scene = Scene::builtin(name).unwrap();
        scene.time.method = Method::EnergyMomentum;
        (scene.time.step, scene.time.end, scene.output.interval) = (step, 2.0 * step, None);
        run(&scene).unwrap().warnings
    };
    assert!(warnings("pendulum-2d", 1e-3)[0].contains("axial wave"));
    assert!(warnings("pendulum-2d", 2.5e-4)[0].contains("axial wave"));
    assert!(warnings("pendulum-2d", 2.5e-5).is_empty() && warnings("pendulum-2d-relaxed", 1e-3).is_empty());
}

/// The paper's element with ν ≠ 0 is too stiff, and says so: by (1 − 2ν)/(1 − ν)² = 0.816 at ν = 0.3. The cure and the
/// Euler–Bernoulli element do not lock.
#[test]
fn locking_is_warned_of() {
    let warnings = |nu: f64, change: fn(&mut Rod)| {
        let mut scene = Scene::builtin("cantilever").unwrap();
        scene.material.nu = nu;
        change(&mut scene.rods[0]);
        run(&scene).unwrap().warnings
    };
    let locked = warnings(0.3, |_| {});
    assert!(locked.len() == 1 && locked[0].contains("81.6 %") && locked[0].contains("`rod`"), "{locked:?}");
    assert!(locked[0].contains("\"poisson\": \"axis\"") && locked[0].contains("\"law\": \"uniaxial\""), "{locked:?}");
    assert!(warnings(0.0, |_| {}).is_empty());
    assert!(warnings(0.3, |rod| rod.poisson = Poisson::Axis).is_empty());
    assert!(warnings(0.3, |rod| rod.law = Law::Uniaxial).is_empty());
    assert!(warnings(0.3, |rod| rod.element = Element::EulerBernoulli).is_empty());
}

/// The warning about locking names every rod that locks, those of one ν together, and no other.
#[test]
fn locking_is_warned_of_rod_by_rod() {
    let mut scene = knee();
    scene.material.nu = 0.3;
    let mut more = scene.rods.clone();
    for (rod, (name, nu)) in more.iter_mut().zip([("third", 0.25), ("fourth", 0.0)]) {
        (rod.name, rod.material) = (name.into(), Some(Material::new(2e8, nu, 7200.0)));
    }
    scene.rods.extend(more);
    (scene.time.step, scene.time.end, scene.output.interval) = (1e-3, 2e-3, None);
    let warnings = run(&scene).unwrap().warnings;
    let locking = warnings.iter().find(|warning| warning.contains("locks")).unwrap();
    let names: Vec<String> = scene.rods[..2].iter().map(|rod| format!("`{}`", rod.name)).collect();
    assert!(
        locking.contains(&format!("with nu = 0.3 each of the slender rods {} bends by only 81.6 %", names.join(", "))),
        "{locking}"
    );
    assert!(locking.contains("with nu = 0.25 the slender rod `third` bends by only 88.9 %"), "{locking}");
    assert!(!locking.contains("fourth"), "{locking}");
}

/// The length of a slide's direction says nothing, however large or small.
#[test]
fn a_slide_may_have_any_length() {
    let tip = |slide: [f64; 2], constraints: Constraints| {
        let mut scene = knee();
        scene.supports = vec![Support { point: "o".into(), fix: Vec::new(), slide: Some(slide), clamp: None }];
        (scene.constraints, scene.time.method) = (constraints, Method::GeneralizedAlpha);
        (scene.time.step, scene.time.end, scene.output.interval) = (1e-2, 0.1, None);
        *run(&scene).unwrap().trajectory.column("tip.y").unwrap().last().unwrap()
    };
    for constraints in [Constraints::Condensed, Constraints::Multipliers] {
        let plain = tip([0.6, 0.8], constraints);
        for slide in [[0.75 * f64::MAX, f64::MAX], [6e200, 8e200], [6e-200, 8e-200], [3e-320, 4e-320]] {
            let off = (tip(slide, constraints) - plain).abs();
            // The smallest numbers have few digits.
            let bound = if slide[0] < 1e-300 { 1e-3 } else { 1e-12 };
            assert!(off < bound, "{slide:?}, {constraints}: {off:e} m");
        }
    }
}

/// A step far too long for sudden heat throws the section apart in its first step (generalized-α overshoots by (ωΔt)²). It
/// creates energy, and that ends the run: a rod held at both ends, suddenly 20 K warmer.
#[test]
fn energy_that_nothing_put_in_ends_the_run() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    scene.material.youngs_modulus = 7e10;
    scene.gravity = [0.0, 0.0];
    scene.temperature.as_mut().unwrap().history = vec![[0.0, 20.0]];
    let mut other = scene.supports[0].clone();
    other.point = "a".into();
    scene.supports.push(other);
    (scene.time.method, scene.time.step, scene.time.end) = (Method::GeneralizedAlpha, 1e-3, 0.1);
    scene.output.interval = None;
    match run(&scene) {
        Err(Error::EnergyAppeared { time, step, created, supply, .. }) => {
            assert!(time < 0.01 && step < 10 && created > supply && supply > 0.0, "{time} {step} {created} {supply}");
        }
        other => panic!("{:?}", other.map(|run| run.counts)),
    }
    scene.temperature.as_mut().unwrap().history = vec![[0.0, 0.0], [1e-3, 20.0]];
    run(&scene).unwrap();
}
