//! `summary.json`: what a run was, what it took, where it ended.

use std::collections::BTreeMap;
use std::io::{self, Write};

use ancf::error::Error;
use ancf::integrators::Counts;
use ancf::internals::model::{Part, Plan};
use ancf::model::{Method, Scene};
use ancf::run::{ColumnAccuracy, Estimate, Run};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::ends::{energy_imbalance, final_time, final_values};

/// Writes the content of `summary.json`.
///
/// # Errors
/// What `out` reports.
pub fn write_summary(out: &mut dyn Write, summary: &Summary) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, summary)?;
    writeln!(out)
}

/// Content of `summary.json`: what a run was, what it took, where it ended.
#[derive(Serialize, JsonSchema)]
pub struct Summary<'a> {
    /// Run id: the first 16 hexadecimal digits of the SHA-256 of the run's table, as `sha256sum` prints it.
    run: &'a str,
    /// Whether the run reached its end.
    status: Status,
    /// What ended a run that failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    /// Time of the last row of `trajectory.partial.csv`, s, the load factor in statics; null if there is none. Of runs that failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    last_good_time: Option<Option<f64>>,
    /// The program that ran it.
    program: Program,
    /// Changes of the scene by `--set`, as they were given.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    set: &'a [String],
    /// The scene that was run, with these changes.
    scene: &'a Scene,
    /// What was computed and what was left out.
    plan: Vec<Part>,
    /// The method of the scene.
    method: Method,
    /// Time steps, or load steps.
    steps: usize,
    /// Newton iterations over all steps.
    newton_iterations: usize,
    /// Counters of the work.
    counts: &'a Counts,
    /// Run time, s: the only number of a run's files that differs when the run is repeated.
    wall_seconds: f64,
    /// The last row.
    #[serde(rename = "final")]
    end: End<'a>,
    /// What a person should know before trusting the result.
    warnings: &'a [String],
    /// What is known of the errors.
    accuracy: KnownErrors<'a>,
}

impl<'a> Summary<'a> {
    /// Summary of a run: the scene, what the run took, where the probes ended, and what is known of the accuracy. `id` is
    /// that of the run's table; `error` ended the run, which then holds what there was until then.
    pub fn of(
        id: &'a str,
        scene: &'a Scene,
        set: &'a [String],
        run: &'a Run,
        error: Option<&Error>,
        wall_seconds: f64,
    ) -> Summary<'a> {
        Summary {
            run: id,
            status: if error.is_some() { Status::Failed } else { Status::Ok },
            error: error.map(Error::to_string),
            last_good_time: error.map(|_| final_time(run)),
            program: Program::default(),
            set,
            scene,
            plan: Plan::of(scene).parts(scene),
            method: scene.time.method,
            steps: run.counts.steps,
            newton_iterations: run.counts.newton_iterations,
            counts: &run.counts,
            wall_seconds,
            end: End { t: final_time(run), probes: run },
            warnings: &run.warnings,
            accuracy: KnownErrors {
                columns: &run.accuracy.columns,
                amplification: run.accuracy.amplification,
                time: Known::of(run.accuracy.time.clone()),
                space: Known::of(run.accuracy.space.clone()),
                energy: Known::of(energy_imbalance(&run.trajectory).map(|value| {
                    let method = "largest |energy.balance| over the rows".into();
                    Estimate { value, unit: "J", method }
                })),
            },
        }
    }
}

/// The program that ran a scene.
#[derive(Serialize, JsonSchema)]
struct Program {
    /// Its version.
    version: &'static str,
    /// The commit that it was built from, as `git describe --always --dirty` names it; left out where that is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    commit: Option<&'static str>,
    /// Processor and system, such as x86_64-linux.
    platform: String,
}

impl Default for Program {
    fn default() -> Program {
        Program {
            version: env!("CARGO_PKG_VERSION"),
            commit: option_env!("ANCF_COMMIT"),
            platform: format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS),
        }
    }
}

/// The line of `--summary-line`, of a scene that was refused: nothing was run.
pub fn refused_line(scene: &str, set: &[String], error: &str) -> String {
    #[derive(Serialize)]
    struct Refused<'a> {
        status: &'static str,
        error: &'a str,
        scene: &'a str,
        set: &'a [String],
    }
    line(&Refused { status: "refused", error, scene, set })
}

/// JSON in one line.
pub fn line(of: &impl Serialize) -> String {
    // Data of this crate's own types is always JSON.
    serde_json::to_string(of).unwrap_or_default() + "\n"
}

/// How a run ended.
#[derive(Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Status {
    /// At its end; `trajectory.csv` has the rows.
    Ok,
    /// With an error; `trajectory.partial.csv` has the rows until then.
    Failed,
}

/// The last row of a trajectory.
#[derive(Serialize, JsonSchema)]
struct End<'a> {
    /// Time, s; the load factor in statics.
    t: Option<f64>,
    /// Values by name of column: m, m/s, m/s², N.
    #[serde(serialize_with = "probes")]
    #[schemars(with = "BTreeMap<String, f64>")]
    probes: &'a Run,
}

fn probes<S: Serializer>(run: &Run, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(final_values(run))
}

/// Errors of a run, as far as they are known.
#[derive(Serialize, JsonSchema)]
struct KnownErrors<'a> {
    /// Error due to the step.
    time: Known,
    /// Error due to the mesh.
    space: Known,
    /// Error of the energy balance.
    energy: Known,
    /// Errors of all columns, by name and in their units; empty if no estimate was asked for.
    columns: &'a [ColumnAccuracy],
    /// Factor by which a deviation of 10⁻⁸ of the structure's size has grown; left out where no such run was made.
    #[serde(skip_serializing_if = "Option::is_none")]
    amplification: Option<f64>,
}

/// An error that is known or not.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
enum Known {
    /// A value, its unit and how it was found.
    Found(Estimate),
    /// No estimate was asked for, or there are no energies.
    Not(NotEstimated),
}

/// The words for an error that is not known.
#[derive(Serialize, JsonSchema)]
enum NotEstimated {
    /// "not estimated".
    #[serde(rename = "not estimated")]
    NotEstimated,
}

impl Known {
    fn of(estimate: Option<Estimate>) -> Known {
        estimate.map_or(Known::Not(NotEstimated::NotEstimated), Known::Found)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use ancf::model::Model;

    use super::*;
    use crate::report::tests::{AWKWARD, run};

    fn summary(scene: &Scene, run: &Run) -> Value {
        let mut text = Vec::new();
        write_summary(&mut text, &Summary::of("0f", scene, &[], run, None, 0.25)).unwrap();
        serde_json::from_slice(&text).unwrap()
    }

    #[test]
    fn summary_holds_the_scene_the_counts_and_the_end() {
        let (scene, run) = run();
        let summary = summary(&scene, &run);
        assert_eq!(
            (&summary["run"], &summary["status"], &summary["error"]),
            (&json!("0f"), &json!("ok"), &Value::Null)
        );
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
