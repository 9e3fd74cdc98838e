//! Cantilevers bent to a circle by a moment.

use ancf::internals::elements::Meaning;
use ancf::internals::structure::Structure;
use ancf::model::Scene;
use nalgebra::{DVector, Matrix2, Vector2};

use crate::common::evidence;
use crate::common::references::{
    EI, Kind, Reference, References, Shape, assert_stored, at_rest, off, slender, vectors,
};

/// Bent by the moment M at a's section, which turns with it: M × d/|d|² on the slope d there, the director r_y or r_x,
/// whose work is M δφ. Plain Newton with the load's own derivative, from the circle of `reference`, which no mesh has
/// as its equilibrium.
///
/// ```text
///   ▒▒│
///   ▒▒o ═════════════════ a ↺ M
///   ▒▒
/// ```
fn bent(scene: &Scene, M: f64, reference: &Reference) -> Shape {
    let structure = Structure::new(scene).unwrap();
    let vectors = vectors(scene);
    let mut u = DVector::zeros(structure.size());
    for (vector, (meaning, place)) in vectors.iter().enumerate() {
        let change = on_circle(reference, *meaning, place / scene.rods[0].elements as f64);
        for component in [0, 1] {
            if let Some(unknown) = structure.unknown("rod", vector, component) {
                u[unknown] = change[component];
            }
        }
    }
    let last = vectors.len() - 1;
    let end = [0, 1].map(|component| structure.unknown("rod", last, component).unwrap());
    for _ in 0..30 {
        let d = at_rest(vectors[last].0) + Vector2::new(u[end[0]], u[end[1]]);
        let (across, square) = (Vector2::new(-d.y, d.x), d.norm_squared());
        let load = M / square * across;
        let load_rate = M / square * (Matrix2::new(0.0, -1.0, 1.0, 0.0) - 2.0 / square * across * d.transpose());
        let mut residual = DVector::zeros(structure.size());
        structure.force(&u, &[[0.0; 2]], &mut residual);
        let mut K = structure.tangent(&u, &[[0.0; 2]]).dense();
        for i in 0..2 {
            residual[end[i]] -= load[i];
            for j in 0..2 {
                K[(end[i], end[j])] -= load_rate[(i, j)];
            }
        }
        let du = K.lu().solve(&residual).unwrap();
        u -= &du;
        if du.amax() <= 1e-12 {
            return Shape::new(scene, structure, u);
        }
    }
    panic!("no equilibrium under the moment {M:e} N m");
}

/// What a nodal vector at s of a rod of 1 m changes by as it becomes the circle.
fn on_circle(reference: &Reference, meaning: Meaning, s: f64) -> Vector2<f64> {
    let [turned, stretch] = ["turned", "stretch"].map(|name| reference.value(name));
    let (sin, cos) = (turned * s).sin_cos();
    match meaning {
        Meaning::Position => stretch / turned * Vector2::new(sin, 1.0 - cos) - Vector2::new(s, 0.0),
        Meaning::SlopeX => stretch * Vector2::new(cos, sin) - Vector2::x(),
        Meaning::SlopeY => reference.value("thickness") * Vector2::new(-sin, cos) - Vector2::y(),
    }
}

/// The end moment 2πEI/L bends the elastica to a full circle. The paper's rod softens as its fibres shorten, turns
/// further and shortens: the tip's distance from the clamp is that of the closed form, to which the element converges
/// with order 4, and not zero. Euler and Bernoulli's rod is the elastica here, as no force stretches it.
#[test]
fn a_moment_bends_the_rod_to_the_circle_of_its_strain() {
    let references = References::load();
    let elastica = references.entry("circle-elastica");
    // Kind, entry, h, distances of the tip, distance of the slope there with 32 elements, order between 32
    // and 64: above four, and falling, as long as the slenderest rod's locking fades.
    let stored = [
        (
            Kind::Paper,
            "circle-green-lagrange-0.05",
            0.05,
            [1.6893e-3, 1.0900e-4, 6.9131e-6, 4.3385e-7],
            4.9315e-5,
            3.99,
        ),
        (
            Kind::Paper,
            "circle-green-lagrange-0.02",
            0.02,
            [1.7819e-3, 1.0004e-4, 6.2748e-6, 3.9340e-7],
            4.0296e-5,
            4.00,
        ),
        (
            Kind::Paper,
            "circle-green-lagrange-0.01",
            0.01,
            [2.6018e-3, 1.0236e-4, 6.2079e-6, 3.8833e-7],
            3.9292e-5,
            4.00,
        ),
        (Kind::EulerBernoulli, "circle-elastica", 0.05, [1.4418e-3, 8.9978e-5, 5.6306e-6, 3.5206e-7], 8.4090e-5, 4.00),
        (Kind::EulerBernoulli, "circle-elastica", 0.01, [2.1114e-3, 1.0075e-4, 6.1735e-6, 3.8551e-7], 3.9221e-5, 4.00),
        (Kind::EulerBernoulli, "circle-elastica", 0.001, [4.5270e-2, 3.3636e-4, 7.1344e-6, 3.9069e-7], 4.4906e-5, 4.19),
    ];
    for (kind, id, h, errors, slope, stored_order) in stored {
        let reference = references.entry(id);
        let mut before = f64::NAN;
        for (elements, stored) in [8, 16, 32, 64].into_iter().zip(errors) {
            let scene = slender(kind, h, elements);
            let shape = bent(&scene, elastica.value("turned") * EI(&scene), &reference);
            let at = Vector2::x() + shape.tip();
            let error = off(at, reference.tip());
            let (order, away) = ((before / error).log2(), off(at, elastica.tip()));
            println!(
                "{kind:?}, {id}, h/L = {h}, {elements:2}: tip off by {error:.4e} L, order {order:.2}, \
                 {away:.4e} L from o"
            );
            assert_stored(&format!("{kind:?}, {id}, {h}, {elements} elements"), error, stored);
            if elements == 64 {
                evidence::at_most("references.circle", error);
            }
            assert!(elements < 64 || (order - stored_order).abs() <= 0.05, "{kind:?}, {id}, {h}: order {order:.2}");
            before = error;
            if elements == 32 {
                let (meaning, _) = vectors(&scene)[vectors(&scene).len() - 1];
                let error = (shape.last_slope() - at_rest(meaning) - on_circle(&reference, meaning, 1.0)).norm();
                println!("{kind:?}, {id}, h/L = {h}, {elements}: slope off by {error:.4e}");
                assert_stored(&format!("{kind:?}, {id}, {h}, the tip's slope"), error, slope);
            }
        }
    }
}
