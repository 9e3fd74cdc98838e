//! Motions of another program: CSV with a header, or JSON in the fixtures' layout.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path as FilePath;

use serde_json::Value;

use super::frames::{Frames, Path};
use crate::error::{Error, Result};

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 28;

const COLUMNS: &str = "a header with `t` and columns of points, such as `tip_x,tip_y`, with or without `tip_vx,tip_vy`, \
                       `kinetic,strain,potential`";
const KEYS: &str = "an object such as {\"t\": [0, …], \"tip\": [[1, 0], …]}, with or without \"tip_velocity\", \"energy\", \
                    \"step\", \"q\", \"M\", \"q_ddot\"";

/// A motion as a program wrote it.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// Name of the file.
    pub file: String,
    /// Samples, in order of time.
    pub frames: Frames,
    /// Step of its method, where the file says so, s.
    pub step: Option<f64>,
    /// Half a unit of the last decimal place that is written, m.
    pub rounding: f64,
    /// Nodal coordinates at t = 0.
    pub nodal: Option<Vec<f64>>,
    /// Mass matrix, row by row.
    pub mass: Option<Vec<Vec<f64>>>,
    /// Accelerations of the nodal coordinates at t = 0.
    pub acceleration: Option<Vec<f64>>,
    /// Time of the first sample that is not a number, from which on the file is ignored.
    pub ends_at: Option<f64>,
    /// Columns or keys that are not known.
    pub ignored: Vec<String>,
}

/// What a column holds.
#[derive(Clone, Debug, PartialEq)]
enum Column {
    Time,
    Position(String, usize),
    Velocity(String, usize),
    Energy(&'static str),
}

/// Reads a file. `points` are the names of the scene's points that move.
///
/// # Errors
/// [`Error::Read`] if it cannot be read, [`Error::Motion`] with file, place, value and what is allowed if it is malformed.
pub fn read(path: &FilePath, points: &[&str]) -> Result<Written> {
    let unreadable = |source| Error::Read { path: path.into(), source };
    let size = fs::metadata(path).map_err(unreadable)?.len();
    let file = path.display().to_string();
    if size > LARGEST {
        let value = format!("it has {size} bytes");
        return Err(Error::Motion { file, place: "size".into(), value, allowed: format!("at most {LARGEST}") });
    }
    let bytes = fs::read(path).map_err(unreadable)?;
    let text = String::from_utf8_lossy(&bytes);
    parse(&text, &file, points)
}

/// Reads the text of a file.
///
/// # Errors
/// [`Error::Motion`].
pub fn parse(text: &str, file: &str, points: &[&str]) -> Result<Written> {
    let text = text.trim_start_matches('\u{feff}');
    let mut written =
        if text.trim_start().starts_with(['{', '[']) { json(text, file, points)? } else { csv(text, file, points)? };
    written.file = file.into();
    check(&mut written, points)?;
    Ok(written)
}

fn fault(file: &str, place: impl Into<String>, value: impl Into<String>, allowed: impl Into<String>) -> Error {
    Error::Motion { file: file.into(), place: place.into(), value: value.into(), allowed: allowed.into() }
}

/// Name without case, quotes and unit.
fn plain(name: &str) -> String {
    let name = name.trim().trim_matches(['"', '\'']).to_lowercase();
    let end = name.find(['[', '(']).unwrap_or(name.len());
    name.get(..end).unwrap_or(&name).trim().to_string()
}

/// Meaning of a column's name; `None` if it has none here.
fn column(name: &str, points: &[&str]) -> Option<Column> {
    let name = plain(name);
    match name.as_str() {
        "t" | "time" | "t_s" | "time_s" | "zeit" => return Some(Column::Time),
        _ => {}
    }
    let parts: Vec<&str> = name.split(['.', '_', ' ', '-', ':', '/']).filter(|part| !part.is_empty()).collect();
    for (energy, words) in [
        ("kinetic", ["kinetic", "kin", "ekin", "t"]),
        ("strain", ["strain", "elastic", "estrain", "u"]),
        ("potential", ["potential", "pot", "epot", "v"]),
        ("input", ["input", "work", "einput", "w"]),
    ] {
        let is_energy = parts.iter().any(|part| words[..3].contains(part));
        let short = matches!(parts[..], [word] | ["energy" | "e", word] if word == words[3] && word != "t" && word != "u" && word != "v");
        if is_energy || short {
            return Some(Column::Energy(energy));
        }
    }
    let component = |word: &str| match word {
        "x" => Some((false, 0)),
        "y" => Some((false, 1)),
        "vx" | "xdot" | "dx" => Some((true, 0)),
        "vy" | "ydot" | "dy" => Some((true, 1)),
        _ => None,
    };
    let mut found = None;
    let mut velocity = false;
    let mut rest = Vec::new();
    for part in &parts {
        match component(part) {
            Some(c) if found.is_none() => found = Some(c),
            _ if matches!(*part, "v" | "vel" | "velocity" | "speed" | "dot") => velocity = true,
            _ if matches!(*part, "pos" | "position" | "r") => {}
            _ => rest.push(*part),
        }
    }
    let named = rest.join("_");
    let lower = |point: &&&str| point.to_lowercase();
    let point = match rest.is_empty() {
        // Columns without a name are those of the only point.
        true if points.len() == 1 => points.first()?.to_string(),
        true => return None,
        false => points
            .iter()
            .find(|point| lower(point) == named)
            .or_else(|| {
                // A point and its component may be written as one word, such as tipx.
                points.iter().find(|point| {
                    parts.len() == 1 && component(named.strip_prefix(&lower(point)).unwrap_or("")).is_some()
                })
            })?
            .to_string(),
    };
    let (of_velocity, n) = match found {
        Some(found) => found,
        None => component(named.strip_prefix(&point.to_lowercase())?)?,
    };
    Some(if of_velocity || velocity { Column::Velocity(point, n) } else { Column::Position(point, n) })
}

/// Decimal places of a number as text.
fn decimals(text: &str) -> i32 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let places = mantissa.split_once('.').map_or(0, |(_, places)| places.len() as i32);
    places - exponent.parse::<i32>().unwrap_or(0)
}

/// Step in a comment such as `# step = 1e-4`.
fn step_of(comment: &str) -> Option<f64> {
    let comment = comment.to_lowercase();
    let at = ["step", "dt"].iter().find_map(|word| Some(comment.find(word)? + word.len()))?;
    let rest = comment.get(at..)?.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '.');
    let end = rest.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | '-' | '+'))).unwrap_or(rest.len());
    rest.get(..end)?.parse().ok().filter(|step: &f64| *step > 0.0)
}

fn csv(text: &str, file: &str, points: &[&str]) -> Result<Written> {
    let mut written = Written { rounding: f64::INFINITY, ..Written::default() };
    let mut lines = text.lines().enumerate().map(|(n, line)| (n + 1, line.trim())).filter(|(_, line)| !line.is_empty());
    let (number, header) = loop {
        match lines.next() {
            Some((_, line)) if line.starts_with(['#', '%']) => {
                written.step = written.step.or(step_of(line));
                // A header may be commented out, as numpy.savetxt does.
                let bare = line.trim_start_matches(['#', '%']).trim();
                if split(bare, delimiter(bare)).first().is_some_and(|name| column(name, points) == Some(Column::Time)) {
                    break (0, bare);
                }
            }
            Some((number, line)) => break (number, line),
            None => return Err(fault(file, "line 1", "there are no lines", COLUMNS)),
        }
    };
    let separator = delimiter(header);
    let names = split(header, separator);
    let headless = names.iter().all(|name| name.replace(',', ".").parse::<f64>().is_ok());
    let mut columns: Vec<Option<Column>> = if headless {
        let [point] = points else {
            return Err(fault(file, format!("line {number}"), "numbers without a header", COLUMNS));
        };
        let all = [
            Column::Time,
            Column::Position(point.to_string(), 0),
            Column::Position(point.to_string(), 1),
            Column::Velocity(point.to_string(), 0),
            Column::Velocity(point.to_string(), 1),
        ];
        if !matches!(names.len(), 3 | 5) {
            let value = format!("{} numbers without a header", names.len());
            return Err(fault(file, format!("line {number}"), value, COLUMNS));
        }
        all.into_iter().take(names.len()).map(Some).collect()
    } else {
        names.iter().map(|name| column(name, points)).collect()
    };
    for n in 0..columns.len() {
        let repeated = columns[n].is_some() && columns[..n].contains(&columns[n]);
        if repeated {
            let place = format!("line {number}, column `{}`", names[n]);
            return Err(fault(file, place, "a second column of this meaning", "one of each"));
        }
    }
    if !columns.contains(&Some(Column::Time)) {
        return Err(fault(file, format!("line {number}"), format!("`{header}` has no column `t`"), COLUMNS));
    }
    written.ignored =
        names.iter().zip(&columns).filter(|(_, column)| column.is_none()).map(|(name, _)| name.to_string()).collect();
    let mut table: Vec<Vec<f64>> = vec![Vec::new(); columns.len()];
    let first = headless.then_some((number, header));
    for (number, line) in first.into_iter().chain(lines) {
        if line.starts_with(['#', '%']) {
            written.step = written.step.or(step_of(line));
            continue;
        }
        let cells = split(line, separator);
        if cells.len() != columns.len() {
            let value = format!("{} columns", cells.len());
            return Err(fault(file, format!("line {number}"), value, format!("{}, as in the header", columns.len())));
        }
        for ((cell, column), (name, list)) in cells.iter().zip(&columns).zip(names.iter().zip(&mut table)) {
            let Some(column) = column else { continue };
            let cell = if separator == Some(',') { cell.to_string() } else { cell.replace(',', ".") };
            let Ok(value) = cell.parse::<f64>() else {
                let place = if headless { format!("line {number}") } else { format!("line {number}, column `{name}`") };
                return Err(fault(file, place, format!("`{cell}`"), "a number"));
            };
            if matches!(column, Column::Position(..)) && value.is_finite() {
                written.rounding = written.rounding.min(0.5 * 10f64.powi(-decimals(&cell)));
            }
            list.push(value);
        }
    }
    let mut halves: BTreeMap<(bool, String), [Option<Vec<f64>>; 2]> = BTreeMap::new();
    for (column, list) in columns.iter_mut().zip(table) {
        match column.take() {
            Some(Column::Time) => written.frames.t = list,
            Some(Column::Position(point, n)) => halves.entry((false, point)).or_default()[n] = Some(list),
            Some(Column::Velocity(point, n)) => halves.entry((true, point)).or_default()[n] = Some(list),
            Some(Column::Energy(name)) => _ = written.frames.energy.insert(name.into(), list),
            None => {}
        }
    }
    for ((is_velocity, point), halves) in halves {
        let [Some(x), Some(y)] = halves else {
            let value = format!("only one component of `{point}`");
            return Err(fault(file, format!("line {number}"), value, "both: x and y"));
        };
        let table = if is_velocity { &mut written.frames.velocity } else { &mut written.frames.position };
        table.insert(point, x.into_iter().zip(y).map(|(x, y)| [x, y]).collect());
    }
    Ok(written)
}

/// What separates the columns of a header; `None` for blanks.
fn delimiter(header: &str) -> Option<char> {
    [';', '\t', ','].into_iter().find(|separator| header.contains(*separator))
}

fn split(line: &str, separator: Option<char>) -> Vec<&str> {
    match separator {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    }
}

fn json(text: &str, file: &str, points: &[&str]) -> Result<Written> {
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

/// Checks lengths, times and names, and leaves out what comes after the first sample that is not a number.
fn check(written: &mut Written, points: &[&str]) -> Result<()> {
    let file = written.file.clone();
    let frames = &mut written.frames;
    let length = frames.t.len();
    let lengths = (frames.position.iter().chain(&frames.velocity).map(|(name, list)| (name, list.len())))
        .chain(frames.energy.iter().map(|(name, list)| (name, list.len())));
    for (name, other) in lengths {
        if other != length {
            return Err(fault(
                &file,
                format!("key `{name}`"),
                format!("{other} entries"),
                format!("{length}, as many as t has"),
            ));
        }
    }
    if frames.position.is_empty() {
        let value = if written.ignored.is_empty() {
            "no positions".into()
        } else {
            format!("not known: {}", written.ignored.join(", "))
        };
        let allowed = format!("positions of {}, as {COLUMNS}; or {KEYS}", points.join(", "));
        return Err(fault(&file, "columns", value, allowed));
    }
    let finite = |n: usize| {
        let pairs = frames.position.values().chain(frames.velocity.values());
        frames.t[n].is_finite()
            && pairs.flat_map(|path| path[n]).all(f64::is_finite)
            && frames.energy.values().all(|list| list[n].is_finite())
    };
    if let Some(end) = (0..length).find(|n| !finite(*n)) {
        written.ends_at = Some(frames.t[end]);
        *frames = frames.picked(&(0..end).collect::<Vec<_>>());
    }
    if frames.t.len() < 2 {
        return Err(fault(&file, "samples", format!("{} of numbers", frames.t.len()), "at least 2"));
    }
    if let Some(n) = (1..frames.t.len()).find(|n| frames.t[*n] <= frames.t[n - 1]) {
        let value = format!("{} after {}", frames.t[n], frames.t[n - 1]);
        return Err(fault(&file, format!("sample {}, `t`", n + 1), value, "times that grow"));
    }
    Ok(())
}
