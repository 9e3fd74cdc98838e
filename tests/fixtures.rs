//! Every function of `src/equations/` against the symbolic oracle, in every state, and proof that none is left out.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;

use std::collections::BTreeSet;
use std::sync::LazyLock;

use ancf::equations::element::Element;
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::internals::equations::{CONTENTS, Entry};
use ancf::internals::state::evaluate_system;
use ancf::state::{evaluate, evaluate_cable};
use common::cable::{self, cables};
use common::evidence;
use common::scale::scale;
use common::system::{Terms, systems};
use common::{Case, Equations, TOLERANCE, cases, within, worst_ratio};

static EQUATIONS: LazyLock<Equations> = LazyLock::new(Equations::load);

#[test]
fn every_equation_meets_the_oracle_in_every_state() {
    let entries = CONTENTS.iter().filter(|entry| !entry.is_of_a_structure() && !entry.is_of_a_cable());
    meet_the_oracle("paper", entries.collect(), EQUATIONS.cases(), evaluate, scale);
}

#[test]
fn the_cable_meets_the_oracle_in_every_state() {
    let entries = CONTENTS.iter().filter(|entry| entry.is_of_a_cable());
    meet_the_oracle("cable", entries.collect(), cases(&cables(), 20), evaluate_cable, cable::scale);
}

/// Every entry's value in every case.
fn meet_the_oracle<S>(
    name: &str,
    entries: Vec<&Entry>,
    cases: Vec<Case<S>>,
    evaluate: fn(&str, &S) -> Option<Vec<f64>>,
    scale: fn(&str, &Case<S>) -> Vec<f64>,
) {
    evidence::number(&format!("equations.{name}-states"), cases.len());
    evidence::number(&format!("equations.{name}-quantities"), entries.len());
    // The last states are the random ones, where a mistake shows first.
    for case in cases.into_iter().rev() {
        let mut failures = Vec::new();
        for entry in &entries {
            let actual = evaluate(entry.quantity, &case.state).unwrap_or_else(|| panic!("no {}", entry.quantity));
            let (expected, scale) = (case.value(entry.reference), scale(entry.reference, &case));
            if !within(TOLERANCE, &actual, &expected, &scale) {
                let ratio = worst_ratio(&actual, &expected, &scale);
                failures.push(format!("{}: {ratio:.1e}", entry.quantity));
            }
        }
        assert!(
            failures.is_empty(),
            "{}: off by more than {TOLERANCE:e} of their scale:\n{}",
            case.id,
            failures.join("\n")
        );
    }
}

/// (23) on the oracle's terms: two pinned structures, and a square example in which the printed form has a value.
#[test]
fn equation_23_meets_the_oracle() {
    let mut printed = 0;
    for case in systems()["cases"].as_array().unwrap() {
        let terms = Terms::read(case);
        for entry in CONTENTS.iter().filter(|entry| entry.is_of_a_structure()) {
            let actual = evaluate_system(entry.quantity, &terms.state);
            if !terms.has(entry.reference) {
                assert!(entry.reference.ends_with("/printed"), "{}: no {}", terms.id, entry.reference);
                assert_eq!(actual, None, "{}: {} is not defined", terms.id, entry.quantity);
                continue;
            }
            printed += usize::from(entry.reference.ends_with("/printed"));
            let (expected, scale) = (terms.value(entry.reference), terms.scale(entry.reference));
            let actual = actual.unwrap_or_else(|| panic!("{}: no {}", terms.id, entry.quantity));
            let ratio = worst_ratio(&actual, &expected, &scale);
            assert!(within(TOLERANCE, &actual, &expected, &scale), "{}: {}: {ratio:.1e}", terms.id, entry.quantity);
        }
    }
    assert_eq!(printed, 2, "the square example has both printed values");
}

/// The tolerances that the fixtures publish for others are those of the tests here, times ten: two tables by two hands.
#[test]
fn published_tolerances_are_the_scales_of_these_tests() {
    let equations = &*EQUATIONS;
    let (of_elements, of_cables) = (&equations.json["states"], &cables()["states"]);
    for (stored, case) in of_elements.as_array().unwrap().iter().zip(equations.cases()) {
        for (quantity, value) in stored["values"].as_object().unwrap() {
            assert_published(&format!("{} {quantity}", case.id), value, &scale(quantity, &case));
        }
    }
    for (stored, case) in of_cables.as_array().unwrap().iter().zip(cases(&cables(), 20)) {
        for (quantity, value) in stored["values"].as_object().unwrap() {
            assert_published(&format!("{} {quantity}", case.id), value, &cable::scale(quantity, &case));
        }
    }
    for case in systems()["cases"].as_array().unwrap() {
        let terms = Terms::read(case);
        for quantity in ["23.constraint_force", "23.residual", "23.acceleration", "23.lambda"] {
            assert_published(&format!("{} {quantity}", terms.id), &case["values"][quantity], &terms.scale(quantity));
        }
    }
}

#[track_caller]
fn assert_published(what: &str, value: &serde_json::Value, scale: &[f64]) {
    let mut absolute = Vec::new();
    common::flatten(&value["absolute"], &mut absolute);
    let absolute = if absolute.len() == 1 { vec![absolute[0]; scale.len()] } else { absolute };
    assert_eq!((absolute.len(), value["relative"].as_f64()), (scale.len(), Some(10.0 * TOLERANCE)), "{what}");
    for (bound, size) in absolute.iter().zip(scale).filter(|(_, size)| **size > 1e-250) {
        // Rounded up to two digits; inverses of matrices are rounded in ours.
        let ratio = bound / (10.0 * TOLERANCE * size);
        assert!((1.0 - 1e-6..1.11).contains(&ratio), "{what}: {bound:e} is {ratio} of the scale {size:e}");
    }
}

#[test]
fn every_numbered_equation_has_a_function_and_a_fixture() {
    let equations = &*EQUATIONS;
    let listed: BTreeSet<&str> = CONTENTS.iter().map(|entry| entry.equation).collect();
    let numbers = (1..=23).map(|n| n.to_string()).chain((1..=5).map(|n| format!("A.{n}")));
    for number in numbers {
        assert!(listed.contains(number.as_str()), "equation ({number}) is not in CONTENTS");
    }
    let used: BTreeSet<&str> = CONTENTS.iter().map(|entry| entry.reference).collect();
    // Terms of (23), which the structure assembles; a test of its own compares them.
    let assembled = ["23.m", "23.Q_e", "23.f", "23.Phi", "23.Phi_q"];
    let (structure, cable) = (systems(), cables());
    let quantities = [&equations.json, &structure, &cable].map(|json| json["quantities"].as_object().unwrap());
    for quantity in quantities.iter().flat_map(|table| table.keys()).filter(|name| !assembled.contains(&name.as_str()))
    {
        assert!(used.contains(quantity.as_str()), "the fixture's {quantity} is tested by nothing");
    }
}

#[test]
fn the_contents_and_the_source_name_the_same_functions() {
    let mut in_source = BTreeSet::new();
    for module in ["shape", "inertia", "strain", "material", "force", "motion", "axis", "uniaxial", "cable"] {
        let path = format!("{}/src/equations/{module}.rs", env!("CARGO_MANIFEST_DIR"));
        for line in std::fs::read_to_string(path).unwrap().lines() {
            if let Some(rest) = line.strip_prefix("pub fn ") {
                in_source.insert(format!("{module}::{}", rest.split(['(', '<']).next().unwrap()));
            }
        }
    }
    // Steps on the way: `9.J` and all of (11) are computed through them.
    for helper in ["shape::S_x", "shape::S_y"] {
        assert!(in_source.remove(helper), "{helper} is gone");
    }
    let in_contents: BTreeSet<String> = CONTENTS.iter().map(|entry| entry.function.to_string()).collect();
    assert_eq!(in_source, in_contents);
}

/// (9) for any J₀, which no straight unstretched element tests: a configuration is undeformed against itself.
#[test]
fn a_configuration_is_undeformed_against_itself() {
    let mut deformed = 0;
    for case in EQUATIONS.cases() {
        let mut state = case.state.clone();
        state.e0 = state.e;
        let J_0 = evaluate("9.J_0", &state).unwrap();
        let det = J_0[0] * J_0[3] - J_0[1] * J_0[2];
        deformed += usize::from((det - 1.0).abs() > 0.1);
        let size = J_0.iter().map(|j| j * j).sum::<f64>() / det.abs();
        let J = evaluate("9.J", &state).unwrap();
        let identity = [1.0, 0.0, 0.0, 1.0].repeat(state.points.len());
        assert!(within(TOLERANCE, &J, &identity, &vec![size; J.len()]), "{}: {J:?}", case.id);
    }
    assert!(deformed >= 5, "hardly a state with another volume than at first");
}

/// e₀ of every state is that of a straight element, moved to its first node.
#[test]
fn the_straight_element_has_the_initial_coordinates_of_every_state() {
    for case in EQUATIONS.cases() {
        let s = &case.state;
        let element = Element::straight(s.l, s.h, s.w, s.theta);
        assert_eq!((element.l, element.h, element.w), (s.l, s.h, s.w), "{}", case.id);
        let is_position = |row: usize| matches!(row / 2, 0 | 2 | 5);
        let start = |row: usize| if is_position(row) { s.e0[row % 2] } else { 0.0 };
        let moved: Vec<f64> = element.e_0.iter().enumerate().map(|(row, e)| e + start(row)).collect();
        let scale: Vec<f64> = (0..14).map(|row| 1.0 + start(row).abs() + s.l).collect();
        let ratio = worst_ratio(&moved, &s.e0, &scale);
        assert!(within(TOLERANCE, &moved, &s.e0, &scale), "{}: {ratio:.1e}", case.id);
    }
}

/// (17) both ways: λ and μ of the oracle are those of E and ν, and give E and ν back.
#[test]
fn moduli_are_converted_both_ways() {
    for case in EQUATIONS.cases() {
        let moduli = case.state.moduli();
        let lame = LameConstants::from(moduli);
        let expected = [case.scalar("17.lambda"), case.scalar("17.mu")];
        let scale = [scale("17.lambda", &case)[0], scale("17.mu", &case)[0]];
        assert!(within(TOLERANCE, &[lame.lambda, lame.mu], &expected, &scale), "{}: {lame:?}", case.id);

        let back = YoungPoisson::from(LameConstants { lambda: expected[0], mu: expected[1] });
        // Near ν = ½ the sums are of large λ; near −1 the numbers cancel.
        let scale = [moduli.E * (1.0 + 1.0 / (1.0 + moduli.nu)), 1.0 + 1.0 / (1.0 + moduli.nu)];
        let found = [back.E, back.nu];
        let ratio = worst_ratio(&found, &[moduli.E, moduli.nu], &scale);
        assert!(within(TOLERANCE, &found, &[moduli.E, moduli.nu], &scale), "{}: {ratio:.1e}", case.id);
    }
}
