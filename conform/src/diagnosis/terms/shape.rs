//! Terms of (1) to (5) and (A.1) to (A.4).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Vector2;

use super::term::{Term, at_points, term};
use crate::diagnosis::layout::VECTORS;
use ancf::equations::shape::{self, Vector14};
use ancf::state::ElementState;

/// Terms of (1) to (5) and (A.1) to (A.4).
pub(super) fn of(quantity: &str, state: &ElementState) -> Vec<Term> {
    let l = state.l;
    let c = shape::coefficients(&shape::nodes(&Vector14::from(state.e)), l);
    let list = |v: Vector2<f64>| vec![v[0], v[1]];
    let sum = |e: &[f64; 14]| {
        let names = [1, 2, 3, 4, 5, 6, 7].map(|i| format!("the term of S_{i}"));
        at_points(state, &names.each_ref().map(String::as_str), |x, y| {
            let S = shape::S_i(x, y, l);
            (0..7).map(|i| vec![S[i] * e[2 * i], S[i] * e[2 * i + 1]]).collect()
        })
    };
    match quantity {
        "A.1.r" => at_points(state, &["a_0", "a_1 x", "a_2 y", "a_3 xy", "a_4 x²", "a_5 x³", "a_6 x²y"], |x, y| {
            [1.0, x, y, x * y, x * x, x.powi(3), x * x * y].iter().zip(c).map(|(m, a)| list(a * *m)).collect()
        }),
        "A.1.r_x" => at_points(state, &["a_1", "a_3 y", "2 a_4 x", "3 a_5 x²", "2 a_6 xy"], |x, y| {
            vec![list(c[1]), list(c[3] * y), list(c[4] * 2.0 * x), list(c[5] * 3.0 * x * x), list(c[6] * 2.0 * x * y)]
        }),
        "A.1.r_y" => {
            at_points(state, &["a_2", "a_3 x", "a_6 x²"], |x, _| vec![list(c[2]), list(c[3] * x), list(c[6] * x * x)])
        }
        "A.3.coefficients" => of_coefficients(state),
        "A.4.r" | "1.r" => sum(&state.e),
        "5.rdot" => sum(&state.edot),
        "3.S" => of_functions(None, state),
        "3.S_x" => of_functions(Some('x'), state),
        "3.S_y" => of_functions(Some('y'), state),
        _ => Vec::new(),
    }
}

/// S₁ … S₇: factor 1, y or l, and the coefficients of aⁿ with a = x/l.
pub(in crate::diagnosis) const POLYNOMIALS: [(char, [f64; 4]); 7] = [
    ('1', [1.0, -5.0, 8.0, -4.0]),
    ('y', [1.0, -3.0, 2.0, 0.0]),
    ('1', [0.0, 4.0, -4.0, 0.0]),
    ('l', [0.0, -2.0, 6.0, -4.0]),
    ('y', [0.0, 4.0, -4.0, 0.0]),
    ('1', [0.0, 1.0, -4.0, 4.0]),
    ('y', [0.0, -1.0, 2.0, 0.0]),
];

/// Terms of (3) or of its derivative in x or y.
fn of_functions(derivative: Option<char>, state: &ElementState) -> Vec<Term> {
    let mut terms = Vec::new();
    for (i, (before, coefficients)) in POLYNOMIALS.iter().enumerate() {
        for (n, c) in coefficients.iter().enumerate().filter(|(_, c)| **c != 0.0) {
            let value = |[x, y]: [f64; 2]| {
                let a = x / state.l;
                let factor = match (derivative, before) {
                    (Some('y'), 'y') => 1.0,
                    (Some('y'), _) => 0.0,
                    (_, 'y') => y,
                    (_, 'l') => state.l,
                    _ => 1.0,
                };
                let power = if derivative == Some('x') {
                    if n == 0 { 0.0 } else { n as f64 * a.powi(n as i32 - 1) / state.l }
                } else {
                    a.powi(n as i32)
                };
                factor * c * power
            };
            let numbers = state.points.iter().flat_map(|point| {
                let mut row = [0.0; 7];
                row[i] = value(*point);
                row
            });
            terms.push(term(format!("in S_{} the term {c} a^{n}", i + 1), numbers.collect()));
        }
    }
    terms
}

/// Terms of (A.3): the shares of the nodal vectors in each row.
fn of_coefficients(state: &ElementState) -> Vec<Term> {
    let v = |k: usize| Vector2::new(state.e[2 * k], state.e[2 * k + 1]);
    let l = state.l;
    let shares: [&[(usize, f64)]; 7] = [
        &[(0, 1.0)],
        &[(0, -5.0 / l), (2, 4.0 / l), (5, 1.0 / l), (3, -2.0)],
        &[(1, 1.0)],
        &[(1, -3.0 / l), (4, 4.0 / l), (6, -1.0 / l)],
        &[(0, 8.0 / l.powi(2)), (2, -4.0 / l.powi(2)), (5, -4.0 / l.powi(2)), (3, 6.0 / l)],
        &[(0, -4.0 / l.powi(3)), (5, 4.0 / l.powi(3)), (3, -4.0 / l.powi(2))],
        &[(1, 2.0 / l.powi(2)), (4, -4.0 / l.powi(2)), (6, 2.0 / l.powi(2))],
    ];
    let mut terms = Vec::new();
    for (row, shares) in shares.iter().enumerate() {
        for (k, factor) in *shares {
            let mut numbers = vec![0.0; 14];
            let share = v(*k) * *factor;
            (numbers[2 * row], numbers[2 * row + 1]) = (share[0], share[1]);
            terms.push(term(format!("in a_{row} the term of {}", VECTORS[*k]), numbers));
        }
    }
    terms
}
