//! Heat, from what can hardly be told from none to the limits of the strain measure: rods that are free to expand, and rods that are
//! not.
//!
//! Each rounding is counted once, and none against another. Free: a strain of the size 1 + 2αΔT is rounded where nodes are subtracted,
//! where it is squared, where heat is taken off and where the tip is written, half of ε_mach each; Newton's iteration may leave its
//! tolerance, 1e-15 of EA. Clamped: the reaction is a sum over the 15 quadrature points of terms αΔT D, D of four roundings, written
//! once: 20 halves of ε_mach of N, and Newton's tolerance of it. (Euler–Bernoulli has fewer.)

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, builtin, last, positions};
use crate::error::Result;
use ancf::model::{Direction, Element, Probe, Quantity, Scene, Support, Temperature, ThermalModel};
use ancf::run::run;

pub const FREE: Case = Case {
    name: "heat-free",
    parameter: "αΔT",
    unit: "of E",
    reference: "no stress at the stretch √(1 + 2αΔT), Euler–Bernoulli 1 + αΔT (M2)",
    right: "the stress of the stretch that statics finds, over E, at most (2 ε_mach + 1e-15)(1 + 2αΔT): four roundings of a strain, and \
            Newton's tolerance. Where the stress-free stretch is not positive the scene is refused, with the limit.",
    trials: free,
};

pub const CLAMPED: Case = Case {
    name: "heat-clamped",
    parameter: "αΔT",
    unit: "of EA",
    reference: "N = −EAαΔT/(1 − ν²) of the straight rod whose section is free to thicken (M8); Euler's load of the straight branch, \
                4π²EI/L² clamped",
    right: "reaction at most (10 ε_mach + 1e-15) N off: twenty roundings of N, and Newton's tolerance. Twice \
            above Euler's load the straight equilibrium is unstable, and the run has to say so; half below it must not.",
    trials: clamped,
};

/// A power of two, so that ΔT = strain/α is exact.
const ALPHA: f64 = 1.0 / 65536.0;
const NU: f64 = 0.3;
/// Newton's, of the largest force.
const TOLERANCE: f64 = 1e-15;
/// h/L.
const HEIGHT: f64 = 0.02;

fn heated(strain: f64) -> Option<Temperature> {
    Some(Temperature { model: ThermalModel::TwoD, start: Default::default(), history: vec![[0.0, strain / ALPHA]] })
}

/// A rod of 1 m, heated in ten steps.
fn rod(element: Element, strain: f64) -> Result<Scene> {
    let mut scene = builtin("cantilever")?;
    (scene.material.youngs_modulus, scene.material.alpha) = (2e8, ALPHA);
    (scene.section.height, scene.section.width) = (HEIGHT, HEIGHT);
    (scene.rods[0].element, scene.rods[0].elements) = (element, 4);
    (scene.time.load_steps, scene.time.newton_tolerance) = (10, TOLERANCE);
    (scene.forces, scene.temperature) = (Vec::new(), heated(strain));
    Ok(scene)
}

const ELEMENTS: [Element; 2] = [Element::Ancf, Element::EulerBernoulli];
const OUT: &[&str] = &["temperature.history[0][1]", "stays positive in the rod `rod`"];

fn free() -> Result<Vec<Trial>> {
    let strains = [1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.4, 1.0, 1e2, 1e4, -1e-12, -1e-6, -1e-3, -0.1, -0.4, -0.49];
    let mut trials = Vec::new();
    for element in ELEMENTS {
        for strain in strains {
            let expected = if strain <= 0.4 { Expected::Result } else { Expected::ResultOrRefusal };
            let trial = Trial::new(element.to_string(), strain, move || expand(element, strain));
            trials.push(trial.fast(true).expect(expected));
        }
        let limit = if element == Element::Ancf { 0.5 } else { 1.0 };
        for strain in [-limit, -1.2 * limit, -1e3] {
            let trial = Trial::new(element.to_string(), strain, move || expand(element, strain));
            trials.push(trial.fast(true).expect(Expected::Refusal(OUT)));
        }
    }
    Ok(trials)
}

fn expand(element: Element, strain: f64) -> Result<Finding> {
    let mut scene = rod(element, strain)?;
    scene.supports[0].clamp = None;
    scene.supports.push(Support { point: "a".into(), fix: Vec::new(), slide: Some([1.0, 0.0]), clamp: None });
    let run = run(&scene)?;
    let [x, y] = positions(&run, "tip").last().copied().unwrap_or([f64::NAN; 2]);
    let stretch = x.hypot(y);
    let stress = match element {
        Element::Ancf => 0.5 * (stretch - 1.0) * (stretch + 1.0) - strain,
        Element::EulerBernoulli => stretch - 1.0 - strain,
    };
    let size = 1.0 + 2.0 * strain.max(0.0);
    let bound = (2.0 * EPS + TOLERANCE) * size;
    let why = "four roundings of the strain, Newton's tolerance".into();
    let (counts, warnings) = (run.counts, run.warnings);
    Ok(Finding { error: stress.abs(), bound, why, size, rounding: bound, counts, warnings, beside: None })
}

fn clamped() -> Result<Vec<Trial>> {
    // Euler's load is that of αΔT = π²(h/L)²/3 = 1.3e-3.
    let strains = [1e-12, 1e-9, 1e-6, 1e-4, 6e-4, 2.7e-3, 1e-2, 0.1, 0.4, -1e-12, -1e-6, -1e-3, -0.1, -0.3];
    let mut trials = Vec::new();
    for element in ELEMENTS {
        for strain in strains {
            let expected = if strain > 1.3e-3 { Expected::Warning(&["unstable"]) } else { Expected::Result };
            let trial = Trial::new(element.to_string(), strain, move || press(element, strain));
            trials.push(trial.fast(true).expect(expected));
        }
        // ν = 0.3: 1 + 2αΔT/(1 − ν) < 0, nothing is left of the section.
        if element == Element::Ancf {
            let trial = Trial::new(element.to_string(), -0.49, move || press(element, -0.49));
            trials.push(trial.fast(true).expect(Expected::Refusal(&["element 1 of 4 of the rod `rod` has collapsed"])));
        }
        let trial = Trial::new(element.to_string(), -1.2, move || press(element, -1.2));
        trials.push(trial.fast(true).expect(Expected::Refusal(OUT)));
    }
    Ok(trials)
}

fn press(element: Element, strain: f64) -> Result<Finding> {
    let mut scene = rod(element, strain)?;
    let nu = if element == Element::Ancf { NU } else { 0.0 };
    scene.material.nu = nu;
    let both = vec![Direction::X, Direction::Y];
    scene.supports.push(Support { point: "a".into(), fix: both, slide: None, clamp: Some("rod".into()) });
    scene.probes.push(Probe {
        name: "wall".into(),
        point: Some("a".into()),
        rod: None,
        at: None,
        of: vec![Quantity::Reaction],
    });
    let run = run(&scene)?;
    let stiffness = scene.material.youngs_modulus * HEIGHT * HEIGHT;
    let reaction = -last(&run, "wall.rx") / stiffness;
    let error = (reaction - strain / (1.0 - nu * nu)).hypot(last(&run, "wall.ry") / stiffness);
    let size = strain.abs() / (1.0 - nu * nu);
    let bound = (10.0 * EPS + TOLERANCE) * size;
    let (counts, why) = (run.counts, "twenty roundings of N, Newton's tolerance".into());
    // The element with ν ≠ 0 warns of locking in bending, of which there is none here.
    let warnings = run.warnings.into_iter().filter(|warning| !warning.contains("locks")).collect();
    Ok(Finding { error, bound, why, size, rounding: bound, counts, warnings, beside: None })
}
