//! Mistakes in the lines of the shape functions, and in the slopes that (A.2) asks for.

#![allow(non_snake_case)] // The paper's symbols are names here.

use super::candidate::{Candidate, candidate};
use super::mistake::MistakeKind::{Missing, Other};
use super::terms::POLYNOMIALS;
use ancf::equations::shape::{S_i, S_i_x, S_i_y, S_x, Vector14};
use ancf::state::ElementState;

/// Candidates for (3), its derivatives and (A.2).
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    match quantity {
        "3.S" | "3.S_x" | "3.S_y" => {
            [copied(quantity, state), derivatives(quantity, state)].into_iter().flatten().collect()
        }
        "A.2.e" => slopes(state),
        _ => Vec::new(),
    }
}

/// The seven functions or derivatives at a point.
type Functions = fn(f64, f64, f64) -> [f64; 7];

fn right(quantity: &str) -> Functions {
    match quantity {
        "3.S" => S_i,
        "3.S_x" => S_i_x,
        _ => S_i_y,
    }
}

/// The right values with one of them replaced, at all points.
fn with_one(state: &ElementState, quantity: &str, k: usize, other: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let at = |&[x, y]: &[f64; 2]| {
        let mut row = right(quantity)(x, y, state.l);
        row[k] = other(x, y);
        row
    };
    state.points.iter().flat_map(at).collect()
}

/// One line copied to another.
fn copied<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let pairs = (0..7).flat_map(|to| (0..7).filter(move |from| *from != to).map(move |from| (from, to)));
    let copy = |(from, to): (usize, usize)| {
        candidate(Other, format!("the line of S_{} copied to S_{}", from + 1, to + 1), move || {
            with_one(state, quantity, to, |x, y| right(quantity)(x, y, state.l)[from])
        })
    };
    pairs.map(copy).collect()
}

/// Derivatives that are none, or are those of other variables.
fn derivatives<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    if quantity == "3.S" {
        return Vec::new();
    }
    let l = state.l;
    let mut all = Vec::new();
    for (k, (before, coefficients)) in POLYNOMIALS.iter().enumerate() {
        let name = format!("S_{}", k + 1);
        let factor = move |y: f64| match before {
            'y' => y,
            'l' => l,
            _ => 1.0,
        };
        let replaced = move |of: fn(f64, i32) -> f64, factor: &dyn Fn(f64) -> f64| {
            with_one(state, quantity, k, |x, y| {
                let powers = coefficients.iter().enumerate();
                factor(y) * powers.map(|(n, c)| c * of(x / l, n as i32)).sum::<f64>()
            })
        };
        let power: fn(f64, i32) -> f64 = |a, n| a.powi(n);
        let derivative: fn(f64, i32) -> f64 = |a, n| if n == 0 { 0.0 } else { f64::from(n) * a.powi(n - 1) };
        let lowered: fn(f64, i32) -> f64 = |a, n| if n == 0 { 0.0 } else { a.powi(n - 1) };
        all.push(candidate(Other, format!("{name} itself for its derivative"), move || replaced(power, &factor)));
        match quantity {
            "3.S_x" => {
                let what = format!("the powers of a missing in the derivative of {name}: a^(n−1) for n a^(n−1)");
                all.push(candidate(Missing, what, move || replaced(lowered, &|y| factor(y) / l)));
            }
            _ if *before == 'y' => {
                let what = format!("the derivative of {name} by a for that by y");
                all.push(candidate(Other, what, move || replaced(derivative, &|_| 1.0)));
                let what = format!("y kept in the derivative of {name} by y, in place of l");
                all.push(candidate(Other, what, move || replaced(power, &|y| y / l)));
            }
            _ => {}
        }
    }
    all
}

/// The slope r_x asked for at another place than the middle.
fn slopes(state: &ElementState) -> Vec<Candidate<'_>> {
    let asked = move |x: f64| {
        let slope = S_x(x, 0.0, state.l) * Vector14::from(state.e);
        let mut e = state.e;
        (e[6], e[7]) = (slope[0], slope[1]);
        e.to_vec()
    };
    vec![
        candidate(Other, "r_x_j asked for at x = l in place of l/2", move || asked(state.l)),
        candidate(Other, "r_x_j asked for at x = 0 in place of l/2", move || asked(0.0)),
    ]
}
