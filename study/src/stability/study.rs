//! The study of stiff and extreme cases: its cases with their rows.

use std::time::Instant;

use serde::Serialize;

use super::case::{Case, Trial};
use super::cases::named;
use super::row::{StabilityRow, Verdict};
use crate::error::Result;
use crate::parallel::in_parallel;

/// The content of `stability.json`.
#[derive(Debug, Serialize)]
pub struct StabilityStudy {
    /// Run time of the study, s.
    pub wall_seconds: f64,
    /// The cases, in the order of the table.
    pub cases: Vec<Swept>,
}

/// A case with its rows.
#[derive(Debug, Serialize)]
pub struct Swept {
    /// The case: parameter, reference and the meaning of right.
    #[serde(flatten)]
    pub case: &'static Case,
    /// A row for each value of the parameter and each variant.
    pub rows: Vec<StabilityRow>,
}

/// Which trials are run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Subset {
    /// Those that take almost no time.
    Fast,
    /// All.
    Full,
}

/// Runs the named cases, or all of them.
///
/// # Errors
/// [`Error::Name`](crate::error::Error::Name) for an unknown case.
pub fn measure(names: &[String], subset: Subset) -> Result<StabilityStudy> {
    let clock = Instant::now();
    let cases = named(names)?;
    let trials_of = |number: usize| (cases[number].trials)().into_iter().map(move |trial| (number, trial));
    let wanted = |(_, trial): &(usize, Trial)| subset == Subset::Full || trial.fast;
    let jobs: Vec<(usize, Trial)> = (0..cases.len()).flat_map(trials_of).filter(wanted).collect();
    let rows = in_parallel("stability", &jobs, |(number, trial)| Ok(trial.row(cases[*number])))?;
    let mut swept: Vec<Swept> = cases.into_iter().map(|case| Swept { case, rows: Vec::new() }).collect();
    for ((number, _), row) in jobs.iter().zip(rows) {
        swept[*number].rows.push(row);
    }
    Ok(StabilityStudy { wall_seconds: clock.elapsed().as_secs_f64(), cases: swept })
}

impl StabilityStudy {
    /// All rows.
    pub fn rows(&self) -> impl Iterator<Item = &StabilityRow> {
        self.cases.iter().flat_map(|case| &case.rows)
    }

    /// The rows that are WRONG.
    pub fn wrong(&self) -> impl Iterator<Item = &StabilityRow> {
        self.rows().filter(|row| row.verdict == Verdict::Wrong)
    }
}
