//! `ancf error-time`: the files that it writes, and the input that it refuses.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.filter(|name| name != "peers.csv").collect();
    names.sort();
    names
}

#[test]
fn bad_input_is_exit_code_2_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let cases = [
        (&["error-time", "pendulum"][..], "`SCENE` is `pendulum`; allowed: pendulum-flexible, "),
        (&["error-time", "--references", "pendulum"], "`SCENE` is `pendulum`"),
        (&["error-time", "cantilever", "--peers", "none.csv"], "cannot read none.csv"),
        (&["error-time", "cantilever", "--peers", "bad.csv"], "bad.csv:1: `scene` is missing"),
    ];
    fs::write(path.join("bad.csv"), "a,b\n").unwrap();
    for (arguments, says) in cases {
        let output = ancf(path, arguments);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
        assert!(stderr.contains(says), "{arguments:?}: {stderr}");
    }
    // The table that lies in the output folder is read as well.
    fs::create_dir_all(path.join("out")).unwrap();
    fs::rename(path.join("bad.csv"), path.join("out/peers.csv")).unwrap();
    let output = ancf(path, &["error-time", "cantilever"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(names(&path.join("out")).is_empty());
}

#[test]
fn the_command_writes_its_four_files() {
    let folder = tempfile::tempdir().unwrap();
    let output = ancf(folder.path(), &["error-time", "--quick", "cantilever", "--out", "here"]);
    let (stdout, stderr) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && stderr.is_empty(), "{stderr}");
    for part in [
        "No other program was measured: `python -m oracle.peers --out here",
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
    assert!(html.contains("<svg") && html.contains("Which method for which accuracy") && html.ends_with("</html>\n"));
}
