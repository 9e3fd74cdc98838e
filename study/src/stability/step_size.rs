//! The step, from far too long to so short that only rounding is left.
//!
//! Steps resolve bending if ωΔt ≤ ½ for the third frequency of a supported and free rod, 104 √(EI/(ρAL⁴)) = 97 rad/s. A method of order p
//! then has e(h) = Ch^p(1 + O(h)), and the next halving is no farther from the order than the last: e(h) ≤ e(2h) 2⁻ᵖ (1 + |e(4h)/(2ᵖ
//! e(2h)) − 1|), from three distances to the oracle and without a constant of our own. Longer steps show no order. They are halved until
//! they resolve bending, |x(h) − x(0)| ≤ Σ |x(h/2ⁿ) − x(h/2ⁿ⁺¹)|, and the last two terms are continued as a series.
//!
//! The sudden weight also shears the section: g/ω² with ω = √(12G/ρ)/h = 1.96e4 rad/s, doubled as it is sudden: 5.1e-8 m. The vibrations of
//! the section go up to √(12E/ρ)/h = 2.78e4 rad/s. They may be missing as long as the longest of the three steps does not resolve them.

use super::implicit::{IMPLICIT, Implicit};
use super::prelude::*;
use super::richardson::{Series, order};
use crate::paper::reference_pendulum::Oracle;

pub const CASE: Case = Case {
    name: "step-size",
    parameter: "step, s",
    unit: "m",
    reference: "fixtures/pendulum.json: one element by SciPy's DOP853 on the strain energy alone, ± 2e-14 m, at 0.1 s",
    right: "steps up to 5e-3 s: error at most 2⁻ᵖ of that with twice the step, times 1 + |e(4h)/(2ᵖe(2h)) − 1|, as the next halving is no farther \
            from the order p than the last. Longer steps: the changes under halving, summed until steps resolve bending, and the series of the \
            last two. Until 4h resolves the vibrations of the section, their amplitude 2g/ω² = 5.1e-8 m may be missing. Floor: each step rounds u \
            and v by ε_mach, n ε_mach (|u| + |v|T); Newton may leave 1e-14 of the largest force, ½ 1e-14 F/m T².",
    trials,
};

const END: f64 = 0.1;

/// √(12 G/ρ)/h and √(12 E/ρ)/h, rad/s.
const SHEAR: f64 = 1.96e4;
const THICKNESS: f64 = 2.78e4;

/// The longest step that resolves bending, s.
const BENDING: f64 = 5e-3;

const TOLERANCE: f64 = 1e-14;

fn trials() -> Vec<Trial> {
    let trial = |(how, step): (Implicit, f64)| {
        let trial = Trial::new(how.with(Element::Ancf), step, move || measure(how, step));
        let promised = how.method != Method::Gauss || step <= 1e-2;
        trial.fast((2e-4..=1e-2).contains(&step)).expect(Expected::result_if(promised))
    };
    let halved = (0..=11).map(|n| END / f64::from(1 << n));
    iproduct!(IMPLICIT, halved.chain([1e-5, 1e-6, 1e-7])).map(trial).collect()
}

fn swing(how: Implicit, step: f64) -> Result<Run> {
    let mut scene = pendulum(Element::Ancf, 1)?.solved(how.method, step, END).newton(TOLERANCE).rows_every(END);
    (scene.constraints, scene.output.energy) = (how.constraints, false);
    Ok(run(&scene)?)
}

fn measure(how: Implicit, step: f64) -> Result<Finding> {
    let oracle = Oracle::load()?;
    let known = oracle.runs.iter().find(|run| run.id == "flexible-1");
    let missing = || Error::fixture("pendulum.json", "there is no flexible-1");
    let known = known.ok_or_else(missing)?;
    let reference = known.tip.at(END);
    let own = swing(how, step)?;
    let order = order(how.method);
    let (bound, why) =
        if step > BENDING { by_halving(how, step, &own, order)? } else { by_order(how, step, reference, order)? };
    let way = distance(reference, [1.0, 0.0]);
    // v ≤ 2 way/T; F/m ≤ 3g at the tip of a falling rod.
    let rounding = own.counts.steps as f64 * f64::EPSILON * (way + 2.0 * way);
    let floor = rounding + 0.5 * TOLERANCE * 3.0 * 9.8 * END * END + known.error_estimate.position;
    let unresolved = if 4.0 * step * THICKNESS > 0.5 { 2.0 * 9.8 / (SHEAR * SHEAR) } else { 0.0 };
    let error = distance(last_tip(&own), reference);
    let why = format!("{why}, floor {floor:.1e}, not resolved {unresolved:.1e}");
    Ok(Finding { error, bound: bound + floor + unresolved, why, size: way, rounding: floor, ..Finding::of(own) })
}

/// Changes under halving until the step resolves bending, and the series of the last two.
fn by_halving(how: Implicit, mut step: f64, own: &Run, order: i32) -> Result<(f64, String)> {
    let (mut changes, mut last) = (Vec::new(), tip(own));
    while step > 0.25 * BENDING {
        step *= 0.5;
        let finer = tip(&swing(how, step)?);
        changes.push(largest_distance(&last, &finer));
        last = finer;
    }
    let (earlier, last) = changes.split_at(changes.len() - 2);
    let series = Series::new(last[0], last[1], order);
    Ok((earlier.iter().sum::<f64>() + series.bound(), format!("{} halvings, the last two {series}", changes.len())))
}

/// Bound from the errors with twice and with four times the step.
fn by_order(how: Implicit, step: f64, reference: [f64; 2], order: i32) -> Result<(f64, String)> {
    let error = |step| Ok::<_, Error>(distance(last_tip(&swing(how, step)?), reference));
    let (twice, four): (f64, f64) = (error(2.0 * step)?, error(4.0 * step)?);
    let ratio = 2f64.powi(order);
    let bound = twice / ratio * (1.0 + (four / (ratio * twice) - 1.0).abs());
    Ok((bound, format!("twice the step {twice:.1e}, four times {four:.1e}")))
}
