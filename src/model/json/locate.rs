//! Location of a key's value in the text of a scene file, and its spelling there.

use serde::Deserialize;
use serde::de::IgnoredAny;

/// Longest quotation from a file in a message, characters.
const LONGEST_QUOTE: usize = 60;

/// Byte offset at which the value of `key`, such as `rods[0].from`, begins. The text need be valid JSON only up to
/// there.
pub fn start_of(text: &str, key: &str) -> Option<usize> {
    let mut at = skip_space(text, 0);
    let mut path = key;
    while !path.is_empty() {
        if let Some(index) = path.strip_prefix('[') {
            let (index, rest) = index.split_once(']')?;
            at = entry(text, at, index.parse().ok()?)?;
            path = rest;
        } else {
            (at, path) = member(text, at, path.strip_prefix('.').unwrap_or(path))?;
        }
    }
    Some(at)
}

/// Text of the value at byte `at`, as written; up to the next delimiter if it is not JSON, like `NaN`.
pub fn value_at(text: &str, at: usize) -> String {
    let end = read::<IgnoredAny>(text, at).map(|(_, end)| end);
    let tail = text.get(at..).unwrap_or_default();
    let written = match end {
        Some(end) => text.get(at..end).unwrap_or(tail),
        None => tail.split([',', ']', '}', '\n']).next().unwrap_or(tail),
    };
    quote(written)
}

/// `text` on one line, without control characters, shortened if it is long.
pub fn quote(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ").replace(char::is_control, "\u{fffd}");
    match line.char_indices().nth(LONGEST_QUOTE) {
        Some((cut, _)) => format!("{}…", line.get(..cut).unwrap_or_default()),
        None => line,
    }
}

/// Line and column (in characters) of byte `at`, both counted from 1.
pub fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let column = before.get(line_start..).unwrap_or_default().chars().count() + 1;
    (before.matches('\n').count() + 1, column)
}

/// Offset of the value of the first member in `path`, in the object at `at`, and the rest of the path.
fn member<'a>(text: &str, at: usize, path: &'a str) -> Option<(usize, &'a str)> {
    let mut at = punctuation(text, at, '{')?;
    loop {
        let (name, after_name) = read::<String>(text, at)?;
        let value = punctuation(text, after_name, ':')?;
        match path.strip_prefix(name.as_str()) {
            Some(rest) if rest.is_empty() || rest.starts_with(['.', '[']) => return Some((value, rest)),
            _ => at = punctuation(text, read::<IgnoredAny>(text, value)?.1, ',')?,
        }
    }
}

/// Offset of entry `index` of the list at `at`.
fn entry(text: &str, at: usize, index: usize) -> Option<usize> {
    let mut at = punctuation(text, at, '[')?;
    for _ in 0..index {
        at = punctuation(text, read::<IgnoredAny>(text, at)?.1, ',')?;
    }
    Some(at)
}

/// One JSON value at byte `at`, and the offset behind it.
fn read<'a, T: Deserialize<'a>>(text: &'a str, at: usize) -> Option<(T, usize)> {
    let mut values = serde_json::Deserializer::from_str(text.get(at..)?).into_iter::<T>();
    let value = values.next()?.ok()?;
    Some((value, at + values.byte_offset()))
}

/// Offset behind `mark`, which must be the next character at byte `at`.
fn punctuation(text: &str, at: usize, mark: char) -> Option<usize> {
    let at = skip_space(text, at);
    text.get(at..)?.starts_with(mark).then(|| skip_space(text, at + mark.len_utf8()))
}

fn skip_space(text: &str, at: usize) -> usize {
    let rest = text.get(at..).unwrap_or_default();
    at + rest.len() - rest.trim_start_matches([' ', '\t', '\r', '\n']).len()
}
