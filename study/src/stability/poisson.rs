//! Poisson's ratio up to its limits: the patch test of a rod that is pulled.
//!
//! λ = Eν/((1 + ν)(1 − 2ν)) grows beside μ as λ/μ = 2ν/(1 − 2ν). The stress along the rod is λ tr ε + 2μ ε₁₁, of which λ tr ε stays of the
//! size of μ ε₁₁ as the section thins: a rounding of a strain makes a stress λ/μ times as large, beside μ. Each point's stress has four
//! roundings of D and of the sum, and a residual adds 15 points: 20 halves of ε_mach of the strain 0.105, times 1 + |λ|/μ; and Newton's
//! tolerance, times the same. Towards −1 everything goes as 1/(1 + ν), and nothing is lost.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, builtin, positions};
use crate::error::Result;
use ancf::model::Poisson;
use ancf::run::run;

pub const CASE: Case = Case {
    name: "poisson",
    parameter: "ν",
    unit: "of L",
    reference: "uniform tension by a dead load F, exactly: F = A E/(1 − ν²) ½(s² − 1) s at the stretch s, the section free to thin",
    right: "patch test: stretch off by at most (10 ε_mach + 1e-15)(1 + |λ|/μ) of the strain, λ/μ = 2ν/(1 − 2ν): twenty roundings of a stress that \
            λ makes, beside μ, and Newton's tolerance; the tip is written to ε_mach. Refused at −1, 0.5, beyond, and where it is not a number.",
    trials,
};

/// Newton's, of the largest force.
const TOLERANCE: f64 = 1e-15;

/// Stretch under the load.
const STRETCH: f64 = 1.1;

fn trials() -> Result<Vec<Trial>> {
    let ratios = [
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
    let refused = [-1.0, 0.5, -1.5, 0.7, f64::NAN, f64::INFINITY];
    let mut trials = Vec::new();
    for poisson in [Poisson::Full, Poisson::Axis] {
        let variant = format!("Poisson's terms \"{poisson}\"");
        for nu in ratios {
            let expected = if (-0.99..=0.4999999).contains(&nu) { Expected::Result } else { Expected::ResultOrRefusal };
            trials.push(Trial::new(variant.clone(), nu, move || patch(nu, poisson)).fast(true).expect(expected));
        }
        for nu in refused {
            let expected = Expected::Refusal(&["material.nu", "a number between -1 and 0.5, without both"]);
            trials.push(Trial::new(variant.clone(), nu, move || patch(nu, poisson)).fast(true).expect(expected));
        }
    }
    Ok(trials)
}

fn patch(nu: f64, poisson: Poisson) -> Result<Finding> {
    let mut scene = builtin("cantilever")?;
    scene.material.nu = nu;
    (scene.section.height, scene.section.width) = (0.1, 0.1);
    (scene.rods[0].elements, scene.rods[0].poisson) = (4, poisson);
    (scene.time.load_steps, scene.time.newton_tolerance) = (4, TOLERANCE);
    // Not 1 − ν², whose rounding near ν = −1 would be the load's.
    let modulus = scene.material.youngs_modulus / ((1.0 - nu) * (1.0 + nu));
    scene.forces[0].force = [0.01 * modulus * 0.5 * (STRETCH - 1.0) * (STRETCH + 1.0) * STRETCH, 0.0];
    if !nu.is_finite() {
        // So that the load is not refused before the material.
        scene.forces.clear();
    }
    let run = run(&scene)?;
    let [x, y] = positions(&run, "tip").last().copied().unwrap_or([f64::NAN; 2]);
    let strain = 0.5 * (STRETCH - 1.0) * (STRETCH + 1.0);
    let grown = 1.0 + (2.0 * nu / (1.0 - 2.0 * nu)).abs();
    let bound = (10.0 * EPS + TOLERANCE) * grown * strain + EPS;
    Ok(Finding {
        error: (x - STRETCH).hypot(y),
        bound,
        why: format!("1 + |λ|/μ = {grown:.1e}"),
        size: STRETCH - 1.0,
        rounding: bound,
        counts: run.counts,
        // There is no bending here that could lock.
        warnings: run.warnings.into_iter().filter(|warning| !warning.contains("locks")).collect(),
        beside: None,
    })
}
