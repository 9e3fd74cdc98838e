//! Poisson's ratio up to its limits: the patch test of a rod under tension.
//!
//! λ = Eν/((1 + ν)(1 − 2ν)) grows as λ/μ = 2ν/(1 − 2ν). The stress along the rod is λ tr ε + 2μ ε₁₁. As the section thins, λ tr ε stays of
//! the size of μ ε₁₁, so that the rounding of a strain makes a stress λ/μ times as large, relative to μ. The stress of a point has four
//! roundings, of D and of the sum, and a residual adds 15 points: 20 halves of ε_mach of the strain 0.105, times 1 + |λ|/μ; Newton's
//! tolerance is multiplied alike. Towards −1 everything grows as 1/(1 + ν), and nothing is lost.

use super::prelude::*;

pub const CASE: Case = Case {
    name: "poisson",
    parameter: "ν",
    unit: "of L",
    reference: "uniform tension by a dead load F, exact: F = A E/(1 − ν²) ½(s² − 1) s at the stretch s, the section free to thin",
    right: "patch test: error of the stretch at most (10 ε_mach + 1e-15)(1 + |λ|/μ) of the strain, λ/μ = 2ν/(1 − 2ν): twenty roundings of the \
            stress from λ, relative to μ, and Newton's tolerance; the tip is written to ε_mach. Refused: −1, 0.5, values beyond, and what is not a \
            number.",
    trials,
};

/// Newton's, relative to the largest force.
const TOLERANCE: f64 = 1e-15;

/// Stretch under the load.
const STRETCH: f64 = 1.1;

/// In front of both limits.
const RATIOS: &[f64] = &[
    -0.9999999999999,
    -0.9999999,
    -0.999,
    -0.99,
    -0.5,
    0.0,
    0.3,
    0.4,
    0.49,
    0.499,
    0.49999,
    0.4999999,
    0.499999999,
    0.49999999999,
];

fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for poisson in [Poisson::Full, Poisson::Axis] {
        let mut add = |nu, expected| {
            let name = format!("Poisson's terms \"{poisson}\"");
            trials.push(Trial::new(name, nu, move || patch(nu, poisson)).fast(true).expect(expected));
        };
        for &nu in RATIOS {
            add(nu, Expected::result_if((-0.99..=0.4999999).contains(&nu)));
        }
        for nu in [-1.0, 0.5, -1.5, 0.7, f64::NAN, f64::INFINITY] {
            add(nu, Expected::Refusal(&["material.nu", "a number between -1 and 0.5, both excluded"]));
        }
    }
    trials
}

fn patch(nu: f64, poisson: Poisson) -> Result<Finding> {
    let mut scene = cantilever(Element::Ancf, 4, 0.1)?.newton(TOLERANCE);
    (scene.material.nu, scene.rods[0].poisson, scene.time.load_steps) = (nu, poisson, 4);
    // Not 1 − ν², whose rounding near ν = −1 would be an error of the load.
    let modulus = scene.material.youngs_modulus / ((1.0 - nu) * (1.0 + nu));
    scene.forces[0].force = [0.01 * modulus * 0.5 * (STRETCH - 1.0) * (STRETCH + 1.0) * STRETCH, 0.0];
    if !nu.is_finite() {
        // So that the load is not refused before the material.
        scene.forces.clear();
    }
    let mut own = run(&scene)?;
    // There is no bending that could lock.
    own.warnings.retain(|warning| !warning.contains("locks"));
    let strain = 0.5 * (STRETCH - 1.0) * (STRETCH + 1.0);
    let growth = 1.0 + (2.0 * nu / (1.0 - 2.0 * nu)).abs();
    let bound = (10.0 * f64::EPSILON + TOLERANCE) * growth * strain + f64::EPSILON;
    let error = distance(last_tip(&own), [STRETCH, 0.0]);
    let why = format!("1 + |λ|/μ = {growth:.1e}");
    Ok(Finding { error, bound, why, size: STRETCH - 1.0, rounding: bound, ..Finding::of(own) })
}
