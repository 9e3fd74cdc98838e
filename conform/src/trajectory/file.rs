//! Motions of another program: CSV with a header, or JSON in the fixtures' layout.

use std::fs;
use std::path::Path;

use super::csv::csv;
use super::json::json;
use super::written::{COLUMNS, KEYS, Written, fault};
use crate::error::{Error, Result};

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 28;

/// Reads a file. `points` are the names of the scene's points that move.
///
/// # Errors
/// [`Error::Read`] if it cannot be read, [`Error::Motion`] with file, place, value and what is allowed if it is malformed.
pub fn read(path: &Path, points: &[&str]) -> Result<Written> {
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
