//! `ancf equations`: every value of one state, and states that are refused.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf::error::Error;
use ancf::internals::equations::CONTENTS;
use ancf::state::{CableState, ElementState};
use ancf_conform::{State, Suite};
use serde_json::{Value, json};

fn ancf(folder: &Path, state: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(["equations", state]).current_dir(folder).output().unwrap()
}

#[test]
fn every_quantity_of_a_state_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    let suite = Suite::embedded().unwrap();
    let case = suite.cases.iter().find(|case| case.id == "bending-inclined-1d").unwrap();
    fs::write(folder.path().join("mine.json"), case.state_json.to_string()).unwrap();
    let output = ancf(folder.path(), "mine.json");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for entry in CONTENTS.iter().filter(|entry| !entry.is_of_a_structure() && !entry.is_of_a_cable()) {
        // The heat of this state is 1D.
        let is_there = entry.function != "strain::eps_T";
        let line = format!("{}  {}", entry.quantity, entry.function);
        let found = text.contains(&format!("{line}\n")) || text.contains(&format!("{line}  ["));
        assert_eq!(found, is_there, "{line}");
    }
    let U = case.values["18.U"].numbers[0];
    assert!(text.contains(&format!("(18) 18.U  force::U  [consistent]\n  {:>17}\n", format!("{U:.9e}"))), "{text}");
    let places = text.split("\n(13) 13.epsilon_1").nth(1).unwrap();
    let [x, y] = [0, 1].map(|n| case.state_json["points"][0][n].as_f64().unwrap());
    let epsilon_1 = case.values["13.epsilon_1"].numbers[0];
    let expected = format!("  strain::eps_1\n  at ({x}, {y})\n  {:>17}\n", format!("{epsilon_1:.9e}"));
    assert!(places.starts_with(&expected), "{expected}\n{places:.300}");
    // The name of a stored state does as well.
    assert_eq!(String::from_utf8(ancf(folder.path(), "bending-inclined-1d").stdout).unwrap(), text);
}

#[test]
fn what_no_element_can_be_is_refused_by_its_key() {
    let suite = Suite::embedded().unwrap();
    assert!(suite.invalid.len() >= 20);
    for invalid in &suite.invalid {
        let text = serde_json::to_string_pretty(&invalid.state).unwrap();
        let Err(error) = ElementState::parse(&text, "state.json") else { panic!("{} is accepted", invalid.id) };
        assert!(error.is_bad_input());
        let Error::Scene { key, .. } = &error else { panic!("{}: {error}", invalid.id) };
        assert!(key.starts_with(&invalid.key), "{}: {error}", invalid.id);
    }
    for case in suite.cases.iter().filter(|case| case.state_json.get("l").is_some() && !case.id.starts_with("cable-")) {
        ElementState::parse(&case.state_json.to_string(), &case.id).unwrap();
    }
}

#[test]
fn messages_name_file_place_key_value_and_what_is_allowed() {
    let folder = tempfile::tempdir().unwrap();
    let suite = Suite::embedded().unwrap();
    let right = &suite.cases[0].state_json;
    let with = |key: &str, value: Value| {
        let mut state = right.clone();
        state[key] = value;
        serde_json::to_string_pretty(&state).unwrap()
    };
    for (text, part) in [
        (with("nu", json!(0.5)), "`nu` is 0.5; allowed: a number over −1 and under 0.5"),
        (with("h", json!(-0.02)), "`h` is -0.02; allowed: a finite number over 0"),
        (with("height", json!(1)), "`height` is an unknown key (value 1); allowed: `l`, `h`"),
        (with("e", json!([1, 2])), "`e` is [ 1, 2 ]; allowed: an array of length 14"),
        (with("model", json!("3d")), "`model` is \"3d\"; allowed: `2d`, `1d`, `transverse`, `none`; nearest: `1d`"),
        (with("theta", json!(0.25)), "`theta` is 0.25; allowed: the inclination of e0, "),
        (with("points", json!([])), "`points` is []; allowed: one point [x, y] at least"),
        ("{\"l\": 1".into(), "state.json:1:"),
        ("[]".into(), "`state` is []; allowed: an object, {…}"),
    ] {
        fs::write(folder.path().join("state.json"), text).unwrap();
        let output = ancf(folder.path(), "state.json");
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(part) && message.contains("state.json"), "no {part:?} in: {message}");
        assert!(output.stdout.is_empty());
    }
    for (name, part) in [
        ("nowhere.json", "cannot read nowhere.json: there is no such file, and no stored state of that name"),
        ("bending-inclined-1", "nearest: `bending-inclined-1d`; stored are "),
        (".", "cannot read ."),
    ] {
        let output = ancf(folder.path(), name);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

#[test]
fn stored_states_of_cables_and_structures_are_printed_too() {
    let folder = tempfile::tempdir().unwrap();
    let suite = Suite::embedded().unwrap();
    for case in suite.cases.iter().filter(|case| !matches!(case.state, State::Element(_))).step_by(5) {
        let output = ancf(folder.path(), &case.id);
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let of_a_cable = matches!(case.state, State::Cable(_));
        for entry in CONTENTS.iter().filter(|entry| entry.is_of_a_cable() || entry.is_of_a_structure()) {
            let head = format!("{}  {}", entry.quantity, entry.function);
            assert_eq!(text.contains(&head), entry.is_of_a_cable() == of_a_cable, "{}: {head}", case.id);
        }
        let (name, first) = if of_a_cable { ("cable.U", 0) } else { ("23.residual", 0) };
        let value = case.values[name].numbers[first];
        let digits = if value == 0.0 { "0".into() } else { format!("{value:.9e}") };
        assert!(text.contains(&digits), "{}: no {digits} in\n{text}", case.id);
        if of_a_cable {
            fs::write(folder.path().join("mine.json"), case.state_json.to_string()).unwrap();
            assert_eq!(String::from_utf8(ancf(folder.path(), "mine.json").stdout).unwrap(), text);
        }
    }
}

#[test]
fn what_no_cable_element_can_be_is_refused_by_its_key() {
    let suite = Suite::embedded().unwrap();
    let mut of_cables = suite.cases.iter().filter(|case| case.id.starts_with("cable-"));
    for case in of_cables.clone() {
        CableState::parse(&case.state_json.to_string(), &case.id).unwrap();
    }
    let right = &of_cables.next_back().unwrap().state_json;
    let mut slope_off = right["e0"].clone();
    slope_off[2] = json!(slope_off[2].as_f64().unwrap() + 0.5);
    for (key, value, refused) in [
        ("w", json!(0), "w"),
        ("nu", json!(0.5), "nu"),
        ("dT", json!(-1e9), "dT"),
        ("theta", json!(0.3), "theta"),
        ("e0", json!([0, 0, 1, 0, 2, 0, 1, 0]), "e0"),
        ("e0", slope_off, "e0"),
        ("points", json!([[0, 1e-3]]), "points[0][1]"),
        ("points", json!([]), "points"),
        ("edot", json!([]), "edot"),
        ("e", json!([]), "e"),
        ("height", json!(1), "height"),
    ] {
        let mut state = right.clone();
        (state["model"], state[key]) = (json!("1d"), value);
        let Err(Error::Scene { key: named, .. }) = CableState::parse(&state.to_string(), "state.json") else {
            panic!("{key} is accepted")
        };
        assert_eq!(named, refused);
    }
}
