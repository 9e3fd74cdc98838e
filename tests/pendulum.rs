//! The pendulum of Table 1: against the dynamic oracle, observed orders, energy, mesh.
//!
//! Source: Peng et al. (2018), Section 3 and Table 1. Goal: every method, model and start gives the motion that follows
//! from the strain energy alone (`oracle/pendulum.py`).
//!
//! ```text
//!   o────────────── rod, L = 1 m ──────────────a     gravity 9.8 m/s² downwards, at rest at t = 0
//!   pinned                                     tip
//! ```

mod common;

use ancf::run::{Run, run};
use ancf::scene::{Method, Scene};
use common::pendulum::{OracleRun, Pendulum};

fn scene(name: &str, elements: usize, method: Method, step: f64, end: f64) -> Scene {
    let mut scene = Scene::builtin(name).unwrap();
    scene.rods[0].elements = elements;
    scene.time.method = method;
    (scene.time.step, scene.time.end) = (step, end);
    scene.output.interval = Some(0.05);
    scene
}

fn tip(run: &Run) -> Vec<[f64; 2]> {
    let (x, y) = (run.trajectory.column("tip.x").unwrap(), run.trajectory.column("tip.y").unwrap());
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

fn largest_distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let distance = |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - b[0]).hypot(a[1] - b[1]);
    a.iter().zip(b).map(distance).fold(0.0, |worst, d| if d > worst || d.is_nan() { d } else { worst })
}

fn distance_from_oracle(oracle: &OracleRun, method: Method, step: f64) -> f64 {
    let run = run(&scene(oracle.scene(), oracle.elements, method, step, 0.5)).unwrap();
    largest_distance(&tip(&run), &oracle.tip)
}

/// Every run of the oracle, steps refined until the bar of 1e-6 m is met.
#[test]
fn every_model_and_start_meets_the_oracle() {
    let oracle = Pendulum::load();
    assert_eq!(oracle.runs.len(), 11, "flexible with 1, 2 and 4 elements; 1D and 2D, sudden and relaxed, with 2 and 4");
    for run in &oracle.runs {
        assert!(run.error_estimate.position < 1e-7, "{}: the oracle is not sure enough itself", run.id);
        let step = if run.start.as_deref() == Some("sudden") { 1e-6 } else { 1e-5 };
        let distance = distance_from_oracle(run, Method::Explicit, step);
        assert!(distance <= 1e-6, "{}: {distance:.2e} m", run.id);
    }
}

/// The implicit methods reach the same limit: their distance falls by four when the step is halved, down to the bar.
#[test]
fn implicit_methods_meet_the_oracle() {
    let oracle = Pendulum::load();
    for id in ["flexible-2", "2d-relaxed-2"] {
        let run = oracle.run(id);
        for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
            let distance = distance_from_oracle(run, method, 2e-5);
            assert!(distance <= 1e-6, "{id}, {method}: {distance:.2e} m");
        }
    }
}
