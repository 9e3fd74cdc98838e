//! The step, from far too long to so short that rounding is all there is.

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{EPS, How, IMPLICIT, builtin, positions, words};
use crate::error::Result;
use crate::run::{Run, run};
use crate::scene::{Constraints, Element, Method, Scene};

pub const CASE: Case = Case {
    name: "step-size",
    parameter: "step, s",
    unit: "m",
    reference: "the same element by Gauss's collocation (order 4) with a step of 1e-5 s, held to the oracle's 12 digits by the tests of the \
                methods",
    right: "one element, a tenth of a second: error at most a quarter of that with twice the step, times 2, where steps resolve bending (≤ 5e-3 \
            s; above, at most that error, or the phase ωT(ωΔt)²/6 of the vibration that the weight starts), and for Gauss a sixteenth, times 2, where they resolve the thickness vibration; above, its \
            amplitude 2g/ω² = 2.5e-8 m may be missing. Or the floor: each step rounds u and v by ε_mach, n ε_mach (|u| + |v|T); Newton may leave 1e-12 of the largest force, \
            ½ 1e-12 F/m T², once for the method and once for the reference. The longest step has no other: it is at most the whole way.",
    trials,
};

const END: f64 = 0.1;

/// √12 √(E/ρ)/h, rad/s.
const THICKNESS: f64 = 2.78e4;

/// A step resolves bending where ω Δt ≤ ½ for the third frequency of a supported and free rod, 104 √(EI/(ρAL⁴)) = 97 rad/s.
const BENDING: f64 = 5e-3;

/// The second of them, rad/s, and twice the static deflection under the weight, ρAg L⁴/(336 EI), m: the tip's vibration.
const SECOND: f64 = 46.0;
const AMPLITUDE: f64 = 0.068;
const TOLERANCE: f64 = 1e-12;
const STEPS: [f64; 14] = [1e-1, 5e-2, 2.5e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 1e-5, 1e-6, 5e-7, 1e-7];

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for how in IMPLICIT {
        for step in STEPS {
            let trial = Trial::new(words(how, Element::Ancf), step, move || measure(how, step));
            let far = how.0 == Method::Gauss && step > 1e-2;
            let expected = if far { Expected::ResultOrRefusal } else { Expected::Result };
            trials.push(trial.fast((2e-4..=1e-2).contains(&step)).expect(expected));
        }
    }
    Ok(trials)
}

fn scene((method, constraints): How, step: f64, end: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.rods[0].elements, scene.time.method, scene.constraints) = (1, method, constraints);
    (scene.time.step, scene.time.end, scene.time.newton_tolerance) = (step, end, TOLERANCE);
    (scene.output.interval, scene.output.energy) = (Some(end), false);
    Ok(scene)
}

fn tip(run: &Run) -> [f64; 2] {
    positions(run, "tip").last().copied().unwrap_or([f64::NAN; 2])
}

fn off([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (a - c).hypot(b - d)
}

fn measure(how: How, step: f64) -> Result<Finding> {
    // The shortest steps, over a tenth of the time.
    let end = if step < 5e-6 { 0.1 * END } else { END };
    let reference = tip(&run(&scene((Method::Gauss, Constraints::Condensed), 1e-5, end)?)?);
    let own = run(&scene(how, step, end)?)?;
    let error = off(tip(&own), reference);
    let way = off(reference, [1.0, 0.0]);
    let steps = own.counts.steps as f64;
    // v ≤ 2 way/T; F/m ≤ 3g at the tip of a falling rod, half of it for the rest.
    let rounding = steps * EPS * (way + 2.0 * way);
    let floor = rounding + 2.0 * 0.5 * TOLERANCE * 3.0 * 9.8 * end * end;
    // Until a step resolves the thickness vibration the amplitude that the sudden weight gives it, 2g/ω², may be missing; and until it
    // resolves what bends, no order shows.
    let unresolved = if step * THICKNESS > 1.0 { 2.0 * 9.8 / (THICKNESS * THICKNESS) } else { 0.0 };
    let order = match how.0 {
        Method::Gauss if unresolved == 0.0 => 4,
        _ => 2,
    };
    let twice = 2.0 * step;
    let coarse = if twice <= end && (end / twice - (end / twice).round()).abs() < 1e-9 {
        off(tip(&run(&scene(how, twice, end)?)?), reference)
    } else {
        way * 2f64.powi(order) / 2.0
    };
    let by_order = if step > BENDING {
        // Each frequency is off by (ωΔt)²/6 at most, which shifts its vibration by ωT times as much.
        let phase = SECOND * end * (SECOND * step).powi(2) / 6.0;
        coarse.max(AMPLITUDE * phase.min(2.0))
    } else {
        2.0 * coarse / 2f64.powi(order)
    };
    Ok(Finding {
        error,
        bound: by_order.max(floor) + unresolved,
        why: format!("twice the step {coarse:.1e}, floor {floor:.1e}, not resolved {unresolved:.1e}"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
