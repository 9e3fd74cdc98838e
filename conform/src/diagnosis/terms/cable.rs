//! Terms of the Euler–Bernoulli element.

#![allow(non_snake_case)] // The symbols of the equations are names here.

use super::term::{Term, term};
use crate::diagnosis::cable::Cable;
use crate::diagnosis::entries::rows;
use ancf::equations::cable::{self, Matrix8, S_i, S_i_x, S_i_xx, Vector8};
use ancf::equations::motion;
use ancf::state::{CableState, ThermalModel, evaluate_cable};

/// Functions S₁ … S₄: factor 1 or l, and the coefficients of aⁿ with a = x/l.
const POLYNOMIALS: [(bool, [f64; 4]); 4] = [
    (false, [1.0, 0.0, -3.0, 2.0]),
    (true, [0.0, 1.0, -2.0, 1.0]),
    (false, [0.0, 0.0, 3.0, -2.0]),
    (true, [0.0, 0.0, -1.0, 1.0]),
];

/// Terms of a quantity of the Euler–Bernoulli element.
pub(super) fn of(quantity: &str, state: &CableState) -> Vec<Term> {
    let at = |of: &dyn Fn(f64) -> Vec<f64>| state.points.iter().flat_map(|[x, _]| of(*x)).collect::<Vec<f64>>();
    let (e, l) = (Vector8::from(state.e), state.l);
    let (r_x, r_xx) = (|x| cable::r_x(x, &e, l), |x| cable::r_xx(x, &e, l));
    match quantity {
        "cable.S" => of_functions(0, state),
        "cable.S_x" => of_functions(1, state),
        "cable.S_xx" => of_functions(2, state),
        "cable.r" => of_sum(state, S_i),
        "cable.r_x" => of_sum(state, S_i_x),
        "cable.r_xx" => of_sum(state, S_i_xx),
        "cable.epsilon" => {
            let heat = if state.model == ThermalModel::None { 0.0 } else { state.alpha * state.dT };
            vec![
                term("|r_x|", at(&|x| vec![r_x(x).norm()])),
                term("−1", at(&|_| vec![-1.0])),
                term("−ε_T", at(&|_| vec![-heat])),
            ]
        }
        "cable.kappa" => vec![
            term("x′y″", at(&|x| vec![r_x(x)[0] * r_xx(x)[1] / r_x(x).norm_squared()])),
            term("−y′x″", at(&|x| vec![-r_x(x)[1] * r_xx(x)[0] / r_x(x).norm_squared()])),
        ],
        "cable.U" | "cable.Q_e" | "cable.tangent" => {
            let [axial, bending] = Cable::new(state).energies().map(|(U, Q_e, K)| match quantity {
                "cable.U" => vec![U],
                "cable.Q_e" => rows(&Q_e),
                _ => rows(&K),
            });
            vec![term("the part of the strain, EA,", axial), term("the part of the curvature, EI,", bending)]
        }
        "cable.eddot" => {
            let of = |name: &str| evaluate_cable(name, state);
            let (Some(M), Some(Q_e), Some(Q_w)) = (of("cable.M"), of("cable.Q_e"), of("cable.Q_w")) else {
                return Vec::new();
            };
            let (M, zero) = (Matrix8::from_row_slice(&M), Vector8::zeros());
            let (Q_e, Q_w) = (Vector8::from_row_slice(&Q_e), Vector8::from_row_slice(&Q_w));
            let shares = [("the share of Q_e", Q_e, zero), ("the share of Q_w", zero, Q_w)];
            let solved = |(name, Q_e, Q_w)| Some(term(name, rows(&motion::acceleration(&M, &Q_e, &Q_w)?)));
            shares.into_iter().filter_map(solved).collect()
        }
        _ => Vec::new(),
    }
}

/// Terms of the functions or of a derivative of some order.
fn of_functions(order: i32, state: &CableState) -> Vec<Term> {
    let mut terms = Vec::new();
    for (i, (with_l, coefficients)) in POLYNOMIALS.iter().enumerate() {
        for (n, c) in coefficients.iter().enumerate().filter(|(n, c)| **c != 0.0 && *n as i32 >= order) {
            let falling: f64 = (0..order).map(|k| f64::from(n as i32 - k)).product();
            let length = if *with_l { state.l } else { 1.0 } / state.l.powi(order);
            let numbers = state.points.iter().flat_map(|[x, _]| {
                let mut row = [0.0; 4];
                row[i] = c * falling * (x / state.l).powi(n as i32 - order) * length;
                row
            });
            terms.push(term(format!("in S_{} the term {c} a^{n}", i + 1), numbers.collect()));
        }
    }
    terms
}

/// Shares of the four nodal vectors.
fn of_sum(state: &CableState, functions: fn(f64, f64) -> [f64; 4]) -> Vec<Term> {
    let share = |i: usize| {
        let at = |x: f64| [0, 1].map(|k| functions(x, state.l)[i] * state.e[2 * i + k]);
        term(format!("the term of S_{}", i + 1), state.points.iter().flat_map(|[x, _]| at(*x)).collect())
    };
    (0..4).map(share).collect()
}
