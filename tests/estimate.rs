//! Estimated errors in time and space, and an error where no digit is sure.

use ancf::error::Error;
use ancf::model::{Force, Method, Motion, Probe, Quantity, Scene, Start, Temperature, ThermalModel};
use ancf::run::run_estimated;
use ancf::run::{Convergence, Run, run};

fn pendulum(method: Method, step: f64) -> Scene {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.rods[0].elements = 2;
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, 0.1);
    scene
}

/// Without a probe all points are looked at, and the rows stay as the scene has them.
#[test]
fn a_scene_without_probes_is_estimated_at_its_points() {
    let mut scene = pendulum(Method::Gauss, 1e-3);
    scene.probes.clear();
    let estimated = run_estimated(&scene, |_| ()).unwrap();
    assert_eq!(estimated.trajectory, run(&scene).unwrap().trajectory);
    let with_probe = run_estimated(pendulum(Method::Gauss, 1e-3), |_| ()).unwrap();
    let positions = |run: Run| (run.accuracy.time, run.accuracy.space, run.accuracy.at_rows);
    assert_eq!(positions(estimated), positions(with_probe));
}

/// A probe of a held point, or of a bow, sees less than what moves: the estimate is that of all points.
#[test]
fn what_probes_look_at_does_not_matter() {
    let accuracy = |change: &dyn Fn(&mut Scene)| {
        let mut scene = pendulum(Method::EnergyMomentum, 1e-2);
        scene.output.interval = Some(1e-2);
        change(&mut scene);
        run_estimated(&scene, |_| ()).unwrap().accuracy
    };
    let tip = accuracy(&|_| ());
    assert!(tip.time.as_ref().unwrap().value > 1e-5);
    let held = accuracy(&|scene| scene.probes[0].point = Some("o".into()));
    assert_eq!((&held.time, &held.space), (&tip.time, &tip.space));
    let bow = |scene: &mut Scene| {
        let probe = &mut scene.probes[0];
        (probe.point, probe.rod, probe.at, probe.of) =
            (None, Some("rod".into()), Some(0.5), vec![Quantity::Deflection]);
    };
    // A bow's own error counts beside those of the points.
    assert!(accuracy(&bow).time.unwrap().value >= tip.time.unwrap().value);
}

/// A rod between two held points moves between them, where no point is.
#[test]
fn a_rod_between_held_points_is_looked_at() {
    let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
    let mut end = scene.supports[0].clone();
    end.point = "a".into();
    scene.supports.push(end);
    scene.probes[0].of = vec![Quantity::Position];
    let accuracy = run_estimated(&scene, |_| ()).unwrap().accuracy;
    let (time, space) = (accuracy.time.unwrap().value, accuracy.space.unwrap().value);
    assert!(time > 1e-7 && space > 1e-7, "{time:e}, {space:e}");
}

/// Steps of a tenth of a second cannot follow the pendulum, which is seen although no probe looks at it.
#[test]
fn a_motion_that_no_probe_sees_is_an_error_all_the_same() {
    let mut scene = pendulum(Method::EnergyMomentum, 0.1);
    (scene.time.end, scene.output.interval) = (2.0, None);
    scene.probes[0].point = Some("o".into());
    match run_estimated(&scene, |_| ()) {
        Err(Error::Inaccurate { time, moved, .. }) => assert!(time > 0.1 * moved && moved > 1.0, "{time}, {moved}"),
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    }
}

/// Where nothing moves, errors are estimated all the same, and are those of rounding.
#[test]
fn a_structure_at_rest_is_estimated() {
    let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
    scene.gravity = [0.0; 2];
    let total = run_estimated(&scene, |_| ()).unwrap().accuracy.total().unwrap();
    assert_eq!(total, 0.0);
    let history = vec![[0.0, 200.0]];
    scene.temperature = Some(Temperature { model: ThermalModel::TwoD, start: Start::Relaxed, history });
    let total = run_estimated(&scene, |_| ()).unwrap().accuracy.total().unwrap();
    assert!(total < 1e-13, "{total:e}");
}

/// Every column has an error of its own; that of a vector is compared with its largest component.
#[test]
fn every_column_is_estimated() {
    let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
    scene.probes = vec![Probe::point("tip", "a", &[Quantity::Velocity, Quantity::Acceleration])];
    scene.probes.push(Probe::point("o", "o", &[Quantity::Reaction]));
    let run = run_estimated(&scene, |_| ()).unwrap();
    let names: Vec<&str> = run.accuracy.columns.iter().map(|column| column.column.as_str()).collect();
    assert_eq!(names, &scene.columns()[1..]);
    for column in &run.accuracy.columns[..6] {
        let largest = run.trajectory.column(&column.column).unwrap().iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        assert!(column.total() > 0.0 && column.largest >= largest, "{column:?}");
    }
    assert_eq!(run.accuracy.column("tip.vx").unwrap().largest, run.accuracy.column("tip.vy").unwrap().largest);
}

/// Twice the load steps are twice the rows: every second one is compared.
#[test]
fn columns_of_statics_are_estimated_at_their_own_rows() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    scene.time.load_steps = 5;
    let run = run_estimated(&scene, |_| ()).unwrap();
    assert_eq!(run.accuracy.columns.len(), scene.columns().len() - 1);
    for column in &run.accuracy.columns {
        assert!(column.total().is_finite() && column.total() <= 0.1 * column.largest, "{column:?}");
    }
}

/// Under a sudden load every halving of the step shows other accelerations; their means converge.
#[test]
fn what_does_not_converge_is_said_and_its_mean_does() {
    let mut scene = pendulum(Method::EnergyMomentum, 2e-3);
    scene.material.youngs_modulus *= 100.0;
    scene.rods[0].elements = 4;
    (scene.time.end, scene.output.interval) = (0.3, Some(0.02));
    let acceleration = Probe::point("tip", "a", &[Quantity::Acceleration]);
    scene.probes = vec![acceleration.clone(), Probe { name: "mean".into(), ..acceleration }.mean(0.1)];
    let accuracy = run_estimated(&scene, |_| ()).unwrap().accuracy;
    let convergence = |name| accuracy.column(name).unwrap().convergence;
    assert_eq!((convergence("tip.ay"), convergence("mean.ay")), (Convergence::None, Convergence::Sure), "{accuracy:?}");
    let warnings = run(&scene).unwrap().warnings;
    assert!(
        warnings.iter().any(|warning| warning.contains("ring from row to row (`tip.ax`, `tip.ay`)")),
        "{warnings:?}"
    );
}

/// Time's part falls with the order of the method, by every method that has a step, and with the tolerance.
#[test]
fn estimates_fall_with_the_step() {
    for (method, step, order) in
        [(Method::EnergyMomentum, 1e-3, 2), (Method::GeneralizedAlpha, 1e-3, 2), (Method::Explicit, 4e-5, 2)]
    {
        let time = |step| run_estimated(pendulum(method, step), |_| ()).unwrap().accuracy.time.unwrap().value;
        let (coarse, fine) = (time(step), time(0.5 * step));
        let seen = (coarse / fine).log2();
        println!("{method}: {coarse:.1e}, {fine:.1e} m, order {seen:.2}");
        assert!((seen - f64::from(order)).abs() < 0.3, "{method}: {seen}");
    }
    let time = |tolerance| {
        let mut scene = pendulum(Method::GaussAdaptive, 0.01);
        scene.time.tolerance = tolerance;
        run_estimated(&scene, |_| ()).unwrap().accuracy.time.unwrap()
    };
    let (coarse, fine) = (time(1e-5), time(1e-7));
    assert!(
        coarse.value > 5.0 * fine.value && coarse.method.contains("a tenth of the tolerance"),
        "{coarse:?} {fine:?}"
    );
}

#[test]
fn statics_is_estimated_by_its_load_steps() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    scene.time.load_steps = 3;
    let accuracy = run_estimated(&scene, |_| ()).unwrap().accuracy;
    let (time, space) = (accuracy.time.unwrap(), accuracy.space.unwrap());
    // The path does not matter; eight elements are 3.9e-3 L off.
    assert!(
        time.value < 1e-9 && time.method.contains("load steps") && (3.9e-3..2e-2).contains(&space.value),
        "{space:?}"
    );
}

/// Two elements cannot bend by 80°.
#[test]
fn a_result_without_a_digit_is_an_error() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    (scene.rods[0].elements, scene.time.load_steps) = (2, 20);
    scene.section.height = 1e-4;
    scene.section.width = 0.1;
    scene.forces[0].force[1] *= 0.1;
    match run_estimated(&scene, |_| ()) {
        Err(Error::Inaccurate { space, moved, .. }) => assert!(space > 0.1 * moved),
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    }
}

/// Corners that steps land on anyway are closer than half the longest step: it is halved until there are more steps.
#[test]
fn steps_between_corners_are_halved() {
    let mut scene = pendulum(Method::GaussAdaptive, 0.1);
    scene.time.tolerance = 1.0;
    scene.output.interval = Some(0.1);
    let history = vec![[0.03, 1.0], [0.06, 1.0], [0.08, 1.0]];
    scene.forces.push(Force { point: "a".into(), force: [0.0, 1.0], history: Some(history) });
    let mut exact = scene.clone();
    (exact.time.tolerance, exact.time.step) = (1e-9, 1e-3);
    let (exact, coarse) = (run(&exact).unwrap(), run_estimated(&scene, |_| ()).unwrap());
    let [a, b] = [&exact, &coarse].map(|run| run.trajectory.rows[1].to_vec());
    let (off, time) = ((a[1] - b[1]).hypot(a[2] - b[2]), coarse.accuracy.time.unwrap().value);
    assert!(off > 1e-7 && time >= off, "{off:e} {time:e}");
}

/// An iteration that ends early leaves an error that no step shortens: Newton's tolerance is made finer, too.
#[test]
fn the_tolerance_of_newton_is_estimated() {
    let with = |tolerance| {
        let mut scene = pendulum(Method::Gauss, 2e-3);
        scene.time.newton_tolerance = tolerance;
        scene
    };
    let exact = run(with(1e-12)).unwrap();
    let coarse = run_estimated(with(5e-3), |_| ()).unwrap();
    let off = |row: (&[f64], &[f64])| (row.0[1] - row.1[1]).hypot(row.0[2] - row.1[2]);
    let off = coarse.trajectory.rows.iter().zip(&exact.trajectory.rows).map(off).fold(0.0, f64::max);
    let time = coarse.accuracy.time.unwrap();
    assert!(off > 1e-6 && time.value >= off && time.method.contains("Newton's tolerance"), "{off:e} {time:?}");
}

/// Pressed far beyond its buckling load a column has many equilibria, and other meshes and load steps find others: no estimate.
#[test]
fn an_unstable_equilibrium_is_not_estimated() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    let bending = scene.material.youngs_modulus * scene.section.width * scene.section.height.powi(3) / 12.0;
    let length = scene.points["a"][0] - scene.points["o"][0];
    let euler = std::f64::consts::PI.powi(2) * bending / (4.0 * length * length);
    scene.forces[0].force = [-0.5 * euler, 1e-3 * euler];
    let stable = run_estimated(&scene, |_| ());
    assert!(stable.is_ok(), "{:?}", stable.map(|run| run.accuracy));
    scene.forces[0].force = [-30.0 * euler, 0.0];
    assert!(run(&scene).unwrap().unstable_directions > 1);
    match run_estimated(&scene, |_| ()) {
        Err(error @ Error::Unstable { directions }) => {
            assert!(directions > 1 && error.to_string().contains("leads to the stable one"), "{error}");
        }
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    }
}

/// A finer run that fails leaves no estimate: steps of 5e-4 s take the shock on 16 elements, and not on 32.
#[test]
fn a_finer_run_that_fails_is_named() {
    let mut scene = pendulum(Method::GeneralizedAlpha, 5e-4);
    scene.temperature = Scene::builtin("pendulum-2d").unwrap().temperature;
    scene.rods[0].elements = 16;
    match run_estimated(&scene, |_| ()) {
        Err(Error::NoEstimate { what, reason }) => {
            assert!(what.contains("twice the elements") && reason.contains("at t = "), "{what}: {reason}");
        }
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    }
}

/// A rod at rest on a hinge, with a force at its tip between the steps of a millisecond.
fn shaken(method: Method, force: f64, history: Vec<[f64; 2]>) -> Scene {
    let mut scene = pendulum(method, 1e-3);
    (scene.gravity, scene.time.end, scene.output.interval) = ([0.0; 2], 0.2, Some(0.01));
    scene.forces.push(Force { point: "a".into(), force: [0.0, force], history: Some(history) });
    scene
}

/// A pulse that no step sees, nor half a step, is seen by as many as it takes; as is a wave that all of them take for a constant.
#[test]
fn what_comes_and_goes_within_a_step_is_seen() {
    let pulse = vec![[0.0, 0.0], [0.10005, 0.0], [0.10025, 1.0], [0.10045, 0.0]];
    let wave: Vec<[f64; 2]> = (0..1000).map(|n| [2.5e-4 * f64::from(n), f64::from(n % 2)]).collect();
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Gauss] {
        for (force, history) in [(1e3, &pulse), (60.0, &wave)] {
            let scene = shaken(method, force, history.clone());
            match run_estimated(&scene, |_| ()) {
                Err(Error::Inaccurate { time, .. }) => assert!(time > 1e-2, "{method}: {time:e}"),
                other => panic!("{method}: {:?}", other.map(|run| run.accuracy)),
            }
        }
    }
    let short = vec![[0.10005, 0.0], [0.10006, 1.0], [0.10007, 0.0]];
    match run_estimated(shaken(Method::EnergyMomentum, 1e4, short), |_| ()) {
        Err(error @ Error::NoEstimate { .. }) => {
            let message = error.to_string();
            assert!(message.contains("1/16 of the step") && message.contains("the force at `a`"), "{message}");
        }
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    }
    // A ramp is not missed.
    let ramp = vec![[0.1000, 0.0], [0.10001, 1.0]];
    let mut ramp = shaken(Method::EnergyMomentum, 1.0, ramp);
    // Two elements leave a tenth of what it does wrong.
    ramp.rods[0].elements = 4;
    let accuracy = run_estimated(&ramp, |_| ()).unwrap().accuracy;
    assert!(accuracy.time.unwrap().method.contains("half the step"));
}

/// A turn that is wrong by a third is not hidden by a journey of kilometres, nor by another part's.
#[test]
fn each_place_is_judged_beside_its_own_motion() {
    let inaccurate = |scene: &Scene| match run_estimated(scene, |_| ()) {
        Err(Error::Inaccurate { place, moved, .. }) => {
            assert!(place.contains("`a`") || place.contains("`o`"), "{place}");
            assert!(moved < 50.0, "{moved}");
        }
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    };
    let mut free = pendulum(Method::EnergyMomentum, 1e-2);
    (free.time.end, free.output.interval, free.gravity) = (2.0, None, [0.0; 2]);
    free.material.youngs_modulus = 2e11;
    free.supports.clear();
    free.motion = Some(Motion { omega: 30.0, about: [0.5, 0.0], ..Motion::default() });
    inaccurate(&free);
    let mut parts = free.clone();
    free.motion = Some(Motion { omega: 30.0, about: [0.5, 0.0], velocity: [1e3, 0.0] });
    inaccurate(&free);
    // The same, told by a point far off.
    free.motion = Some(Motion { omega: 30.0, about: [0.5, 100.0], ..Motion::default() });
    inaccurate(&free);

    parts.points.extend([("p".to_string(), [5.0, 0.0]), ("q".to_string(), [6.0, 0.0])]);
    let mut falling = parts.rods[0].clone();
    (falling.name, falling.from, falling.to) = ("falling".into(), "p".into(), "q".into());
    parts.rods.push(falling);
    parts.forces.push(Force { point: "p".into(), force: [1e3, 0.0], history: None });
    parts.forces.push(Force { point: "q".into(), force: [1e3, 0.0], history: None });
    inaccurate(&parts);
}

/// Where rounding leaves no tenth of Newton's tolerance, a stiff scene that runs is estimated with its own.
#[test]
fn a_stiff_scene_that_runs_is_estimated() {
    let mut scene = pendulum(Method::GeneralizedAlpha, 1e-3);
    (scene.material.youngs_modulus, scene.rods[0].elements, scene.time.end) = (2e14, 8, 0.5);
    run_estimated(&scene, |_| ()).unwrap();
    // It vibrates past its straight shape, where its displacement is the difference of far larger numbers.
    (scene.rods[0].elements, scene.time.end, scene.gravity) = (16, 0.2, [0.0, -9.8]);
    scene.supports[0].clamp = Some("rod".into());
    let estimated = run_estimated(&scene, |_| ());
    assert!(!matches!(estimated, Err(Error::NewtonFailed { .. } | Error::NoEstimate { .. })), "{estimated:?}");
}

/// A cantilever of steel that a sudden force keeps swinging between 0 and −3.8·10⁻⁶ m, 0.8 kHz beside steps of a millisecond. They damp
/// it, and half of them do, long before the first row: both runs agree there, and are wrong. The rows stay as the scene has them.
#[test]
fn a_vibration_that_is_damped_before_the_rows_is_seen() {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    (scene.material.youngs_modulus, scene.material.nu, scene.material.rho) = (2.1e11, 0.0, 7850.0);
    (scene.section.height, scene.section.width, scene.gravity) = (0.01, 0.01, [0.0; 2]);
    scene.points.insert("a".into(), [0.1, 0.0]);
    (scene.rods[0].elements, scene.supports[0].clamp) = (8, Some("rod".into()));
    scene.forces.push(Force { point: "a".into(), force: [0.0, -1.0], history: None });
    (scene.time.method, scene.time.step, scene.time.end) = (Method::GeneralizedAlpha, 1e-3, 4.0);
    (scene.output.interval, scene.output.energy) = (Some(1.0), false);
    let rows = run(&scene).unwrap().trajectory.rows;
    assert!(rows.iter().skip(1).all(|row| (row[2] + 1.91e-6).abs() < 1e-8), "{rows:?}");
    match run_estimated(&scene, |_| ()) {
        Err(Error::Inaccurate { time, moved, .. }) => assert!(time > 1e-6 && moved < 5e-6, "{time:e} {moved:e}"),
        other => panic!("{:?}", other.map(|run| run.accuracy)),
    }
}

/// What is compared between the rows changes neither them nor what is counted and warned of.
#[test]
fn an_estimated_run_is_the_run_itself() {
    for (method, step) in
        [(Method::EnergyMomentum, 1e-3), (Method::Explicit, 4e-5), (Method::GaussAdaptive, 1e-2), (Method::Static, 1.0)]
    {
        let mut scene =
            if method == Method::Static { Scene::builtin("cantilever").unwrap() } else { pendulum(method, step) };
        if method != Method::Static {
            // Accelerations are counted at the rows.
            scene.output.interval = Some(1e-2);
            scene.probes[0].of = vec![Quantity::Position, Quantity::Acceleration];
        }
        let (own, mut estimated) = (run(&scene).unwrap(), run_estimated(&scene, |_| ()).unwrap());
        let when = match method {
            Method::Static => "after each load step",
            method if method.is_adaptive() => "at the rows",
            _ => "after each step",
        };
        let accuracy = std::mem::take(&mut estimated.accuracy);
        assert!(accuracy.at_rows <= accuracy.total(), "{accuracy:?}");
        for estimate in [accuracy.time, accuracy.space] {
            let method = estimate.unwrap().method;
            assert!(method.contains(when), "{method}");
        }
        assert_eq!(estimated, own, "{method}");
    }
}

/// A wave half a step out of phase vanishes at the end of each step, and not of each half.
#[test]
fn a_wave_that_vanishes_at_each_step_is_seen() {
    let corners = (0..200).map(|k| [(f64::from(k) + 0.5) * 1e-3, 1.0 - 2.0 * f64::from(k % 2)]);
    let wave: Vec<[f64; 2]> = [[0.0, 0.0]].into_iter().chain(corners).collect();
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
        match run_estimated(shaken(method, 500.0, wave.clone()), |_| ()) {
            Err(Error::Inaccurate { time, moved, .. }) => assert!(time > moved, "{method}: {time:e} {moved:e}"),
            other => panic!("{method}: {:?}", other.map(|run| run.accuracy)),
        }
    }
}
