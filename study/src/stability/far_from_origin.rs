//! Far from the origin: the position of a scene must not matter.

use nalgebra::{Rotation2, Vector2};

use super::prelude::*;
use super::stiff::bent;

pub const CASE: Case = Case {
    name: "far-from-origin",
    parameter: "offset, m",
    unit: "m",
    reference: "the pendulum at the origin, along x",
    right: "displacements are stored, not positions, so that (L/h)² does not enter. Digits are lost only as the points of the file are rounded, \
            ε_mach/2 of each coordinate (offset and 0.7 offset). Of two ends: length and direction are off by δ = 1.22 ε_mach · offset. The tip \
            shows the direction once (a swing does not grow with its start in half a second), the length once, the period, which depends on the \
            length, ½√(3g/L) T = 1.36 times (ω ≤ √(3g/L)), and the deflection, as L⁴, 4(1/336 + 1/302) q₀L⁴/EI = 0.29 times; the output rounds by \
            half of δ: 5.1 ε_mach · offset. Each step rounds u and v, in both runs: 2n ε_mach (|u| + |v|T), and Newton may leave 1e-14 of the \
            largest force, ½ 1e-14 · 3g T². A rod shorter than 1e-9 of its coordinates is refused.",
    trials,
};

const END: f64 = 0.5;
const TOLERANCE: f64 = 1e-14;

fn trials() -> Vec<Trial> {
    let solvers = [(Element::Ancf, Method::EnergyMomentum), (Element::EulerBernoulli, Method::Gauss)];
    let offsets = [0.0, 1.0, 1e2, 1e4, 1e6, 1e8, 1e10];
    let trial = |((element, method), angle, offset)| {
        let refused = Expected::Refusal(&["rods[0].to", "a point further from `o`"]);
        let name = format!("{element}, {method}, turned by {angle} rad");
        let trial = Trial::new(name, offset, move || measure(element, method, angle, offset));
        let fast = method == Method::EnergyMomentum && (angle == 0.5 || offset == 1e8);
        trial.fast(fast).expect(if offset == 1e10 { refused } else { Expected::Result })
    };
    iproduct!(solvers, [0.0, 0.5, 2.0, -1.3], offsets).map(trial).collect()
}

fn measure(element: Element, method: Method, angle: f64, offset: f64) -> Result<Finding> {
    let here = pendulum(element, 4)?.solved(method, 1e-3, END).newton(TOLERANCE);
    let (turn, by) = (Rotation2::new(angle), Vector2::new(offset, -0.7 * offset));
    let mut there = here.clone();
    there.points.values_mut().for_each(|point| *point = (turn * Vector2::from(*point) + by).into());
    there.gravity = (turn * Vector2::from(here.gravity)).into();
    let (at_origin, own) = (run(&here)?, run(&there)?);
    let back = |point: [f64; 2]| (turn.inverse() * (Vector2::from(point) - by)).into();
    let path: Path = tip(&own).into_iter().map(back).collect();
    let g = -here.gravity[1];
    let fastest = (3.0 * g).sqrt();
    let points = f64::hypot(1.0, 0.7) * f64::EPSILON * offset;
    let shown = 1.0 + 1.0 + 0.5 * fastest * END + 4.0 * (1.0 / 336.0 + 1.0 / 302.0) * bent(&here) + 0.5;
    // Half a swing moves the tip by √2 at most.
    let rounded = 2.0 * own.counts.steps as f64 * f64::EPSILON * (2f64.sqrt() + fastest * END);
    let steps = rounded + TOLERANCE * 3.0 * g * END * END;
    let bound = shown * points + steps;
    let error = largest_distance(&path, &tip(&at_origin));
    let why = format!("points {points:.1e} m, shown {shown:.1} times; steps {steps:.1e}");
    Ok(Finding { error, bound, why, rounding: bound, ..Finding::of(own) })
}
