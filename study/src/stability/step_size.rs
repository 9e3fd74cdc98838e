//! The step, from far too long to so short that rounding is all there is.
//!
//! Where steps resolve what bends, ωΔt ≤ ½ for the third frequency of a supported and free rod, 104 √(EI/(ρAL⁴)) = 97 rad/s, a method of
//! order p has e(h) = Ch^p(1 + O(h)): the next halving is not further from its order than the last was, e(h) ≤ e(2h) 2⁻ᵖ (1 + |e(4h)/(2ᵖ
//! e(2h)) − 1|), with three distances from the oracle and no constant of ours. Longer steps show no order: they are halved until they
//! resolve what bends, |x(h) − x(0)| ≤ Σ |x(h/2ⁿ) − x(h/2ⁿ⁺¹)|, the last two terms continued as a series.
//!
//! The sudden weight also shears the section, g/ω² with ω = √(12G/ρ)/h = 1.96e4 rad/s, twice that suddenly: 5.1e-8 m, and its
//! vibrations go up to √(12E/ρ)/h = 2.78e4 rad/s. They may be missing as long as the longest of the three steps does not resolve them.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, How, IMPLICIT, builtin, positions, words};
use super::richardson::Halving;
use crate::error::{Error, Result};
use crate::error_time::samples::largest;
use crate::paper::reference_pendulum;
use ancf::model::{Element, Method, Scene};
use ancf::run::{Run, run};

pub const CASE: Case = Case {
    name: "step-size",
    parameter: "step, s",
    unit: "m",
    reference: "fixtures/pendulum.json: one element by SciPy's DOP853 on the strain energy alone, ± 2e-14 m, at 0.1 s",
    right: "steps up to 5e-3 s: error at most 2⁻ᵖ of that with twice the step, times 1 + |e(4h)/(2ᵖe(2h)) − 1|, as the next halving is not \
            further from the order p than the last; longer ones: what halving changes, summed up until steps resolve bending, and the \
            series of the last two. Until 4h resolves the section's vibrations their amplitude 2g/ω² = 5.1e-8 m may be missing. And the floor: \
            each step rounds u and v by ε_mach, n ε_mach (|u| + |v|T); Newton may leave 1e-14 of the largest force, ½ 1e-14 F/m T².",
    trials,
};

const END: f64 = 0.1;

/// √(12 G/ρ)/h and √(12 E/ρ)/h, rad/s.
const SHEAR: f64 = 1.96e4;
const THICKNESS: f64 = 2.78e4;

/// The longest step that resolves bending.
const BENDING: f64 = 5e-3;

const TOLERANCE: f64 = 1e-14;

fn trials() -> Result<Vec<Trial>> {
    let halved = (0..=11).map(|n| END / f64::from(1 << n));
    let steps: Vec<f64> = halved.chain([1e-5, 1e-6, 1e-7]).collect();
    let mut trials = Vec::new();
    for how in IMPLICIT {
        for &step in &steps {
            let trial = Trial::new(words(how, Element::Ancf), step, move || measure(how, step));
            let far = how.0 == Method::Gauss && step > 1e-2;
            let expected = if far { Expected::ResultOrRefusal } else { Expected::Result };
            trials.push(trial.fast((2e-4..=1e-2).contains(&step)).expect(expected));
        }
    }
    Ok(trials)
}

fn scene((method, constraints): How, step: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.rods[0].elements, scene.time.method, scene.constraints) = (1, method, constraints);
    (scene.time.step, scene.time.end, scene.time.newton_tolerance) = (step, END, TOLERANCE);
    (scene.output.interval, scene.output.energy) = (Some(END), false);
    Ok(scene)
}

/// The oracle's tip at the end, and its error.
fn reference() -> Result<([f64; 2], f64)> {
    let oracle = reference_pendulum::load()?;
    let known = oracle.runs.iter().find(|run| run.id == "flexible-1");
    let at = known.and_then(|run| {
        let row = run.t.iter().position(|t| (t - END).abs() < 1e-12)?;
        Some((run.tip[row], run.error_estimate.position))
    });
    at.ok_or_else(|| Error::Fixture { name: "pendulum.json", reason: format!("no tip of flexible-1 at {END} s") })
}

fn off(run: &Run, [x, y]: [f64; 2]) -> f64 {
    positions(run, "tip").last().map_or(f64::NAN, |tip| (tip[0] - x).hypot(tip[1] - y))
}

fn measure(how: How, step: f64) -> Result<Finding> {
    let (tip, uncertainty) = reference()?;
    let order = if how.0 == Method::Gauss { 4 } else { 2 };
    let way = (tip[0] - 1.0).hypot(tip[1]);
    let own = run(&scene(how, step)?)?;
    let (bound, why) =
        if step > BENDING { by_halving(how, step, &own, order)? } else { by_order(how, step, tip, order)? };
    // v ≤ 2 way/T; F/m ≤ 3g at the tip of a falling rod.
    let rounding = own.counts.steps as f64 * EPS * (way + 2.0 * way);
    let floor = rounding + 0.5 * TOLERANCE * 3.0 * 9.8 * END * END + uncertainty;
    let unresolved = if 4.0 * step * THICKNESS > 0.5 { 2.0 * 9.8 / (SHEAR * SHEAR) } else { 0.0 };
    Ok(Finding {
        error: off(&own, tip),
        bound: bound + floor + unresolved,
        why: format!("{why}, floor {floor:.1e}, not resolved {unresolved:.1e}"),
        size: way,
        rounding: floor,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

/// What halving a step changes until it resolves bending, and the series of the last two.
fn by_halving(how: How, step: f64, own: &Run, order: i32) -> Result<(f64, String)> {
    let (mut terms, mut step, mut last) = (Vec::new(), step, positions(own, "tip"));
    while step > 0.25 * BENDING {
        step *= 0.5;
        let finer = positions(&run(&scene(how, step)?)?, "tip");
        terms.push(largest(&last, &finer));
        last = finer;
    }
    let (earlier, last) = terms.split_at(terms.len() - 2);
    let series = Halving::new(last[0], last[1], order);
    Ok((earlier.iter().sum::<f64>() + series.bound(), format!("{} halvings, the last two {series}", terms.len())))
}

/// What the errors of twice and of four times the step leave.
fn by_order(how: How, step: f64, tip: [f64; 2], order: i32) -> Result<(f64, String)> {
    let [twice, four] = [off(&run(&scene(how, 2.0 * step)?)?, tip), off(&run(&scene(how, 4.0 * step)?)?, tip)];
    let ratio = 2f64.powi(order);
    let bound = twice / ratio * (1.0 + (four / (ratio * twice) - 1.0).abs());
    Ok((bound, format!("twice the step {twice:.1e}, four times {four:.1e}")))
}
