//! Whole motions on the portable path and on this machine's fastest are the same to rounding.

use ancf::error::Result;
use ancf::integrators::{Counts, State};
use ancf::internals::integrators::integrator;
use ancf::internals::lanes::Path;
use ancf::internals::model::Plan;
use ancf::internals::structure::Structure;
use ancf::model::{Constraints, Element, Form, Method, Scene};

/// Largest difference of a displacement after the motion, of the largest.
const TOLERANCE: f64 = 1e-12;

fn scene(name: &str, element: Element) -> Scene {
    let mut scene = Scene::builtin(name).unwrap();
    scene.rods.iter_mut().for_each(|rod| rod.element = element);
    scene
}

/// State after `steps` steps, and the strain energy there.
fn moved(scene: &Scene, steps: usize, path: Path) -> Result<(State, f64)> {
    let (plan, mut counts) = (Plan::of(scene), Counts::default());
    let structure = Structure::planned_on(scene, &plan, path)?;
    let mut state = State::at_start(&structure);
    let mut method = integrator(scene, &plan, &structure, &state, &mut counts)?;
    for step in 1..=steps {
        let before = state.u.clone();
        let t_1 = step as f64 * scene.time.step;
        method.step(&structure, &mut state, t_1, &mut counts)?;
        structure.check_collapse(&before, &state.u, t_1)?;
    }
    let energy = structure.strain_energy(&state.u, &structure.thermal_strains(state.t));
    Ok((state, energy))
}

fn assert_same(name: &str, scene: &Scene, steps: usize) {
    let [(portable, energy), (fastest, other)] =
        [Path::PORTABLE, Path::fastest()].map(|path| moved(scene, steps, path).unwrap());
    let off = (&portable.u - &fastest.u).amax() / portable.u.amax();
    assert!(off <= TOLERANCE, "{name}: displacements differ by {off:e}");
    // Strains are differences of displacements: an energy keeps fewer digits.
    let off = (energy - other).abs() / energy.abs();
    assert!(off <= 1e-9, "{name}: strain energies differ by {off:e}");
}

#[test]
fn motions_are_the_same_on_both_paths() {
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for (method, step, steps) in [
            (Method::GeneralizedAlpha, 1e-3, 40),
            (Method::EnergyMomentum, 1e-3, 40),
            (Method::Gauss, 1e-3, 20),
            (Method::Explicit, 1e-5, 400),
        ] {
            let mut pendulum = scene("pendulum-flexible", element);
            (pendulum.time.method, pendulum.time.step) = (method, step);
            assert_same(&format!("pendulum, {element}, {method}"), &pendulum, steps);
        }
        let mut scissors = scene("scissors-3-thermal", element);
        scissors.time.step = 1e-3;
        assert_same(&format!("scissors, {element}"), &scissors, 20);
        (scissors.time.method, scissors.constraints) = (Method::GeneralizedAlpha, Constraints::Multipliers);
        assert_same(&format!("scissors with multipliers, {element}"), &scissors, 5);
    }
    let mut printed = scene("pendulum-flexible", Element::Ancf);
    printed.form = Form::PrintedShear;
    assert_same("printed shear", &printed, 10);
}
