//! Heat that comes suddenly: waves that a step may not resolve, and a mesh may not either.

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{builtin, columns, positions};
use crate::error::{Error, Result};
use crate::estimate::run_estimated;
use crate::run::{Run, run};
use crate::scene::{Element, Method, Scene};
use crate::study::error_time::case::Case as Timed;
use crate::study::error_time::reference::Reference;
use crate::study::error_time::samples::largest;
use crate::study::oracle;

pub const CASE: Case = Case {
    name: "heat-shock",
    parameter: "step, s (adaptive: tolerance, m)",
    unit: "m",
    reference: "fixtures/converged/: the suddenly heated pendulum on 128 elements, two explicit methods agreed, ± 9e-5 m, which the plane solid \
                confirms to 0.5 s; tip at 0.25 and 0.5 s",
    right: "with `--estimate`: a result only if the estimated error is at least the true one (with the reference's uncertainty); an error \
            where the estimate is over a tenth of the motion, a finer run fails, or the run itself does. Exudyn returns success with \
            the tip metres away at 1e-2 s and halved steps.",
    trials: shocks,
};

pub const HINGE: Case = Case {
    name: "explicit-with-a-hinge",
    parameter: "elements",
    unit: "m",
    reference: "fixtures/pendulum.json: the same mesh by SciPy's DOP853 on the strain energy alone, to 1e-12 m, 0 … 0.5 s",
    right: "tip at most 4/3 of what half the step changes, doubled, and the oracle's error off: second order, fourth for `nystrom`. Exudyn's \
            explicit solvers are 0.13 m off with 4 elements, without a word.",
    trials: hinges,
};

const END: f64 = 0.5;

fn shocks() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    let mut add = |method: Method, elements: usize, values: &[f64]| {
        for &value in values {
            let name = format!("{method}, {elements} elements");
            let trial = Trial::new(name, value, move || shock(method, elements, value));
            let exudyn = method == Method::GeneralizedAlpha && elements == 4 && value == 1e-2;
            let fast = exudyn || (method == Method::EnergyMomentum && elements == 4 && value >= 1e-3);
            trials.push(trial.fast(fast).expect(Expected::ResultOrRefusal));
        }
    };
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Gauss] {
        for elements in [4, 16] {
            add(method, elements, &[1e-2, 5e-3, 2.5e-3, 1e-3, 5e-4, 1e-4]);
        }
        add(method, 4, &[1e-5]);
        add(method, 64, &[1e-2, 1e-3, 2e-4]);
    }
    for method in [Method::Explicit, Method::Nystrom] {
        for elements in [4, 16, 64] {
            add(method, elements, &[1e-3, 1e-4, 1e-5]);
        }
    }
    for method in [Method::GaussAdaptive, Method::NystromAdaptive] {
        for elements in [4, 16] {
            add(method, elements, &[1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
        }
    }
    Ok(trials)
}

fn shock(method: Method, elements: usize, value: f64) -> Result<Finding> {
    let mut scene = builtin("pendulum-2d")?;
    scene.rods[0].elements = elements;
    (scene.time.method, scene.time.end) = (method, END);
    if method.is_adaptive() {
        (scene.time.tolerance, scene.time.step) = (value, 0.01);
    } else {
        scene.time.step = value;
    }
    scene.output.interval = Some(0.01);
    let own = run_estimated(&scene, |_| ())?;
    let case = Timed::named(&["pendulum-2d".into()])?[0];
    let reference = Reference::embedded(case, Element::Ancf)?;
    let finest = reference.meshes.last().map(|mesh| mesh.samples.position.clone()).unwrap_or_default();
    let samples = [0.25, 0.5].map(|t| at(&own, t));
    let estimate = own.accuracy.total().unwrap_or(f64::NAN);
    let uncertainty = reference.converged.uncertainty;
    Ok(Finding {
        error: largest(&samples, &finest[..2.min(finest.len())]),
        bound: estimate + uncertainty,
        why: format!("estimate {estimate:.1e}, the reference's uncertainty {uncertainty:.1e}"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

/// The tip at a time.
fn at(run: &Run, t: f64) -> [f64; 2] {
    let times = run.trajectory.column("t").unwrap_or_default();
    let row = times.iter().position(|row| (row - t).abs() < 1e-9);
    row.and_then(|row| columns(run, "tip", ["x", "y"]).get(row).copied()).unwrap_or([f64::NAN; 2])
}

fn hinges() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for method in [Method::Explicit, Method::Nystrom] {
            for elements in [1, 2, 4] {
                let trial = Trial::new(format!("{method}, {element}"), elements as f64, move || {
                    hinge(method, element, elements)
                });
                trials.push(trial.fast(true));
            }
        }
    }
    Ok(trials)
}

fn hinge(method: Method, element: Element, elements: usize) -> Result<Finding> {
    let oracle = oracle::load()?;
    let known = oracle
        .runs
        .iter()
        .find(|run| run.scene() == Some("pendulum-flexible") && run.element == element && run.elements == elements);
    let missing =
        || Error::Fixture { name: "pendulum.json", reason: format!("no run of {elements} elements {element}") };
    let known = known.ok_or_else(missing)?;
    let scene = |step: f64| -> Result<Scene> {
        let mut scene = builtin("pendulum-flexible")?;
        (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
        (scene.time.method, scene.time.step, scene.time.end) = (method, step, END);
        scene.output.interval = Some(0.05);
        Ok(scene)
    };
    let (own, finer) = (run(&scene(2e-5)?)?, run(&scene(1e-5)?)?);
    let samples: Vec<[f64; 2]> = known.t.iter().map(|t| at(&own, *t)).collect();
    let time = 2.0 * 4.0 / 3.0 * largest(&positions(&own, "tip"), &positions(&finer, "tip"));
    let uncertainty = known.error_estimate.position + 1e-12;
    Ok(Finding {
        error: largest(&samples, &known.tip),
        bound: time + uncertainty,
        why: format!("time {time:.1e}, the oracle's own {uncertainty:.1e}"),
        size: Some(1.0),
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
