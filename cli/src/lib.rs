//! What the program `ancf` writes: texts for people, the files and the page of a run, and the schemas of its files.

pub mod compare;
pub mod cost;
mod ends;
pub mod error;
mod frames;
pub mod modes;
pub mod options;
mod output;
mod page;
mod quantity;
pub mod report;
pub mod run;
mod schema;
mod shapes;
pub mod source;
pub mod summary;
mod vtk;

pub use schema::schemas;
