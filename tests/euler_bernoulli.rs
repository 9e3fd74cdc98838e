//! Structures of the paper's competitor, `"element": "euler-bernoulli"`: the same numbering, pins, supports, integrators and
//! statics as for the paper's element.
//!
//! Source: closed forms derived beside each test; `tests/references` has its statics and vibration. Goal: what a structure
//! asks of an element is answered by this one too.

#![allow(non_snake_case)] // The symbols of mechanics are names here.

mod common;

use ancf::error::Error;
use ancf::internals::model::Scissors;
use ancf::internals::structure::Structure;
use ancf::model::{Constraints, Element, Method, Quantity, Scene, ThermalModel};
use ancf::run::{Run, run};
use common::motion::{Placing, farthest, force_on, longest, must_run, positions, probe, reactions};
use nalgebra::DVector;

/// A scene whose rods are all made of this element.
fn euler_bernoulli(mut scene: Scene) -> Scene {
    scene.rods.iter_mut().for_each(|rod| rod.element = Element::EulerBernoulli);
    scene
}

fn builtin(name: &str) -> Scene {
    euler_bernoulli(Scene::builtin(name).unwrap())
}

fn scissors(count: usize, model: ThermalModel) -> Scene {
    let mut scene = euler_bernoulli(Scissors { elements: 4, model, ..Scissors::new(count) }.scene().unwrap());
    let last = format!("a{}", count + 1);
    scene.probes = vec![
        probe(&last, &[Quantity::Position]),
        probe("b1", &[Quantity::Reaction]),
        force_on("m1", "a1b2"),
        force_on("a2", "b1a2"),
    ];
    scene
}

/// Largest imbalance over the energy put in.
fn imbalance(run: &Run) -> f64 {
    let column = |name| run.trajectory.column(name).unwrap();
    let largest = column("energy.balance").into_iter().fold(0.0, |far: f64, b| far.max(b.abs()));
    largest / column("energy.input").last().unwrap()
}

/// Heated or not, energy–momentum keeps the balance although |r_x| and κ are no polynomials: its strain derivative is the
/// exact quotient of differences. Measured 4e-13 … 2e-11.
#[test]
fn energy_momentum_keeps_the_energy() {
    for model in [ThermalModel::None, ThermalModel::OneD] {
        let mut scene = scissors(3, model);
        (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 1e-3, 3.0);
        let run = must_run(&scene);
        let off = imbalance(&run);
        println!("{model:?}: {off:.1e} of the energy put in, {} iterations", run.counts.newton_iterations);
        assert!(off <= 1e-10, "{model:?}: {off:.1e}");
        // Newton's iteration has the exact derivative.
        assert!(run.counts.newton_iterations <= 4 * run.counts.steps, "{model:?}: {:?}", run.counts);
    }
}

/// The two forms of (23): shared coordinates, and multipliers.
#[test]
fn condensed_and_multipliers_are_the_same_motion() {
    let mut scene = scissors(2, ThermalModel::OneD);
    (scene.time.method, scene.time.step, scene.time.end, scene.output.energy) =
        (Method::GeneralizedAlpha, 5e-4, 1.0, false);
    let condensed = must_run(&scene);
    scene.constraints = Constraints::Multipliers;
    let multipliers = must_run(&scene);
    let moved = farthest(&positions(&condensed, "a3"), &positions(&multipliers, "a3"));
    assert!(moved <= 1e-9, "{moved:.1e} m");
    for name in ["b1", "m1-a1b2", "a2-b1a2"] {
        let (a, b) = (reactions(&condensed, name), reactions(&multipliers, name));
        assert!(farthest(&a, &b) <= 1e-6 * longest(&a), "{name}: {:.1e} of {:.1e} N", farthest(&a, &b), longest(&a));
    }
}

/// Rods of both elements, pinned to each other: the pin does not ask what they are made of. The balance is kept, and both
/// forms of (23) agree.
#[test]
fn both_elements_stand_in_one_structure() {
    let mut scene = scissors(1, ThermalModel::TwoD);
    scene.rods[0].element = Element::Ancf;
    (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 1e-3, 1.0);
    let off = imbalance(&must_run(&scene));
    assert!(off <= 1e-10, "{off:.1e} of the energy put in");
    (scene.time.method, scene.time.step, scene.output.energy) = (Method::GeneralizedAlpha, 5e-4, false);
    let [condensed, multipliers] = [Constraints::Condensed, Constraints::Multipliers].map(|constraints| {
        scene.constraints = constraints;
        positions(&must_run(&scene), "a2")
    });
    let apart = farthest(&condensed, &multipliers);
    assert!(apart <= 1e-9, "{apart:.1e} m");
}

/// "2d" heats a section that this element does not have.
#[test]
fn heat_across_the_rod_does_nothing() {
    let [one, two] = [ThermalModel::OneD, ThermalModel::TwoD].map(|model| {
        let mut scene = builtin("pendulum-2d");
        scene.temperature.as_mut().unwrap().model = model;
        (scene.time.step, scene.time.end) = (5e-5, 0.1);
        must_run(&scene).trajectory.rows
    });
    assert_eq!(one, two);
}

/// One element, all three methods, steps halved from 10⁻³ s: second order, and one limit.
#[test]
fn every_method_is_of_second_order() {
    let tip = |method, step| {
        let mut scene = builtin("pendulum-flexible");
        (scene.rods[0].elements, scene.time.method, scene.time.rho_inf) = (1, method, 0.9);
        (scene.time.step, scene.time.end, scene.output.interval) = (step, 0.5, Some(0.05));
        positions(&must_run(&scene), "tip")
    };
    let exact = tip(Method::EnergyMomentum, 1e-5);
    for method in [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Explicit] {
        let errors = [5e-4, 2.5e-4, 1.25e-4].map(|step| farthest(&tip(method, step), &exact));
        let orders = [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()];
        println!("{method}: errors {errors:?} m, orders {orders:.2?}");
        assert!(orders.iter().all(|order| (order - 2.0).abs() <= 0.1), "{method}: {orders:.2?}");
        assert!(errors[2] <= 1e-5, "{method}: {errors:?}");
    }
}

fn cantilever(height: f64, elements: usize, load_steps: usize, load: f64) -> Scene {
    let mut scene = builtin("cantilever");
    (scene.section.height, scene.section.width) = (height, height);
    scene.forces[0].force = [0.0, -load * scene.material.youngs_modulus * height.powi(4) / 12.0];
    (scene.rods[0].elements, scene.time.load_steps) = (elements, load_steps);
    scene
}

/// PL²/EI = 10, h/L = 10⁻³: one load step ends where ten do, in parts whose displacements agree with their rates: 21
/// iterations, of which the whole step takes 8 or 9.
#[test]
fn one_load_step_bends_a_slender_rod_far() {
    for elements in [8, 16, 32] {
        let [ten, one] = [10, 1].map(|steps| must_run(&cantilever(1e-3, elements, steps, 10.0)));
        println!("{elements} elements: {} iterations", one.counts.newton_iterations);
        assert!(farthest(&positions(&one, "tip")[1..], &positions(&ten, "tip")[10..]) <= 1e-9, "{elements}");
        assert!(one.counts.newton_iterations <= 25, "{elements} elements: {:?}", one.counts);
    }
}

/// A clamp holds the direction of r_x, not its length; without it the rod drifts, and statics says so.
#[test]
fn a_clamp_holds_the_direction() {
    let mut scene = cantilever(0.02, 2, 1, 1.0);
    let placing = Placing { mirrored: false, angle: 1.1, by: [2.0, -3.0] };
    let [straight, placed] = [scene.clone(), placing.scene(&scene)].map(|scene| positions(&must_run(&scene), "tip"));
    let expected: Vec<_> = straight.iter().map(|tip| placing.point(*tip)).collect();
    assert!(farthest(&placed, &expected) <= 1e-10, "{placed:?}, not {expected:?}");
    scene.supports[0].clamp = None;
    assert!(matches!(run(&scene), Err(Error::Drifts { .. })));
}

/// The relaxed start is at the stretch 1 + αΔT, without a force, and stays there.
#[test]
fn a_relaxed_free_rod_is_stress_free() {
    let mut scene = builtin("pendulum-1d-relaxed");
    (scene.supports, scene.gravity) = (Vec::new(), [0.0, 0.0]);
    (scene.time.step, scene.time.end, scene.output.interval) = (2e-5, 0.01, None);
    let structure = Structure::new(&scene).unwrap();
    let [o, a] = ["o", "a"].map(|point| structure.position(structure.point(point).unwrap(), structure.start()));
    assert!(((a[0] - o[0]) - (1.0 + 2.85e-5 * 200.0)).abs() <= 1e-15, "{o:?}, {a:?}");
    let mut force = DVector::zeros(structure.size());
    structure.force(structure.start(), &structure.thermal_strains(0.0), &mut force);
    assert!(force.amax() <= 1e-12 * 2e8 * 4e-4, "{:.1e} N", force.amax());
    let path = positions(&must_run(&scene), "tip");
    assert!(farthest(&path, &vec![path[0]; path.len()]) <= 1e-12);
}

/// The explicit limit is a bound of the true one, and close to it, although an element taken free is 1.3 to 1.5 times as fast: the
/// rod is looked at as a whole.
#[test]
fn the_frequency_bound_is_a_bound_and_close() {
    for elements in [1, 4, 16] {
        let mut scene = builtin("pendulum-1d");
        scene.rods[0].elements = elements;
        let structure = Structure::new(&scene).unwrap();
        let stiffness = structure.tangent(structure.start(), &structure.thermal_strains(0.0)).dense();
        let lower = structure.mass().dense().cholesky().unwrap().l();
        let half = lower.solve_lower_triangular(&stiffness).unwrap();
        let largest = lower.solve_lower_triangular(&half.transpose()).unwrap().symmetric_eigenvalues().max().sqrt();
        let bound = structure.largest_frequency().unwrap();
        assert!((0.999_999..1.1).contains(&(bound / largest)), "{elements} elements: {bound:e} for {largest:e} rad/s");
    }
}

/// Where twice the cold would leave nothing of the rod there is no such state: the limit is that of the states that there are.
#[test]
fn a_rod_turned_inside_out_sets_no_limit() {
    let bounds = [-505.0, -600.0].map(|change| {
        let mut scene = builtin("pendulum-1d");
        scene.material.alpha = 1e-3;
        scene.temperature.as_mut().unwrap().history = vec![[0.0, change]];
        Structure::new(&scene).unwrap().largest_frequency().unwrap()
    });
    assert!((0.5..2.0).contains(&(bounds[0] / bounds[1])), "{bounds:?} rad/s");
}

/// Errors name the place of an unknown of this element as of the other.
#[test]
fn unknowns_have_places() {
    let structure = Structure::new(scissors(1, ThermalModel::None)).unwrap();
    let pivot = structure.unknown("a1b2", 4, 0).unwrap();
    assert_eq!(structure.location(pivot), "the point `m1`");
    assert_eq!(structure.location(structure.unknown("a1b2", 3, 0).unwrap()), "the rod `a1b2`");
    assert_eq!(structure.unknown("a1b2", 10, 0), None);
}
