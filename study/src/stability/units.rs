//! Other units: the same scene with its numbers in other systems. Every tolerance has to be dimensionless.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, builtin, positions};
use crate::error::Result;
use crate::error_time::samples::largest;
use ancf::model::{Constraints, Element, Material, Method, Scene, Scissors, Section, Temperature, ThermalModel};
use ancf::run::run;

pub const CASE: Case = Case {
    name: "units",
    parameter: "m in the unit of length",
    unit: "of the largest position",
    reference: "the same scene in m, kg, s",
    right: "positions equal to (16 + 2n) κ ε_mach of the largest in n steps: eight numbers of the scene are rounded as they are converted, half of \
            ε_mach each, and the tip goes with none of them by more than its fourth power (L⁴); each step rounds place and velocity once in \
            each run. κ is what the tip does with a relative change of E, if more than 1: measured with 1e-6 (a heat shock pumps bending, in \
            which small changes grow). Rounding may end an iteration one earlier or later, with 1e-12 of the largest force left, \
            which moves a mass by ½ 1e-12 F/m T², F/m T² ≤ 6 m (EAαΔT of the heat shock): 3e-12. A tolerance that has a dimension, or \
            compares a slope with a length, would end it elsewhere. Other units only rescale, so that this goes on until numbers leave the range of f64: w h⁵ of a section.",
    trials,
};

/// A system of units: numbers of metres, kilograms and seconds in it.
#[derive(Clone, Copy)]
struct Units {
    name: &'static str,
    length: f64,
    mass: f64,
    time: f64,
}

const SYSTEMS: [Units; 12] = [
    Units { name: "mm, t, s", length: 1e3, mass: 1e-3, time: 1.0 },
    Units { name: "km, Gg, s", length: 1e-3, mass: 1e-6, time: 1.0 },
    Units { name: "mm, kg, ms", length: 1e3, mass: 1.0, time: 1e3 },
    Units { name: "Å, u, fs", length: 1e10, mass: 6.022e26, time: 1e15 },
    rescaled(1e-25),
    rescaled(1e25),
    rescaled(1e-50),
    rescaled(1e50),
    rescaled(1e-75),
    rescaled(1e75),
    rescaled(1e-100),
    rescaled(1e100),
];

/// Nobody's units.
const fn rescaled(length: f64) -> Units {
    Units { name: "kg, s", length, mass: 1.0, time: 1.0 }
}

type Made = fn() -> Result<Scene>;
const SCENES: [(&str, &str, Made); 10] = [
    ("pendulum, energy-momentum", "tip", || pendulum("pendulum-flexible", Method::EnergyMomentum, Element::Ancf)),
    ("pendulum, generalized-alpha", "tip", || pendulum("pendulum-flexible", Method::GeneralizedAlpha, Element::Ancf)),
    ("pendulum, multipliers", "tip", || {
        let scene = pendulum("pendulum-flexible", Method::GeneralizedAlpha, Element::Ancf)?;
        Ok(Scene { constraints: Constraints::Multipliers, ..scene })
    }),
    ("pendulum, gauss, euler-bernoulli", "tip", || {
        pendulum("pendulum-flexible", Method::Gauss, Element::EulerBernoulli)
    }),
    ("pendulum, gauss-adaptive", "tip", || pendulum("pendulum-flexible", Method::GaussAdaptive, Element::Ancf)),
    ("pendulum, nystrom-adaptive", "tip", || pendulum("pendulum-flexible", Method::NystromAdaptive, Element::Ancf)),
    ("pendulum heated, relaxed, gauss", "tip", || pendulum("pendulum-2d-relaxed", Method::Gauss, Element::Ancf)),
    ("pendulum heated suddenly, energy-momentum", "tip", || {
        pendulum("pendulum-2d", Method::EnergyMomentum, Element::Ancf)
    }),
    ("scissors heated, multipliers", "a4", || {
        let scissors = Scissors { elements: 2, model: ThermalModel::TwoD, ..Scissors::new(3) };
        let mut scene = scissors.scene()?;
        (scene.time.method, scene.time.step, scene.time.end) = (Method::GeneralizedAlpha, 1e-3, 0.3);
        scene.constraints = Constraints::Multipliers;
        Ok(scene)
    }),
    ("cantilever, statics", "tip", || builtin("cantilever")),
];

fn pendulum(name: &'static str, method: Method, element: Element) -> Result<Scene> {
    let mut scene = builtin(name)?;
    (scene.rods[0].element, scene.rods[0].elements) = (element, 4);
    (scene.time.method, scene.time.step, scene.time.end) = (method, 1e-3, 0.2);
    Ok(scene)
}

fn trials() -> Result<Vec<Trial>> {
    let trials = SCENES.into_iter().flat_map(|(name, probe, made)| {
        SYSTEMS.map(|units| {
            let fast = units.length == 1e-3 || units.length == 1e-50 || units.time == 1e15;
            // Statics may fail from 1e19 on: see the README.
            let expected = match units.length {
                1e-3..=1e10 => Expected::Result,
                1e-25..=1e50 => Expected::ResultOrRefusal,
                _ => Expected::Refusal(&["section.height", "fifth power"]),
            };
            let trial =
                Trial::new(format!("{name}; {}", units.name), units.length, move || measure(probe, made, units));
            trial.fast(fast).expect(expected)
        })
    });
    Ok(trials.collect())
}

/// Newton's, of the largest force.
const TOLERANCE: f64 = 1e-12;

/// Of E, to see what becomes of small changes.
const CHANGE: f64 = 1e-6;

fn measure(probe: &'static str, made: Made, units: Units) -> Result<Finding> {
    let mut scene = made()?;
    scene.time.newton_tolerance = TOLERANCE;
    let (ours, run) = (run(&scene)?, run(&converted(&scene, units))?);
    let ours = positions(&ours, probe);
    let path: Path = positions(&run, probe).iter().map(|point| point.map(|x| x / units.length)).collect();
    let size = largest(&ours, &vec![[0.0; 2]; ours.len()]);
    let mut stiffer = scene.clone();
    stiffer.material.youngs_modulus *= 1.0 + CHANGE;
    let kappa = (largest(&ours, &positions(&self::run(&stiffer)?, probe)) / size / CHANGE).max(1.0);
    let bound = (16.0 + 2.0 * run.counts.steps as f64) * kappa * EPS + 3.0 * TOLERANCE;
    Ok(Finding {
        error: largest(&ours, &path) / size,
        bound,
        why: format!("{} steps, κ = {kappa:.1}", run.counts.steps),
        size: 1.0,
        rounding: bound,
        counts: run.counts,
        // Heat that comes suddenly is warned of in all units.
        warnings: Vec::new(),
        beside: None,
    })
}

/// A scene with its numbers in other units; temperatures stay.
fn converted(scene: &Scene, units: Units) -> Scene {
    let Units { length, mass, time, .. } = units;
    let mut scene = scene.clone();
    let material = |material: &mut Material| {
        material.youngs_modulus *= mass / (length * time * time);
        material.rho *= mass / length.powi(3);
    };
    let section = |section: &mut Section| {
        section.height *= length;
        section.width *= length;
    };
    let temperature = |temperature: &mut Temperature| temperature.history.iter_mut().for_each(|pair| pair[0] *= time);
    material(&mut scene.material);
    section(&mut scene.section);
    scene.temperature.iter_mut().for_each(temperature);
    for rod in &mut scene.rods {
        rod.material.iter_mut().for_each(material);
        rod.section.iter_mut().for_each(section);
        rod.temperature.iter_mut().for_each(temperature);
    }
    scene.points.values_mut().for_each(|point| *point = point.map(|x| x * length));
    for force in &mut scene.forces {
        force.force = force.force.map(|f| f * mass * length / (time * time));
        force.history.iter_mut().flatten().for_each(|pair| pair[0] *= time);
    }
    scene.gravity = scene.gravity.map(|g| g * length / (time * time));
    if scene.time.method != Method::Static {
        (scene.time.end, scene.time.step) = (scene.time.end * time, scene.time.step * time);
    }
    scene.time.tolerance *= length;
    scene.output.interval = scene.output.interval.map(|interval| interval * time);
    scene
}
