//! The main job: the paper's Section 3, recomputed and compared with the oracles.

mod figure;
mod oracle;
mod pendulum;
mod table;

use std::path::Path;
use std::time::Instant;

use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::Serialize;

use crate::error::{Error, Result};
use crate::report::{self, Files};

/// `main.json`.
#[derive(Serialize)]
struct Report {
    wall_seconds: f64,
    oracle: Vec<oracle::Row>,
    tip: Vec<pendulum::Row>,
}

/// Runs the pendulum of Table 1 in all its models, hands tables to `print`, and writes pictures and `main.json` to `out`.
///
/// # Errors
/// [`Error::Comparison`] when a run misses the oracle: the files are written all the same. Those of the runs themselves.
pub fn main_job(out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    let clock = Instant::now();
    // First, so that a folder that cannot be written is not found after the work.
    let mut files = Files::in_folder(out)?;
    let oracle = oracle::load()?;
    print("Peng et al. (2018), Section 3: the heated pendulum of Table 1\n\n")?;

    let rows = oracle::compare(&oracle)?;
    print(&table::oracle(&rows))?;
    let models = pendulum::simulate()?;
    print(&table::tips(&models, &oracle))?;
    print(&table::differences(&models))?;

    for (name, svg) in pendulum::pictures(&models, &oracle.rigid)? {
        files.write(name, |file| file.write_all(svg.as_bytes()))?;
    }
    files.write("pendulum.csv", |file| report::write_csv(file, &pendulum::curves(&models)))?;
    let failed: Vec<String> = rows.iter().filter(|row| !row.holds()).map(ToString::to_string).collect();
    let report = Report {
        wall_seconds: clock.elapsed().as_secs_f64(),
        oracle: rows,
        tip: models.iter().flat_map(pendulum::Model::rows).collect(),
    };
    files.write("main.json", |file| Ok(serde_json::to_writer_pretty(file, &report)?))?;
    let paths = files.publish()?;
    print(&table::written(&paths, report.wall_seconds))?;
    match failed.first() {
        None => Ok(()),
        Some(first) => Err(Error::Comparison { count: failed.len(), first: first.clone() }),
    }
}

/// Does all jobs on all cores, in the order given, with a progress bar on a terminal.
fn in_parallel<J: Sync, R: Send>(
    what: &'static str,
    jobs: &[J],
    f: impl Fn(&J) -> Result<R> + Sync + Send,
) -> Result<Vec<R>> {
    let style = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}, {eta} left");
    let bar = ProgressBar::new(jobs.len() as u64).with_message(what);
    let bar = style.map_or(bar.clone(), |style| bar.with_style(style));
    let results = jobs.par_iter().progress_with(bar.clone()).map(f).collect();
    bar.finish_and_clear();
    results
}
