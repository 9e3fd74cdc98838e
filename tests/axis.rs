//! Axes of rods, [`Simulation::axis`]: against the equations in random states, and against closed forms.

use ancf::equations::{cable, shape};
use ancf::error::Error;
use ancf::internals::elements::{Ancf, Beam, Cable, Law};
use ancf::model::{Element, Force, Material, Method, Rod, Scene, Section, Support, Temperature, ThermalModel};
use ancf::nalgebra::{SVector, Vector2};
use ancf::run::Simulation;
use proptest::prelude::*;

const FRACTIONS: [f64; 5] = [0.0, 0.2, 0.5, 0.9, 1.0];

fn close(found: f64, expected: f64, tolerance: f64) -> bool {
    (found - expected).abs() <= tolerance
}

proptest! {
    /// Strain, director and curvature are those of (1), (9) and (13) along the rod. Rounding of slopes near 1 is the tolerance,
    /// and for the curvature that of a difference quotient.
    #[test]
    fn the_papers_section_is_that_of_the_equations(
        values in prop::array::uniform14(-0.3..0.3f64), l in 0.2..2.0f64, theta in -3.0..3.0f64,
    ) {
        let element = ancf::equations::element::Element::straight(l, 0.05, 0.02, theta);
        let law = Law::Uniaxial(ancf::equations::material::YoungPoisson { E: 1.0, nu: 0.0 });
        let u = SVector::<f64, 14>::from(values);
        let e = element.e_0 + u;
        let beam = Ancf::new(l, 0.05, 0.02, theta, law);
        for at in FRACTIONS {
            let section = beam.section_state(at, &u);
            let (r_x, d) = (shape::S_x(at * l, 0.0, l) * e, shape::S_y(at * l, 0.0, l) * e);
            prop_assert!((section.director - d).norm() < 1e-13);
            prop_assert!(close(section.strain, 0.5 * (r_x.dot(&r_x) - 1.0), 1e-12 * (1.0 + r_x.norm_squared())));
            let step = 1e-6 * l;
            let near = |sign: f64| shape::S_y(at * l + sign * step, 0.0, l) * e;
            let slope: Vector2<f64> = (near(1.0) - near(-1.0)) / (2.0 * step);
            let expected = d.perp(&slope) / d.norm_squared();
            prop_assert!(close(section.curvature, expected, 1e-7 * (1.0 + slope.norm()) / d.norm()));
        }
    }

    #[test]
    fn the_cables_section_is_that_of_its_equations(
        values in prop::array::uniform8(-0.1..0.1f64), l in 0.5..2.0f64, theta in -3.0..3.0f64,
    ) {
        let (sin, cos) = theta.sin_cos();
        let e_0 = cable::Vector8::from([0.0, 0.0, cos, sin, l * cos, l * sin, cos, sin]);
        let u = cable::Vector8::from(values);
        let beam = Cable::new(l, theta, 1.0, 1.0);
        for at in FRACTIONS {
            let section = beam.section_state(at, &u);
            let (r_x, r_xx) = (cable::r_x(at * l, &(e_0 + u), l), cable::r_xx(at * l, &(e_0 + u), l));
            prop_assert!(close(section.strain, cable::epsilon(&r_x, 0.0), 1e-13));
            prop_assert!(close(section.curvature, cable::kappa(&r_x, &r_xx), 1e-12 * (1.0 + r_xx.norm())));
            prop_assert!(close(section.director.dot(&r_x), 0.0, 1e-14) && close(section.director.norm(), 1.0, 1e-14));
            prop_assert!(r_x.perp(&section.director) > 0.0);
        }
    }
}

/// A cantilever of length L along (3, 4)/5 with a small load F across its end: κ = F(L − x)/EI, also between two elements,
/// and no strain. The load bends it by 10⁻⁶ of its length, and so far it is linear.
#[test]
fn curvature_of_a_cantilever() {
    let (young, height, width, length) = (7e10, 0.02, 0.03, 2.0);
    let bending = young * width * f64::powi(height, 3) / 12.0;
    let load = 3e-6 * bending / (length * length);
    for element in [Element::Ancf, Element::EulerBernoulli] {
        let mut scene = Scene::new(Material::new(young, 0.0, 2750.0), Section::new(height, width))
            .point("o", [0.0, 0.0])
            .point("a", [0.6 * length, 0.8 * length])
            .rod(Rod::new("rod", "o", "a").elements(element, 4))
            .support(Support::pinned("o").clamping("rod"))
            .force(Force::new("a", [-0.8 * load, 0.6 * load]));
        (scene.time.method, scene.time.load_steps) = (Method::Static, 1);
        let mut simulation = Simulation::new(scene).unwrap();
        simulation.finish().unwrap();
        let at: Vec<f64> = (0..=20).map(|n| f64::from(n) / 20.0).collect();
        for (point, at) in simulation.axis("rod", &at).unwrap().iter().zip(at) {
            let expected = load * length * (1.0 - at) / bending;
            // The end bears the load within an element, which the mean of its two sides hides elsewhere.
            assert!(
                close(point.curvature, expected, 1e-5 * load * length / bending),
                "{element}: {} at {at}, not {expected}",
                point.curvature
            );
            assert!(point.strain.abs() < 1e-11 && point.temperature == 0.0, "{element}: {point:?}");
        }
    }
}

/// A rod that expands freely has the strain of its heat: no elastic one is left. In statics the heat grows with the load.
#[test]
fn heat_strains_a_free_rod() {
    for (element, model) in [
        (Element::Ancf, ThermalModel::TwoD),
        (Element::Ancf, ThermalModel::OneD),
        (Element::Ancf, ThermalModel::Transverse),
        (Element::EulerBernoulli, ThermalModel::OneD),
    ] {
        let mut scene = Scene::new(Material::new(7e10, 0.0, 2750.0).alpha(2e-5), Section::new(0.02, 0.02))
            .point("o", [0.0, 0.0])
            .point("a", [1.0, 0.0])
            .rod(Rod::new("rod", "o", "a").elements(element, 2))
            .support(Support::pinned("o").clamping("rod"))
            .temperature(Temperature::new(model, vec![[0.0, 100.0]]));
        (scene.time.method, scene.time.load_steps) = (Method::Static, 2);
        let mut simulation = Simulation::new(scene).unwrap();
        for load in [0.5, 1.0] {
            simulation.run_until(load).unwrap();
            let thickness = match model {
                ThermalModel::TwoD | ThermalModel::Transverse => (1.0 + 2.0 * 2e-3 * load).sqrt(),
                _ => 1.0,
            };
            let along = if model == ThermalModel::Transverse { 0.0 } else { 2e-3 * load };
            for point in simulation.axis("rod", &[0.0, 0.3, 0.5, 1.0]).unwrap() {
                assert!(close(point.temperature, 100.0 * load, 1e-12) && close(point.thermal_strain, along, 1e-15));
                assert!(close(point.strain, point.thermal_strain, 1e-12), "{element}: {point:?}");
                assert!(close(point.director[1], thickness, 1e-12), "{element}: {point:?}");
            }
        }
    }
}

#[test]
fn readings_that_do_not_exist_are_refused() {
    let pendulum = Simulation::new(Scene::builtin("pendulum-2d").unwrap()).unwrap();
    assert!(matches!(pendulum.axis("rood", &[0.5]), Err(Error::Unknown { .. })));
    for at in [-0.1, 1.1, f64::NAN] {
        let error = pendulum.axis("rod", &[0.5, at]).unwrap_err();
        assert!(matches!(&error, Error::Scene { key, .. } if key == "at"), "{error}");
    }
}
