//! Where a run ended, and by how much its energies miss their balance.

use ancf::internals::model::ENERGY_COLUMNS;
use ancf::run::{Run, Trajectory};

/// Column of the load factor, where it is a result.
pub const LOAD: &str = "load";

/// Time of the last row, s; the load factor in statics.
pub fn final_time(run: &Run) -> Option<f64> {
    let load = run.trajectory.column(LOAD).and_then(|loads| loads.last().copied());
    load.or_else(|| run.trajectory.rows.last().and_then(|row| row.first()).copied())
}

/// Names and values of the probes' columns in the last row.
pub fn final_values(run: &Run) -> impl Iterator<Item = (&str, f64)> {
    let last = run.trajectory.rows.last().into_iter().flatten().copied();
    let columns = run.trajectory.columns.iter().map(String::as_str).zip(last);
    columns.skip(1).filter(|(name, _)| *name != LOAD && !ENERGY_COLUMNS.contains(name))
}

/// Largest |`energy.balance`| over the rows, J; `None` if there is no such column.
pub fn energy_imbalance(trajectory: &Trajectory) -> Option<f64> {
    largest_of(trajectory, "energy.balance")
}

/// Largest |value| of a column.
pub fn largest_of(trajectory: &Trajectory, column: &str) -> Option<f64> {
    // In the total order NaN is the largest, and is not lost.
    trajectory.column(column)?.into_iter().map(f64::abs).max_by(f64::total_cmp)
}
