//! `ancf conform --trajectory`: motions of right programs are not called wrong, and mistakes are named.
//!
//! The kit moves its mistakes with rods and steps of its own. Here they are made elsewhere: by the library's structures with its
//! implicit methods and Verlet's, and by classical Runge–Kutta steps of elements assembled from the equations of the paper.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::fs;

use ancf::equations::element::Element;
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::shape::Vector14;
use ancf::equations::{force, inertia, strain};
use ancf::model::{Direction, Method, Probe, Quantity, Scene, Start, ThermalModel};
use ancf::run::run;
use ancf_conform::Error;
use ancf_conform::trajectory::{Outcome, Request, Verdict, compare, reference};
use nalgebra::{DMatrix, DVector, Vector2, Vector3};

/// The scene of a motion, with the method and step of a program.
fn scene(id: &str, method: Method, step: f64) -> Scene {
    let reference = reference(id).unwrap();
    let mut scene = reference.scene;
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, 0.5);
    scene.constraints = ancf::model::Constraints::Condensed;
    scene.output.interval = Some(0.025);
    scene.output.energy = true;
    let of = [Quantity::Position, Quantity::Velocity];
    scene.probes = reference.frames.position.keys().map(|point| Probe::point(point, point, &of)).collect();
    scene
}

/// Writes the motion of a scene as the program's own CSV, and compares it.
fn compared(id: &str, scenes: &[Scene]) -> Outcome {
    let folder = tempfile::tempdir().unwrap();
    let mut request = Request { scene: id.into(), ..Request::default() };
    for (n, scene) in scenes.iter().enumerate() {
        let path = folder.path().join(format!("{n}.csv"));
        let mut csv = Vec::new();
        run(scene).unwrap().trajectory.write_csv(&mut csv).unwrap();
        fs::write(&path, csv).unwrap();
        request.files.push(path);
        request.steps.push(scene.time.step);
    }
    compare(&request).unwrap()
}

#[track_caller]
fn assert_named(outcome: &Outcome, words: &str) {
    let named: Vec<&str> = outcome.mistakes.iter().map(|mistake| mistake.what.as_str()).collect();
    assert!(
        outcome.verdict == Verdict::Mistake && named.iter().any(|what| what.contains(words)),
        "{}",
        outcome.markdown()
    );
    assert!(outcome.markdown().lines().count() <= 25, "{}", outcome.markdown());
}

#[test]
fn right_programs_are_not_called_wrong() {
    demand_that_they_pass(&[
        ("flexible-2", Method::EnergyMomentum, &[1e-3]),
        ("2d-sudden-2", Method::EnergyMomentum, &[1e-3]),
        ("knee-2-1", Method::EnergyMomentum, &[1e-3]),
    ]);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "a minute; in release mode")]
fn right_programs_by_several_methods_are_not_called_wrong() {
    demand_that_they_pass(&[
        ("flexible-2", Method::GeneralizedAlpha, &[1e-3, 5e-4][..]),
        ("flexible-4", Method::Explicit, &[2e-5]),
        ("2d-sudden-2", Method::EnergyMomentum, &[5e-4]),
        ("2d-sudden-2", Method::Explicit, &[4e-5, 2e-5]),
        ("2d-relaxed-4", Method::GeneralizedAlpha, &[2e-4, 1e-4]),
        ("flexible-eb-2", Method::Gauss, &[5e-4]),
        ("knee-2-1", Method::GeneralizedAlpha, &[5e-4, 2.5e-4]),
        ("scissor-1-2", Method::EnergyMomentum, &[2e-4]),
    ]);
}

fn demand_that_they_pass(runs: &[(&str, Method, &[f64])]) {
    for (id, method, steps) in runs.iter().copied() {
        let scenes: Vec<Scene> = steps.iter().map(|step| scene(id, method, *step)).collect();
        let outcome = compared(id, &scenes);
        assert!(outcome.passes(), "{id}, {method}, {steps:?}: {}", outcome.markdown());
    }
}

#[test]
#[cfg_attr(debug_assertions, ignore = "a minute; in release mode")]
fn mistakes_of_a_scene_are_named() {
    type Change = fn(&mut Scene);
    let cases: [(&str, Method, f64, Change, &str); 14] = [
        (
            "flexible-2",
            Method::GeneralizedAlpha,
            2e-4,
            |s| s.supports[0].clamp = Some("rod".into()),
            "hinge is clamped",
        ),
        ("flexible-2", Method::EnergyMomentum, 2e-4, |s| s.supports[0].fix = vec![Direction::Y], "held along y only"),
        ("flexible-2", Method::Explicit, 4e-5, |s| s.gravity[1] = -9.81, "9.81"),
        ("flexible-2", Method::Explicit, 4e-5, |s| s.gravity[1] = 9.8, "upwards"),
        ("flexible-2", Method::Explicit, 4e-5, |s| s.material.youngs_modulus = 2.1e8, "E times 1.05"),
        ("flexible-2", Method::Explicit, 2e-5, |s| s.rods[0].elements = 4, "4 elements"),
        ("2d-sudden-2", Method::Explicit, 4e-5, |s| heat(s).model = ThermalModel::OneD, "1D heat in place of 2D"),
        ("2d-sudden-2", Method::EnergyMomentum, 1e-4, |s| heat(s).model = ThermalModel::OneD, "1D heat in place of 2D"),
        ("2d-sudden-2", Method::Explicit, 4e-5, |s| heat(s).start = Start::Relaxed, "relaxed start"),
        ("2d-sudden-2", Method::Explicit, 4e-5, |s| heat(s).history = vec![[0.0, 400.0]], "doubled"),
        ("2d-sudden-2", Method::Explicit, 4e-5, |s| s.material.nu = 0.3, "ν is 0.3"),
        (
            "2d-sudden-2",
            Method::GeneralizedAlpha,
            1e-4,
            |s| heat(s).history = vec![[0.0, 0.0], [0.13, 200.0]],
            "grows over 0.1",
        ),
        ("knee-2-1", Method::GeneralizedAlpha, 1e-4, |s| s.supports[0].clamp = None, "hinged in place of clamped"),
        ("scissor-1-2", Method::Explicit, 2e-5, |s| s.forces[0].history = None, "does not follow its history"),
    ];
    for (id, method, step, change, words) in cases {
        let mut scene = scene(id, method, step);
        change(&mut scene);
        assert_named(&compared(id, &[scene]), words);
    }
}

fn heat(scene: &mut Scene) -> &mut ancf::model::Temperature {
    scene.temperature.as_mut().unwrap()
}

/// The strain energy at t = 0 is that of the heat: what a long step hides in the positions, it shows.
#[test]
fn heat_is_named_by_the_strain_energy_at_the_start() {
    let mut scene = scene("2d-sudden-2", Method::EnergyMomentum, 1e-3);
    heat(&mut scene).model = ThermalModel::OneD;
    let outcome = compared("2d-sudden-2", &[scene]);
    assert_named(&outcome, "at t = 0: 1D heat in place of 2D");
    let energy = outcome.start.iter().find(|start| start.what == "strain energy").unwrap();
    assert!(!energy.right && energy.detail.contains("0.5000 of it"), "{}", energy.detail);
}

/// The hinged rod of two elements by Runge–Kutta steps; `once` replaces the blocks of M at the shared node instead of adding.
fn runge_kutta(once: bool, damping: f64, step: f64) -> String {
    let (elements, l, g) = (2, 0.5, Vector2::new(0.0, -9.8));
    let element = Element::straight(l, 0.02, 0.02, 0.0);
    let lame = LameConstants::from(YoungPoisson { E: 2e8, nu: 0.0 });
    let size = 10 * elements + 4;
    let mut M = DMatrix::zeros(size, size);
    let mut weight = DVector::zeros(size);
    let mut q = DVector::zeros(size);
    let (m, w) = (inertia::M(7750.0, &element), inertia::Q_w_gravity(&g, 7750.0, &element));
    for k in 0..elements {
        for i in 0..14 {
            for j in 0..14 {
                let entry = &mut M[(10 * k + i, 10 * k + j)];
                *entry = if once && i < 4 && j < 4 { m[(i, j)] } else { *entry + m[(i, j)] };
            }
            weight[10 * k + i] += w[i];
            q[10 * k + i] = element.e_0[i] + if matches!(i, 0 | 4 | 10) { k as f64 * l } else { 0.0 };
        }
    }
    let inverse = M.view((2, 2), (size - 2, size - 2)).into_owned().try_inverse().unwrap();
    let eps_T: Vector3<f64> = strain::eps_T(0.0, 0.0);
    let acceleration = |q: &DVector<f64>, v: &DVector<f64>| {
        let mut f = weight.clone();
        for k in 0..elements {
            let own = Vector14::from_iterator(q.rows(10 * k, 14).iter().copied());
            let Q_e = force::Q_e(
                &own,
                &force::K(
                    lame,
                    &force::K_1(&own, &eps_T, &element),
                    &force::K_2(&own, &eps_T, &element),
                    &force::K_3(&own, &eps_T, &element),
                ),
            );
            f.rows_mut(10 * k, 14).axpy(-1.0, &DVector::from_column_slice(Q_e.as_slice()), 1.0);
        }
        let mut a = DVector::zeros(size);
        a.rows_mut(2, size - 2).copy_from(&(&inverse * f.rows(2, size - 2)));
        a - damping * v
    };
    let mut v = DVector::zeros(size);
    let mut csv = format!("# step = {step}\nt; tip x [m]; tip y [m]\n0; 1; 0\n");
    let per_row = (0.025 / step).round() as usize;
    for n in 1..=20 * per_row {
        let (a_1, v_1) = (acceleration(&q, &v), v.clone());
        let v_2 = &v + 0.5 * step * &a_1;
        let a_2 = acceleration(&(&q + 0.5 * step * &v_1), &v_2);
        let v_3 = &v + 0.5 * step * &a_2;
        let a_3 = acceleration(&(&q + 0.5 * step * &v_2), &v_3);
        let v_4 = &v + step * &a_3;
        let a_4 = acceleration(&(&q + step * &v_3), &v_4);
        q += step / 6.0 * (v_1 + 2.0 * v_2 + 2.0 * v_3 + v_4);
        v += step / 6.0 * (a_1 + 2.0 * a_2 + 2.0 * a_3 + a_4);
        if n % per_row == 0 {
            csv += &format!("{:.4}; {:.12}; {:.12}\n", n as f64 * step, q[size - 4], q[size - 3]);
        }
    }
    csv
}

fn compared_text(text: &str, id: &str) -> Result<Outcome, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motion.txt");
    fs::write(&path, text).unwrap();
    compare(&Request { files: vec![path], scene: id.into(), ..Request::default() })
}

#[test]
#[cfg_attr(debug_assertions, ignore = "some seconds; in release mode")]
fn runge_kutta_steps_agree_and_their_mistakes_are_named() {
    let right = compared_text(&runge_kutta(false, 0.0, 5e-5), "flexible-2").unwrap();
    assert_eq!(right.verdict, Verdict::Agrees, "{}", right.markdown());
    assert_named(&compared_text(&runge_kutta(true, 0.0, 5e-5), "flexible-2").unwrap(), "mass assembled once");
    assert_named(&compared_text(&runge_kutta(false, 0.8, 5e-5), "flexible-2").unwrap(), "damping");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "some seconds; in release mode")]
fn a_first_order_method_is_told_from_a_long_step() {
    let mut damped = [1e-3, 5e-4].map(|step| scene("flexible-2", Method::GeneralizedAlpha, step));
    let outcome = compared("flexible-2", &damped);
    assert_eq!(outcome.verdict, Verdict::ShortenTheStep, "{}", outcome.markdown());
    let order = outcome.order.unwrap();
    assert!((1.7..2.3).contains(&order.order), "{order:?}");
    damped.iter_mut().for_each(|scene| scene.gravity[1] = -9.0);
    assert_named(&compared("flexible-2", &damped), "weight times 0.918");
}

/// The fixture's own motion, with each y times a factor, and no numbers after a time.
fn stored(factor: f64, end: f64) -> String {
    let reference = reference("flexible-2").unwrap();
    let row = |(t, [x, y]): (&f64, &[f64; 2])| match *t > end {
        true => format!("{t},nan,nan\n"),
        false => format!("{t},{x},{}\n", factor * y),
    };
    let rows: String = reference.frames.t.iter().zip(&reference.frames.position["tip"]).map(row).collect();
    format!("t,tip_x,tip_y\n{rows}")
}

#[test]
fn a_motion_that_explodes_is_not_called_right() {
    let outcome = compared_text(&stored(1.0, 0.3), "flexible-2").unwrap();
    assert_eq!((outcome.verdict, outcome.mistakes.len()), (Verdict::Undecided, 0), "{}", outcome.markdown());
    assert!(outcome.summary.contains("explodes at t = 0.35 s"), "{}", outcome.summary);
    assert!(compared_text(&stored(1.0, 1.0), "flexible-2").unwrap().passes());
}

#[test]
#[cfg_attr(debug_assertions, ignore = "half a million steps; in release mode")]
fn a_step_that_is_too_short_to_be_run_is_judged_all_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motion.csv");
    fs::write(&path, stored(1.001, 1.0)).unwrap();
    let request = Request { files: vec![path], scene: "flexible-2".into(), steps: vec![1e-12] };
    let outcome = compare(&request).unwrap();
    assert_eq!(outcome.verdict, Verdict::Mistake, "{}", outcome.markdown());
}

#[test]
fn malformed_files_are_refused_by_place() {
    for (text, words) in [
        ("", "line 1"),
        ("t,tip_x,tip_y\n0,1,0\n0.05,x,0\n", "line 3, column `tip_x`: `x`; allowed: a number"),
        ("t,tip_x,tip_y\n0,1,0\n0.05,1\n", "line 3: 2 columns; allowed: 3"),
        ("t,tip_x\n0,1\n0.05,1\n", "only one component of `tip`"),
        ("a,b\n0,1\n", "no column `t`"),
        ("t,tip_x,tip_y\n0,1,0\n0,1,0\n", "times that grow"),
        ("t,tip_x,tip_y\n0,1,0\n", "at least 2"),
        ("t,foo\n0,1\n0.05,1\n", "not known: foo"),
        ("t,tip_x,tip_y\n1,1,0\n2,1,0\n", "they last from 1 to 2 s"),
        ("t,tip_x,tip_x\n0,1,0\n0.05,1,0\n", "second column"),
        ("{\"t\": [0, 0.05], \"tip\": [[1, 0]]}", "1 entries; allowed: 2"),
        ("{\"t\": 5}", "key `t`"),
        ("{\"t\": [0,", "line 1, column"),
    ] {
        let message = compared_text(text, "flexible-2").unwrap_err().to_string();
        assert!(message.contains(words), "{text:?}: {message}");
    }
    let unknown = compared_text("", "flexibel-2").unwrap_err().to_string();
    assert!(
        unknown.contains("nearest: `flexible-2`") && unknown.contains("knee-2-1") && unknown.lines().count() == 1,
        "{unknown}"
    );
}

/// The same right motion in other layouts: JSON, blanks, decimal commas, other times.
#[test]
fn layouts_of_a_file_are_read_alike() {
    let reference = reference("flexible-2").unwrap();
    let (t, tip, velocity) =
        (&reference.frames.t, &reference.frames.position["tip"], &reference.frames.velocity["tip"]);
    let rows = |separator: &str, comma: bool| {
        let number = |x: f64| if comma { x.to_string().replace('.', ",") } else { x.to_string() };
        let row = |(t, (p, v)): (&f64, (&[f64; 2], &[f64; 2]))| {
            [*t, p[0], p[1], v[0], v[1]].map(number).join(separator) + "\n"
        };
        t.iter().zip(tip.iter().zip(velocity)).map(row).collect::<String>()
    };
    let json = serde_json::json!({"t": t, "tip": tip, "tip_velocity": velocity, "energy": reference.frames.energy, "q": reference.nodal});
    for text in [
        format!("time tip.x tip.y tip.vx tip.vy\n{}", rows(" ", false)),
        format!("\u{feff}t;tipx;tipy;tip_vx;tip_vy\n{}", rows(";", true)),
        format!("% t\tx\ty\tvx\tvy\n{}", rows("\t", false)),
        format!("\"t [s]\",\"x\",\"y\",\"xdot\",\"ydot\"\n{}", rows(",", false)),
        rows(",", false),
        json.to_string(),
    ] {
        let outcome = compared_text(&text, "flexible-2").unwrap();
        assert_eq!((outcome.verdict, outcome.files[0].compared), (Verdict::Agrees, 11), "{text}");
    }
}

#[test]
fn a_wrong_mass_matrix_is_named_at_the_start() {
    let reference = reference("flexible-2").unwrap();
    let (t, tip) = (&reference.frames.t, &reference.frames.position["tip"]);
    let element = Element::straight(0.5, 0.02, 0.02, 0.0);
    let m = inertia::M(7750.0, &element);
    let mut M = vec![vec![0.0; 24]; 24];
    for k in 0..2 {
        for i in 0..14 {
            for j in 0..14 {
                M[10 * k + i][10 * k + j] =
                    if i < 4 && j < 4 { m[(i, j)] } else { M[10 * k + i][10 * k + j] + m[(i, j)] };
            }
        }
    }
    let json = serde_json::json!({"t": t, "tip": tip, "M": M});
    assert_named(&compared_text(&json.to_string(), "flexible-2").unwrap(), "mass assembled once");
}
