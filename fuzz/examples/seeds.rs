//! Writes what fuzzing starts from into `corpus/`: built-in scenes, the fixtures' states and right answers; and their words into
//! `words.dict`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ancf::internals::model::{builtin_names, builtin_text};
use ancf_conform::Suite;
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    let mut words = BTreeSet::new();
    let mut write = |target: &str, name: &str, text: String| {
        let folder = folder.join(target);
        fs::create_dir_all(&folder)?;
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).for_each(|value| collect(&value, &mut words));
        fs::write(folder.join(name), text)
    };
    for name in builtin_names() {
        // On one line, and with fewer steps and elements than the original: more runs in the same time.
        let mut scene: Value = serde_json::from_str(&builtin_text(name)?)?;
        for rod in scene["rods"].as_array_mut().into_iter().flatten() {
            rod["elements"] = json!(2);
        }
        write("scene", name, scene.to_string())?;
        for method in [
            "generalized-alpha",
            "energy-momentum",
            "explicit",
            "gauss",
            "nystrom",
            "gauss-adaptive",
            "nystrom-adaptive",
        ] {
            scene["time"] = json!({"end": 0.002, "step": 1e-4, "method": method});
            write("scene", &format!("{name}-{method}"), scene.to_string())?;
        }
        scene["time"] = json!({"method": "static", "load_steps": 4});
        write("scene", &format!("{name}-static"), scene.to_string())?;
    }
    let suite = Suite::embedded()?;
    for case in &suite.cases {
        write("state", &case.id, case.state_json.to_string())?;
        let answers = case.values.values().map(|right| json!({"id": case.id, "value": right.json}).to_string() + "\n");
        write("answer", &case.id, answers.take(4).collect())?;
    }
    for invalid in &suite.invalid {
        write("state", &invalid.id, invalid.state.to_string())?;
    }
    let others = [
        r#"{"hello":{"name":"mine","given":true,"quantities":["7.M"]}}"#,
        r#"{"id":"1","not_implemented":true}"#,
        r#"{"id":"1","error":"h is 0"}"#,
        r#"{"id":"1","value":[NaN,-Infinity,1e999,null]}"#,
        "ready",
    ];
    write("answer", "others", others.join("\n"))?;
    let quoted = words.iter().map(|word| format!("\"\\\"{word}\\\"\"\n")).collect::<String>();
    fs::write(folder.join("words.dict"), quoted)?;
    Ok(())
}

/// Adds the keys and words of a value that a dictionary can hold.
fn collect(value: &Value, words: &mut BTreeSet<String>) {
    let mut add = |word: &String| {
        if word.len() < 30 && word.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c)) {
            words.insert(word.clone());
        }
    };
    match value {
        Value::String(word) => add(word),
        Value::Array(items) => items.iter().for_each(|item| collect(item, words)),
        Value::Object(table) => {
            table.keys().for_each(&mut add);
            table.values().for_each(|item| collect(item, words));
        }
        _ => {}
    }
}
