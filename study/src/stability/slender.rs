//! Slender cantilevers in statics under loads so small that the response is linear, up to a known term of second order.
//!
//! **Rounding.** The answer is bending, EI/L³; the rounded quantity is stretch, EA/L. The latter stiffness carries ε_mach of itself, which
//! is 12 (L/h)² ε_mach of the former; four such roundings at the end of a rod make ρ = 50 ε_mach (L/h)². One solution of the linear
//! equations loses that much. Newton's second iteration solves for what the first has left, and loses ρ of it. What remains is ρ², and the
//! rounding of the residual itself, [`residual`].
//!
//! **Second order.** A tip at δ turns the axis by w' = (3δ/2L)(1 − η²), η = 1 − x/L, which stretches it by f = ½w'² of the fourth degree.
//! An element's u' is of the second degree; the remainder, ½EA ∫ (f − quadratic)² dx, stiffens the rod. With the monic Legendre
//! polynomials p₃, p₄ of the unit interval η⁴ = p₄ + 2p₃ + …, so that one element has ½EAL (9δ²/8L²)² (‖p₄‖² + 4‖p₃‖²). The derivative by
//! δ over 3EIδ/L³ is (81/8)(‖p₄‖² + 4‖p₃‖²)(δ/h)² = 0.014694 (δ/h)². The paper's element has as much again across the rod: r_y has to keep
//! its length, 1 − ½w'², with coordinates of the second degree. With n elements an interpolation of the second degree leaves at most
//! l³ max|f‴|/(72√3), L³f‴ ≤ 24 · 9δ²/8L²: at most (81/8)(24/(72√3))² n⁻⁶ (δ/h)².

use nalgebra::Vector2;

use super::prelude::*;
use super::single_element::{SingleElement, free_directions, solve};
use ancf::equations::material::YoungPoisson;

pub const CASE: Case = Case {
    name: "slenderness",
    parameter: "L/h",
    unit: "relative",
    reference: "Timoshenko's cantilever, PL³/3EI + PL/GA (Euler's for the other element), which one element meets exactly at ν = 0, stiffened by \
                0.0147 (δ/h)² of itself (the paper's element 0.0294), as one element cannot stretch as its axis turns",
    right: "error of a tip δ of 1e-8 L at most ρ = 50 ε_mach (L/h)² of itself (stretch is 12 (L/h)² stiffer than bending and is rounded to ε_mach \
            of itself, four times) and no more than ρ² + (1.5n + 16) ε_mach, as Newton's second iteration solves for what rounding has left of the \
            first. Eight elements: plus at most 0.375 n⁻⁶ (δ/h)² (twice) of the second order. For comparison the total form of one element, \
            equations (9)–(21) in e and not in e − e₀: its strains are differences from 1. From 1e7 on ρ is more than the tip itself, and nothing \
            is required but a warning or a refusal.",
    trials,
};

/// Deflection of the tip, relative to the length of 1 m.
pub const TIP: f64 = 1e-8;

const SLENDERNESSES: [f64; 12] = [2.0, 5.0, 10.0, 30.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

/// ‖p₄‖² + 4‖p₃‖², of ‖pₙ‖² = n!⁴/((2n)!² (2n + 1)).
const REMAINDER: f64 = 1.0 / 44100.0 + 4.0 / 2800.0;

/// Relative stiffening of a cantilever's tip, over (δ/h)²: the value for one element, the bound for more.
pub fn stiffened(element: Element, elements: usize) -> f64 {
    let along = match elements {
        1 => 81.0 / 8.0 * REMAINDER,
        _ => 81.0 / 8.0 / 27.0 * (elements as f64).powi(-6),
    };
    if element == Element::Ancf { 2.0 * along } else { along }
}

/// Rounding of the residual of a cantilever, relative to its tip. Differences of neighbouring nodes are exact. A curvature is a sum of slopes
/// over l that cancel, and carries ε_mach θ/l, θ ≤ 3δ/2L: with one sign in n elements at a mean distance of ½L a tip of ¾n ε_mach δ. The
/// sums of two elements' forces at a node carry as much; and 16 roundings of the parameters, the load and the tip.
pub fn residual(elements: usize) -> f64 {
    (1.5 * elements as f64 + 16.0) * f64::EPSILON
}

/// Rounding of the tip if one solution of the linear equations loses `solution` of it: its square after Newton's second iteration, and the
/// residual; never more than of one solution.
pub fn after_two_iterations(solution: f64, elements: usize) -> f64 {
    solution.min(solution.powi(2) + residual(elements))
}

fn trials() -> Vec<Trial> {
    let trial = |(element, elements, slenderness)| {
        let name = format!("{element}, {elements} element{}", if elements == 1 { "" } else { "s" });
        let trial = Trial::new(name, slenderness, move || measure(element, elements, slenderness));
        trial.fast(true).expect(Expected::result_if(slenderness <= 1e5))
    };
    iproduct!(ELEMENTS, [1, 8], SLENDERNESSES).map(trial).collect()
}

fn measure(element: Element, elements: usize, slenderness: f64) -> Result<Finding> {
    let scene = light_cantilever(element, elements, slenderness, 0.0, TIP)?.newton(1e-15);
    let own = run(&scene)?;
    let second = stiffened(element, elements) * (TIP * slenderness).powi(2);
    // Known for one element, bounded for more.
    let (known, unknown) = if elements == 1 { (second, second * second) } else { (0.0, second) };
    let solution = 50.0 * f64::EPSILON * slenderness.powi(2);
    let rounding = after_two_iterations(solution, elements);
    let error_of = |tip: f64| (tip / (TIP * (1.0 - known)) - 1.0).abs();
    let error = error_of(-last_tip(&own)[1]);
    let why = format!(
        "rounding {rounding:.1e} (one solution {solution:.1e}), second order known {known:.1e}, unknown {unknown:.1e}"
    );
    let beside = (element == Element::Ancf && elements == 1).then(|| error_of(-total(&scene)));
    Ok(Finding { error, bound: rounding + unknown, why, rounding, beside, ..Finding::of(own) })
}

/// The tip in the paper's own form: absolute coordinates e, forces (19), tangent, Newton's iteration on a dense matrix.
fn total(scene: &Scene) -> f64 {
    let (section, material) = (&scene.section, &scene.material);
    let moduli = YoungPoisson { E: material.youngs_modulus, nu: material.nu };
    let beam = SingleElement::new(section.height, 0.0, moduli);
    let free = free_directions(Vector2::y());
    let mut e = beam.element.e_0;
    for _ in 0..6 {
        let mut residual = -beam.forces(&e);
        residual[11] += scene.forces[0].force[1];
        let Some(change) = solve(&beam.tangent(&e, false), &residual, &free) else { return f64::NAN };
        e.iter_mut().zip(&change).for_each(|(e, change)| *e += change);
    }
    e[11]
}
