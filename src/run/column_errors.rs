//! Estimated errors of the columns of a trajectory, from runs with finer steps and meshes.

use super::accuracy::{ColumnAccuracy, Convergence};
use super::observer::{INACCURATE, SAFETY};
use super::trajectory::Trajectory;

/// Ratio of successive changes above which halving does not converge. A method of first order reaches ½.
const NOT_CONVERGING: f64 = 0.7;

/// Factor from the change to the error of all columns but positions: velocities and forces behind a wave front fall by
/// √½ with each halving, so that the error is 1/(1 − √½) changes.
const SAFETY_BEHIND_WAVES: f64 = 3.4;

/// Largest change of each column but the time between a run and a finer one, which may have several rows for each of
/// its own: more load steps. NaN if a value is, or if the rows do not match.
pub(super) fn changes(own: &Trajectory, finer: &Trajectory) -> Vec<f64> {
    let mut largest = vec![0.0; own.columns.len().saturating_sub(1)];
    let [steps, finer_steps] = [own, finer].map(|run| run.rows.len().saturating_sub(1));
    let every = finer_steps.checked_div(steps).unwrap_or(1).max(1);
    if steps * every != finer_steps {
        largest.fill(f64::NAN);
    }
    for (a, b) in own.rows.iter().zip(finer.rows.iter().step_by(every)) {
        for (largest, (a, b)) in largest.iter_mut().zip(a.iter().zip(b).skip(1)) {
            let change = (a - b).abs();
            // In the total order NaN is the largest, and is not lost.
            *largest = if change.total_cmp(largest).is_gt() { change } else { *largest };
        }
    }
    largest
}

/// Errors of all columns, if the run's own trajectory changes by these values in time and in space.
pub(super) fn column_errors(own: &Trajectory, in_time: &[f64], in_space: &[f64]) -> Vec<ColumnAccuracy> {
    let names = own.columns.iter().skip(1);
    let errors = names.zip(in_time.iter().zip(in_space)).map(|(column, (time, space))| {
        let safety = if is_position(column) { SAFETY } else { SAFETY_BEHIND_WAVES };
        ColumnAccuracy {
            column: column.clone(),
            time: safety * time,
            space: safety * space,
            largest: largest(own, group(column)),
            convergence: if (time + space).is_finite() { Convergence::Sure } else { Convergence::Unsure },
        }
    });
    errors.collect()
}

/// Whether no digit of the column's largest value is sure, because of this error. Positions are judged by their motion
/// elsewhere.
pub(super) fn is_unsure(column: &ColumnAccuracy, error: f64) -> bool {
    // A NaN is not small.
    let small = error <= INACCURATE * column.largest;
    !is_position(&column.column) && !small
}

/// Whether a column holds a coordinate or a deflection.
fn is_position(column: &str) -> bool {
    matches!(column.rsplit('.').next(), Some("x" | "y" | "w"))
}

/// Convergence of an unsure column whose change by one halving is `first`, and by the next one `second`.
pub(super) fn convergence(first: f64, second: f64) -> Convergence {
    if second >= NOT_CONVERGING * first { Convergence::None } else { Convergence::Unsure }
}

/// What the columns of a vector have in common, and those of the energies.
fn group(column: &str) -> &str {
    match column.strip_prefix("energy.") {
        Some(_) => "energy.",
        None => column.strip_suffix(['x', 'y']).unwrap_or(column),
    }
}

/// Largest magnitude of the columns of a group.
fn largest(trajectory: &Trajectory, group: &str) -> f64 {
    let places: Vec<usize> =
        (1..trajectory.columns.len()).filter(|&place| self::group(&trajectory.columns[place]) == group).collect();
    let values = trajectory.rows.iter().flat_map(|row| places.iter().filter_map(|&place| row.get(place)));
    values.map(|value| value.abs()).fold(0.0, f64::max)
}
