//! The stiff limit: the pendulum as E grows, at a step that resolves none of its waves.
//!
//! The elastic pendulum differs from the rigid one by what its loads bend it. A rod that turns about its end under its weight
//! q₀ = ρAg feels q(x) = q₀ cos θ (1 − 3x/2L) across, so that M(x) = −¼ q₀L² ξ(1 − ξ)² with ξ = x/L: its tip is q₀L⁴/(336 EI)
//! off the rigid motion (the part of the deflection that has no moment of momentum about the hinge), twice that where it is let go
//! suddenly. Its bending energy q₀²L⁵/(3360 EI) is missing in the motion: q₀L³/(1680 EI) of ½q₀L², half of it of the speed, twice as
//! much after a sudden start, over the angle 2π that the tip runs through in two seconds: 2π q₀L⁴/(1680 EI) of the place.
//! Stretch and shear are (h/L)² of it. Together C/E = (2/336 + 2π/1680) q₀L⁴/(EI), and a tenth for what is of second order.

use super::case::{Case, Expected, Finding, Trial};
use super::rigid::Pendulum;
use super::tools::{EPS, How, IMPLICIT, Path, builtin, most_iterations, positions, words};
use crate::error::Result;
use crate::run::run;
use crate::scene::{Constraints, Element, Method, Scene};
use crate::study::error_time::samples::largest;

pub const CASE: Case = Case {
    name: "stiff-limit",
    parameter: "E, Pa",
    unit: "m",
    reference: "the rigid pendulum in closed form (elliptic functions), I = mL²/3 + mh²/12, Euler–Bernoulli without mh²/12; held to the \
                oracle's 30 digits",
    right: "distance of the tip over 2 s, step 1e-3 s, at most C/E + the method's own time error + rounding. C = (2/336 + 2π/1680) \
            q₀L⁴E/(EI) · 1.1: what the weight bends the rod, twice as it comes suddenly, and the speed that the bending energy costs. \
            Time error: twice what half the step changes (it at least halves). Rounding: a strain carries ε_mach |u|/l, which the modulus \
            makes a force EA ε_mach |u|/l; along the rod it acts against the mass like a load, as far as the motion lasts. At most 8 Newton \
            iterations in any step up to 2e14 Pa; `gauss`, whose stages are coupled, is not meant for steps that resolve nothing, and may be \
            refused above 2e10 Pa.",
    trials,
};

const STEP: f64 = 1e-3;
/// Up to here a method for stiff systems has to hold.
const PROMISED: f64 = 2e14;
const MOST_ITERATIONS: usize = 8;
const ELEMENTS: usize = 4;

/// The decades of E: those of the issue, and on until the method breaks.
const MODULI: [f64; 8] = [2e8, 2e10, 2e12, 2e14, 2e16, 2e18, 2e20, 2e22];

fn trials() -> Result<Vec<Trial>> {
    let elements = [Element::Ancf, Element::EulerBernoulli];
    let all = elements.into_iter().flat_map(|element| IMPLICIT.map(|how| (how, element)));
    let trials = all.flat_map(|(how, element)| {
        MODULI.map(|modulus| {
            let fast = how == IMPLICIT[0] && element == Element::Ancf && (modulus == 2e10 || modulus == 2e14);
            let until = if how.0 == Method::Gauss { 2e10 } else { PROMISED };
            let expected = if modulus <= until { Expected::Result } else { Expected::ResultOrRefusal };
            Trial::new(words(how, element), modulus, move || measure(how, element, modulus)).fast(fast).expect(expected)
        })
    });
    Ok(trials.collect())
}

/// Energy–momentum solves the same equations with multipliers as without, so that only generalized-α has both.
fn scene((method, constraints): How, element: Element, modulus: f64, step: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.material.youngs_modulus, scene.rods[0].elements, scene.rods[0].element) = (modulus, ELEMENTS, element);
    (scene.time.method, scene.constraints, scene.time.step) = (method, constraints, step);
    scene.output.energy = method == Method::EnergyMomentum && constraints == Constraints::Condensed;
    Ok(scene)
}

fn measure(how: How, element: Element, modulus: f64) -> Result<Finding> {
    let scene = |step| scene(how, element, modulus, step);
    let (coarse, fine) = (run(&scene(STEP)?)?, run(&scene(0.5 * STEP)?)?);
    let scene = scene(STEP)?;
    let (h, w, rho, g) = (scene.section.height, scene.section.width, scene.material.rho, -scene.gravity[1]);
    let rigid = Pendulum::new(1.0, if element == Element::Ancf { h } else { 0.0 }, g);
    let times = coarse.trajectory.column("t").unwrap_or_default();
    let expected: Path = times.iter().map(|&t| rigid.released(t)).collect();
    let tip = positions(&coarse, "tip");

    let bent = rho * h * w * g / (modulus * w * h.powi(3) / 12.0);
    let flexible = 1.1 * (2.0 / 336.0 + 2.0 * std::f64::consts::PI / 1680.0) * bent;
    let time = 2.0 * largest(&tip, &positions(&fine, "tip"));
    // |u| ≤ 2L, l = L/4; the acceleration EA ε_mach |u|/(l m) over the time, as a load that does not change: ½ t².
    let rounding = 0.5 * 4.0 * modulus * EPS * 2.0 * ELEMENTS as f64 / rho;
    let iterations = most_iterations(&scene)?;
    let why = format!("C/E {flexible:.1e}, time {time:.1e}, rounding {rounding:.1e}; at most {iterations} iterations");
    let error = largest(&tip, &expected);
    // Collocation couples two stages, whose iteration creeps where steps resolve nothing: it has no such bar.
    let creeps = iterations > MOST_ITERATIONS && modulus <= PROMISED && how.0 != Method::Gauss;
    let error = if creeps { f64::INFINITY } else { error };
    let bound = flexible + time + rounding;
    // The difference of two theories takes no digits away.
    let size = Some(if time + rounding > 1e-2 { 1.0 } else { f64::INFINITY });
    Ok(Finding { error, bound, why, size, counts: coarse.counts, warnings: coarse.warnings, beside: None })
}
