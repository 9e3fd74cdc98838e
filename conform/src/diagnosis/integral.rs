//! Mistakes in the integrands of (18), (21) and the tangent, and in quadrature rules.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{Vector2, Vector3};

use super::candidate::{Candidate, candidate, possible};
use super::entries::rows;
use super::mistake::MistakeKind::{self, Digits, Erratum, Heat, HeatOnShear, Missing, Other, Quadrature, Transpose};
use super::quadrature::{Integrand, K, bracket, exact, gauss, integrands, material, mean, points, product};
use ancf::equations::element::Matrix14;
use ancf::equations::material::{self as law, LameConstants};
use ancf::equations::shape::{self, Vector14};
use ancf::internals::equations::volume::{GAUSS_3, GAUSS_5, Point};
use ancf::state::{ElementState, ThermalModel};

/// Numbers of decimals of constants that were copied too short.
const SHORT: std::ops::RangeInclusive<i32> = 4..=12;

/// Candidates for a quantity that is an integral.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let mut all = other_integrands(quantity, state);
    if matches!(quantity, "6.T" | "7.M" | "gravity.Q_w" | "18.U" | "20.K" | "19.Q_e" | "tangent.dQ_e")
        || quantity.starts_with("21.K_")
    {
        let by =
            |(what, rule): (String, Vec<Point>)| possible(Quadrature, what, move || integrated(quantity, state, &rule));
        all.extend(rules(state).into_iter().map(by));
        let with =
            |(what, rule): (String, Vec<Point>)| possible(Digits, what, move || integrated(quantity, state, &rule));
        all.extend(short_constants(state).into_iter().map(with));
        if quantity == "tangent.dQ_e" {
            all.extend(
                rules(state)
                    .into_iter()
                    .map(|(what, rule)| candidate(Quadrature, what, move || with_the_right_K(state, &rule))),
            );
        }
    }
    all
}

/// Wrong quadrature rules: too few points, or points of another interval.
fn rules(state: &ElementState) -> Vec<(String, Vec<Point>)> {
    let mut all = Vec::new();
    for along in 1..=5 {
        for across in 1..=3 {
            if (along, across) != (5, 3) {
                let rule = points(state, gauss(along), gauss(across), |xi, eta| (xi, eta));
                all.push((format!("{along} × {across} Gauss points"), rule));
            }
        }
    }
    let exchanged = |rule: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let weights: Vec<f64> = rule.iter().map(|(_, weight)| *weight).collect();
        let middle = weights.len() / 2;
        let other = |n: usize| {
            if n == middle {
                weights[middle - 1]
            } else if n.abs_diff(middle) == 1 {
                weights[middle]
            } else {
                weights[n]
            }
        };
        rule.iter().enumerate().map(|(n, (point, _))| (*point, other(n))).collect()
    };
    let across = points(state, &GAUSS_5, &exchanged(&GAUSS_3), |xi, eta| (xi, eta));
    all.push(("weights 8/9 and 5/9 exchanged across the element".to_string(), across));
    let along = points(state, &exchanged(&GAUSS_5), &GAUSS_3, |xi, eta| (xi, eta));
    all.push(("weights of the middle point and of its neighbours exchanged along the element".to_string(), along));
    let half = |xi: f64| (1.0 + xi) / 2.0;
    let mut moved = |what: &str, by: &dyn Fn(f64, f64) -> (f64, f64)| {
        all.push((what.to_string(), points(state, &GAUSS_5, &GAUSS_3, by)));
    };
    moved("points of [0, 1] for [−1, 1] along the element", &|xi, eta| (half(xi), eta));
    moved("points of [0, 1] for [−1, 1] in both directions", &|xi, eta| (half(xi), half(eta)));
    moved("points of [0, 1] for [−1, 1] across the element", &|xi, eta| (xi, half(eta)));
    moved("x from −l to l", &|xi, eta| (2.0 * xi - 1.0, eta));
    moved("x from −l/2 to l/2", &|xi, eta| (xi - 1.0, eta));
    moved("y from −h to h", &|xi, eta| (xi, 2.0 * eta));
    moved("y from 0 to h", &|xi, eta| (xi, 1.0 + eta));
    all
}

/// The right rule, its points and weights with few digits.
fn short_constants(state: &ElementState) -> Vec<(String, Vec<Point>)> {
    let rule = |shorten: &dyn Fn(f64) -> f64| {
        let all = |rule: &[(f64, f64)]| -> Vec<(f64, f64)> {
            rule.iter().map(|(point, weight)| (shorten(*point), shorten(*weight))).collect()
        };
        points(state, &all(&GAUSS_5), &all(&GAUSS_3), |xi, eta| (xi, eta))
    };
    let single = ("Gauss points and weights in single precision".to_string(), rule(&|number| f64::from(number as f32)));
    let decimals = SHORT.map(|n| {
        let unit = 10f64.powi(n);
        (format!("Gauss points and weights with {n} decimals"), rule(&|number| (number * unit).round() / unit))
    });
    decimals.chain([single]).collect()
}

/// Value of a quantity by a quadrature rule.
fn integrated(quantity: &str, state: &ElementState, rule: &[Point]) -> Option<Vec<f64>> {
    let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
    let lame @ LameConstants { lambda, mu } = state.moduli().into();
    let S = |p: &Point| shape::S(p.x, p.y, state.l);
    let M = || rule.iter().fold(Matrix14::zeros(), |M, p| M + state.rho * p.dV * S(p).tr_mul(&S(p)));
    match quantity {
        "7.M" => return Some(rows(&M())),
        "6.T" => {
            let e_dot = Vector14::from(state.edot);
            return Some(vec![0.5 * e_dot.dot(&(M() * e_dot))]);
        }
        "gravity.Q_w" => {
            let g = Vector2::from(state.gravity);
            return Some(rows(&rule.iter().fold(Vector14::zeros(), |Q, p| Q + state.rho * p.dV * S(p).tr_mul(&g))));
        }
        _ => {}
    }
    let integrands = integrands(&e, &element, rule);
    let strain = |k: usize| move |s: &Integrand| bracket(s, &eps_T, k);
    let (one, two, three) = (strain(0), strain(1), strain(2));
    let K_1 = || K(&integrands, |s| [one(s), two(s), 0.0]);
    let K_2 = || K(&integrands, |s| [two(s), one(s), 0.0]);
    let K_3 = || K(&integrands, |s| [0.0, 0.0, three(s)]);
    let all = || (lambda + 2.0 * mu) * K_1() + lambda * K_2() + 4.0 * mu * K_3();
    match quantity {
        "18.U" => {
            let square = |k| 0.5 * (lambda + 2.0 * mu) * product(&integrands, &eps_T, k, k);
            let shear = 2.0 * mu * product(&integrands, &eps_T, 2, 2);
            Some(vec![square(0) + square(1) + lambda * product(&integrands, &eps_T, 0, 1) + shear])
        }
        "21.K_1" => Some(rows(&K_1())),
        "21.K_2" => Some(rows(&K_2())),
        "21.K_3" => Some(rows(&K_3())),
        "20.K" => Some(rows(&all())),
        "19.Q_e" => Some(rows(&(all() * e))),
        "tangent.dQ_e" => {
            let B = |s: &Integrand| s.S_1.map(|S_1| S_1 * e);
            Some(rows(&(all() + material(&integrands, B, stiffness(lame)))))
        }
        _ => None,
    }
}

/// Tangent with the right K and the material part by another rule, as from a program that uses the K it is given. Its candidate has the
/// name of the whole tangent by that rule, so that one cause is named once.
fn with_the_right_K(state: &ElementState, rule: &[Point]) -> Vec<f64> {
    let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
    let lame = state.moduli().into();
    let by = |points: &[Point]| {
        let own = |s: &Integrand| s.S_1.map(|S_1| S_1 * e);
        material(&integrands(&e, &element, points), own, stiffness(lame))
    };
    rows(&(ancf::equations::force::tangent(&e, &eps_T, lame, &element) - by(&exact(state)) + by(rule)))
}

/// Stiffness between the three strains.
fn stiffness(LameConstants { lambda, mu }: LameConstants) -> [[f64; 3]; 3] {
    let stiff = lambda + 2.0 * mu;
    [[stiff, lambda, 0.0], [lambda, stiff, 0.0], [0.0, 0.0, 4.0 * mu]]
}

/// Candidates with a wrong integrand.
fn other_integrands<'a>(quantity: &str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let (e, eps_T) = (Vector14::from(state.e), state.eps_T());
    let at = move || integrands(&e, &state.element(), &exact(state));
    let of = move |what: &'static str, kind: MistakeKind, weights: fn(&Integrand, &Vector3<f64>) -> [f64; 3]| {
        candidate(kind, what, move || rows(&K(&at(), |s| weights(s, &eps_T))))
    };
    match quantity {
        "21.K_1" => vec![
            of("K_2 for K_1: S_a1 with S_b", Other, |s, T| [bracket(s, T, 1), bracket(s, T, 0), 0.0]),
            of("thermal strains 11 and 22 exchanged", Other, |s, T| {
                [s.form[0] - 1.0 - 2.0 * T[1], s.form[1] - 1.0 - 2.0 * T[0], 0.0]
            }),
        ],
        "21.K_2" => vec![
            of("K_1 for K_2: S_a1 with S_a", Other, |s, T| [bracket(s, T, 0), bracket(s, T, 1), 0.0]),
            of("thermal strains 11 and 22 exchanged", Other, |s, T| {
                [s.form[1] - 1.0 - 2.0 * T[0], s.form[0] - 1.0 - 2.0 * T[1], 0.0]
            }),
        ],
        "21.K_3" => {
            let sum = move |S: fn(&Integrand) -> Matrix14| {
                let sum = |sum, s: &Integrand| sum + S(s) * (0.25 * bracket(s, &eps_T, 2) * s.dV);
                rows(&at().iter().fold(Matrix14::zeros(), sum))
            };
            let heat = if state.model == ThermalModel::None { 0.0 } else { state.alpha * state.dT };
            vec![
                candidate(Transpose, "S_c + S_c for S_c1", move || sum(|s| 2.0 * s.S[2])),
                candidate(Transpose, "S_c for S_c1", move || sum(|s| s.S[2])),
                candidate(HeatOnShear, "αΔT in K_3, as in K_1", move || {
                    rows(&K(&at(), |s| [0.0, 0.0, s.form[2] - 2.0 * heat]))
                }),
            ]
        }
        "18.U" => {
            let lame = state.moduli().into();
            let half = move || {
                let (D, integrands) = (law::D(lame), at());
                let stress = D * Vector3::from_fn(|n, _| mean(&integrands, &eps_T, n));
                let U = ancf::equations::force::U(&e, &eps_T, lame, &state.element());
                vec![U + 0.5 * (eps_T[0] * stress[0] + eps_T[1] * stress[1] + 2.0 * eps_T[2] * stress[2])]
            };
            vec![candidate(Heat, "½ σ : ε_f for ½ σ : ε: heat in one factor only", half)]
        }
        "20.K" => sums().map(|(kind, what, sum)| candidate(kind, what, move || rows(&summed(state, sum)))).into(),
        "tangent.dQ_e" => tangents(state),
        _ => Vec::new(),
    }
}

/// Factors of K_1, K_2 and K_3 by λ and μ.
type Sum = fn(f64, f64) -> [f64; 3];

/// Sums of K_1, K_2 and K_3 with factors of (20) that are often confused.
pub(super) fn sums() -> [(MistakeKind, &'static str, Sum); 5] {
    [
        (Other, "the factors of K_1 and K_2 exchanged", |lambda, mu| [lambda, lambda + 2.0 * mu, 4.0 * mu]),
        (Other, "μ K_2 for λ K_2", |lambda, mu| [lambda + 2.0 * mu, mu, 4.0 * mu]),
        (Other, "2μ K_2 for λ K_2", |lambda, mu| [lambda + 2.0 * mu, 2.0 * mu, 4.0 * mu]),
        (Other, "4λ K_3 for 4μ K_3", |lambda, mu| [lambda + 2.0 * mu, lambda, 4.0 * lambda]),
        (Other, "λ and μ exchanged", |lambda, mu| [mu + 2.0 * lambda, mu, 4.0 * lambda]),
    ]
}

/// (20) with other factors.
pub(super) fn summed(state: &ElementState, factors: Sum) -> Matrix14 {
    let (e, eps_T) = (Vector14::from(state.e), state.eps_T());
    let LameConstants { lambda, mu } = state.moduli().into();
    let [one, two, three] = factors(lambda, mu);
    let by = |s: &Integrand| {
        let [a, b, c] = [0, 1, 2].map(|k| bracket(s, &eps_T, k));
        [one * a + two * b, one * b + two * a, three * c]
    };
    K(&integrands(&e, &state.element(), &exact(state)), by)
}

/// Candidates with a wrong material part of the tangent.
fn tangents(state: &ElementState) -> Vec<Candidate<'_>> {
    let (e, eps_T) = (Vector14::from(state.e), state.eps_T());
    let lame @ LameConstants { lambda, .. } = state.moduli().into();
    let right = stiffness(lame);
    let value = move |B: fn(&Integrand, &Vector14) -> [Vector14; 3], weights: [[f64; 3]; 3]| {
        let (element, integrands) = (state.element(), integrands(&e, &state.element(), &exact(state)));
        let all = ancf::equations::force::tangent(&e, &eps_T, lame, &element);
        let own = |s: &Integrand| s.S_1.map(|S_1| S_1 * e);
        rows(&(all - material(&integrands, own, right) + material(&integrands, |s| B(s, &e), weights)))
    };
    let S_1: fn(&Integrand, &Vector14) -> [Vector14; 3] = |s, e| s.S_1.map(|S_1| S_1 * e);
    let [one, two, mut three] = right;
    three[2] *= 0.5;
    let (mut ab, mut ba) = (right, right);
    (ab[0][1], ab[1][0]) = (2.0 * lambda, 0.0);
    (ba[0][1], ba[1][0]) = (0.0, 2.0 * lambda);
    let (mut only_ab, mut only_ba) = (right, right);
    (only_ab[1][0], only_ba[0][1]) = (0.0, 0.0);
    vec![
        candidate(Erratum, "E3 in the material part alone", move || value(S_1, [one, two, three])),
        candidate(Transpose, "2 a bᵀ for a bᵀ + b aᵀ, with a = S_a1 e and b = S_b1 e", move || value(S_1, ab)),
        candidate(Transpose, "2 b aᵀ for a bᵀ + b aᵀ, with a = S_a1 e and b = S_b1 e", move || value(S_1, ba)),
        candidate(Missing, "a bᵀ for a bᵀ + b aᵀ, with a = S_a1 e and b = S_b1 e", move || value(S_1, only_ab)),
        candidate(Missing, "b aᵀ for a bᵀ + b aᵀ, with a = S_a1 e and b = S_b1 e", move || value(S_1, only_ba)),
        candidate(Transpose, "2 S e for (S + Sᵀ) e in the material part", move || {
            value(|s, e| s.S.map(|S| 2.0 * S * e), right)
        }),
        candidate(Transpose, "2 Sᵀ e for (S + Sᵀ) e in the material part", move || {
            value(|s, e| s.S.map(|S| 2.0 * S.transpose() * e), right)
        }),
        candidate(Missing, "S e for (S + Sᵀ) e in the material part", move || {
            value(|s, e| s.S.map(|S| S * e), right)
        }),
    ]
}
