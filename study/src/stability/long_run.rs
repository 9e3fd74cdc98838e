//! Long runs: what rounding makes of the energy.

use super::case::{Case, Finding, Trial};
use super::helpers::{EPS, builtin, largest};
use crate::error::Result;
use ancf::model::{Element, Method};
use ancf::run::run;

pub const CASE: Case = Case {
    name: "long-run",
    parameter: "steps",
    unit: "of the largest kinetic energy",
    reference: "the energy of the start, which the energy–momentum rule keeps",
    right: "balance at most 2 n ε_mach: each of n steps rounds place and velocity once, and the energy is quadratic in both. The bound grows with \
            n only: it would reach a hundredth after 2e13 steps, a year of computing, so that this sweep ends before it breaks. That the \
            energy is kept says nothing of the place: the case of the step's size does.",
    trials,
};

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for steps in [1e3, 1e4, 1e5, 1e6] {
            let trial = Trial::new(format!("energy-momentum, {element}"), steps, move || measure(element, steps));
            trials.push(trial.fast(steps <= 1e4));
        }
    }
    Ok(trials)
}

fn measure(element: Element, steps: f64) -> Result<Finding> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.rods[0].element, scene.rods[0].elements) = (element, 1);
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 1e-3, 1e-3 * steps);
    scene.time.newton_tolerance = 1e-14;
    scene.output.interval = Some(0.1);
    let own = run(&scene)?;
    let bound = 2.0 * steps * EPS;
    Ok(Finding {
        error: largest(&own, "energy.balance") / largest(&own, "energy.kinetic"),
        bound,
        why: "two roundings a step".into(),
        size: 1.0,
        rounding: bound,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
