//! Verdict on the stability of a motion: a run with a small deviation at the start, beside the run itself.
//!
//! A motion that is unstable, like a straight rod above its buckling load, is decided by rounding: it may stay straight
//! in one direction of the frame, and bow in another. No finer step or mesh shows that. The perturbed run begins with a
//! smooth displacement of 10⁻⁸ of the structure's size ([`Structure::perturbation`](crate::structure::Structure::perturbation)).
//! In a stable structure it vibrates at that size, or drifts slowly. A deviation that has grown a hundredfold, and moves
//! a column by more than its estimated error or leaves no digit of a motion, is refused.

use super::accuracy::ColumnAccuracy;
use super::column_errors::changes;
use super::observer::{INACCURATE, Observations, Observer};
use super::result::Run;
use super::simulation::Simulation;
use crate::error::{Error, Result};
use crate::model::Model;

/// Deviation at the start, relative to the structure's size.
const DEVIATION: f64 = 1e-8;

/// Growth of the deviation below which a motion is stable.
const STABLE: f64 = 100.0;

/// Period below which vibrations are filtered out of the deviation, relative to the duration: they would show in
/// velocities and forces, and say nothing of stability.
const SHORTEST_PERIOD: f64 = 1e-3;

/// Errors of observed quantities and of columns.
pub(super) struct Errors<'a> {
    pub observed: Vec<f64>,
    pub columns: &'a [ColumnAccuracy],
}

/// Runs the perturbed structure; returns the growth of the deviation.
///
/// # Errors
/// [`Error::UnstableMotion`] where the deviation decides the result; [`Error::NoEstimate`] where the perturbed run
/// fails.
pub(super) fn amplification(
    observer: &Observer,
    model: Model,
    own: &Run,
    seen: &Observations,
    errors: &Errors,
) -> Result<f64> {
    let (size, end) = (DEVIATION * observer.scene.size(), observer.scene.time.end);
    let what = format!("a deviation of {size:.0e} m at the start");
    let (perturbed, seen_of_it) = Simulation::perturbed(model, size, SHORTEST_PERIOD * end)
        .and_then(|mut run| observer.run_with_progress(&mut run, |_| ()))
        .map_err(|error| Error::NoEstimate { what, reason: error.to_string() })?;
    let distances = observer.distances(seen, &seen_of_it, |_| true);
    // In the total order NaN is the largest, and is not lost.
    let amplification = distances.iter().copied().max_by(f64::total_cmp).unwrap_or(0.0) / size;
    if amplification <= STABLE {
        return Ok(amplification);
    }
    let motions = observer.motions(seen);
    let observed = distances.iter().zip(&errors.observed).zip(motions).enumerate();
    let of_observed =
        observed.map(|(n, ((moved, error), motion))| (observer.name(n), *moved, error.min(INACCURATE * motion)));
    let moved = changes(&own.trajectory, &perturbed.trajectory);
    // The deviation itself changes the energies at the start.
    let at_start = |column: usize| {
        let values = [own, &perturbed].map(|run| run.trajectory.rows.first().and_then(|row| row.get(column + 1)));
        values[0].zip(values[1]).map_or(0.0, |(own, perturbed)| STABLE * (own - perturbed).abs())
    };
    let of_columns = errors
        .columns
        .iter()
        .zip(moved)
        .enumerate()
        .map(|(n, (column, moved))| (column.column.clone(), moved, column.total().max(at_start(n))));
    let exceeds = |(_, moved, error): &(String, f64, f64)| {
        let within = moved <= error;
        // A NaN is not within an error.
        !within
    };
    let worst = of_observed.chain(of_columns).filter(exceeds);
    match worst.max_by(|(_, a, error_a), (_, b, error_b)| (a / error_a).total_cmp(&(b / error_b))) {
        Some((place, moved, error)) => {
            Err(Error::UnstableMotion { deviation: size, amplification, place, moved, error })
        }
        None => Ok(amplification),
    }
}
