//! `fixtures/structure.json`: pinned rods in motion and the rigid mechanism, compared with our runs.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::comparison::Comparison;
use super::reference_pendulum::ErrorEstimate;
use super::tip::Tip;
use crate::error::Result;
use crate::fixture;
use crate::parallel::in_parallel;
use crate::path::{column, largest_of, positions};
use crate::scene::{Change, point_probe};
use ancf::internals::model::Scissors;
use ancf::model::{Constraints, Method, Model, Quantity, Scene};
use ancf::run::run;

/// Pairs of pinned rods by SciPy in free coordinates, and the rigid mechanism by quadrature, by `python -m oracle`.
#[derive(Deserialize)]
pub struct Structures {
    trajectories: Vec<PinnedRods>,
    rigid: RigidMechanisms,
}

/// Pinned rods at different temperatures.
#[derive(Deserialize)]
struct PinnedRods {
    id: String,
    scene: serde_json::Value,
    t: Vec<f64>,
    position: BTreeMap<String, Vec<[f64; 2]>>,
    error_estimate: ErrorEstimate,
}

#[derive(Deserialize)]
struct RigidMechanisms {
    runs: Vec<RigidMechanism>,
}

/// Scissors of rigid rods; the tip is the outermost upper point.
#[derive(Deserialize)]
struct RigidMechanism {
    scissors: usize,
    #[serde(flatten)]
    tip: Tip,
    error_estimate: AngleError,
}

/// Of the angle, rad; the rods are about a metre long.
#[derive(Deserialize)]
struct AngleError {
    theta: f64,
}

/// E of the stiff scissors over Table 2's, and the end of their comparison, s.
const STIFFER: f64 = 1e4;
const STIFF_UNTIL: f64 = 2.9;

/// Bounds of the distances from the oracle and from the rigid mechanism, m.
const BOUND: f64 = 1e-6;
const BOUND_RIGID: f64 = 1e-3;

/// A scene, and the reference's positions of its probes.
struct Job {
    name: String,
    scene: Scene,
    references: Vec<(String, Tip)>,
    error: f64,
    bound: f64,
}

impl Structures {
    /// The embedded fixture.
    pub fn load() -> Result<Structures> {
        fixture::parse("structure.json", ancf_fixtures::STRUCTURE)
    }

    /// Compares all structures with our runs.
    pub fn compare(&self) -> Result<Vec<Comparison>> {
        let pinned = self.trajectories.iter().map(PinnedRods::job);
        let rigid = self.rigid.runs.iter().filter(|mechanism| mechanism.scissors == 3).map(RigidMechanism::job);
        let jobs = pinned.chain(rigid).collect::<Result<Vec<Job>>>()?;
        in_parallel("structures", &jobs, Job::compare)
    }
}

impl Job {
    fn compare(&self) -> Result<Comparison> {
        let own = run(&self.scene)?;
        let distance = |(probe, reference): &(String, Tip)| {
            let ours = Tip { t: column(&own, "t"), r: positions(&own, probe) };
            ours.largest_distance(reference, |_| true)
        };
        Ok(Comparison {
            run: self.name.clone(),
            step: self.scene.time.step,
            largest_distance: largest_of(self.references.iter().map(distance)),
            oracle_error: self.error,
            bound: self.bound,
        })
    }
}

impl PinnedRods {
    /// The oracle's scene by the explicit method; the error of its step is well below the bound.
    fn job(&self) -> Result<Job> {
        let mut scene = Model::parse(&self.scene.to_string(), &self.id)?.into_scene();
        (scene.time.method, scene.constraints, scene.time.step) = (Method::Explicit, Constraints::Condensed, 2.5e-6);
        (scene.output.energy, scene.output.interval) = (false, self.t.get(1).copied());
        scene.probes = self.position.keys().map(|point| point_probe(point, &[Quantity::Position])).collect();
        let tip = |(name, r): (&String, &Vec<[f64; 2]>)| (name.clone(), Tip { t: self.t.clone(), r: r.clone() });
        Ok(Job {
            name: self.id.clone(),
            scene,
            references: self.position.iter().map(tip).collect(),
            error: self.error_estimate.position,
            bound: BOUND,
        })
    }
}

impl RigidMechanism {
    /// The paper's scissors with stiff rods.
    fn job(&self) -> Result<Job> {
        let mut scene = Scissors { elements: 4, ..Scissors::new(self.scissors) }
            .scene()?
            .solved(Method::GeneralizedAlpha, 1e-3, STIFF_UNTIL)
            .rows_every(0.1);
        scene.material.youngs_modulus *= STIFFER;
        scene.output.energy = false;
        let rows = self.tip.t.iter().zip(&self.tip.r).filter(|(t, _)| **t < STIFF_UNTIL + 1e-9);
        let (t, r) = rows.unzip();
        Ok(Job {
            name: "rigid-3".into(),
            scene,
            references: vec![("a4".into(), Tip { t, r })],
            error: self.error_estimate.theta,
            bound: BOUND_RIGID,
        })
    }
}
