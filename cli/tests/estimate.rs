//! `ancf run --estimate`: errors in time and space in `summary.json`, and exit code 1 where no digit is sure.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf::model::{Method, Scene};
use serde_json::Value;

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

fn pendulum(method: Method, step: f64) -> Scene {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap();
    scene.rods[0].elements = 2;
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, 0.1);
    scene
}

#[test]
fn the_summary_has_both_errors_with_their_method_and_the_rows_are_the_same() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.json"), pendulum(Method::EnergyMomentum, 1e-3).to_text()).unwrap();
    let run = |arguments: &[&str]| {
        let output = ancf(folder.path(), arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).unwrap();
        let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
        (read("trajectory.csv"), summary, String::from_utf8(output.stdout).unwrap())
    };
    let (plain, summary, _) = run(&["run", "mine.json"]);
    assert_eq!(summary["accuracy"]["time"], "not estimated");
    let (estimated, summary, text) = run(&["run", "mine.json", "--estimate"]);
    assert_eq!(plain, estimated);
    for (part, how) in [("time", "half the step"), ("space", "twice the elements")] {
        let known = &summary["accuracy"][part];
        let value = known["value"].as_f64().unwrap();
        assert!(value > 0.0 && value < 1e-2 && known["unit"] == "m", "{known}");
        assert!(known["method"].as_str().unwrap().contains(how), "{known}");
        assert!(text.contains(how), "{text}");
    }
}

/// Two elements cannot bend by 80°.
#[test]
fn a_result_without_a_digit_is_an_error() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    (scene.rods[0].elements, scene.time.load_steps) = (2, 20);
    scene.section.height = 1e-4;
    scene.section.width = 0.1;
    scene.forces[0].force[1] *= 0.1;
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.json"), scene.to_text()).unwrap();
    let output = ancf(folder.path(), &["run", "mine.json", "--estimate"]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(1) && message.contains("not even the first digit is sure"), "{message}");
    let summary: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out/summary.json")).unwrap()).unwrap();
    assert_eq!(summary["status"], "failed");
}
