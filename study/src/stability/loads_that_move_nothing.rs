//! Loads that move nothing: they must not hide rounding that is as large as the loads that move the structure.

use super::prelude::*;
use super::stiff::rounding_as_load;
use ancf::model::Start;

pub const CASE: Case = Case {
    name: "loads-that-move-nothing",
    parameter: "E, Pa",
    unit: "m",
    reference: "the pendulum without the load, which does not change its motion; a free rod without loads: start + velocity · time",
    right: "loads besides the weight of 30 N: 1e9 N at the hinge; 1e9 N at the tip, or 200 K, after the end; constant heat of a relaxed start. \
            The tip over 2 s, step 1e-3 s, is where it is without the load, up to the rounding of both runs: EA ε_mach |u|/l along the rod, like a \
            load on its mass. As without the load: a warning at 2e16 Pa, a refusal at 2e20 Pa. A free rod is not bent, however stiff it is: each \
            of n steps rounds a position by ε_mach |u|, and the rounding of strains shakes the rod by as much; 4 n ε_mach |u| in all, without a \
            warning.",
    trials,
};

const STEPS: f64 = 2000.0;

/// A load by its name.
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

/// Changes the rod's length and so its motion, but does not drive it.
const RELAXED: Load = ("heat of a relaxed start", |scene| scene.temperature = heat(Start::Relaxed, vec![[0.0, 200.0]]));

fn heat(start: Start, history: Vec<[f64; 2]>) -> Option<Temperature> {
    Some(Temperature { model: ThermalModel::TwoD, start, history })
}

fn trials() -> Vec<Trial> {
    let refused = Expected::Refusal(&["rounding errors", "of the loads"]);
    let warned = Expected::Warning(&["rounding errors"]);
    let mut trials = Vec::new();
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
        let is_fast = method == Method::EnergyMomentum;
        let mut add = |(name, load): Load, modulus, expected, fast| {
            let trial = Trial::new(format!("{name}, {method}"), modulus, move || loaded(method, modulus, load));
            trials.push(trial.fast(fast).expect(expected));
        };
        for (load, (modulus, expected)) in iproduct!(LOADS, [(2e8, Expected::Result), (2e16, warned), (2e20, refused)])
        {
            add(load, modulus, expected, is_fast);
        }
        add(RELAXED, 2e20, refused, true);
        for (element, modulus) in iproduct!(ELEMENTS, [2e8, 2e14, 2e20]) {
            let name = format!("coasting, {method}, {element}");
            trials.push(Trial::new(name, modulus, move || coasting(method, element, modulus)).fast(is_fast));
        }
    }
    trials
}

fn scene(method: Method, element: Element, modulus: f64) -> Result<Scene> {
    let mut scene = pendulum(element, 4)?.solved(method, 2.0 / STEPS, 2.0).rows_every(0.01);
    scene.material.youngs_modulus = modulus;
    Ok(scene)
}

fn loaded(method: Method, modulus: f64, load: fn(&mut Scene)) -> Result<Finding> {
    let plain = scene(method, Element::Ancf, modulus)?;
    let mut loaded = plain.clone();
    load(&mut loaded);
    // Of both runs.
    let rounding = 2.0 * rounding_as_load(&plain, modulus);
    let (loaded, plain) = (run(&loaded)?, run(&plain)?);
    let error = largest_distance(&tip(&loaded), &tip(&plain));
    let why = format!("rounding {rounding:.1e}");
    Ok(Finding { error, bound: rounding, why, rounding, ..Finding::of(loaded) })
}

/// A free rod without any load.
fn coasting(method: Method, element: Element, modulus: f64) -> Result<Finding> {
    let mut scene = scene(method, element, modulus)?;
    (scene.supports, scene.gravity) = (Vec::new(), [0.0; 2]);
    let [v_x, v_y] = [2.0, -1.0];
    scene.motion = Some(Motion { velocity: [v_x, v_y], ..Motion::default() });
    let own = run(&scene)?;
    let expected: Path = column(&own, "t").into_iter().map(|t| [1.0 + v_x * t, v_y * t]).collect();
    let bound = 4.0 * STEPS * f64::EPSILON * 2.0 * v_x.hypot(v_y);
    let error = largest_distance(&tip(&own), &expected);
    let why = format!("4 n ε |u| {bound:.1e}");
    Ok(Finding { error, bound, why, rounding: bound, ..Finding::of(own) })
}
