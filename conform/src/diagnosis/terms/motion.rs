//! Terms of (22) and (23).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{DVector, SVector, Vector2};

use super::term::{Term, term};
use crate::diagnosis::entries::rows;
use ancf::equations::inertia;
use ancf::equations::motion;
use ancf::equations::shape::Vector14;
use ancf::internals::state::SystemState;
use ancf::state::{ElementState, evaluate};

/// Terms of (22).
pub(super) fn of(quantity: &str, state: &ElementState) -> Vec<Term> {
    let motion_of_one = matches!(quantity, "22.residual" | "22.eddot");
    let Some(Q_e) = evaluate("19.Q_e", state).filter(|_| motion_of_one) else { return Vec::new() };
    let (Q_e, element) = (Vector14::from_row_slice(&Q_e), state.element());
    let M = inertia::M(state.rho, &element);
    let Q_w = inertia::Q_w_gravity(&Vector2::from(state.gravity), state.rho, &element);
    if quantity == "22.residual" {
        let inertia = M * Vector14::from(state.edot);
        return vec![term("M ë", rows(&inertia)), term("Q_e", rows(&Q_e)), term("−Q_w", rows(&(-Q_w)))];
    }
    let zero = SVector::zeros();
    let solved = |Q_e: &Vector14, Q_w: &Vector14| motion::acceleration(&M, Q_e, Q_w).map(|a| rows(&a));
    named([("the share of Q_e", solved(&Q_e, &zero)), ("the share of Q_w", solved(&zero, &Q_w))])
}

/// Terms of (23).
pub(super) fn of_system(quantity: &str, system: &SystemState) -> Vec<Term> {
    let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = system;
    let zero = DVector::zeros(kq.len());
    let solved = |kq: &DVector<f64>, f: &DVector<f64>| {
        let (acceleration, lambda) = motion::system_acceleration(m, kq, Phi_q, f)?;
        Some(if quantity == "23.lambda" { rows(&lambda) } else { rows(&acceleration) })
    };
    match quantity {
        "23.constraint_force" => {
            let share = |k: usize| rows(&(Phi_q.row(k).transpose() * lambda[k]));
            let last = lambda.len().saturating_sub(1);
            vec![
                term("the share of the first constraint", share(0)),
                term("the share of the last constraint", share(last)),
            ]
        }
        "23.residual" => vec![
            term("m q̈", rows(&(m * q_ddot))),
            term("k q", rows(kq)),
            term("Φ_qᵀ λ", rows(&motion::constraint_force(Phi_q, lambda))),
            term("−f", rows(&(-f))),
        ],
        "23.acceleration" | "23.lambda" => {
            named([("the share of k q", solved(kq, &zero)), ("the share of f", solved(&zero, f))])
        }
        _ => Vec::new(),
    }
}

/// Terms that have a value, with their names.
fn named<const N: usize>(terms: [(&str, Option<Vec<f64>>); N]) -> Vec<Term> {
    terms.into_iter().filter_map(|(name, numbers)| Some(term(name, numbers?))).collect()
}
