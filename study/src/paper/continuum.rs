//! `fixtures/continuum.json`: the pendulum as a plane solid, which stands in for the paper's ANSYS curve.

use serde::{Deserialize, Serialize};

use super::pendulum::Tip;
use crate::error::{Error, Result};

const TEXT: &str = ancf_fixtures::CONTINUUM;

/// What `python -m oracle continuum` writes.
#[derive(Deserialize)]
pub struct Continuum {
    /// Time from one position to the next, s.
    interval: f64,
    windows: Vec<[f64; 2]>,
    runs: Vec<Run>,
}

#[derive(Deserialize)]
struct Run {
    id: String,
    uncertainty: Uncertainty,
    tip: Vec<[f64; 2]>,
}

/// Of the tip in each window, m: of mesh and step together.
#[derive(Deserialize)]
struct Uncertainty {
    total: Vec<f64>,
}

/// A part of the time, s, without its beginning.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Window {
    pub from: f64,
    pub to: f64,
    /// Its number among the windows.
    #[serde(skip)]
    pub number: usize,
}

impl Window {
    /// Whether a time belongs to it.
    pub fn contains(&self, t: f64) -> bool {
        t > self.from + 1e-9 && t <= self.to + 1e-9
    }
}

impl std::fmt::Display for Window {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} … {} s", self.from, self.to)
    }
}

/// The solid's tip in one model.
pub struct Solid {
    pub tip: Tip,
    /// Uncertainty in each window, m.
    uncertainty: Vec<f64>,
}

impl Solid {
    /// Its uncertainty in a window, m.
    pub fn uncertainty(&self, window: Window) -> f64 {
        self.uncertainty.get(window.number).copied().unwrap_or(f64::NAN)
    }
}

/// Reads the embedded fixture.
pub fn load() -> Result<Continuum> {
    serde_json::from_str(TEXT).map_err(|reason| Error::Fixture { name: "continuum.json", reason: reason.to_string() })
}

impl Continuum {
    /// The windows in the order of time.
    pub fn windows(&self) -> impl Iterator<Item = Window> {
        self.windows.iter().enumerate().map(|(number, &[from, to])| Window { from, to, number })
    }

    /// The solid of a name.
    pub fn solid(&self, id: &str) -> Result<Solid> {
        let missing = || Error::Fixture { name: "continuum.json", reason: format!("there is no run {id}") };
        let run = self.runs.iter().find(|run| run.id == id).ok_or_else(missing)?;
        let t = (0..run.tip.len()).map(|n| n as f64 * self.interval).collect();
        Ok(Solid { tip: Tip { t, r: run.tip.clone() }, uncertainty: run.uncertainty.total.clone() })
    }
}
