//! Elements that are pressed to nothing: an error with rod, element and time, where the equations would go on with the mirror image.

use std::f64::consts::PI;

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{EPS, builtin, positions};
use crate::error::Result;
use crate::run::run;
use crate::scene::{Direction, Element, Force, Method, Support};

pub const CASE: Case = Case {
    name: "collapsed-element",
    parameter: "force over EA",
    unit: "of L",
    reference: "the pressed rod: F/EA = ½(1 − s²) s, at most 1/√27 = 0.192 at s = 1/√3 (Green–Lagrange); F/EA = 1 − s, at most 1 \
                (Euler–Bernoulli)",
    right: "statics below the largest force: stretch off by at most 50 ε_mach times the slope ds/dF of that curve, which grows without bound \
            towards the largest force. Above it there is no equilibrium but that of the mirror image: refused, as collapsed (det J ≤ 0 \
            at a quadrature point; rod, element, time) or as not found. Suddenly, 0.01 EA shortens by twice the static shortening at \
            most, with a twentieth for the mesh; 3 EA is refused as collapsed.",
    trials,
};

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
            for force in [0.01, 3.0] {
                let expected = if force == 0.01 {
                    Expected::Result
                } else {
                    Expected::Refusal(&["of the rod `", "has collapsed at t ="])
                };
                let trial =
                    Trial::new(format!("sudden, {method}, {element}"), force, move || crush(method, element, force));
                trials.push(trial.fast(true).expect(expected));
            }
        }
    }
    Ok(trials)
}

/// A rod that cannot bend, as it is higher than long and its end slides, under a force along it.
fn press(element: Element, force: f64) -> Result<Finding> {
    let mut scene = builtin("cantilever")?;
    (scene.material.youngs_modulus, scene.rods[0].element, scene.rods[0].elements) = (2e8, element, 2);
    (scene.section.height, scene.section.width) = (0.1, 0.1);
    (scene.time.load_steps, scene.time.newton_tolerance) = (20, 1e-15);
    let slide = Support { point: "a".into(), fix: Vec::new(), slide: Some([1.0, 0.0]), clamp: Some("rod".into()) };
    scene.supports.push(slide);
    scene.forces[0].force = [-force * 2e8 * 0.01, 0.0];
    let run = run(&scene)?;
    let x = positions(&run, "tip").last().map_or(f64::NAN, |[x, _]| *x);
    let stretch = stretch(element, force);
    let slope = if element == Element::Ancf { 1.0 / (1.5 * stretch * stretch - 0.5) } else { 1.0 };
    let bound = 50.0 * EPS * (1.0 + slope);
    Ok(Finding {
        error: (x - stretch).abs(),
        bound,
        why: format!("stretch {stretch:.6}"),
        size: Some(1.0),
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

/// The same rod under a force that comes suddenly, in motion.
fn crush(method: Method, element: Element, force: f64) -> Result<Finding> {
    let mut scene = builtin("pendulum-flexible")?;
    scene.gravity = [0.0; 2];
    (scene.rods[0].element, scene.rods[0].elements) = (element, 2);
    let guide = Support { point: "a".into(), fix: vec![Direction::Y], slide: None, clamp: Some("rod".into()) };
    scene.supports[0].clamp = Some("rod".into());
    scene.supports.push(guide);
    let load = [-force * 2e8 * 4e-4, 0.0];
    scene.forces.push(Force { point: "a".into(), force: load, history: None });
    // As long as a wave takes to and fro three times.
    (scene.time.method, scene.time.step, scene.time.end) = (method, 2e-5, 0.04);
    scene.output.interval = Some(2e-4);
    let run = run(&scene)?;
    // The least and the most that it is shortened, of twice the static shortening.
    let outside = positions(&run, "tip").into_iter().map(|[x, y]| {
        let shortened = (1.0 - x) / (2.0 * (1.0 - stretch(element, force)));
        (shortened - 0.5).abs() - 0.5 + y.abs()
    });
    Ok(Finding {
        error: outside.fold(0.0, f64::max),
        bound: 0.05,
        why: "shortened by 0 … 2 times the static, ± a twentieth for F/EA of the second order and the mesh".into(),
        size: None,
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}
