//! Mistakes in the moduli of (17) and in the constitutive law (16).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Vector3;

use super::candidate::{Candidate, candidate, possible};
use super::entries::rows;
use super::mistake::MistakeKind::Poisson;
use ancf::equations::force;
use ancf::equations::material::{self as law, LameConstants};
use ancf::equations::shape::Vector14;
use ancf::state::{ElementState, evaluate};

/// Quantities that depend on the thermal strain and on λ and μ, and their parts.
pub(super) const HEATED: [&str; 7] = ["18.U", "21.K_1", "21.K_2", "21.K_3", "20.K", "19.Q_e", "tangent.dQ_e"];

/// Candidates with other moduli: for (17) itself all products of powers, for quantities that use it the known mistakes.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    match quantity {
        "17.lambda" => products(state, "λ"),
        "17.mu" => products(state, "μ"),
        "16.D" | "15.sigma" => laws(quantity, state),
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
        "15.sigma" => Some(
            evaluate("14.epsilon", state)?
                .chunks_exact(3)
                .flat_map(|eps| rows(&(law::D(lame) * Vector3::from_row_slice(eps))))
                .collect(),
        ),
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
