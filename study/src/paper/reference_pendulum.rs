//! `fixtures/pendulum.json`, compared with our runs of the same meshes.

use serde::Deserialize;

use super::comparison::Comparison;
use super::pendulum_run::PendulumRun;
use super::tip::Tip;
use crate::error::{Error, Result};
use crate::fixture;
use crate::parallel::in_parallel;
use ancf::model::Element;

const NAME: &str = "pendulum.json";

/// Bound of the distance from the oracle, m.
const BOUND: f64 = 1e-6;

/// The pendulum from its strain energy alone, and the rigid pendulum, by `python -m oracle`.
#[derive(Deserialize)]
pub struct Oracle {
    pub runs: Vec<OracleRun>,
    /// The rigid pendulum by elliptic functions.
    pub rigid: Tip,
    pub shear: Shear,
}

/// Change of the flexible pendulum's tip by a shear correction factor.
#[derive(Deserialize)]
pub struct Shear {
    pub t: Vec<f64>,
    pub shift: Vec<[f64; 2]>,
}

/// One run by the oracle's integrator.
#[derive(Deserialize)]
pub struct OracleRun {
    pub id: String,
    pub element: Element,
    model: String,
    start: Option<String>,
    pub elements: usize,
    #[serde(flatten)]
    pub tip: Tip,
    pub error_estimate: ErrorEstimate,
}

#[derive(Deserialize)]
pub struct ErrorEstimate {
    pub position: f64,
}

impl OracleRun {
    /// The built-in scene of this model and start, if there is one.
    fn scene(&self) -> Option<&'static str> {
        match (self.model.as_str(), self.start.as_deref()) {
            ("none", None) => Some("pendulum-flexible"),
            ("1d", Some("sudden")) => Some("pendulum-1d"),
            ("2d", Some("sudden")) => Some("pendulum-2d"),
            ("1d", Some("relaxed")) => Some("pendulum-1d-relaxed"),
            ("2d", Some("relaxed")) => Some("pendulum-2d-relaxed"),
            _ => None,
        }
    }

    /// Our run of the same mesh, compared. The explicit method's error is well below the bound: the waves of a heat shock need a shorter step.
    fn compare(&self) -> Result<Comparison> {
        let missing = || Error::fixture(NAME, format!("no scene for the run {}", self.id));
        let step = if self.start.as_deref() == Some("sudden") { 1e-6 } else { 1e-5 };
        let ours = PendulumRun {
            scene: self.scene().ok_or_else(missing)?,
            element: self.element,
            elements: self.elements,
            step,
            end: self.tip.t.last().copied().unwrap_or_default(),
            interval: 0.05,
        };
        Ok(Comparison {
            run: self.id.clone(),
            step,
            largest_distance: ours.tip()?.largest_distance(&self.tip, |_| true),
            oracle_error: self.error_estimate.position,
            bound: BOUND,
        })
    }
}

impl Oracle {
    /// The embedded fixture.
    pub fn load() -> Result<Oracle> {
        fixture::parse(NAME, ancf_fixtures::PENDULUM)
    }

    /// The run of a built-in scene with this mesh.
    pub fn find(&self, scene: &str, element: Element, elements: usize) -> Option<&OracleRun> {
        let same = |run: &&OracleRun| (run.scene(), run.element, run.elements) == (Some(scene), element, elements);
        self.runs.iter().find(same)
    }

    /// Compares the runs of all models of the paper with ours.
    pub fn compare(&self) -> Result<Vec<Comparison>> {
        let of_the_paper: Vec<&OracleRun> = self.runs.iter().filter(|run| run.model != "transverse").collect();
        in_parallel("oracle", &of_the_paper, |run| run.compare())
    }
}
