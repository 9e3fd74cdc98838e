//! Far from the origin: where a scene lies must not matter.

use nalgebra::{Rotation2, Vector2};

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{EPS, Path, builtin, positions};
use crate::error::Result;
use crate::run::run;
use crate::scene::{Element, Method, Scene};
use crate::study::error_time::samples::largest;

pub const CASE: Case = Case {
    name: "far-from-origin",
    parameter: "offset, m",
    unit: "m",
    reference: "the same pendulum at the origin, along x",
    right: "displacements are stored, not places, so that (L/h)² does not enter: what is lost is lost when the points of the file are \
            rounded, ε_mach/2 · offset each. The rod's length and direction are then off by 2 ε_mach · offset, which its tip's place shows \
            at most fivefold within half a second (one swing: the angle of the start, the length in the period), and the output rounds \
            once more: 10 ε_mach · offset, beside 1e-12 m of rounding in the turned axes. A rod shorter than 1e-9 of its coordinates is \
            refused.",
    trials,
};

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
    (scene.time.method, scene.time.step, scene.time.end) = (method, 1e-3, 0.5);
    scene.time.newton_tolerance = 1e-12;
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
    let bound = 10.0 * EPS * offset + 1e-12;
    Ok(Finding {
        error: largest(&path, &positions(&at_origin, "tip")),
        bound,
        why: format!("points rounded by {:.1e} m", EPS * offset / 2.0),
        size: Some(1.0),
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}
