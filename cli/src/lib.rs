//! What the program `ancf` writes: texts for people, `summary.json`, and the schemas of its files.

mod ends;
pub mod error;
pub mod report;
mod schema;
mod summary;

pub use schema::schemas;
