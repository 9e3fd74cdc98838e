//! Explicit methods with a hinge, whose position and force they have to hold without an iteration.

use super::prelude::*;
use super::richardson;
use crate::error_time::benchmarks::of;
use crate::error_time::reference::Reference;
use crate::paper::reference_pendulum::Oracle;
use crate::paper::tip::Tip;

pub const CASE: Case = Case {
    name: "explicit-with-a-hinge",
    parameter: "elements",
    unit: "m",
    reference: "the same mesh. 1, 2, 4 elements: fixtures/pendulum.json, by SciPy's DOP853 on the strain energy alone, to 1e-12 m, every 0.05 s to \
                0.5 s; more: fixtures/converged/, two methods agreed, at 0.25 and 0.5 s",
    right: "step 2e-5 s: error of the tip at most the series of three runs with halved steps, order two (`nystrom` four), the reference's error, \
            and rounding: 1e5 independent ones of u and v, three standard deviations, 3 √n ε_mach/√12 (|u| + |v|T). Refused if the step is over the \
            limit of stability. Exudyn's explicit solvers are 0.13 m off with 4 elements, without a warning.",
    trials,
};

const END: f64 = 0.5;

fn trials() -> Vec<Trial> {
    let trial = |(element, method, elements)| {
        let run = move || measure(method, element, elements);
        let trial = Trial::new(format!("{method}, {element}"), elements as f64, run).fast(elements <= 2);
        trial.expect(Expected::result_if(elements <= 4))
    };
    iproduct!(ELEMENTS, [Method::Explicit, Method::Nystrom], [1, 2, 4, 8, 16, 32, 64]).map(trial).collect()
}

/// The reference's tip to [`END`], and its error, m.
fn reference(element: Element, elements: usize) -> Result<(Tip, f64)> {
    let oracle = Oracle::load()?;
    let run = oracle.find("pendulum-flexible", element, elements);
    if let Some(run) = run {
        return Ok((run.tip.clone(), run.error_estimate.position));
    }
    let benchmark = of("pendulum-flexible")?;
    let stored = Reference::embedded(benchmark, element)?;
    let missing = || Error::fixture(benchmark.scene, format!("no mesh of {elements} elements {element}"));
    let mesh = stored.mesh(elements).ok_or_else(missing)?;
    let (t, r) = stored.rows(benchmark, mesh).filter(|(t, _)| *t <= END).unzip();
    Ok((Tip { t, r }, mesh.time_uncertainty))
}

fn measure(method: Method, element: Element, elements: usize) -> Result<Finding> {
    let scene = pendulum(element, elements)?.solved(method, 2e-5, END).rows_every(0.05);
    let (own, step) = richardson::in_steps(&scene, tip)?;
    let (known, its_error) = reference(element, elements)?;
    // Of the run with a quarter of the step; half a swing moves the tip by √2 at most, at √(3g/L) at most.
    let steps = 4.0 * own.counts.steps as f64;
    let rounding = 3.0 * (steps / 12.0).sqrt() * f64::EPSILON * (2f64.sqrt() + (3.0 * 9.8f64).sqrt() * END);
    let step = step.above(rounding);
    let tip = Tip::of(&own);
    let samples: Path = known.t.iter().map(|t| tip.at(*t)).collect();
    let error = largest_distance(&samples, &known.r);
    let why = format!("step {step}, error of the reference {its_error:.1e}, rounding {rounding:.1e}");
    Ok(Finding { error, bound: step.bound() + its_error + rounding, why, rounding, ..Finding::of(own) })
}
