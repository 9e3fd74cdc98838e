//! Heat, from the smallest strain to the limits of the strain measure: rods that are free to expand, and clamped ones.
//!
//! Roundings are added up, each at its worst. Free: a strain of the size 1 + 2αΔT is rounded four times, as nodes are subtracted, squared,
//! the thermal strain is subtracted and the tip is written, half of ε_mach each; Newton's iteration may leave its tolerance, 1e-15 of EA.
//! Clamped: the reaction is a sum over 15 quadrature points of terms αΔT D, D of four roundings, written once: 20 halves of ε_mach of N, and
//! Newton's tolerance of it. (Euler–Bernoulli has fewer.)

use super::prelude::*;

pub const FREE: Case = Case {
    name: "heat-free",
    parameter: "αΔT",
    unit: "of E",
    reference: "no stress at the stretch √(1 + 2αΔT), Euler–Bernoulli 1 + αΔT (M2)",
    right: "stress of the stretch that statics finds, over E, at most (2 ε_mach + 1e-15)(1 + 2αΔT): four roundings of a strain, and Newton's \
            tolerance. A scene whose stress-free stretch is not positive is refused, with the limit.",
    trials: free,
};

pub const CLAMPED: Case = Case {
    name: "heat-clamped",
    parameter: "αΔT",
    unit: "of EA",
    reference: "N = −EAαΔT/(1 − ν²) of the straight rod whose section is free to thicken (M8); Euler's load of the straight branch, clamped, \
                4π²EI/L²",
    right: "error of the reaction at most (10 ε_mach + 1e-15) N: twenty roundings of N, and Newton's tolerance. At twice Euler's load the straight \
            equilibrium is unstable, and the run has to warn of it; at half of it, it must not.",
    trials: clamped,
};

/// A power of two, so that ΔT = strain/α is exact.
const ALPHA: f64 = 1.0 / 65536.0;
/// Newton's, relative to the largest force.
const TOLERANCE: f64 = 1e-15;
/// h/L.
const HEIGHT: f64 = 0.02;

/// A cantilever of 1 m without forces, heated in ten steps.
fn rod(element: Element, strain: f64) -> Result<Scene> {
    let mut scene = cantilever(element, 4, HEIGHT)?.newton(TOLERANCE);
    (scene.material.youngs_modulus, scene.material.alpha, scene.time.load_steps) = (2e8, ALPHA, 10);
    let history = vec![[0.0, strain / ALPHA]];
    scene.temperature = Some(Temperature { model: ThermalModel::TwoD, start: Default::default(), history });
    scene.forces.clear();
    Ok(scene)
}

const OUT: Expected = Expected::Refusal(&["temperature.history[0][1]", "stays positive in the rod `rod`"]);

fn trial(element: Element, strain: f64, measure: fn(Element, f64) -> Result<Finding>, expected: Expected) -> Trial {
    Trial::new(element.to_string(), strain, move || measure(element, strain)).fast(true).expect(expected)
}

fn free() -> Vec<Trial> {
    let strains = [1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.4, 1.0, 1e2, 1e4, -1e-12, -1e-6, -1e-3, -0.1, -0.4, -0.49];
    let mut trials = Vec::new();
    for element in ELEMENTS {
        let limit = if element == Element::Ancf { 0.5 } else { 1.0 };
        let inside = strains.map(|strain| trial(element, strain, expand, Expected::result_if(strain <= 0.4)));
        let outside = [-limit, -1.2 * limit, -1e3].map(|strain| trial(element, strain, expand, OUT));
        trials.extend(inside.into_iter().chain(outside));
    }
    trials
}

fn expand(element: Element, strain: f64) -> Result<Finding> {
    let mut scene = rod(element, strain)?;
    scene.supports[0].clamp = None;
    scene.supports.push(Support { point: "a".into(), fix: Vec::new(), slide: Some([1.0, 0.0]), clamp: None });
    let own = run(&scene)?;
    let [x, y] = last_tip(&own);
    let stretch = x.hypot(y);
    let stress = match element {
        Element::Ancf => 0.5 * (stretch - 1.0) * (stretch + 1.0) - strain,
        Element::EulerBernoulli => stretch - 1.0 - strain,
    };
    let size = 1.0 + 2.0 * strain.max(0.0);
    let bound = (2.0 * f64::EPSILON + TOLERANCE) * size;
    let why = "four roundings of the strain, Newton's tolerance".into();
    Ok(Finding { error: stress.abs(), bound, why, size, rounding: bound, ..Finding::of(own) })
}

fn clamped() -> Vec<Trial> {
    // Euler's load is at αΔT = π²(h/L)²/3 = 1.3e-3.
    let strains = [1e-12, 1e-9, 1e-6, 1e-4, 6e-4, 2.7e-3, 1e-2, 0.1, 0.4, -1e-12, -1e-6, -1e-3, -0.1, -0.3];
    let mut trials = Vec::new();
    for element in ELEMENTS {
        trials.extend(strains.map(|strain| {
            let expected = if strain > 1.3e-3 { Expected::Warning(&["unstable"]) } else { Expected::Result };
            trial(element, strain, press, expected)
        }));
        // At ν = 0.3 1 + 2αΔT/(1 − ν) < 0: the section has collapsed.
        if element == Element::Ancf {
            let collapsed = Expected::Refusal(&["element 1 of 4 of the rod `rod` has collapsed"]);
            trials.push(trial(element, -0.49, press, collapsed));
        }
        trials.push(trial(element, -1.2, press, OUT));
    }
    trials
}

fn press(element: Element, strain: f64) -> Result<Finding> {
    let mut scene = rod(element, strain)?;
    let nu = if element == Element::Ancf { 0.3 } else { 0.0 };
    scene.material.nu = nu;
    let both = vec![Direction::X, Direction::Y];
    scene.supports.push(Support { point: "a".into(), fix: both, slide: None, clamp: Some("rod".into()) });
    let (name, point, of) = ("wall".into(), Some("a".into()), vec![Quantity::Reaction]);
    scene.probes.push(Probe { name, point, rod: None, at: None, of, mean: None });
    let mut own = run(&scene)?;
    // The element with ν ≠ 0 warns of locking in bending, of which there is none here.
    own.warnings.retain(|warning| !warning.contains("locks"));
    let stiffness = scene.material.youngs_modulus * HEIGHT * HEIGHT;
    let [along, across] = ["wall.rx", "wall.ry"].map(|column| last(&own, column) / stiffness);
    let size = strain.abs() / (1.0 - nu * nu);
    let bound = (10.0 * f64::EPSILON + TOLERANCE) * size;
    let error = (-along - strain / (1.0 - nu * nu)).hypot(across);
    let why = "twenty roundings of N, Newton's tolerance".into();
    Ok(Finding { error, bound, why, size, rounding: bound, ..Finding::of(own) })
}
