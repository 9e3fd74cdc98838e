//! Modes: motions without a force, deviations that grow, independence of directions, and what is refused.

#![allow(non_snake_case)] // The symbols of mechanics are names here.

use std::f64::consts::PI;

use ancf::error::Error;
use ancf::model::{Element, Force, Material, Model, Rod, Scene, Section, Support, Temperature, ThermalModel};
use ancf::run::{About, Kind, buckling, modes};

/// Numbers of rigid motions and of mechanisms.
fn without_force(scene: Scene) -> [usize; 2] {
    let found = modes(&scene.build().unwrap(), About::Unloaded, 2).unwrap();
    assert_eq!(found.count(Kind::Vibration), 2);
    assert_eq!(found.count(Kind::Unstable), 0);
    let zeros = found.modes.iter().filter(|mode| mode.square == 0.0).count();
    assert_eq!(zeros, found.modes.len() - 2);
    [Kind::Rigid, Kind::Mechanism].map(|kind| found.count(kind))
}

/// A rod along x, pinned and sliding, turned by `angle`.
///
/// ```text
///   a ═══════════════ b
///   △                 ○
/// ```
fn held(element: Element, angle: f64) -> Scene {
    let t = [angle.cos(), angle.sin()];
    Scene::new(Material::new(2e8, 0.0, 7750.0).alpha(2.85e-5), Section::new(0.02, 0.02))
        .point("a", [0.0, 0.0])
        .point("b", t)
        .rod(Rod::new("rod", "a", "b").elements(element, 16))
        .support(Support::pinned("a"))
        .support(Support::sliding("b", t))
}

/// Source: counting degrees of freedom. Goal: motions without a force are counted, and those of the structure as one body are told
/// from those of its parts.
#[test]
fn motions_without_a_force_are_counted() {
    let free = |scene: &Scene| {
        let mut free = scene.clone();
        free.supports.clear();
        free
    };
    for element in [Element::Ancf, Element::EulerBernoulli] {
        let rod = held(element, 0.3);
        assert_eq!(without_force(free(&rod)), [3, 0], "a free rod");
        let mut pendulum = rod.clone();
        pendulum.supports.truncate(1);
        assert_eq!(without_force(pendulum.clone()), [1, 0], "a pendulum");
        assert_eq!(without_force(rod.clone()), [0, 0], "a held rod");
        let with = |scene: &Scene, from: &str, at| {
            let mut other = scene.rods[0].clone();
            (other.name, other.from, other.to) = ("other".into(), from.into(), "c".into());
            scene.clone().point("c", at).rod(other)
        };
        assert_eq!(without_force(with(&pendulum, "b", [1.5, 0.9])), [1, 1], "a double pendulum");
        assert_eq!(without_force(free(&with(&rod, "b", [1.5, 0.9]))), [3, 1], "two free rods, pinned");
        let apart = free(&with(&rod.clone().point("d", [0.0, 2.0]), "d", [1.0, 2.0]));
        assert_eq!(without_force(apart), [3, 3], "two free rods");
    }
    for (name, expected) in [("scissors-3", [0, 1]), ("scissors-10", [0, 1]), ("scissor-static", [0, 0])] {
        assert_eq!(without_force(Model::load(name).unwrap().into_scene()), expected, "{name}");
    }
}

/// Source: second variation of Euler and Bernoulli's energy, ω² = (EI q⁴ − EA αΔT q²)/ρA with q = nπ/L. Goal: a rod heated beyond its
/// critical temperature between supports grows from the straight state in one direction, at that rate, and vibrates in the others.
/// Parameters: 1 m, 20 mm square, 15 K; it buckles at 11.5 K.
#[test]
fn a_rod_heated_beyond_its_critical_temperature_grows() {
    let mut scene = held(Element::EulerBernoulli, 0.0);
    scene.rods[0].elements = 64;
    scene.supports[1] = Support::pinned("b");
    scene = scene.temperature(Temperature::new(ThermalModel::OneD, vec![[0.0, 15.0]]));
    let model = scene.build().unwrap();
    let found = modes(&model, About::Heated, 2).unwrap();
    assert_eq!((found.count(Kind::Unstable), found.count(Kind::Vibration)), (1, 2));
    assert_eq!(found.modes[0].frequency(), None);
    let EA = 2e8 * 4e-4;
    let EI = EA * 4e-4 / 12.0;
    for (n, mode) in found.modes.iter().enumerate() {
        let q = (n + 1) as f64 * PI;
        let exact = (EI * q.powi(4) - EA * 2.85e-5 * 15.0 * q * q) / (7750.0 * 4e-4);
        // Three waves over 64 elements, order 4: 4e-7 of the bending part, which is larger than the sum.
        assert!((mode.square / exact - 1.0).abs() <= 2e-6, "{n}: {} {exact}", mode.square);
    }
}

/// Frequencies and buckling loads do not depend on the direction of the structure, nor on how pins are enforced.
#[test]
fn directions_make_no_difference() {
    for element in [Element::Ancf, Element::EulerBernoulli] {
        let at = |angle: f64| {
            let scene = held(element, angle).force(Force::new("b", [-13.0 * angle.cos(), -13.0 * angle.sin()]));
            let model = scene.build().unwrap();
            let found = modes(&model, About::Loaded, 4).unwrap();
            let buckled = buckling(&model, About::Loaded).unwrap();
            let factors = [buckled.linearised.unwrap(), buckled.factor.unwrap()];
            found.modes.iter().map(|mode| mode.square.sqrt()).chain(factors).collect::<Vec<f64>>()
        };
        let along_x = at(0.0);
        for n in 1..12 {
            for (found, expected) in at(f64::from(n) * PI / 6.0).iter().zip(&along_x) {
                // Rounding, and the last halving of the path.
                assert!((found / expected - 1.0).abs() <= 1e-7, "{element}, {n}: {found} {expected}");
            }
        }
    }
}

/// Tension has no factor, nor has the load across a cantilever, which bends from the start.
#[test]
fn tension_and_bending_do_not_buckle() {
    for element in [Element::Ancf, Element::EulerBernoulli] {
        let tension = held(element, 0.0).force(Force::new("b", [13.0, 0.0]));
        let mut cantilever = held(element, 0.0).force(Force::new("b", [0.0, -1.0]));
        cantilever.supports = vec![Support::pinned("a").clamping("rod")];
        for scene in [tension, cantilever] {
            let found = buckling(&scene.build().unwrap(), About::Loaded).unwrap();
            assert_eq!((found.linearised, found.factor, found.shape.len()), (None, None, 0));
        }
    }
}

#[test]
fn what_has_no_modes_is_refused_with_the_reason() {
    let model = held(Element::Ancf, 0.0).build().unwrap();
    for number in [0, 201] {
        let error = modes(&model, About::Unloaded, number).unwrap_err();
        assert!(error.is_bad_input() && error.to_string().contains("from 1 to 200"), "{error}");
    }
    let error = buckling(&model, About::Unloaded).unwrap_err();
    assert!(error.is_bad_input() && error.to_string().contains("\"heated\""), "{error}");
    let pendulum = Model::load("pendulum-flexible").unwrap();
    assert!(matches!(modes(&pendulum, About::Loaded, 2), Err(Error::Drifts { .. })));
    assert!(matches!(buckling(&pendulum, About::Loaded), Err(Error::Drifts { .. })));
}
