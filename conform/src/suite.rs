//! The fixtures as questions: states, reference values and tolerances.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeMap;
use std::path::Path;

use ancf::internals::state::SystemState;
use ancf::state::{CableState, ElementState};
use nalgebra::{DMatrix, DVector};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::error::{Error, Result};
use crate::graph::{TERMS_OF_23, needs_a_scene};
use crate::numbers::flatten;

/// Fixture files in the order of the questions, each with its embedded text. [`Suite::load`] reads the same names from a folder.
const FILES: [(&str, &str); 4] = [
    ("equations.json", ancf_fixtures::EQUATIONS),
    ("structure.json", ancf_fixtures::STRUCTURE),
    ("cable.json", ancf_fixtures::CABLE),
    ("invalid.json", ancf_fixtures::INVALID),
];

/// All states with their reference values, and the states that must be refused.
#[derive(Clone, Debug, Default)]
pub struct Suite {
    /// Version of each fixture file, by name.
    pub versions: BTreeMap<String, String>,
    /// Description of each quantity, by name.
    pub quantities: BTreeMap<String, Quantity>,
    /// States with reference values, in the order of the questions.
    pub cases: Vec<Case>,
    /// States that must be refused.
    pub invalid: Vec<InvalidCase>,
}

/// Description of a quantity.
#[derive(Clone, Debug, Deserialize)]
pub struct Quantity {
    /// Whether there is a value for each point of the state, or one for the element; null for (23).
    pub per: Option<Per>,
    /// Lengths of the nested lists of one value, outer first; empty for a number. For (23), n is the number of coordinates and c that of
    /// constraints.
    pub shape: Vec<Length>,
    /// SI unit; where positions and slopes are mixed, the unit of positions, then that of slopes.
    pub unit: String,
    /// Meaning in words.
    pub what: String,
}

/// What a value belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Per {
    /// A point: the answer is a list with an entry for each of the state's points.
    Point,
    /// The element: the answer is one value.
    Element,
}

/// Length of a list.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Length {
    /// Equal in all cases.
    Fixed(usize),
    /// A letter for a length that depends on the case.
    Letter(String),
}

/// A state with its reference values.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name; those of `cable.json` begin with `cable-`.
    pub id: String,
    /// What the case can reveal, such as `rotated` or `heated`.
    pub tags: Vec<String>,
    /// The state as it is sent to the program; that of a structure with its scene, and the rows of Φ in words.
    pub state_json: Value,
    /// The state to compute with.
    pub state: State,
    /// Reference values by quantity, of those that can be asked for in this case.
    pub values: BTreeMap<String, Reference>,
    /// Assembled terms of (23), which are sent with questions about the others; empty for an element.
    pub terms: BTreeMap<&'static str, Value>,
}

/// A state to compute with.
#[derive(Clone, Debug)]
pub enum State {
    /// State of an ANCF element.
    Element(Box<ElementState>),
    /// Terms of (23) for a structure.
    System(Box<SystemState>),
    /// State of an Euler–Bernoulli element.
    Cable(Box<CableState>),
}

/// A reference value with its tolerances.
#[derive(Clone, Debug)]
pub struct Reference {
    /// The value as nested lists.
    pub json: Value,
    /// Whether the outermost list has an entry for each point of the state.
    pub per_point: bool,
    /// Lengths of the nested lists, points first.
    pub shape: Vec<usize>,
    /// Entries, row by row.
    pub numbers: Vec<f64>,
    /// Absolute tolerance of each entry.
    pub absolute: Vec<f64>,
    /// `absolute` divided by the size of the terms that are added up.
    pub relative: f64,
    /// Wider tolerances, of a program below double precision; `None` for those of the fixtures.
    pub attainable: Option<Tolerance>,
}

/// Tolerances of a reference value at the precision of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Absolute tolerance of each entry.
    pub absolute: Vec<f64>,
    /// Rounding of a term, relative to the term.
    pub relative: f64,
}

/// A state that must be refused.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
pub struct InvalidCase {
    /// Name of the case in invalid.json.
    pub id: String,
    /// Name of the quantity to ask for.
    pub equation: String,
    /// The state as it is sent to the program.
    #[serde(skip_serializing)]
    pub state: Value,
    /// Invalid key of the state.
    pub key: String,
    /// Why the state is invalid.
    #[serde(skip_serializing)]
    pub because: String,
}

impl Suite {
    /// Reads the fixtures that are embedded in this crate.
    ///
    /// # Errors
    /// [`Error::Suite`] if a file is malformed.
    pub fn embedded() -> Result<Suite> {
        let mut suite = Suite::default();
        FILES.iter().try_for_each(|(name, text)| suite.add(name, text).map_err(|reason| malformed(name, reason)))?;
        Ok(suite)
    }

    /// Reads the fixtures of a folder. `equations.json` is required, the other files are optional.
    ///
    /// # Errors
    /// [`Error::Read`] if a file cannot be read, [`Error::Suite`] if it is malformed.
    pub fn load(folder: &Path) -> Result<Suite> {
        let mut suite = Suite::default();
        for (name, _) in FILES {
            let path = folder.join(name);
            match std::fs::read_to_string(&path) {
                Ok(text) => {
                    suite.add(name, &text).map_err(|reason| malformed(&path.display().to_string(), reason))?;
                }
                Err(source) if name != "equations.json" && source.kind() == std::io::ErrorKind::NotFound => {}
                Err(source) => return Err(Error::Read { path, source }),
            }
        }
        Ok(suite)
    }

    fn add(&mut self, name: &str, text: &str) -> Result<(), String> {
        let mut json: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        self.versions.insert(name.into(), read(&json["version"], "version")?);
        // Files before structure.json 1.2 and invalid.json 1.2 have `cases` alone.
        let list = if json["states"].is_null() { "cases" } else { "states" };
        if name == "invalid.json" {
            self.invalid = read(&json[list], list)?;
            return Ok(());
        }
        self.quantities.extend(read::<BTreeMap<String, Quantity>>(&json["quantities"], "quantities")?);
        let Value::Array(cases) = json[list].take() else { return Err("no list `states`".into()) };
        for case in &cases {
            let id: String = read(&case["id"], "id of a case")?;
            self.cases.push(self.read_case(name, case).map_err(|reason| format!("{id}: {reason}"))?);
        }
        Ok(())
    }

    fn read_case(&self, file: &str, case: &Value) -> Result<Case, String> {
        let stored: BTreeMap<String, Value> = read(&case["values"], "values")?;
        let mut values = BTreeMap::new();
        for (id, stored) in stored {
            let per_point = self.quantities.get(&id).is_some_and(|quantity| quantity.per == Some(Per::Point));
            let value = Reference::read(&stored, per_point).map_err(|reason| format!("{id}: {reason}"))?;
            values.insert(id, value);
        }
        let state = match file {
            "equations.json" => State::Element(read(&case["state"], "state")?),
            "cable.json" => State::Cable(read(&case["state"], "state")?),
            _ => State::System(Box::new(system(&case["state"], &values).ok_or("state: not the terms of (23)")?)),
        };
        let mut state_json = case["state"].clone();
        let mut terms = BTreeMap::new();
        if let State::System(_) = state {
            terms = TERMS_OF_23.iter().filter_map(|id| Some((*id, values.get(*id)?.json.clone()))).collect();
            if case["scene"].is_null() {
                // Terms without a scene are data: nothing is known that they could be computed from.
                values.retain(|id, _| !needs_a_scene(id));
            } else {
                state_json["scene"] = case["scene"].clone();
                state_json["rows"] = case["rows"].clone();
            }
        }
        let prefix = if file == "cable.json" { "cable-" } else { "" };
        let id = format!("{prefix}{}", read::<String>(&case["id"], "id")?);
        Ok(Case { id, tags: read(&case["tags"], "tags")?, state_json, state, values, terms })
    }
}

fn malformed(file: &str, reason: String) -> Error {
    Error::Suite { file: file.into(), reason }
}

/// Reads a part of a fixture; the error names the part.
fn read<T: DeserializeOwned>(json: &Value, part: &str) -> Result<T, String> {
    T::deserialize(json).map_err(|error| format!("{part}: {error}"))
}

/// The terms of (23): accelerations and multipliers of the state, the others from the values that come with every question.
fn system(state: &Value, values: &BTreeMap<String, Reference>) -> Option<SystemState> {
    let own = |name: &str| {
        let mut numbers = Vec::new();
        flatten(&state[name], &mut numbers).map(|_| DVector::from_vec(numbers))
    };
    let [m, kq, f, Phi_q] = TERMS_OF_23 else { return None };
    let matrix = |name: &str| {
        let value = values.get(name)?;
        let [rows, columns] = value.shape[..] else { return None };
        Some(DMatrix::from_row_slice(rows, columns, &value.numbers))
    };
    let vector = |name: &str| Some(DVector::from_vec(values.get(name)?.numbers.clone()));
    Some(SystemState {
        m: matrix(m)?,
        q_ddot: own("q_ddot")?,
        kq: vector(kq)?,
        Phi_q: matrix(Phi_q)?,
        lambda: own("lambda")?,
        f: vector(f)?,
    })
}

impl Case {
    /// Reference values that are sent with a question about `quantity`: those of `inputs`, and for (23) the assembled terms, unless
    /// it is one of them.
    pub(crate) fn given<'a>(&'a self, quantity: &str, inputs: &[&'a str]) -> BTreeMap<&'a str, &'a Value> {
        let terms = self.terms.iter().filter(|_| !needs_a_scene(quantity)).map(|(id, value)| (*id, value));
        let stored = |id: &&'a str| self.values.get(*id).map(|value| (*id, &value.json));
        terms.chain(inputs.iter().filter_map(stored)).collect()
    }
}

impl Reference {
    fn read(stored: &Value, per_point: bool) -> Result<Reference, String> {
        let json = stored["f64"].clone();
        let (mut numbers, mut absolute) = (Vec::new(), Vec::new());
        let shape = flatten(&json, &mut numbers).ok_or("`f64` is no nested list of numbers")?;
        flatten(&stored["absolute"], &mut absolute).ok_or("`absolute` is no nested list of numbers")?;
        if let [all] = absolute[..] {
            absolute.resize(numbers.len(), all);
        }
        let relative = read(&stored["relative"], "relative")?;
        if absolute.len() != numbers.len() || !absolute.iter().chain([&relative]).all(|a| *a > 0.0) {
            return Err(
                "`absolute` and `relative` must be positive, `absolute` one number or one for each entry".into()
            );
        }
        Ok(Reference { json, per_point, shape, numbers, absolute, relative, attainable: None })
    }

    /// Shape of the value at one point, or of the whole value of an element.
    pub(crate) fn shape_at_a_point(&self) -> &[usize] {
        if self.per_point { self.shape.get(1..).unwrap_or_default() } else { &self.shape }
    }

    /// Absolute tolerances at the precision of the program.
    pub(crate) fn tolerances(&self) -> &[f64] {
        self.attainable.as_ref().map_or(&self.absolute, |attainable| &attainable.absolute)
    }

    /// Size of the terms that are added up for an entry.
    pub(crate) fn terms(&self) -> impl Iterator<Item = f64> {
        self.absolute.iter().map(|bound| bound / self.relative)
    }

    /// Entry with the largest error, and that error in tolerances. A NaN is the largest error of all.
    pub(crate) fn worst_entry(&self, answer: &[f64]) -> (usize, f64) {
        let entries = answer.iter().zip(&self.numbers).zip(self.tolerances()).enumerate();
        entries
            .map(|(n, ((a, b), bound))| (n, (a - b).abs() / bound))
            .fold((0, 0.0), |worst, next| if next.1 > worst.1 || next.1.is_nan() { next } else { worst })
    }

    /// Largest error of an entry relative to its terms.
    pub(crate) fn error(&self, answer: &[f64]) -> f64 {
        let entries = answer.iter().zip(&self.numbers).zip(self.terms());
        entries
            .map(|((a, b), terms)| (a - b).abs() / terms)
            .fold(0.0, |worst: f64, next| if next.is_nan() { f64::INFINITY } else { worst.max(next) })
    }

    /// Correct digits of the worst entry, as many as there are: infinite where every entry is exact.
    pub(crate) fn digits(&self, answer: &[f64]) -> f64 {
        -self.error(answer).log10()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::graph::GRAPH;

    #[test]
    fn every_quantity_is_asked_for_except_printed_forms() {
        let suite = Suite::embedded().unwrap();
        let asked: BTreeSet<&str> = GRAPH.iter().map(|node| node.quantity).collect();
        let stored = suite.quantities.keys().map(String::as_str);
        assert_eq!(asked, stored.filter(|id| !id.contains("/printed")).collect());
        let of_a_case: BTreeSet<&str> =
            suite.cases.iter().flat_map(|case| case.values.keys()).map(String::as_str).collect();
        assert!(asked.is_subset(&of_a_case), "no case has {:?}", asked.difference(&of_a_case));
    }

    #[test]
    fn terms_of_23_are_asked_for_with_the_scene_and_sent_with_the_others() {
        let suite = Suite::embedded().unwrap();
        let systems: Vec<&Case> = suite.cases.iter().filter(|case| matches!(case.state, State::System(_))).collect();
        assert_eq!(systems.len(), 5);
        for case in systems {
            let asked = ["23.m", "23.Q_e", "23.f", "23.Phi", "23.Phi_q"].map(|id| case.values.contains_key(id));
            // `square` has no scene: its terms are data.
            assert_eq!(asked, [case.id != "square"; 5], "{}", case.id);
            let state = &case.state_json;
            assert_eq!([&state["scene"], &state["rows"], &state["t"]].map(Value::is_null), [case.id == "square"; 3]);
            assert_eq!(case.given("23.residual", &["23.constraint_force"]).len(), 5);
            assert!(case.given("23.m", &[]).is_empty());
        }
    }
}
