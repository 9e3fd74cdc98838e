//! `ancf modes`: its table, its files and its exit codes.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf_cli::schemas;
use serde_json::Value;

/// A supported column under half its Euler load.
const COLUMN: &str = r#"{
  "schema": "ancf-scene/1",
  "title": "a {{body}} column <1>",
  "material": {"E": 2e8, "nu": 0, "rho": 7750},
  "section": {"height": 0.02, "width": 0.02},
  "points": {"o": [0, 0], "a": [1, 0]},
  "rods": [{"name": "rod", "from": "o", "to": "a", "elements": 16}],
  "supports": [{"point": "o", "fix": ["x", "y"]}, {"point": "a", "fix": ["y"]}],
  "forces": [{"point": "a", "force": [-13, 0]}],
  "time": {"method": "static"}
}"#;

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).arg("modes").args(arguments).current_dir(folder).output().unwrap()
}

fn stdout(output: Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The table says what the file has, the file has the shape of its schema, the page a picture of each mode and of the buckling; equal
/// inputs give equal bytes.
#[test]
fn modes_are_told_and_written() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("column.json"), COLUMN).unwrap();
    let text = stdout(ancf(folder.path(), &["column.json", "--buckling", "--number", "3", "--out", "first"]));
    for part in ["under all loads", "1        1.03530  vibration", "Buckles at: 2.0222", "2.0218", "first/modes.html"] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
    let read = |file: &str| fs::read_to_string(folder.path().join(file)).unwrap();
    let file: Value = serde_json::from_str(&read("first/modes.json")).unwrap();
    let (_, schema) = schemas().into_iter().find(|(name, _)| *name == "modes.schema.json").unwrap();
    let validator = jsonschema::draft202012::new(schema.as_value()).unwrap();
    let faults: Vec<String> = validator.iter_errors(&file).map(|fault| fault.to_string()).collect();
    assert!(faults.is_empty(), "{faults:?}");
    assert_eq!((&file["about"], file["modes"].as_array().unwrap().len()), (&"loaded".into(), 3));
    let first = file["modes"][0]["shape"][0]["y"].as_array().unwrap();
    let largest = first.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert!((largest - 1.0).abs() < 1e-9 && first.len() == file["rods"][0]["at"].as_array().unwrap().len());
    let page = read("first/modes.html");
    assert_eq!(page.matches("<figure").count(), 4);
    assert!(
        page.contains("a &#123;&#123;body}} column &lt;1&gt;") && !page.contains("NaN") && !page.contains("<script")
    );

    stdout(ancf(folder.path(), &["column.json", "--buckling", "--number", "3", "--out", "second"]));
    for name in ["modes.json", "modes.html"] {
        assert_eq!(read(&format!("first/{name}")), read(&format!("second/{name}")), "{name}");
    }
}

#[test]
fn mechanisms_have_modes_as_built_and_no_equilibrium() {
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(ancf(folder.path(), &["scissors-3"]));
    assert!(text.contains("1              0  mechanism\n       2        2.88266  vibration"), "{text}");
    for (arguments, part) in [
        (&["scissors-3", "--about", "loaded", "--out", "none"][..], "can move without a strain"),
        (&["scissors-3", "--buckling", "--out", "none"], "can move without a strain"),
        (&["scissors-3", "--buckling", "--about", "unloaded", "--out", "none"], "nothing to multiply"),
        (&["scissors-3", "--number", "0", "--out", "none"], "a whole number from 1 to 200"),
        (&["scissors-3", "--about", "hot", "--out", "none"], "unloaded, heated, loaded"),
        (&["no-such-scene", "--out", "none"], "no built-in scene has this name"),
    ] {
        let output = ancf(folder.path(), arguments);
        let told = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert!(told.contains(part), "{arguments:?}: {told}");
        assert!(!folder.path().join("none/modes.json").exists());
    }
}
