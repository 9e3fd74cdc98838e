//! Large rotations: a free rod that spins, and the pendulum that goes over the top.

use std::f64::consts::PI;

use nalgebra::{DVector, Vector2};

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, builtin, largest as largest_of, positions};
use super::richardson::{self, Halving};
use super::rigid::Pendulum;
use super::stiff;
use crate::error::{Error, Result};
use crate::error_time::samples::largest;
use ancf::elements::{Ancf, Beam, Cable, Meaning, NodalVector};
use ancf::integrators::counts::Counts;
use ancf::integrators::{State, integrator};
use ancf::model::plan::Plan;
use ancf::model::{Element, Method, Motion, Scene};
use ancf::structure::Structure;

pub const SPUN: Case = Case {
    name: "rotation-free",
    parameter: "turns",
    unit: "of the start's",
    reference: "energy and angular momentum of the start: nothing acts on a free rod",
    right: "energy–momentum: both drift by at most 2.5 n ε_mach in n steps, 5.6e-11 in 1,000 turns of a hundred: each step rounds place and velocity once, \
            and Newton leaves 1e-15 of the force N ≤ ρAω²L²/8 that works over ½ωLΔt, 0.4 ε_mach of the energy. Gauss and velocity Verlet keep \
            what is bilinear in place and momentum, and so the angular momentum, to the same; their energy, and both quantities of the \
            other methods, are lost by as much as their step makes: the series of three runs with halved steps. Turns go on to 3,000, where \
            nothing has broken (a hundredth would be reached after 2e11 turns); with one or two steps a turn places mean nothing, whatever is kept.",
    trials: spun,
};

pub const CIRCLING: Case = Case {
    name: "rotation-over-the-top",
    parameter: "ω at the lowest point, rad/s",
    unit: "m",
    reference: "the rigid pendulum over the top in closed form, φ/2 = am(ωt/2)",
    right: "tip over ten turns, a thousand steps a turn: at most C/E + the series of three runs with halved steps + rounding. C/E as in \
            the stiff limit with the angle that it turns through, and the stretch ρω²L³/3E + ρgL²/2E, twice as it comes suddenly, which \
            slows it by twice as much again over that angle; all times 1/(1 − m), m = (2ω₀/ω)², for the slow passage over the top. From \
            100 rad/s on E grows as ω², from 2e12 Pa, as the stretch would else be all that is seen: from there on it is the same motion in other units, and does not break. Rounding: a force EA ε_mach |u|/l \
            that acts like a load. Energy–momentum's balance at most 2.5 n ε_mach + Newton's 1e-10 of the kinetic energy, or the row is WRONG.",
    trials: circling,
};

/// What is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kept {
    Energy,
    Momentum,
}

/// A turn takes a fifth of a second.
const TURN: f64 = 0.2;

fn spun() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    let mut add = |method: Method, element: Element, steps: usize, turns: &[usize]| {
        for &turns in turns {
            for kept in [Kept::Energy, Kept::Momentum] {
                let what = if kept == Kept::Energy { "energy" } else { "angular momentum" };
                let name = format!("{method}, {element}, {steps} steps a turn, {what}");
                let trial = Trial::new(name, turns as f64, move || spin(method, element, steps, turns, kept));
                let expected = if steps >= 100 { Expected::Result } else { Expected::ResultOrRefusal };
                trials.push(trial.fast(turns == 10 && method == Method::EnergyMomentum).expect(expected));
            }
        }
    };
    for element in [Element::Ancf, Element::EulerBernoulli] {
        add(Method::EnergyMomentum, element, 100, &[10, 100, 1000, 3000]);
        for steps in [30, 10, 5, 3] {
            add(Method::EnergyMomentum, element, steps, &[10]);
        }
        add(Method::Gauss, element, 100, &[10, 100]);
        add(Method::GeneralizedAlpha, element, 100, &[10, 100]);
    }
    add(Method::Explicit, Element::Ancf, 5000, &[10, 100]);
    // Its steps damp vibrations that they do not resolve: with fewer, all of the section's is gone after ten turns, with half of them too.
    add(Method::Nystrom, Element::Ancf, 20_000, &[10]);
    Ok(trials)
}

/// A rod of one element that turns about its middle.
fn free_rod(method: Method, element: Element, step: f64, turns: usize) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.supports, scene.gravity) = (Vec::new(), [0.0; 2]);
    (scene.rods[0].element, scene.rods[0].elements) = (element, 1);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega: 2.0 * PI / TURN, about: [0.5, 0.0] });
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, TURN * turns as f64);
    scene.time.newton_tolerance = 1e-15;
    scene.output.interval = Some(TURN);
    scene.validate("rotation")?;
    Ok(scene)
}

fn spin(method: Method, element: Element, steps: usize, turns: usize, kept: Kept) -> Result<Finding> {
    let step = TURN / steps as f64;
    let (drift, counts) = drift(&free_rod(method, element, step, turns)?, kept)?;
    let keeps = match method {
        Method::EnergyMomentum => true,
        Method::Gauss | Method::Explicit => kept == Kept::Momentum,
        _ => false,
    };
    let rounding = 2.5 * EPS * (steps * turns) as f64;
    let (bound, why) = if keeps {
        (rounding, "kept: rounding and Newton's residual".into())
    } else {
        let finer = |parts: f64| Ok::<_, Error>(self::drift(&free_rod(method, element, step / parts, turns)?, kept)?.0);
        let (half, quarter): (f64, f64) = (finer(2.0)?, finer(4.0)?);
        let order = if matches!(method, Method::Gauss | Method::Nystrom) { 4 } else { 2 };
        let halving = Halving::new((drift - half).abs(), (half - quarter).abs(), order).above(4.0 * rounding);
        // The shortest step rounds four times as often.
        (halving.bound() + 4.0 * rounding, format!("not kept; halved steps {halving}"))
    };
    Ok(Finding { error: drift, bound, why, size: 1.0, rounding, counts, warnings: Vec::new(), beside: None })
}

/// Largest relative change of a quantity at the ends of the turns.
fn drift(scene: &Scene, kept: Kept) -> Result<(f64, Counts)> {
    let plan = Plan::of(scene);
    let structure = Structure::planned(scene, &plan)?;
    let mut counts = Counts::default();
    let mut state = State::at_start(&structure);
    let mut method = integrator(scene, &plan, &structure, &state, &mut counts)?;
    let mut memory = DVector::zeros(structure.size());
    let mut quantity = |state: &State| match kept {
        Kept::Energy => {
            structure.kinetic_energy(&state.v, &mut memory)
                + structure.strain_energy(&state.u, &structure.thermal_strains(0.0))
        }
        Kept::Momentum => angular_momentum(scene, &structure, state),
    };
    let (start, mut worst) = (quantity(&state), 0.0);
    for step in 1..=scene.steps() {
        method.step(&structure, &mut state, scene.time_after(step), &mut counts)?;
        if scene.is_row(step) {
            let change = (quantity(&state) / start - 1.0).abs();
            // A NaN stays.
            worst = if change <= worst { worst } else { change };
        }
    }
    Ok((worst, counts))
}

/// Σ q × (M v) over the nodal vectors of the only rod, about the origin: slopes turn with the rod as places do.
fn angular_momentum(scene: &Scene, structure: &Structure, state: &State) -> f64 {
    let rod = &scene.rods[0];
    let vectors: &[NodalVector] = match rod.element {
        Element::Ancf => Ancf::VECTORS,
        Element::EulerBernoulli => Cable::VECTORS,
    };
    let momentum = structure.inertia(&state.v);
    let of = |(place, &(meaning, at)): (usize, &NodalVector)| {
        let get = |of: &DVector<f64>| {
            let component = |c| structure.unknown(&rod.name, place, c).map_or(0.0, |unknown| of[unknown]);
            Vector2::new(component(0), component(1))
        };
        let start = match meaning {
            Meaning::Position => Vector2::new(at, 0.0),
            Meaning::SlopeX => Vector2::x(),
            Meaning::SlopeY => Vector2::y(),
        };
        (start + get(&state.u)).perp(&get(&momentum))
    };
    vectors.iter().enumerate().map(of).sum()
}

fn circling() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for (method, element) in [
        (Method::EnergyMomentum, Element::Ancf),
        (Method::EnergyMomentum, Element::EulerBernoulli),
        (Method::GeneralizedAlpha, Element::Ancf),
        (Method::Gauss, Element::Ancf),
    ] {
        for omega in [8.0, 9.0, 20.0, 100.0, 1e3, 1e5] {
            let trial = Trial::new(format!("{method}, {element}"), omega, move || circle(method, element, omega));
            // Collocation is not meant for rods as stiff as this.
            let promised = method != Method::Gauss && omega <= 1e3;
            let expected = if promised { Expected::Result } else { Expected::ResultOrRefusal };
            let trial = trial.expect(expected);
            let fast = method == Method::EnergyMomentum && element == Element::Ancf && omega == 9.0;
            trials.push(trial.fast(fast));
        }
    }
    Ok(trials)
}

const STEPS: f64 = 1000.0;
const TURNS: f64 = 10.0;

fn circle(method: Method, element: Element, omega: f64) -> Result<Finding> {
    let mut scene = builtin("pendulum-flexible")?;
    scene.points.insert("a".into(), [0.0, -1.0]);
    let modulus = 2e12 * (omega / 100.0).powi(2).max(1.0);
    (scene.material.youngs_modulus, scene.rods[0].element, scene.rods[0].elements) = (modulus, element, 4);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega, about: [0.0; 2] });
    let step = 2.0 * PI / omega / STEPS;
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, STEPS * TURNS * step);
    scene.output.interval = Some(10.0 * step);
    let order = if method == Method::Gauss { 4 } else { 2 };
    let (own, halved) = richardson::in_steps(&scene, order, |run| positions(run, "tip"))?;
    let (h, rho, g) = (scene.section.height, scene.material.rho, -scene.gravity[1]);
    let rigid = Pendulum::new(1.0, if element == Element::Ancf { h } else { 0.0 }, g);
    let times = own.trajectory.column("t").unwrap_or_default();
    let expected: Path = times.iter().map(|&t| rigid.circling(omega, t)).collect();
    let tip = positions(&own, "tip");

    let angle = 2.0 * PI * TURNS;
    let stretch = 2.0 * rho * (omega * omega / 3.0 + 0.5 * g) / modulus;
    let slow = 1.0 / (1.0 - 4.0 * rigid.square / (omega * omega));
    let flexible = slow * (stiff::first_order(stiff::bent(&scene), angle) + (1.0 + 2.0 * angle) * stretch);
    let rounding = 0.5 * scene.time.end.powi(2) * modulus * EPS * 2.0 * 4.0 / rho;
    let balance = largest_of(&own, "energy.balance") / largest_of(&own, "energy.kinetic");
    let kept = method != Method::EnergyMomentum || balance <= 2.5 * EPS * STEPS * TURNS + scene.time.newton_tolerance;
    let error = largest(&tip, &expected);
    Ok(Finding {
        error: if kept { error } else { f64::INFINITY },
        bound: flexible + halved.bound() + rounding,
        why: format!("C/E {flexible:.1e}, step {halved}, rounding {rounding:.1e}; balance {balance:.1e}"),
        size: 1.0,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
