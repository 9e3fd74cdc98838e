//! Programs below double precision: right ones pass, and mistakes are named as in double precision.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::sync::LazyLock;

use ancf::equations::shape;
use ancf::state::{ElementState, evaluate};
use ancf_conform::{Answer, Asked, Code, Examination, MistakeKind, Options, Report, Suite, examine};

static SUITE: LazyLock<Suite> = LazyLock::new(|| Suite::embedded().unwrap());

/// Quantities that the programs below answer.
const QUANTITIES: [&str; 21] = [
    "3.S",
    "3.S_x",
    "3.S_y",
    "2.S",
    "1.r",
    "7.M",
    "6.T",
    "8.epsilon_T",
    "9.J_0",
    "9.J",
    "10.epsilon_m",
    "13.epsilon_1",
    "14.epsilon",
    "17.lambda",
    "17.mu",
    "16.D",
    "18.U",
    "21.K_1",
    "21.K_3",
    "19.Q_e",
    "tangent.dQ_e",
];

/// Computes a quantity in a state, perhaps with a mistake.
type Equation = fn(&str, &ElementState) -> Vec<f64>;

fn right(quantity: &str, state: &ElementState) -> Vec<f64> {
    evaluate(quantity, state).unwrap()
}

/// Examines a program that computes with `equation` in a state that is read with `read`, and prints its numbers with `print`.
fn examined(equation: Equation, read: fn(f64) -> f64, print: fn(f64) -> f64) -> (Examination, Report) {
    let answer = |question: &Asked| {
        let Ok(mut state) = ElementState::parse(&question.state.to_string(), "state") else {
            return Answer::Error("not a state".into());
        };
        let ElementState { l, h, w, theta, E, nu, rho, alpha, dT, .. } = &mut state;
        [l, h, w, theta, E, nu, rho, alpha, dT].into_iter().for_each(|number| *number = read(*number));
        let vectors = [&mut state.e0, &mut state.e, &mut state.edot].into_iter().flatten();
        vectors.chain(&mut state.gravity).for_each(|number| *number = read(*number));
        state.points.iter_mut().flatten().for_each(|number| *number = read(*number));
        let value = equation(question.equation, &state).into_iter().map(print).collect::<Vec<_>>();
        let case = SUITE.cases.iter().find(|case| case.state_json == *question.state).unwrap();
        Answer::value(nested(&value, &case.values[question.equation].shape))
    };
    let mut program = Code::new("program", answer).with_quantities(QUANTITIES);
    let examination = examine(&SUITE, &mut program, Options::default(), |_| {});
    let report = Report::new(&SUITE, &examination);
    (examination, report)
}

/// Nested lists of a shape.
fn nested(numbers: &[f64], shape: &[usize]) -> serde_json::Value {
    match shape {
        [] => numbers[0].into(),
        [length, inner @ ..] => numbers.chunks(numbers.len() / length).map(|part| nested(part, inner)).collect(),
    }
}

fn double(number: f64) -> f64 {
    number
}

fn single(number: f64) -> f64 {
    f64::from(number as f32)
}

fn six_digits(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap()
}

fn six_decimals(number: f64) -> f64 {
    format!("{number:.6}").parse().unwrap()
}

fn nine_decimals(number: f64) -> f64 {
    format!("{number:.9}").parse().unwrap()
}

fn culprits(report: &Report) -> Vec<&str> {
    report.culprits.iter().map(|culprit| culprit.blame.quantity).collect()
}

/// Kinds of the mistakes that explain the first wrong equation.
fn kinds(report: &Report) -> Vec<MistakeKind> {
    report.first_wrong.iter().flat_map(|culprit| &culprit.diagnosis.mistakes).map(|mistake| mistake.kind).collect()
}

#[test]
fn right_programs_pass_at_their_precision() {
    for (read, print, kind, by_errors) in [
        (double as fn(f64) -> f64, double as fn(f64) -> f64, "double precision", false),
        (single, single, "single precision", false),
        (double, six_digits, "six significant digits printed", false),
        (double, six_decimals, "six decimals printed", false),
        (double, nine_decimals, "nine decimals printed", false),
        // The numbers have all digits, but none has more than eight right ones.
        (single, double, "single precision", true),
    ] {
        let (_, report) = examined(right, read, print);
        assert_eq!((report.precision.kind.as_str(), report.precision.by_errors), (kind, by_errors));
        assert!(report.passes, "{kind}: {}", report.markdown());
        assert!(report.precision.others.is_empty(), "{:?}", report.precision.others);
    }
}

/// E3 in the energy.
fn shear_counted_once(quantity: &str, state: &ElementState) -> Vec<f64> {
    right(if quantity == "18.U" { "18.U/printed-shear" } else { quantity }, state)
}

/// Plane stress in (17), and in all that uses it.
fn plane_stress(quantity: &str, state: &ElementState) -> Vec<f64> {
    match quantity {
        "17.lambda" => vec![state.E * state.nu / ((1.0 + state.nu) * (1.0 - state.nu))],
        _ => right(quantity, state),
    }
}

/// (1 + ν)αΔT for αΔT in (8).
fn plane_strain_heat(quantity: &str, state: &ElementState) -> Vec<f64> {
    match quantity {
        "8.epsilon_T" => right(quantity, state).into_iter().map(|heat| (1.0 + state.nu) * heat).collect(),
        _ => right(quantity, state),
    }
}

#[test]
fn mistakes_are_named_at_any_precision() {
    let mistakes: [(Equation, &str, MistakeKind); 3] = [
        (shear_counted_once, "18.U", MistakeKind::Erratum),
        (plane_stress, "17.lambda", MistakeKind::Poisson),
        (plane_strain_heat, "8.epsilon_T", MistakeKind::Heat),
    ];
    for (equation, quantity, kind) in mistakes {
        for (read, print, precision) in [
            (double as fn(f64) -> f64, double as fn(f64) -> f64, "double precision"),
            (single, single, "single precision"),
            (double, six_digits, "six significant digits printed"),
            (double, nine_decimals, "nine decimals printed"),
        ] {
            let (_, report) = examined(equation, read, print);
            assert_eq!(report.precision.kind, precision);
            assert_eq!(culprits(&report), [quantity], "{precision}: {}", report.markdown());
            assert_eq!(kinds(&report).first(), Some(&kind), "{precision}: {}", report.markdown());
        }
    }
}

#[test]
fn a_small_mistake_in_double_precision_is_no_lack_of_precision() {
    let (_, report) = examined(
        |quantity, state| {
            let factor = if quantity == "17.mu" { 1.0 + 1e-8 } else { 1.0 };
            right(quantity, state).into_iter().map(|number| number * factor).collect()
        },
        double,
        double,
    );
    assert_eq!(report.precision.kind, "double precision");
    assert_eq!(culprits(&report), ["17.mu"]);
}

#[test]
fn a_quantity_in_another_precision_is_said() {
    let (_, report) = examined(
        |quantity, state| {
            let print = if quantity == "7.M" { single } else { double };
            right(quantity, state).into_iter().map(print).collect()
        },
        double,
        double,
    );
    assert!(report.passes, "{}", report.markdown());
    assert_eq!(report.precision.kind, "double precision");
    let others: Vec<_> =
        report.precision.others.iter().map(|other| (other.kind.as_str(), &other.quantities[..])).collect();
    assert_eq!(others, [("single precision", &["7.M"][..])]);
}

/// (7) with Gauss points and weights of eight decimals.
fn short_constants(quantity: &str, state: &ElementState) -> Vec<f64> {
    if quantity != "7.M" {
        return right(quantity, state);
    }
    const ALONG: [(f64, f64); 5] = [
        (-0.90617985, 0.23692689),
        (-0.53846931, 0.47862867),
        (0.0, 0.56888889),
        (0.53846931, 0.47862867),
        (0.90617985, 0.23692689),
    ];
    const ACROSS: [(f64, f64); 3] = [(-0.77459667, 0.55555556), (0.0, 0.88888889), (0.77459667, 0.55555556)];
    let ElementState { l, h, w, rho, .. } = *state;
    let mut M = vec![0.0; 196];
    for ((xi, of_xi), (eta, of_eta)) in ALONG.iter().flat_map(|a| ACROSS.iter().map(move |b| (*a, *b))) {
        let S = shape::S(l / 2.0 * (1.0 + xi), h / 2.0 * eta, l);
        let dm = rho * l * h * w / 4.0 * of_xi * of_eta;
        let product = S.tr_mul(&S) * dm;
        M.iter_mut().enumerate().for_each(|(n, entry)| *entry += product[(n / 14, n % 14)]);
    }
    M
}

#[test]
fn constants_with_few_digits_are_named() {
    let (_, report) = examined(short_constants, double, double);
    assert_eq!(report.precision.kind, "double precision");
    assert_eq!(culprits(&report), ["7.M"]);
    let what: Vec<&str> = report.culprits[0].diagnosis.mistakes.iter().map(|mistake| mistake.what.as_str()).collect();
    assert_eq!(what, ["Gauss points and weights with 8 decimals"]);
}

#[test]
fn an_input_with_a_small_error_does_not_excuse_a_large_one() {
    let (_, report) = examined(
        |quantity, state| {
            let numbers = right(quantity, state);
            match quantity {
                "9.J" => numbers.into_iter().map(|number| number * (1.0 + 1e-9)).collect(),
                "10.epsilon_m" => numbers.into_iter().map(|number| -number).collect(),
                _ => numbers,
            }
        },
        double,
        double,
    );
    assert_eq!(culprits(&report), ["9.J", "10.epsilon_m"]);
    let because = &report.culprits[1].blame.because;
    assert!(because.contains("9.J lost 7.") || because.contains("9.J lost 6."), "{because}");
}

#[test]
fn digits_can_be_demanded() {
    let (examination, mut report) = examined(right, single, single);
    assert!(report.passes);
    report.demand(&SUITE, &examination, 5);
    assert!(report.passes && report.precision.fewer.is_empty());
    report.demand(&SUITE, &examination, 12);
    assert!(!report.passes);
    assert!(report.precision.fewer.iter().any(|fewer| fewer.quantity == "17.mu" && fewer.digits < 9.0));
    assert!(report.summary().contains("Fewer than the 12 digits demanded: 3.S"), "{}", report.summary());
    assert!(report.markdown().contains("have fewer than the 12 digits that are demanded"));
}

#[test]
fn mistakes_below_the_precision_are_invisible() {
    // K_3 with two decimals does not show the smaller mistakes in its heat.
    let (_, report) = examined(right, double, |number| format!("{number:.2}").parse().unwrap());
    assert_eq!(report.precision.kind, "two decimals printed");
    assert!(report.passes, "{}", report.markdown());
    assert!(!report.precision.invisible.is_empty());
    let of_heat = report.precision.invisible.iter().filter(|hidden| hidden.mistake.kind == MistakeKind::Heat);
    assert!(of_heat.count() > 0, "{:?}", report.precision.invisible);
}
