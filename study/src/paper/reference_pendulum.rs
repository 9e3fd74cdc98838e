//! `fixtures/pendulum.json`, and the same runs by this program beside it.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::pendulum::{Variant, tip};
use crate::error::{Error, Result};
use crate::parallel::in_parallel;
use ancf::model::Element;

/// What `python -m oracle` writes: the pendulum from its strain energy alone, and the rigid pendulum.
const TEXT: &str = ancf_fixtures::PENDULUM;

/// The bar for the distance from the oracle, m.
const BOUND: f64 = 1e-6;

#[derive(Deserialize)]
pub struct Oracle {
    pub runs: Vec<Run>,
    pub rigid: Rigid,
    pub shear: Shear,
}

/// What a shear correction factor would change of the flexible pendulum's tip.
#[derive(Deserialize)]
pub struct Shear {
    pub t: Vec<f64>,
    pub shift: Vec<[f64; 2]>,
}

/// One run by the oracle's integrator.
#[derive(Deserialize)]
pub struct Run {
    pub id: String,
    pub element: Element,
    pub model: String,
    pub start: Option<String>,
    pub elements: usize,
    pub t: Vec<f64>,
    pub tip: Vec<[f64; 2]>,
    pub error_estimate: ErrorEstimate,
}

#[derive(Deserialize)]
pub struct ErrorEstimate {
    pub position: f64,
}

/// The rigid pendulum by elliptic functions.
#[derive(Deserialize)]
pub struct Rigid {
    pub t: Vec<f64>,
    pub tip: Vec<[f64; 2]>,
}

/// A run of ours beside the oracle's.
#[derive(Serialize)]
pub struct Row {
    pub run: String,
    pub step: f64,
    /// Over all of the oracle's times, m.
    pub largest_distance: f64,
    pub oracle_error: f64,
    pub bound: f64,
}

impl Row {
    /// A distance that is not a number does not hold.
    pub fn holds(&self) -> bool {
        self.largest_distance <= self.bound
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {:.1e} m from the oracle, bound {:.0e} m", self.run, self.largest_distance, self.bound)
    }
}

impl Run {
    /// The built-in scene of the same model and start, if there is one.
    pub fn scene(&self) -> Option<&'static str> {
        match (self.model.as_str(), self.start.as_deref()) {
            ("none", None) => Some("pendulum-flexible"),
            ("1d", Some("sudden")) => Some("pendulum-1d"),
            ("2d", Some("sudden")) => Some("pendulum-2d"),
            ("1d", Some("relaxed")) => Some("pendulum-1d-relaxed"),
            ("2d", Some("relaxed")) => Some("pendulum-2d-relaxed"),
            _ => None,
        }
    }

    /// A step at which the explicit method's error is well below the bound: the waves of a heat shock need a shorter one.
    fn step(&self) -> f64 {
        if self.start.as_deref() == Some("sudden") { 1e-6 } else { 1e-5 }
    }
}

/// Reads the embedded fixture.
pub fn load() -> Result<Oracle> {
    serde_json::from_str(TEXT).map_err(|reason| Error::Fixture { name: "pendulum.json", reason: reason.to_string() })
}

/// Runs every case of the oracle and measures the distance.
pub fn compare(oracle: &Oracle) -> Result<Vec<Row>> {
    in_parallel("oracle", &oracle.runs, |run| {
        let step = run.step();
        let end = run.t.last().copied().unwrap_or_default();
        let unknown = || Error::Fixture { name: "pendulum.json", reason: format!("no scene for the run {}", run.id) };
        let scene = run.scene().ok_or_else(unknown)?;
        let ours = tip(&Variant { scene, element: run.element, elements: run.elements, step, end, interval: 0.05 })?;
        let distances = run.t.iter().zip(&run.tip).map(|(&t, tip)| ours.distance(t, *tip));
        Ok(Row {
            run: run.id.clone(),
            step,
            largest_distance: distances.max_by(f64::total_cmp).unwrap_or(f64::NAN),
            oracle_error: run.error_estimate.position,
            bound: BOUND,
        })
    })
}
