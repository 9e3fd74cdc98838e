//! The scene file: reading, writing, and saying where in it something is wrong.

pub mod locate;
pub mod missing;
pub mod parse;
pub mod shape;
mod text;
pub mod words;
