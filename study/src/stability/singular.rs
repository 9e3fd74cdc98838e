//! Mechanisms that start in, or run through, positions where they are singular.
//!
//! **Stiff ones** are judged by the rigid mechanism, from which an elastic one is C/E away: a tenth of E and ten times E, with E itself,
//! are a series, each term at most the observed part of the last, or a tenth. Beside it the series of halved steps, and the rounding EA
//! ε_mach |u|/l beside the force of 50 N. Vibrations of stiff rods that no step resolves are a part of what E changes, and out of phase
//! twice of it: terms of halved steps below that need not shrink, and then the series is that of order two, and they are added.
//!
//! **Where the mechanism has no single motion** (started flat all pins of one end are at one point, and each pair of rods may turn about
//! it), and past its singular position, an elastic one still has one. It is compared with the run with an eighth of the step, of which
//! it is at most the series of halved steps away; and its balance is a row of its own.
//!
//! **Stacked**, all rods on top of one another and the force along them, the perfect structure stays straight and is pressed. The two rods of
//! each scissor share their middle only, so that the force goes along half of a1–b2 and half of b1–a2, one after the other, and the rest
//! hangs on as mass. The force's point goes down by d, what this path is shortened by, whose strain energy is at least ½(EA/L)d². What
//! the force puts in, Fd, is strain and kinetic energy of all: Fd ≥ ½(EA/L)d², d ≤ 2FL/EA, whatever waves there are. Undamped, the point
//! vibrates about where it would rest, FL/EA down, so that its largest d is at least that.
//!
//! **Balance.** Each of n steps rounds place and velocity once, 2n ε_mach. Newton may leave its tolerance times the largest force in each
//! of the unknowns; what a force passes from one part to another in a step is at most all the energy that was put in.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, largest as largest_of, positions};
use super::richardson::{self, Halving};
use crate::error::{Error, Result};
use crate::error_time::samples::largest;
use ancf::model::plan::Plan;
use ancf::model::{Force, Method, Quantity, Scene, Scissors};
use ancf::run::{Run, run};
use ancf::structure::Structure;

pub const CASE: Case = Case {
    name: "singular-mechanism",
    parameter: "E over Table 2's",
    unit: "m (balance: of the energy put in)",
    reference: "the rigid mechanism: M(θ)θ'' + ½M'θ'² = −FL cos θ with M = Σ 2m[((k + ½)L sin θ)² + (½L cos θ)² + (L² + h²)/12], Runge and \
                Kutta's method, steps of 1e-5 s; where there is no single rigid motion the run with an eighth of the step; stacked: the \
                energy that the force puts in",
    right: "stiff ones: outermost point at most the series of E/10, E, 10E (the distance from rigid goes as 1/E), the series of halved steps \
            and the rounding EA ε_mach |u|/l beside the force of 50 N off. Started flat, and past the singular position: at most the series of \
            halved steps from the run with an eighth of the step; balance at most n(2 ε_mach + Newton's tolerance for each unknown). Stacked: straight to \
            1e-12 m, the balance kept, and the force's point farthest between FL/EA, about which it vibrates, and 2FL/EA down, as Fd ≥ ½(EA/L)d². Or refused by name.",
    trials,
};

/// Table 2: length, section, density; and the force.
const L: f64 = 2.0;
const H: f64 = 0.02;
const RHO: f64 = 2750.0;
const F: f64 = 50.0;
const COUNT: usize = 3;
const TOLERANCE: f64 = 1e-14;
const DEGREES: f64 = std::f64::consts::PI / 180.0;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for factor in [1e2, 1e4, 1e6, 1e8] {
        let run = move || beside_rigid(80.0, 3.5, factor);
        trials.push(Trial::new("driven through the flat position, to 3.5 s", factor, run).expect(until(1e6, factor)));
    }
    let mut alone = |name: &str, angle: f64, end: f64, factor: f64| {
        let motion = Trial::new(format!("{name}, motion"), factor, move || motion(angle, end, factor));
        trials.push(motion.expect(until(1e4, factor)));
        let balance = Trial::new(format!("{name}, balance"), factor, move || balanced(angle, end, factor));
        trials.push(balance.fast(angle == 0.0 && factor == 1.0).expect(until(1e4, factor)));
    };
    for factor in [1.0, 1e2, 1e4, 1e6] {
        alone("started flat, to 1.2 s", 0.0, 1.2, factor);
    }
    alone("driven past 3.03 s, to 3.6 s", 80.0, 3.6, 1.0);
    for factor in [1.0, 1e2, 1e4, 1e6, 1e8] {
        let trial = Trial::new("started stacked, to 0.2 s", factor, move || stacked(factor));
        trials.push(trial.fast(factor == 1.0).expect(until(1e6, factor)));
    }
    Ok(trials)
}

/// A result up to a stiffness, and then one or a refusal.
fn until(most: f64, factor: f64) -> Expected {
    if factor <= most { Expected::Result } else { Expected::ResultOrRefusal }
}

/// The scissors at an angle that the built-in ones need not have.
fn scissors(angle: f64, factor: f64, step: f64, end: f64) -> Result<Scene> {
    let mut scene = Scissors { elements: 2, ..Scissors::new(COUNT) }.scene()?;
    let (sin, cos) = (angle * DEGREES).sin_cos();
    for (name, point) in &mut scene.points {
        let k = name[1..].parse::<f64>().unwrap_or(f64::NAN) - 1.0;
        let cos = if angle == 90.0 { 0.0 } else { cos };
        *point = [k * L * cos, if name.starts_with('a') { L * sin } else { 0.0 }];
    }
    scene.material.youngs_modulus *= factor;
    scene.time.newton_tolerance = TOLERANCE;
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, step, end);
    scene.output.interval = Some(0.05);
    let probe = scene.probes.iter().find(|probe| probe.point.as_deref() == Some("a4")).cloned();
    scene.probes = probe.into_iter().collect();
    scene.probes.iter_mut().for_each(|probe| probe.of = vec![Quantity::Position]);
    Ok(scene)
}

fn a4(scene: &Scene, run: &Run) -> Path {
    scene.probes.first().map(|probe| positions(run, &probe.name)).unwrap_or_default()
}

/// The outermost upper point of the rigid mechanism at the times that rows have.
fn rigid(angle: f64, rows: usize) -> Path {
    let mass = RHO * L * H * H;
    // θ'' of θ and θ'.
    let acceleration = |theta: f64, rate: f64| {
        let (sin, cos) = theta.sin_cos();
        let (mut inertia, mut slope) = (0.0, 0.0);
        for k in 0..COUNT {
            let arm = (k as f64 + 0.5) * L;
            inertia += 2.0 * mass * ((arm * sin).powi(2) + (0.5 * L * cos).powi(2) + (L * L + H * H) / 12.0);
            slope += 4.0 * mass * sin * cos * (arm * arm - 0.25 * L * L);
        }
        (-F * L * cos - 0.5 * slope * rate * rate) / inertia
    };
    let (mut theta, mut rate, dt, steps) = (angle * DEGREES, 0.0, 1e-5, 5000);
    let mut path = Vec::new();
    for step in 0..=(rows - 1) * steps {
        if step % steps == 0 {
            path.push([COUNT as f64 * L * f64::cos(theta), L * f64::sin(theta)]);
        }
        let (k1, l1) = (rate, acceleration(theta, rate));
        let (k2, l2) = (rate + 0.5 * dt * l1, acceleration(theta + 0.5 * dt * k1, rate + 0.5 * dt * l1));
        let (k3, l3) = (rate + 0.5 * dt * l2, acceleration(theta + 0.5 * dt * k2, rate + 0.5 * dt * l2));
        let (k4, l4) = (rate + dt * l3, acceleration(theta + dt * k3, rate + dt * l3));
        theta += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        rate += dt / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    path
}

const STEP: f64 = 1e-3;
/// Where the distance from the rigid mechanism is to be seen beside that of the step.
const SHORT: f64 = 2.5e-4;

fn beside_rigid(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, SHORT, end)?;
    let (own, step) = richardson::in_steps(&scene, 2, |run| a4(&scene, run))?;
    let path = a4(&scene, &own);
    let with = |factor: f64| Ok::<_, Error>(a4(&scene, &run(&scissors(angle, factor, SHORT, end)?)?));
    let (softer, stiffer): (Path, Path) = (with(0.1 * factor)?, with(10.0 * factor)?);
    // The force EA ε_mach |u|/l, |u| ≤ 4 m in elements of 1 m, beside the one of 50 N, over the way.
    let rounding = EPS * 4.0 * scene.material.youngs_modulus * H * H / F * 2.0 * L;
    // Steps and rounding make as much of each run: terms below that say nothing of the order.
    let series = Halving::with(largest(&softer, &path), largest(&path, &stiffer), 0.1);
    let model = series.above(2.0 * (step.bound() + rounding)).bound() - series.first;
    let (step, vibrations) = if step.ratio < 1.0 { (step, 0.0) } else { (step.above(2.0 * model), 2.0 * model) };
    Ok(Finding {
        error: largest(&path, &rigid(angle, path.len())),
        bound: model + step.bound() + vibrations + rounding,
        why: format!(
            "flexible {model:.1e} (E/10 {:.1e}, 10E {:.1e}), step {step}, vibrations {vibrations:.1e}, rounding {rounding:.1e}",
            series.first, series.second
        ),
        size: 2.0 * L,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

fn motion(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, STEP, end)?;
    let (own, step) = richardson::in_steps(&scene, 2, |run| a4(&scene, run))?;
    let finest = run(&scissors(angle, factor, STEP / 8.0, end)?)?;
    let rounding = EPS * 4.0 * scene.material.youngs_modulus * H * H / F * 2.0 * L;
    Ok(Finding {
        error: largest(&a4(&scene, &own), &a4(&scene, &finest)),
        bound: step.bound() + rounding,
        why: format!("step {step}, rounding {rounding:.1e}"),
        size: 2.0 * L,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

/// What the balance may be, of the energy put in.
fn drift(scene: &Scene, own: &Run) -> Result<f64> {
    let unknowns = Structure::planned(scene, &Plan::of(scene))?.size() as f64;
    Ok(own.counts.steps as f64 * (2.0 * EPS + unknowns * scene.time.newton_tolerance))
}

fn balanced(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, STEP, end)?;
    let own = run(&scene)?;
    let bound = drift(&scene, &own)?;
    Ok(Finding {
        error: largest_of(&own, "energy.balance") / largest_of(&own, "energy.input"),
        bound,
        why: format!("{} steps", own.counts.steps),
        size: 1.0,
        rounding: bound,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

fn stacked(factor: f64) -> Result<Finding> {
    let mut scene = scissors(90.0, factor, 1e-4, 0.2)?;
    let a1 = scene.forces.first().map(|force: &Force| force.point.clone()).unwrap_or_default();
    scene.probes[0].point = Some(a1);
    (scene.output.interval, scene.time.newton_tolerance) = (None, 1e-12);
    let own = run(&scene)?;
    let path = a4(&scene, &own);
    let sideways = path.iter().map(|[x, _]| x.abs()).fold(0.0, f64::max);
    let down = path.iter().map(|[_, y]| (y - L).abs()).fold(0.0, f64::max);
    let short = F * L / (scene.material.youngs_modulus * H * H);
    let balance = largest_of(&own, "energy.balance") / largest_of(&own, "energy.input");
    // Straight to rounding, and the balance kept: what is not is an error of any size.
    let kept = sideways <= 1e-12 && balance <= drift(&scene, &own)?;
    Ok(Finding {
        // From the middle between the static shortening, about which the end vibrates, and twice that.
        error: if kept { (down - 1.5 * short).abs() } else { f64::INFINITY },
        // The output rounds a place of 2 m.
        bound: 0.5 * short + 2.0 * short * balance + 2.0 * EPS,
        why: format!(
            "FL/EA = {short:.1e}, d {:.2} times that; sideways {sideways:.1e} m, balance {balance:.1e}",
            down / short
        ),
        size: 2.0 * short,
        rounding: 2.0 * EPS,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
