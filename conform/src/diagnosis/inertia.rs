//! Mistakes in the masses of (6), (7) and the weight.

#![allow(non_snake_case)] // The paper's symbols are names here.

use super::candidate::{Candidate, candidate};
use super::entries::rows;
use super::mistake::MistakeKind::{Missing, Other};
use ancf::equations::inertia;
use ancf::equations::shape::Vector14;
use ancf::state::{ElementState, evaluate};
use nalgebra::SMatrix;

/// Shares of the mass at r_i, r_j and r_k.
const SHARES: [(&str, [f64; 3]); 3] = [
    ("a third on each node", [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0]),
    ("half on each end", [0.5, 0.0, 0.5]),
    ("a quarter on each end, half in the middle", [0.25, 0.5, 0.25]),
];

/// Shares by coordinate of (4), for x and y.
fn by_coordinate([i, j, k]: [f64; 3]) -> Vector14 {
    let vectors = [i, 0.0, j, 0.0, 0.0, k, 0.0];
    Vector14::from_fn(|n, _| vectors[n / 2])
}

/// Candidates with wrong masses.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    if !matches!(quantity, "7.M" | "6.T" | "gravity.Q_w") {
        return Vec::new();
    }
    let now = (state.e[10] - state.e[0]).hypot(state.e[11] - state.e[1]) / state.l;
    let stretched = candidate(Other, "the present length |r_k − r_i| for l in the mass", move || {
        evaluate(quantity, &ElementState { rho: now * state.rho, ..state.clone() }).unwrap_or_default()
    });
    let mut all = lumped(quantity, state);
    all.push(stretched);
    match quantity {
        "7.M" => all.push(candidate(Other, "the masses between x and y too", move || {
            let M = inertia::M(state.rho, &state.element());
            rows(&M.map_with_location(|row, column, _| M[(row / 2 * 2, column / 2 * 2)]))
        })),
        "6.T" => all.extend(["x", "y"].into_iter().enumerate().map(|(component, name)| {
            candidate(Missing, format!("the velocity along {name} only"), move || {
                let edot = std::array::from_fn(|n| if n % 2 == component { state.edot[n] } else { 0.0 });
                evaluate(quantity, &ElementState { edot, ..state.clone() }).unwrap_or_default()
            })
        })),
        _ => {}
    }
    all
}

/// Candidates with masses in the nodes.
fn lumped<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let mass = state.rho * state.l * state.h * state.w;
    let lumped = SHARES.map(|(what, shares)| (format!("lumped: {what}"), mass * by_coordinate(shares)));
    if quantity == "gravity.Q_w" {
        let weight = |shares: Vector14| shares.component_mul(&Vector14::from_fn(|n, _| state.gravity[n % 2]));
        return lumped.map(|(what, shares)| candidate(Other, what, move || rows(&weight(shares)))).into();
    }
    let M = inertia::M(state.rho, &state.element());
    let mut diagonals = vec![
        ("lumped: row sums on the diagonal".to_string(), M.column_sum()),
        ("its diagonal only".to_string(), M.diagonal()),
    ];
    diagonals.extend(lumped);
    let e_dot = Vector14::from(state.edot);
    let of = |(what, diagonal): (String, Vector14)| {
        let M = SMatrix::from_diagonal(&diagonal);
        let what = if quantity == "6.T" { format!("M {what}") } else { what };
        let of_T = quantity == "6.T";
        candidate(Other, what, move || if of_T { vec![inertia::T(&M, &e_dot)] } else { rows(&M) })
    };
    diagonals.into_iter().map(of).collect()
}
