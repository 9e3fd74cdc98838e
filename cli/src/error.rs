//! What can go wrong in a command.

use std::path::PathBuf;

/// Result with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Everything that can go wrong in a command.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A scene or its run.
    #[error(transparent)]
    Run(#[from] ancf::error::Error),
    /// A study, or an output file.
    #[error(transparent)]
    Study(#[from] ancf_study::error::Error),
    /// A run failed, and so did the writing of its rows.
    #[error("{error}; its rows are lost: {unwritten}")]
    Unwritten {
        /// Error of the run.
        error: ancf::error::Error,
        /// Error of its files.
        unwritten: Box<Error>,
    },
    /// Two runs cannot be compared.
    #[error("{} and {} cannot be compared: {reason}; allowed: two runs of the same scene with the same rows", a.display(), b.display())]
    Compare {
        /// Table of a run.
        a: PathBuf,
        /// Table of the other.
        b: PathBuf,
        /// What keeps them apart.
        reason: String,
    },
    /// A run's table cannot be read.
    #[error("cannot read {}: {reason}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// Two runs differ.
    #[error("the runs differ in {columns}, by up to {worst:.1e} of the largest value; allowed: {within:e} (--within)")]
    RunsDiffer {
        /// Columns that differ by more.
        columns: String,
        /// Largest difference.
        worst: f64,
        /// What counts as agreement.
        within: f64,
    },
    /// A program under test could not be judged.
    #[error(transparent)]
    Conform(#[from] ancf_conform::Error),
    /// A program under test is right where it was asked, and was asked only a part.
    #[error(
        "the program is only partly checked: {what}{}; allowed: answers in all cases of what it implements, or `--allow-partial`",
        left_out_text(left_out)
    )]
    PartlyChecked {
        /// What was checked in part.
        what: String,
        /// Tags of which it leaves out every state.
        left_out: Vec<String>,
    },
    /// A program under test is right, and does not refuse all invalid states, as the user demands.
    #[error(
        "the program should refuse {states} more invalid state(s), which conformance.md lists; allowed: an answer with `error` for each, \
         or no `--must-refuse`"
    )]
    NotRefusing {
        /// Number of states that were not refused.
        states: usize,
    },
    /// A motion under test differs from that of the fixtures.
    #[error("the motion does not conform: {summary}")]
    OtherMotion {
        /// The verdict in a sentence.
        summary: String,
    },
    /// A program under test is wrong somewhere.
    #[error("the program does not conform: {summary}")]
    NotConforming {
        /// What it has, and what fails.
        summary: String,
    },
}

impl Error {
    /// Exit code: 1 the run or a comparison failed, 2 bad input, 3 right where asked, but only partly checked.
    pub fn exit_code(&self) -> u8 {
        let is_bad_input = match self {
            Error::Run(error) => error.is_bad_input(),
            Error::Study(error) => error.is_bad_input(),
            Error::Unwritten { error, .. } => error.is_bad_input(),
            Error::Conform(_) | Error::Compare { .. } | Error::Unreadable { .. } => true,
            Error::RunsDiffer { .. }
            | Error::NotConforming { .. }
            | Error::NotRefusing { .. }
            | Error::OtherMotion { .. } => false,
            Error::PartlyChecked { .. } => return 3,
        };
        if is_bad_input { 2 } else { 1 }
    }
}

/// Tags of which every state is left out, as a phrase.
fn left_out_text(tags: &[String]) -> String {
    if tags.is_empty() { String::new() } else { format!("; it leaves out every state tagged {}", tags.join(", ")) }
}
