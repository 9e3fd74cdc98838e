//! Long runs: the drift of the energy by rounding.

use super::prelude::*;

pub const CASE: Case = Case {
    name: "long-run",
    parameter: "steps",
    unit: "of the largest kinetic energy",
    reference: "the initial energy, which the energy–momentum rule conserves",
    right: "balance at most 2 n ε_mach: each of n steps rounds position and velocity once, and the energy is quadratic in both. The bound grows \
            as n: it would reach a hundredth after 2e13 steps, a year of computing, so that this sweep ends before the method breaks. A \
            conserved energy says nothing of the position: see the case step-size.",
    trials,
};

fn trials() -> Vec<Trial> {
    let trial = |(element, steps)| {
        Trial::new(format!("energy-momentum, {element}"), steps, move || measure(element, steps)).fast(steps <= 1e4)
    };
    iproduct!(ELEMENTS, [1e3, 1e4, 1e5, 1e6]).map(trial).collect()
}

fn measure(element: Element, steps: f64) -> Result<Finding> {
    let scene = pendulum(element, 1)?.solved(Method::EnergyMomentum, 1e-3, 1e-3 * steps).newton(1e-14).rows_every(0.1);
    let own = run(&scene)?;
    let bound = 2.0 * steps * f64::EPSILON;
    let error = largest(&own, "energy.balance") / largest(&own, "energy.kinetic");
    let why = "two roundings a step".into();
    Ok(Finding { error, bound, why, rounding: bound, ..Finding::of(own) })
}
