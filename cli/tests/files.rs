//! Output files as sets: two runs at once, failed runs, full disks, folders that cannot be written, inputs that would be replaced.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf::model::Scene;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// A pendulum of `ROWS` steps.
const SCENE: &str = r#"{"schema": "ancf-scene/1", "title": "TITLE", "material": {"E": 2e8, "nu": 0.0, "rho": 7750.0},
 "section": {"height": 0.02, "width": 0.02}, "points": {"o": [0.0, 0.0], "a": [LENGTH, 0.0]},
 "rods": [{"name": "rod", "from": "o", "to": "a", "elements": 1}], "supports": [{"point": "o", "fix": ["x", "y"]}],
 "gravity": [0.0, -9.8], "time": {"end": END, "step": 4e-5, "method": "explicit"},
 "probes": [{"name": "tip", "point": "a", "of": ["position"]}]}"#;

/// A pendulum that no step of this length follows: it fails after some rows.
const FAILING: &str = r#"{"schema": "ancf-scene/1", "material": {"E": 2e8, "nu": 0.3, "rho": 2766.67, "alpha": 1e-3},
 "section": {"height": 0.02, "width": 0.02}, "points": {"o": [0.0, 0.0], "a": [1.0, 0.0]},
 "rods": [{"name": "rod", "from": "o", "to": "a", "elements": 8}], "supports": [{"point": "o", "fix": ["x", "y"]}],
 "gravity": [0.0, -9.8], "temperature": {"history": [[0.0, 0.0], [0.05, 0.0], [0.0501, 1e4]]},
 "time": {"end": 1.0, "step": 0.01, "method": "energy-momentum"},
 "probes": [{"name": "tip", "point": "a", "of": ["position"]}]}"#;

fn write_scene(folder: &Path, name: &str, length: &str, end: &str) {
    let text = SCENE.replace("TITLE", name).replace("LENGTH", length).replace("END", end);
    fs::write(folder.join(format!("{name}.json")), text).unwrap();
}

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

fn message(output: &Output, code: i32) -> String {
    let message = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(output.status.code(), Some(code), "{message}");
    message
}

fn entries(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

fn summary(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
}

/// The beginning of what `sha256sum` prints.
fn id_of(table: &Path) -> String {
    let digest = Sha256::digest(fs::read(table).unwrap());
    digest.iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}

#[test]
fn of_two_runs_at_once_one_stands_whole() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    write_scene(folder.path(), "one", "1.0", "0.004");
    write_scene(folder.path(), "two", "1.5", "0.004");
    let pairs = if cfg!(debug_assertions) { 25 } else { 300 };
    let mut wins = [0, 0];
    for _ in 0..pairs {
        let mut both = ["one.json", "two.json"].map(|scene| {
            let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
            command.args(["run", scene]).current_dir(folder.path()).stdout(std::process::Stdio::null()).spawn().unwrap()
        });
        assert!(both.iter_mut().all(|child| child.wait().unwrap().success()));
        let summary = summary(&out);
        assert_eq!(summary["run"], id_of(&out.join("trajectory.csv")), "files of two runs");
        wins[usize::from(summary["scene"]["title"] == "two")] += 1;
        assert_eq!(entries(&out), ["report.html", "summary.json", "trajectory.csv"]);
    }
    println!("{pairs} pairs: {} ended with the first, {} with the second", wins[0], wins[1]);
}

#[test]
fn a_run_that_fails_leaves_its_rows_and_its_error() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    fs::write(folder.path().join("failing.json"), FAILING).unwrap();
    write_scene(folder.path(), "good", "1.0", "0.004");
    assert!(ancf(folder.path(), &["run", "good.json"]).status.success());

    let error = message(&ancf(folder.path(), &["run", "failing.json"]), 1);
    assert_eq!(entries(&out), ["report.html", "summary.json", "trajectory.partial.csv"]);
    let table = out.join("trajectory.partial.csv");
    let rows: Vec<String> = fs::read_to_string(&table).unwrap().lines().map(String::from).collect();
    let last: f64 = rows.last().unwrap().split(',').next().unwrap().parse().unwrap();
    assert!(rows[0].starts_with("t,tip.x,tip.y,") && rows.len() > 3 && last < 1.0, "{rows:?}");
    let failed = summary(&out);
    assert_eq!(failed["status"], "failed");
    assert_eq!(format!("error: {}\n", failed["error"].as_str().unwrap()), error);
    assert_eq!(
        (failed["last_good_time"].as_f64(), failed["steps"].as_u64()),
        (Some(last), Some(rows.len() as u64 - 2))
    );
    assert_eq!(failed["run"], id_of(&table));

    assert!(ancf(folder.path(), &["run", "good.json"]).status.success());
    assert_eq!(entries(&out), ["report.html", "summary.json", "trajectory.csv"]);
    let good = summary(&out);
    assert_eq!((&good["status"], &good["error"], &good["last_good_time"]), (&"ok".into(), &Value::Null, &Value::Null));
}

/// Two elements cannot bend by 80°; the rows are those of the run itself, all of them.
#[test]
fn a_run_whose_estimate_fails_keeps_its_rows() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let mut scene = Scene::builtin("cantilever").unwrap();
    (scene.rods[0].elements, scene.time.load_steps) = (2, 20);
    (scene.section.height, scene.section.width) = (1e-4, 0.1);
    scene.forces[0].force[1] *= 0.1;
    fs::write(folder.path().join("slender.json"), scene.to_text()).unwrap();
    let error = message(&ancf(folder.path(), &["run", "slender.json", "--estimate"]), 1);
    assert!(error.contains("not even the first digit is sure"), "{error}");
    assert_eq!(fs::read_to_string(out.join("trajectory.partial.csv")).unwrap().lines().count(), 22);
    assert_eq!(summary(&out)["last_good_time"], 1.0);
}

#[test]
fn a_run_replaces_no_file_that_it_reads() {
    let folder = tempfile::tempdir().unwrap();
    write_scene(folder.path(), "summary", "1.0", "0.004");
    let before = fs::read(folder.path().join("summary.json")).unwrap();
    for out in [".", "./", "../."] {
        let out = out.replace("..", &format!("../{}", folder.path().file_name().unwrap().to_str().unwrap()));
        let error = message(&ancf(folder.path(), &["run", "summary.json", "--out", &out]), 2);
        assert!(error.contains("summary.json is read by this command") && error.contains("`--out`"), "{error}");
    }
    write_scene(folder.path(), "error-time", "1.0", "0.004");
    let own = ["error-time", "error-time.json", "--quick", "--out", "."];
    assert!(message(&ancf(folder.path(), &own), 2).contains("error-time.json is read by this command"));
    fs::write(folder.path().join("conformance.md"), "a program").unwrap();
    let program = ["conform", "--out", ".", "--", "python3", "conformance.md"];
    assert!(message(&ancf(folder.path(), &program), 2).contains("conformance.md is read by this command"));
    assert_eq!(fs::read(folder.path().join("summary.json")).unwrap(), before);
    assert_eq!(entries(folder.path()), ["conformance.md", "error-time.json", "summary.json"]);
}

/// A run that would take minutes is refused at once.
#[test]
fn a_folder_that_cannot_be_written_is_found_before_the_run() {
    let folder = tempfile::tempdir().unwrap();
    write_scene(folder.path(), "long", "1.0", "400.0");
    let out = folder.path().join("out");
    for name in ["trajectory.csv", "trajectory.partial.csv", "summary.json", "report.html", "axis.pvd"] {
        fs::create_dir_all(out.join(name)).unwrap();
        let error = message(&ancf(folder.path(), &["run", "long.json"]), 1);
        assert!(error.starts_with(&format!("error: cannot write out/{name}")), "{error}");
        assert_eq!(entries(&out), [name]);
        fs::remove_dir(out.join(name)).unwrap();
    }
    #[cfg(target_os = "linux")]
    for out in ["/proc/self", "/proc/ancf"] {
        let error = message(&ancf(folder.path(), &["run", "long.json", "--out", out]), 1);
        assert!(error.starts_with(&format!("error: cannot write {out}")), "{error}");
    }
    for command in
        [&["error-time", "--out", "long.json"][..], &["stability", "--out", "long.json"], &["--out", "long.json"]]
    {
        let error = message(&ancf(folder.path(), command), 1);
        assert!(error.starts_with("error: cannot write long.json"), "{error}");
    }
}

/// The shell's limit of a file's size, with its signal ignored, fails like a full disk: in the middle of a write.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_the_earlier_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    write_scene(folder.path(), "earlier", "1.0", "0.004");
    write_scene(folder.path(), "later", "1.5", "0.4");
    assert!(ancf(folder.path(), &["run", "earlier.json"]).status.success());
    let before = ["trajectory.csv", "summary.json"].map(|name| fs::read(out.join(name)).unwrap());
    // Blocks of 512 or 1024 bytes: fewer than the table has, and for the last fewer than the first bytes need.
    for limit in ["64", "4", "0"] {
        let line = format!("trap '' XFSZ; ulimit -f {limit}; exec \"$0\" run later.json");
        let binary = env!("CARGO_BIN_EXE_ancf");
        let output = Command::new("sh").args(["-c", &line, binary]).current_dir(folder.path()).output().unwrap();
        let error = message(&output, 1);
        assert!(error.contains("cannot write out"), "{error}");
        assert_eq!(entries(&out), ["report.html", "summary.json", "trajectory.csv"]);
        assert!(before == ["trajectory.csv", "summary.json"].map(|name| fs::read(out.join(name)).unwrap()));
    }
}
