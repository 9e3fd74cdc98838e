//! What the program `ancf` writes: texts for people, the files and the page of a run, and the schemas of its files.

mod ends;
pub mod error;
mod frames;
mod output;
mod page;
mod quantity;
pub mod report;
pub mod run;
mod schema;
mod shapes;
mod summary;
mod vtk;

pub use schema::schemas;
