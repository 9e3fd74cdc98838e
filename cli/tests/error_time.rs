//! `ancf error-time`: the files that it writes, and the input that it refuses.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

/// A built-in scene as a file, changed.
fn scene_file(path: &Path, builtin: &str, change: impl FnOnce(&mut serde_json::Value)) {
    let text = String::from_utf8(ancf(Path::new("."), &["scene", builtin]).stdout).unwrap();
    let mut scene = serde_json::from_str(&text).unwrap();
    change(&mut scene);
    fs::write(path, scene.to_string()).unwrap();
}

#[test]
fn bad_input_is_exit_code_2_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    scene_file(&path.join("unseen.json"), "cantilever", |scene| scene["probes"] = serde_json::json!([]));
    scene_file(&path.join("path.json"), "cantilever", |scene| scene["time"]["path"] = "arc-length".into());
    fs::write(path.join("mute.sh"), "echo hello\n").unwrap();
    let cases = [
        (&["error-time", "pendulum"][..], "`SCENE` is `pendulum`; allowed: pendulum-flexible, "),
        (&["error-time", "--references", "pendulum"], "`SCENE` is `pendulum`"),
        (&["error-time", "none.json"], "none.json"),
        (
            &["error-time", "unseen.json"],
            "unseen.json: `probes` is without one of a position; allowed: a probe of a point's position",
        ),
        (&["error-time", "path.json"], "path.json: `time.path` is arc-length; allowed: statics by load steps"),
        (
            &["error-time", "cantilever", "--peer", "no-such-program"],
            "the program `no-such-program` cannot be measured: ",
        ),
        (&["error-time", "cantilever", "--peer", "sh mute.sh"], "its line `hello` is no answer"),
        (&["error-time", "cantilever", "--peer", "true"], "it has ended without an answer"),
    ];
    for (arguments, says) in cases {
        let output = ancf(path, arguments);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
        assert!(stderr.contains(says), "{arguments:?}: {stderr}");
    }
    assert!(!path.join("out").exists() || names(&path.join("out")).is_empty());
}

/// Of a program that has no run of the scene.
#[test]
fn another_program_is_asked_in_lines_of_json() {
    let folder = tempfile::tempdir().unwrap();
    let script = "echo '{\"program\": \"Other\", \"version\": \"1.0\", \"build\": \"fast\"}'\n\
                  while read -r line; do echo \"$line\" >> asked.txt; echo '{\"points\": []}'; done\n";
    fs::write(folder.path().join("other.sh"), script).unwrap();
    let output = ancf(folder.path(), &["error-time", "--quick", "cantilever", "--peer", "sh other.sh"]);
    let stdout = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && stdout.contains("Other 1.0 (fast), in turns with this one"), "{stdout}");
    let asked = fs::read_to_string(folder.path().join("asked.txt")).unwrap();
    assert_eq!(asked, "{\"points\":\"cantilever\",\"quick\":true}\n");
}

#[test]
fn a_scene_of_ones_own_is_told_which_method_mesh_and_step_to_take() {
    let folder = tempfile::tempdir().unwrap();
    scene_file(&folder.path().join("mine.json"), "cantilever", |scene| {
        (scene["section"]["height"], scene["section"]["width"]) = (0.02.into(), 0.02.into());
        scene["forces"][0]["force"] = serde_json::json!([0.0, -7000.0]);
    });
    let output = ancf(folder.path(), &["error-time", "--quick", "mine.json", "--out", "here"]);
    let (stdout, stderr) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && stderr.is_empty(), "{stdout}{stderr}");
    let advice = "mine, ancf, errors below 1e-3 m: \"elements\": ";
    let line = stdout.lines().find(|line| line.contains(advice)).unwrap_or_else(|| panic!("{stdout}"));
    let (elements, time) = line.split_once(advice).unwrap().1.split_once(" in each rod, \"time\": ").unwrap();
    assert!(
        !stdout.contains("Economies")
            && stdout.contains("mine, ancf: ")
            && stdout.contains("; reference 32 elements ± ")
    );
    let html = fs::read_to_string(folder.path().join("here/error-time.html")).unwrap();
    assert!(html.contains("As lines of a scene file") && html.contains("mine, ancf, errors below 1e-3 m"));
    // The lines are those of a scene file, and hold what they promise.
    let tip = |elements: &str, time: &str| {
        scene_file(&folder.path().join("taken.json"), "cantilever", |scene| {
            (scene["section"]["height"], scene["section"]["width"]) = (0.02.into(), 0.02.into());
            scene["forces"][0]["force"] = serde_json::json!([0.0, -7000.0]);
            scene["rods"][0]["elements"] = elements.parse::<usize>().unwrap().into();
            scene["time"] = serde_json::from_str(time).unwrap();
        });
        let run = ancf(folder.path(), &["run", "taken.json", "--out", "taken", "--no-report"]);
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let csv = fs::read_to_string(folder.path().join("taken/trajectory.csv")).unwrap();
        let last: Vec<f64> = csv.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
        [last[1], last[2]]
    };
    let (own, fine) = (tip(elements, time), tip("128", "{\"method\": \"static\", \"load_steps\": 20}"));
    assert!((own[0] - fine[0]).hypot(own[1] - fine[1]) <= 1e-3, "{own:?} {fine:?}");
}

/// A flat toggle beyond its limit load.
#[test]
fn a_scene_without_a_reference_ends_with_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let scene = serde_json::json!({
        "schema": "ancf-scene/1", "title": "flat toggle", "material": {"E": 2e8, "nu": 0.0, "rho": 7750.0},
        "section": {"height": 0.02, "width": 0.02}, "points": {"a": [0.0, 0.0], "b": [1.0, 0.05], "c": [2.0, 0.0]},
        "rods": [{"name": "ab", "from": "a", "to": "b", "elements": 1}, {"name": "bc", "from": "b", "to": "c", "elements": 1}],
        "supports": [{"point": "a", "fix": ["x", "y"]}, {"point": "c", "fix": ["x", "y"]}],
        "forces": [{"point": "b", "force": [0.0, -1000.0]}], "time": {"method": "static", "load_steps": 10},
        "probes": [{"name": "b", "point": "b", "of": ["position"]}],
    });
    fs::write(folder.path().join("toggle.json"), scene.to_string()).unwrap();
    let output = ancf(folder.path(), &["error-time", "--quick", "toggle.json"]);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(!folder.path().join("out").exists() || names(&folder.path().join("out")).is_empty());
}

#[test]
fn the_command_writes_its_four_files() {
    let folder = tempfile::tempdir().unwrap();
    let output = ancf(folder.path(), &["error-time", "--quick", "cantilever", "--out", "here"]);
    let (stdout, stderr) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && stderr.is_empty(), "{stderr}");
    for part in [
        "No other program was measured: `--peer \"python -m oracle.peers\"` does.",
        "cantilever, euler-bernoulli:",
        "≤ 1e-2 m  static",
    ] {
        assert!(stdout.contains(part), "no {part:?} in {stdout}");
    }
    let here = folder.path().join("here");
    assert_eq!(names(&here), ["error-time.csv", "error-time.html", "error-time.json", "error-time.svg"]);
    let read = |name: &str| fs::read_to_string(here.join(name)).unwrap();
    let csv = read("error-time.csv");
    let (heading, rows) = csv.split_once('\n').unwrap();
    assert!(heading.starts_with("program,scene,element,method,elements,step,") && heading.ends_with(",status,reason"));
    assert!(rows.contains(",ok,") && rows.lines().all(|row| row.starts_with("ancf,cantilever,")), "{rows}");
    let json: serde_json::Value = serde_json::from_str(&read("error-time.json")).unwrap();
    assert!(json["machine"]["version"] == env!("CARGO_PKG_VERSION") && json["options"]["quick"] == true);
    let html = read("error-time.html");
    assert!(
        json["winners"].as_array().unwrap().iter().all(|winner| winner["ours"]["time"]["in_turns"] == true),
        "{json}"
    );
    assert!(html.contains("<svg") && html.contains("Which method for which accuracy") && html.ends_with("</html>\n"));
}
