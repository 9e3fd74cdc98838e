//! Mistakes made here by hand, and the kind that is found for them.

#![allow(non_snake_case)] // The paper's symbols are names here.

use super::*;
use crate::conformance::suite::{Parsed, Suite};
use crate::state::{ElementState, ThermalModel, evaluate};
use std::sync::LazyLock;

static SUITE: LazyLock<Suite> = LazyLock::new(|| Suite::embedded().unwrap());

/// What is found where `answer` gives the numbers for a state with its right ones.
fn found(quantity: &str, answer: impl Fn(&ElementState, &Reference) -> Vec<f64>) -> Finding {
    let answers: Vec<(&Case, Vec<f64>)> = SUITE
        .cases
        .iter()
        .filter_map(|case| match &case.parsed {
            Parsed::Element(state) => Some((case, answer(state, case.values.get(quantity)?))),
            _ => None,
        })
        .collect();
    let observations: Vec<Observation> = answers
        .iter()
        .map(|(case, numbers)| {
            let right = &case.values[quantity];
            let agrees = numbers.iter().zip(&right.numbers).zip(&right.absolute).all(|((a, b), t)| (a - b).abs() <= *t);
            Observation { case, answer: Some((!agrees).then_some(numbers.as_slice())) }
        })
        .collect();
    assert!(observations.iter().any(|o| o.answer != Some(None)), "{quantity}: nothing is wrong");
    diagnose(quantity, &observations)
}

fn kinds(finding: &Finding) -> Vec<Kind> {
    finding.kinds.iter().map(|(kind, _)| *kind).collect()
}

#[track_caller]
fn assert_first(quantity: &str, kind: Kind, answer: impl Fn(&ElementState, &Reference) -> Vec<f64>) -> Finding {
    let finding = found(quantity, answer);
    assert_eq!(kinds(&finding).first(), Some(&kind), "{quantity}: {finding:?}");
    finding
}

#[test]
fn printed_errors_are_told_by_their_names() {
    for (right, printed, name) in [
        ("A.3.coefficients", "A.3.coefficients/printed", "E1"),
        ("21.K_3", "21.K_3/printed", "E2"),
        ("18.U", "18.U/printed-shear", "E3"),
        ("19.Q_e", "19.Q_e/printed-shear", "E3"),
        ("tangent.dQ_e", "tangent.dQ_e/printed-shear", "E3"),
    ] {
        let finding = assert_first(right, Kind::Erratum, |state, _| evaluate(printed, state).unwrap());
        assert!(finding.kinds[0].1.starts_with(name), "{finding:?}");
    }
}

#[test]
fn signs_factors_and_missing_terms() {
    assert_first("7.M", Kind::Sign, |_, right| right.numbers.iter().map(|m| -m).collect());
    assert_first("6.T", Kind::Factor, |_, right| right.numbers.iter().map(|t| 2.0 * t).collect());
    // ½ JᵀJ without the −½ I.
    let finding = assert_first("10.epsilon_m", Kind::Missing, |_, right| {
        right.numbers.iter().enumerate().map(|(n, eps)| eps + if n % 4 % 3 == 0 { 0.5 } else { 0.0 }).collect()
    });
    assert_eq!(finding.kinds[0].1, "−½ I missing");
}

#[test]
fn transposes_are_told_from_symmetric_cases() {
    let transposed = |_: &ElementState, right: &Reference| {
        right.numbers.chunks(4).flat_map(|J| [J[0], J[2], J[1], J[3]]).collect::<Vec<_>>()
    };
    assert!(kinds(&found("9.J", transposed)).contains(&Kind::Transpose));
    let finding = found("10.epsilon_m", |state, _| {
        let J = evaluate("9.J", state).unwrap();
        let left = |J: &[f64]| {
            let [a, b, c, d] = [J[0], J[1], J[2], J[3]];
            [0.5 * (a * a + b * b - 1.0), 0.5 * (a * c + b * d), 0.5 * (a * c + b * d), 0.5 * (c * c + d * d - 1.0)]
        };
        J.chunks(4).flat_map(left).collect()
    });
    assert_eq!(finding.kinds, [(Kind::Transpose, "J Jᵀ for Jᵀ J".to_string())]);
}

#[test]
fn heat_and_poissons_ratio() {
    let along_x = |state: &ElementState, right: &Reference| match state.model {
        ThermalModel::OneD => vec![state.alpha * state.dT, 0.0, 0.0],
        _ => right.numbers.clone(),
    };
    let finding = assert_first("8.epsilon_T", Kind::HeatAlongX, along_x);
    assert_eq!(finding.only_where, ["1d"]);
    let on_shear = |state: &ElementState, right: &Reference| match state.model {
        ThermalModel::TwoD => vec![state.alpha * state.dT; 3],
        _ => right.numbers.clone(),
    };
    let finding = assert_first("8.epsilon_T", Kind::HeatOnShear, on_shear);
    assert_eq!(finding.entries, ["(3)"]);
    let plane_stress = |state: &ElementState, _: &Reference| vec![state.E * state.nu / (1.0 - state.nu * state.nu)];
    let finding = assert_first("17.lambda", Kind::Poisson, plane_stress);
    assert!(finding.kinds[0].1.contains("plane stress"), "{finding:?}");
}

#[test]
fn orders_in_e_and_the_angle() {
    let misread = |order: [usize; 7]| {
        move |state: &ElementState, _: &Reference| {
            let e = std::array::from_fn(|n| state.e[2 * order[n / 2] + n % 2]);
            evaluate("1.r", &ElementState { e, ..state.clone() }).unwrap()
        }
    };
    assert_first("1.r", Kind::NodeOrder, misread([0, 1, 5, 6, 2, 3, 4]));
    assert_first("gravity.Q_w", Kind::XyOrder, |_, right| right.numbers.chunks(2).flat_map(|v| [v[1], v[0]]).collect());
    let exchanged = |state: &ElementState, _: &Reference| {
        let theta = std::f64::consts::FRAC_PI_2 - state.theta;
        evaluate("11.S_c", &ElementState { theta, ..state.clone() }).unwrap()
    };
    assert_first("11.S_c", Kind::SinCos, exchanged);
}

#[test]
fn single_precision_is_no_wrong_formula() {
    let single = |_: &ElementState, right: &Reference| right.numbers.iter().map(|x| f64::from(*x as f32)).collect();
    assert_first("21.K_1", Kind::Digits, single);
}

#[test]
fn nothing_is_said_where_nothing_fits() {
    let finding = found("1.r", |state, right| right.numbers.iter().map(|r| r + state.l.sqrt()).collect());
    assert_eq!(finding.kinds, []);
}
