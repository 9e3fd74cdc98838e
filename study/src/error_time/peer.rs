//! Another program that makes runs of our scenes in the same minutes: a process that answers lines of JSON.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::timing::Lap;
use crate::error::{Error, Result};
use crate::escape;

/// The command that is known.
pub const COMMAND: &str = "python -m oracle.peers";

/// The other program.
#[derive(Debug)]
pub struct Peer {
    command: String,
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    /// Its name and version.
    pub name: String,
    /// How it was built.
    pub build: String,
}

/// Its first line.
#[derive(Deserialize)]
struct Hello {
    program: String,
    version: String,
    build: String,
}

/// A run that it can make.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub struct Offer {
    /// Its number.
    pub id: usize,
    /// The program's name of the element.
    pub element: String,
    /// The program's name of the method.
    pub method: String,
    /// Elements of each rod.
    pub elements: usize,
    /// Step, s.
    pub step: f64,
    /// Newton's tolerance; `None` without an iteration.
    pub newton_tolerance: Option<f64>,
    /// Other settings, in words.
    pub options: String,
}

#[derive(Deserialize)]
struct Offers {
    points: Vec<Offer>,
}

/// What a run has given.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
pub enum Answer {
    /// The reason why it has failed.
    Failed {
        /// In the program's words.
        failed: String,
    },
    /// Time and counts; motion of the probe, if it was asked for.
    Done {
        /// Its time.
        #[serde(flatten)]
        lap: Lap,
        /// Number of steps.
        steps: usize,
        /// Newton's iterations.
        newton_iterations: usize,
        /// Computed Jacobians.
        jacobians: usize,
        /// Motion after every step, with the start.
        #[serde(flatten)]
        motion: Option<Motion>,
    },
}

/// Motion of the probe.
#[derive(Debug, Deserialize)]
pub struct Motion {
    /// Times, s.
    pub t: Vec<f64>,
    /// Positions, m.
    pub x: Vec<f64>,
    /// Positions, m.
    pub y: Vec<f64>,
    /// Velocities, m/s.
    pub vx: Vec<f64>,
    /// Velocities, m/s.
    pub vy: Vec<f64>,
}

/// What an element converges to.
#[derive(Debug, Deserialize)]
pub struct Limit {
    /// Positions at the instants, m; `None` if the element has the theory of our Euler–Bernoulli element.
    pub position: Option<Vec<[f64; 2]>>,
    /// Their uncertainty, m.
    #[serde(default)]
    pub uncertainty: f64,
}

impl Peer {
    /// Starts the program: words of the command are separated by spaces.
    ///
    /// # Errors
    /// [`Error::Peer`] if it cannot be started, or does not say what it is.
    pub fn start(command: &str) -> Result<Peer> {
        let mut words = command.split_whitespace();
        let fault = |reason: String| Error::Peer { command: command.into(), reason };
        let program = words.next().ok_or_else(|| fault("it is empty".into()))?;
        let child = Command::new(program).args(words).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut child = child.map_err(|reason| fault(reason.to_string()))?;
        let (input, output) = (child.stdin.take(), child.stdout.take());
        let output = BufReader::new(output.ok_or_else(|| fault("it has no output".into()))?);
        let (name, build) = Default::default();
        let mut peer = Peer { command: command.into(), child, input, output, name, build };
        let Hello { program, version, build } = peer.answer()?;
        peer.name = escape::line(&format!("{program} {version}"));
        peer.build = escape::line(&build);
        Ok(peer)
    }

    /// The runs that it can make of a scene.
    ///
    /// # Errors
    /// [`Error::Peer`].
    pub fn offers(&mut self, scene: &str, quick: bool) -> Result<Vec<Offer>> {
        Ok(self.ask::<Offers>(&json!({ "points": scene, "quick": quick }))?.points)
    }

    /// Makes a run; `record`: with its motion at every step.
    ///
    /// # Errors
    /// [`Error::Peer`].
    pub fn run(&mut self, id: usize, record: bool) -> Result<Answer> {
        self.ask(&json!({ "run": id, "record": record }))
    }

    /// What an element converges to in a scene.
    ///
    /// # Errors
    /// [`Error::Peer`].
    pub fn limit(&mut self, scene: &str, element: &str, times: &[f64]) -> Result<Limit> {
        self.ask(&json!({ "limit": scene, "element": element, "times": times }))
    }

    fn ask<T: DeserializeOwned>(&mut self, question: &Value) -> Result<T> {
        let sent = self.input.as_mut().map(|input| writeln!(input, "{question}").and_then(|()| input.flush()));
        // A program that has ended says why on the standard error.
        if sent.is_none_or(|sent| sent.is_err()) {
            return Err(self.fault("it has ended".into()));
        }
        self.answer()
    }

    fn answer<T: DeserializeOwned>(&mut self) -> Result<T> {
        let mut line = String::new();
        match self.output.read_line(&mut line) {
            Err(reason) => return Err(self.fault(reason.to_string())),
            Ok(0) => return Err(self.fault("it has ended without an answer".into())),
            Ok(_) => {}
        }
        serde_json::from_str(&line).map_err(|reason| {
            let start: String = line.trim_end().chars().take(80).collect();
            self.fault(format!("its line `{start}` is no answer ({reason})"))
        })
    }

    fn fault(&self, reason: String) -> Error {
        Error::Peer { command: self.command.clone(), reason }
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        // The end of its input tells it to end; one that does not is ended.
        self.input = None;
        if !matches!(self.child.try_wait(), Ok(Some(_))) {
            let _ = self.child.kill();
        }
        let _ = self.child.wait();
    }
}
