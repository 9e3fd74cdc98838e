//! Writes a scene as readable JSON text.

use crate::model::scene::Scene;

/// Longest line on which a list or an object stays together, bytes.
const LONGEST_LINE: usize = 116;

/// Spaces of indentation per level.
const INDENT: usize = 2;

impl Scene {
    /// The scene as the text of a scene file; lists and objects that fit on a line stay on one.
    pub fn to_text(&self) -> String {
        // A scene holds nothing that JSON cannot represent: its keys are texts, and numbers that are not finite become
        // null.
        let json = serde_json::to_string(self).unwrap_or_default();
        let mut text = String::new();
        write(&json, 0, &mut text);
        text + "\n"
    }
}

/// Writes compact JSON, its first line `indent` from the margin.
fn write(json: &str, indent: usize, text: &mut String) {
    let line = one_line(json);
    let opening = json.chars().next().filter(|first| "{[".contains(*first));
    let (Some(opening), true) = (opening, indent == 0 || indent + line.len() > LONGEST_LINE) else {
        text.push_str(&line);
        return;
    };
    let inner = indent + INDENT;
    text.push(opening);
    for (i, part) in parts(json).into_iter().enumerate() {
        text.push_str(if i == 0 { "\n" } else { ",\n" });
        text.push_str(&" ".repeat(inner));
        let (key, value) = if opening == '{' { member(part) } else { ("", part) };
        if !key.is_empty() {
            text.push_str(key);
            text.push_str(": ");
        }
        write(value, inner, text);
    }
    text.push('\n');
    text.push_str(&" ".repeat(indent));
    text.push(if opening == '{' { '}' } else { ']' });
}

/// Compact JSON with a space behind each comma and colon.
fn one_line(json: &str) -> String {
    let mut line = String::with_capacity(json.len() + json.len() / 4);
    for (c, context) in characters(json) {
        line.push(c);
        if context != Context::Text && (c == ',' || c == ':') {
            line.push(' ');
        }
    }
    line
}

/// Entries of a compact list, or members of a compact object.
fn parts(json: &str) -> Vec<&str> {
    let (mut parts, mut start, mut at) = (Vec::new(), 1, 0);
    for (c, context) in characters(json) {
        if context == Context::Depth(1) && c == ',' {
            parts.extend(json.get(start..at));
            start = at + 1;
        }
        at += c.len_utf8();
    }
    parts.extend(json.get(start..json.len() - 1));
    parts
}

/// Key, with its quotes, and value of a compact member.
fn member(part: &str) -> (&str, &str) {
    let mut at = 0;
    for (c, context) in characters(part) {
        if context != Context::Text && c == ':' {
            break;
        }
        at += c.len_utf8();
    }
    part.split_at_checked(at).map_or(("", part), |(key, value)| (key, value.strip_prefix(':').unwrap_or(value)))
}

/// Context of a character in a JSON text.
#[derive(PartialEq)]
enum Context {
    /// Inside a string.
    Text,
    /// At this depth of nested lists and objects.
    Depth(usize),
}

/// Characters of a JSON text, each with its context.
fn characters(json: &str) -> impl Iterator<Item = (char, Context)> {
    let (mut depth, mut text, mut escaped) = (0_usize, false, false);
    json.chars().map(move |c| {
        match c {
            _ if escaped => escaped = false,
            '\\' if text => escaped = true,
            '"' => text = !text,
            '[' | '{' if !text => depth += 1,
            ']' | '}' if !text => depth = depth.saturating_sub(1),
            _ => {}
        }
        (c, if text { Context::Text } else { Context::Depth(depth) })
    })
}
