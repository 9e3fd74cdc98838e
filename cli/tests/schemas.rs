//! Schemas of scenes and summaries: `schema/` is up to date, what the program accepts is valid, and what it refuses by its shape is not.

use std::fs;
use std::path::Path;
use std::process::Command;

use ancf::internals::model::{builtin_names, builtin_text};
use ancf::model::Model;
use ancf_cli::schemas;
use jsonschema::Validator;
use serde_json::{Value, json};

fn validator(file: &str) -> Validator {
    let (_, schema) = schemas().into_iter().find(|(name, _)| *name == file).unwrap();
    jsonschema::draft202012::new(schema.as_value()).unwrap()
}

#[track_caller]
fn assert_valid(validator: &Validator, instance: &Value) {
    let faults: Vec<String> =
        validator.iter_errors(instance).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn the_files_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../schema");
    for (name, schema) in schemas() {
        let written = fs::read_to_string(folder.join(name)).unwrap_or_default();
        let expected = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        assert!(written == expected, "schema/{name} is not up to date: cargo run -p ancf-cli --example write_schemas");
    }
}

#[test]
fn every_property_has_a_description() {
    fn check(schema: &Value, path: &str) {
        for (key, property) in schema["properties"].as_object().into_iter().flatten() {
            assert!(property["description"].is_string(), "{path}.{key} has no description");
        }
        match schema {
            Value::Object(table) => table.iter().for_each(|(key, part)| check(part, &format!("{path}.{key}"))),
            Value::Array(items) => items.iter().for_each(|part| check(part, path)),
            _ => {}
        }
    }
    for (name, schema) in schemas() {
        check(schema.as_value(), name);
    }
}

#[test]
fn built_in_scenes_are_valid() {
    let scenes = validator("scene.schema.json");
    for name in builtin_names() {
        assert_valid(&scenes, &serde_json::from_str(&builtin_text(name).unwrap()).unwrap());
    }
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/simulate.md")).unwrap();
    let text = page.split("```json").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    assert_valid(&scenes, &serde_json::from_str(text).unwrap());
}

/// A schema knows shapes, words and keys; what a value means beside others only the program knows.
#[test]
fn scenes_of_a_wrong_shape_are_not_valid() {
    let scenes = validator("scene.schema.json");
    let good: Value = serde_json::from_str(&builtin_text("pendulum-2d").unwrap()).unwrap();
    for (pointer, value) in [
        ("/schema", json!("ancf-scene/2")),
        ("/material/E", json!("2e8")),
        ("/material", json!([2e8, 0, 2766.67])),
        ("/rods/0/elements", json!(-1)),
        ("/time/method", json!("rk4")),
        ("/time/step", json!(null)),
        ("/points/a", json!([0.0])),
        ("/gravity", json!([0.0, -9.81, 0.0])),
        ("/temperature/model", json!({"2d": null})),
        ("/probes/0/of", json!(["place"])),
        ("/supports/0/fix", json!(["z"])),
        ("/output/interval", json!(null)),
        ("/temperature", json!(null)),
        ("/rods/0", json!({"name": "rod", "from": "a", "to": "o", "pivot": null})),
        ("/probes/0", json!({"name": "tip", "point": "a", "of": ["position"], "at": null})),
    ] {
        let mut scene = good.clone();
        *scene.pointer_mut(pointer).unwrap_or_else(|| panic!("no {pointer}")) = value;
        assert!(!scenes.is_valid(&scene), "{pointer} is valid");
        assert!(Model::parse(&scene.to_string(), "scene").is_err(), "{pointer} is accepted");
    }
    for key in ["material", "section", "points", "rods", "time", "schema"] {
        let mut scene = good.clone();
        scene.as_object_mut().unwrap().remove(key);
        assert!(!scenes.is_valid(&scene), "{key} is not required");
    }
    let mut scene = good;
    scene["gravitation"] = json!([0, -9.81]);
    assert!(!scenes.is_valid(&scene), "unknown keys are valid");
}

#[track_caller]
fn assert_output_is_valid(folder: &Path) {
    for name in ["summary", "shapes"] {
        let text = fs::read_to_string(folder.join(format!("out/{name}.json"))).unwrap();
        assert_valid(&validator(&format!("{name}.schema.json")), &serde_json::from_str(&text).unwrap());
    }
}

#[test]
fn a_summary_and_shapes_are_valid() {
    let folder = tempfile::tempdir().unwrap();
    let scene = r#"{"schema": "ancf-scene/1", "material": {"E": 2e8, "nu": 0, "rho": 2766.67}, "section": {"height": 0.02, "width": 0.02},
        "points": {"a": [0, 0], "b": [1, 0]}, "rods": [{"name": "rod", "from": "a", "to": "b", "elements": 4}],
        "supports": [{"point": "a", "fix": ["x", "y"]}], "gravity": [0, -9.81], "time": {"end": 0.01},
        "output": {"shapes": {"interval": 0.005, "points": 3}}, "probes": [{"name": "tip", "point": "b", "of": ["position"]}]}"#;
    fs::write(folder.path().join("scene.json"), scene).unwrap();
    for options in [&["run", "scene.json"][..], &["run", "scene.json", "--estimate"]] {
        let output =
            Command::new(env!("CARGO_BIN_EXE_ancf")).args(options).current_dir(folder.path()).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        assert_output_is_valid(folder.path());
    }
    // Heat within one step: that of a run which fails.
    let failing = scene.replace("\"gravity\"", "\"temperature\": {\"history\": [[0, 0], [0.001, 1e4]]}, \"gravity\"");
    let failing = failing.replace("2766.67}", "2766.67, \"alpha\": 1e-3}");
    fs::write(folder.path().join("scene.json"), failing).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_ancf"))
        .args(["run", "scene.json"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    assert_output_is_valid(folder.path());
}
