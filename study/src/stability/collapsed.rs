//! Elements that are pressed to nothing: an error with rod, element and time, where the equations would go on with the mirror image.

use std::f64::consts::PI;

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, builtin, positions};
use super::richardson::Halving;
use crate::error::{Error, Result};
use crate::error_time::samples::largest;
use ancf::model::{Direction, Element, Force, Method, Scene, Support};
use ancf::run::{Run, run};

pub const CASE: Case = Case {
    name: "collapsed-element",
    parameter: "force over EA",
    unit: "of L",
    reference: "the pressed rod: F/EA = ½(1 − s²) s, at most 1/√27 = 0.192 at s = 1/√3 (Green–Lagrange); F/EA = 1 − s, at most 1 \
                (Euler–Bernoulli)",
    right: "statics below the largest force: stretch off by at most (10 ε_mach + 1e-15) F/EA (twenty roundings of the force, and Newton's tolerance) \
            times the slope ds/dF of that curve, which grows without bound towards the largest force, and ε_mach. Above it there is no \
            equilibrium but that of the mirror image: refused, as collapsed (det J ≤ 0 at a quadrature point; rod, element, time) or as \
            not found. Suddenly, 0.001 EA: the end follows d'Alembert's wave, 2FL/EA to and fro in 4L/c, off by at most what halved \
            elements and steps change (series of three) and by the wave's speed at finite strain, c √(1 + 3ε), ε ≤ 2F/EA, over the way; \
            3 EA is refused as collapsed.",
    trials,
};

/// Newton's, of the largest force.
const TOLERANCE: f64 = 1e-15;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    let most = |element| if element == Element::Ancf { 1.0 / 27f64.sqrt() } else { 1.0 };
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for share in [0.01, 0.1, 0.5, 0.9, 0.99] {
            let force = share * most(element);
            let trial = Trial::new(format!("statics, {element}"), force, move || press(element, force));
            // The column that can be shortened bends out where x(1 − x) > 4π²EI/(EAL²), x = F/EA: not when little of it is left.
            let buckles = force * (1.0 - force) > 4.0 * PI * PI * 0.01 / 12.0;
            let expected = if buckles { Expected::Warning(&["unstable"]) } else { Expected::Result };
            trials.push(trial.fast(true).expect(expected));
        }
        for share in [1.01, 1.5, 3.0, 10.0] {
            let force = share * most(element);
            let trial = Trial::new(format!("statics, {element}"), force, move || press(element, force));
            trials.push(trial.fast(true).expect(Expected::Refusal(&["of the load|has collapsed"])));
        }
        for method in
            [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Explicit, Method::Gauss, Method::NystromAdaptive]
        {
            let name = format!("sudden, {method}, {element}");
            trials
                .push(Trial::new(name.clone(), SMALL, move || wave(method, element)).fast(method == Method::Explicit));
            let crush = move || Ok(run(&sudden(method, element, 3.0, 2, 2e-5)?).map(|_| Finding::default())?);
            let expected = Expected::Refusal(&["of the rod `rod` has collapsed at t =", "element "]);
            trials.push(Trial::new(name, 3.0, crush).fast(true).expect(expected));
        }
    }
    Ok(trials)
}

/// A rod that cannot bend, as it is higher than long and its end slides, under a force along it.
fn press(element: Element, force: f64) -> Result<Finding> {
    let mut scene = builtin("cantilever")?;
    (scene.material.youngs_modulus, scene.rods[0].element, scene.rods[0].elements) = (2e8, element, 2);
    (scene.section.height, scene.section.width) = (0.1, 0.1);
    (scene.time.load_steps, scene.time.newton_tolerance) = (20, TOLERANCE);
    let slide = Support { point: "a".into(), fix: Vec::new(), slide: Some([1.0, 0.0]), clamp: Some("rod".into()) };
    scene.supports.push(slide);
    scene.forces[0].force = [-force * 2e8 * 0.01, 0.0];
    let run = run(&scene)?;
    let x = positions(&run, "tip").last().map_or(f64::NAN, |[x, _]| *x);
    let stretch = stretch(element, force);
    let slope = if element == Element::Ancf { 1.0 / (1.5 * stretch * stretch - 0.5) } else { 1.0 };
    let bound = (10.0 * EPS + TOLERANCE) * force * slope + EPS;
    Ok(Finding {
        error: (x - stretch).abs(),
        bound,
        why: format!("stretch {stretch:.6}"),
        size: 1.0,
        rounding: bound,
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}

/// The larger root, by Newton's iteration from no load.
fn stretch(element: Element, force: f64) -> f64 {
    if element == Element::EulerBernoulli {
        return 1.0 - force;
    }
    let mut s: f64 = 1.0;
    for _ in 0..60 {
        s -= (0.5 * (1.0 - s * s) * s - force) / (0.5 - 1.5 * s * s);
    }
    s
}

/// Small beside EA, so that the wave is nearly linear.
const SMALL: f64 = 1e-3;
/// As long as a wave takes to and fro three times.
const END: f64 = 0.04;

/// The rod under a force, of EA, that comes suddenly, in motion.
fn sudden(method: Method, element: Element, force: f64, elements: usize, step: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    scene.gravity = [0.0; 2];
    (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
    let guide = Support { point: "a".into(), fix: vec![Direction::Y], slide: None, clamp: Some("rod".into()) };
    scene.supports[0].clamp = Some("rod".into());
    scene.supports.push(guide);
    let load = [-force * 2e8 * 4e-4, 0.0];
    scene.forces.push(Force { point: "a".into(), force: load, history: None });
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, END);
    // Of an adaptive method, m.
    scene.time.tolerance = 0.1 * step * force;
    scene.output.interval = Some(2e-4);
    Ok(scene)
}

/// The end's path, of the length: d'Alembert's wave grows as F/EA · ct until it is back at 2L/c, and then goes the same way back.
fn wave(method: Method, element: Element) -> Result<Finding> {
    let make = |finer: usize| Ok::<_, Error>(run(&sudden(method, element, SMALL, 8 * finer, 4e-5 / finer as f64)?)?);
    let (own, half, quarter) = (make(1)?, make(2)?, make(4)?);
    let tip = |run: &Run| positions(run, "tip");
    // A kink in the path: order one.
    let halving = Halving::new(largest(&tip(&own), &tip(&half)), largest(&tip(&half), &tip(&quarter)), 1);
    let speed = (2e8f64 / 7750.0).sqrt();
    let times = own.trajectory.column("t").unwrap_or_default();
    let expected: Path = times
        .iter()
        .map(|t| {
            let way = (speed * t).rem_euclid(4.0);
            [1.0 - SMALL * way.min(4.0 - way), 0.0]
        })
        .collect();
    // F/EA · δ(ct), δc/c ≤ 3/2 · 2 F/EA.
    let faster = SMALL * speed * END * 3.0 * SMALL;
    Ok(Finding {
        error: largest(&tip(&own), &expected),
        bound: halving.bound() + faster,
        why: format!("elements and steps {halving}, speed of the wave {faster:.1e}"),
        size: 2.0 * SMALL,
        rounding: 0.0,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
