//! Systems of units: a scene with its numbers in other units. Every tolerance has to be dimensionless.

use super::prelude::*;
use ancf::model::{Material, Section};

pub const CASE: Case = Case {
    name: "units",
    parameter: "m in the unit of length",
    unit: "of the largest position",
    reference: "the scene in m, kg, s",
    right: "positions equal to (16 + 2n) κ ε_mach of the largest in n steps: eight numbers of the scene are rounded by half of ε_mach as they are \
            converted, and the tip depends on none of them by more than its fourth power (L⁴); each step rounds position and velocity once in each \
            run. κ, at least 1, is the relative change of the tip by a relative change of E, measured with 1e-6 (a heat shock excites bending, in \
            which small changes grow). Rounding may end an iteration one earlier or later, with 1e-12 of the largest force left, which moves a \
            mass by ½ 1e-12 F/m T², F/m T² ≤ 6 m (EAαΔT of the heat shock): 3e-12. A tolerance with a dimension, or one that compares a slope with a \
            length, would end it elsewhere. Other units only rescale, so that the sweep continues until numbers leave the range of f64: w h⁵ of \
            a section.",
    trials,
};

/// A system of units: the numbers that 1 m, 1 kg and 1 s have in it.
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

/// Another unit of length alone.
const fn rescaled(length: f64) -> Units {
    Units { name: "kg, s", length, mass: 1.0, time: 1.0 }
}

/// A scene with the name of its probe.
type Probed = (&'static str, fn() -> Result<Scene>);

const SCENES: [(&str, Probed); 10] = {
    use Element::{Ancf, EulerBernoulli};
    use Method::{EnergyMomentum, Gauss, GaussAdaptive, GeneralizedAlpha, NystromAdaptive};
    const COLD: &str = "pendulum-flexible";
    [
        ("pendulum, energy-momentum", ("tip", || pendulum(COLD, EnergyMomentum, Ancf))),
        ("pendulum, generalized-alpha", ("tip", || pendulum(COLD, GeneralizedAlpha, Ancf))),
        ("pendulum, multipliers", ("tip", || Ok(pinned(pendulum(COLD, GeneralizedAlpha, Ancf)?)))),
        ("pendulum, gauss, euler-bernoulli", ("tip", || pendulum(COLD, Gauss, EulerBernoulli))),
        ("pendulum, gauss-adaptive", ("tip", || pendulum(COLD, GaussAdaptive, Ancf))),
        ("pendulum, nystrom-adaptive", ("tip", || pendulum(COLD, NystromAdaptive, Ancf))),
        ("pendulum heated, relaxed, gauss", ("tip", || pendulum("pendulum-2d-relaxed", Gauss, Ancf))),
        ("pendulum heated suddenly, energy-momentum", ("tip", || pendulum("pendulum-2d", EnergyMomentum, Ancf))),
        (
            "scissors heated, multipliers",
            ("a4", || {
                let scissors = Scissors { elements: 2, model: ThermalModel::TwoD, ..Scissors::new(3) };
                Ok(pinned(scissors.scene()?.solved(GeneralizedAlpha, 1e-3, 0.3)))
            }),
        ),
        ("cantilever, statics", ("tip", || builtin("cantilever"))),
    ]
};

fn pendulum(name: &'static str, method: Method, element: Element) -> Result<Scene> {
    Ok(builtin(name)?.meshed(element, 4).solved(method, 1e-3, 0.2))
}

fn pinned(mut scene: Scene) -> Scene {
    scene.constraints = Constraints::Multipliers;
    scene
}

fn trials() -> Vec<Trial> {
    let trial = |((name, scene), units): ((&str, Probed), Units)| {
        let fast = units.length == 1e-3 || units.length == 1e-50 || units.time == 1e15;
        // Statics may fail from 1e19 on.
        let expected = match units.length {
            1e-3..=1e10 => Expected::Result,
            1e-25..=1e50 => Expected::ResultOrRefusal,
            _ => Expected::Refusal(&["section.height", "fifth power"]),
        };
        let trial = Trial::new(format!("{name}; {}", units.name), units.length, move || measure(scene, units));
        trial.fast(fast).expect(expected)
    };
    iproduct!(SCENES, SYSTEMS).map(trial).collect()
}

/// Newton's, relative to the largest force.
const TOLERANCE: f64 = 1e-12;

/// Relative change of E that shows how small changes grow.
const CHANGE: f64 = 1e-6;

fn measure((probe, made): Probed, units: Units) -> Result<Finding> {
    let scene = made()?.newton(TOLERANCE);
    let (in_si, own) = (run(&scene)?, run(converted(&scene, units))?);
    let expected = positions(&in_si, probe);
    let path: Path = positions(&own, probe).into_iter().map(|point| point.map(|x| x / units.length)).collect();
    let size = largest_distance(&expected, &vec![[0.0; 2]; expected.len()]);
    let mut stiffer = scene.clone();
    stiffer.material.youngs_modulus *= 1.0 + CHANGE;
    let kappa = (largest_distance(&expected, &positions(&run(&stiffer)?, probe)) / size / CHANGE).max(1.0);
    let bound = (16.0 + 2.0 * own.counts.steps as f64) * kappa * f64::EPSILON + 3.0 * TOLERANCE;
    let (error, why) =
        (largest_distance(&expected, &path) / size, format!("{} steps, κ = {kappa:.1}", own.counts.steps));
    // Warnings are those of the scene in SI units as well.
    Ok(Finding { error, bound, why, rounding: bound, warnings: Vec::new(), ..Finding::of(own) })
}

/// The scene with its numbers in other units; temperatures stay.
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
    if scene.time.method.is_adaptive() {
        scene.time.tolerance *= length;
    }
    scene.output.interval = scene.output.interval.map(|interval| interval * time);
    scene
}
