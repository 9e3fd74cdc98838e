//! The stiff limit: the pendulum as E grows, with a step that resolves none of its waves.
//!
//! The elastic pendulum differs from the rigid one by its bending. A rod that turns about its end under its weight q₀ = ρAg feels
//! q(x) = q₀ cos θ (1 − 3x/2L) across, so that M(x) = −¼ q₀L² ξ(1 − ξ)² with ξ = x/L. Its tip is q₀L⁴/(336 EI) off the rigid motion (the
//! part of the deflection without moment of momentum about the hinge). The load comes suddenly, so that each free vibration has the
//! amplitude of its part of that deflection. The tips of the parts have alternating signs; together they reach at most the sum of the
//! absolute values, q₀L⁴/(302 EI) (tan k = tanh k, ten of them). The motion lacks the bending energy q₀²L⁵/(3360 EI), which is
//! q₀L³/(1680 EI) of ½q₀L², and half of that of the speed. A sudden start doubles it; over the angle 2π that the tip turns through in two
//! seconds this makes 2π q₀L⁴/(1680 EI) in position. Stretch and shear are (h/L)² of all this.
//!
//! Together C/E = (1/336 + 1/302 + 2π/1680) q₀L⁴/(EI) to first order. Second order: loads turn against the rod by its slope, q₀L³/(48 EI),
//! and twice that suddenly; they turn with it, by ω² ≤ 3g/L, and a vibration of frequency ω₁ (15.4 √(EI/ρA)/L²) follows as
//! 1/(1 − ω²/ω₁²).

use super::implicit::{IMPLICIT, Implicit};
use super::prelude::*;
use super::richardson;
use super::rigid_pendulum::RigidPendulum;
use super::steps::each_step;

pub const CASE: Case = Case {
    name: "stiff-limit",
    parameter: "E, Pa",
    unit: "m",
    reference: "the rigid pendulum in closed form (elliptic functions), checked against the oracle's 30 digits; I = mL²/3 + mh²/12, for \
                Euler–Bernoulli without mh²/12",
    right: "distance of the tip over 2 s, step 1e-3 s, at most C/E + error of the step + rounding. C = (1/336 + 1/302 + 2π/1680) q₀L⁴E/(EI): \
            bending by the weight, vibrations of the sudden start, and speed lost to the bending energy; times (1 + q₀L³/24EI)/(1 − 3g/(Lω₁²)) \
            for the second order. Step: series of three runs with halved steps. Rounding: a strain carries ε_mach |u|/l, and so a force \
            EA ε_mach |u|/l, which at worst acts on the mass like a load during the whole motion. At most 8 Newton iterations in any step up to \
            2e14 Pa; `gauss`, whose stages are coupled, is not meant for steps that resolve nothing, and may be refused above 2e10 Pa.",
    trials,
};

/// Up to this modulus a method for stiff systems has to give a result, Pa.
const PROMISED: f64 = 2e14;
const MOST_ITERATIONS: usize = 8;

/// The sweep continues until the method breaks.
const MODULI: [f64; 8] = [2e8, 2e10, 2e12, 2e14, 2e16, 2e18, 2e20, 2e22];

fn trials() -> Vec<Trial> {
    let trial = |(element, how, modulus): (Element, Implicit, f64)| {
        let fast = how == IMPLICIT[0] && element == Element::Ancf && modulus == 2e14;
        let promised = modulus <= if how.method == Method::Gauss { 2e10 } else { PROMISED };
        let trial = Trial::new(how.with(element), modulus, move || measure(how, element, modulus));
        trial.fast(fast).expect(Expected::result_if(promised))
    };
    iproduct!(ELEMENTS, IMPLICIT, MODULI).map(trial).collect()
}

/// q₀L⁴/(EI) of the pendulum of 1 m, relative to the length: the weight over the bending stiffness.
pub fn bent(scene: &Scene) -> f64 {
    let (material, h) = (&scene.material, scene.section.height);
    -material.rho * scene.gravity[1] * 12.0 / (material.youngs_modulus * h * h)
}

/// C/E over an angle, relative to the length, to first order.
pub fn first_order(bent: f64, angle: f64) -> f64 {
    (1.0 / 336.0 + 1.0 / 302.0 + angle / 1680.0) * bent
}

/// Displacement by the rounding of strains in a motion of rods of 1 m, m: the acceleration EA ε_mach |u|/(l m), |u| ≤ 2L, as a constant load,
/// ½ t².
pub fn rounding_as_load(scene: &Scene, modulus: f64) -> f64 {
    let (time, elements) = (scene.time.end, scene.rods[0].elements as f64);
    0.5 * time * time * modulus * f64::EPSILON * 2.0 * elements / scene.material.rho
}

fn measure(how: Implicit, element: Element, modulus: f64) -> Result<Finding> {
    let mut scene = pendulum(element, 4)?;
    scene.material.youngs_modulus = modulus;
    (scene.time.method, scene.constraints, scene.time.step) = (how.method, how.constraints, 1e-3);
    scene.output.energy = how.method == Method::EnergyMomentum && how.constraints == Constraints::Condensed;
    let (own, step) = richardson::in_steps(&scene, tip)?;
    let rigid = RigidPendulum::limit_of(&scene);
    let expected: Path = column(&own, "t").into_iter().map(|t| rigid.released(t)).collect();

    let bent = bent(&scene);
    // 3g/(L ω₁²), as ω₁² = 15.4² EI/(ρA L⁴) and q₀ = ρAg.
    let slow = 1.0 / (1.0 - 3.0 * bent / (15.418 * 15.418));
    let flexible = first_order(bent, 2.0 * std::f64::consts::PI) * (1.0 + bent / 24.0) * slow;
    let rounding = rounding_as_load(&scene, modulus);
    let iterations = most_iterations(&scene)?;
    // Collocation couples two stages; where steps resolve nothing, its iteration converges slowly, and has no such bar.
    let slow_iteration = iterations > MOST_ITERATIONS && modulus <= PROMISED && how.method != Method::Gauss;
    let error = if slow_iteration { f64::INFINITY } else { largest_distance(&tip(&own), &expected) };
    let why = format!("C/E {flexible:.1e}, step {step}, rounding {rounding:.1e}; at most {iterations} iterations");
    Ok(Finding { error, bound: flexible + step.bound() + rounding, why, rounding, ..Finding::of(own) })
}

/// The most Newton iterations of one step.
fn most_iterations(scene: &Scene) -> Result<usize> {
    let (mut most, mut before) = (0, 0);
    each_step(scene, |_, _, step, counts| {
        // The start may take some as well.
        most = if step == 0 { 0 } else { most.max(counts.newton_iterations - before) };
        before = counts.newton_iterations;
    })?;
    Ok(most)
}
