//! Mistakes made by hand, and the diagnosis of each.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use ancf::state::{CableState, ElementState, ThermalModel, evaluate, evaluate_cable};

use super::ancestors::{Ancestor, Seen, ancestors};
use super::chain::{Chain, Values};
use super::diagnose::{Diagnosis, diagnose};
use super::entries::rows;
use super::mistake::{Mistake, MistakeKind};
use super::observation::{Observation, Outcome};
use super::quadrature;
use super::wrong_values::Upstream;
use crate::suite::{Case, Reference, State, Suite};
use crate::verdict::Fault;

mod kinds;

static SUITE: LazyLock<Suite> = LazyLock::new(|| Suite::embedded().unwrap());

/// What is found where `answer` gives the numbers for a state with its right ones.
fn found(quantity: &str, answer: impl Fn(&ElementState, &Reference) -> Vec<f64>) -> Diagnosis {
    let answers: Vec<(&Case, Vec<f64>)> = SUITE
        .cases
        .iter()
        .filter_map(|case| match &case.state {
            State::Element(state) => Some((case, answer(state, case.values.get(quantity)?))),
            _ => None,
        })
        .collect();
    let observations: Vec<Observation> = answers
        .iter()
        .map(|(case, numbers)| {
            let right = &case.values[quantity];
            let agrees = numbers.iter().zip(&right.numbers).zip(&right.absolute).all(|((a, b), t)| (a - b).abs() <= *t);
            Observation { case, outcome: if agrees { Outcome::Right } else { Outcome::Wrong(numbers) } }
        })
        .collect();
    assert!(observations.iter().any(|o| o.outcome != Outcome::Right), "{quantity}: nothing is wrong");
    diagnose(quantity, &observations)
}

fn kinds(finding: &Diagnosis) -> Vec<MistakeKind> {
    finding.mistakes.iter().map(|mistake| mistake.kind).collect()
}

#[track_caller]
fn assert_first(
    quantity: &str,
    kind: MistakeKind,
    answer: impl Fn(&ElementState, &Reference) -> Vec<f64>,
) -> Diagnosis {
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
        let finding = assert_first(right, MistakeKind::Erratum, |state, _| evaluate(printed, state).unwrap());
        assert!(finding.mistakes[0].what.starts_with(name), "{finding:?}");
    }
}

/// The whole rod turned by −θ, so that it lies along x, and its printed energy: its shear is that of the rod's own axes.
#[test]
fn the_third_erratum_in_the_rods_own_axes_has_a_name() {
    let turned = |vectors: &[f64], angle: f64| -> Vec<f64> {
        let (sin, cos) = angle.sin_cos();
        vectors.chunks(2).flat_map(|v| [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]]).collect()
    };
    let along_x = |state: &ElementState| {
        let of = |e: &[f64; 14]| turned(e, -state.theta).try_into().unwrap();
        ElementState { theta: 0.0, e0: of(&state.e0), e: of(&state.e), ..state.clone() }
    };
    let finding =
        assert_first("18.U", MistakeKind::Erratum, |state, _| evaluate("18.U/printed-shear", &along_x(state)).unwrap());
    assert!(finding.mistakes[0].what.starts_with("E3 in the rod's own axes"), "{finding:?}");
    let finding = assert_first("19.Q_e", MistakeKind::Erratum, |state, _| {
        turned(&evaluate("19.Q_e/printed-shear", &along_x(state)).unwrap(), state.theta)
    });
    assert_eq!(finding.mistakes.len(), 1, "{finding:?}");
    for quantity in ["20.K", "tangent.dQ_e"] {
        let finding = assert_first(quantity, MistakeKind::Erratum, |state, _| {
            let matrix = evaluate(&format!("{quantity}/printed-shear"), &along_x(state)).unwrap();
            // R K Rᵀ: rows first, then columns.
            let rows: Vec<f64> = matrix.chunks(14).flat_map(|row| turned(row, state.theta)).collect();
            let columns = (0..14).map(|n| rows.iter().skip(n).step_by(14).copied().collect::<Vec<_>>());
            let columns: Vec<Vec<f64>> = columns.map(|column| turned(&column, state.theta)).collect();
            (0..196).map(|n| columns[n % 14][n / 14]).collect()
        });
        assert!(finding.mistakes[0].what.starts_with("E3 in the rod's own axes"), "{finding:?}");
    }
}

#[test]
fn signs_factors_and_missing_terms() {
    assert_first("7.M", MistakeKind::Sign, |_, right| right.numbers.iter().map(|m| -m).collect());
    assert_first("6.T", MistakeKind::Factor, |_, right| right.numbers.iter().map(|t| 2.0 * t).collect());
    // ½ JᵀJ without the −½ I.
    let finding = assert_first("10.epsilon_m", MistakeKind::Missing, |_, right| {
        right.numbers.iter().enumerate().map(|(n, eps)| eps + if n % 4 % 3 == 0 { 0.5 } else { 0.0 }).collect()
    });
    assert_eq!(finding.mistakes[0].what, "−½ I missing");
}

#[test]
fn transposes_are_told_from_symmetric_cases() {
    let transposed = |_: &ElementState, right: &Reference| {
        right.numbers.chunks(4).flat_map(|J| [J[0], J[2], J[1], J[3]]).collect::<Vec<_>>()
    };
    assert!(kinds(&found("9.J", transposed)).contains(&MistakeKind::Transpose));
    let finding = found("10.epsilon_m", |state, _| {
        let J = evaluate("9.J", state).unwrap();
        let left = |J: &[f64]| {
            let [a, b, c, d] = [J[0], J[1], J[2], J[3]];
            [0.5 * (a * a + b * b - 1.0), 0.5 * (a * c + b * d), 0.5 * (a * c + b * d), 0.5 * (c * c + d * d - 1.0)]
        };
        J.chunks(4).flat_map(left).collect()
    });
    assert_eq!(finding.mistakes, [Mistake { kind: MistakeKind::Transpose, what: "J Jᵀ for Jᵀ J".into() }]);
}

#[test]
fn heat_and_poissons_ratio() {
    let along_x = |state: &ElementState, right: &Reference| match state.model {
        ThermalModel::OneD => vec![state.alpha * state.dT, 0.0, 0.0],
        _ => right.numbers.clone(),
    };
    let finding = assert_first("8.epsilon_T", MistakeKind::HeatAlongX, along_x);
    assert_eq!(finding.only_where, ["1d"]);
    let on_shear = |state: &ElementState, right: &Reference| match state.model {
        ThermalModel::TwoD => vec![state.alpha * state.dT; 3],
        _ => right.numbers.clone(),
    };
    let finding = assert_first("8.epsilon_T", MistakeKind::HeatOnShear, on_shear);
    assert_eq!(finding.entries, ["(3)"]);
    let plane_stress = |state: &ElementState, _: &Reference| vec![state.E * state.nu / (1.0 - state.nu * state.nu)];
    let finding = assert_first("17.lambda", MistakeKind::Poisson, plane_stress);
    assert_eq!(finding.mistakes[0].what, "λ = Eν/((1 + ν)(1 − ν)): plane stress");
}

#[test]
fn orders_in_e_and_the_angle() {
    let misread = |order: [usize; 7]| {
        move |state: &ElementState, _: &Reference| {
            let e = std::array::from_fn(|n| state.e[2 * order[n / 2] + n % 2]);
            evaluate("1.r", &ElementState { e, ..state.clone() }).unwrap()
        }
    };
    assert_first("1.r", MistakeKind::NodeOrder, misread([0, 1, 5, 6, 2, 3, 4]));
    assert_first("gravity.Q_w", MistakeKind::XyOrder, |_, right| {
        right.numbers.chunks(2).flat_map(|v| [v[1], v[0]]).collect()
    });
    let exchanged = |state: &ElementState, _: &Reference| {
        let theta = std::f64::consts::FRAC_PI_2 - state.theta;
        evaluate("11.S_c", &ElementState { theta, ..state.clone() }).unwrap()
    };
    assert_first("11.S_c", MistakeKind::SinCos, exchanged);
}

#[test]
fn single_precision_is_no_wrong_formula() {
    let single = |_: &ElementState, right: &Reference| right.numbers.iter().map(|x| f64::from(*x as f32)).collect();
    assert_first("21.K_1", MistakeKind::Digits, single);
}

#[test]
fn nothing_is_said_where_nothing_fits() {
    let finding = found("1.r", |state, right| right.numbers.iter().map(|r| r + state.l.sqrt()).collect());
    assert_eq!(finding.mistakes, []);
}

#[test]
fn nan_in_some_states_invents_no_kind() {
    let fault = Fault::NotFinite("1 of its entries".into());
    let seen = |case: &Case| if case.tags.contains(&"1d".into()) { Outcome::Fault(&fault) } else { Outcome::Right };
    let observations: Vec<Observation> = (SUITE.cases.iter())
        .filter(|case| case.values.contains_key("8.epsilon_T"))
        .map(|case| Observation { case, outcome: seen(case) })
        .collect();
    let finding = diagnose("8.epsilon_T", &observations);
    assert_eq!((finding.mistakes, finding.only_where), (vec![], vec!["1d".to_string()]));
    assert_eq!(finding.without_numbers, BTreeMap::from([("NaN or infinite", finding.failing)]));
    assert!(finding.failing > 3);
}

#[test]
fn numbers_that_are_all_but_right_have_no_kind_but_too_few_digits() {
    let finding = found("21.K_1", |_, right| {
        right.numbers.iter().zip(&right.absolute).map(|(number, bound)| number + 20.0 * bound).collect()
    });
    assert_eq!(kinds(&finding), [MistakeKind::Digits]);
}

#[test]
fn powers_of_a_length_and_any_fraction_are_found() {
    let times = |quantity: &str, factor: fn(&ElementState) -> f64| {
        let finding = found(quantity, |state, right| right.numbers.iter().map(|x| x * factor(state)).collect());
        finding.mistakes.into_iter().map(|mistake| mistake.what).collect::<Vec<_>>()
    };
    assert_eq!(times("7.M", |state| 4.0 / (state.l * state.h)), ["all of it times 4/(l h)"]);
    assert_eq!(times("gravity.Q_w", |state| 1.0 / state.rho), ["all of it without the factor ρ"]);
    assert!(times("21.K_3", |_| 5.0 / 6.0).contains(&"all of it times 5/6".to_string()));
    // A power of l in one row of (A.3).
    let finding = found("A.3.coefficients", |state, right| {
        right.numbers.iter().enumerate().map(|(n, a)| if n / 2 == 5 { a * state.l } else { *a }).collect()
    });
    let what = "row 6 times l: one factor too many, or a missing division".into();
    assert_eq!(finding.mistakes, [Mistake { kind: MistakeKind::Factor, what }]);
}

#[test]
fn two_terms_at_once() {
    let finding =
        found("11.S_b", |state, _| evaluate("11.S_b", &ElementState { theta: -state.theta, ..state.clone() }).unwrap());
    assert!(kinds(&finding).contains(&MistakeKind::Sign), "{finding:?}");
    let finding = assert_first("22.residual", MistakeKind::Sign, |state, right| {
        let (Q_e, Q_w) = (evaluate("19.Q_e", state).unwrap(), evaluate("gravity.Q_w", state).unwrap());
        right.numbers.iter().zip(Q_e.iter().zip(Q_w)).map(|(sum, (Q_e, Q_w))| sum - 2.0 * Q_e + 1.5 * Q_w).collect()
    });
    assert_eq!(finding.mistakes[0].what, "Q_e with the wrong sign and −Q_w with the wrong sign and half");
}

#[test]
fn rules_configurations_and_copied_lines() {
    assert_first("21.K_3", MistakeKind::Quadrature, |state, right| {
        let rule = quadrature::points(state, quadrature::gauss(2), quadrature::gauss(3), |xi, eta| (xi, eta));
        let (e, element, eps_T) = (state.e.into(), state.element(), state.eps_T());
        let K = quadrature::K(&quadrature::integrands(&e, &element, &rule), |s| {
            [0.0, 0.0, quadrature::bracket(s, &eps_T, 2)]
        });
        assert_eq!(right.numbers.len(), 196);
        rows(&K)
    });
    let finding = assert_first("9.J_0", MistakeKind::Other, |state, _| {
        evaluate("9.J_0", &ElementState { e0: state.e, ..state.clone() }).unwrap()
    });
    assert_eq!(finding.mistakes[0].what, "e read for e0");
    assert_first("11.S_b", MistakeKind::Other, |state, _| evaluate("11.S_a", state).unwrap());
    let finding = found("tangent.dQ_e", |state, right| {
        let lambda = evaluate("17.lambda", state).unwrap()[0];
        let (e, element) = (state.e.into(), state.element());
        let at = quadrature::integrands(&e, &element, &quadrature::exact(state));
        let skew = [[0.0, lambda, 0.0], [-lambda, 0.0, 0.0], [0.0; 3]];
        let more = rows(&quadrature::material(&at, |s| s.S_1.map(|S_1| S_1 * e), skew));
        right.numbers.iter().zip(more).map(|(right, more)| right + more).collect()
    });
    assert!(finding.mistakes[0].what.starts_with("2 a bᵀ for a bᵀ + b aᵀ"), "{finding:?}");
}

#[test]
fn the_tangents_own_part_by_another_rule() {
    for (points_of, name) in [(2, "2 × 3 Gauss points"), (4, "4 × 3 Gauss points")] {
        // With K as it is handed over.
        let finding = assert_first("tangent.dQ_e", MistakeKind::Quadrature, |state, right| {
            let (lambda, mu) = (evaluate("17.lambda", state).unwrap()[0], evaluate("17.mu", state).unwrap()[0]);
            let stiff = lambda + 2.0 * mu;
            let weights = [[stiff, lambda, 0.0], [lambda, stiff, 0.0], [0.0, 0.0, 4.0 * mu]];
            let (e, element) = (state.e.into(), state.element());
            let part = |rule: &[ancf::internals::equations::volume::Point]| {
                quadrature::material(&quadrature::integrands(&e, &element, rule), |s| s.S_1.map(|S_1| S_1 * e), weights)
            };
            let coarse =
                quadrature::points(state, quadrature::gauss(points_of), quadrature::gauss(3), |xi, eta| (xi, eta));
            let more = rows(&(part(&coarse) - part(&quadrature::exact(state))));
            right.numbers.iter().zip(more).map(|(right, more)| right + more).collect()
        });
        assert_eq!(finding.mistakes[0].what, name);
    }
}

#[test]
fn errors_and_other_shapes_alone_have_no_kind() {
    for fault in [Fault::Error("TypeError".into()), Fault::Shape("196; expected 14 × 14".into())] {
        for quantity in ["3.S", "7.M", "17.mu", "8.epsilon_T", "21.K_3", "19.Q_e"] {
            let of_quantity = SUITE.cases.iter().filter(|case| case.values.contains_key(quantity));
            let observations: Vec<Observation> =
                of_quantity.map(|case| Observation { case, outcome: Outcome::Refused(&fault) }).collect();
            assert_eq!(diagnose(quantity, &observations).mistakes, [], "{quantity}");
        }
    }
}

/// Ancestors of the force in a black box that answers M, the force and its tangent, with wrong values of some quantities.
fn in_a_black_box(wrong: impl Fn(&ElementState, &Chain) -> Vec<(&'static str, Vec<f64>)>) -> Vec<Ancestor> {
    let answered = ["7.M", "19.Q_e", "tangent.dQ_e"];
    let mut answers: Vec<(&'static str, &Case, Vec<f64>)> = Vec::new();
    for case in &SUITE.cases {
        let State::Element(state) = &case.state else { continue };
        let chain = Chain::new(state);
        let replaced: Values = wrong(state, &chain).into_iter().map(|(name, value)| (name, value.into())).collect();
        for quantity in answered {
            let value = chain.value(quantity, &replaced).unwrap_or_else(|| case.values[quantity].numbers.clone());
            answers.push((quantity, case, value));
        }
    }
    let mut seen = Seen::new();
    for (quantity, case, numbers) in &answers {
        let right = case.values[*quantity].worst_entry(numbers).1 <= 1.0;
        let outcome = if right { Outcome::Right } else { Outcome::Wrong(numbers) };
        seen.entry(quantity).or_default().push(Observation { case, outcome });
    }
    let all_right = |quantity: &str| seen[quantity].iter().all(|o| o.outcome == Outcome::Right);
    assert!(!all_right("19.Q_e"));
    ancestors("19.Q_e", &seen, |quantity| seen.contains_key(quantity) && all_right(quantity), &mut Upstream::default())
}

#[test]
fn a_black_box_names_the_root() {
    // S_4x with the wrong sign of its middle term, θ in place of J_0.
    let found = in_a_black_box(|_, chain| {
        let points = chain.everywhere.points.iter();
        let l = chain.everywhere.l;
        let mut S_x = chain.right("3.S_x").unwrap().to_vec();
        points.enumerate().for_each(|(p, [x, _])| S_x[7 * p + 3] -= 24.0 * x / l);
        vec![("3.S_x", S_x), ("9.J_0", chain.right("9.J_0").unwrap().to_vec())]
    });
    assert_eq!((found[0].quantity, found[0].mistakes[0].kind), ("3.S_x", MistakeKind::Sign), "{found:?}");
    assert!(found.iter().all(|ancestor| !["3.S", "2.S"].contains(&ancestor.quantity)), "M is right: {found:?}");
    let found = in_a_black_box(|state, _| match state.model {
        ThermalModel::OneD => vec![("8.epsilon_T", vec![state.alpha * state.dT, 0.0, 0.0])],
        _ => vec![],
    });
    assert_eq!((found[0].quantity, found[0].mistakes[0].kind), ("8.epsilon_T", MistakeKind::HeatAlongX), "{found:?}");
    let found = in_a_black_box(|_, chain| {
        vec![("11.S_c", chain.right("11.S_c").unwrap().chunks(196).flat_map(transposed).collect())]
    });
    assert!(found[0].mistakes.is_empty(), "only the sum of S_c and its transpose is used: {found:?}");
}

fn transposed(matrix: &[f64]) -> Vec<f64> {
    (0..196).map(|n| 0.3 * matrix[n % 14 * 14 + n / 14] + 0.9 * matrix[n]).collect()
}

#[test]
fn two_mistakes_in_a_black_box_are_two() {
    let found = in_a_black_box(|state, _| {
        let lambda = state.E * state.nu / ((1.0 + state.nu) * (1.0 - state.nu));
        let heat = match state.model {
            ThermalModel::TwoD => vec![("8.epsilon_T", vec![state.alpha * state.dT; 3])],
            _ => vec![],
        };
        [heat, vec![("17.lambda", vec![lambda])]].concat()
    });
    let named: Vec<&str> =
        found.iter().filter(|ancestor| !ancestor.mistakes.is_empty()).map(|ancestor| ancestor.quantity).collect();
    assert_eq!(named, ["8.epsilon_T", "17.lambda"], "{found:?}");
    assert!(found[0].speaks.contains("together"), "{found:?}");
}

#[test]
fn two_mistakes_in_different_states_are_two() {
    let finding = found("8.epsilon_T", |state, right| match state.model {
        ThermalModel::OneD => vec![state.alpha * state.dT, 0.0, 0.0],
        ThermalModel::TwoD => vec![state.alpha * state.dT; 3],
        _ => right.numbers.clone(),
    });
    assert!(finding.together, "{finding:?}");
    assert_eq!(kinds(&finding), [MistakeKind::HeatAlongX, MistakeKind::HeatOnShear], "{finding:?}");
    assert!(finding.mistakes[0].what.ends_with("in states tagged 1d"), "{finding:?}");
}

/// What is found in answers of a cable.
fn found_in_a_cable(quantity: &str, answer: impl Fn(&CableState) -> Vec<f64>) -> Vec<Mistake> {
    let answers: Vec<(&Case, Vec<f64>)> = (SUITE.cases.iter())
        .filter_map(|case| match &case.state {
            State::Cable(state) => Some((case, answer(state))),
            _ => None,
        })
        .collect();
    let outcome = |case: &Case, numbers: &'static [f64]| match case.values[quantity].worst_entry(numbers).1 <= 1.0 {
        true => Outcome::Right,
        false => Outcome::Wrong(numbers),
    };
    let observations: Vec<Observation> = (answers.into_iter())
        .map(|(case, numbers)| Observation { case, outcome: outcome(case, Vec::leak(numbers)) })
        .collect();
    diagnose(quantity, &observations).mistakes
}

#[test]
fn mistakes_in_a_cable_have_kinds() {
    for quantity in ["cable.epsilon", "cable.U", "cable.Q_e", "cable.tangent", "cable.eddot"] {
        let found = found_in_a_cable(quantity, |state| {
            evaluate_cable(quantity, &CableState { alpha: -state.alpha, ..state.clone() }).unwrap()
        });
        assert_eq!(found[0].kind, MistakeKind::Sign, "{quantity}: {found:?}");
        assert!(found[0].what.contains("heat") || found[0].what.contains("ε_T"), "{quantity}: {found:?}");
    }
    for quantity in ["cable.U", "cable.Q_e", "cable.tangent"] {
        // EA goes with h and EI with its cube: their parts follow from two heights.
        let found = found_in_a_cable(quantity, |state| {
            let with = |h: f64| evaluate_cable(quantity, &CableState { h, ..state.clone() }).unwrap();
            let (one, two) = (with(state.h), with(2.0 * state.h));
            one.iter().zip(two).map(|(one, two)| one + 11.0 * (two - 2.0 * one) / 6.0).collect()
        });
        assert!(found.iter().any(|mistake| mistake.what == "I = w h³ without 1/12"), "{quantity}: {found:?}");
    }
    let found = found_in_a_cable("cable.kappa", |state| {
        let (r_x, kappa) = ("cable.r_x", "cable.kappa");
        let norms = evaluate_cable(r_x, state).unwrap();
        let norms = norms.chunks(2).map(|r_x| r_x[0].hypot(r_x[1]));
        evaluate_cable(kappa, state).unwrap().iter().zip(norms).map(|(kappa, norm)| kappa / norm).collect()
    });
    assert!(found[0].what.starts_with("|r_x|³ for |r_x|²"), "{found:?}");
    let found = found_in_a_cable("cable.M", |state| {
        let half = state.rho * state.h * state.w * state.l / 2.0;
        (0..64).map(|n| if [0, 9, 36, 45].contains(&n) { half } else { 0.0 }).collect()
    });
    assert_eq!(found[0].what, "lumped: half on each end");
}
