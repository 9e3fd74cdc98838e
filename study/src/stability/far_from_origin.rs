//! Far from the origin: where a scene lies must not matter.

use nalgebra::{Rotation2, Vector2};

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, builtin, positions};
use super::stiff;
use crate::error::Result;
use crate::error_time::samples::largest;
use ancf::model::{Element, Method, Scene};
use ancf::run::run;

pub const CASE: Case = Case {
    name: "far-from-origin",
    parameter: "offset, m",
    unit: "m",
    reference: "the same pendulum at the origin, along x",
    right: "displacements are stored, not places, so that (L/h)² does not enter: what is lost is lost when the points of the file are \
            rounded, ε_mach/2 of each coordinate (offset and 0.7 offset). Two ends: length and direction are off by δ = 1.22 ε_mach · offset. The \
            tip shows the direction once (a swing does not grow with its start in half a second), the length once, the period that goes \
            with it by ½√(3g/L) T = 1.36 times (ω ≤ √(3g/L)), and the deflection, as L⁴, 4(1/336 + 1/302) q₀L⁴/EI = 0.29 times; the output \
            rounds by half of δ: 5.1 ε_mach · offset. Each step rounds u and v, in both runs: 2n ε_mach (|u| + |v|T), and Newton may leave \
            1e-14 of the largest force, ½ 1e-14 · 3g T². A rod shorter than 1e-9 of its coordinates is refused.",
    trials,
};

const END: f64 = 0.5;
const TOLERANCE: f64 = 1e-14;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for (element, method) in [(Element::Ancf, Method::EnergyMomentum), (Element::EulerBernoulli, Method::Gauss)] {
        for angle in [0.0, 0.5, 2.0, -1.3] {
            for offset in [0.0, 1.0, 1e2, 1e4, 1e6, 1e8, 1e10] {
                let expected = match offset {
                    1e10 => Expected::Refusal(&["rods[0].to", "a point further from `o`"]),
                    _ => Expected::Result,
                };
                let fast = method == Method::EnergyMomentum && (angle == 0.5 || offset == 1e8);
                let trial = Trial::new(format!("{element}, {method}, turned by {angle} rad"), offset, move || {
                    measure(element, method, angle, offset)
                });
                trials.push(trial.fast(fast).expect(expected));
            }
        }
    }
    Ok(trials)
}

fn scene(element: Element, method: Method) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.rods[0].element, scene.rods[0].elements) = (element, 4);
    (scene.time.method, scene.time.step, scene.time.end) = (method, 1e-3, END);
    scene.time.newton_tolerance = TOLERANCE;
    Ok(scene)
}

fn measure(element: Element, method: Method, angle: f64, offset: f64) -> Result<Finding> {
    let here = scene(element, method)?;
    let (turn, by) = (Rotation2::new(angle), Vector2::new(offset, -0.7 * offset));
    let mut there = here.clone();
    there.points.values_mut().for_each(|point| *point = (turn * Vector2::from(*point) + by).into());
    there.gravity = (turn * Vector2::from(here.gravity)).into();
    let (at_origin, run) = (run(&here)?, run(&there)?);
    let back = |point: &[f64; 2]| (turn.inverse() * (Vector2::from(*point) - by)).into();
    let path: Path = positions(&run, "tip").iter().map(back).collect();
    let g = -here.gravity[1];
    let fastest = (3.0 * g).sqrt();
    let points = f64::hypot(1.0, 0.7) * EPS * offset;
    let shown = 1.0 + 1.0 + 0.5 * fastest * END + 4.0 * (1.0 / 336.0 + 1.0 / 302.0) * stiff::bent(&here) + 0.5;
    // Half a swing takes the tip by √2 at most.
    let steps = 2.0 * run.counts.steps as f64 * EPS * (2f64.sqrt() + fastest * END) + TOLERANCE * 3.0 * g * END * END;
    let bound = shown * points + steps;
    Ok(Finding {
        error: largest(&path, &positions(&at_origin, "tip")),
        bound,
        why: format!("points {points:.1e} m, shown {shown:.1} times; steps {steps:.1e}"),
        size: 1.0,
        rounding: bound,
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}
