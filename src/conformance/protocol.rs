//! The lines of JSON that a program is asked with, and what it may answer.
//!
//! | line to the program | its answer |
//! |---|---|
//! | `{"hello": {"protocol", "quantities"}}` | `{"hello": {"name", "given"?, "quantities"?}}` |
//! | `{"id", "equation", "state", "given"?}` | `{"id", "value"}` \| `{"id", "not_implemented": true}` \| `{"id", "error"}` |
//!
//! `equation` is a quantity's name, such as `21.K_1`. A program that takes intermediate values says so with `"given": true`; one that
//! lists `quantities` is asked for these only.

use serde_json::{Map, Value, json};

use super::graph::GRAPH;
use super::suite::{Case, Suite, flatten};
use super::verdict::Fault;

/// Name and version of the lines' form.
pub const PROTOCOL: &str = "ancf-conform/1";

/// Longest piece of a line that is shown, in characters.
const LONGEST_QUOTE: usize = 80;

/// What a program says of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hello {
    /// Its name, for the report.
    pub name: String,
    /// Whether it takes the reference's intermediate values.
    pub given: bool,
    /// What it has; everything, if it does not say.
    pub quantities: Option<Vec<String>>,
}

/// The first line to a program.
pub fn hello_line(suite: &Suite) -> String {
    let described = |id: &str| {
        let quantity = suite.quantity(id)?;
        let table = json!({"what": quantity.what, "shape": quantity.shape, "per": quantity.per, "unit": quantity.unit});
        Some((id.to_string(), table))
    };
    let quantities: Map<String, Value> = GRAPH.iter().filter_map(|node| described(node.quantity)).collect();
    json!({"hello": {"protocol": PROTOCOL, "quantities": quantities}}).to_string()
}

/// A question; `given` names the quantities whose reference values are handed over.
pub fn question_line<'a>(id: &str, quantity: &str, case: &Case, given: impl IntoIterator<Item = &'a str>) -> String {
    let mut question = json!({"id": id, "equation": quantity, "state": case.state});
    if let Some(given) = case.given(case.terms().iter().copied().chain(given)) {
        question["given"] = given;
    }
    question.to_string()
}

/// What a line from the program is.
#[derive(Clone, Debug, PartialEq)]
pub enum Line {
    /// Its answer to `hello`.
    Hello(Hello),
    /// Its answer to the question of that id.
    Answer(String, Answer),
    /// No JSON object at all, such as a message for people; how it starts.
    Chatter(String),
}

/// The three answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A value, not looked at yet.
    Value(Value),
    /// The program does not have it.
    NotImplemented,
    /// The program refuses, and says why.
    Error(String),
}

/// Reads a line.
///
/// # Errors
/// [`Fault::Garbage`] for a JSON object that is neither `hello` nor an answer.
pub fn read(line: &str) -> Result<Line, Fault> {
    let garbage = || Fault::Garbage(quoted(line));
    let table = match serde_json::from_str::<Value>(line).or_else(|_| serde_json::from_str(&without_nan(line))) {
        Ok(Value::Object(table)) => table,
        _ => return Ok(Line::Chatter(quoted(line))),
    };
    if let Some(hello) = table.get("hello") {
        let name = hello["name"].as_str().unwrap_or("a program without a name").to_string();
        let given = hello["given"].as_bool().unwrap_or(false);
        let words = |list: &Vec<Value>| list.iter().filter_map(|id| id.as_str().map(str::to_string)).collect();
        return Ok(Line::Hello(Hello { name, given, quantities: hello["quantities"].as_array().map(words) }));
    }
    let id = match table.get("id") {
        Some(Value::String(id)) => id.clone(),
        _ => return Err(garbage()),
    };
    let answer = if let Some(value) = table.get("value") {
        Answer::Value(value.clone())
    } else if table.contains_key("not_implemented") {
        Answer::NotImplemented
    } else if let Some(error) = table.get("error") {
        Answer::Error(quoted(error.as_str().unwrap_or(&error.to_string())))
    } else {
        return Err(garbage());
    };
    Ok(Line::Answer(id, answer))
}

/// The numbers of a value in lists of these lengths.
pub fn numbers(value: &Value, shape: &[usize]) -> Result<Vec<f64>, Fault> {
    if let Some(count) = not_finite(value) {
        return Err(Fault::NotFinite(format!("{count} of its entries")));
    }
    let mut numbers = Vec::new();
    let expected = words(shape);
    match flatten(value, &mut numbers) {
        None => Err(Fault::Shape(format!("no nested lists of numbers; expected {expected}"))),
        Some(found) if found != shape => {
            let turned: Vec<usize> = shape.iter().rev().copied().collect();
            let hint = if found == turned && turned != shape { ", rows and columns exchanged" } else { "" };
            Err(Fault::Shape(format!("{}{hint}; expected {expected}", words(&found))))
        }
        Some(_) => Ok(numbers),
    }
}

/// How many entries are null or no finite number, if any.
fn not_finite(value: &Value) -> Option<usize> {
    let count = match value {
        Value::Null => 1,
        Value::Array(items) => items.iter().filter_map(not_finite).sum(),
        _ => 0,
    };
    (count > 0).then_some(count)
}

/// Lengths in words.
fn words(shape: &[usize]) -> String {
    if shape.is_empty() {
        return "a number".into();
    }
    shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" × ")
}

/// The start of a line, on one line.
pub fn quoted(line: &str) -> String {
    let line: String = line.trim().chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    match line.char_indices().nth(LONGEST_QUOTE) {
        Some((cut, _)) => format!("{}…", line.get(..cut).unwrap_or_default()),
        None => line,
    }
}

/// The line with null for NaN and Infinity in all their spellings, which JSON does not have but programs write.
fn without_nan(line: &str) -> String {
    let mut out = String::with_capacity(line.len());
    let mut rest = line.chars().peekable();
    let (mut in_string, mut before) = (false, ' ');
    while let Some(c) = rest.next() {
        if in_string {
            in_string = c != '"';
            out.push(c);
            if c == '\\' {
                out.extend(rest.next());
            }
        } else if c.is_ascii_alphabetic() && !before.is_ascii_digit() && before != '.' {
            let mut word = String::from(c);
            while let Some(next) = rest.next_if(char::is_ascii_alphabetic) {
                word.push(next);
            }
            if matches!(word.to_ascii_lowercase().as_str(), "nan" | "inf" | "infinity") {
                while out.ends_with(['-', '+']) {
                    out.pop();
                }
                word = "null".into();
            }
            out.push_str(&word);
        } else {
            in_string = c == '"';
            out.push(c);
        }
        before = c;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_three_answers_and_hello() {
        let of = |line: &str| read(line).unwrap();
        assert_eq!(of(r#"{"id":"7","value":[1.5]}"#), Line::Answer("7".into(), Answer::Value(json!([1.5]))));
        assert_eq!(of(r#"{"id":"7","not_implemented":true}"#), Line::Answer("7".into(), Answer::NotImplemented));
        assert_eq!(of(r#"{"id":"7","error":"h is 0"}"#), Line::Answer("7".into(), Answer::Error("h is 0".into())));
        let hello = Hello { name: "mine".into(), given: true, quantities: Some(vec!["1.r".into()]) };
        assert_eq!(of(r#"{"hello":{"name":"mine","given":true,"quantities":["1.r"]}}"#), Line::Hello(hello));
    }

    #[test]
    fn anything_else_is_garbage_or_chatter() {
        for line in ["{}", r#"{"id":7,"value":1}"#, r#"{"id":"7"}"#] {
            assert!(matches!(read(line), Err(Fault::Garbage(_))), "{line}");
        }
        for line in ["", "ready", "[1]", r#"{"id":"7","value":"#, "{'id': '7', 'value': 1}"] {
            assert_eq!(read(line), Ok(Line::Chatter(line.into())));
        }
        let long = "x".repeat(1000);
        assert_eq!(read(&long), Ok(Line::Chatter(format!("{}…", "x".repeat(LONGEST_QUOTE)))));
    }

    #[test]
    fn nan_and_infinity_are_found_in_every_spelling() {
        for bad in ["NaN", "nan", "-NaN", "Infinity", "-Infinity", "inf", "-inf", "null"] {
            let line = format!(r#"{{"id":"1","value":[1e5,{bad},2]}}"#);
            let Ok(Line::Answer(_, Answer::Value(value))) = read(&line) else { panic!("{line}") };
            assert_eq!(numbers(&value, &[3]), Err(Fault::NotFinite("1 of its entries".into())), "{line}");
        }
        let line = r#"{"id":"NaN","error":"a \" NaN","x":NaN}"#;
        assert_eq!(read(line).unwrap(), Line::Answer("NaN".into(), Answer::Error("a \" NaN".into())));
    }

    #[test]
    fn shapes_are_compared_list_by_list() {
        let shape = |value: Value| match numbers(&value, &[2, 3]) {
            Err(Fault::Shape(detail)) => detail,
            other => panic!("{other:?}"),
        };
        assert_eq!(numbers(&json!([[1, 2, 3], [4, 5, 6.5]]), &[2, 3]).unwrap(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.5]);
        assert_eq!(shape(json!([1, 2, 3, 4, 5, 6])), "6; expected 2 × 3");
        assert_eq!(shape(json!([[1, 2], [3, 4], [5, 6]])), "3 × 2, rows and columns exchanged; expected 2 × 3");
        assert!(shape(json!([[1, 2, 3], [4, 5]])).starts_with("no nested lists"));
        assert!(shape(json!("six")).starts_with("no nested lists"));
        assert_eq!(numbers(&json!(2.0), &[]).unwrap(), [2.0]);
        assert!(matches!(numbers(&json!([2.0]), &[]), Err(Fault::Shape(detail)) if detail == "1; expected a number"));
    }
}
