//! Reads a checked scene from text, and turns serde's errors into the terms of a scene file.

use serde::de::DeserializeOwned;
use serde_json::error::Category;

use super::locate::{line_and_column, start_of, value_at};
use super::missing::check_missing;
use super::shape::Object;
use super::words::Words;
use crate::error::{Error, Result};
use crate::model::check::Refusal;
use crate::model::checks::check;
use crate::model::checks::idle::check_idle;
use crate::model::choice::Schema;
use crate::model::nearest::or_nearest;
use crate::model::scene::Scene;

/// Reads and checks the text of a scene file; `file` is its name in messages.
///
/// # Errors
/// [`Error::Scene`] with place in the file, key, value as written, and what is allowed.
pub fn read_scene(text: &str, file: &str) -> Result<Scene> {
    let scene = read(text).map_err(|(refusal, place)| refusal.into_error(file, Some(place)))?;
    check_missing(&scene, text)
        .and_then(|()| check(&scene))
        .and_then(|()| check_idle(&scene, |key| start_of(text, key).is_some()))
        .map_err(|mut refusal| {
            if let Some(at) = start_of(text, &refusal.key) {
                refusal.value = value_at(text, at);
            }
            let place = position_of(text, &refusal.key);
            refusal.into_error(file, Some(place))
        })?;
    Ok(scene)
}

/// Error of a value in a file other than a scene, with the value as written and its place.
pub fn refuse_in_file(refusal: Refusal, text: &str, file: &str) -> Error {
    let value = start_of(text, &refusal.key).map(|at| value_at(text, at)).filter(|value| !value.starts_with('['));
    let place = position_of(text, &refusal.key);
    Refusal { value: value.unwrap_or_else(|| refusal.value.clone()), ..refusal }.into_error(file, Some(place))
}

/// Reads the JSON of a file other than a scene; `whole` names the file's content in messages.
///
/// # Errors
/// [`Error::Scene`] with place in the file, key, value as written, and what is allowed.
pub fn read_json<T: DeserializeOwned>(text: &str, file: &str, whole: &str) -> Result<T> {
    let refused = |path: &str, error: &serde_json::Error| {
        let (mut refusal, place) = explain(text, path, error);
        if refusal.key == WHOLE_FILE {
            refusal.key = whole.into();
        }
        refusal.into_error(file, Some(place))
    };
    let mut json = serde_json::Deserializer::from_str(text);
    let Object(read) = serde_path_to_error::deserialize(&mut json)
        .map_err(|error| refused(&error.path().to_string(), error.inner()))?;
    json.end().map_err(|error| refused(".", &error))?;
    Ok(read)
}

/// Reads a scene without checking it; a failure has line and column.
fn read(text: &str) -> std::result::Result<Scene, (Refusal, (usize, usize))> {
    // The version is checked first, wherever its key stands: a later version may have keys that are unknown here.
    if let Some(at) = start_of(text, "schema") {
        let written = value_at(text, at);
        if serde_json::from_str::<Schema>(&written).is_err() {
            let allowed = format!("`{}`", Schema::WORDS.join("`, `"));
            return Err((Refusal { key: "schema".into(), value: written, allowed }, line_and_column(text, at)));
        }
    }
    let mut json = serde_json::Deserializer::from_str(text);
    let Object(scene) = serde_path_to_error::deserialize::<_, Object<Scene>>(&mut json)
        .map_err(|error| explain(text, &error.path().to_string(), error.inner()))?;
    json.end().map_err(|error| explain(text, ".", &error))?;
    Ok(scene)
}

/// Line and column of the value of `key`, or of the innermost existing part around it.
fn position_of(text: &str, key: &str) -> (usize, usize) {
    let mut key = key;
    loop {
        if let Some(at) = start_of(text, key) {
            return line_and_column(text, at);
        }
        key = key.rfind(['.', '[']).and_then(|cut| key.get(..cut)).unwrap_or_default();
    }
}

/// Refusal for what serde_json found at `path`, with line and column.
///
/// serde reports key names and expectations only inside its messages, so they are parsed from there. The tests cover
/// every kind of message distinguished here.
fn explain(text: &str, path: &str, error: &serde_json::Error) -> (Refusal, (usize, usize)) {
    let message = error.to_string();
    let reason = message.rsplit_once(" at line ").map_or(message.as_str(), |(reason, _)| reason);
    // "." is the path of the whole file; ".?" at the end marks a key that could not be read.
    let path = path.trim_end_matches('?').trim_end_matches('.');
    let in_path = |name: &str| if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
    let at = start_of(text, path);
    let written = at.map(|at| value_at(text, at)).unwrap_or_default();
    let expected = reason.rsplit_once(", expected ").map_or("", |(_, expected)| expected);
    let known = expected.split('`').skip(1).step_by(2);
    let quoted = |prefix| reason.strip_prefix(prefix).map(|name: &str| name.trim_end_matches('`'));

    let (key, value, allowed) = if let Some(name) = quoted("missing field `") {
        (in_path(name), "missing".into(), "a value here, the key is required".into())
    } else if let Some(name) = quoted("duplicate field `") {
        (in_path(name), "given twice".into(), "each key once".into())
    } else if reason.starts_with("unknown field") {
        let name = path.rsplit('.').next().unwrap_or(path);
        (path.into(), format!("an unknown key (value {written})"), one_of(known, name))
    } else if reason.starts_with("unknown variant") {
        (path.into(), written.clone(), one_of(known, written.trim_matches('"')))
    } else if error.classify() == Category::Data {
        (path.into(), written, plain(expected))
    } else if reason == "trailing characters" && !path.is_empty() {
        (path.into(), written, plain(PAIR))
    } else if error.classify() == Category::Syntax && !path.is_empty() && !written.starts_with(['{', '[']) {
        let allowed = format!("a JSON value; numbers are finite, without NaN or Infinity ({reason})");
        (path.into(), written, allowed)
    } else {
        // At the end of a line serde_json counts from 0.
        let place = (error.line().max(1), error.column().max(1));
        let value = if error.is_eof() { "cut off at the end of the file".into() } else { "not JSON here".into() };
        return (Refusal { key: named_key(path), value, allowed: format!("JSON ({reason})") }, place);
    };
    let place = position_of(text, &key);
    (Refusal { key: named_key(&key), value, allowed }, place)
}

/// Key of an error that concerns the whole scene file.
const WHOLE_FILE: &str = "scene";

/// The key, or the name for the whole file.
fn named_key(key: &str) -> String {
    if key.is_empty() { WHOLE_FILE.into() } else { key.into() }
}

/// Known names, and the one nearest to `name`.
fn one_of<'a>(known: impl Iterator<Item = &'a str> + Clone, name: &str) -> String {
    let all = known.clone().collect::<Vec<_>>().join("`, `");
    format!("`{all}`{}", or_nearest(name, known))
}

/// serde's expectation for a pair of numbers, the only list of fixed length in a scene.
const PAIR: &str = "an array of length 2";

/// serde's expectation without Rust's type names.
fn plain(expected: &str) -> String {
    match expected {
        "f64" => "a number",
        "usize" => "a whole number, not negative",
        "a sequence" => "a list, […]",
        PAIR => "a list of two numbers, [a, b]",
        other => other,
    }
    .into()
}
