//! `summary.json`: what a run was, what it took, where it ended.

use std::io::{self, Write};

use serde::{Serialize, Serializer};

use super::{energy_imbalance, final_time, final_values};
use ancf::integrators::Counts;
use ancf::internals::model::{Part, Plan};
use ancf::model::{Method, Scene};
use ancf::run::Estimate;
use ancf::run::Run;

/// Writes the content of `summary.json`: the scene, what the run took, where the probes ended, and what is known of
/// the accuracy.
///
/// # Errors
/// What `out` reports.
pub fn write_summary(out: &mut dyn Write, scene: &Scene, run: &Run, wall_seconds: f64) -> io::Result<()> {
    let summary = Summary {
        scene,
        plan: Plan::of(scene).parts(scene),
        method: scene.time.method,
        steps: run.counts.steps,
        newton_iterations: run.counts.newton_iterations,
        counts: &run.counts,
        wall_seconds,
        end: End { t: final_time(run), probes: run },
        warnings: &run.warnings,
        accuracy: Accuracy {
            time: Known::of(&run.accuracy.time),
            space: Known::of(&run.accuracy.space),
            energy: energy_imbalance(&run.trajectory).map_or(Known::None, |value| {
                let method = "largest |energy.balance| over the rows".into();
                Known::Found(Estimate { value, unit: "J", method })
            }),
        },
    };
    serde_json::to_writer_pretty(&mut *out, &summary)?;
    writeln!(out)
}

/// `summary.json`, its keys in the order of the file.
#[derive(Serialize)]
struct Summary<'a> {
    scene: &'a Scene,
    /// What was computed and what was left out.
    plan: Vec<Part>,
    method: Method,
    steps: usize,
    newton_iterations: usize,
    counts: &'a Counts,
    wall_seconds: f64,
    #[serde(rename = "final")]
    end: End<'a>,
    warnings: &'a [String],
    accuracy: Accuracy,
}

/// The last row: its time, s, and the probes' columns by name.
#[derive(Serialize)]
struct End<'a> {
    t: Option<f64>,
    #[serde(serialize_with = "probes")]
    probes: &'a Run,
}

fn probes<S: Serializer>(run: &Run, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(final_values(run))
}

#[derive(Serialize)]
struct Accuracy {
    time: Known,
    space: Known,
    energy: Known,
}

/// A value with the method that estimated it.
#[derive(Serialize)]
#[serde(untagged)]
enum Known {
    Found(Estimate),
    #[serde(serialize_with = "not_estimated")]
    None,
}

impl Known {
    fn of(estimate: &Option<Estimate>) -> Known {
        estimate.clone().map_or(Known::None, Known::Found)
    }
}

fn not_estimated<S: Serializer>(serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str("not estimated")
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use ancf::model::Model;

    use super::super::tests::{AWKWARD, run};
    use super::*;

    fn summary(scene: &Scene, run: &Run) -> Value {
        let mut text = Vec::new();
        write_summary(&mut text, scene, run, 0.25).unwrap();
        serde_json::from_slice(&text).unwrap()
    }

    #[test]
    fn summary_holds_the_scene_the_counts_and_the_end() {
        let (scene, run) = run();
        let summary = summary(&scene, &run);
        assert_eq!(Model::parse(&summary["scene"].to_string(), "summary").unwrap().into_scene(), scene);
        assert_eq!(summary["method"], "energy-momentum");
        assert_eq!((&summary["steps"], &summary["newton_iterations"]), (&json!(1), &json!(2)));
        let counts = json!({"steps": 1, "rejected": 0, "newton_iterations": 2, "force_calls": 3, "tangent_calls": 4,
            "factorizations": 5, "solves": 6});
        assert_eq!(summary["counts"], counts);
        let probes = json!({"tip.x": AWKWARD[1], "tip.y": AWKWARD[2], "tip.vx": AWKWARD[3], "tip.vy": AWKWARD[4]});
        assert_eq!(summary["final"], json!({"t": 0.1, "probes": probes}));
        assert_eq!(summary["warnings"], json!(["mind the gap"]));
        assert_eq!(summary["accuracy"]["time"], "not estimated");
        assert_eq!(summary["accuracy"]["space"], "not estimated");
        assert_eq!(summary["accuracy"]["energy"]["value"], 3e-7);
    }

    #[test]
    fn without_energies_their_balance_is_not_estimated() {
        let (scene, mut run) = run();
        run.trajectory.columns.truncate(5);
        assert_eq!(summary(&scene, &run)["accuracy"]["energy"], "not estimated");
    }
}
