//! Where a scene comes from, and the changes that `--set` makes to it.

use std::io::{self, Read};

use ancf::error::Error;
use ancf::internals::model::scene_text;
use ancf::model::Model;
use serde_json::Value;

/// Standard input, as a scene.
const STANDARD_INPUT: &str = "-";

/// Most bytes that are read from standard input, as of a file.
const MOST_BYTES: u64 = 16 << 20;

/// The model of a built-in scene, of a scene file, of the scene in a `summary.json`, or of standard input (`-`), with changes.
///
/// # Errors
/// What cannot be read; a change that has no place in the scene; whatever the scene itself may not be.
pub fn load(name: &str, changes: &[String]) -> Result<Model, Error> {
    if name == STANDARD_INPUT {
        return parse(&standard_input()?, "standard input", changes);
    }
    parse(&scene_text(name)?, name, changes)
}

/// The model of a text, with changes.
///
/// # Errors
/// As of [`load`].
pub fn parse(text: &str, file: &str, changes: &[String]) -> Result<Model, Error> {
    // Some editors put a byte order mark before the text.
    let text = text.trim_start_matches('\u{feff}');
    let repeated = scene_of_summary(text);
    if changes.is_empty() && repeated.is_none() {
        return Model::parse(text, file);
    }
    // A text that is no JSON is told of with its line.
    let value = repeated.map_or_else(|| serde_json::from_str(text), Ok);
    let Ok(mut scene) = value else { return Model::parse(text, file) };
    changes.iter().try_for_each(|change| set(&mut scene, change))?;
    let changed = if changes.is_empty() { file.to_string() } else { format!("{file} with --set") };
    Model::parse(&format!("{scene:#}"), &changed)
}

/// The scene that a run's summary holds; `None` of another text.
fn scene_of_summary(text: &str) -> Option<Value> {
    let Value::Object(mut summary) = serde_json::from_str(text).ok()? else { return None };
    let is_summary = ["run", "status", "scene", "accuracy"].iter().all(|key| summary.contains_key(*key));
    is_summary.then(|| summary.remove("scene")).flatten()
}

fn standard_input() -> Result<String, Error> {
    let refused = |source| Error::Read { path: "standard input".into(), source };
    let mut text = String::new();
    io::stdin().lock().take(MOST_BYTES + 1).read_to_string(&mut text).map_err(refused)?;
    if text.len() as u64 > MOST_BYTES {
        let reason = format!("larger than {MOST_BYTES} bytes; allowed: a scene up to that size");
        return Err(refused(io::Error::new(io::ErrorKind::FileTooLarge, reason)));
    }
    Ok(text)
}

/// Makes one change, `time.step=1e-4`: keys joined by dots, of a list the number or the name of an entry, or `*` for all; then the value
/// as JSON, or a word.
fn set(scene: &mut Value, change: &str) -> Result<(), Error> {
    let Some((key, text)) = change.split_once('=') else {
        return Err(refused(change, "without a value", "KEY=VALUE, such as time.step=1e-4".into()));
    };
    let value = serde_json::from_str(text).unwrap_or_else(|_| Value::String(text.into()));
    let path: Vec<&str> = key.split('.').collect();
    put(scene, &path, &value).map_err(|allowed| refused(key, text, allowed))
}

fn refused(key: &str, value: &str, allowed: String) -> Error {
    Error::Scene { file: "--set".into(), key: key.into(), value: value.into(), allowed }
}

/// Puts a value below `place`; the error is what would be allowed.
fn put(place: &mut Value, path: &[&str], value: &Value) -> Result<(), String> {
    let [part, rest @ ..] = path else {
        *place = value.clone();
        return Ok(());
    };
    match place {
        // Keys of a scene that were left out: the scene's own checks tell what they may hold.
        Value::Object(keys) if rest.is_empty() => {
            keys.insert((*part).into(), value.clone());
            Ok(())
        }
        Value::Object(keys) => put(keys.entry(*part).or_insert_with(|| Value::Object(Default::default())), rest, value),
        Value::Array(entries) if *part == "*" => entries.iter_mut().try_for_each(|entry| put(entry, rest, value)),
        Value::Array(entries) => {
            let allowed = format!("{} (there is no `{part}`)", names(entries));
            put(entry(entries, part).ok_or(allowed)?, rest, value)
        }
        _ => Err(format!("no `{part}` here: what holds it is neither an object nor a list")),
    }
}

/// An entry of a list by its number, from 0, or by its name.
fn entry<'a>(entries: &'a mut [Value], which: &str) -> Option<&'a mut Value> {
    let named = entries.iter().position(|entry| entry["name"] == which);
    entries.get_mut(named.or_else(|| which.parse().ok())?)
}

/// What an entry of a list may be called.
fn names(entries: &[Value]) -> String {
    let names: Vec<&str> = entries.iter().filter_map(|entry| entry["name"].as_str()).collect();
    let numbers = match entries.len() {
        0 => "nothing: the list is empty".into(),
        count => format!("`*`, a number from 0 to {}", count - 1),
    };
    if names.is_empty() { numbers } else { format!("{numbers}, or one of {}", names.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = "pendulum-2d";

    fn changed(changes: &[&str]) -> Result<Model, String> {
        let changes: Vec<String> = changes.iter().map(ToString::to_string).collect();
        load(SCENE, &changes).map_err(|error| error.to_string())
    }

    #[test]
    fn any_key_can_be_set_and_the_rest_stays() {
        let mut expected = Model::load(SCENE).unwrap().into_scene();
        (expected.time.step, expected.rods[0].elements, expected.title) = (1e-5, 16, "mine".into());
        let rod = expected.rods[0].name.clone();
        for path in ["rods.0.elements=16", "rods.*.elements=16", &format!("rods.{rod}.elements=16")] {
            let model = changed(&["time.step=1e-5", path, "title=mine"]).unwrap();
            assert_eq!(model.into_scene(), expected);
        }
        let model =
            changed(&["temperature.history=[[0,10]]", "imperfection.mode=1", "imperfection.amplitude=1e-3"]).unwrap();
        let scene = model.scene();
        assert_eq!(scene.temperature.as_ref().unwrap().history, [[0.0, 10.0]]);
        assert!(scene.imperfection.is_some());
    }

    #[test]
    fn a_change_without_a_place_or_a_sense_is_refused() {
        for (change, words) in [
            ("time.step", "KEY=VALUE"),
            ("time.stepp=1e-4", "with --set"),
            ("time.stepp=1e-4", "`time.stepp` is an unknown key"),
            ("rods.7.elements=4", "a number from 0 to 0"),
            ("time.step.x=4", "neither an object nor a list"),
            ("rods.0.elements=many", "`rods[0].elements` is"),
        ] {
            let error = changed(&[change]).unwrap_err();
            assert!(error.contains(words), "{change}: {error}");
        }
    }

    #[test]
    fn a_summary_is_run_again() {
        let scene = Model::load(SCENE).unwrap();
        let text = serde_json::json!({"run": "0f", "status": "ok", "accuracy": {}, "scene": scene.scene()}).to_string();
        assert_eq!(parse(&text, "summary.json", &[]).unwrap(), scene);
        assert!(parse("{\"scene\": {}}", "no.json", &[]).is_err());
    }
}
