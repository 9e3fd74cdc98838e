//! The command line: what is printed, what is written, and the exit codes.

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use ancf::internals::model::{Scissors, builtin_names};
use ancf::model::{Model, Scene, ThermalModel};
use serde_json::Value;

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

fn stdout(output: Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn entries(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

#[test]
fn scenes_lists_names_and_titles() {
    let folder = tempfile::tempdir().unwrap();
    let list = stdout(ancf(folder.path(), &["scenes"]));
    assert_eq!(list.lines().count(), builtin_names().count() + 1);
    for (line, name) in list.lines().zip(builtin_names()) {
        assert!(line.starts_with(name) && line.ends_with(&Scene::builtin(name).unwrap().title), "{line}");
    }
    let last = list.lines().last().unwrap();
    for part in ["scissors-<n> ", "scissors-<n>-thermal", "--angle", "--force", "--temperature"] {
        assert!(last.contains(part), "no {part:?} in: {last}");
    }
    assert!(entries(folder.path()).is_empty());
}

#[test]
fn a_printed_scene_is_a_file_to_start_from() {
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(ancf(folder.path(), &["scene", "pendulum-2d"]));
    let file = folder.path().join("mine.json");
    fs::write(&file, text).unwrap();
    assert_eq!(Model::load(file.to_str().unwrap()).unwrap().into_scene(), Scene::builtin("pendulum-2d").unwrap());
}

#[test]
fn scissors_are_printed_in_any_number_and_as_the_options_say() {
    let folder = tempfile::tempdir().unwrap();
    let printed = |arguments: &[&str]| {
        let text = stdout(ancf(folder.path(), &[&["scene"], arguments].concat()));
        Model::parse(&text, "printed").unwrap().into_scene()
    };
    assert_eq!(printed(&["scissors-10"]), Model::load("scissors-10").unwrap().into_scene());
    let options = ["--angle", "70", "--force", "-20.5", "--temperature", "1d"];
    let changed = Scissors { angle: 70.0, force: -20.5, model: ThermalModel::OneD, ..Scissors::new(4) };
    assert_eq!(printed(&[&["scissors-4"][..], &options].concat()), changed.scene().unwrap());
    // An option that is not given leaves what the name says.
    let cold = Scissors { angle: 70.0, ..Scissors::new(3) };
    assert_eq!(printed(&["scissors-3-thermal", "--temperature", "none", "--angle", "70"]), cold.scene().unwrap());
    let heated = Scissors { force: 20.0, model: ThermalModel::TwoD, ..Scissors::new(3) };
    assert_eq!(printed(&["scissors-3-thermal", "--force", "20"]), heated.scene().unwrap());
}

#[test]
fn options_of_scissors_that_do_not_fit_are_exit_code_2() {
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        (&["scissors-3", "--angle", "90"][..], "scissors-3: `angle` is 90.0; allowed: a number between 0 and 90"),
        (&["scissors-3", "--angle", "steep"], "invalid value 'steep' for '--angle <DEGREES>'"),
        (&["scissors-3", "--force", "NaN"], "`force` is NaN; allowed: a finite number"),
        (&["scissors-3", "--temperature", "3d"], "[possible values: 2d, 1d, transverse, none]"),
        (&["scissors-6251"], "`scissors-<n>` is 6251; allowed: a whole number from 1 to 6250"),
        (
            &["pendulum-2d", "--angle", "70"],
            "pendulum-2d: `--angle` is 70; allowed: this option for the scenes `scissors-<n>`",
        ),
        (&["pendulum-2d", "--temperature", "none"], "`--temperature` is none; allowed: this option"),
        (&["mine.json", "--force", "1"], "mine.json: `--force` is 1; allowed: this option"),
    ];
    for command in ["scene", "run"] {
        for (arguments, part) in cases {
            let output = ancf(folder.path(), &[&[command], arguments].concat());
            let message = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{message}");
            assert!(message.contains(part), "no {part:?} in: {message}");
        }
    }
    assert!(entries(folder.path()).is_empty());
}

#[test]
fn scene_of_an_unknown_name_tells_the_nearest() {
    let folder = tempfile::tempdir().unwrap();
    let output = ancf(folder.path(), &["scene", "free-rod"]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(message.contains("free-rod: no built-in scene") && message.contains("`free-rod-heated`"), "{message}");
}

#[test]
fn run_writes_the_trajectory_and_the_summary() {
    let folder = tempfile::tempdir().unwrap();
    let output = ancf(folder.path(), &["run", "free-rod-heated", "--out", "new/results"]);
    assert!(output.stderr.is_empty(), "there is no progress bar in a pipe");
    let printed = stdout(output);
    let out = folder.path().join("new/results");
    assert_eq!(entries(&out), ["report.html", "summary.json", "trajectory.csv"]);

    let scene = Scene::builtin("free-rod-heated").unwrap();
    let csv = fs::read_to_string(out.join("trajectory.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], scene.columns());
    assert_eq!(rows.len(), 1 + scene.steps() + 1);
    let last: Vec<f64> = rows.last().unwrap().iter().map(|number| number.parse().unwrap()).collect();
    assert!((last[0] - scene.time.end).abs() < 1e-12);

    let summary: Value = serde_json::from_str(&fs::read_to_string(out.join("summary.json")).unwrap()).unwrap();
    assert_eq!(serde_json::from_value::<Scene>(summary["scene"].clone()).unwrap(), scene);
    assert_eq!(summary["method"], "energy-momentum");
    assert_eq!(summary["steps"], 50);
    for (column, name) in rows[0].iter().enumerate().skip(1).take(4) {
        assert_eq!(summary["final"]["probes"][name], last[column], "{name}");
    }
    assert!(summary["accuracy"]["energy"]["value"].is_f64());

    for part in [&scene.title, "energy-momentum: 50 steps", "to.y", "trajectory.csv", "summary.json"] {
        assert!(printed.contains(part), "no {part:?} in:\n{printed}");
    }
}

#[test]
fn run_of_a_file_with_other_output() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = Scene::builtin("free-rod-heated").unwrap();
    (scene.output.interval, scene.output.energy) = (Some(0.02), false);
    fs::write(folder.path().join("mine.json"), serde_json::to_string(&scene).unwrap()).unwrap();
    stdout(ancf(folder.path(), &["run", "mine.json"]));
    let csv = fs::read_to_string(folder.path().join("out/trajectory.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("t,from.x,from.y,to.x,to.y"));
    let times: Vec<f64> = lines.map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(times.len(), 4);
    for (time, expected) in times.iter().zip([0.0, 0.02, 0.04, 0.05]) {
        assert!((time - expected).abs() < 1e-12, "{times:?}");
    }
}

#[test]
fn output_that_cannot_be_written_is_exit_code_1_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("taken"), "a file").unwrap();
    let output = ancf(folder.path(), &["run", "free-rod-heated", "--out", "taken"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stderr).unwrap().starts_with("error: cannot write taken"));

    fs::create_dir_all(folder.path().join("out/summary.json")).unwrap();
    let output = ancf(folder.path(), &["run", "free-rod-heated"]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(entries(&folder.path().join("out")), ["summary.json"]);
}

/// Runs the changed `pendulum-2d` into a folder that holds an older result, and returns exit code and message. Bad input leaves that
/// alone, a run that fails replaces it.
fn failing_run(time: Value, energy: bool) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = serde_json::to_value(Scene::builtin("pendulum-2d").unwrap()).unwrap();
    (scene["time"], scene["output"]) = (time, serde_json::json!({"energy": energy}));
    fs::write(folder.path().join("mine.json"), scene.to_string()).unwrap();
    fs::create_dir(folder.path().join("out")).unwrap();
    fs::write(folder.path().join("out/summary.json"), "an older result").unwrap();
    let output = ancf(folder.path(), &["run", "mine.json"]);
    let summary = fs::read_to_string(folder.path().join("out/summary.json")).unwrap();
    if output.status.code() == Some(2) {
        assert_eq!(entries(&folder.path().join("out")), ["summary.json"]);
        assert_eq!(summary, "an older result");
    } else {
        assert_eq!(entries(&folder.path().join("out")), ["report.html", "summary.json", "trajectory.partial.csv"]);
        assert!(summary.contains("\"status\": \"failed\""), "{summary}");
    }
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn newton_that_does_not_converge_is_exit_code_1_with_time_iterations_and_residual() {
    let (code, message) =
        failing_run(serde_json::json!({"end": 1.0, "step": 0.01, "method": "energy-momentum"}), false);
    assert_eq!(code, Some(1), "{message}");
    for part in ["at t = 0.", "residual", "iterations (tolerance 1.0e-10)"] {
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

#[test]
fn energy_that_appears_is_exit_code_1_with_its_size() {
    let (code, message) =
        failing_run(serde_json::json!({"end": 1.0, "step": 0.01, "method": "generalized-alpha"}), true);
    assert_eq!(code, Some(1), "{message}");
    for part in ["at t = 0.", "the energy has grown by", "J that loads and heat put in", "`time.step`"] {
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

#[test]
fn an_explicit_step_over_the_limit_is_exit_code_2_with_the_limit() {
    let (code, message) = failing_run(serde_json::json!({"end": 1.0, "step": 1e-4, "method": "explicit"}), true);
    assert_eq!(code, Some(2), "{message}");
    for part in ["`time.step` is 1e-4", "allowed: at most 6.", "explicit"] {
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

#[test]
fn wrong_usage_is_exit_code_2() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [&["run"][..], &["fly"], &["run", "pendulum-2d", "--fast"], &["--out", "x", "scenes"]] {
        assert_eq!(ancf(folder.path(), arguments).status.code(), Some(2), "{arguments:?}");
    }
    assert!(entries(folder.path()).is_empty());
}

#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let command = command.args(["scene", "pendulum-2d"]).current_dir(folder.path());
    // The pipe's reading end is closed before the program starts, so that its first write fails.
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut child = command.stdout(writer).stderr(Stdio::piped()).spawn().unwrap();
    let mut message = String::new();
    child.stderr.take().unwrap().read_to_string(&mut message).unwrap();
    assert_eq!((child.wait().unwrap().code(), message.as_str()), (Some(0), ""));
}

/// Linux has a device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_standard_output_that_is_full_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = command.args(["scene", "pendulum-2d"]).current_dir(folder.path()).stdout(full).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.starts_with("error: cannot write standard output"), "{message}");
}
