//! Limits: memory that the system does not give, states and files without an end, numbers out of range.

#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf_conform::Suite;
use serde_json::json;

/// A hundred million rows without a column but the time: 0.8 GB.
const ROWS: &str = r#"{"schema": "ancf-scene/1", "material": {"E": 2e8, "nu": 0, "rho": 7750}, "section": {"height": 0.02, "width": 0.02},
 "points": {"o": [0, 0], "a": [1, 0]}, "rods": [{"name": "r", "from": "o", "to": "a", "elements": 1}],
 "supports": [{"point": "o", "fix": ["x", "y"]}], "gravity": [0, -9.8], "time": {"end": 1.0, "step": 1e-8, "method": "explicit"},
 "output": {"energy": false}}"#;

/// Runs the program with so many kB of memory.
fn limited(folder: &Path, kilobytes: u64, arguments: &str) -> Output {
    let line = format!("ulimit -v {kilobytes}; exec \"$0\" {arguments}");
    let binary = env!("CARGO_BIN_EXE_ancf");
    Command::new("sh").args(["-c", &line, binary]).current_dir(folder).output().unwrap()
}

fn refused(output: Output, parts: &[&str]) {
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in parts {
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
    assert!(output.stdout.is_empty());
}

#[test]
fn memory_that_is_not_there_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("rows.json"), ROWS).unwrap();
    let parts = ["the rows of the trajectory, 100000001 of 1 columns, take 0.800 GB", "`output.interval`"];
    refused(limited(folder.path(), 700_000, "run rows.json"), &parts);

    // A hundred rods of a hundred elements that meet in one point.
    let points: Vec<String> = (0..100).map(|n| format!("\"p{n}\": [{}, 1.0]", n + 1)).collect();
    let rods: Vec<String> =
        (0..100).map(|n| format!(r#"{{"name": "r{n}", "from": "o", "to": "p{n}", "elements": 400}}"#)).collect();
    let scene = format!(
        r#"{{"schema": "ancf-scene/1", "material": {{"E": 2e8, "nu": 0, "rho": 7750}}, "section": {{"height": 0.02, "width": 0.02}},
        "points": {{"o": [0, 0], {}}}, "rods": [{}], "gravity": [0, -9.8], "time": {{"end": 0.001, "method": "gauss"}}}}"#,
        points.join(", "),
        rods.join(", ")
    );
    fs::write(folder.path().join("matrices.json"), scene).unwrap();
    refused(
        limited(folder.path(), 150_000, "run matrices.json"),
        &["which the system does not give", "fewer `elements`"],
    );
}

#[test]
fn states_are_bounded() {
    let folder = tempfile::tempdir().unwrap();
    let equations = |state: &str| {
        Command::new(env!("CARGO_BIN_EXE_ancf")).args(["equations", state]).current_dir(folder.path()).output().unwrap()
    };
    refused(equations("/dev/zero"), &["cannot read /dev/zero", "1048576 bytes"]);
    let mut state = Suite::embedded().unwrap().cases[0].state_json.clone();
    state["points"] = (0..1001).map(|_| json!([0.0, 0.0])).collect();
    fs::write(folder.path().join("state.json"), state.to_string()).unwrap();
    refused(equations("state.json"), &["`points` is a list of 1001", "at most 1000 points"]);
    state["points"] = json!([[0.0, 0.0]]);
    state["E"] = json!(1e308);
    fs::write(folder.path().join("state.json"), state.to_string()).unwrap();
    refused(equations("state.json"), &["state.json: ", "leave the range of numbers", "19.Q_e"]);
}
