//! Mistakes in the moduli of (17) and in the constitutive law (16).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{Matrix3, Vector3};

use super::candidate::{Candidate, candidate, possible};
use super::entries::rows;
use super::mistake::MistakeKind::{Factor, Missing, Other, Poisson, Sign};
use ancf::equations::force;
use ancf::equations::material::{self as law, LameConstants};
use ancf::equations::shape::Vector14;
use ancf::state::{ElementState, evaluate};

/// Quantities that depend on the thermal strain and on λ and μ, and their parts.
pub(super) const HEATED: [&str; 7] = ["18.U", "21.K_1", "21.K_2", "21.K_3", "20.K", "19.Q_e", "tangent.dQ_e"];

/// Candidates with other moduli: for (17) itself all products of powers, for quantities that use it the known mistakes.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    match quantity {
        "17.lambda" => [products(state, "λ"), ratios(state, |lame| lame.lambda)].into_iter().flatten().collect(),
        "17.mu" => [products(state, "μ"), ratios(state, |lame| lame.mu)].into_iter().flatten().collect(),
        "16.D" | "15.sigma" => [laws(quantity, state), matrices(quantity, state)].into_iter().flatten().collect(),
        _ if HEATED.contains(&quantity) => laws(quantity, state),
        _ => Vec::new(),
    }
}

/// Name and value of a bracket of (17) as a function of ν.
type Bracket = (&'static str, fn(f64) -> f64);

/// 2ᵃ E νᵇ (1 + ν)ᶜ (1 − ν)ᵈ (1 − 2ν)ᵉ (1 + 2ν)ᶠ with small exponents.
fn products<'a>(state: &'a ElementState, symbol: &str) -> Vec<Candidate<'a>> {
    const BRACKETS: [Bracket; 4] = [
        ("(1 + ν)", |nu| 1.0 + nu),
        ("(1 − ν)", |nu| 1.0 - nu),
        ("(1 − 2ν)", |nu| 1.0 - 2.0 * nu),
        ("(1 + 2ν)", |nu| 1.0 + 2.0 * nu),
    ];
    let mut all = Vec::new();
    for code in 0..81 {
        let exponents = [code % 3 - 1, code / 3 % 3 - 1, code / 9 % 3 - 1, code / 27 - 1];
        for with_nu in [false, true] {
            for (below, factor) in [("", 1.0), ("2", 0.5), ("3", 1.0 / 3.0), ("4", 0.25)] {
                let of_sign = |sign: i32| -> Vec<&str> {
                    BRACKETS.iter().zip(exponents).filter(|(_, n)| *n == sign).map(|(bracket, _)| bracket.0).collect()
                };
                let above = format!("E{}{}", if with_nu { "ν" } else { "" }, of_sign(1).concat());
                let brackets = of_sign(-1);
                let below = match (below, brackets.len()) {
                    ("", 0) => String::new(),
                    ("", 1) => format!("/{}", brackets.concat()),
                    (number, 0) => format!("/{number}"),
                    (number, _) => format!("/({number}{})", brackets.concat()),
                };
                let stress =
                    if with_nu && factor == 1.0 && exponents == [-1, -1, 0, 0] { ": plane stress" } else { "" };
                let value = move || {
                    let brackets = BRACKETS.iter().zip(exponents);
                    let product: f64 = brackets.map(|((_, bracket), n)| bracket(state.nu).powi(n)).product();
                    vec![factor * state.E * if with_nu { state.nu } else { 1.0 } * product]
                };
                all.push(candidate(Poisson, format!("{symbol} = {above}{below}{stress}"), value));
            }
        }
    }
    all.push(candidate(Poisson, format!("{symbol} = 0"), || vec![0.0]));
    all
}

/// Candidates for (17) with another Poisson's ratio, alike for λ and μ.
fn ratios(state: &ElementState, modulus: fn(LameConstants) -> f64) -> Vec<Candidate<'_>> {
    let whatever = |ratio: &str| format!("ν = {ratio} whatever the state says");
    let ratios = [
        ("|ν| for ν".to_string(), state.nu.abs()),
        ("−ν for ν".to_string(), -state.nu),
        (whatever("0"), 0.0),
        (whatever("0.25"), 0.25),
        (whatever("0.3"), 0.3),
        (whatever("0.33"), 0.33),
        (whatever("1/3"), 1.0 / 3.0),
    ];
    let with = |(what, nu): (String, f64)| {
        candidate(Poisson, what, move || vec![modulus(ElementState { nu, ..state.clone() }.moduli().into())])
    };
    ratios.map(with).into()
}

/// Candidates with other entries in D of (16).
fn matrices<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let LameConstants { lambda, mu } = state.moduli().into();
    let D = |diagonal: f64, beside: f64, shear: f64| {
        Matrix3::new(diagonal, beside, 0.0, beside, diagonal, 0.0, 0.0, 0.0, shear)
    };
    let (stiff, shear) = (lambda + 2.0 * mu, 2.0 * mu);
    let others = [
        (Factor, "λ + μ for λ + 2μ on the diagonal", D(lambda + mu, lambda, shear)),
        (Missing, "2μ for λ + 2μ on the diagonal", D(2.0 * mu, lambda, shear)),
        (Missing, "λ for λ + 2μ on the diagonal", D(lambda, lambda, shear)),
        (Other, "E for λ + 2μ on the diagonal", D(state.E, lambda, shear)),
        (Missing, "no λ beside the diagonal", D(stiff, 0.0, shear)),
        (Sign, "−λ for λ beside the diagonal", D(stiff, -lambda, shear)),
        (Other, "μ for λ beside the diagonal", D(stiff, mu, shear)),
        (Other, "2μ for λ beside the diagonal", D(stiff, 2.0 * mu, shear)),
        (Other, "λ + 2μ beside the diagonal, λ on it", D(lambda, stiff, shear)),
        (Other, "E for 2μ in the shear", D(stiff, lambda, state.E)),
    ];
    let value = move |D: Matrix3<f64>| match quantity {
        "16.D" => Some(rows(&D)),
        _ => stresses(state, &D),
    };
    others.map(|(kind, what, D)| possible(kind, what, move || value(D))).into()
}

/// (15) with another law.
fn stresses(state: &ElementState, D: &Matrix3<f64>) -> Option<Vec<f64>> {
    let strains = evaluate("14.epsilon", state)?;
    Some(strains.chunks_exact(3).flat_map(|eps| rows(&(D * Vector3::from_row_slice(eps)))).collect())
}

/// Candidates with moduli that are often confused with those of (17).
fn laws<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let ElementState { E, nu, .. } = *state;
    let LameConstants { lambda, mu } = state.moduli().into();
    let constants = [
        ("plane stress in place of (16)", E * nu / (1.0 - nu * nu), mu),
        ("λ and μ exchanged", mu, lambda),
        ("λ = Eν/((1 + ν)(1 − ν)(1 − 2ν))", E * nu / ((1.0 + nu) * (1.0 - nu) * (1.0 - 2.0 * nu)), mu),
        ("λ = Eν/(1 − 2ν)", E * nu / (1.0 - 2.0 * nu), mu),
        ("λ = Eν/(1 + ν)", E * nu / (1.0 + nu), mu),
        ("λ = Eν/((1 − ν)(1 − 2ν))", E * nu / ((1.0 - nu) * (1.0 - 2.0 * nu)), mu),
        ("λ = Eν/((1 + ν)(1 + 2ν))", E * nu / ((1.0 + nu) * (1.0 + 2.0 * nu)), mu),
        ("the bulk modulus E/(3(1 − 2ν)) for λ", E / (3.0 * (1.0 - 2.0 * nu)), mu),
        ("λ = 0", 0.0, mu),
        ("E for λ + 2μ and no λ", 0.0, E / 2.0),
        ("μ = E/(2(1 − ν))", lambda, E / (2.0 * (1.0 - nu))),
        ("μ = E/(2(1 + 2ν))", lambda, E / (2.0 * (1.0 + 2.0 * nu))),
        ("μ = E/2, without ν", lambda, E / 2.0),
    ];
    let value = move |lame: LameConstants| match quantity {
        "16.D" => Some(rows(&law::D(lame))),
        "15.sigma" => stresses(state, &law::D(lame)),
        _ => with_heat_and_law(quantity, state, &state.eps_T(), lame),
    };
    let with = |(what, lambda, mu)| possible(Poisson, what, move || value(LameConstants { lambda, mu }));
    constants.map(with).into()
}

/// Energy, force, stiffness and tangent with another thermal strain and other moduli.
pub(super) fn with_heat_and_law(
    quantity: &str,
    state: &ElementState,
    eps_T: &Vector3<f64>,
    lame: LameConstants,
) -> Option<Vec<f64>> {
    let (e, element) = (Vector14::from(state.e), state.element());
    let K = || {
        let (K_1, K_2) = (force::K_1(&e, eps_T, &element), force::K_2(&e, eps_T, &element));
        force::K(lame, &K_1, &K_2, &force::K_3(&e, eps_T, &element))
    };
    match quantity {
        "18.U" => Some(vec![force::U(&e, eps_T, lame, &element)]),
        "21.K_1" => Some(rows(&force::K_1(&e, eps_T, &element))),
        "21.K_2" => Some(rows(&force::K_2(&e, eps_T, &element))),
        "21.K_3" => Some(rows(&force::K_3(&e, eps_T, &element))),
        "20.K" => Some(rows(&K())),
        "19.Q_e" => Some(rows(&force::Q_e(&e, &K()))),
        "tangent.dQ_e" => Some(rows(&force::tangent(&e, eps_T, lame, &element))),
        _ => None,
    }
}
