//! Motions of two pinned rods against the oracle.
//!
//! Source: `fixtures/structure.json`, "trajectories": two rods as scissors and as a knee, inclined, of different material,
//! section and temperature, with a hinge or a clamp, an oblique slide, weight and a changing force; SciPy integrates in free
//! coordinates what follows from energy and constraint functions alone. Goal: every method, condensed and with multipliers,
//! gives that motion and its forces as the step is refined.

mod common;

use ancf::model::{Constraints, Method, Model, Scene};
use ancf::run::Run;
use common::evidence;
use common::motion::{farthest, longest, must_run, positions, reactions, velocities};
use common::system::systems;
use serde::Deserialize;
use std::collections::BTreeMap;

type Paths = BTreeMap<String, Vec<[f64; 2]>>;

/// A motion of the oracle.
#[derive(Deserialize)]
struct Motion {
    id: String,
    scene: serde_json::Value,
    t: Vec<f64>,
    position: Paths,
    velocity: Paths,
    reactions: Paths,
    pins: BTreeMap<String, Paths>,
    error_estimate: ErrorEstimate,
}

#[derive(Deserialize)]
struct ErrorEstimate {
    position: f64,
    velocity: f64,
    force: f64,
}

/// Largest distances from the oracle: m, m/s, and forces relative to the largest of them.
#[derive(Clone, Copy, Debug)]
struct Distances {
    position: f64,
    velocity: f64,
    force: f64,
}

fn motion(id: &str) -> Motion {
    let all: Vec<Motion> = serde_json::from_value(systems()["trajectories"].clone()).unwrap();
    let motion = all.into_iter().find(|motion| motion.id == id).unwrap_or_else(|| panic!("no motion {id}"));
    let sure = &motion.error_estimate;
    assert!(sure.position < 1e-9 && sure.velocity < 1e-6 && sure.force < 1e-4, "the oracle is not sure enough itself");
    motion
}

impl Motion {
    fn scene(&self, method: Method, constraints: Constraints, step: f64) -> Scene {
        let mut scene = Model::parse(&self.scene.to_string(), &self.id).unwrap().into_scene();
        (scene.time.method, scene.constraints, scene.time.step) = (method, constraints, step);
        (scene.output.interval, scene.output.energy) = (Some(self.t[1]), false);
        scene
    }

    fn distances(&self, run: &Run) -> Distances {
        let t = run.trajectory.column("t").unwrap();
        assert!(t.len() == self.t.len() && t.iter().zip(&self.t).all(|(a, b)| (a - b).abs() < 1e-12), "{t:?}");
        let worst = |paths: &Paths, ours: fn(&Run, &str) -> Vec<[f64; 2]>| {
            assert!(!paths.is_empty());
            paths.iter().map(|(name, path)| farthest(path, &ours(run, name))).fold(0.0, f64::max)
        };
        // The probes of the force on a rod are called `point-rod`.
        let pins =
            self.pins.iter().flat_map(|(point, rods)| rods.iter().map(move |(rod, p)| (format!("{point}-{rod}"), p)));
        let forces: Paths = self.reactions.clone().into_iter().chain(pins.map(|(name, p)| (name, p.clone()))).collect();
        let largest = forces.values().map(|path| longest(path)).fold(0.0, f64::max);
        Distances {
            position: worst(&self.position, positions),
            velocity: worst(&self.velocity, velocities),
            force: worst(&forces, reactions) / largest,
        }
    }

    /// Distances of a method, at each of the steps.
    fn refined(&self, method: Method, constraints: Constraints, steps: &[f64]) -> Vec<Distances> {
        let distances = |step: &f64| {
            let distances = self.distances(&must_run(&self.scene(method, constraints, *step)));
            println!("{}, {method}, {constraints:?}, step {step:e}: {distances:?}", self.id);
            distances
        };
        steps.iter().map(distances).collect()
    }
}

/// Orders in position seen from one step to the next.
fn orders(steps: &[f64], distances: &[Distances]) -> Vec<f64> {
    let pairs = distances.windows(2).zip(steps.windows(2));
    pairs.map(|(d, s)| (d[0].position / d[1].position).ln() / (s[0] / s[1]).ln()).collect()
}

/// The bars: positions within 1e-6 m, and for the rest what was measured, with room for a factor of two.
///
/// Velocities and forces carry the thickness vibrations, ω ≈ 3e4 rad/s, which positions hardly show. A method of second order
/// is late by (ωΔt)²/24 · ωt, many radians at 0.5 s with steps of 5e-6 s, so that all of such a vibration is an error: a
/// thousandth of the largest force, the knee's more than the scissors'. It goes once steps resolve the vibration:
/// [`forces_meet_the_oracle_once_the_thickness_vibration_is_resolved`].
#[track_caller]
fn assert_near(what: &str, off: Distances, velocity: f64, force: f64) {
    assert!(off.position <= 1e-6, "{what}: {:.1e} m", off.position);
    assert!(off.velocity <= velocity, "{what}: {:.1e} m/s", off.velocity);
    assert!(off.force <= force, "{what}: {:.1e} of the largest force", off.force);
}

/// A single run.
#[track_caller]
fn assert_meets(motion: &Motion, method: Method, constraints: Constraints, step: f64, velocity: f64, force: f64) {
    let off = motion.refined(method, constraints, &[step])[0];
    assert_near(&format!("{}, {method}, {constraints:?}", motion.id), off, velocity, force);
}

/// Velocity Verlet at 5e-6 s.
#[test]
fn explicit_motions_meet_the_oracle() {
    for (id, velocity, force) in [("scissor-1-2", 6e-5, 8e-5), ("scissor-3-4", 4e-4, 2e-4), ("knee-2-1", 1.2e-4, 4e-3)]
    {
        assert_meets(&motion(id), Method::Explicit, Constraints::Condensed, 5e-6, velocity, force);
    }
}

/// Energy–momentum and generalized-α at 2e-5 s, with shared coordinates and with multipliers.
#[test]
fn implicit_motions_meet_the_oracle() {
    for (method, constraints) in [
        (Method::EnergyMomentum, Constraints::Condensed),
        (Method::GeneralizedAlpha, Constraints::Condensed),
        (Method::GeneralizedAlpha, Constraints::Multipliers),
    ] {
        assert_meets(&motion("knee-2-1"), method, constraints, 2e-5, 6e-4, 6e-3);
    }
}

/// The same for scissors, whose middles are nodes of an element and of two; and the error falls with the square of the step,
/// but for the finer mesh, whose waves no such step resolves (`convergence.rs` has the same of the pendulum): measured 2.0 and
/// 2.1, and 1.4 with three and four elements.
#[test]
#[cfg_attr(debug_assertions, ignore = "takes a minute; cargo test --release")]
fn implicit_motions_meet_the_oracle_as_the_step_is_refined() {
    let steps = [4e-5, 2e-5, 1e-5];
    for (id, least_order, velocity, force) in
        [("scissor-1-2", 1.9, 6e-4, 8e-4), ("scissor-3-4", 1.2, 3e-3, 1.3e-3), ("knee-2-1", 1.9, 1.5e-4, 2.4e-3)]
    {
        let motion = motion(id);
        for method in [Method::EnergyMomentum, Method::GeneralizedAlpha] {
            let distances = motion.refined(method, Constraints::Condensed, &steps);
            let orders = orders(&steps, &distances);
            println!("{id}, {method}: orders {orders:.2?}");
            assert!(orders.iter().all(|order| *order >= least_order), "{id}, {method}: {orders:.2?}");
            evidence::at_most("two-rods.implicit", distances[2].position);
            assert_near(&format!("{id}, {method}"), distances[2], velocity, force);
        }
        assert_meets(&motion, Method::GeneralizedAlpha, Constraints::Multipliers, 1e-5, velocity, force);
    }
}

/// At 5e-7 s the thickness vibration is late by a tenth of a radian at the end: forces are met to 1.5e-4 of the largest in
/// place of 2e-3, velocities to 2e-6 m/s in place of 6e-5, positions to 2e-10 m.
#[test]
#[cfg_attr(debug_assertions, ignore = "takes a minute; cargo test --release")]
fn forces_meet_the_oracle_once_the_thickness_vibration_is_resolved() {
    assert_meets(&motion("knee-2-1"), Method::Explicit, Constraints::Condensed, 5e-7, 4e-6, 4e-4);
}
