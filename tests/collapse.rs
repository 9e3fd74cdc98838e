//! Collapse of an element: `Beam::min_det_j` is the smallest det J of `equations/` over the quadrature points. A run ends where it is
//! ≤ 0 or NaN, with rod, element and time.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;
#[path = "common/states.rs"]
mod states;

use ancf::equations::material::LameConstants;
use ancf::equations::{cable, shape, strain};
use ancf::error::Error;
use ancf::internals::elements::{Ancf, Beam, Cable, Law};
use ancf::internals::equations::volume;
use ancf::model::{Element, Force, Method, Poisson, Scene};
use ancf::run::run;
use proptest::prelude::*;
use states::{cases, states};

proptest! {
    #![proptest_config(cases(256))]

    /// Displacements up to three times the element, so that a third of the states has collapsed.
    #[test]
    fn min_det_j_is_the_least_determinant(s in states(), far in 0.0..3.0f64, seed in any::<[i8; 14]>()) {
        let element = s.element();
        let u = nalgebra::SVector::<f64, 14>::from_fn(|i, _| {
            let size = if matches!(i / 2, 0 | 2 | 5) { s.l } else { 1.0 };
            far * size * f64::from(seed[i]) / 128.0
        });
        let kernel = Ancf::new(s.l, s.h, s.w, s.theta, Law::PlaneStrain { lame: LameConstants { lambda: 1.0, mu: 1.0 }, poisson: Poisson::Full });
        let e = element.e_0 + u;
        let determinants = volume::gauss_points(s.l, s.h, s.w)
            .map(|point| strain::J(point.x, point.y, &e, &element).determinant());
        let expected = determinants.into_iter().fold(f64::INFINITY, f64::min);
        let scale = (1.0 + far * (1.0 + s.h / s.l)).powi(2) * 100.0;
        let found = kernel.min_det_j(&u, &u);
        prop_assert!((found - expected).abs() <= 1e-14 * scale, "{found:e}, {expected:e}");
    }

    /// Euler–Bernoulli: the outermost fibre's |r_x| − |y| |θ_x|, of r_x and r_xx at the three points of the curvature.
    #[test]
    fn min_det_j_of_a_cable_is_the_least_stretch_of_a_fibre(theta in -3.2..3.2f64, h in 0.01..0.5f64, seed in any::<[i8; 8]>()) {
        let (l, t) = (1.3, nalgebra::Vector2::new(theta.cos(), theta.sin()));
        let e_0 = cable::Vector8::from_fn(|i, _| match i / 2 { 1 | 3 => t[i % 2], 2 => l * t[i % 2], _ => 0.0 });
        let u = cable::Vector8::from_fn(|i, _| 1.5 * f64::from(seed[i]) / 128.0);
        let beam = Cable::new(l, theta, 1.0, h * h / 12.0);
        let y = (3.0f64 / 5.0).sqrt() * h / 2.0;
        let expected = volume::axis_points(&volume::GAUSS_3, l)
            .map(|(x, _)| {
                let (r_x, r_xx) = (cable::r_x(x, &(e_0 + u), l), cable::r_xx(x, &(e_0 + u), l));
                r_x.norm() - y * (r_x.perp(&r_xx) / r_x.norm_squared()).abs()
            })
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        // From the state itself nothing has turned: the squares of r_x at the five points are no less than 0.
        let found = beam.min_det_j(&u, &u);
        let squares = volume::axis_points(&volume::GAUSS_5, l).map(|(x, _)| cable::r_x(x, &(e_0 + u), l).norm_squared());
        let expected = squares.into_iter().fold(expected, f64::min);
        prop_assert!((found - expected).abs() <= 1e-12 * (1.0 + expected.abs()), "{found:e}, {expected:e}");
    }
}

/// A rod turned by 80° in a step is itself, by 100° it may be its mirror image.
#[test]
fn an_axis_that_turns_by_more_than_a_right_angle_is_not_followed() {
    let beam = Cable::new(1.0, 0.0, 1.0, 1e-4);
    let turned = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        cable::Vector8::from([0.0, 0.0, cos - 1.0, sin, cos - 1.0, sin, cos - 1.0, sin])
    };
    assert!(beam.min_det_j(&turned(0.0), &turned(80.0)) > 0.1 && beam.min_det_j(&turned(0.0), &turned(100.0)) < -0.1);
    assert!(
        beam.min_det_j(&turned(0.0), &turned(180.0)) < -0.9 && beam.min_det_j(&turned(100.0), &turned(180.0)) > 0.1
    );
    // All seven vectors of the paper's element turned: det J is 1.
    let ancf = Ancf::new(
        1.0,
        0.1,
        0.1,
        0.0,
        Law::PlaneStrain { lame: LameConstants { lambda: 0.0, mu: 1.0 }, poisson: Poisson::Full },
    );
    let half = nalgebra::SVector::<f64, 14>::from([0., 0., 0., -2., -1., 0., -2., 0., 0., -2., -2., 0., 0., -2.]);
    assert!((ancf.min_det_j(&half, &half) - 1.0).abs() < 1e-15);
}

/// A NaN has collapsed, too.
#[test]
fn a_nan_has_collapsed() {
    let ancf = Ancf::new(
        1.0,
        0.1,
        0.1,
        0.0,
        Law::PlaneStrain { lame: LameConstants { lambda: 0.0, mu: 1.0 }, poisson: Poisson::Full },
    );
    let mut u = nalgebra::SVector::<f64, 14>::zeros();
    u[6] = f64::NAN;
    assert!(ancf.min_det_j(&u, &u).is_nan());
}

/// The second of two rods is pressed to nothing: the error names it, the element and the time.
#[test]
fn the_error_names_rod_element_and_time() {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.points.insert("b".into(), [2.0, 0.0]);
    let mut second = scene.rods[0].clone();
    (second.name, second.from, second.to, second.elements) = ("weak".into(), "a".into(), "b".into(), 3);
    let mut weak = scene.material.clone();
    weak.youngs_modulus /= 100.0;
    second.material = Some(weak);
    scene.rods.push(second);
    scene.gravity = [0.0; 2];
    // Four times EA of the weak one, towards the hinge.
    scene.forces.push(Force { point: "b".into(), force: [-3200.0, 0.0], history: None });
    for (element, method) in [(Element::Ancf, Method::EnergyMomentum), (Element::EulerBernoulli, Method::Gauss)] {
        scene.rods.iter_mut().for_each(|rod| rod.element = element);
        (scene.time.method, scene.time.step, scene.time.end, scene.output.interval) = (method, 1e-4, 0.1, None);
        match run(&scene) {
            Err(Error::Collapsed { rod, element, elements, time, .. }) => {
                assert_eq!((rod.as_str(), element, elements), ("weak", 3, 3));
                // The wave of the weak rod takes 20 ms for an element.
                assert!(time > 1e-3 && time < 0.02, "{time}");
            }
            other => panic!("{:?}", other.map(|run| run.counts)),
        }
    }
}

/// A step that collapses an element is made again, shorter: a rod pressed suddenly by a tenth of EA, with steps up to 20 ms, in which
/// its end would pass through its beginning, and a tolerance that allows for that. Only where no shorter step helps it is an error, and
/// that of the element.
#[test]
fn adaptive_steps_are_shortened_before_an_element_collapses() {
    let pressed = |method, element, share: f64| {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        (scene.gravity, scene.rods[0].elements, scene.rods[0].element) = ([0.0; 2], 2, element);
        scene.forces.push(Force { point: "a".into(), force: [-share * 8e4, 0.0], history: None });
        (scene.time.method, scene.time.step, scene.time.end) = (method, 0.02, 0.1);
        (scene.time.tolerance, scene.output.interval) = (0.1, None);
        scene
    };
    for method in [Method::GaussAdaptive, Method::NystromAdaptive] {
        let run = run(pressed(method, Element::EulerBernoulli, 0.1)).unwrap();
        // Shortened by up to twice what rests under this force, and the tolerance.
        let x = run.trajectory.column("tip.x").unwrap();
        assert!(run.counts.rejected > 0 && x.iter().all(|x| (0.6..1.1).contains(x)), "{method}: {x:?}");
    }
    // Pressed to nothing for good.
    for method in [Method::GaussAdaptive, Method::NystromAdaptive] {
        let mut scene = pressed(method, Element::Ancf, 3.0);
        (scene.time.step, scene.time.tolerance) = (1e-3, 1e-6);
        match run(&scene) {
            Err(Error::Collapsed { rod, time, .. }) => assert!(rod == "rod" && time < 0.04, "{rod} {time}"),
            other => panic!("{method}: {:?}", other.map(|run| run.counts)),
        }
    }
}

/// What bounds how much an element may change between two looks at it: at every quadrature point r_x by 13 times, r_y by 1.3 times what
/// its nodes have moved, over its length, and its slopes have changed.
#[test]
fn gradients_change_no_more_than_thirteen_times_as_much_as_nodes() {
    for h in [0.01, 1.0, 20.0] {
        let l = 1.3;
        let by_slope_y = 1.0f64.min(l / h);
        let measures = [l, by_slope_y, l, 1.0, by_slope_y, l, by_slope_y];
        let sum =
            |values: [f64; 7]| values.iter().zip(measures).map(|(value, measure)| value.abs() * measure).sum::<f64>();
        let points = volume::gauss_points(l, h, 1.0);
        let along = points.iter().map(|point| sum(shape::S_i_x(point.x, point.y, l))).fold(0.0, f64::max);
        let across = points.iter().map(|point| sum(shape::S_i_y(point.x, point.y, l))).fold(0.0, f64::max);
        println!("h/l = {}: {along:.2}, {across:.2}", h / l);
        assert!(along <= 13.0 && across <= 1.3, "{along} {across}");
    }
    let l = 1.3;
    let sum =
        |x| cable::S_i_x(x, l).iter().zip([l, 1.0, l, 1.0]).map(|(value, measure)| value.abs() * measure).sum::<f64>();
    let along = volume::axis_points(&volume::GAUSS_5, l).map(|(x, _)| sum(x)).into_iter().fold(0.0, f64::max);
    println!("{along:.2}");
    assert!(along <= 13.0);
}
