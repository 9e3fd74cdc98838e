//! Slender cantilevers in statics under loads so small that the answer is linear, but for what is known of the second order.
//!
//! **Rounding.** What is solved for is bending, EI/L³, and what is rounded is stretch, EA/L: the stiffness of the latter carries ε_mach
//! of itself, which is 12 (L/h)² ε_mach of the former; four of such roundings at the end of a rod make ρ = 50 ε_mach (L/h)². So much one
//! solution of the linear equations loses. Newton's second iteration solves for what the first has left, and loses ρ of that: ρ² is
//! left, and what rounds the residual itself, [`residual`].
//!
//! **Second order.** A tip at δ turns the axis by w' = (3δ/2L)(1 − η²), η = 1 − x/L, which stretches it by f = ½w'² of the fourth degree.
//! An element's u' is of the second degree: what of f is left over, ½EA ∫ (f − quadratic)² dx, stiffens the rod. With the monic
//! Legendre polynomials p₃, p₄ of the unit interval η⁴ = p₄ + 2p₃ + …, so that one element has ½EAL (9δ²/8L²)² (‖p₄‖² + 4‖p₃‖²); the
//! derivative by δ over 3EIδ/L³ is (81/8)(‖p₄‖² + 4‖p₃‖²)(δ/h)² = 0.014694 (δ/h)². The paper's element has the same once more across
//! the rod: r_y has to keep its length, 1 − ½w'², with coordinates of the second degree. With n elements an interpolation of the second
//! degree leaves at most l³ max|f‴|/(72√3), L³f‴ ≤ 24 · 9δ²/8L²: at most (81/8)(24/(72√3))² n⁻⁶ (δ/h)².

use nalgebra::{DMatrix, DVector, Vector3};

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, builtin, last};
use crate::error::Result;
use ancf::equations::element::Element as Beam;
use ancf::equations::force;
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::shape::Vector14;
use ancf::model::{Element, Scene};
use ancf::run::run;

pub const CASE: Case = Case {
    name: "slenderness",
    parameter: "L/h",
    unit: "relative",
    reference: "Timoshenko's cantilever, PL³/3EI + PL/GA (Euler's for the other element), which one element meets exactly at ν = 0, stiffened \
                by 0.0147 (δ/h)² of itself (the paper's element 0.0294), as one element cannot stretch as its axis turns",
    right: "tip δ of 1e-8 L off by at most ρ = 50 ε_mach (L/h)² of itself (stretch is 12 (L/h)² stiffer than bending and is rounded to ε_mach of \
            itself, four times) and no more than ρ² + (1.5n + 16) ε_mach, as Newton's second iteration solves for what rounding has left \
            of the first. Eight elements: and at most 0.375 n⁻⁶ (δ/h)² (twice) of the second order. Beside it the total form, equations \
            (9)–(21) in e and not in e − e₀, one element: its strains are differences from 1. From 1e7 on ρ is more than the tip itself, \
            and nothing is claimed but a warning or a refusal.",
    trials,
};

/// Of the length, which is 1 m.
const TIP: f64 = 1e-8;

const SLENDERNESSES: [f64; 12] = [2.0, 5.0, 10.0, 30.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

/// ‖p₄‖² + 4‖p₃‖², of ‖pₙ‖² = n!⁴/((2n)!² (2n + 1)).
const LEFT_OVER: f64 = 1.0 / 44100.0 + 4.0 / 2800.0;

/// How much of itself the tip of a cantilever is stiffened by, over (δ/h)²: what one element has, or the most that `elements` may have.
pub fn stiffened(element: Element, elements: usize) -> f64 {
    let along = match elements {
        1 => 81.0 / 8.0 * LEFT_OVER,
        _ => 81.0 / 8.0 / 27.0 * (elements as f64).powi(-6),
    };
    if element == Element::Ancf { 2.0 * along } else { along }
}

/// What rounds the residual of a cantilever, of its tip. Differences of neighbouring nodes are exact; a curvature is a sum of slopes over
/// l that cancel, and carries ε_mach θ/l, θ ≤ 3δ/2L: with one sign in n elements at a mean distance of ½L a tip of ¾n ε_mach δ; the sums
/// of two elements' forces at a node as much; and 16 roundings of the parameters, the load and the tip.
pub fn residual(elements: usize) -> f64 {
    (1.5 * elements as f64 + 16.0) * EPS
}

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
    let second = stiffened(element, elements) * (TIP * slenderness).powi(2);
    // One element: what it has is known. More: only how much it may be.
    let (known, unknown) = if elements == 1 { (second, second * second) } else { (0.0, second) };
    let solution = 50.0 * EPS * slenderness.powi(2);
    let rounding = solution.min(solution.powi(2) + residual(elements));
    let error = |tip: f64| (tip / (TIP * (1.0 - known)) - 1.0).abs();
    Ok(Finding {
        error: error(-last(&run, "tip.y")),
        bound: rounding + unknown,
        why: format!(
            "rounding {rounding:.1e} (one solution {solution:.1e}), second order known {known:.1e}, not known {unknown:.1e}"
        ),
        size: 1.0,
        rounding,
        counts: run.counts,
        warnings: run.warnings,
        beside: (element == Element::Ancf && elements == 1).then(|| error(-total(&scene))),
    })
}

/// The tip by the paper's own arrangement: absolute coordinates e, forces (19), tangent, Newton's iteration on a dense matrix.
fn total(scene: &Scene) -> f64 {
    let (section, material) = (&scene.section, &scene.material);
    let lame = LameConstants::from(YoungPoisson { E: material.youngs_modulus, nu: material.nu });
    let element = Beam::straight(1.0, section.height, section.width, 0.0);
    // Held: both coordinates of rⁱ and the first of r_yⁱ.
    let free: Vec<usize> = (3..14).collect();
    let (mut e, no_heat): (Vector14, _) = (element.e_0, Vector3::zeros());
    for _ in 0..6 {
        let stiffness = force::K(
            lame,
            &force::K_1(&e, &no_heat, &element),
            &force::K_2(&e, &no_heat, &element),
            &force::K_3(&e, &no_heat, &element),
        );
        let mut residual = -force::Q_e(&e, &stiffness);
        residual[11] += scene.forces[0].force[1];
        let tangent = force::tangent(&e, &no_heat, lame, &element);
        let of_free = DMatrix::from_fn(free.len(), free.len(), |row, column| tangent[(free[row], free[column])]);
        let Some(change) = of_free.lu().solve(&DVector::from_fn(free.len(), |row, _| residual[free[row]])) else {
            return f64::NAN;
        };
        free.iter().zip(&change).for_each(|(place, change)| e[*place] += change);
    }
    e[11]
}
