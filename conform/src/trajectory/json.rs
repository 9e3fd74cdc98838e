//! Motions as JSON in the fixtures' layout.

use serde_json::Value;

use super::column::{Column, column, decimals};
use super::frames::Path;
use super::written::{KEYS, Written, fault};
use crate::error::Result;

/// Reads JSON. `points` are the names of the scene's points.
///
/// # Errors
/// [`Error::Motion`](crate::error::Error::Motion).
pub fn json(text: &str, file: &str, points: &[&str]) -> Result<Written> {
    let json: Value = serde_json::from_str(text).map_err(|error| {
        fault(file, format!("line {}, column {}", error.line(), error.column()), error.to_string(), "JSON")
    })?;
    let Some(object) = json.as_object() else { return Err(fault(file, "the whole", "it is no object", KEYS)) };
    let mut written = Written { rounding: 0.0, ..Written::default() };
    let list = |value: &Value, key: &str| -> Result<Vec<f64>> {
        let numbers = value.as_array().map(|list| list.iter().map(number).collect::<Option<Vec<f64>>>());
        numbers.flatten().ok_or_else(|| fault(file, format!("key `{key}`"), short(value), "a list of numbers"))
    };
    let path = |value: &Value, key: &str| -> Result<Path> {
        let pairs = value.as_array().map(|list| {
            let pair = |pair: &Value| match pair.as_array()?.as_slice() {
                [x, y] => Some([number(x)?, number(y)?]),
                _ => None,
            };
            list.iter().map(pair).collect::<Option<Path>>()
        });
        pairs
            .flatten()
            .ok_or_else(|| fault(file, format!("key `{key}`"), short(value), "a list of pairs [x, y], one for each t"))
    };
    for (key, value) in object {
        let lower = key.to_lowercase();
        let point =
            |name: &str| points.iter().find(|point| point.to_lowercase() == name).map(|point| point.to_string());
        match lower.as_str() {
            "t" | "time" => written.frames.t = list(value, key)?,
            "step" | "dt" => {
                let step = value.as_f64().filter(|step| *step > 0.0);
                written.step = Some(step.ok_or_else(|| fault(file, "key `step`", short(value), "a number over 0, s"))?);
            }
            "q" | "e" | "nodal" => written.nodal = Some(list(value, key)?),
            "q_ddot" | "qddot" | "acceleration" | "initial_acceleration" => {
                written.acceleration = Some(list(value, key)?)
            }
            "m" | "mass" => {
                let rows = value
                    .as_array()
                    .ok_or_else(|| fault(file, format!("key `{key}`"), short(value), "a list of rows"))?;
                written.mass = Some(rows.iter().map(|row| list(row, key)).collect::<Result<_>>()?);
            }
            "position" | "velocity" if value.is_object() => {
                for (name, value) in value.as_object().into_iter().flatten() {
                    let Some(point) = point(&name.to_lowercase()) else {
                        written.ignored.push(format!("{key}.{name}"));
                        continue;
                    };
                    let table =
                        if lower == "position" { &mut written.frames.position } else { &mut written.frames.velocity };
                    table.insert(point, path(value, &format!("{key}.{name}"))?);
                }
            }
            "energy" | "energies" if value.is_object() => {
                for (name, value) in value.as_object().into_iter().flatten() {
                    match column(name, &[]) {
                        Some(Column::Energy(energy)) => {
                            written.frames.energy.insert(energy.into(), list(value, &format!("{key}.{name}"))?);
                        }
                        _ => written.ignored.push(format!("{key}.{name}")),
                    }
                }
            }
            _ => match (point(&lower), lower.strip_suffix("_velocity").and_then(point)) {
                (Some(point), _) => _ = written.frames.position.insert(point, path(value, key)?),
                (_, Some(point)) => _ = written.frames.velocity.insert(point, path(value, key)?),
                _ => match column(key, &[]) {
                    Some(Column::Energy(energy)) => _ = written.frames.energy.insert(energy.into(), list(value, key)?),
                    _ => written.ignored.push(key.clone()),
                },
            },
        }
    }
    if written.frames.t.is_empty() {
        return Err(fault(file, "key `t`", "missing or empty", KEYS));
    }
    let places = written.frames.position.values().flatten().flatten().filter(|x| x.is_finite());
    written.rounding = places.map(|x| 0.5 * 10f64.powi(-decimals(&format!("{x}")))).fold(f64::INFINITY, f64::min);
    Ok(written)
}

/// A number; null, as JSON writes what is none.
fn number(value: &Value) -> Option<f64> {
    if value.is_null() { Some(f64::NAN) } else { value.as_f64() }
}

fn short(value: &Value) -> String {
    let text = value.to_string();
    if text.chars().count() > 60 { format!("{}…", text.chars().take(60).collect::<String>()) } else { text }
}
