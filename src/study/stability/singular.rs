//! Mechanisms that start in, or run through, positions where they are singular.

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{EPS, Path, builtin, largest as largest_of, positions};
use crate::error::Result;
use crate::run::run;
use crate::scene::{Force, Method, Quantity, Scene, Scissors};
use crate::study::error_time::samples::largest;

pub const CASE: Case = Case {
    name: "singular-mechanism",
    parameter: "E over Table 2's",
    unit: "m (balance: of the energy put in)",
    reference: "the rigid mechanism: M(θ)θ'' + ½M'θ'² = −FL cos θ with M = Σ 2m[((k + ½)L sin θ)² + (½L cos θ)² + (L² + h²)/12], Runge and \
                Kutta's method, steps of 1e-5 s",
    right: "stiff ones: outermost point within 2/9 of what a tenth of E changes (the distance from rigid goes as 1/E) and twice what half \
            the step changes, and the rounding EA ε_mach |u|/l beside the force of 50 N. Started flat the rigid mechanism has no single motion: all pins of one end are at one point, and each pair of \
            rods may turn about it. What an elastic one does there, and past its singular position, has no other reference than itself: the \
            balance at most 1e-8 of the energy put in, and beside it the distance from the run with half the step. Or refused by name.",
    trials,
};

/// Table 2: length, section, density; and the force.
const L: f64 = 2.0;
const H: f64 = 0.02;
const RHO: f64 = 2750.0;
const F: f64 = 50.0;
const COUNT: usize = 3;
const DEGREES: f64 = std::f64::consts::PI / 180.0;

fn trials() -> Result<Vec<Trial>> {
    let stiff = |name: &str, angle: f64, end: f64, factor: f64| {
        Trial::new(name, factor, move || beside_rigid(angle, end, factor)).expect(Expected::ResultOrRefusal)
    };
    let balance = |name: &str, angle: f64, end: f64, factor: f64| {
        Trial::new(name, factor, move || balanced(angle, end, factor)).expect(Expected::ResultOrRefusal)
    };
    let mut trials = Vec::new();
    for factor in [1e2, 1e4, 1e6, 1e8] {
        trials.push(stiff("driven through the flat position, to 3.5 s", 80.0, 3.5, factor));
    }
    for factor in [1.0, 1e2, 1e4, 1e6] {
        trials.push(balance("started flat, to 1.2 s", 0.0, 1.2, factor).fast(factor == 1.0));
    }
    trials.push(balance("driven past 3.03 s, to 3.6 s", 80.0, 3.6, 1.0));
    trials.push(Trial::new("flexible, started stacked, to 0.2 s", 1.0, stacked).fast(true));
    Ok(trials)
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
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, step, end);
    scene.output.interval = Some(0.05);
    let probe = scene.probes.iter().find(|probe| probe.point.as_deref() == Some("a4")).cloned();
    scene.probes = probe.into_iter().collect();
    scene.probes.iter_mut().for_each(|probe| probe.of = vec![Quantity::Position]);
    Ok(scene)
}

fn a4(scene: &Scene, run: &crate::run::Run) -> Path {
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

fn beside_rigid(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, STEP, end)?;
    let (own, softer, finer) = (
        run(&scene)?,
        run(&scissors(angle, factor / 10.0, STEP, end)?)?,
        run(&scissors(angle, factor, 0.5 * STEP, end)?)?,
    );
    let path = a4(&scene, &own);
    let model = 2.0 / 9.0 * largest(&path, &a4(&scene, &softer));
    let time = 2.0 * largest(&path, &a4(&scene, &finer));
    // The force EA ε_mach |u|/l, |u| ≤ 4 m in elements of 1 m, beside the one of 50 N, over the way.
    let rounding = EPS * 4.0 * scene.material.youngs_modulus * H * H / F * 2.0 * L;
    Ok(Finding {
        error: largest(&path, &rigid(angle, path.len())),
        bound: model + time + rounding,
        why: format!("flexible {model:.1e}, time {time:.1e}, rounding {rounding:.1e}"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

fn balanced(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, STEP, end)?;
    let (own, finer) = (run(&scene)?, run(&scissors(angle, factor, 0.5 * STEP, end)?)?);
    let beside = Some(largest(&a4(&scene, &own), &a4(&scene, &finer)));
    Ok(Finding {
        error: largest_of(&own, "energy.balance") / largest_of(&own, "energy.input"),
        bound: 1e-8,
        why: "Newton's tolerance, 1e-10 of the largest force, over the path".into(),
        size: Some(1.0),
        counts: own.counts,
        warnings: own.warnings,
        beside,
    })
}

/// All rods on top of one another and the force along them: the perfect structure stays straight and is pressed. The two rods of each
/// scissor share their middle only, so that half of a1–b2 and half of b1–a2 bear the force, one after the other, and the rest hangs on
/// as mass: the static shortening FL/EA, at most twice as it comes suddenly, and no more than twice again for the waves in the mass
/// that hangs on.
fn stacked() -> Result<Finding> {
    let mut scene = scissors(90.0, 1.0, 1e-4, 0.2)?;
    let a1 = scene.forces.first().map(|force: &Force| force.point.clone()).unwrap_or_default();
    scene.probes[0].point = Some(a1);
    let start = builtin("scissors-3")?;
    let own = run(&scene)?;
    let path = a4(&scene, &own);
    let sideways = path.iter().map(|[x, _]| x.abs()).fold(0.0, f64::max);
    let down = path.iter().map(|[_, y]| (y - L).abs()).fold(0.0, f64::max);
    let short = F * L / (start.material.youngs_modulus * H * H);
    let balance = largest_of(&own, "energy.balance") / largest_of(&own, "energy.input");
    // Straight to rounding, and the balance kept: what is not is an error of any size.
    let kept = sideways <= 1e-12 && balance <= 1e-8;
    Ok(Finding {
        error: if kept { down } else { f64::INFINITY },
        bound: 4.0 * short,
        why: format!("FL/EA = {short:.1e}; sideways {sideways:.1e} m, balance {balance:.1e}"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
