//! The printed shear term (E3) in inclined rods: what it loses of the stiffness in bending and along the axis.
//!
//! (16) with (18) counts ε₁₂² of the global axes once, where the contraction counts it twice: W lacks μ ε₁₂². With strains a along, c
//! across and s = ε₁₂ in the rod's own axes, S = sin 2θ and C = cos 2θ: ε₁₂ = ½(a − c)S + sC, and at ν = 0
//! W = μ(a² + c² + 2s² − ε₁₂²). A section that is free across and in shear takes the a/W of the least W. Pulled, s = ½ε₁₂C, and with
//! k = S²/(2 + 2S²) the least of a² + c² − k(a − c)² is (1 − 2k)/(1 − k) a²: compliance × (1 − k)/(1 − 2k), 1.5 at 45°. Bent, the
//! strain is a·y while c and s have no part that is odd in y: a²(1 − ¼S²), compliance × 1/(1 − ¼S²), 4/3 at 45°.
//!
//! Where the thickness changes along the rod 2s has the odd part c'y, and ε₁₂² couples it with bending: −½μI SC a₁c'. By parts that is a
//! force f = ½μI SC PL/EI_b on c at the clamp, and f/L along the rod. An element's c is quadratic, c(0) + mean ≤ 4√∫c²/L, and its own
//! energy at least ⅔μA c²: the compliance grows by at most ⅔ (SC)²(h/L)² of itself.

use nalgebra::{DMatrix, DVector, Matrix3, Vector2, Vector3};

use super::case::{Case, Finding, Trial};
use super::helpers::EPS;
use crate::error::Result;
use ancf::equations::element::Element;
use ancf::equations::force;
use ancf::equations::material::{self, LameConstants, YoungPoisson};

pub const CASE: Case = Case {
    name: "inclined-printed-shear",
    parameter: "inclination θ, °",
    unit: "relative",
    reference: "the least energy of a section with the printed term, by hand: compliance × 1/(1 − ¼ sin²2θ) in bending, × (1 − k)/(1 − 2k), \
                k = sin²2θ/(2 + 2 sin²2θ), along the axis; the consistent form × 1 at every angle",
    right: "compliance of one element, L/h = 100, through `equations/`, at most 50 ε_mach (L/h)² off in bending, as in the case of slenderness \
            (along the axis 50 ε_mach), and printed in bending ⅔ (sin 2θ cos 2θ h/L)² more, as bending changes the thickness; the shear part PL/GA of the tip by the \
            section's 3 × 3 stiffness.",
    trials,
};

const SLENDERNESS: f64 = 100.0;
const E: f64 = 2e8;
const MODULI: YoungPoisson = YoungPoisson { E, nu: 0.0 };

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for (name, printed, across) in [
        ("printed, bending", true, true),
        ("printed, along the axis", true, false),
        ("consistent, bending", false, true),
        ("consistent, along the axis", false, false),
    ] {
        for degrees in [0.0, 10.0, 22.5, 45.0, 60.0, 80.0, 90.0] {
            trials.push(Trial::new(name, degrees, move || measure(degrees, printed, across)).fast(true));
        }
    }
    Ok(trials)
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
    // See above: what the thickness couples with bending.
    let thickness = 2.0 / 3.0 * loss * (sin * cos / SLENDERNESS).powi(2);
    let found = compliance(theta, printed, across)?;
    // Along the axis nothing is stiffer than what is asked for.
    let rounding = 50.0 * EPS * if across { SLENDERNESS.powi(2) } else { 1.0 };
    let unit = if across { 1.0 / (3.0 * bending) } else { 1.0 / (E * area) };
    // Along the axis the factor by hand and the section's inverse are two ways to the same.
    let two_ways = if across { 0.0 } else { (expected / (unit * by_hand) - 1.0).abs() };
    Ok(Finding {
        error: (found / expected - 1.0).abs().max(two_ways),
        bound: rounding + if across { thickness } else { 0.0 },
        why: format!("compliance × {:.4}, by hand × {by_hand:.4} (bending beside shear)", found / unit),
        size: 1.0,
        rounding,
        ..Finding::default()
    })
}

/// Displacement of the tip of one clamped element by a force of 1 N, across or along, by the tangent at rest.
fn compliance(theta: f64, printed: bool, across: bool) -> Result<f64> {
    let (sin, cos) = theta.sin_cos();
    let (t, n) = (Vector2::new(cos, sin), Vector2::new(-sin, cos));
    let element = Element::straight(1.0, 1.0 / SLENDERNESS, 1.0 / SLENDERNESS, theta);
    let of = if printed { force::tangent_printed } else { force::tangent };
    let tangent = of(&element.e_0, &Vector3::zeros(), LameConstants::from(MODULI), &element);
    // Free: r_yⁱ along n, as the clamp holds its direction, and all that follows.
    let free = DMatrix::from_fn(14, 11, |row, column| match column {
        0 => {
            if row == 2 || row == 3 {
                n[row - 2]
            } else {
                0.0
            }
        }
        _ => {
            if row == column + 3 {
                1.0
            } else {
                0.0
            }
        }
    });
    let direction = if across { n } else { t };
    let mut load = DVector::zeros(14);
    load.fixed_rows_mut::<2>(10).copy_from(&direction);
    let stiffness = free.transpose() * DMatrix::from_column_slice(14, 14, tangent.as_slice()) * &free;
    let right = free.transpose() * &load;
    let moved = stiffness.lu().solve(&right).ok_or_else(|| ancf::error::Error::Singular {
        time: 0.0,
        iteration: 1,
        place: "the inclined element".into(),
    })?;
    Ok(load.dot(&(free * moved)))
}
