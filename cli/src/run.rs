//! `ancf run`: one scene from its start to its files.

use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::time::Instant;

use ancf::model::Model;
use ancf::run::{Run, Simulation, Trajectory};
use ancf_study::files::{Files, written_lines};
use indicatif::{ProgressBar, ProgressStyle};

use crate::error::{Error, Result};
use crate::frames::Frames;
use crate::options::Options;
use crate::output::{self, Output, Written};
use crate::report;

/// What a run leaves to be told, after its files are written.
pub struct Told {
    /// For people.
    pub text: String,
    /// The summary as one line of JSON, for programs.
    pub line: String,
    /// What ended the run.
    pub error: Option<Error>,
}

/// Runs a model, `name` of which is a built-in scene or a file, and writes its files into `folder`, also those of a run that fails.
///
/// # Errors
/// Bad input; files that cannot be written.
pub fn run(model: &Model, name: &str, options: Options, folder: &Path) -> Result<Told> {
    let scene = model.scene();
    // First, so that a folder that cannot be written is not found after the run.
    let files = Files::in_folder(folder, output::FILES, &[Path::new(name)])?.numbered(&output::NUMBERED);
    let clock = Instant::now();
    let mut output = Output::new(scene, options);
    let mut simulation = match Simulation::new(model.clone()) {
        Ok(simulation) => simulation,
        Err(error) if error.is_bad_input() => return Err(error.into()),
        Err(error) => {
            let run =
                Run { trajectory: Trajectory { columns: scene.columns(), ..Trajectory::default() }, ..Run::default() };
            return failed(files, &output, &run, error, clock.elapsed().as_secs_f64());
        }
    };
    let bar = progress(scene.steps());
    // The time of the run itself, without those that its estimate needs.
    let wall_seconds = Cell::new(0.0);
    output.frames().for_each(|frames: &mut Frames| frames.see(&simulation));
    let on_step = |now: &Simulation| {
        output.frames().for_each(|frames| frames.see(now));
        bar.set_position(now.steps_done() as u64);
        wall_seconds.set(clock.elapsed().as_secs_f64());
    };
    let outcome =
        if options.estimate { simulation.finish_estimated(on_step) } else { simulation.finish_with_progress(on_step) };
    bar.finish_and_clear();
    let wall_seconds = wall_seconds.get();
    match outcome {
        Ok(run) => {
            output.frames().for_each(|frames| frames.end(&simulation));
            let Written { paths, line } = output.write(files, &run, None, wall_seconds)?;
            let text = report::run_text(scene, &run, wall_seconds) + &written_text(&paths);
            Ok(Told { text, line, error: None })
        }
        Err(error) if error.is_bad_input() => Err(error.into()),
        Err(error) => failed(files, &output, &simulation.into_run(), error, wall_seconds),
    }
}

/// The lines that tell a person which files were written, without those that a collection names.
fn written_text(paths: &[PathBuf]) -> String {
    let is_numbered = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "vtu");
    let (numbered, own): (Vec<PathBuf>, Vec<PathBuf>) = paths.iter().cloned().partition(is_numbered);
    let others = match numbered.len() {
        0 => String::new(),
        count => format!("wrote {count} files *.vtu beside them\n"),
    };
    written_lines(&own) + &others
}

/// Writes what there is of a run that failed.
fn failed(files: Files, output: &Output, run: &Run, error: ancf::error::Error, wall_seconds: f64) -> Result<Told> {
    match output.write(files, run, Some(&error), wall_seconds) {
        Ok(Written { line, .. }) => Ok(Told { text: String::new(), line, error: Some(error.into()) }),
        Err(unwritten) => Err(Error::Unwritten { error, unwritten: Box::new(unwritten) }),
    }
}

/// A bar with the time left, on a terminal; nothing in a pipe.
fn progress(steps: usize) -> ProgressBar {
    let bar = ProgressBar::new(steps as u64);
    let style = ProgressStyle::with_template("step {pos}/{len} {bar:30} {eta} left");
    style.map_or(bar.clone(), |style| bar.with_style(style))
}
