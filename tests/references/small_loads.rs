//! Cantilevers under a load so small that the linear theory holds.

use crate::common::evidence;
use crate::common::references::{EI, Kind, Reference, References, length, push, rod, solve};

/// The Green–Lagrange strain is linear for a tip of 10⁻⁸ L. What remains is the next term of the strain against the
/// bending, (v/h)², and rounding, which a section's slope over its height carries to the tip as (L/h)².
fn bound(reference: &Reference) -> f64 {
    let slenderness = length(reference) / reference.parameter("h");
    50.0 * f64::EPSILON * slenderness.powi(2) + (1e-8 * slenderness).powi(2) + 1e-12
}

/// Timoshenko's cantilever, ν = 0, k = 1: with φ of degree 2 and v of degree 3 one element has the exact solution
/// among its fields. Without shear the tip is at PL³/3EI, a cubic as well; the section turns the same in both.
#[test]
fn one_element_is_exact_at_any_slenderness() {
    let references = References::load();
    for kind in Kind::ALL {
        for reference in references.tagged(&["timoshenko", "beam"], 4) {
            let scene = push(rod(kind, &reference, 1), reference.parameter("P"));
            let deflection = match kind {
                Kind::EulerBernoulli => -reference.parameter("P") * length(&reference).powi(3) / (3.0 * EI(&scene)),
                _ => reference.value("tip.y"),
            };
            let shape = solve(&scene);
            let error_of = |actual: f64, expected: f64| (actual / expected - 1.0).abs();
            let error = error_of(shape.tip().y, deflection).max(error_of(shape.angle(), reference.value("tip.angle")));
            let bound = bound(&reference);
            println!("{kind:?}, {}: tip and angle off by {error:.1e}, allowed {bound:.1e}", reference.id());
            evidence::at_most("references.one-element", error);
            assert!(error <= bound, "{kind:?}, {}: {error:.1e}, allowed {bound:.1e}", reference.id());
        }
    }
}

/// A strut by the uniaxial law, whatever its ν: the tip is at PL³/3EI + PL/GA, G = E/2(1 + ν), with one element as with
/// many. Plane strain's is at (1 − ν²)PL³/3EI + PL/GA.
#[test]
fn a_strut_feels_youngs_modulus_whatever_its_poissons_ratio() {
    let references = References::load();
    for (slenderness, nu) in [(10, -0.3), (10, 0.25), (100, 0.3), (100, 0.33), (100, 0.49), (1000, 0.3)] {
        let reference = references.entry(&format!("timoshenko-{slenderness}"));
        let (P, L) = (reference.parameter("P"), length(&reference));
        for elements in [1, 4] {
            let tip = |kind| {
                let mut scene = push(rod(kind, &reference, elements), P);
                scene.material.nu = nu;
                let shear = P * L * 2.0 * (1.0 + nu)
                    / (scene.material.youngs_modulus * scene.section.height * scene.section.width);
                (solve(&scene).tip().y + shear, P * L.powi(3) / (3.0 * EI(&scene)))
            };
            for (kind, share) in [(Kind::Uniaxial, 1.0), (Kind::Axis, 1.0 - nu * nu)] {
                let (bent, strut) = tip(kind);
                let error = (bent / (-share * strut) - 1.0).abs();
                let allowed = bound(&reference) * f64::from(elements as u32).powi(2);
                println!("{kind:?}, L/h {slenderness}, nu {nu}, {elements}: {error:.1e}, allowed {allowed:.1e}");
                assert!(
                    error <= allowed,
                    "{kind:?}, L/h {slenderness}, nu {nu}, {elements}: {error:.1e}, allowed {allowed:.1e}"
                );
            }
        }
    }
}

/// ν ≠ 0: the paper's field is linear in y, so that a bent section cannot thicken above its axis and thin below;
/// E₂₂ = 0 there puts λ + 2μ in place of E/(1 − ν²). The tip is (1 − 2ν)/(1 − ν)² of plane strain's, whatever the
/// mesh. With Poisson's terms on the axis bending feels E/(1 − ν²), and the same fields have plane strain's solution.
#[test]
fn poissons_ratio_locks_whatever_the_mesh_but_not_on_the_axis() {
    let references = References::load();
    let [free, locked] = ["timoshenko-plane-strain", "timoshenko-plane-strain-locked"].map(|id| references.entry(id));
    let (nu, slenderness) = (free.parameter("nu"), length(&free) / free.parameter("h"));
    for (kind, expected, share) in
        [(Kind::Paper, locked, (1.0 - 2.0 * nu) / (1.0 - nu).powi(2)), (Kind::Axis, free, 1.0)]
    {
        for elements in [1, 2, 5, 16] {
            let shape = solve(&push(rod(kind, &free, elements), free.parameter("P")));
            let error_of = |actual: f64, name: &str| (actual / expected.value(name) - 1.0).abs();
            let error = error_of(shape.tip().y, "tip.y").max(error_of(shape.angle(), "tip.angle"));
            let of_free = shape.tip().y / free.value("tip.y");
            println!("{kind:?}, {elements} elements: {of_free:.9} of plane strain, {error:.1e} off {}", expected.id());
            if kind == Kind::Axis {
                evidence::at_most("references.poisson-on-the-axis", error);
            } else {
                evidence::at_most("references.locked", error);
                evidence::number("references.locked-part", of_free);
            }
            // Shear, which does not lock, has a share of the order (h/L)².
            assert!((of_free - share).abs() <= slenderness.powi(-2), "{kind:?}, {elements}: {of_free}");
            // Rounding grows with the number of elements.
            let allowed = bound(&free) * (elements as f64).powi(2);
            assert!(error <= allowed, "{kind:?}, {elements}: {error:.1e}, allowed {allowed:.1e}");
        }
    }
}
