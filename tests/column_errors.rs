//! Estimated errors of all columns against true ones, in time and in space apart.
//!
//! The true error in time is the distance to a run of the same mesh with a sixteenth of the step, that in space the distance of two runs
//! with short steps, of the mesh and of one four times as fine: what these leave is a few hundredths of the error. Columns of which no
//! digit is sure are not judged. Release only: a hundred runs and their estimates.

#![cfg(not(debug_assertions))]

use ancf::model::{Element, Method, Probe, Quantity, Scene};
use ancf::run::{Convergence, Trajectory, run, run_estimated};

/// Built-in scenes with probes of every quantity that they have.
fn scenes() -> Vec<Scene> {
    let every = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration];
    let mut pendulum = Scene::builtin("pendulum-flexible").unwrap().until(0.6);
    pendulum.probes = vec![Probe::point("tip", "a", &every), Probe::point("o", "o", &[Quantity::Reaction])];
    pendulum.probes.push(Probe::deflection("bow", "rod", 0.5));
    let mut heated = pendulum.clone();
    heated.temperature = Scene::builtin("pendulum-2d").unwrap().temperature;
    heated.temperature.as_mut().unwrap().history = vec![[0.0, 0.0], [0.3, 200.0]];
    let mut rigid = pendulum.clone();
    rigid.rods[0].element = Element::EulerBernoulli;
    let mut scissors = Scene::builtin("scissors-3").unwrap().until(0.4);
    scissors.forces.iter_mut().for_each(|force| force.history = Some(vec![[0.0, 0.0], [0.2, 1.0]]));
    vec![pendulum, heated, rigid, scissors]
}

fn with(scene: &Scene, elements: usize, method: Method, step: f64) -> Scene {
    let mut scene = scene.clone().method(method, step);
    scene.rods.iter_mut().for_each(|rod| rod.elements = elements);
    scene.output.interval = Some(0.02);
    scene
}

/// Largest distances of all columns between two runs of the same rows.
fn distances(a: &Trajectory, b: &Trajectory) -> Vec<f64> {
    let of = |column: usize| a.rows.iter().zip(&b.rows).map(|(a, b)| (a[column] - b[column]).abs()).fold(0.0, f64::max);
    (1..a.columns.len()).map(of).collect()
}

#[test]
fn estimates_of_all_columns_hold() {
    let mut ratios: Vec<(f64, String)> = Vec::new();
    for (number, scene) in scenes().iter().enumerate() {
        for elements in [2, 4] {
            let fine = |elements| run(with(scene, elements, Method::Gauss, 1e-4)).unwrap().trajectory;
            let in_space = distances(&fine(elements), &fine(4 * elements));
            for (method, steps) in [
                (Method::EnergyMomentum, [5e-3, 2e-3, 1e-3]),
                (Method::GeneralizedAlpha, [4e-3, 2e-3, 5e-4]),
                (Method::Gauss, [1e-2, 5e-3, 2e-3]),
            ] {
                for step in steps {
                    let case = format!("scene {number}, {elements} elements, {method}, {step} s");
                    let Ok(estimated) = run_estimated(with(scene, elements, method, step), |_| ()) else {
                        println!("{case}: refused");
                        continue;
                    };
                    let exact = run(with(scene, elements, method, step / 16.0)).unwrap().trajectory;
                    let in_time = distances(&estimated.trajectory, &exact);
                    for ((column, time), space) in estimated.accuracy.columns.iter().zip(in_time).zip(&in_space) {
                        // Rounding, and Newton's tolerance, have no order.
                        let noise = 1e-8 * column.largest;
                        for (what, estimate, truth) in [("time", column.time, time), ("space", column.space, *space)] {
                            if column.convergence == Convergence::Sure && truth > noise {
                                ratios.push((estimate / truth, format!("{case}: {} in {what}", column.column)));
                            }
                        }
                    }
                }
            }
        }
    }
    ratios.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let quantile = |share: f64| ratios[((ratios.len() - 1) as f64 * share) as usize].0;
    let below = ratios.iter().filter(|(ratio, _)| *ratio < 1.0).count();
    println!("{} ratios; below 1: {below}; least:", ratios.len());
    ratios.iter().take(below.max(5)).for_each(|(ratio, case)| println!("  {ratio:.2} {case}"));
    println!(
        "median {:.2}, 95 % below {:.2}, largest {:.1}: {}",
        quantile(0.5),
        quantile(0.95),
        quantile(1.0),
        ratios.last().unwrap().1
    );
    assert!(ratios.len() > 500);
    assert!(below as f64 <= 0.01 * ratios.len() as f64 && ratios[0].0 >= 1.0 / 3.0);
    assert!(quantile(0.5) <= 5.0 && quantile(0.95) <= 20.0);
}
