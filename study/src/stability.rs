//! `ancf stability`: stiff and extreme cases in one table, each row right, refused with a reason, or WRONG.
//!
//! A [`Case`] sweeps one parameter until the method breaks, or says why it does not. Its reference is a closed form, a fixture, or
//! another method with its own uncertainty; its bound is derived where the case is written, in words that stand beside each row.
//! A kept energy balance makes no row right but its own.

mod axis;
mod bad_structure;
pub mod case;
mod collapsed;
mod estimate_check;
mod explicit_with_a_hinge;
mod far_from_origin;
mod fine_mesh;
mod heat;
mod helpers;
mod inclined;
mod loads_that_move_nothing;
mod long_run;
mod page;
mod picture;
mod poisson;
mod richardson;
pub mod rigid;
mod rotation;
pub mod row;
mod shock;
mod singular;
mod slender;
mod soft_and_stiff;
mod step_size;
mod stiff;
mod text;
mod units;

use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use crate::error::{Error, Result};
use crate::files::Files;
use crate::parallel::in_parallel;
use case::{CASES, Case, Trial};
use row::{Row, Verdict};

/// `stability.json`.
#[derive(Debug, Serialize)]
pub struct Study {
    /// How long it took, s.
    pub wall_seconds: f64,
    /// The cases, in the order of the table.
    pub cases: Vec<Swept>,
}

/// A case with its rows.
#[derive(Debug, Serialize)]
pub struct Swept {
    /// What is swept, against what, and what right means.
    #[serde(flatten)]
    pub case: &'static Case,
    /// A row for each value of the parameter and each variant.
    pub rows: Vec<Row>,
}

/// Which trials are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// Those that take no time.
    Fast,
    /// All.
    Full,
}

/// `ancf stability`: runs the cases, prints and writes.
///
/// # Errors
/// [`Error::Scene`] for a case that is not in the table, [`Error::Comparison`] for rows that are WRONG: the files are written all the
/// same; [`Error::Write`]. Runs that fail are rows.
pub fn study(names: &[String], out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    // First, so that a folder that cannot be written is not found after the work.
    let mut files = Files::in_folder(out)?;
    let study = measure(names, Reach::Full)?;
    print(&text::table(&study))?;
    write(&study, &mut files)?;
    let paths = files.publish()?;
    print(&paths.iter().map(|path| format!("wrote {}\n", path.display())).collect::<String>())?;
    print(&format!("{:.1} s in all\n", study.wall_seconds))?;
    let wrong: Vec<String> = study.wrong().map(Row::line).collect();
    match wrong.first() {
        None => Ok(()),
        Some(first) => Err(Error::Comparison { count: wrong.len(), first: first.clone() }),
    }
}

/// The fast rows, as a part of the main job: prints how many of each case are right, writes with the other files; the rows that are
/// WRONG, and the picture.
///
/// # Errors
/// Those of [`study`].
pub fn part(files: &mut Files, print: impl Fn(&str) -> Result<()>) -> Result<(Vec<String>, String)> {
    let study = measure(&[], Reach::Fast)?;
    print(&text::summary(&study))?;
    let svg = write(&study, files)?;
    Ok((study.wrong().map(Row::line).collect(), svg))
}

fn write(study: &Study, files: &mut Files) -> Result<String> {
    let svg = picture::svg(&study.cases)?;
    let html = page::page(study, &svg);
    files.write("stability.csv", |file| row::write(file, study.rows()))?;
    files.write("stability.json", |file| Ok(serde_json::to_writer_pretty(file, study)?))?;
    files.write("stability.svg", |file| file.write_all(svg.as_bytes()))?;
    files.write("stability.html", |file| file.write_all(html.as_bytes()))?;
    Ok(svg)
}

/// Runs the named cases, or all of them.
///
/// # Errors
/// [`Error::Scene`] for a case that is not in the table; [`Error::Fixture`] for a reference that cannot be used.
pub fn measure(names: &[String], reach: Reach) -> Result<Study> {
    let clock = Instant::now();
    let cases = Case::named(names)?;
    let mut jobs: Vec<(&'static Case, Trial)> = Vec::new();
    for case in &cases {
        let trials = (case.trials)()?;
        jobs.extend(trials.into_iter().filter(|trial| reach == Reach::Full || trial.fast).map(|trial| (*case, trial)));
    }
    let rows = in_parallel("stability", &jobs, |(case, trial)| Ok(trial.row(case)))?;
    let mut rows = jobs.iter().zip(rows);
    let mut swept: Vec<Swept> = cases.into_iter().map(|case| Swept { case, rows: Vec::new() }).collect();
    for case in &mut swept {
        let own = rows.clone().take_while(|((of, _), _)| std::ptr::eq(*of, case.case)).count();
        case.rows = rows.by_ref().take(own).map(|(_, row)| row).collect();
    }
    Ok(Study { wall_seconds: clock.elapsed().as_secs_f64(), cases: swept })
}

impl Study {
    /// All rows.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.cases.iter().flat_map(|case| &case.rows)
    }

    /// Those that are neither right nor refused with a reason.
    pub fn wrong(&self) -> impl Iterator<Item = &Row> {
        self.rows().filter(|row| row.verdict == Verdict::Wrong)
    }
}

/// Names of the cases.
pub fn names() -> impl Iterator<Item = &'static str> {
    CASES.iter().map(|case| case.name)
}
