//! Stress-free deviations of the initial shape: no stress at the start and in no rigid motion, forces that are derivatives of the
//! energy, work that is the change of energy, modes that are refused. `tests/references/imperfection.rs` has the closed forms.

#![allow(non_snake_case)] // The symbols of mechanics are names here.

mod common;
#[path = "common/states.rs"]
mod states;

use ancf::equations::material::LameConstants;
use ancf::equations::shape::Vector14;
use ancf::error::Error;
use ancf::internals::elements::{Ancf, Beam, Ends, Law};
use ancf::internals::structure::{Matrix, StepEnds, Structure};
use ancf::model::{
    Constraints, Direction, Imperfection, Material, Method, Poisson, Rod, Scene, Section, Support, Temperature,
    ThermalModel,
};
use ancf::run::Simulation;
use common::Equations;
use nalgebra::{DVector, Rotation2, Vector2};
use states::rows;

/// A is K of (20) at the deviated coordinates, cold; held to the oracle in every state without heat.
#[test]
fn the_matrix_of_a_deviation_is_k_of_equation_20() {
    let mut compared = 0;
    for case in Equations::load().cases() {
        let s = &case.state;
        if s.model != ThermalModel::None && s.dT != 0.0 {
            continue;
        }
        let lame = LameConstants { lambda: case.scalar("17.lambda"), mu: case.scalar("17.mu") };
        let element = Ancf::new(s.l, s.h, s.w, s.theta, Law::PlaneStrain { lame, poisson: Poisson::Full });
        let u = Vector14::from(s.e) - Vector14::from(s.e0);
        let found = rows(element.deviation(&u).unwrap().stiffness());
        let (expected, scale) = (case.value("20.K"), common::scale::scale("20.K", &case));
        assert!(common::within(common::TOLERANCE, &found, &expected, &scale), "{}", case.id);
        compared += 1;
    }
    assert!(compared >= 5, "{compared}");
}

/// Two rods that meet at an angle, held at both ends and heated; one bowed, or both in a mode.
fn knee(imperfection: Imperfection) -> Scene {
    let mut scene = Scene::new(Material::new(2e8, 0.3, 7200.0).alpha(1e-5), Section::new(0.05, 0.02))
        .point("a", [0.0, 0.0])
        .point("b", [0.6, 0.9])
        .point("c", [1.5, 0.3])
        .rod(Rod::new("ab", "a", "b").elements(Default::default(), 2))
        .rod(Rod::new("bc", "b", "c").elements(Default::default(), 3))
        .support(Support::pinned("a").clamping("ab"))
        .support(Support::pinned("c"))
        .temperature(Temperature {
            model: ThermalModel::TwoD,
            start: Default::default(),
            history: vec![[0.0, 0.0], [1.0, 300.0]],
        })
        .until(0.1);
    scene.gravity = [0.0, -9.8];
    scene.imperfection = Some(imperfection);
    scene
}

fn knees() -> [Scene; 3] {
    [Imperfection::of_rod("bc", 0.02), Imperfection::of_rod("ab", -0.01), Imperfection::of_mode(2, 0.02)].map(knee)
}

fn force(structure: &Structure, u: &DVector<f64>, t: f64) -> DVector<f64> {
    let mut sum = DVector::zeros(structure.size());
    structure.force(u, &structure.thermal_strains(t), &mut sum);
    sum
}

/// Displacements around the start, without a pattern.
fn random(structure: &Structure, seed: f64) -> DVector<f64> {
    structure.start() + DVector::from_fn(structure.size(), |i, _| 0.03 * (12.9898 * (i as f64 + seed)).sin())
}

#[test]
fn the_start_is_free_of_stress() {
    for scene in knees() {
        for constraints in [Constraints::Condensed, Constraints::Multipliers] {
            let mut scene = scene.clone();
            (scene.constraints, scene.time.method) = (constraints, Method::GeneralizedAlpha);
            let structure = Structure::new(&scene).unwrap();
            let (u, cold) = (structure.start(), structure.thermal_strains(0.0));
            let size = structure.largest_displacement(u);
            let amplitude = scene.imperfection.as_ref().unwrap().amplitude.abs();
            // The larger component of a position, and a slope over its length, which moves little more.
            assert!(size >= 0.7 * amplitude && size <= 1.5 * amplitude, "{size} {amplitude}");
            let largest = structure.largest_force(&force(&structure, u, 0.0));
            assert!(largest <= 8.0 * structure.rounding_force(u), "{largest:e}");
            assert!(structure.strain_energy(u, &cold).abs() <= structure.energy_rounding());
        }
    }
}

/// A free rod, bowed by a fiftieth of its length, turned and moved as a whole: no force, no energy.
#[test]
fn a_rigid_motion_of_a_bowed_rod_takes_no_force() {
    for law in [ancf::model::Law::PlaneStrain, ancf::model::Law::Uniaxial] {
        let mut rod = Rod::new("rod", "a", "b").elements(Default::default(), 3);
        rod.law = law;
        let mut scene = Scene::new(Material::new(2e8, 0.3, 7200.0), Section::new(0.05, 0.02))
            .point("a", [0.0, 0.0])
            .point("b", [0.6, 0.8])
            .rod(rod);
        scene.imperfection = Some(Imperfection::of_rod("rod", 0.02));
        let simulation = Simulation::new(scene).unwrap();
        let structure = simulation.structure();
        let e = simulation.nodal_coordinates("rod").unwrap();
        for angle in [0.3, 1.5, -2.8] {
            let mut u = structure.start().clone();
            for (vector, e) in e.iter().enumerate() {
                // r, r_y of node i, then r, r_x, r_y of j and r, r_y of k.
                let shift = if [0, 2].contains(&(vector % 5)) { Vector2::new(0.4, -0.3) } else { Vector2::zeros() };
                let moved = Rotation2::new(angle) * Vector2::from(*e) + shift;
                for axis in 0..2 {
                    u[structure.unknown("rod", vector, axis).unwrap()] += moved[axis] - e[axis];
                }
            }
            let largest = structure.largest_force(&force(structure, &u, 0.0));
            assert!(largest <= 8.0 * structure.rounding_force(&u), "{law}, {angle}: {largest:e}");
            let energy = structure.strain_energy(&u, &structure.thermal_strains(0.0));
            assert!(energy.abs() <= structure.energy_rounding(), "{law}, {angle}: {energy:e}");
        }
    }
}

/// A force as a function of the displacements.
type Of<'a> = &'a dyn Fn(&DVector<f64>) -> DVector<f64>;

/// U is of degree 4 and Q of degree 3 along a line, so the five-point difference is exact.
#[test]
fn forces_and_tangents_are_derivatives() {
    for scene in knees() {
        let structure = Structure::new(&scene).unwrap();
        let (u, d, t) = (random(&structure, 1.0), random(&structure, 2.0) - structure.start(), 0.5);
        let thermal = structure.thermal_strains(t);
        let at = |step: f64| &u + step * &d;
        let U = |step: f64| structure.strain_energy(&at(step), &thermal);
        let slope = (U(-2.0) - 8.0 * U(-1.0) + 8.0 * U(1.0) - U(2.0)) / 12.0;
        let Q = force(&structure, &u, t);
        let scale = U(-2.0).abs() + U(2.0).abs();
        assert!((slope - Q.dot(&d)).abs() <= 1e-12 * scale, "{slope} {}", Q.dot(&d));

        // Each matrix, by what it makes of a vector: K⁻¹ b, whose derivative of the force must be b.
        let other = random(&structure, 3.0);
        let ends = StepEnds { u_0: &other, u_1: &u, thermal_0: &thermal, thermal_1: &thermal };
        let mean = |u_1: &DVector<f64>| {
            let mut sum = DVector::zeros(structure.size());
            structure.mean_force(&StepEnds { u_0: &other, u_1, thermal_0: &thermal, thermal_1: &thermal }, &mut sum);
            sum
        };
        let plain = |u: &DVector<f64>| force(&structure, u, t);
        let tangent = Matrix::Tangent { u: &u, thermal: &thermal, stiffness: 1.0, mass: 0.0 };
        let mixed = Matrix::Mixed { before: &u, u: &u, thermal: &thermal };
        let cases: [(&str, Matrix, Of); 3] =
            [("tangent", tangent, &plain), ("mixed", mixed, &plain), ("mean", Matrix::Mean { ends, mass: 0.0 }, &mean)];
        for (name, matrix, force) in cases {
            let mut factors = structure.factors();
            structure.factorize(matrix, &mut factors).unwrap();
            let b = DVector::from_fn(structure.size(), |i, _| (i as f64).cos());
            let mut x = b.clone();
            factors.solve(&mut x);
            let unit = 0.01 / x.amax();
            let f = |step: f64| force(&(&u + step * unit * &x));
            let found = (f(-2.0) - 8.0 * f(-1.0) + 8.0 * f(1.0) - f(2.0)) / (12.0 * unit);
            let off = (&found - &b).amax() / (f(1.0).amax() / unit);
            assert!(off <= 1e-10, "{name}: {off:.1e}");
        }
    }
}

/// Q̄·(u₁ − u₀) + heating work = U₁ − U₀, as of the straight element.
#[test]
fn the_mean_force_does_the_work_of_the_step() {
    for scene in knees() {
        let structure = Structure::new(&scene).unwrap();
        let (u_0, u_1) = (random(&structure, 4.0), random(&structure, 5.0));
        let (thermal_0, thermal_1) = (structure.thermal_strains(0.1), structure.thermal_strains(0.9));
        let ends: StepEnds = Ends { u_0: &u_0, u_1: &u_1, thermal_0: &thermal_0, thermal_1: &thermal_1 };
        let mut mean = DVector::zeros(structure.size());
        structure.mean_force(&ends, &mut mean);
        let energies = [structure.strain_energy(&u_0, &thermal_0), structure.strain_energy(&u_1, &thermal_1)];
        let off = mean.dot(&(&u_1 - &u_0)) + structure.heating_work(&ends) - (energies[1] - energies[0]);
        assert!(off.abs() <= 1e-12 * (energies[0] + energies[1]), "{off:e} of {energies:?}");
    }
}

/// Every method moves a bowed rod, and to the same place; energy–momentum keeps the energy.
#[test]
fn every_method_can() {
    let tip = |method: Method, step: f64| {
        let mut scene = knee(Imperfection::of_rod("bc", 0.02));
        scene.temperature = None;
        (scene.time.method, scene.time.step, scene.time.end) = (method, step, 0.02);
        if method.is_adaptive() {
            (scene.time.tolerance, scene.output.interval) = (1e-9, Some(0.02));
        }
        let mut simulation = Simulation::new(scene).unwrap();
        let energy = |simulation: &Simulation| {
            let energy = simulation.energy();
            energy.kinetic + energy.strain + energy.potential
        };
        let before = energy(&simulation);
        while simulation.step().unwrap() {}
        let kept = (energy(&simulation) - before).abs() / simulation.energy().kinetic;
        assert!(method != Method::EnergyMomentum || kept <= 1e-7, "{kept:e}");
        Vector2::from(simulation.position("b").unwrap()) - Vector2::new(0.6, 0.9)
    };
    let expected = tip(Method::Nystrom, 1e-5);
    for (method, step) in [
        (Method::GeneralizedAlpha, 1e-4),
        (Method::EnergyMomentum, 1e-4),
        (Method::Explicit, 1e-5),
        (Method::Gauss, 1e-3),
        (Method::GaussAdaptive, 1e-2),
        (Method::NystromAdaptive, 1e-2),
    ] {
        let off = (tip(method, step) - expected).norm() / expected.norm();
        println!("{method}: {off:.1e}");
        assert!(off <= 2e-2, "{method}: {off:.1e}");
    }
}

/// A scene without an imperfection is what it was, and one whose amplitude goes to zero becomes it.
#[test]
fn a_small_deviation_does_little() {
    let straight = {
        let mut scene = knee(Imperfection::of_mode(1, 1.0));
        scene.imperfection = None;
        scene
    };
    let tangent = |scene: &Scene| {
        let structure = Structure::new(scene).unwrap();
        structure.tangent(&DVector::zeros(structure.size()), &structure.thermal_strains(0.0)).dense()
    };
    let plain = tangent(&straight);
    for amplitude in [1e-3, 1e-5] {
        let deviated = tangent(&knee(Imperfection::of_rod("bc", amplitude)));
        let off = (&deviated - &plain).amax() / plain.amax();
        assert!(off > 0.0 && off <= 10.0 * amplitude, "{amplitude}: {off:e}");
    }
}

#[test]
fn modes_that_are_none_are_refused() {
    let refusal = |scene: Scene| match Structure::new(scene) {
        Err(Error::Scene { key, allowed, .. }) => format!("{key}: {allowed}"),
        other => panic!("{:?}", other.map(|structure| structure.size())),
    };
    let mut free = knee(Imperfection::of_mode(1, 0.01));
    free.supports.pop();
    let text = refusal(free);
    assert!(text.starts_with("imperfection.mode: ") && text.contains("`rod` in place of `mode`"), "{text}");
    assert!(text.contains("can move without a strain") && text.contains("`bc`"), "{text}");

    let mut single = knee(Imperfection::of_mode(50, 0.01));
    single.rods.iter_mut().for_each(|rod| rod.elements = 1);
    let text = refusal(single);
    assert!(text.contains("the structure's number of modes"), "{text}");

    // Two equal rods clamped at one point: every frequency is there twice.
    let mut twins = Scene::new(Material::new(2e8, 0.0, 7200.0), Section::new(0.05, 0.02))
        .point("a", [0.0, 0.0])
        .point("b", [1.0, 0.0])
        .point("c", [0.0, 1.0])
        .rod(Rod::new("ab", "a", "b"))
        .rod(Rod::new("ac", "a", "c"))
        .support(Support::fixed("a", &[Direction::X]).clamping("ab"))
        .support(Support::fixed("a", &[Direction::Y]).clamping("ac"));
    twins.imperfection = Some(Imperfection::of_mode(1, 0.01));
    let text = refusal(twins);
    assert!(text.contains("any mix of their shapes is a mode"), "{text}");
}

#[test]
fn elements_that_cannot_be_deviated_are_refused() {
    let refusal = |change: fn(&mut Scene)| {
        let mut scene = knee(Imperfection::of_rod("bc", 0.01));
        change(&mut scene);
        scene.build().unwrap_err().to_string()
    };
    let text = refusal(|scene| scene.rods[0].element = ancf::model::Element::EulerBernoulli);
    assert!(text.contains("curvature is not quadratic") && text.contains("the rod `ab`"), "{text}");
    let text = refusal(|scene| scene.form = ancf::model::Form::PrintedShear);
    assert!(text.contains("whose energy depends on the frame"), "{text}");
}
