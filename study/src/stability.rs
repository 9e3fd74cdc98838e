//! `ancf stability`: stiff and extreme cases in one table, each row right, refused with a reason, or WRONG.
//!
//! A [`Case`] sweeps one parameter until the method breaks, or states why it does not. Its reference is a closed form, a fixture, or
//! another method with its own uncertainty. Its bound is derived where the case is written, and the derivation is printed with the rows.
//! An energy balance that is kept makes no other row right.

mod bad_structure;
mod case;
mod cases;
mod collapsed;
mod estimate_check;
mod explicit_with_a_hinge;
mod far_from_origin;
mod fine_mesh;
mod heat;
mod implicit;
mod inclined;
mod loads_that_move_nothing;
mod long_run;
mod picture;
mod poisson;
mod prelude;
mod report;
mod richardson;
mod rigid_pendulum;
mod rotation_free;
mod rotation_over_the_top;
mod row;
mod shock;
mod single_element;
mod singular;
mod slender;
mod soft_and_stiff;
mod step_size;
mod steps;
mod stiff;
mod study;
mod units;

use std::path::Path;

use crate::error::{Error, Result};
use crate::files::{Files, written_lines};
pub use case::Case;
pub use cases::names;
pub(crate) use report::counts_table;
pub use row::{StabilityRow, Verdict};
pub use study::{StabilityStudy, Subset, Swept, measure};

/// Files that the study writes.
pub(crate) const FILES: [&str; 4] = ["stability.csv", "stability.json", "stability.svg", "stability.html"];

/// `ancf stability`: runs the cases, prints the table and writes the files.
///
/// # Errors
/// [`Error::Name`] for an unknown case, [`Error::Comparison`] for rows that are WRONG (the files are written all the same), [`Error::Write`].
/// Runs that fail are rows.
pub fn study(names: &[String], out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    // First, so that a folder that cannot be written is found before the work.
    let mut files = Files::in_folder(out, FILES, &[])?;
    let study = measure(names, Subset::Full)?;
    print(&report::text(&study))?;
    write(&study, &mut files)?;
    print(&written_lines(&files.publish()?))?;
    print(&format!("{:.1} s in all\n", study.wall_seconds))?;
    let mut wrong = study.wrong();
    match wrong.next() {
        None => Ok(()),
        Some(first) => Err(Error::Comparison { count: 1 + wrong.count(), first: first.line() }),
    }
}

/// The fast rows as a part of the main job: adds to its files. Returns the study and the picture.
pub(crate) fn part(files: &mut Files) -> Result<(StabilityStudy, String)> {
    let study = measure(&[], Subset::Fast)?;
    let svg = write(&study, files)?;
    Ok((study, svg))
}

fn write(study: &StabilityStudy, files: &mut Files) -> Result<String> {
    let svg = picture::svg(&study.cases)?;
    files.write_table("stability.csv", |file| report::csv(study).csv(file))?;
    files.write_json("stability.json", study)?;
    files.write_text("stability.svg", svg.clone())?;
    files.write_text("stability.html", report::page(study, &svg))?;
    Ok(svg)
}
