//! `fixtures/continuum.json`: the pendulum as a plane solid, in place of the paper's ANSYS curve.

use serde::Deserialize;

use super::tip::Tip;
use super::window::Window;
use crate::error::{Error, Result};
use crate::fixture;

const NAME: &str = "continuum.json";

/// Runs of the plane solid, by `python -m oracle continuum`.
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

/// Of the tip in each window, by mesh and step together, m.
#[derive(Deserialize)]
struct Uncertainty {
    total: Vec<f64>,
}

/// The solid's tip in one model.
pub struct Solid {
    pub tip: Tip,
    /// Uncertainty in each window, m.
    uncertainty: Vec<f64>,
}

impl Solid {
    /// Uncertainty in a window, m.
    pub fn uncertainty(&self, window: Window) -> f64 {
        self.uncertainty.get(window.number).copied().unwrap_or(f64::NAN)
    }
}

impl Continuum {
    /// The embedded fixture.
    pub fn load() -> Result<Continuum> {
        fixture::parse(NAME, ancf_fixtures::CONTINUUM)
    }

    /// The windows in the order of time.
    pub fn windows(&self) -> impl Iterator<Item = Window> {
        self.windows.iter().enumerate().map(|(number, &[from, to])| Window { from, to, number })
    }

    /// The solid of a name.
    pub fn solid(&self, id: &str) -> Result<Solid> {
        let run = self.runs.iter().find(|run| run.id == id);
        let run = run.ok_or_else(|| Error::fixture(NAME, format!("there is no run {id}")))?;
        let t = (0..run.tip.len()).map(|n| n as f64 * self.interval).collect();
        Ok(Solid { tip: Tip { t, r: run.tip.clone() }, uncertainty: run.uncertainty.total.clone() })
    }
}
