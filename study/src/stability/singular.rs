//! Mechanisms that start in singular positions, or move through them.
//!
//! **Stiff ones** are compared with the rigid mechanism, from which an elastic one is C/E away. E/10, E and 10E are a series, each term at
//! most the observed ratio of the last, or a tenth. Added are the series of halved steps, and the rounding EA ε_mach |u|/l relative to the
//! force of 50 N. Vibrations of stiff rods that no step resolves are a part of the effect of E, and out of phase twice of it: terms of
//! halved steps below that need not shrink. Then the series is that of order two, and the vibrations are added.
//!
//! **Without a unique rigid motion** (started flat, all pins of one end are at one point, and each pair of rods may turn about it), and past
//! the singular position, an elastic mechanism still has a unique one. It is compared with the run with an eighth of the step, from which
//! it is at most the series of halved steps away. Its balance is a row of its own.
//!
//! **Stacked**, all rods lie on each other and the force acts along them: the perfect structure stays straight and is compressed. The two
//! rods of each scissor share only their middle, so that the force goes along half of a1–b2 and half of b1–a2, in series, and the rest is
//! attached as mass. The force's point moves down by d, by which this path is shortened; its strain energy is at least ½(EA/L)d². The work
//! Fd is strain and kinetic energy: Fd ≥ ½(EA/L)d², d ≤ 2FL/EA, whatever waves there are. Undamped, the point vibrates about its rest
//! position, FL/EA down, so that its largest d is at least that.
//!
//! **Balance.** Each of n steps rounds position and velocity once, 2n ε_mach. Newton may leave its tolerance times the largest force in each
//! of the unknowns; a force transmits at most the total energy put in from one part to another in a step.

use super::prelude::*;
use super::richardson::{self, Series};
use ancf::internals::structure::Structure;

pub const CASE: Case = Case {
    name: "singular-mechanism",
    parameter: "E over Table 2's",
    unit: "m (balance: of the energy put in)",
    reference: "the rigid mechanism: M(θ)θ'' + ½M'θ'² = −FL cos θ with M = Σ 2m[((k + ½)L sin θ)² + (½L cos θ)² + (L² + h²)/12], by the method of \
                Runge and Kutta, steps of 1e-5 s; without a unique rigid motion the run with an eighth of the step; stacked: the energy that the \
                force puts in",
    right: "stiff ones: error of the outermost point at most the series of E/10, E, 10E (the distance from rigid is as 1/E), the series of halved \
            steps and the rounding EA ε_mach |u|/l relative to the force of 50 N. Started flat, and past the singular position: at most the series \
            of halved steps from the run with an eighth of the step; balance at most n(2 ε_mach + Newton's tolerance for each unknown). Stacked: \
            straight to 1e-12 m, the balance conserved, and the force's point at its lowest between FL/EA, about which it vibrates, and 2FL/EA \
            down, as Fd ≥ ½(EA/L)d². Or refused, with the names of the parts.",
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

fn trials() -> Vec<Trial> {
    let up_to = |most: f64, factor: f64| Expected::result_if(factor <= most);
    let mut trials = Vec::new();
    for factor in [1e2, 1e4, 1e6, 1e8] {
        let run = move || beside_rigid(80.0, 3.5, factor);
        trials.push(Trial::new("driven through the flat position, to 3.5 s", factor, run).expect(up_to(1e6, factor)));
    }
    let mut alone = |name: &str, angle: f64, end: f64, factor: f64| {
        let motion = Trial::new(format!("{name}, motion"), factor, move || motion(angle, end, factor));
        let balance = Trial::new(format!("{name}, balance"), factor, move || balanced(angle, end, factor));
        let fast = balance.fast(angle == 0.0 && factor == 1.0);
        trials.extend([motion, fast].map(|trial| trial.expect(up_to(1e4, factor))));
    };
    for factor in [1.0, 1e2, 1e4, 1e6] {
        alone("started flat, to 1.2 s", 0.0, 1.2, factor);
    }
    alone("driven past 3.03 s, to 3.6 s", 80.0, 3.6, 1.0);
    for factor in [1.0, 1e2, 1e4, 1e6, 1e8] {
        let trial = Trial::new("started stacked, to 0.2 s", factor, move || stacked(factor));
        trials.push(trial.fast(factor == 1.0).expect(up_to(1e6, factor)));
    }
    trials
}

/// The scissors at any angle, also at those that the built-in ones refuse.
fn scissors(angle: f64, factor: f64, step: f64, end: f64) -> Result<Scene> {
    let scene = Scissors { elements: 2, ..Scissors::new(COUNT) }.scene()?;
    let mut scene = scene.solved(Method::EnergyMomentum, step, end).newton(TOLERANCE).rows_every(0.05);
    let (sin, cos) = (angle * DEGREES).sin_cos();
    let cos = if angle == 90.0 { 0.0 } else { cos };
    for (name, point) in &mut scene.points {
        let k = name[1..].parse::<f64>().unwrap_or(f64::NAN) - 1.0;
        *point = [k * L * cos, if name.starts_with('a') { L * sin } else { 0.0 }];
    }
    scene.material.youngs_modulus *= factor;
    scene.probes = vec![point_probe("a4", &[Quantity::Position])];
    Ok(scene)
}

fn a4(run: &Run) -> Path {
    positions(run, "a4")
}

/// The outermost upper point of the rigid mechanism at the times of the rows.
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
/// Short, so that the distance from the rigid mechanism is not hidden by that of the step.
const SHORT: f64 = 2.5e-4;

/// Rounding of positions, m: the force EA ε_mach |u|/l, |u| ≤ 4 m in elements of 1 m, relative to 50 N, over the way.
fn rounding(scene: &Scene) -> f64 {
    f64::EPSILON * 4.0 * scene.material.youngs_modulus * H * H / F * 2.0 * L
}

fn beside_rigid(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, SHORT, end)?;
    let (own, step) = richardson::in_steps(&scene, a4)?;
    let path = a4(&own);
    let with = |factor: f64| Ok::<_, Error>(a4(&run(&scissors(angle, factor, SHORT, end)?)?));
    let (softer, stiffer): (Path, Path) = (with(0.1 * factor)?, with(10.0 * factor)?);
    let rounding = rounding(&scene);
    // Steps and rounding contribute as much to each run: terms below that show no order.
    let series = Series::with(largest_distance(&softer, &path), largest_distance(&path, &stiffer), 0.1);
    let model = series.above(2.0 * (step.bound() + rounding)).bound() - series.first;
    let (step, vibrations) = if step.ratio < 1.0 { (step, 0.0) } else { (step.above(2.0 * model), 2.0 * model) };
    let error = largest_distance(&path, &rigid(angle, path.len()));
    let why = format!(
        "flexible {model:.1e} (E/10 {:.1e}, 10E {:.1e}), step {step}, vibrations {vibrations:.1e}, rounding {rounding:.1e}",
        series.first, series.second
    );
    Ok(Finding {
        error,
        bound: model + step.bound() + vibrations + rounding,
        why,
        size: 2.0 * L,
        rounding,
        ..Finding::of(own)
    })
}

fn motion(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, STEP, end)?;
    let (own, step) = richardson::in_steps(&scene, a4)?;
    let finest = run(&scissors(angle, factor, STEP / 8.0, end)?)?;
    let rounding = rounding(&scene);
    let error = largest_distance(&a4(&own), &a4(&finest));
    let why = format!("step {step}, rounding {rounding:.1e}");
    Ok(Finding { error, bound: step.bound() + rounding, why, size: 2.0 * L, rounding, ..Finding::of(own) })
}

/// Balance over the energy put in, and its bound.
fn balance(scene: &Scene, own: &Run) -> Result<(f64, f64)> {
    let unknowns = Structure::planned(scene, &Plan::of(scene))?.size() as f64;
    let bound = own.counts.steps as f64 * (2.0 * f64::EPSILON + unknowns * scene.time.newton_tolerance);
    Ok((largest(own, "energy.balance") / largest(own, "energy.input"), bound))
}

fn balanced(angle: f64, end: f64, factor: f64) -> Result<Finding> {
    let scene = scissors(angle, factor, STEP, end)?;
    let own = run(&scene)?;
    let (error, bound) = balance(&scene, &own)?;
    Ok(Finding { error, bound, why: format!("{} steps", own.counts.steps), rounding: bound, ..Finding::of(own) })
}

fn stacked(factor: f64) -> Result<Finding> {
    let mut scene = scissors(90.0, factor, 1e-4, 0.2)?.newton(1e-12);
    scene.probes = vec![point_probe("a1", &[Quantity::Position])];
    scene.output.interval = None;
    let own = run(&scene)?;
    let path = positions(&own, "a1");
    let sideways = path.iter().map(|[x, _]| x.abs()).fold(0.0, f64::max);
    let down = path.iter().map(|[_, y]| (y - L).abs()).fold(0.0, f64::max);
    let short = F * L / (scene.material.youngs_modulus * H * H);
    let (balance, most) = balance(&scene, &own)?;
    // Anything but straight to rounding and a conserved balance is an error of any size.
    let holds = sideways <= 1e-12 && balance <= most;
    // From the middle between the static shortening, about which the end vibrates, and twice that.
    let error = if holds { (down - 1.5 * short).abs() } else { f64::INFINITY };
    // The output rounds a position of 2 m.
    let bound = 0.5 * short + 2.0 * short * balance + 2.0 * f64::EPSILON;
    let why =
        format!("FL/EA = {short:.1e}, d {:.2} of it; sideways {sideways:.1e} m, balance {balance:.1e}", down / short);
    Ok(Finding { error, bound, why, size: 2.0 * short, rounding: 2.0 * f64::EPSILON, ..Finding::of(own) })
}
