//! The lines of JSON that a program is asked with, and what it may answer.
//!
//! | line to the program | its answer |
//! |---|---|
//! | `{"hello": {"protocol", "quantities"}}` | `{"hello": {"name", "given"?, "quantities"?}}` |
//! | `{"id", "equation", "state", "given"?}` | `{"id", "value"}` \| `{"id", "not_implemented": true}` \| `{"id", "error"}` |
//!
//! Keys that are null or false are as good as absent; beside an error a value counts for nothing.
//!
//! `equation` is a quantity's name, such as `21.K_1`. A program that takes intermediate values says so with `"given": true`; one that
//! lists `quantities` is asked for these only.

use serde_json::{Map, Value, json};

use super::graph::{GRAPH, find};
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

impl Hello {
    /// Names of `quantities` that nobody asks for.
    pub fn unknown(&self) -> impl Iterator<Item = &str> {
        self.quantities.iter().flatten().map(String::as_str).filter(|id| find(id).is_none())
    }

    /// What a program says of itself; otherwise what is wrong with that.
    fn of(said: &Value) -> Result<Hello, &'static str> {
        let table = said.as_object().ok_or("`hello` has to be an object, such as {\"name\": \"mine\"}")?;
        let named = |key: &str| table.get(key).filter(|value| !value.is_null());
        let name = match named("name") {
            None => "a program without a name".into(),
            Some(name) => name.as_str().ok_or("`name` in `hello` has to be a string")?.to_string(),
        };
        let given = match named("given") {
            None => false,
            Some(given) => given.as_bool().ok_or("`given` in `hello` has to be true or false")?,
        };
        let quantities = match named("quantities") {
            None => None,
            Some(Value::Array(ids)) => {
                Some(ids.iter().map(|id| Some(id.as_str()?.to_string())).collect::<Option<Vec<_>>>())
            }
            Some(_) => Some(None),
        };
        let quantities = match quantities {
            Some(None) => return Err("`quantities` in `hello` has to be a list of names, such as [\"1.r\", \"7.M\"]"),
            Some(listed) => listed,
            None => None,
        };
        Ok(Hello { name, given, quantities })
    }
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
/// [`Fault::Garbage`] for a JSON object that is neither `hello` nor an answer, with what is wrong with it.
pub fn read(line: &str) -> Result<Line, Fault> {
    // Some programs start what they write with a byte order mark.
    let line = line.trim_start_matches('\u{feff}');
    let garbage = |why: &str| Fault::Garbage(format!("{}{why}", quoted(line)));
    let table = match serde_json::from_str::<Value>(line).or_else(|_| serde_json::from_str(&without_nan(line))) {
        Ok(Value::Object(table)) => table,
        _ => return Ok(Line::Chatter(quoted(line))),
    };
    if let Some(hello) = table.get("hello") {
        return Hello::of(hello).map(Line::Hello).map_err(|why| garbage(&format!(": {why}")));
    }
    let id = match table.get("id") {
        Some(Value::String(id)) => id.clone(),
        Some(Value::Number(_)) => {
            return Err(garbage(": the id came back as a number, not as the string that was sent"));
        }
        _ => return Err(garbage("")),
    };
    let told = |key: &str| table.get(key).filter(|value| !matches!(value, Value::Null | Value::Bool(false)));
    let answer = if told("not_implemented").is_some() {
        Answer::NotImplemented
    } else if let Some(error) = told("error") {
        Answer::Error(quoted(error.as_str().unwrap_or(&error.to_string())))
    } else if let Some(value) = table.get("value") {
        Answer::Value(value.clone())
    } else {
        return Err(garbage(""));
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

/// The line with null for NaN and Infinity in all their spellings, which JSON does not have but programs write, and for numbers
/// beyond what f64 has.
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
        } else if c.is_ascii_digit() {
            let mut number = String::from(c);
            while let Some(next) = rest.next_if(|c| c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '+' | '-')) {
                number.push(next);
            }
            if number.parse().is_ok_and(f64::is_infinite) {
                while out.ends_with(['-', '+']) {
                    out.pop();
                }
                number = "null".into();
            }
            out.push_str(&number);
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
    fn a_line_that_is_almost_right_is_told_in_words() {
        for (line, words) in [
            (r#"{"id":7,"value":1}"#, "the id came back as a number"),
            (r#"{"hello":5}"#, "`hello` has to be an object"),
            (r#"{"hello":{"name":5}}"#, "`name` in `hello` has to be a string"),
            (r#"{"hello":{"given":"yes"}}"#, "`given` in `hello` has to be true or false"),
            (r#"{"hello":{"quantities":"1.r"}}"#, "`quantities` in `hello` has to be a list of names"),
            (r#"{"hello":{"quantities":["1.r",3]}}"#, "`quantities` in `hello` has to be a list of names"),
        ] {
            let Err(Fault::Garbage(told)) = read(line) else { panic!("{line}") };
            assert!(told.starts_with(line) && told.contains(words), "{told}");
        }
        let Ok(Line::Hello(hello)) = read(r#"{"hello":{"name":null,"quantities":["7.M","1.R","23.m"]}}"#) else {
            panic!()
        };
        assert_eq!(hello.unknown().collect::<Vec<_>>(), ["1.R", "23.m"]);
    }

    #[test]
    fn keys_that_are_null_or_false_and_a_byte_order_mark_are_passed_over() {
        for (line, answer) in [
            (r#"{"id":"1","value":null,"error":"h is 0","not_implemented":false}"#, Answer::Error("h is 0".into())),
            (r#"{"id":"1","value":null,"error":null,"not_implemented":true}"#, Answer::NotImplemented),
            (r#"{"id":"1","value":2.5,"error":null,"not_implemented":false}"#, Answer::Value(json!(2.5))),
            (r#"{"id":"1","value":null,"error":null}"#, Answer::Value(Value::Null)),
            ("\u{feff}{\"id\":\"1\",\"value\":2.5}", Answer::Value(json!(2.5))),
        ] {
            assert_eq!(read(line), Ok(Line::Answer("1".into(), answer)), "{line}");
        }
        assert!(matches!(read(r#"{"id":"1","not_implemented":false}"#), Err(Fault::Garbage(_))));
    }

    #[test]
    fn nan_and_infinity_are_found_in_every_spelling() {
        for bad in ["NaN", "nan", "-NaN", "Infinity", "-Infinity", "inf", "-inf", "null", "1e999", "-1.5E+400"] {
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
