//! Independent jobs on all cores.

use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::error::Result;

/// Does all jobs on all cores, in the order given, with a progress bar on a terminal.
pub fn in_parallel<J: Sync, R: Send>(
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
