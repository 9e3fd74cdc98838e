//! Elements under compression to zero length: an error with rod, element and time, where the equations would continue with the mirror image.

use std::f64::consts::PI;

use super::prelude::*;
use super::richardson::Series;

pub const CASE: Case = Case {
    name: "collapsed-element",
    parameter: "force over EA",
    unit: "of L",
    reference: "the compressed rod: F/EA = ½(1 − s²) s, at most 1/√27 = 0.192 at s = 1/√3 (Green–Lagrange); F/EA = 1 − s, at most 1 \
                (Euler–Bernoulli)",
    right: "statics below the largest force: error of the stretch at most (10 ε_mach + 1e-15) F/EA (twenty roundings of the force, and Newton's \
            tolerance) times the slope ds/dF of that curve, which grows without bound towards the largest force, and ε_mach. Above it only the \
            mirror image is in equilibrium: refused, as collapsed (det J ≤ 0 at a quadrature point; rod, element, time) or as not found. Sudden \
            force of 0.001 EA: the end follows d'Alembert's wave, 2FL/EA back and forth in 4L/c, with an error of at most the series of halved \
            elements and steps and the wave's speed at finite strain, c √(1 + 3ε), ε ≤ 2F/EA, over the distance; 3 EA is refused as collapsed.",
    trials,
};

/// Newton's, relative to the largest force.
const TOLERANCE: f64 = 1e-15;

const MODULUS: f64 = 2e8;

fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for element in ELEMENTS {
        let most = if element == Element::Ancf { 1.0 / 27f64.sqrt() } else { 1.0 };
        for share in [0.01, 0.1, 0.5, 0.9, 0.99, 1.01, 1.5, 3.0, 10.0] {
            let force = share * most;
            // A column that can be shortened buckles if x(1 − x) > 4π²EI/(EAL²), x = F/EA: not when little of it is left, but on
            // the way there.
            let worst = force.min(0.5);
            let buckles = worst * (1.0 - worst) > 4.0 * PI * PI * 0.01 / 12.0;
            let expected = match share {
                1.0.. => Expected::Refusal(&["of the load|has collapsed"]),
                _ if buckles => Expected::Warning(&["unstable"]),
                _ => Expected::Result,
            };
            let trial = Trial::new(format!("statics, {element}"), force, move || press(element, force));
            trials.push(trial.fast(true).expect(expected));
        }
        for method in
            [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Explicit, Method::Gauss, Method::NystromAdaptive]
        {
            let name = format!("sudden, {method}, {element}");
            let small = Trial::new(name.clone(), SMALL, move || wave(method, element));
            let crush = Trial::new(name, 3.0, move || Ok(Finding::of(sudden(method, element, 3.0, 2, 2e-5)?)));
            let refused = Expected::Refusal(&["of the rod `rod` has collapsed at t =", "element "]);
            trials.extend([small.fast(method == Method::Explicit), crush.fast(true).expect(refused)]);
        }
    }
    trials
}

/// A rod between guides, too thick to buckle easily, under a force along it.
fn press(element: Element, force: f64) -> Result<Finding> {
    let mut scene = cantilever(element, 2, 0.1)?.newton(TOLERANCE);
    (scene.material.youngs_modulus, scene.time.load_steps) = (MODULUS, 20);
    let slide = Support { point: "a".into(), fix: Vec::new(), slide: Some([1.0, 0.0]), clamp: Some("rod".into()) };
    scene.supports.push(slide);
    scene.forces[0].force = [-force * MODULUS * 0.01, 0.0];
    let own = run(&scene)?;
    let stretch = stretch(element, force);
    let slope = if element == Element::Ancf { 1.0 / (1.5 * stretch * stretch - 0.5) } else { 1.0 };
    let bound = (10.0 * f64::EPSILON + TOLERANCE) * force * slope + f64::EPSILON;
    let error = (last_tip(&own)[0] - stretch).abs();
    let why = format!("stretch {stretch:.6}");
    Ok(Finding { error, bound, why, rounding: bound, ..Finding::of(own) })
}

/// The larger root, by Newton's iteration from the unloaded rod.
fn stretch(element: Element, force: f64) -> f64 {
    if element == Element::EulerBernoulli {
        return 1.0 - force;
    }
    (0..60).fold(1.0, |s: f64, _| s - (0.5 * (1.0 - s * s) * s - force) / (0.5 - 1.5 * s * s))
}

/// Small relative to EA, so that the wave is nearly linear.
const SMALL: f64 = 1e-3;
/// The wave travels back and forth three times.
const END: f64 = 0.04;

/// The rod in motion under a sudden force, relative to EA.
fn sudden(method: Method, element: Element, force: f64, elements: usize, step: f64) -> Result<Run> {
    let mut scene = pendulum(element, elements)?.solved(method, step, END).rows_every(2e-4);
    scene.gravity = [0.0; 2];
    scene.supports[0].clamp = Some("rod".into());
    let guide = Support { point: "a".into(), fix: vec![Direction::Y], slide: None, clamp: Some("rod".into()) };
    scene.supports.push(guide);
    scene.forces.push(Force { point: "a".into(), force: [-force * MODULUS * 4e-4, 0.0], history: None });
    if method.is_adaptive() {
        scene.time.tolerance = 0.1 * step * force;
    }
    Ok(run(&scene)?)
}

/// Path of the end, relative to the length: d'Alembert's wave grows as F/EA · ct until it is back at 2L/c, and then decreases alike.
fn wave(method: Method, element: Element) -> Result<Finding> {
    let make = |finer: usize| sudden(method, element, SMALL, 8 * finer, 4e-5 / finer as f64);
    let (own, half, quarter) = (make(1)?, tip(&make(2)?), tip(&make(4)?));
    // The path has a kink: order one.
    let series = Series::new(largest_distance(&tip(&own), &half), largest_distance(&half, &quarter), 1);
    let speed = (MODULUS / 7750.0).sqrt();
    let expected = |t: f64| {
        let way = (speed * t).rem_euclid(4.0);
        [1.0 - SMALL * way.min(4.0 - way), 0.0]
    };
    let expected: Path = column(&own, "t").into_iter().map(expected).collect();
    // F/EA · δ(ct), δc/c ≤ 3/2 · 2 F/EA.
    let faster = SMALL * speed * END * 3.0 * SMALL;
    let error = largest_distance(&tip(&own), &expected);
    let why = format!("elements and steps {series}, speed of the wave {faster:.1e}");
    Ok(Finding { error, bound: series.bound() + faster, why, size: 2.0 * SMALL, ..Finding::of(own) })
}
