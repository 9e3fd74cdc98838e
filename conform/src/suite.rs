//! The fixtures as questions: states, reference values and how far an answer may be from them.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeMap;
use std::path::Path;

use nalgebra::{DMatrix, DVector};
use serde::Deserialize;
use serde_json::{Map, Value};

use super::graph::TERMS_OF_23;
use crate::error::{Error, Result};
use ancf::state::{CableState, ElementState, SystemState};

/// The files, in the order of asking; they are part of the program, and a folder of the same names can stand in for them.
const FILES: [(&str, &str); 4] = [
    ("equations.json", ancf_fixtures::EQUATIONS),
    ("structure.json", ancf_fixtures::STRUCTURE),
    ("cable.json", ancf_fixtures::CABLE),
    ("invalid.json", ancf_fixtures::INVALID),
];

/// All questions.
#[derive(Debug)]
pub struct Suite {
    /// Version of the values, by file.
    pub versions: BTreeMap<String, String>,
    /// What is asked for, in the files' order.
    pub quantities: Vec<Quantity>,
    /// States and their values.
    pub cases: Vec<Case>,
    /// States that have to be refused.
    pub invalid: Vec<Invalid>,
}

/// A quantity as the fixtures describe it.
#[derive(Clone, Debug, Deserialize)]
pub struct Quantity {
    /// Its name.
    #[serde(default)]
    pub id: String,
    /// In words.
    pub what: String,
    /// Unit.
    pub unit: String,
    /// Lengths of its nested lists; letters where they differ from case to case. Of a point quantity: at each point.
    pub shape: Vec<Value>,
    /// "point" or "element".
    #[serde(default)]
    pub per: Option<String>,
}

/// One state with its reference values.
#[derive(Debug)]
pub struct Case {
    /// Its name, with the file's in front where two files could have the same.
    pub id: String,
    /// What can be wrong in it.
    pub tags: Vec<String>,
    /// The state as it is sent.
    pub state: Value,
    /// The same to compute with.
    pub parsed: Parsed,
    /// Reference values by quantity.
    pub values: BTreeMap<String, Reference>,
}

/// A state to compute with.
#[derive(Debug)]
pub enum Parsed {
    /// An element's.
    Element(Box<ElementState>),
    /// The terms of (23).
    System(Box<SystemState>),
    /// A cable element's.
    Cable(Box<CableState>),
}

/// A reference value.
#[derive(Clone, Debug)]
pub struct Reference {
    /// As it is stored.
    pub json: Value,
    /// Lengths of its nested lists, points first.
    pub shape: Vec<usize>,
    /// Its numbers, row by row.
    pub numbers: Vec<f64>,
    /// How far an answer may be, entry by entry.
    pub absolute: Vec<f64>,
    /// `absolute` over the size of the terms that are added up.
    pub relative: f64,
}

/// A state that has to be refused.
#[derive(Clone, Debug, Deserialize)]
pub struct Invalid {
    /// Its name.
    pub id: String,
    /// The quantity that is asked for.
    pub equation: String,
    /// The state.
    pub state: Value,
    /// The key that is wrong.
    pub key: String,
    /// Why it has to be refused.
    pub because: String,
}

impl Suite {
    /// The fixtures that this program was built with.
    ///
    /// # Errors
    /// [`Error::Suite`] if they are not what this program expects.
    pub fn embedded() -> Result<Suite> {
        let mut suite = Suite::empty();
        FILES.iter().try_for_each(|(name, text)| suite.add(name, text).map_err(|reason| broken(name, reason)))?;
        Ok(suite)
    }

    /// The fixtures of a folder; of the four files those that are there, `equations.json` at least.
    ///
    /// # Errors
    /// [`Error::Read`] if a file cannot be read, [`Error::Suite`] if it is not what this program expects.
    pub fn load(folder: &Path) -> Result<Suite> {
        let mut suite = Suite::empty();
        for (name, _) in FILES {
            let path = folder.join(name);
            match std::fs::read_to_string(&path) {
                Ok(text) => suite.add(name, &text).map_err(|reason| broken(&path.display().to_string(), reason))?,
                Err(source) if name != "equations.json" && source.kind() == std::io::ErrorKind::NotFound => {}
                Err(source) => return Err(Error::Read { path, source }),
            }
        }
        Ok(suite)
    }

    fn empty() -> Suite {
        Suite { versions: BTreeMap::new(), quantities: Vec::new(), cases: Vec::new(), invalid: Vec::new() }
    }

    /// The description of a quantity.
    pub fn quantity(&self, id: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.id == id)
    }

    fn add(&mut self, name: &str, text: &str) -> std::result::Result<(), String> {
        let json: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let version = json["version"].as_str().ok_or("no `version`")?;
        self.versions.insert(name.into(), version.into());
        if name == "invalid.json" {
            self.invalid = Vec::deserialize(&json["cases"]).map_err(|error| format!("cases: {error}"))?;
            return Ok(());
        }
        for (id, described) in json["quantities"].as_object().ok_or("no `quantities`")? {
            let quantity = Quantity::deserialize(described).map_err(|error| format!("quantities.{id}: {error}"))?;
            self.quantities.push(Quantity { id: id.clone(), ..quantity });
        }
        let cases = json["states"].as_array().or(json["cases"].as_array()).ok_or("no `states` or `cases`")?;
        for case in cases {
            self.cases.push(read_case(name, case)?);
        }
        Ok(())
    }
}

fn broken(file: &str, reason: String) -> Error {
    Error::Suite { file: file.into(), reason }
}

fn read_case(file: &str, case: &Value) -> std::result::Result<Case, String> {
    let id = case["id"].as_str().ok_or("a case without `id`")?;
    let within = |reason: String| format!("{id}: {reason}");
    let mut values = BTreeMap::new();
    for (quantity, stored) in case["values"].as_object().ok_or_else(|| within("no `values`".into()))? {
        let value = read_value(stored).map_err(|reason| within(format!("{quantity}: {reason}")))?;
        values.insert(quantity.clone(), value);
    }
    let tags = Vec::deserialize(&case["tags"]).map_err(|error| within(format!("tags: {error}")))?;
    let (prefix, parsed) = match file {
        "equations.json" => {
            let state = ElementState::deserialize(&case["state"]).map_err(|error| within(format!("state: {error}")))?;
            ("", Parsed::Element(Box::new(state)))
        }
        "structure.json" => ("", system(&case["state"], &values).ok_or_else(|| within("terms of (23)".into()))?),
        _ => {
            let state = CableState::deserialize(&case["state"]).map_err(|error| within(format!("state: {error}")))?;
            ("cable-", Parsed::Cable(Box::new(state)))
        }
    };
    Ok(Case { id: format!("{prefix}{id}"), tags, state: case["state"].clone(), parsed, values })
}

fn read_value(stored: &Value) -> std::result::Result<Reference, String> {
    let json = &stored["f64"];
    let mut numbers = Vec::new();
    let shape = flatten(json, &mut numbers).ok_or("`f64` is no nested list of numbers")?;
    let mut absolute = Vec::new();
    flatten(&stored["absolute"], &mut absolute).ok_or("`absolute` is no nested list of numbers")?;
    if absolute.len() == 1 {
        absolute.resize(numbers.len(), absolute.first().copied().unwrap_or_default());
    }
    let relative = stored["relative"].as_f64().ok_or("no `relative`")?;
    let usable = absolute.len() == numbers.len() && absolute.iter().chain([&relative]).all(|a| *a > 0.0);
    if !usable {
        return Err("`absolute` and `relative` have to be positive, one number or one for each entry".into());
    }
    Ok(Reference { json: json.clone(), shape, numbers, absolute, relative })
}

/// The numbers of nested lists, and the lists' lengths; `None` if they are ragged or hold anything but numbers.
pub fn flatten(value: &Value, numbers: &mut Vec<f64>) -> Option<Vec<usize>> {
    match value {
        Value::Number(number) => {
            numbers.push(number.as_f64()?);
            Some(Vec::new())
        }
        Value::Array(items) => {
            let shapes: Option<Vec<_>> = items.iter().map(|item| flatten(item, numbers)).collect();
            let shapes = shapes?;
            let first = shapes.first().cloned().unwrap_or_default();
            shapes.iter().all(|shape| *shape == first).then(|| [vec![items.len()], first].concat())
        }
        _ => None,
    }
}

fn system(state: &Value, values: &BTreeMap<String, Reference>) -> Option<Parsed> {
    let given = |name: &str| {
        let mut numbers = Vec::new();
        flatten(&state[name], &mut numbers).map(|_| DVector::from_vec(numbers))
    };
    let (q_ddot, lambda) = (given("q_ddot")?, given("lambda")?);
    let [m, kq, f, Phi_q] = TERMS_OF_23 else { return None };
    let matrix = |name: &str| {
        let value = values.get(name)?;
        let [rows, columns] = value.shape[..] else { return None };
        Some(DMatrix::from_row_slice(rows, columns, &value.numbers))
    };
    let vector = |name: &str| Some(DVector::from_vec(values.get(name)?.numbers.clone()));
    let (m, kq, Phi_q, f) = (matrix(m)?, vector(kq)?, matrix(Phi_q)?, vector(f)?);
    Some(Parsed::System(Box::new(SystemState { m, q_ddot, kq, Phi_q, lambda, f })))
}

impl Case {
    /// Reference values of some quantities, to be handed over; `None` if there are none.
    pub fn given<'a>(&self, quantities: impl IntoIterator<Item = &'a str>) -> Option<Value> {
        let stored = |id: &str| self.values.get(id).map(|value| (id.to_string(), value.json.clone()));
        let table: Map<String, Value> = quantities.into_iter().filter_map(stored).collect();
        (!table.is_empty()).then_some(Value::Object(table))
    }

    /// What is handed over with every question of this case.
    pub fn terms(&self) -> &'static [&'static str] {
        if matches!(self.parsed, Parsed::System(_)) { TERMS_OF_23 } else { &[] }
    }
}
