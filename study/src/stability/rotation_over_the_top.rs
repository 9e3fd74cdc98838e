//! Large rotations: the pendulum that goes over the top.

use std::f64::consts::PI;

use super::prelude::*;
use super::richardson;
use super::rigid_pendulum::RigidPendulum;
use super::stiff::{bent, first_order, rounding_as_load};

pub const CASE: Case = Case {
    name: "rotation-over-the-top",
    parameter: "ω at the lowest point, rad/s",
    unit: "m",
    reference: "the rigid pendulum over the top in closed form, φ/2 = am(ωt/2)",
    right: "tip over ten turns, a thousand steps a turn: at most C/E + series of three runs with halved steps + rounding. C/E as in stiff-limit, \
            with the angle turned through, and the stretch ρω²L³/3E + ρgL²/2E, doubled as it comes suddenly, which slows the rod by twice as much \
            over that angle; all times 1/(1 − m), m = (2ω₀/ω)², for the slow passage over the top. From 100 rad/s on E grows as ω², from 2e12 Pa, \
            as the stretch would hide all else; from there on it is one motion in other units, and does not break. Rounding: a force EA ε_mach \
            |u|/l, like a load. The balance of energy–momentum at most 2.5 n ε_mach + Newton's 1e-10 of the kinetic energy, or the row is WRONG.",
    trials,
};

const STEPS: f64 = 1000.0;
const TURNS: f64 = 10.0;

fn trials() -> Vec<Trial> {
    let solvers = [
        (Method::EnergyMomentum, Element::Ancf),
        (Method::EnergyMomentum, Element::EulerBernoulli),
        (Method::GeneralizedAlpha, Element::Ancf),
        (Method::Gauss, Element::Ancf),
    ];
    let trial = |((method, element), omega)| {
        let trial = Trial::new(format!("{method}, {element}"), omega, move || measure(method, element, omega));
        let fast = (method, element) == solvers[0] && omega == 9.0;
        // Collocation is not meant for rods as stiff as this.
        trial.fast(fast).expect(Expected::result_if(method != Method::Gauss && omega <= 1e3))
    };
    iproduct!(solvers, [8.0, 9.0, 20.0, 100.0, 1e3, 1e5]).map(trial).collect()
}

fn measure(method: Method, element: Element, omega: f64) -> Result<Finding> {
    let step = 2.0 * PI / omega / STEPS;
    let mut scene = pendulum(element, 4)?.solved(method, step, STEPS * TURNS * step).rows_every(10.0 * step);
    scene.points.insert("a".into(), [0.0, -1.0]);
    let modulus = 2e12 * (omega / 100.0).powi(2).max(1.0);
    scene.material.youngs_modulus = modulus;
    scene.motion = Some(Motion { velocity: [0.0; 2], omega, about: [0.0; 2] });
    let (own, series) = richardson::in_steps(&scene, tip)?;
    let rigid = RigidPendulum::limit_of(&scene);
    let expected: Path = column(&own, "t").into_iter().map(|t| rigid.circling(omega, t)).collect();

    let angle = 2.0 * PI * TURNS;
    let stretch = 2.0 * scene.material.rho * (omega * omega / 3.0 - 0.5 * scene.gravity[1]) / modulus;
    let slow = 1.0 / (1.0 - 4.0 * rigid.square / (omega * omega));
    let flexible = slow * (first_order(bent(&scene), angle) + (1.0 + 2.0 * angle) * stretch);
    let rounding = rounding_as_load(&scene, modulus);
    let balance = largest(&own, "energy.balance") / largest(&own, "energy.kinetic");
    let most = 2.5 * f64::EPSILON * STEPS * TURNS + scene.time.newton_tolerance;
    let conserved = method != Method::EnergyMomentum || balance <= most;
    let error = if conserved { largest_distance(&tip(&own), &expected) } else { f64::INFINITY };
    let why = format!("C/E {flexible:.1e}, step {series}, rounding {rounding:.1e}; balance {balance:.1e}");
    Ok(Finding { error, bound: flexible + series.bound() + rounding, why, rounding, ..Finding::of(own) })
}
