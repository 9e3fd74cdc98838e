//! An examination as a Markdown table to read and to paste, and as `conformance.json`.

mod json;
mod markdown;
mod rows;

pub use json::{SCHEMA, json};
pub use markdown::{markdown, summary};
