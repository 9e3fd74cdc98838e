//! What can go wrong before another program can be judged.

use std::path::PathBuf;

/// Result with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Everything that can go wrong before another program can be judged. All of it is bad input.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file could not be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A state holds something that is not allowed there.
    #[error(transparent)]
    State(#[from] ancf::error::Error),
    /// Fixtures that another program is to be compared with are not what this program expects.
    #[error("the fixtures cannot be used: {file}: {reason}")]
    Suite {
        /// The file.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A program that is to be tested cannot be started.
    #[error("cannot start the command `{command}`: {source}; allowed: a program and its arguments behind `--`")]
    Command {
        /// Its name.
        command: String,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A state that is neither a file nor stored.
    #[error("cannot read {name}: there is no such file, and no stored state of that name{nearest}; stored are {known}")]
    NoState {
        /// What was asked for.
        name: String,
        /// The name that is most like it, in words.
        nearest: String,
        /// The stored names.
        known: String,
    },
}
