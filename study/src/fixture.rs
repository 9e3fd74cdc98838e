//! Embedded fixtures, read as types.

use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::error::{Error, Result};

/// The content of an embedded fixture.
pub fn parse<T: DeserializeOwned>(name: &'static str, text: &str) -> Result<T> {
    serde_json::from_str(text).map_err(|reason| Error::fixture(name, reason))
}

/// A certified solution: one entry of `references.json`.
pub struct Certified(Value);

impl Certified {
    /// The entry with this id.
    pub fn load(id: &str) -> Result<Certified> {
        let file: Value = parse("references.json", ancf_fixtures::REFERENCES)?;
        let mut entries = file["entries"].as_array().into_iter().flatten();
        let entry = entries.find(|entry| entry["id"] == id).cloned();
        entry.map(Certified).ok_or_else(|| Error::fixture("references.json", format!("there is no {id}")))
    }

    fn number(&self, value: &Value, key: &str) -> Result<f64> {
        value.as_f64().ok_or_else(|| Error::fixture("references.json", format!("{} has no {key}", self.0["id"])))
    }

    /// A parameter of the problem.
    pub fn parameter(&self, key: &str) -> Result<f64> {
        self.number(&self.0["parameters"][key], key)
    }

    /// The tip's position, m.
    pub fn tip(&self) -> Result<[f64; 2]> {
        let [x, y] = ["tip.x", "tip.y"].map(|key| self.number(&self.0["values"][key]["f64"], key));
        Ok([x?, y?])
    }
}
