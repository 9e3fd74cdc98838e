//! Large rotations: a free rod that spins, and the pendulum that goes over the top.

use std::f64::consts::PI;

use nalgebra::{DVector, Vector2};

use super::case::{Case, Expected, Finding, Trial};
use super::rigid::Pendulum;
use super::tools::{EPS, Path, builtin, largest as largest_of, positions};
use crate::counts::Counts;
use crate::error::Result;
use crate::integrators::{State, integrator};
use crate::kernel::{Ancf, Beam, Cable, Meaning, NodalVector};
use crate::plan::Plan;
use crate::run::run;
use crate::scene::{Element, Method, Motion, Scene};
use crate::structure::Structure;
use crate::study::error_time::samples::largest;

pub const SPUN: Case = Case {
    name: "rotation-free",
    parameter: "turns",
    unit: "of the start's",
    reference: "energy and angular momentum of the start: nothing acts on a free rod",
    right: "energy–momentum: both drift by at most 1e-10 in 1,000 turns (two roundings a step, 2 ε_mach · 100 steps a turn · 1,000 turns = 4.4e-11, and as much \
            for Newton's residual). Gauss and velocity Verlet keep what is bilinear in place and momentum, and so the angular momentum, to \
            the same; their energy, and both quantities of the other methods, are lost by as much as their order says: at most twice \
            what half the step changes (the loss at least halves).",
    trials: spun,
};

pub const CIRCLING: Case = Case {
    name: "rotation-over-the-top",
    parameter: "ω at the lowest point, rad/s",
    unit: "m",
    reference: "the rigid pendulum over the top in closed form, φ/2 = am(ωt/2)",
    right: "tip over ten turns, a thousand steps a turn, E = 2e12 Pa: at most C/E + twice what half the step changes + 1e-10 m. C/E as in \
            the stiff limit with the angle that it turns through, and the stretch ρω²L³/3E + ρgL²/2E, twice as it comes suddenly, which \
            slows it by twice as much again over that angle; all times 1/(1 − m), m = (2ω₀/ω)², for the slow passage over the top. \
            Energy–momentum's balance at most 1e-10 of the kinetic energy, or the row is WRONG.",
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
                trials.push(trial.fast(turns == 10 && method == Method::EnergyMomentum));
            }
        }
    };
    for element in [Element::Ancf, Element::EulerBernoulli] {
        add(Method::EnergyMomentum, element, 100, &[10, 100, 1000, 3000]);
        add(Method::Gauss, element, 100, &[10, 100, 1000]);
        add(Method::GeneralizedAlpha, element, 100, &[10, 100]);
    }
    add(Method::Explicit, Element::Ancf, 5000, &[10, 100]);
    add(Method::Nystrom, Element::Ancf, 2500, &[10, 100]);
    Ok(trials)
}

/// A rod of one element that turns about its middle.
fn free_rod(method: Method, element: Element, step: f64, turns: usize) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.supports, scene.gravity) = (Vec::new(), [0.0; 2]);
    (scene.rods[0].element, scene.rods[0].elements) = (element, 1);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega: 2.0 * PI / TURN, about: [0.5, 0.0] });
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, TURN * turns as f64);
    scene.time.newton_tolerance = 1e-14;
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
    let (bound, why) = if keeps {
        (1e-10 * (turns as f64 / 1000.0).max(1.0), "kept: rounding and Newton's residual".into())
    } else {
        let (finer, _) = self::drift(&free_rod(method, element, 0.5 * step, turns)?, kept)?;
        let changed = 2.0 * (drift - finer).abs();
        (changed + 1e-10, format!("not kept; half the step {finer:.1e}"))
    };
    Ok(Finding { error: drift, bound, why, size: None, counts, warnings: Vec::new(), beside: None })
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
        for omega in [8.0, 9.0, 20.0, 100.0, 1000.0] {
            let trial = Trial::new(format!("{method}, {element}"), omega, move || circle(method, element, omega));
            // Collocation is not meant for rods as stiff as this.
            let expected = if method == Method::Gauss { Expected::ResultOrRefusal } else { Expected::Result };
            let trial = trial.expect(expected);
            trials.push(trial.fast(method == Method::EnergyMomentum && (omega == 9.0 || omega == 1000.0)));
        }
    }
    Ok(trials)
}

const STEPS: f64 = 1000.0;
const TURNS: f64 = 10.0;

fn circle(method: Method, element: Element, omega: f64) -> Result<Finding> {
    let mut scene = builtin("pendulum-flexible")?;
    scene.points.insert("a".into(), [0.0, -1.0]);
    (scene.material.youngs_modulus, scene.rods[0].element, scene.rods[0].elements) = (2e12, element, 4);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega, about: [0.0; 2] });
    let step = 2.0 * PI / omega / STEPS;
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, STEPS * TURNS * step);
    scene.output.interval = Some(10.0 * step);
    let own = run(&scene)?;
    let (section, material) = (&scene.section, &scene.material);
    let (h, g) = (section.height, -scene.gravity[1]);
    let rigid = Pendulum::new(1.0, if element == Element::Ancf { h } else { 0.0 }, g);
    let times = own.trajectory.column("t").unwrap_or_default();
    let expected: Path = times.iter().map(|&t| rigid.circling(omega, t)).collect();
    let tip = positions(&own, "tip");
    scene.time.step *= 0.5;
    let time = 2.0 * largest(&tip, &positions(&run(&scene)?, "tip"));

    let angle = 2.0 * PI * TURNS;
    let bent = 1.1 * (2.0 / 336.0 + angle / 1680.0) * material.rho * g * 12.0 / (material.youngs_modulus * h * h);
    let stretch = 2.0 * material.rho * (omega * omega / 3.0 + 0.5 * g) / material.youngs_modulus;
    let slow = 1.0 / (1.0 - 4.0 * rigid.square / (omega * omega));
    let flexible = slow * (bent + (1.0 + 2.0 * angle) * stretch);
    let balance = largest_of(&own, "energy.balance") / largest_of(&own, "energy.kinetic");
    let kept = method != Method::EnergyMomentum || balance <= 1e-10;
    let error = largest(&tip, &expected);
    Ok(Finding {
        error: if kept { error } else { f64::INFINITY },
        bound: flexible + time + 1e-10,
        why: format!("C/E {flexible:.1e}, time {time:.1e}; balance {balance:.1e}, ε_mach {EPS:.0e}"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
