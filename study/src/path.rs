//! Paths of points: read from a run, and compared.

use ancf::run::Run;

/// Positions of a point, or other vectors, over time.
pub type Path = Vec<[f64; 2]>;

/// Two columns of a probe: `["x", "y"]`, or others.
pub fn columns(run: &Run, probe: &str, suffixes: [&str; 2]) -> Path {
    let [x, y] = suffixes.map(|suffix| column(run, &format!("{probe}.{suffix}")));
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

/// Positions of a probe.
pub fn positions(run: &Run, probe: &str) -> Path {
    columns(run, probe, ["x", "y"])
}

/// Positions of the probe `tip`.
pub fn tip(run: &Run) -> Path {
    positions(run, "tip")
}

/// Last position of the probe `tip`; NaN if there is none.
pub fn last_tip(run: &Run) -> [f64; 2] {
    tip(run).last().copied().unwrap_or([f64::NAN; 2])
}

/// A column of a run; empty if there is none of that name.
pub fn column(run: &Run, name: &str) -> Vec<f64> {
    run.trajectory.column(name).unwrap_or_default()
}

/// Last value of a column; NaN if there is none.
pub fn last(run: &Run, name: &str) -> f64 {
    column(run, name).last().copied().unwrap_or(f64::NAN)
}

/// Largest |value| of a column; NaN if a value is not a number or there is none.
pub fn largest(run: &Run, name: &str) -> f64 {
    largest_of(column(run, name).into_iter().map(f64::abs))
}

/// Largest value; NaN if one is not a number or there is none.
pub fn largest_of(values: impl Iterator<Item = f64>) -> f64 {
    // In the total order NaN is the largest, and is not lost.
    values.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

/// Distance of two points.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Largest distance of two paths; NaN if one is longer, empty, or has a NaN.
pub fn largest_distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    if a.len() != b.len() {
        return f64::NAN;
    }
    largest_of(a.iter().zip(b).map(|(a, b)| distance(*a, *b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nan_is_not_lost() {
        assert!(largest_distance(&[[0.0; 2], [f64::NAN, 0.0], [9.0, 0.0]], &[[0.0; 2]; 3]).is_nan());
        assert!(largest_distance(&[[0.0; 2]; 2], &[[0.0; 2]; 3]).is_nan() && largest_distance(&[], &[]).is_nan());
        assert_eq!(largest_distance(&[[0.0; 2], [3.0, 4.0]], &[[0.0; 2]; 2]), 5.0);
    }
}
