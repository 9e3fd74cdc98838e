//! The printed shear term (E3) in inclined rods: the stiffness that it loses in bending and along the axis.
//!
//! (16) with (18) counts ε₁₂² of the global axes once, where the contraction counts it twice: W lacks μ ε₁₂². With strains a along, c
//! across and s = ε₁₂ in the rod's own axes, S = sin 2θ and C = cos 2θ: ε₁₂ = ½(a − c)S + sC, and at ν = 0
//! W = μ(a² + c² + 2s² − ε₁₂²). A section that is free across and in shear minimises W. In tension s = ½ε₁₂C, and with k = S²/(2 + 2S²)
//! the least of a² + c² − k(a − c)² is (1 − 2k)/(1 − k) a²: compliance × (1 − k)/(1 − 2k), 1.5 at 45°. In bending the strain is a·y, while
//! c and s have no part that is odd in y: a²(1 − ¼S²), compliance × 1/(1 − ¼S²), 4/3 at 45°.
//!
//! If the thickness changes along the rod, 2s has the odd part c'y, and ε₁₂² couples it with bending: −½μI SC a₁c'. Integrated by parts,
//! this is a force f = ½μI SC PL/EI_b on c at the clamp, and f/L along the rod. An element's c is quadratic, c(0) + mean ≤ 4√∫c²/L, and its
//! own energy at least ⅔μA c²: the compliance grows by at most ⅔ (SC)²(h/L)² of itself.

use nalgebra::{DVector, Matrix3, Vector2, Vector3};

use super::prelude::*;
use super::single_element::{SingleElement, free_directions, solve};
use ancf::equations::material::{self, YoungPoisson};
use ancf::equations::shape::Vector14;

pub const CASE: Case = Case {
    name: "inclined-printed-shear",
    parameter: "inclination θ, °",
    unit: "relative",
    reference: "the least energy of a section with the printed term, by hand: compliance × 1/(1 − ¼ sin²2θ) in bending, × (1 − k)/(1 − 2k), \
                k = sin²2θ/(2 + 2 sin²2θ), along the axis; of the consistent form × 1 at every angle",
    right: "error of the compliance of one element, L/h = 100, through `equations/`, at most 50 ε_mach (L/h)² in bending, as in slenderness (along the \
            axis 50 ε_mach), and ⅔ (sin 2θ cos 2θ h/L)² more for the printed form in bending, which changes the thickness; the shear part PL/GA of \
            the tip by the section's 3 × 3 stiffness.",
    trials,
};

const SLENDERNESS: f64 = 100.0;
const E: f64 = 2e8;
const MODULI: YoungPoisson = YoungPoisson { E, nu: 0.0 };

fn trials() -> Vec<Trial> {
    let variants = [
        ("printed, bending", true, true),
        ("printed, along the axis", true, false),
        ("consistent, bending", false, true),
        ("consistent, along the axis", false, false),
    ];
    let trial = |((name, printed, across), degrees)| {
        Trial::new(name, degrees, move || measure(degrees, printed, across)).fast(true)
    };
    iproduct!(variants, [0.0, 10.0, 22.5, 45.0, 60.0, 80.0, 90.0]).map(trial).collect()
}

fn measure(degrees: f64, printed: bool, across: bool) -> Result<Finding> {
    let theta = f64::to_radians(degrees);
    let (h, mu) = (1.0 / SLENDERNESS, material::mu(MODULI));
    let (area, bending) = (h * h, E * h.powi(4) / 12.0);
    let (sin, cos) = ((2.0 * theta).sin(), (2.0 * theta).cos());
    let loss = if printed { 1.0 } else { 0.0 };
    // The section's stiffness in (a, c, γ = 2s), over its area.
    let lacking = Vector3::new(0.5 * sin, -0.5 * sin, 0.5 * cos);
    let own = Matrix3::from_diagonal(&Vector3::new(2.0, 2.0, 1.0));
    let section = (own - lacking * lacking.transpose() * (2.0 * loss)) * mu;
    let flexible = section.try_inverse().unwrap_or_else(|| Matrix3::repeat(f64::NAN)) / area;
    let factor = 1.0 / (1.0 - 0.25 * loss * sin * sin);
    let expected = if across { factor / (3.0 * bending) + flexible[(2, 2)] } else { flexible[(0, 0)] };
    let k = loss * sin * sin / (2.0 + 2.0 * sin * sin);
    let by_hand = if across { factor } else { (1.0 - k) / (1.0 - 2.0 * k) };
    // The coupling of thickness and bending derived above.
    let thickness = 2.0 / 3.0 * loss * (sin * cos / SLENDERNESS).powi(2);
    let found = compliance(theta, printed, across)?;
    // Along the axis nothing is stiffer than the measured compliance.
    let rounding = 50.0 * f64::EPSILON * if across { SLENDERNESS.powi(2) } else { 1.0 };
    let unit = if across { 1.0 / (3.0 * bending) } else { 1.0 / (E * area) };
    // Along the axis the factor by hand and the section's inverse have to agree.
    let two_ways = if across { 0.0 } else { (expected / (unit * by_hand) - 1.0).abs() };
    let error = (found / expected - 1.0).abs().max(two_ways);
    let bound = rounding + if across { thickness } else { 0.0 };
    let why = format!("compliance × {:.4}, by hand × {by_hand:.4} (bending beside shear)", found / unit);
    Ok(Finding { error, bound, why, size: 1.0, rounding, ..Finding::default() })
}

/// Displacement of the tip of one clamped element by a force of 1 N, across or along, by the tangent at rest.
fn compliance(theta: f64, printed: bool, across: bool) -> Result<f64> {
    let (sin, cos) = theta.sin_cos();
    let (t, n) = (Vector2::new(cos, sin), Vector2::new(-sin, cos));
    let beam = SingleElement::new(1.0 / SLENDERNESS, theta, MODULI);
    let mut load = Vector14::zeros();
    load.fixed_rows_mut::<2>(10).copy_from(if across { &n } else { &t });
    let singular = || ancf::error::Error::Singular { time: 0.0, iteration: 1, place: "the inclined element".into() };
    let moved = solve(&beam.tangent(&beam.element.e_0, printed), &load, &free_directions(n)).ok_or_else(singular)?;
    Ok(DVector::from_column_slice(load.as_slice()).dot(&moved))
}
