//! Independent jobs on all cores, and progress bars.

use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::error::Result;

/// A progress bar with the time left; it shows on a terminal, and not in a pipe.
pub fn progress_bar(what: &'static str, length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}, {eta} left");
    let bar = ProgressBar::new(length as u64).with_message(what);
    style.map_or(bar.clone(), |style| bar.with_style(style))
}

/// Results of all jobs in the order given, computed on all cores.
pub fn in_parallel<J: Sync, R: Send>(
    what: &'static str,
    jobs: &[J],
    f: impl Fn(&J) -> Result<R> + Sync + Send,
) -> Result<Vec<R>> {
    let bar = progress_bar(what, jobs.len());
    let results = match rayon::ThreadPoolBuilder::new().build() {
        Ok(pool) => pool.install(|| jobs.par_iter().progress_with(bar.clone()).map(f).collect()),
        // Where the system gives no threads, this one does the work.
        Err(_) => jobs.iter().map(|job| f(job).inspect(|_| bar.inc(1))).collect(),
    };
    bar.finish_and_clear();
    results
}
