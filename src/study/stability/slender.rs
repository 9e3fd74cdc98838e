//! Slender cantilevers in statics under loads so small that the answer is linear.
//!
//! What is solved for is bending, EI/L³, and what is rounded is stretch, EA/L: the stiffness of the latter carries ε_mach of itself,
//! which is 12 (L/h)² ε_mach of the former; four of such roundings at the end of a rod make 50. The load itself is not quite small:
//! of second order in the tip's angle over the section's, (1e-8 L/h)².

use nalgebra::{DMatrix, DVector, Vector3};

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{EPS, builtin, last};
use crate::equations::force::{self, Element as Beam};
use crate::equations::shape::Vector14;
use crate::equations::{material, shape};
use crate::error::Result;
use crate::run::run;
use crate::scene::{Element, Scene};

pub const CASE: Case = Case {
    name: "slenderness",
    parameter: "L/h",
    unit: "relative",
    reference: "Timoshenko's cantilever, PL³/3EI + PL/GA (Euler's for the other element), which one element meets exactly at ν = 0",
    right: "tip of 1e-8 L at most 50 ε_mach (L/h)² + (1e-8 L/h)² of itself off: stretch is 12 (L/h)² stiffer than bending and is rounded \
            to ε_mach of itself. Beside it the total form, equations (9)–(21) in e and not in e − e₀, one element: its strains are \
            differences from 1.",
    trials,
};

/// Of the length, which is 1 m.
const TIP: f64 = 1e-8;

const SLENDERNESSES: [f64; 12] = [2.0, 5.0, 10.0, 30.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

fn trials() -> Result<Vec<Trial>> {
    let variants = [(Element::Ancf, 1), (Element::Ancf, 8), (Element::EulerBernoulli, 1), (Element::EulerBernoulli, 8)];
    let trials = variants.into_iter().flat_map(|(element, elements)| {
        SLENDERNESSES.map(|slenderness| {
            let name = format!("{element}, {elements} element{}", if elements == 1 { "" } else { "s" });
            let expected = if slenderness <= 1e5 { Expected::Result } else { Expected::ResultOrRefusal };
            Trial::new(name, slenderness, move || measure(element, elements, slenderness)).fast(true).expect(expected)
        })
    });
    Ok(trials.collect())
}

/// The scene, whose tip has to move by [`TIP`].
fn scene(element: Element, elements: usize, slenderness: f64) -> Result<Scene> {
    let mut scene = builtin("cantilever")?;
    let (h, modulus) = (1.0 / slenderness, scene.material.youngs_modulus);
    (scene.section.height, scene.section.width) = (h, h);
    (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
    scene.time.newton_tolerance = 1e-15;
    let shear = if element == Element::Ancf { 1.0 / (0.5 * modulus * h * h) } else { 0.0 };
    let compliance = 1.0 / (3.0 * modulus * h.powi(4) / 12.0) + shear;
    scene.forces[0].force = [0.0, -TIP / compliance];
    Ok(scene)
}

fn measure(element: Element, elements: usize, slenderness: f64) -> Result<Finding> {
    let scene = scene(element, elements, slenderness)?;
    let run = run(&scene)?;
    let (rounding, nonlinear) = (50.0 * EPS * slenderness.powi(2), (TIP * slenderness).powi(2));
    Ok(Finding {
        error: (-last(&run, "tip.y") / TIP - 1.0).abs(),
        bound: rounding + nonlinear,
        why: format!("rounding {rounding:.1e}, large angle {nonlinear:.1e}"),
        size: Some(1.0),
        counts: run.counts,
        warnings: run.warnings,
        beside: (element == Element::Ancf && elements == 1).then(|| (-total(&scene) / TIP - 1.0).abs()),
    })
}

/// The tip by the paper's own arrangement: absolute coordinates e, forces (19), tangent, Newton's iteration on a dense matrix.
fn total(scene: &Scene) -> f64 {
    let (section, material) = (&scene.section, &scene.material);
    let (lambda, mu) =
        (material::lambda(material.youngs_modulus, material.nu), material::mu(material.youngs_modulus, material.nu));
    let (t, n) = (nalgebra::Vector2::x(), nalgebra::Vector2::y());
    let zero = nalgebra::Vector2::zeros();
    let e_0 = shape::e(&shape::Nodes { r_i: zero, r_y_i: n, r_j: t * 0.5, r_x_j: t, r_y_j: n, r_k: t, r_y_k: n });
    let element = Beam { l: 1.0, h: section.height, w: section.width, e_0 };
    // Held: both coordinates of rⁱ and the first of r_yⁱ.
    let free: Vec<usize> = (3..14).collect();
    let (mut e, no_heat): (Vector14, _) = (e_0, Vector3::zeros());
    for _ in 0..6 {
        let stiffness = force::K(
            lambda,
            mu,
            &force::K_1(&e, &no_heat, &element),
            &force::K_2(&e, &no_heat, &element),
            &force::K_3(&e, &no_heat, &element),
        );
        let mut residual = -force::Q_e(&e, &stiffness);
        residual[11] += scene.forces[0].force[1];
        let tangent = force::tangent(&e, &no_heat, lambda, mu, &element);
        let of_free = DMatrix::from_fn(free.len(), free.len(), |row, column| tangent[(free[row], free[column])]);
        let Some(change) = of_free.lu().solve(&DVector::from_fn(free.len(), |row, _| residual[free[row]])) else {
            return f64::NAN;
        };
        free.iter().zip(&change).for_each(|(place, change)| e[*place] += change);
    }
    e[11]
}
