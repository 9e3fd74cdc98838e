//! Terms of (10) to (16).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Vector3;

use super::term::{Term, at_points, foreign};
use crate::diagnosis::entries::rows;
use ancf::equations::material as law;
use ancf::equations::shape::{self, Vector14};
use ancf::equations::strain;
use ancf::state::ElementState;

/// Terms of (10) to (16) and of the products in (21).
pub(super) fn of(quantity: &str, state: &ElementState) -> Vec<Term> {
    let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
    let S_abc = |x, y| strain::S_abc(x, y, &element);
    let eps_f = |x, y| {
        let eps_m = strain::eps_m(&strain::J(x, y, &e, &element));
        Vector3::new(eps_m[(0, 0)], eps_m[(1, 1)], eps_m[(0, 1)])
    };
    match quantity {
        "10.epsilon_m" => at_points(state, &["½ JᵀJ", "−½ I"], |x, y| {
            let J = strain::J(x, y, &e, &element);
            vec![rows(&(0.5 * J.transpose() * J)), vec![-0.5, 0.0, 0.0, -0.5]]
        }),
        "11.S_a" | "11.S_b" | "11.S_c" => of_metric(quantity, state),
        "13.epsilon_1" | "13.epsilon_2" | "13.epsilon_3" => {
            let k = match quantity {
                "13.epsilon_1" => 0,
                "13.epsilon_2" => 1,
                _ => 2,
            };
            let halves = |x, y| {
                let (S_a, S_b, S_c) = S_abc(x, y);
                vec![vec![0.5 * e.dot(&([S_a, S_b, S_c][k] * e))], vec![-0.5], vec![eps_T[k]]]
            };
            let mut terms = at_points(state, &[["½ eᵀS_a e", "½ eᵀS_b e", "½ eᵀS_c e"][k], "−½", "ε_T"], halves);
            terms[1].belongs = k < 2;
            terms[2].belongs = false;
            terms
        }
        "12.epsilon_f" => {
            let heat: Vec<f64> = state.points.iter().flat_map(|_| eps_T.iter().copied()).collect();
            vec![foreign("ε_T", heat)]
        }
        "14.epsilon" => {
            let names =
                ["ε_f", "−ε_T", "−ε_T of the component 11", "−ε_T of the component 22", "−ε_T of the component 12"];
            at_points(state, &names, |x, y| {
                let only = |k: usize| rows(&Vector3::from_fn(|n, _| if n == k { -eps_T[k] } else { 0.0 }));
                [vec![rows(&eps_f(x, y)), rows(&(-eps_T))], (0..3).map(only).collect()].concat()
            })
        }
        "15.sigma" => {
            let D = law::D(state.moduli().into());
            let names = ["the share of ε_1", "the share of ε_2", "the share of ε_3", "D ε_T", "D_12 ε_2", "D_21 ε_1"];
            let mut terms = at_points(state, &names, |x, y| {
                let eps = eps_f(x, y) - eps_T;
                (0..3)
                    .map(|n| rows(&(D.column(n) * eps[n])))
                    .chain([rows(&(D * eps_T)), vec![D[(0, 1)] * eps[1], 0.0, 0.0], vec![0.0, D[(1, 0)] * eps[0], 0.0]])
                    .collect()
            });
            terms[3].belongs = false;
            terms
        }
        "21.S_a1" | "21.S_b1" | "21.S_c1" => at_points(state, &["S", "Sᵀ"], |x, y| {
            let (S_a, S_b, S_c) = S_abc(x, y);
            let S = match quantity {
                "21.S_a1" => S_a,
                "21.S_b1" => S_b,
                _ => S_c,
            };
            vec![rows(&S), rows(&S.transpose())]
        }),
        _ => Vec::new(),
    }
}

/// The four products in S_a, S_b or S_c of (11).
fn of_metric(quantity: &str, state: &ElementState) -> Vec<Term> {
    let (sin, cos) = state.theta.sin_cos();
    let factors = match quantity {
        "11.S_a" => [cos * cos, -sin * cos, -sin * cos, sin * sin],
        "11.S_b" => [sin * sin, sin * cos, sin * cos, cos * cos],
        _ => [sin * cos, cos * cos, -sin * sin, -sin * cos],
    };
    let names = ["the term S_ixᵀS_ix", "the term S_ixᵀS_iy", "the term S_iyᵀS_ix", "the term S_iyᵀS_iy"];
    at_points(state, &names, |x, y| {
        let (S_x, S_y) = (shape::S_x(x, y, state.l), shape::S_y(x, y, state.l));
        let products = [S_x.tr_mul(&S_x), S_x.tr_mul(&S_y), S_y.tr_mul(&S_x), S_y.tr_mul(&S_y)];
        products.iter().zip(factors).map(|(product, factor)| rows(&(product * factor))).collect()
    })
}
