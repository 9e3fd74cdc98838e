//! One scene from start to end.

mod energy;
pub mod estimate;
mod load_scale;
mod monitor;
mod observer;
mod recorder;
mod unresolved_loads;
mod warnings;

use std::io::{self, Write};

pub(crate) use load_scale::{mass, moves};
use monitor::Watch;
use recorder::Recorder;
pub(crate) use unresolved_loads::missed;
use warnings::warnings;

use crate::error::Result;
use crate::integrators::counts::Counts;
use crate::integrators::{self, State};
use crate::model::Scene;
use crate::model::plan::Plan;
use crate::run::estimate::Accuracy;
use crate::structure::Structure;

/// A table over time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// Names of the columns, the first of them `t`.
    pub columns: Vec<String>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<f64>>,
}

impl Trajectory {
    /// A column by its name.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let place = self.columns.iter().position(|column| column == name)?;
        Some(self.rows.iter().map(|row| row[place]).collect())
    }

    /// Writes the table as CSV: names of the columns, then a line for each row. Numbers have as many digits as it takes to read
    /// back the same `f64`.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "{}", self.columns.join(","))?;
        for row in &self.rows {
            for (column, number) in row.iter().enumerate() {
                let comma = if column == 0 { "" } else { "," };
                write!(out, "{comma}{number:?}")?;
            }
            writeln!(out)?;
        }
        Ok(())
    }
}

/// What a run gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The rows that the scene asks for.
    pub trajectory: Trajectory,
    /// The work that was done.
    pub counts: Counts,
    /// What a person should know before trusting the result.
    pub warnings: Vec<String>,
    /// Statics: in how many independent directions the equilibrium at the end is unstable; 0 in motion, and where that is not told.
    pub unstable_directions: usize,
    /// Estimated errors; those of [`run_estimated`](crate::run::estimate::run_estimated) only.
    pub accuracy: Accuracy,
}

/// Runs a scene.
///
/// # Errors
/// [`Error::Scene`](crate::error::Error::Scene) for a scene that is not valid; those of its method: see [`integrators`]; [`Error::NotFinite`](crate::error::Error::NotFinite) for a row that is
/// no longer made of numbers.
pub fn run(scene: &Scene) -> Result<Run> {
    run_with_progress(scene, |_| ())
}

/// Runs a scene and tells `on_step`, after each of the times that the scene asks for, how many of [`Scene::steps`] are done.
///
/// # Errors
/// Those of [`run`].
pub fn run_with_progress(scene: &Scene, on_step: impl FnMut(usize)) -> Result<Run> {
    run_planned(scene, &Plan::of(scene), on_step)
}

/// The same with a plan that computes more than the scene needs.
///
/// # Errors
/// Those of [`run`].
pub fn run_planned(scene: &Scene, plan: &Plan, on_step: impl FnMut(usize)) -> Result<Run> {
    run_seen(scene, plan, on_step, |_, _, _| ())
}

/// The same, and `see` is shown the state at the start and after each of [`Scene::steps`].
///
/// # Errors
/// Those of [`run`].
pub(crate) fn run_seen(
    scene: &Scene,
    plan: &Plan,
    mut on_step: impl FnMut(usize),
    mut see: impl FnMut(usize, &Structure, &State),
) -> Result<Run> {
    scene.validate("scene")?;
    let structure = Structure::planned(scene, plan)?;
    let mut counts = Counts::default();
    let mut state = State::at_start(&structure);
    let mut before = state.clone();
    let mut method = integrators::integrator(scene, plan, &structure, &state, &mut counts)?;
    let mut recorder = Recorder::new(scene, plan, &structure, &state, &mut counts)?;

    recorder.record(&state, method.multipliers(), &mut counts)?;
    see(0, &structure, &state);
    let mut watch = Watch::new(scene, &structure);
    // Nothing in this loop asks for memory.
    for step in 1..=scene.steps() {
        let t = scene.time_after(step);
        while state.t < t {
            let works = recorder.works();
            if works {
                before.copy_from(&state);
            }
            method
                .step(&structure, &mut state, t, &mut counts)
                .map_err(|error| watch.cause(&structure, &state, error))?;
            if works {
                match method.work(&structure, &before, &state) {
                    Some(work) => recorder.put_in(work),
                    None => recorder.work(&before, &state),
                }
            }
            if state.t < t || !scene.is_row(step) {
                watch.step(&structure, &state)?;
            }
        }
        if scene.is_row(step) {
            recorder.record(&state, method.multipliers(), &mut counts)?;
            watch.row(&structure, &state)?;
        }
        see(step, &structure, &state);
        on_step(step);
    }
    let mut warnings = warnings(scene);
    let unstable_directions = watch.end(&structure, &state, &mut warnings)?;
    warnings.extend(recorder.doubt());
    let trajectory = recorder.trajectory();
    Ok(Run { trajectory, counts, warnings, unstable_directions, accuracy: Accuracy::default() })
}
