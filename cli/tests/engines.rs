//! What programs that start many runs rely on: standard input, changes of keys, a summary in a line, equal bytes, comparison.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};

/// A run of some milliseconds.
const SHORT: [&str; 4] = ["--set", "time.end=0.01", "--set", "rods.0.elements=2"];

fn ancf(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_ancf"));
    program.args(arguments).current_dir(folder).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = program.spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    ancf(folder, &[&["run"], arguments, &SHORT].concat(), "")
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn words(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn line(output: &Output) -> Value {
    let text = String::from_utf8(output.stdout.clone()).unwrap();
    assert_eq!(text.lines().count(), 1, "{text}");
    serde_json::from_str(&text).unwrap()
}

fn summary(folder: &Path, out: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join(out).join("summary.json")).unwrap()).unwrap()
}

#[test]
fn a_scene_comes_from_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let scene = ancf(folder.path(), &["scene", "pendulum-2d"], "").stdout;
    let arguments = [&["run", "-", "--out", "piped"], &SHORT[..]].concat();
    let piped = ancf(folder.path(), &arguments, std::str::from_utf8(&scene).unwrap());
    assert_eq!(code(&piped), 0, "{}", words(&piped));
    assert_eq!(code(&run(folder.path(), &["pendulum-2d", "--out", "named"])), 0);
    assert_eq!(summary(folder.path(), "piped")["run"], summary(folder.path(), "named")["run"]);
    let refused = ancf(folder.path(), &["run", "-"], "{\"schema\": 1}");
    assert!(code(&refused) == 2 && words(&refused).contains("standard input"), "{}", words(&refused));
}

#[test]
fn a_summary_has_the_changes_and_repeats_its_run() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(code(&run(folder.path(), &["pendulum-2d", "--out", "first"])), 0);
    let first = summary(folder.path(), "first");
    assert_eq!(first["set"], json!(["time.end=0.01", "rods.0.elements=2"]));
    assert_eq!((&first["scene"]["time"]["end"], &first["scene"]["rods"][0]["elements"]), (&json!(0.01), &json!(2)));
    for key in ["version", "platform"] {
        assert!(first["program"][key].is_string(), "{}", first["program"]);
    }
    let again = ancf(folder.path(), &["run", "first/summary.json", "--out", "again"], "");
    assert_eq!(code(&again), 0, "{}", words(&again));
    assert_eq!(summary(folder.path(), "again")["run"], first["run"]);
    let same = ancf(folder.path(), &["compare", "first", "again"], "");
    assert!(code(&same) == 0 && String::from_utf8_lossy(&same.stdout).contains("the same bytes"));
}

#[test]
fn the_summary_is_a_line_whether_a_run_ends_fails_or_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let ends = run(folder.path(), &["pendulum-2d", "--summary-line"]);
    assert_eq!((code(&ends), &line(&ends)["status"]), (0, &json!("ok")));
    let mut written = summary(folder.path(), "out");
    let mut told = line(&ends);
    for summary in [&mut written, &mut told] {
        summary.as_object_mut().unwrap().remove("wall_seconds").unwrap();
    }
    assert_eq!(told, written);
    // Sudden heat, and steps that are too long for its wave.
    let long = ["--set", "time.method=generalized-alpha", "--set", "time.step=0.01", "--set", "time.end=1"];
    let fails = ancf(folder.path(), &[&["run", "pendulum-2d", "--summary-line"], &long[..]].concat(), "");
    assert_eq!((code(&fails), &line(&fails)["status"]), (1, &json!("failed")));
    assert!(line(&fails)["error"].as_str().is_some_and(|error| words(&fails).contains(error)));
    let refused = run(folder.path(), &["pendulum-2d", "--summary-line", "--set", "material.E=-1"]);
    assert_eq!((code(&refused), &line(&refused)["status"]), (2, &json!("refused")));
    assert!(line(&refused)["error"].as_str().is_some_and(|error| error.contains("`material.E` is -1")));
}

#[test]
fn equal_inputs_give_equal_bytes() {
    let folder = tempfile::tempdir().unwrap();
    for out in ["one", "two"] {
        assert_eq!(code(&run(folder.path(), &["pendulum-2d", "--vtk", "--out", out])), 0);
    }
    for entry in fs::read_dir(folder.path().join("one")).unwrap() {
        let name = entry.unwrap().file_name();
        let [one, two] = ["one", "two"].map(|out| fs::read_to_string(folder.path().join(out).join(&name)).unwrap());
        let differ: Vec<_> = one.lines().zip(two.lines()).filter(|(a, b)| a != b).collect();
        let is_clock = differ.iter().all(|(a, _)| name == "summary.json" && a.contains("wall_seconds"));
        assert!(one.len().abs_diff(two.len()) < 32 && is_clock, "{name:?}: {differ:?}");
    }
}

#[test]
fn runs_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(code(&run(folder.path(), &["pendulum-2d", "--out", "a"])), 0);
    assert_eq!(code(&run(folder.path(), &["pendulum-2d", "--out", "b", "--set", "material.E=2.1e8"])), 0);
    assert_eq!(code(&ancf(folder.path(), &["compare", "a", "b"], "")), 0);
    let differ = ancf(folder.path(), &["compare", "a", "b", "--within", "1e-9"], "");
    assert!(code(&differ) == 1 && words(&differ).contains("the runs differ in tip.x"), "{}", words(&differ));
    assert_eq!(code(&ancf(folder.path(), &["compare", "a/trajectory.csv", "b", "--within", "1"], "")), 0);
    let other = ancf(folder.path(), &["compare", "a", "b", "--columns", "tip.z"], "");
    assert!(code(&other) == 2 && words(&other).contains("tip.x, tip.y"), "{}", words(&other));
    let lacking = ancf(folder.path(), &["compare", "a", "none"], "");
    assert!(code(&lacking) == 2 && words(&lacking).contains("none"), "{}", words(&lacking));
}

#[test]
fn a_plan_tells_what_a_run_will_take() {
    let folder = tempfile::tempdir().unwrap();
    let plan = ancf(folder.path(), &["plan", "pendulum-2d", "--cost", "--set", "time.end=0.01"], "");
    let text = String::from_utf8_lossy(&plan.stdout).into_owned();
    assert!(code(&plan) == 0 && text.contains("a run takes about") && text.contains("section: "), "{text}");
}

#[test]
fn shells_complete_commands() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = ancf(folder.path(), &["completions", shell], "");
        assert!(code(&script) == 0 && String::from_utf8_lossy(&script.stdout).contains("summary-line"), "{shell}");
    }
}
