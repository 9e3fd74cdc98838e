//! Mistakes that engineers make often, each made by hand.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::equations::shape;
use ancf::state::{ElementState, evaluate};
use nalgebra::{DMatrix, DVector};

use super::{assert_first, in_a_black_box};
use crate::diagnosis::mistake::MistakeKind;
use crate::suite::Reference;

/// Another value of a quantity, from the state.
fn of(quantity: &str, state: &ElementState) -> Vec<f64> {
    evaluate(quantity, state).unwrap()
}

fn square(quantity: &str, state: &ElementState) -> DMatrix<f64> {
    DMatrix::from_row_slice(14, 14, &of(quantity, state))
}

#[test]
fn the_force_of_displacements_is_told() {
    let displaced = |state: &ElementState, _: &Reference| {
        let u = DVector::from_fn(14, |n, _| state.e[n] - state.e0[n]);
        (square("20.K", state).tr_mul(&u)).as_slice().to_vec()
    };
    let finding = assert_first("19.Q_e", MistakeKind::Other, displaced);
    assert_eq!(finding.mistakes[0].what, "K (e − e_0) for K e");
}

#[test]
fn half_of_a_symmetric_matrix_is_told() {
    let upper = |_: &ElementState, right: &Reference| {
        let keep = |(n, value): (usize, &f64)| if n % 14 >= n / 14 { *value } else { 0.0 };
        right.numbers.iter().enumerate().map(keep).collect::<Vec<f64>>()
    };
    for quantity in ["7.M", "tangent.dQ_e"] {
        let finding = assert_first(quantity, MistakeKind::Missing, upper);
        assert_eq!(finding.mistakes[0].what, "only the upper triangle filled", "{quantity}");
    }
}

#[test]
fn absolute_values_are_told() {
    let nu =
        |state: &ElementState, _: &Reference| of("17.lambda", &ElementState { nu: state.nu.abs(), ..state.clone() });
    assert_eq!(assert_first("17.lambda", MistakeKind::Poisson, nu).mistakes[0].what, "|ν| for ν");
    let heat =
        |state: &ElementState, _: &Reference| of("8.epsilon_T", &ElementState { dT: state.dT.abs(), ..state.clone() });
    let finding = assert_first("8.epsilon_T", MistakeKind::Heat, heat);
    assert!(finding.mistakes[0].what.starts_with("|ΔT| for ΔT"), "{finding:?}");
}

#[test]
fn missing_heat_on_the_shear_is_no_heat_on_the_shear() {
    let without = |_: &ElementState, right: &Reference| vec![right.numbers[0], right.numbers[1], 0.0];
    let finding = assert_first("8.epsilon_T", MistakeKind::Heat, without);
    assert!(finding.mistakes.iter().all(|mistake| mistake.kind != MistakeKind::HeatOnShear), "{finding:?}");
}

#[test]
fn other_entries_of_the_law_are_told() {
    let with = |diagonal: fn(f64, f64) -> f64, beside: fn(f64, f64) -> f64| {
        move |state: &ElementState, right: &Reference| {
            let (lambda, mu) = (of("17.lambda", state)[0], of("17.mu", state)[0]);
            let mut D = right.numbers.clone();
            (D[0], D[4], D[1], D[3]) =
                (diagonal(lambda, mu), diagonal(lambda, mu), beside(lambda, mu), beside(lambda, mu));
            D
        }
    };
    let stiff: fn(f64, f64) -> f64 = |lambda, mu| lambda + 2.0 * mu;
    assert_first("16.D", MistakeKind::Missing, with(stiff, |_, _| 0.0));
    assert_first("16.D", MistakeKind::Other, with(stiff, |_, mu| mu));
    assert_first("16.D", MistakeKind::Factor, with(|lambda, mu| lambda + mu, |lambda, _| lambda));
    assert_first("16.D", MistakeKind::Missing, with(|_, mu| 2.0 * mu, |lambda, _| lambda));
}

#[test]
fn a_solution_with_the_diagonal_is_told() {
    let divided = |state: &ElementState, _: &Reference| {
        let (M, Q_e, Q_w) = (square("7.M", state), of("19.Q_e", state), of("gravity.Q_w", state));
        (0..14).map(|n| (Q_w[n] - Q_e[n]) / M[(n, n)]).collect()
    };
    let finding = assert_first("22.eddot", MistakeKind::Other, divided);
    assert!(finding.mistakes[0].what.contains("diagonal of M"), "{finding:?}");
}

#[test]
fn copied_lines_of_shape_functions_are_told() {
    let copied = |_: &ElementState, right: &Reference| {
        let row = |row: &[f64]| [&row[..4], &[row[2]], &row[5..]].concat();
        right.numbers.chunks(7).flat_map(row).collect()
    };
    let finding = assert_first("3.S_x", MistakeKind::Other, copied);
    assert_eq!(finding.mistakes[0].what, "the line of S_3 copied to S_5");
    let kept = |state: &ElementState, right: &Reference| {
        let at = |([x, y], row): (&[f64; 2], &[f64])| {
            let mut row = row.to_vec();
            row[1] = shape::S_i(*x, *y, state.l)[1];
            row
        };
        state.points.iter().zip(right.numbers.chunks(7)).flat_map(at).collect()
    };
    assert_first("3.S_y", MistakeKind::Other, kept);
}

#[test]
fn a_sum_over_one_row_is_told() {
    let along_x = |_: &ElementState, right: &Reference| {
        let keep = |(n, value): (usize, &f64)| if n % 2 == 0 && n / 14 % 2 == 0 { *value } else { 0.0 };
        right.numbers.chunks(196).flat_map(|S| S.iter().enumerate().map(keep).collect::<Vec<f64>>()).collect()
    };
    assert_first("11.S_a", MistakeKind::Missing, along_x);
}

#[test]
fn a_black_box_names_the_deformation_gradient() {
    // Transposed after its derivatives were taken.
    let found = in_a_black_box(|_, chain| {
        let J = chain.right("9.J").unwrap();
        vec![("9.J", J.chunks(4).flat_map(|J| [J[0], J[2], J[1], J[3]]).collect())]
    });
    assert_eq!((found[0].quantity, found[0].mistakes[0].kind), ("9.J", MistakeKind::Transpose), "{found:?}");
    let found = in_a_black_box(|_, chain| {
        vec![("10.epsilon_m", chain.right("10.epsilon_m").unwrap().iter().map(|strain| 2.0 * strain).collect())]
    });
    assert_eq!((found[0].quantity, found[0].mistakes[0].kind), ("10.epsilon_m", MistakeKind::Factor), "{found:?}");
}
