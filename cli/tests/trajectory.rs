//! `ancf conform --trajectory` as a command: exit codes, files, messages.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf_conform::trajectory::reference;
use serde_json::Value;

fn conform(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    command.arg("conform").args(arguments).current_dir(folder).output().unwrap()
}

/// The fixture's own motion with the y axis turned.
fn motion(sign: f64) -> String {
    let reference = reference("flexible-1").unwrap();
    let rows = reference.frames.t.iter().zip(&reference.frames.position["tip"]);
    "t,tip_x,tip_y\n".to_string() + &rows.map(|(t, p)| format!("{t},{},{}\n", p[0], sign * p[1])).collect::<String>()
}

#[test]
fn exit_codes_and_files() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("right.csv"), motion(1.0)).unwrap();
    fs::write(folder.path().join("wrong.csv"), motion(-1.0)).unwrap();
    for (file, code, verdict, words) in
        [("right.csv", 0, "agrees", "agrees, to"), ("wrong.csv", 1, "mistake", "y has the wrong sign")]
    {
        let output = conform(folder.path(), &["--trajectory", file, "--scene", "flexible-1"]);
        let text = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(code), "{text}");
        assert!(text.contains(words), "{text}");
        let report: Value =
            serde_json::from_slice(&fs::read(folder.path().join("out/conformance.json")).unwrap()).unwrap();
        assert_eq!((&report["schema"], &report["verdict"]), (&"ancf-trajectory/1".into(), &verdict.into()));
        assert!(fs::read_to_string(folder.path().join("out/conformance.md")).unwrap().contains(words));
    }
}

#[test]
fn bad_input_has_code_2_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("right.csv"), motion(1.0)).unwrap();
    for (arguments, words) in [
        (&["--trajectory", "right.csv", "--scene", "pendulum"][..], "there is no such motion"),
        (&["--trajectory", "none.csv", "--scene", "flexible-1"], "cannot read none.csv"),
        (&["--trajectory", "right.csv"], "--scene"),
        (&["--trajectory", "right.csv", "--scene", "flexible-1", "--steps", "1e-3,1e-4"], "a step for each file"),
        (&["--trajectory", "right.csv", "right.csv", "--scene", "flexible-1"], "--steps a,b"),
        (&["--trajectory", "right.csv", "--scene", "flexible-1", "--", "true"], "cannot be used with"),
    ] {
        let output = conform(folder.path(), arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && text.contains(words), "{arguments:?}: {text}");
        assert!(!folder.path().join("out/conformance.json").exists());
    }
}
