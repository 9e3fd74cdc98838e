//! Explicit methods with a hinge, whose place and force they have to hold without an iteration.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, builtin, positions};
use super::richardson;
use crate::error::{Error, Result};
use crate::error_time::case::Case as Timed;
use crate::error_time::reference::Reference;
use crate::error_time::samples::largest;
use crate::paper::reference_pendulum;
use ancf::model::{Element, Method, Scene};
use ancf::run::Run;

pub const CASE: Case = Case {
    name: "explicit-with-a-hinge",
    parameter: "elements",
    unit: "m",
    reference: "the same mesh: 1, 2, 4 elements fixtures/pendulum.json, by SciPy's DOP853 on the strain energy alone, to 1e-12 m, every 0.05 s to \
                0.5 s; more: fixtures/converged/, two methods agreed, at 0.25 and 0.5 s",
    right: "step 2e-5 s: tip off by at most the series of three runs with halved steps, order two (`nystrom` four), the reference's error, and \
            rounding: 1e5 independent ones of u and v, three standard deviations, 3 √n ε_mach/√12 (|u| + |v|T). Refused where the step is over the limit of stability. Exudyn's explicit solvers are \
            0.13 m off with 4 elements, without a word.",
    trials,
};

const END: f64 = 0.5;
const INTERVAL: f64 = 0.05;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for method in [Method::Explicit, Method::Nystrom] {
            for elements in [1, 2, 4, 8, 16, 32, 64] {
                let trial = Trial::new(format!("{method}, {element}"), elements as f64, move || {
                    measure(method, element, elements)
                });
                let expected = if elements <= 4 { Expected::Result } else { Expected::ResultOrRefusal };
                trials.push(trial.fast(elements <= 2).expect(expected));
            }
        }
    }
    Ok(trials)
}

/// Known places of the tip with their times, and how well they are known.
struct Known {
    times: Vec<f64>,
    tip: Path,
    error: f64,
}

impl Known {
    fn of(element: Element, elements: usize) -> Result<Known> {
        let oracle = reference_pendulum::load()?;
        let is = |run: &&reference_pendulum::Run| {
            run.scene() == Some("pendulum-flexible") && run.element == element && run.elements == elements
        };
        if let Some(run) = oracle.runs.iter().find(is) {
            return Ok(Known { times: run.t.clone(), tip: run.tip.clone(), error: run.error_estimate.position });
        }
        let case = Timed::named(&["pendulum-flexible".into()])?[0];
        let stored = Reference::embedded(case, element)?;
        let missing =
            || Error::Fixture { name: case.scene, reason: format!("no mesh of {elements} elements {element}") };
        let mesh = stored.mesh(elements).ok_or_else(missing)?;
        let times: Vec<f64> = case.times().into_iter().filter(|t| *t <= END).collect();
        let tip = mesh.samples.position.get(..times.len()).unwrap_or_default().to_vec();
        Ok(Known { times, tip, error: mesh.time_uncertainty })
    }
}

fn measure(method: Method, element: Element, elements: usize) -> Result<Finding> {
    let mut scene: Scene = builtin("pendulum-flexible")?;
    (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
    (scene.time.method, scene.time.step, scene.time.end) = (method, 2e-5, END);
    scene.output.interval = Some(INTERVAL);
    let order = if method == Method::Nystrom { 4 } else { 2 };
    let (own, step) = richardson::in_steps(&scene, order, |run: &Run| positions(run, "tip"))?;
    let known = Known::of(element, elements)?;
    let tip = positions(&own, "tip");
    let row = |t: &f64| tip.get((t / INTERVAL).round() as usize).copied().unwrap_or([f64::NAN; 2]);
    // The quarter of the step; half a swing takes the tip by √2 at most, at √(3g/L) at most.
    let steps = 4.0 * own.counts.steps as f64;
    let rounding = 3.0 * (steps / 12.0).sqrt() * EPS * (2f64.sqrt() + (3.0 * 9.8f64).sqrt() * END);
    let step = step.above(rounding);
    let samples: Path = known.times.iter().map(row).collect();
    Ok(Finding {
        error: largest(&samples, &known.tip),
        bound: step.bound() + known.error + rounding,
        why: format!("step {step}, the reference's own {:.1e}, rounding {rounding:.1e}", known.error),
        size: 1.0,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
