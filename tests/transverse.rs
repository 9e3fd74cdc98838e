//! Heat across the rod only (`"model": "transverse"`), which isolates what the paper says of the section: it thickens, the rod
//! keeps its length, and bends less.
//!
//! All follows from the energy W(E − ε_T), ε_T = αΔT n⊗n with n across the rod's initial direction. The law has no
//! out-of-plane part of ε_T (M1), so that E = ε_T is free of stress in the plane at any ν.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;

use ancf::error::Error;
use ancf::model::{
    Element, Force, Law, Material, Method, Poisson, Rod, Scene, Section, Support, Temperature, ThermalModel,
};
use ancf::run::Simulation;
use ancf::state::{CableState, ElementState, evaluate};

/// αΔT of the tests.
const HEAT: f64 = 2e-3;

/// A rod of 1 m at 40° to the x axis, 20 × 20 mm, pinned at one end, α = 2·10⁻⁵ 1/K.
fn rod(nu: f64, law: Law, poisson: Poisson) -> Scene {
    let (sin, cos) = 40.0_f64.to_radians().sin_cos();
    let mut scene = Scene::new(Material::new(7e10, nu, 2750.0).alpha(2e-5), Section::new(0.02, 0.02))
        .point("o", [0.0, 0.0])
        .point("a", [cos, sin])
        .rod(Rod::new("rod", "o", "a").elements(Element::Ancf, 2))
        .support(Support::pinned("o"));
    (scene.rods[0].law, scene.rods[0].poisson) = (law, poisson);
    scene
}

fn heated(model: ThermalModel) -> Temperature {
    Temperature::new(model, vec![[0.0, 100.0]])
}

/// Stress-free: E₁₁ = (a² − 1)/2 = 0 and E₂₂ = (c² − 1)/2 = αΔT, so a = 1 and c = √(1 + 2αΔT) = 1 + αΔT − ½(αΔT)² + …: the
/// rod thickens by αΔT and keeps its length. σ = D(E − ε_T) = 0 there whatever D is: at any ν, in plane strain, with Poisson's
/// terms on the axis, and by the uniaxial law. (A plane-strain body heated in *all* directions would have (1 + ν)αΔT here.)
/// A relaxed start is this state, and a rod left to itself stays in it.
#[test]
fn a_free_rod_thickens_and_keeps_its_length() {
    let kinds = [(Law::PlaneStrain, Poisson::Full), (Law::PlaneStrain, Poisson::Axis), (Law::Uniaxial, Poisson::Full)];
    for (nu, (law, poisson)) in [0.0, 0.3, 0.45].into_iter().flat_map(|nu| kinds.map(|kind| (nu, kind))) {
        let mut scene = rod(nu, law, poisson).temperature(heated(ThermalModel::Transverse).relaxed());
        (scene.time.method, scene.time.step) = (Method::Explicit, 1e-7);
        let mut simulation = Simulation::new(scene).unwrap();
        for t in [0.0, 1e-4] {
            simulation.run_until(t).unwrap();
            for point in simulation.axis("rod", &[0.0, 0.3, 0.5, 1.0]).unwrap() {
                let thickness = point.director[0].hypot(point.director[1]);
                assert!((thickness - (1.0 + 2.0 * HEAT).sqrt()).abs() < 1e-12, "{nu} {law} {poisson}: {point:?}");
                assert!((thickness - 1.0 - HEAT).abs() < 0.6 * HEAT * HEAT, "{nu} {law} {poisson}: {point:?}");
                // No strain along, and none that heat has caused freely.
                assert!(point.strain.abs() < 1e-12 && point.thermal_strain == 0.0, "{nu} {law} {poisson}: {point:?}");
            }
            let [x, y] = simulation.position("a").unwrap();
            assert!((x.hypot(y) - 1.0).abs() < 1e-12, "{nu} {law} {poisson}: {x} {y}");
        }
    }
}

/// Bending: with a section stretched by c and turned by φ, E₁₁ = y c φ′ and 2E₁₂ = c (w′ − φ) to first order, and the state that
/// they are added to is free of stress. Both stiffnesses of the beam, E I and μA, are thus c² = 1 + 2αΔT times those of the cold
/// rod: a small load deflects it by 1/(1 + 2αΔT) as much. The same holds for every mesh, as r_y is interpolated as φ is.
/// That is the paper's "varying moment of inertia". At ν = 0, where nothing couples the strains along and across.
#[test]
fn a_heated_cantilever_is_stiffer_by_the_square_of_its_thickness() {
    let deflection = |temperature: Option<Temperature>| {
        let mut scene = rod(0.0, Law::PlaneStrain, Poisson::Full);
        scene.supports = vec![Support::pinned("o").clamping("rod")];
        let [x, y] = scene.points["a"];
        // Deflects by 3·10⁻⁶ of the length: terms of second order are below 10⁻⁹ of that.
        scene.forces = vec![Force::new("a", [-0.008 * y, 0.008 * x])];
        scene.temperature = temperature;
        (scene.time.method, scene.time.newton_tolerance) = (Method::Static, 1e-15);
        let mut simulation = Simulation::new(scene).unwrap();
        simulation.run_until(1.0).unwrap();
        let [moved_x, moved_y] = simulation.position("a").unwrap();
        x * moved_y - y * moved_x
    };
    let cold = deflection(None);
    let ratio = deflection(Some(heated(ThermalModel::Transverse))) / cold;
    println!("cold {cold:.6e} m, heated across {ratio:.9} times that, {:.9} expected", 1.0 / (1.0 + 2.0 * HEAT));
    assert!(cold > 1e-6 && (ratio * (1.0 + 2.0 * HEAT) - 1.0).abs() < 1e-8, "{cold} {ratio}");
}

/// An element at −0.7 rad, strained and bent, ν = 0.3.
fn element(model: &str) -> ElementState {
    let (sin, cos) = (-0.7_f64).sin_cos();
    let straight = |x: f64| [x * cos, x * sin];
    let ([t_x, t_y], [j_x, j_y], [k_x, k_y]) = ([cos, sin], straight(0.25), straight(0.5));
    let e_0 = [0.0, 0.0, -t_y, t_x, j_x, j_y, t_x, t_y, -t_y, t_x, k_x, k_y, -t_y, t_x];
    let moved: Vec<f64> = e_0.iter().enumerate().map(|(n, entry)| entry + 0.02 * (1.7 * n as f64).sin()).collect();
    let text = format!(
        r#"{{"l": 0.5, "h": 0.1, "w": 0.05, "theta": -0.7, "e0": {e_0:?}, "e": {moved:?}, "edot": {:?}, "E": 2e8,
            "nu": 0.3, "rho": 7200.0, "alpha": 1e-5, "dT": 400.0, "model": "{model}", "points": [[0.1, 0.02], [0.4, -0.03]]}}"#,
        [0.0; 14]
    );
    ElementState::parse(&text, "state.json").unwrap()
}

/// I = t⊗t + n⊗n, and W is quadratic in E − ε_T: forces and stresses are affine in ε_T. What 2D heat changes of them is the sum
/// of what 1D and transverse heat change, exactly: in the paper's law, on the axis and by the uniaxial law, in global axes and in the
/// rod's own.
#[test]
fn heat_along_and_across_add_up_to_2d_heat() {
    let states = ["none", "1d", "transverse", "2d"].map(element);
    for quantity in ["8.epsilon_T", "14.epsilon", "15.sigma", "19.Q_e", "axis.Q_e", "uniaxial.Q_e", "tangent.dQ_e"] {
        let [none, along, across, both] = states.each_ref().map(|state| evaluate(quantity, state).unwrap());
        let largest = both.iter().fold(0.0, |size: f64, entry| size.max(entry.abs()));
        let mut changed = false;
        for n in 0..none.len() {
            let sum = along[n] + across[n] - none[n];
            assert!((both[n] - sum).abs() <= 1e-13 * largest, "{quantity} {n}: {} {sum}", both[n]);
            changed |= (across[n] - none[n]).abs() > 1e-6 * largest;
        }
        assert!(changed, "{quantity}: heat across changes nothing");
    }
    // n⊗n in global axes, from the angle itself.
    let (sin, cos) = (-0.7_f64).sin_cos();
    let [.., across, _] = &states;
    for (found, factor) in across.eps_T().iter().zip([sin * sin, cos * cos, -sin * cos]) {
        assert!((found - 4e-3 * factor).abs() < 1e-17, "{found} {factor}");
    }
}

/// Euler–Bernoulli elements have no section: the heat would do nothing, and nothing silently is refused.
#[test]
fn rods_without_a_section_are_refused() {
    let refused = |scene: Scene, wanted: &str| match Simulation::new(scene) {
        Err(Error::Scene { key, value, allowed, .. }) => {
            assert_eq!((key.as_str(), value.as_str()), (wanted, "\"transverse\""));
            assert!(allowed.contains("no section") && allowed.contains("`second`"), "{allowed}");
        }
        other => panic!("{:?}", other.map(|_| ())),
    };
    let mut scene = rod(0.0, Law::PlaneStrain, Poisson::Full).point("b", [2.0, 0.0]);
    scene.rods.push(Rod::new("second", "a", "b").elements(Element::EulerBernoulli, 2));
    let mut of_all = scene.clone();
    of_all.temperature = Some(heated(ThermalModel::Transverse));
    refused(of_all.clone(), "temperature.model");
    scene.rods[1].temperature = Some(heated(ThermalModel::Transverse));
    refused(scene, "rods[1].temperature.model");
    // With another heat of its own the rod does not mind.
    of_all.rods[1].temperature = Some(heated(ThermalModel::None));
    assert!(Simulation::new(of_all).is_ok());

    let text = r#"{"l": 2.0, "h": 0.1, "w": 0.05, "theta": 0.0, "e0": [0, 0, 1, 0, 2, 0, 1, 0], "e": [0, 0, 1, 0, 2, 0, 1, 0],
        "edot": [0, 0, 0, 0, 0, 0, 0, 0], "E": 2e8, "nu": 0.25, "rho": 7200.0, "alpha": 1e-5, "dT": 100.0,
        "model": "transverse", "points": [[0.5, 0.0]]}"#;
    let error = CableState::parse(text, "state.json").unwrap_err();
    assert!(error.to_string().contains("`model` is \"transverse\""), "{error}");
    assert!(CableState::parse(&text.replace("transverse", "2d"), "state.json").is_ok());
}
