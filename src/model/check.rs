//! Result of a check: the refused key, its value, and what is allowed.

use std::fmt::Display;

use super::json::locate::quote;
use crate::error::Error;

/// Refused value, with the path of its key and what is allowed.
#[derive(Debug)]
pub struct Refusal {
    pub key: String,
    pub value: String,
    pub allowed: String,
}

impl Refusal {
    /// Error with the name of the file and the place in it.
    pub fn into_error(self, file: &str, place: Option<(usize, usize)>) -> Error {
        let file = place.map_or(file.to_string(), |(line, column)| format!("{file}:{line}:{column}"));
        let key = match quote(&self.key) {
            // A key of spaces only.
            key if key.is_empty() => format!("{:?}", self.key),
            key => key,
        };
        Error::Scene { file, key, value: self.value, allowed: self.allowed }
    }
}

/// Outcome of one check.
pub type Check = Result<(), Refusal>;

/// Refuses `value` at `key` unless `holds`.
pub fn require(holds: bool, key: impl Display, value: impl Display, allowed: impl Display) -> Check {
    if holds {
        return Ok(());
    }
    Err(Refusal { key: key.to_string(), value: value.to_string(), allowed: allowed.to_string() })
}

/// Refuses numbers that are not finite.
pub fn finite(key: impl Display, value: f64) -> Check {
    require(value.is_finite(), key, value, "a finite number")
}

/// Refuses numbers that are not positive.
pub fn positive(key: impl Display, value: f64) -> Check {
    require(value.is_finite() && value > 0.0, key, format_args!("{value:?}"), "a finite number over 0")
}
