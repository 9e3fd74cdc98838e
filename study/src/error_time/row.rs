//! `error-time.csv`: a line for each point.

use std::io::{self, Write};

use serde::{Deserialize, Serialize};

use super::point::{Point, Status};

/// A line; empty where a program does not tell or a run has failed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// "ancf", or another program with its version.
    pub program: String,
    /// The scene.
    pub scene: String,
    /// The element.
    pub element: String,
    /// The method.
    pub method: String,
    /// Elements of each rod.
    pub elements: usize,
    /// Step, s; part of the load in statics.
    pub step: Option<f64>,
    /// Local error of a step, m.
    pub tolerance: Option<f64>,
    /// Where Newton's iteration ends, relative to the largest force.
    pub newton_tolerance: Option<f64>,
    /// Largest distance from the reference at the sample times, m.
    pub error_position: Option<f64>,
    /// R.m.s. over the sample times, m/s.
    pub error_velocity: Option<f64>,
    /// Statics: distance of the support's force from the loads, N.
    pub error_reaction: Option<f64>,
    /// Largest energy balance at the sample times, J.
    pub energy_balance: Option<f64>,
    /// Part of the error that is the step's, m.
    pub error_time: Option<f64>,
    /// Part of the error that is the mesh's, m.
    pub error_space: Option<f64>,
    /// Uncertainty of the reference, m.
    pub reference_uncertainty: f64,
    /// Median of the run times, s.
    pub time_median_s: Option<f64>,
    /// The shortest, s.
    pub time_min_s: Option<f64>,
    /// The longest, s.
    pub time_max_s: Option<f64>,
    /// Number of runs that were timed.
    pub runs: usize,
    /// Steps made.
    pub steps: usize,
    /// Steps taken back.
    pub rejected: Option<usize>,
    /// Iterations of Newton's method.
    pub newton_iterations: usize,
    /// Evaluations of the forces.
    pub force_calls: usize,
    /// Evaluations of the tangent.
    pub tangent_calls: usize,
    /// LU factorisations.
    pub factorizations: usize,
    /// Solutions with given factors.
    pub solves: usize,
    /// What the point is good for.
    pub status: Status,
    /// Why it failed.
    pub reason: String,
}

impl From<&Point> for Row {
    fn from(point: &Point) -> Row {
        let (errors, time, counts) = (point.errors.as_ref(), point.time.as_ref(), &point.counts);
        Row {
            program: point.program.clone(),
            scene: point.scene.clone(),
            element: point.element.clone(),
            method: point.method.clone(),
            elements: point.elements,
            step: point.step,
            tolerance: point.tolerance,
            newton_tolerance: point.newton_tolerance,
            error_position: errors.map(|errors| errors.position),
            error_velocity: errors.and_then(|errors| errors.velocity),
            error_reaction: errors.and_then(|errors| errors.reaction),
            energy_balance: errors.and_then(|errors| errors.energy),
            error_time: errors.and_then(|errors| errors.time),
            error_space: errors.and_then(|errors| errors.space),
            reference_uncertainty: point.reference_uncertainty,
            time_median_s: time.map(|time| time.median),
            time_min_s: time.map(|time| time.min),
            time_max_s: time.map(|time| time.max),
            runs: time.map_or(0, |time| time.runs),
            steps: counts.steps,
            rejected: point.rejected,
            newton_iterations: counts.newton_iterations,
            force_calls: counts.force_calls,
            tangent_calls: counts.tangent_calls,
            factorizations: counts.factorizations,
            solves: counts.solves,
            status: point.status,
            reason: point.reason.clone(),
        }
    }
}

/// Writes the points.
///
/// # Errors
/// What `out` reports.
pub fn write<'a>(out: &mut dyn Write, points: impl Iterator<Item = &'a Point>) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    for point in points {
        writer.serialize(Row::from(point)).map_err(io::Error::other)?;
    }
    writer.flush()
}

/// Reads what [`write()`] has written.
///
/// # Errors
/// Where the text is something else.
pub fn read(text: &str) -> io::Result<Vec<Row>> {
    csv::Reader::from_reader(text.as_bytes()).into_deserialize().map(|row| row.map_err(io::Error::other)).collect()
}
