//! Lines of JSON that are exchanged with the program under test.
//!
//! | line to the program | its answer |
//! |---|---|
//! | `{"hello": {"protocol", "fixtures", "quantities"}}` | `{"hello": {"name", "given"?, "quantities"?, "conventions"?, "fixtures"?}}` |
//! | `{"id", "equation", "state", "given"?}` | `{"id", "value"}` \| `{"id", "not_implemented": true}` \| `{"id", "error"}` |
//!
//! `equation` is the name of a quantity, such as `21.K_1`. A program that accepts intermediate values says so with `"given": true`. A
//! program that lists `quantities` is asked for these only.
//!
//! Keys that are null or false count as absent. An error takes precedence over a value.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::declaration::DeclaredConventions;
use crate::graph::{GRAPH, Node, TERMS_OF_23, equation, find};
use crate::numbers::{Numbers, flatten};
use crate::quotation::quoted;
use crate::spelling;
use crate::suite::{Length, Per, Quantity, Suite};
use crate::verdict::Fault;

/// Name and version of the protocol.
const PROTOCOL: &str = "ancf-conform/1";

/// Beginning of the name of a question that is asked again to see whether its answer stays.
pub const AGAIN: &str = "again/";

/// A line to the program. The first one announces all quantities; each further one asks for a quantity in a state.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(deny_unknown_fields)]
pub enum Question<'a> {
    /// The first line.
    Hello {
        /// What the program will be asked.
        hello: Announcement<'a>,
    },
    /// A question.
    Quantity(Asked<'a>),
}

/// A question: a quantity in a state.
#[derive(Serialize, JsonSchema)]
pub struct Asked<'a> {
    /// Name of the quantity that is asked for, such as 21.K_1.
    pub equation: &'a str,
    /// Reference values of other quantities, by name, each in its SI unit. For (23) those of 23.m, 23.Q_e, 23.f and 23.Phi_q, but where
    /// one of these or 23.Phi is asked for. Otherwise the inputs of a quantity that failed before, if the program accepts them.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    #[schemars(with = "BTreeMap<String, Numbers>")]
    pub given: BTreeMap<&'a str, &'a Value>,
    /// Name of the question; the answer repeats it letter by letter. It is that of the quantity and of the state, such as
    /// 21.K_1/rest-vertical, and more behind them where the same is asked again.
    #[schemars(length(min = 1))]
    pub id: &'a str,
    /// State in SI units: of an element as in equations.json or cable.json, for (23) that of a case in structure.json, with its `scene`
    /// and `rows` where it has them. It may be one of invalid.json.
    #[schemars(with = "Map<String, Value>")]
    pub state: &'a Value,
}

/// What the program will be asked.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Announcement<'a> {
    /// Name and version of the protocol.
    #[schemars(extend("const" = PROTOCOL))]
    protocol: &'static str,
    /// Version of each fixture file, by name.
    fixtures: &'a BTreeMap<String, String>,
    /// Every quantity that can be asked for, by name.
    quantities: BTreeMap<&'a str, Announced<'a>>,
}

/// A quantity that can be asked for.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Announced<'a> {
    /// Names of the quantities whose values may come as `given` with a question for this one. Empty: none ever do.
    from: Vec<&'static str>,
    /// Whether there is a value for each point of the state, or one for the element; null for (23).
    per: Option<Per>,
    /// Lengths of the nested lists of one value, outer first; empty for a number. For (23), n is the number of coordinates and c that of
    /// constraints.
    shape: &'a [Length],
    /// SI unit; where positions and slopes are mixed, the unit of positions, then that of slopes.
    unit: &'a str,
    /// Meaning in words.
    what: &'a str,
}

/// A line from the program: its answer to the first line or to a question.
#[derive(Clone, Debug, PartialEq, JsonSchema)]
#[serde(untagged)]
#[schemars(deny_unknown_fields)]
pub enum AnswerLine {
    /// Answer to the first line.
    Hello {
        /// What the program says about itself.
        hello: Hello,
    },
    /// Answer to a question.
    Answer {
        /// Name of the question.
        #[schemars(length(min = 1))]
        id: String,
        /// Value, refusal or excuse.
        #[serde(flatten)]
        answer: Answer,
    },
    /// A line that is not a JSON object, such as a message for people; its beginning.
    #[schemars(skip)]
    Chatter(String),
}

/// What a program says about itself.
#[derive(Clone, Debug, Default, PartialEq, JsonSchema)]
#[serde(default)]
pub struct Hello {
    /// Name of the program, for the report.
    pub name: Option<String>,
    /// Whether the program accepts intermediate values.
    pub given: bool,
    /// Names of the quantities that the program implements; all if absent or null.
    pub quantities: Option<Vec<String>>,
    /// Conventions in which the program differs from the fixtures. Those that are absent are read off its answers.
    #[schemars(with = "Option<DeclaredConventions>")]
    pub conventions: Map<String, Value>,
    /// Versions of the fixtures, repeated from the first question. Needed by nobody but a program that is asked through files.
    pub fixtures: Option<BTreeMap<String, String>>,
}

/// Answer to a question.
#[derive(Clone, Debug, PartialEq, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Answer {
    /// Value of the quantity in its SI unit: a number or nested lists of its shape, rows first. A quantity of a point is a list with an
    /// entry for each of the state's points.
    #[schemars(with = "Numbers")]
    Value(Value),
    /// True: the program does not implement the quantity, which is not a mistake.
    #[schemars(schema_with = "always_true")]
    NotImplemented,
    /// Why there is no value: the right answer for a state that must be refused, wrong for any other.
    Error(String),
}

impl Answer {
    /// Answer with a number or nested lists of numbers: arrays, slices or vectors of `f64`, rows first.
    pub fn value(value: impl Serialize) -> Answer {
        match serde_json::to_value(value) {
            Ok(value) => Answer::Value(value),
            Err(error) => Answer::Error(format!("the value cannot be written as JSON: {error}")),
        }
    }
}

/// Schema of the value `true`.
fn always_true(_: &mut SchemaGenerator) -> Schema {
    json_schema!({"const": true})
}

impl Hello {
    /// Listed names that are not asked for.
    pub fn unknown(&self) -> impl Iterator<Item = &str> {
        self.quantities.iter().flatten().map(String::as_str).filter(|id| find(id).is_none())
    }

    /// Reads the object under `hello`.
    fn read(hello: &Value) -> Result<Hello, String> {
        fn part<T: DeserializeOwned>(
            hello: &Map<String, Value>,
            key: &str,
            allowed: &str,
        ) -> Result<Option<T>, String> {
            let value = hello.get(key).unwrap_or(&Value::Null);
            Option::deserialize(value).map_err(|_| format!("`{key}` in `hello` must be {allowed}"))
        }
        let hello = hello.as_object().ok_or("`hello` must be an object, such as {\"name\": \"mine\"}")?;
        Ok(Hello {
            name: part(hello, "name", "a string")?,
            given: part(hello, "given", "true or false")?.unwrap_or_default(),
            quantities: part(hello, "quantities", "a list of names, such as [\"1.r\", \"7.M\"]")?,
            conventions: part(hello, "conventions", "an object, such as {\"matrices\": \"columns\"}")?
                .unwrap_or_default(),
            fixtures: part(hello, "fixtures", "the versions of the first question, such as {\"cable.json\": \"1.2\"}")?,
        })
    }
}

/// Returns the first question: the announcement of every quantity.
pub fn announcement(suite: &Suite) -> Question<'_> {
    let announced = |node: &Node| {
        let Quantity { per, shape, unit, what } = suite.quantities.get(node.quantity)?;
        let terms = if equation(node.quantity) == "23" { TERMS_OF_23 } else { &[] };
        let from = terms.iter().chain(node.given).copied().collect();
        Some((node.quantity, Announced { from, per: *per, shape, unit, what }))
    };
    let quantities = GRAPH.iter().filter_map(announced).collect();
    Question::Hello { hello: Announcement { protocol: PROTOCOL, fixtures: &suite.versions, quantities } }
}

impl Question<'_> {
    /// The question as a line of JSON.
    pub fn line(&self) -> String {
        line(self)
    }
}

impl Asked<'_> {
    /// The question as a line of JSON.
    pub fn line(&self) -> String {
        line(self)
    }
}

fn line(question: &impl Serialize) -> String {
    // Maps with text keys can always be written.
    serde_json::to_string(question).unwrap_or_default()
}

/// Reads a line of the program: one hello or answer. `Lines` reads what takes several lines.
///
/// # Errors
/// [`Fault::Garbage`] for a JSON object that is neither `hello` nor an answer, with the reason.
pub fn read(line: &str) -> Result<AnswerLine, Fault> {
    match spelling::objects(line) {
        Some((tables, _)) if tables.len() == 1 => {
            tables.first().map_or_else(|| chatter(line), |table| answer(table, line))
        }
        _ => chatter(line),
    }
}

fn chatter(line: &str) -> Result<AnswerLine, Fault> {
    Ok(AnswerLine::Chatter(quoted(line.trim_start_matches('\u{feff}'))))
}

/// Reads the object of a line.
///
/// # Errors
/// [`Fault::Garbage`] if it is neither `hello` nor an answer, with the reason.
pub fn answer(table: &Map<String, Value>, line: &str) -> Result<AnswerLine, Fault> {
    let garbage = |why: &str| Fault::Garbage(format!("{}{why}", quoted(line.trim_start_matches('\u{feff}'))));
    if let Some(hello) = table.get("hello") {
        return Hello::read(hello).map(|hello| AnswerLine::Hello { hello }).map_err(|why| garbage(&format!(": {why}")));
    }
    let id = match table.get("id") {
        Some(Value::String(id)) => id.clone(),
        Some(Value::Number(_)) => return Err(garbage(": the id must be the string that was sent, not a number")),
        _ => return Err(garbage("")),
    };
    let present = |key: &str| table.get(key).filter(|value| !matches!(value, Value::Null | Value::Bool(false)));
    let answer = if present("not_implemented").is_some() {
        Answer::NotImplemented
    } else if let Some(error) = present("error") {
        Answer::Error(quoted(error.as_str().unwrap_or(&error.to_string())))
    } else if let Some(value) = table.get("value") {
        Answer::Value(value.clone())
    } else {
        return Err(garbage(""));
    };
    Ok(AnswerLine::Answer { id, answer })
}

/// Reads the numbers of a value that must have a shape.
///
/// # Errors
/// [`Fault::NotFinite`] for a null, [`Fault::Shape`] for another shape.
pub fn numbers(value: &Value, shape: &[usize]) -> Result<Vec<f64>, Fault> {
    match nulls(value) {
        0 => {}
        count => return Err(Fault::NotFinite(format!("{count} of its entries"))),
    }
    let mut numbers = Vec::new();
    match flatten(value, &mut numbers) {
        None => Err(Fault::Shape(format!("not nested lists of numbers; expected {}", shape_text(shape)))),
        Some(found) if found != shape => Err(other_shape(&found, shape)),
        Some(_) => Ok(numbers),
    }
}

/// Fault of an answer with another shape than expected.
fn other_shape(found: &[usize], expected: &[usize]) -> Fault {
    let turned: Vec<usize> = expected.iter().rev().copied().collect();
    let hint = if found == turned { ", rows and columns exchanged" } else { "" };
    Fault::Shape(format!("{}{hint}; expected {}", shape_text(found), shape_text(expected)))
}

/// Counts the null entries of nested lists.
fn nulls(value: &Value) -> usize {
    match value {
        Value::Null => 1,
        Value::Array(items) => items.iter().map(nulls).sum(),
        _ => 0,
    }
}

fn shape_text(shape: &[usize]) -> String {
    if shape.is_empty() {
        return "a number".into();
    }
    shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" × ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn line(id: &str, answer: Answer) -> AnswerLine {
        AnswerLine::Answer { id: id.into(), answer }
    }

    #[test]
    fn the_three_answers_and_hello() {
        let of = |line: &str| read(line).unwrap();
        assert_eq!(of(r#"{"id":"7","value":[1.5]}"#), line("7", Answer::Value(json!([1.5]))));
        assert_eq!(of(r#"{"id":"7","not_implemented":true}"#), line("7", Answer::NotImplemented));
        assert_eq!(of(r#"{"id":"7","error":"h is 0"}"#), line("7", Answer::Error("h is 0".into())));
        let quantities = Some(vec!["1.r".into()]);
        let hello = Hello { name: Some("mine".into()), given: true, quantities, ..Hello::default() };
        assert_eq!(of(r#"{"hello":{"name":"mine","given":true,"quantities":["1.r"]}}"#), AnswerLine::Hello { hello });
    }

    #[test]
    fn anything_else_is_garbage_or_chatter() {
        for line in ["{}", r#"{"id":7,"value":1}"#, r#"{"id":"7"}"#] {
            assert!(matches!(read(line), Err(Fault::Garbage(_))), "{line}");
        }
        for line in ["", "ready", "[1]", r#"{"id":"7","value":"#, "{id: 7, value: 1}"] {
            assert_eq!(read(line), Ok(AnswerLine::Chatter(line.into())));
        }
        let long = "x".repeat(1000);
        assert_eq!(read(&long), Ok(AnswerLine::Chatter(format!("{}…", "x".repeat(crate::quotation::LONGEST)))));
    }

    #[test]
    fn a_line_that_is_almost_right_is_explained() {
        for (line, words) in [
            (r#"{"id":7,"value":1}"#, "the id must be the string that was sent"),
            (r#"{"hello":5}"#, "`hello` must be an object"),
            (r#"{"hello":{"name":5}}"#, "`name` in `hello` must be a string"),
            (r#"{"hello":{"given":"yes"}}"#, "`given` in `hello` must be true or false"),
            (r#"{"hello":{"quantities":"1.r"}}"#, "`quantities` in `hello` must be a list of names"),
            (r#"{"hello":{"quantities":["1.r",3]}}"#, "`quantities` in `hello` must be a list of names"),
        ] {
            let Err(Fault::Garbage(message)) = read(line) else { panic!("{line}") };
            assert!(message.starts_with(line) && message.contains(words), "{message}");
        }
        let Ok(AnswerLine::Hello { hello }) = read(r#"{"hello":{"name":null,"quantities":["7.M","1.R","23.M"]}}"#)
        else {
            panic!()
        };
        assert_eq!(hello.unknown().collect::<Vec<_>>(), ["1.R", "23.M"]);
    }

    #[test]
    fn null_and_false_keys_and_a_byte_order_mark_are_ignored() {
        for (text, answer) in [
            (r#"{"id":"1","value":null,"error":"h is 0","not_implemented":false}"#, Answer::Error("h is 0".into())),
            (r#"{"id":"1","value":null,"error":null,"not_implemented":true}"#, Answer::NotImplemented),
            (r#"{"id":"1","value":2.5,"error":null,"not_implemented":false}"#, Answer::Value(json!(2.5))),
            (r#"{"id":"1","value":null,"error":null}"#, Answer::Value(Value::Null)),
            ("\u{feff}{\"id\":\"1\",\"value\":2.5}", Answer::Value(json!(2.5))),
        ] {
            assert_eq!(read(text), Ok(line("1", answer)), "{text}");
        }
        assert!(matches!(read(r#"{"id":"1","not_implemented":false}"#), Err(Fault::Garbage(_))));
    }

    #[test]
    fn nan_and_infinity_are_found_in_every_spelling() {
        for bad in ["NaN", "nan", "-NaN", "Infinity", "-Infinity", "inf", "-inf", "null", "1e999", "-1.5E+400"] {
            let line = format!(r#"{{"id":"1","value":[1e5,{bad},2]}}"#);
            let Ok(AnswerLine::Answer { answer: Answer::Value(value), .. }) = read(&line) else { panic!("{line}") };
            assert_eq!(numbers(&value, &[3]), Err(Fault::NotFinite("1 of its entries".into())), "{line}");
        }
        let text = r#"{"id":"NaN","error":"a \" NaN","x":NaN}"#;
        assert_eq!(read(text).unwrap(), line("NaN", Answer::Error("a \" NaN".into())));
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
        assert!(shape(json!([[1, 2, 3], [4, 5]])).starts_with("not nested lists"));
        assert!(shape(json!("six")).starts_with("not nested lists"));
        assert_eq!(numbers(&json!(2.0), &[]).unwrap(), [2.0]);
        assert!(matches!(numbers(&json!([2.0]), &[]), Err(Fault::Shape(detail)) if detail == "1; expected a number"));
    }
}
