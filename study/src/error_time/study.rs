//! The study of error against run time: its options and results.

use serde::Serialize;

use super::economies::Economy;
use super::group::Group;
use super::machine::Machine;
use super::winner::Winner;

/// Scenes, grid and peer of a study.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Options {
    /// Names of scenes, or files; all scenes of the study if there are none.
    pub scenes: Vec<String>,
    /// Command of another program that is measured in turns with this one.
    pub peer: Option<String>,
    /// A coarse grid, of the flexible pendulum if no scene is named.
    pub quick: bool,
}

/// The content of `error-time.json`.
#[derive(Debug, Serialize)]
pub struct ErrorTimeStudy {
    /// The options.
    pub options: Options,
    /// The machine.
    pub machine: Machine,
    /// Run time of the study, s.
    pub wall_seconds: f64,
    /// A sentence on the other program.
    pub peer: String,
    /// Scenes with their elements.
    pub groups: Vec<Group>,
    /// For each group, its fastest points by decades of error, and the other program's.
    pub winners: Vec<Winner>,
    /// Savings of the plan.
    pub economies: Vec<Economy>,
}
