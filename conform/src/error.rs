//! Input errors of the kit.

use std::path::PathBuf;

/// Result, with this crate's [`Error`] unless another is named.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Error that prevents an examination or a listing. All of them are bad input.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file cannot be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// Path of the file.
        path: PathBuf,
        /// Reason that the system gives.
        source: std::io::Error,
    },
    /// A state is invalid.
    #[error(transparent)]
    State(#[from] ancf::error::Error),
    /// A fixture file is malformed.
    #[error("the fixtures cannot be used: {file}: {reason}")]
    Suite {
        /// Name of the file.
        file: String,
        /// Its first fault.
        reason: String,
    },
    /// The program under test cannot be started.
    #[error("cannot start the command `{command}`: {source}; allowed: a program and its arguments after `--`")]
    Command {
        /// Name of the program.
        command: String,
        /// Reason that the system gives.
        source: std::io::Error,
    },
    /// A motion's file is malformed.
    #[error("{file}: {place}: {value}; allowed: {allowed}")]
    Motion {
        /// Name of the file.
        file: String,
        /// Line and column, or key.
        place: String,
        /// What stands there.
        value: String,
        /// What may.
        allowed: String,
    },
    /// No motion of the fixtures has a name.
    #[error("--scene {id}: there is no such motion{nearest}; allowed: {known}")]
    NoMotion {
        /// Name that was given.
        id: String,
        /// Nearest known name as a phrase; empty if none is near.
        nearest: String,
        /// All names.
        known: String,
    },
    /// Numbers of a state lead out of the range of f64.
    #[error(
        "{name}: numbers of the state are too large or too small to compute with: these leave the range of numbers, up to 1.8e308: \
         {quantities}; allowed: a state in units in which they stay within it"
    )]
    NotFinite {
        /// Name of the state.
        name: String,
        /// The quantities that are infinite or not a number.
        quantities: String,
    },
    /// A state is neither a file nor stored.
    #[error("cannot read {name}: there is no such file, and no stored state of that name{nearest}; stored are {known}")]
    NoState {
        /// Name that was given.
        name: String,
        /// Nearest stored name as a phrase; empty if none is near.
        nearest: String,
        /// Names of all stored states.
        known: String,
    },
    /// No quantity has this name.
    #[error("there is no quantity `{name}`{nearest}; allowed: a name such as 21.K_1, or its first part: {known}")]
    NoQuantity {
        /// Name that was given.
        name: String,
        /// Nearest name as a phrase; empty if none is near.
        nearest: String,
        /// First parts of all names.
        known: String,
    },
    /// No state has this name.
    #[error("there is no state `{name}`{nearest}; allowed: {known}")]
    NoSuchState {
        /// Name that was given.
        name: String,
        /// Nearest name as a phrase; empty if none is near.
        nearest: String,
        /// Names of all states.
        known: String,
    },
    /// The selected states have none of the selected quantities.
    #[error(
        "nothing is asked: none of the states {states} has a value of {quantities}; allowed: states of the same element"
    )]
    NothingAsked {
        /// Selected quantities.
        quantities: String,
        /// Selected states.
        states: String,
    },
    /// Answers of a file cannot be judged.
    #[error("{file}: {reason}")]
    Answers {
        /// Path of the file.
        file: String,
        /// What is wrong, what is allowed, and what to do.
        reason: String,
    },
}
