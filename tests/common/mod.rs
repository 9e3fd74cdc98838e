//! The fixture loader, the one tolerance and the table of scales it applies to.

#![allow(non_snake_case)] // The paper's symbols are names here.
#![allow(dead_code)] // Each test binary uses its own part.

use ancf::state::ElementState;
use serde::de::DeserializeOwned;
use serde_json::Value;

pub mod cable;
pub mod column;
pub mod evidence;
pub mod motion;
pub mod pendulum;
pub mod references;
pub mod scale;
pub mod system;

/// Every value of the fixtures is met to this fraction of its scale: 45 roundings of f64.
pub const TOLERANCE: f64 = 1e-14;

/// `fixtures/equations.json`.
pub struct Equations {
    pub json: Value,
}

/// One state of it, or of `fixtures/cable.json`.
pub struct Case<'a, S = ElementState> {
    pub id: &'a str,
    pub state: S,
    values: &'a Value,
}

/// A fixture's content.
pub fn read(file: &str) -> Value {
    let path = format!("{}/fixtures/{file}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// All states of a fixture that has `least` at least.
pub fn cases<S: DeserializeOwned>(json: &Value, least: usize) -> Vec<Case<'_, S>> {
    let states = json["states"].as_array().unwrap();
    assert!(states.len() >= least, "only {} states", states.len());
    states
        .iter()
        .map(|case| Case {
            id: case["id"].as_str().unwrap(),
            state: serde_json::from_value(case["state"].clone()).unwrap(),
            values: &case["values"],
        })
        .collect()
}

impl Equations {
    pub fn load() -> Equations {
        Equations { json: read("equations.json") }
    }

    pub fn cases(&self) -> Vec<Case<'_>> {
        cases(&self.json, 24)
    }

    pub fn case(&self, id: &str) -> Case<'_> {
        self.cases().into_iter().find(|case| case.id == id).unwrap_or_else(|| panic!("no state {id}"))
    }
}

impl<S> Case<'_, S> {
    /// A quantity's numbers (nearest f64), row by row; for a point quantity one point after the other.
    pub fn value(&self, quantity: &str) -> Vec<f64> {
        let value = &self.values[quantity]["f64"];
        assert!(!value.is_null(), "{}: the fixture has no {quantity}", self.id);
        let mut numbers = Vec::new();
        flatten(value, &mut numbers);
        numbers
    }

    pub fn scalar(&self, quantity: &str) -> f64 {
        self.value(quantity)[0]
    }
}

pub fn flatten(value: &Value, numbers: &mut Vec<f64>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| flatten(item, numbers)),
        number => numbers.push(number.as_f64().unwrap()),
    }
}

/// Whether |a − b| ≤ tolerance · scale, entry by entry: never for a NaN, and every scale must be positive and finite.
pub fn within(tolerance: f64, actual: &[f64], expected: &[f64], scale: &[f64]) -> bool {
    assert_eq!((actual.len(), actual.len()), (expected.len(), scale.len()), "numbers of entries differ");
    assert!(scale.iter().all(|s| *s > 0.0 && s.is_finite()), "a scale is not positive: {scale:?}");
    let mut entries = actual.iter().zip(expected).zip(scale);
    entries.all(|((a, b), s)| approx::abs_diff_eq!(a, b, epsilon = tolerance * s))
}

/// The largest |a − b| / scale, for messages; a NaN is infinitely far.
pub fn worst_ratio(actual: &[f64], expected: &[f64], scale: &[f64]) -> f64 {
    let ratio = |((a, b), s): ((&f64, &f64), &f64)| if a.is_nan() { f64::INFINITY } else { (a - b).abs() / s };
    actual.iter().zip(expected).zip(scale).map(ratio).fold(0.0, f64::max)
}
