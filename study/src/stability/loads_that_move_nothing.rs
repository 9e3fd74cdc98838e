//! Loads that move nothing: they must not hide that rounding is as large as what moves the structure.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, builtin, positions};
use crate::error::Result;
use crate::error_time::samples::largest;
use ancf::model::{Element, Force, Method, Motion, Scene, Start, Temperature, ThermalModel};
use ancf::run::run;

pub const CASE: Case = Case {
    name: "loads-that-move-nothing",
    parameter: "E, Pa",
    unit: "m",
    reference: "the pendulum without the load, which it does not change; a free rod that coasts: start + velocity · time",
    right: "beside a weight of 30 N: 1e9 N at the hinge, 1e9 N at the tip and 200 K that come after the end, the constant heat of a relaxed \
            start. Tip over 2 s, step 1e-3 s, where it is without the load, up to what rounding does to both: EA ε_mach |u|/l along the rod, \
            acting against its mass like a load as far as the motion lasts. Warned of at 2e16 Pa and refused at 2e20 Pa, as without the load. A \
            rod that coasts is bent by nothing however stiff it is: each of n steps rounds a place by ε_mach |u|, and what rounds a strain \
            shakes the rod by as much; 4 n ε_mach |u| in all, and no warning.",
    trials,
};

const ELEMENTS: usize = 4;
const STEPS: f64 = 2000.0;

/// A load that moves nothing, by its name.
type Load = (&'static str, fn(&mut Scene));

const LOADS: [Load; 3] = [
    ("force at the hinge", |scene| {
        scene.forces.push(Force { point: "o".into(), force: [1e9, -1e9], history: None });
    }),
    ("force after the end", |scene| {
        let history = Some(vec![[2.0, 0.0], [3.0, 1.0]]);
        scene.forces.push(Force { point: "a".into(), force: [0.0, -1e9], history });
    }),
    ("heat after the end", |scene| scene.temperature = heat(Start::Sudden, vec![[2.0, 0.0], [3.0, 200.0]])),
];

/// This one changes the rod's length and so its motion, but does not drive it.
const RELAXED: Load = ("heat of a relaxed start", |scene| scene.temperature = heat(Start::Relaxed, vec![[0.0, 200.0]]));

fn heat(start: Start, history: Vec<[f64; 2]>) -> Option<Temperature> {
    Some(Temperature { model: ThermalModel::TwoD, start, history })
}

fn trials() -> Result<Vec<Trial>> {
    let refused = Expected::Refusal(&["rounding errors", "of the loads"]);
    let mut trials = Vec::new();
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
        for (name, load) in LOADS {
            for (modulus, expected) in
                [(2e8, Expected::Result), (2e16, Expected::Warning(&["rounding errors"])), (2e20, refused)]
            {
                let trial = Trial::new(format!("{name}, {method}"), modulus, move || beside(method, modulus, load));
                trials.push(trial.fast(method == Method::EnergyMomentum).expect(expected));
            }
        }
        let (name, load) = RELAXED;
        let relaxed = Trial::new(format!("{name}, {method}"), 2e20, move || beside(method, 2e20, load));
        trials.push(relaxed.fast(true).expect(refused));
        for (element, modulus) in [Element::Ancf, Element::EulerBernoulli]
            .into_iter()
            .flat_map(|element| [2e8, 2e14, 2e20].map(|modulus| (element, modulus)))
        {
            let trial =
                Trial::new(format!("coasting, {method}, {element}"), modulus, move || coast(method, element, modulus));
            trials.push(trial.fast(method == Method::EnergyMomentum));
        }
    }
    Ok(trials)
}

fn pendulum(method: Method, modulus: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    (scene.material.youngs_modulus, scene.rods[0].elements) = (modulus, ELEMENTS);
    (scene.time.method, scene.time.step, scene.time.end) = (method, 2.0 / STEPS, 2.0);
    scene.output.interval = Some(0.01);
    Ok(scene)
}

fn beside(method: Method, modulus: f64, load: fn(&mut Scene)) -> Result<Finding> {
    let plain = pendulum(method, modulus)?;
    let mut loaded = plain.clone();
    load(&mut loaded);
    let (loaded, plain) = (run(&loaded)?, run(&plain)?);
    // |u| ≤ 2L, l = L/4, over 2 s, in both.
    let rounding = 2.0 * 0.5 * 4.0 * modulus * EPS * 2.0 * ELEMENTS as f64 / 7750.0;
    Ok(Finding {
        error: largest(&positions(&loaded, "tip"), &positions(&plain, "tip")),
        bound: rounding,
        why: format!("rounding {rounding:.1e}"),
        size: 1.0,
        rounding,
        counts: loaded.counts,
        warnings: loaded.warnings,
        beside: None,
    })
}

/// A free rod without any load.
fn coast(method: Method, element: Element, modulus: f64) -> Result<Finding> {
    let mut scene = pendulum(method, modulus)?;
    (scene.supports, scene.gravity, scene.rods[0].element) = (Vec::new(), [0.0; 2], element);
    let [v_x, v_y] = [2.0, -1.0];
    scene.motion = Some(Motion { velocity: [v_x, v_y], ..Motion::default() });
    let run = run(&scene)?;
    let times = run.trajectory.column("t").unwrap_or_default();
    let expected: Vec<[f64; 2]> = times.iter().map(|t| [1.0 + v_x * t, v_y * t]).collect();
    let bound = 4.0 * STEPS * EPS * 2.0 * v_x.hypot(v_y);
    Ok(Finding {
        error: largest(&positions(&run, "tip"), &expected),
        bound,
        why: format!("4 n ε |u| {bound:.1e}"),
        size: 1.0,
        rounding: bound,
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}
