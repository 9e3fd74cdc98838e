//! Almost JSON, as programs write it: read as what is meant, and named.

use std::collections::BTreeSet;
use std::iter::Peekable;
use std::str::Chars;

use serde_json::{Map, Value};

use crate::trouble::Trouble;

/// Objects, and what is not JSON in their text.
type Objects = (Vec<Map<String, Value>>, BTreeSet<Trouble>);

/// Objects of a text, and what is not JSON in it. `None` if there is anything but objects in it.
pub fn objects(text: &str) -> Option<Objects> {
    let mut troubles = BTreeSet::new();
    let mut text = text;
    while let Some(rest) = text.strip_prefix('\u{feff}') {
        text = rest;
        troubles.insert(Trouble::ByteOrderMark);
    }
    if !text.trim_start().starts_with('{') {
        return None;
    }
    let tables = parsed(text).or_else(|| {
        let (tidied, found) = tidied(text);
        troubles.extend(found);
        parsed(&tidied)
    })?;
    if tables.len() > 1 {
        troubles.insert(Trouble::SeveralOnALine);
    }
    Some((tables, troubles))
}

/// Objects of a text of valid JSON.
fn parsed(text: &str) -> Option<Vec<Map<String, Value>>> {
    let values = serde_json::Deserializer::from_str(text).into_iter::<Map<String, Value>>();
    values.collect::<Result<Vec<_>, _>>().ok().filter(|tables| !tables.is_empty())
}

/// Whether a text is the beginning of an object that goes on in the next line.
pub fn is_open(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let (mut depth, mut quote, mut escaped) = (0_usize, None, false);
    for c in text.chars() {
        match quote {
            Some(_) if escaped => escaped = false,
            Some(_) if c == '\\' => escaped = true,
            Some(q) if c == q => quote = None,
            Some(_) => {}
            None if matches!(c, '"' | '\'') => quote = Some(c),
            None if matches!(c, '{' | '[') => depth += 1,
            None if matches!(c, '}' | ']') => depth = depth.saturating_sub(1),
            None => {}
        }
    }
    text.starts_with('{') && depth > 0
}

/// The text as JSON, and what was changed.
fn tidied(text: &str) -> (String, BTreeSet<Trouble>) {
    let (mut out, mut troubles) = (String::with_capacity(text.len()), BTreeSet::new());
    let mut rest = text.chars().peekable();
    while let Some(&c) = rest.peek() {
        match c {
            '"' | '\'' => {
                if c == '\'' {
                    troubles.insert(Trouble::SingleQuotes);
                }
                copy_string(&mut rest, &mut out);
            }
            '0'..='9' | '.' | '+' | '-' => {
                let token = taken(&mut rest, |c| c.is_ascii_alphanumeric() || matches!(c, '.' | '+' | '-' | '#'));
                out += &number(&token, &mut troubles);
                skip_brackets(&token, &mut rest);
            }
            c if c.is_ascii_alphabetic() => {
                let token = taken(&mut rest, |c| c.is_ascii_alphanumeric() || c == '_');
                out += &word(&token, &mut troubles);
                skip_brackets(&token, &mut rest);
            }
            ']' | '}' => {
                let kept = out.trim_end();
                if let Some(before) = kept.strip_suffix(',') {
                    out.truncate(before.len());
                    troubles.insert(Trouble::TrailingComma);
                }
                out.extend(rest.next());
            }
            _ => out.extend(rest.next()),
        }
    }
    (out, troubles)
}

fn taken(rest: &mut Peekable<Chars>, wanted: impl Fn(char) -> bool) -> String {
    let mut token = String::new();
    while let Some(c) = rest.next_if(|c| wanted(*c)) {
        token.push(c);
    }
    token
}

/// Copies a string in either kind of quotes; in double quotes at the end.
fn copy_string(rest: &mut Peekable<Chars>, out: &mut String) {
    let Some(quote) = rest.next() else { return };
    out.push('"');
    while let Some(c) = rest.next() {
        match c {
            '\\' => match rest.next() {
                Some('\'') => out.push('\''),
                Some(next) => out.extend(['\\', next]),
                None => return,
            },
            c if c == quote => break,
            '"' => out.push_str("\\\""),
            c => out.push(c),
        }
    }
    out.push('"');
}

/// A number as JSON: null if it is not finite, and the token itself if it is no number.
fn number(token: &str, troubles: &mut BTreeSet<Trouble>) -> String {
    let unsigned = token.trim_start_matches(['+', '-']);
    // 1.#INF and 1.#QNAN are Microsoft's.
    if is_not_finite(unsigned) || unsigned.contains('#') {
        troubles.insert(Trouble::NotFinite);
        return "null".into();
    }
    let mut found = BTreeSet::new();
    let mut text = token.to_owned();
    if let Some(rest) = text.strip_prefix('+') {
        found.insert(Trouble::PlusSign);
        text = rest.into();
    }
    // Fortran writes D or Q for E, and leaves the letter out before an exponent of three digits.
    let exponent = text.char_indices().skip(1).find(|(_, c)| c.is_ascii_alphabetic() || matches!(c, '+' | '-'));
    let (mantissa, exponent) = match exponent {
        Some((at, c)) if c.is_ascii_alphabetic() => (&text[..at], Some((c, &text[at + 1..]))),
        Some((at, _)) => (&text[..at], Some(('D', &text[at..]))),
        None => (&text[..], None),
    };
    let (sign, digits) = mantissa.strip_prefix('-').map_or(("", mantissa), |digits| ("-", digits));
    if digits.starts_with('.') || digits.ends_with('.') {
        found.insert(Trouble::BareDecimalPoint);
    }
    let zero = |missing: bool| if missing { "0" } else { "" };
    let mut tidied = format!("{sign}{}{digits}{}", zero(digits.starts_with('.')), zero(digits.ends_with('.')));
    if let Some((letter, power)) = exponent {
        if matches!(letter, 'd' | 'D' | 'q' | 'Q') {
            found.insert(Trouble::FortranExponent);
        } else if !matches!(letter, 'e' | 'E') {
            return token.into();
        }
        tidied += &format!("e{power}");
    }
    match tidied.parse::<f64>() {
        Ok(number) if number.is_finite() => {
            troubles.extend(found);
            tidied
        }
        Ok(_) => {
            troubles.insert(Trouble::NotFinite);
            "null".into()
        }
        Err(_) => token.into(),
    }
}

/// A word as JSON.
fn word(token: &str, troubles: &mut BTreeSet<Trouble>) -> String {
    let of_python = match token {
        "True" => "true",
        "False" => "false",
        "None" => "null",
        _ if is_not_finite(token) => {
            troubles.insert(Trouble::NotFinite);
            return "null".into();
        }
        _ => return token.into(),
    };
    troubles.insert(Trouble::PythonWords);
    of_python.into()
}

/// Whether a word says that a number is not finite, in any spelling.
fn is_not_finite(word: &str) -> bool {
    ["nan", "inf", "infinity", "snan", "qnan"].iter().any(|name| word.eq_ignore_ascii_case(name))
}

/// Skips what some C libraries write behind nan, such as (ind).
fn skip_brackets(token: &str, rest: &mut Peekable<Chars>) {
    if is_not_finite(token.trim_start_matches(['+', '-'])) && rest.next_if_eq(&'(').is_some() {
        taken(rest, |c| c != ')');
        rest.next();
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// The value under `v`, and the troubles.
    fn read(text: &str) -> (Value, Vec<Trouble>) {
        let (tables, troubles) = objects(text).unwrap_or_else(|| panic!("{text}"));
        (tables[0]["v"].clone(), troubles.into_iter().collect())
    }

    #[test]
    fn json_has_no_trouble() {
        for text in [r#"{"v":[1,-2.5e-3,"D+1 'a', .5",true,null]}"#, "{\"v\":1}\r\n", "{\n\"v\": [1,\n2]}"] {
            assert_eq!(read(text).1, [], "{text}");
        }
    }

    #[test]
    fn numbers_of_other_languages_have_the_value_that_is_meant() {
        for (text, value, trouble) in [
            ("0.1D+01", 1.0, Trouble::FortranExponent),
            ("-1.25d-2", -0.0125, Trouble::FortranExponent),
            ("0.5-100", 0.5e-100, Trouble::FortranExponent),
            ("1.5+101", 1.5e101, Trouble::FortranExponent),
            (".5", 0.5, Trouble::BareDecimalPoint),
            ("-.5", -0.5, Trouble::BareDecimalPoint),
            ("1.", 1.0, Trouble::BareDecimalPoint),
            ("1.e3", 1000.0, Trouble::BareDecimalPoint),
            ("+1", 1.0, Trouble::PlusSign),
            ("+2.5E+1", 25.0, Trouble::PlusSign),
        ] {
            let (found, troubles) = read(&format!(r#"{{"v": [{text}, 2]}}"#));
            assert_eq!((found[0].as_f64(), troubles), (Some(value), vec![trouble]), "{text}");
        }
        let both = vec![Trouble::FortranExponent, Trouble::BareDecimalPoint, Trouble::PlusSign];
        assert_eq!(read(r#"{"v":[+.1D+01]}"#), (json!([1.0]), both));
    }

    #[test]
    fn every_digit_of_a_fortran_number_is_kept() {
        let (value, _) = read(r#"{"v":0.30000000000000004D+00}"#);
        assert_eq!(value.as_f64(), Some(0.1 + 0.2));
    }

    #[test]
    fn what_is_not_finite_is_null() {
        for bad in [
            "NaN",
            "nan",
            "-NaN",
            "+Inf",
            "Infinity",
            "-Infinity",
            "inf",
            "-inf",
            "1e999",
            "-1.5E+400",
            "-nan(ind)",
            "nan(snan)",
            "1.#INF",
            "-1.#IND",
            "1.#QNAN",
            "1.0D+999",
        ] {
            assert_eq!(
                read(&format!(r#"{{"v":[1,{bad},2]}}"#)),
                (json!([1, null, 2]), vec![Trouble::NotFinite]),
                "{bad}"
            );
        }
    }

    #[test]
    fn quotes_commas_and_words_of_python() {
        let (tables, troubles) = objects("{'id': 'it\\'s \"7\"', 'v': [1, 2,], 'a': True, 'b': None,}").unwrap();
        assert_eq!(Value::Object(tables[0].clone()), json!({"id": "it's \"7\"", "v": [1, 2], "a": true, "b": null}));
        let expected = [Trouble::TrailingComma, Trouble::SingleQuotes, Trouble::PythonWords];
        assert_eq!(troubles.into_iter().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn several_objects_and_a_mark_are_named() {
        let (tables, troubles) = objects("\u{feff}{\"v\":1}{\"v\":2}").unwrap();
        assert_eq!(tables.len(), 2);
        assert_eq!(troubles.into_iter().collect::<Vec<_>>(), [Trouble::SeveralOnALine, Trouble::ByteOrderMark]);
    }

    #[test]
    fn other_text_is_no_object() {
        for text in
            ["", "ready", "[1]", "{", r#"{"v":"#, r#"{"v":1} done"#, "{v: 1}", r#"{"v": 1-2-3}"#, r#"{"v":0x1F}"#]
        {
            assert!(objects(text).is_none(), "{text}");
        }
    }

    #[test]
    fn an_object_is_open_until_its_brackets_are_closed() {
        for (text, open) in [
            ("{", true),
            (r#"{"v": [[1, 2],"#, true),
            (r#"{"v": "}"#, true),
            (r#"{"v": [1]}"#, false),
            ("computing [", false),
            ("", false),
        ] {
            assert_eq!(is_open(text), open, "{text}");
        }
    }
}
