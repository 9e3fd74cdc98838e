//! Errors of the studies.

use std::path::PathBuf;

/// Result with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Error of a study: a run that failed, an input that is refused, a file, a fixture or a picture that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A run of the study failed.
    #[error(transparent)]
    Run(#[from] ancf::error::Error),
    /// A file could not be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A file could not be written.
    #[error("cannot write {path}: {source}")]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// An output file would replace a file that the command reads.
    #[error(
        "{path} is read by this command, and its output of the same name would replace it; allowed: another folder for `--out`, or \
         another name for the input"
    )]
    OverwritesInput {
        /// The file.
        path: PathBuf,
    },
    /// No scene or case of the study has that name.
    #[error("{file}: `{key}` is {value}; allowed: {allowed}")]
    Name {
        /// The study.
        file: String,
        /// The argument that holds the name.
        key: String,
        /// The unknown name.
        value: String,
        /// The known names.
        allowed: String,
    },
    /// An embedded fixture is not what the study expects.
    #[error("the embedded fixture {name} cannot be used: {reason}")]
    Fixture {
        /// Its file name.
        name: &'static str,
        /// What is wrong with it.
        reason: String,
    },
    /// A picture could not be drawn.
    #[error("cannot draw \"{title}\": {reason}")]
    Picture {
        /// The picture's title.
        title: String,
        /// The drawing library's reason.
        reason: String,
    },
    /// Another program, with which this one is compared, does not answer.
    #[error(
        "the program `{command}` cannot be measured: {reason}; allowed: a command that answers as `python -m oracle.peers` does"
    )]
    Peer {
        /// Its command.
        command: String,
        /// What is wrong.
        reason: String,
    },
    /// A scene of the user's own that the study cannot use.
    #[error("{file}: `{key}` is {value}; allowed: {allowed}")]
    Scene {
        /// The file.
        file: String,
        /// The key.
        key: String,
        /// Its value.
        value: String,
        /// What would have been accepted.
        allowed: String,
    },
    /// No accuracy is certain in a scene of the user's own.
    #[error(
        "no run of {scene} is certain to any accuracy: its reference is known to {uncertainty:.0e} m only; allowed: a smoother start, a shorter \
         `time.end`, or finer `elements` to converge from"
    )]
    Undecided {
        /// The scene.
        scene: String,
        /// Uncertainty of its reference, m.
        uncertainty: f64,
    },
    /// A result is farther from its reference than its bound allows.
    #[error("{count} comparison(s) with the reference failed; the first: {first}")]
    Comparison {
        /// How many failed.
        count: usize,
        /// The first, with its numbers.
        first: String,
    },
}

impl Error {
    /// An embedded fixture that cannot be used, with the reason.
    pub(crate) fn fixture(name: &'static str, reason: impl ToString) -> Error {
        Error::Fixture { name, reason: reason.to_string() }
    }

    /// Whether the input is at fault, rather than a run.
    pub fn is_bad_input(&self) -> bool {
        match self {
            Error::Run(error) => error.is_bad_input(),
            Error::Name { .. } | Error::Peer { .. } | Error::Scene { .. } | Error::Read { .. } => true,
            Error::OverwritesInput { .. } => true,
            _ => false,
        }
    }
}
