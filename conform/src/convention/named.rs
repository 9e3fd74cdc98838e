//! A convention in the report.

use schemars::JsonSchema;
use serde::Serialize;

/// A convention of the program that differs from that of the fixtures. It is not a mistake.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Convention {
    /// Key of the convention in `hello`, such as `order`.
    pub name: &'static str,
    /// The convention in words.
    pub words: String,
    /// How it is known.
    pub how: How,
    /// What shows it.
    pub evidence: String,
    /// What the answers cannot be told from, in words.
    pub ambiguous_with: Vec<String>,
}

/// How a convention is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum How {
    /// The program says so in `hello`.
    Declared,
    /// Its answers show it.
    Inferred,
}
