//! `fixtures/structure.json`: pinned rods in motion by the oracle, the rigid mechanism, and ours beside them.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::reference_pendulum::{ErrorEstimate, Row};
use crate::error::{Error, Result};
use crate::parallel::in_parallel;
use ancf::model::{Constraints, Method, Probe, Quantity, Scene, Scissors};
use ancf::run::run;

/// What `python -m oracle` writes: two pairs of rods by SciPy in free coordinates, the rigid mechanism by quadrature.
const TEXT: &str = ancf_fixtures::STRUCTURE;

#[derive(Deserialize)]
pub struct Pinned {
    trajectories: Vec<Motion>,
    rigid: RigidMechanisms,
}

/// Pinned rods at different temperatures.
#[derive(Deserialize)]
struct Motion {
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

/// Scissors of rigid rods; `tip` is the outermost upper point.
#[derive(Deserialize)]
struct RigidMechanism {
    scissors: usize,
    t: Vec<f64>,
    tip: Vec<[f64; 2]>,
    error_estimate: AngleError,
}

/// Of the angle, rad; the rods are of the order of a metre.
#[derive(Deserialize)]
struct AngleError {
    theta: f64,
}

/// How much stiffer than Table 2 the scissors are that have to move like rigid ones, and until when.
const STIFFER: f64 = 1e4;
const STIFF_UNTIL: f64 = 2.9;

/// Bounds for the distances from the oracle and from the rigid mechanism, m.
const BOUND: f64 = 1e-6;
const BOUND_RIGID: f64 = 1e-3;

/// Reads the embedded fixture.
pub fn load() -> Result<Pinned> {
    serde_json::from_str(TEXT).map_err(|reason| Error::Fixture { name: "structure.json", reason: reason.to_string() })
}

/// Positions at a time of a point that belong together: the oracle's, and the name of our probe.
struct Job<'a> {
    name: String,
    scene: Scene,
    /// Probe, and the oracle's positions of it at the times `t`.
    positions: Vec<(&'a str, &'a [[f64; 2]])>,
    t: &'a [f64],
    error: f64,
    bound: f64,
}

/// Runs every case and measures the distance.
pub fn compare(pinned: &Pinned) -> Result<Vec<Row>> {
    let mut jobs = Vec::new();
    for motion in &pinned.trajectories {
        jobs.push(pinned_rods(motion)?);
    }
    for mechanism in pinned.rigid.runs.iter().filter(|mechanism| mechanism.scissors == 3) {
        jobs.push(stiff_scissors(mechanism)?);
    }
    in_parallel("structures", &jobs, |job| {
        let trajectory = run(&job.scene)?.trajectory;
        let t = trajectory.column("t").unwrap_or_default();
        let mut largest: f64 = 0.0;
        for (probe, positions) in &job.positions {
            let column = |axis: &str| trajectory.column(&format!("{probe}.{axis}")).unwrap_or_default();
            let (x, y) = (column("x"), column("y"));
            for (time, position) in job.t.iter().zip(*positions) {
                let row = t.iter().position(|row| (row - time).abs() < 1e-9);
                let distance = row.map_or(f64::NAN, |row| (x[row] - position[0]).hypot(y[row] - position[1]));
                // `f64::max` would drop a NaN.
                largest = if distance > largest || distance.is_nan() { distance } else { largest };
            }
        }
        let step = job.scene.time.step;
        Ok(Row { run: job.name.clone(), step, largest_distance: largest, oracle_error: job.error, bound: job.bound })
    })
}

/// The oracle's scene by the explicit method, at a step whose error is well below the bound.
fn pinned_rods(motion: &Motion) -> Result<Job<'_>> {
    let mut scene = Scene::parse(&motion.scene.to_string(), &motion.id)?;
    (scene.time.method, scene.constraints, scene.time.step) = (Method::Explicit, Constraints::Condensed, 2.5e-6);
    scene.output.energy = false;
    scene.output.interval = motion.t.get(1).copied();
    let probe = |point: &String| Probe {
        name: point.clone(),
        point: Some(point.clone()),
        rod: None,
        at: None,
        of: vec![Quantity::Position],
    };
    scene.probes = motion.position.keys().map(probe).collect();
    Ok(Job {
        name: motion.id.clone(),
        scene,
        positions: motion.position.iter().map(|(name, positions)| (name.as_str(), positions.as_slice())).collect(),
        t: &motion.t,
        error: motion.error_estimate.position,
        bound: BOUND,
    })
}

/// The paper's scissors with stiff rods.
fn stiff_scissors(mechanism: &RigidMechanism) -> Result<Job<'_>> {
    let mut scene = Scissors { elements: 4, ..Scissors::new(mechanism.scissors) }.scene()?;
    scene.material.youngs_modulus *= STIFFER;
    (scene.time.method, scene.time.step, scene.time.end) = (Method::GeneralizedAlpha, 1e-3, STIFF_UNTIL);
    (scene.output.interval, scene.output.energy) = (Some(0.1), false);
    let until = mechanism.t.iter().filter(|&&t| t < STIFF_UNTIL + 1e-9).count();
    Ok(Job {
        name: "rigid-3".into(),
        scene,
        positions: vec![("a4", &mechanism.tip[..until])],
        t: &mechanism.t[..until],
        error: mechanism.error_estimate.theta,
        bound: BOUND_RIGID,
    })
}
