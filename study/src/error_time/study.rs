//! The study of error against run time: its options and results.

use std::path::PathBuf;

use serde::Serialize;

use super::economies::Economy;
use super::group::Group;
use super::machine::Machine;
use super::peers::Peer;

/// Scenes, grid and peers of a study.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Options {
    /// Names of scenes; all if there are none.
    pub scenes: Vec<String>,
    /// Runs of another program; `None`: `peers.csv` in the output folder, if it is there.
    pub peers: Option<PathBuf>,
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
    pub peers: String,
    /// The other program's rows: options and samples.
    pub peer_rows: Vec<Peer>,
    /// Scenes with their elements.
    pub groups: Vec<Group>,
    /// Savings of the plan.
    pub economies: Vec<Economy>,
}
