//! The stiff limit: the pendulum as E grows, at a step that resolves none of its waves.
//!
//! The elastic pendulum differs from the rigid one by what its loads bend it. A rod that turns about its end under its weight
//! q₀ = ρAg feels q(x) = q₀ cos θ (1 − 3x/2L) across, so that M(x) = −¼ q₀L² ξ(1 − ξ)² with ξ = x/L: its tip is q₀L⁴/(336 EI)
//! off the rigid motion (the part of the deflection that has no moment of momentum about the hinge). It comes suddenly, so that each
//! of the free vibrations swings about its part as far as that part is: their tips have changing signs, and swing together by at most
//! the sum of the absolute values, q₀L⁴/(302 EI) (tan k = tanh k, ten of them). The bending energy q₀²L⁵/(3360 EI) is missing in the
//! motion: q₀L³/(1680 EI) of ½q₀L², half of it of the speed, twice as much after a sudden start, over the angle 2π that the tip runs
//! through in two seconds: 2π q₀L⁴/(1680 EI) of the place. Stretch and shear are (h/L)² of it.
//!
//! Together C/E = (1/336 + 1/302 + 2π/1680) q₀L⁴/(EI), to first order in it. Of second order: loads turn against the rod by its slope,
//! q₀L³/(48 EI), and twice that suddenly; they turn with it, by ω² ≤ 3g/L, which a vibration of the frequency ω₁ (15.4 √(EI/ρA)/L²)
//! follows as 1/(1 − ω²/ω₁²).

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, How, IMPLICIT, Path, builtin, most_iterations, positions, words};
use super::richardson;
use super::rigid::Pendulum;
use crate::error::Result;
use crate::error_time::samples::largest;
use ancf::model::{Constraints, Element, Method, Scene};

pub const CASE: Case = Case {
    name: "stiff-limit",
    parameter: "E, Pa",
    unit: "m",
    reference: "the rigid pendulum in closed form (elliptic functions), I = mL²/3 + mh²/12, Euler–Bernoulli without mh²/12; held to the \
                oracle's 30 digits",
    right: "distance of the tip over 2 s, step 1e-3 s, at most C/E + the step's own error + rounding. C = (1/336 + 1/302 + 2π/1680) \
            q₀L⁴E/(EI): what the weight bends the rod, the vibrations of its sudden start, and the speed that the bending energy costs; \
            times (1 + q₀L³/24EI)/(1 − 3g/(Lω₁²)) for the second order. Step: the series of three runs with halved steps. Rounding: a strain \
            carries ε_mach |u|/l, which the modulus makes a force EA ε_mach |u|/l; at worst it acts against the mass like a load for as long \
            as the motion lasts. At most 8 Newton iterations in any step up to 2e14 Pa; `gauss`, whose stages are coupled, is not meant for \
            steps that resolve nothing, and may be refused above 2e10 Pa.",
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
            let fast = how == IMPLICIT[0] && element == Element::Ancf && modulus == 2e14;
            let until = if how.0 == Method::Gauss { 2e10 } else { PROMISED };
            let expected = if modulus <= until { Expected::Result } else { Expected::ResultOrRefusal };
            Trial::new(words(how, element), modulus, move || measure(how, element, modulus)).fast(fast).expect(expected)
        })
    });
    Ok(trials.collect())
}

/// Energy–momentum solves the same equations with multipliers as without, so that only generalized-α has both.
fn scene((method, constraints): How, element: Element, modulus: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.material.youngs_modulus, scene.rods[0].elements, scene.rods[0].element) = (modulus, ELEMENTS, element);
    (scene.time.method, scene.constraints, scene.time.step) = (method, constraints, STEP);
    scene.output.energy = method == Method::EnergyMomentum && constraints == Constraints::Condensed;
    Ok(scene)
}

/// q₀L⁴/(EI) of the pendulum of 1 m, of the length: the weight beside what it bends.
pub fn bent(scene: &Scene) -> f64 {
    let (material, h) = (&scene.material, scene.section.height);
    -material.rho * scene.gravity[1] * 12.0 / (material.youngs_modulus * h * h)
}

/// C/E over an angle, of the length, to first order.
pub fn first_order(bent: f64, angle: f64) -> f64 {
    (1.0 / 336.0 + 1.0 / 302.0 + angle / 1680.0) * bent
}

fn measure(how: How, element: Element, modulus: f64) -> Result<Finding> {
    let scene = scene(how, element, modulus)?;
    let order = if how.0 == Method::Gauss { 4 } else { 2 };
    let (own, step) = richardson::in_steps(&scene, order, |run| positions(run, "tip"))?;
    let (h, rho, g) = (scene.section.height, scene.material.rho, -scene.gravity[1]);
    let rigid = Pendulum::new(1.0, if element == Element::Ancf { h } else { 0.0 }, g);
    let times = own.trajectory.column("t").unwrap_or_default();
    let expected: Path = times.iter().map(|&t| rigid.released(t)).collect();

    let bent = bent(&scene);
    // 3g/(L ω₁²), as ω₁² = 15.4² EI/(ρA L⁴) and q₀ = ρAg.
    let slow = 1.0 / (1.0 - 3.0 * bent / (15.418 * 15.418));
    let flexible = first_order(bent, 2.0 * std::f64::consts::PI) * (1.0 + bent / 24.0) * slow;
    // |u| ≤ 2L, l = L/4; the acceleration EA ε_mach |u|/(l m) over the time, as a load that does not change: ½ t².
    let rounding = 0.5 * 4.0 * modulus * EPS * 2.0 * ELEMENTS as f64 / rho;
    let iterations = most_iterations(&scene)?;
    let why = format!("C/E {flexible:.1e}, step {step}, rounding {rounding:.1e}; at most {iterations} iterations");
    let error = largest(&positions(&own, "tip"), &expected);
    // Collocation couples two stages, whose iteration creeps where steps resolve nothing: it has no such bar.
    let creeps = iterations > MOST_ITERATIONS && modulus <= PROMISED && how.0 != Method::Gauss;
    Ok(Finding {
        error: if creeps { f64::INFINITY } else { error },
        bound: flexible + step.bound() + rounding,
        why,
        size: 1.0,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
