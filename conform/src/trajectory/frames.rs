//! A motion at some times: positions and velocities of points, energies.

use std::collections::BTreeMap;

/// Vectors of a point, one for each time.
pub type Path = Vec<[f64; 2]>;

/// Positions and velocities of points, and energies, at some times.
#[derive(Clone, Debug, Default)]
pub struct Frames {
    /// The times, s.
    pub t: Vec<f64>,
    /// Positions by point, m.
    pub position: BTreeMap<String, Path>,
    /// Velocities by point, m/s.
    pub velocity: BTreeMap<String, Path>,
    /// Energies by name (kinetic, strain, potential, input), J.
    pub energy: BTreeMap<String, Vec<f64>>,
}

/// Largest difference of two motions.
#[derive(Clone, Debug, PartialEq)]
pub struct Farthest {
    /// Index of the time.
    pub at: usize,
    /// Point.
    pub point: String,
    /// Distance.
    pub distance: f64,
}

impl Frames {
    /// The frames with these indices.
    pub fn picked(&self, indices: &[usize]) -> Frames {
        fn of<T: Clone>(table: &BTreeMap<String, Vec<T>>, indices: &[usize]) -> BTreeMap<String, Vec<T>> {
            let picked = |list: &Vec<T>| indices.iter().filter_map(|n| list.get(*n).cloned()).collect();
            table.iter().map(|(name, list)| (name.clone(), picked(list))).collect()
        }
        Frames {
            t: indices.iter().filter_map(|n| self.t.get(*n).copied()).collect(),
            position: of(&self.position, indices),
            velocity: of(&self.velocity, indices),
            energy: of(&self.energy, indices),
        }
    }
}

/// Largest distance of two tables of paths, over the points and times that both have; `None` if they have none.
pub fn farthest(a: &BTreeMap<String, Path>, b: &BTreeMap<String, Path>) -> Option<Farthest> {
    let mut worst: Option<Farthest> = None;
    for (point, path) in a {
        let Some(other) = b.get(point) else { continue };
        for (at, (p, q)) in path.iter().zip(other).enumerate() {
            let distance = (p[0] - q[0]).hypot(p[1] - q[1]);
            // A distance that is not a number is the largest of all.
            if worst.as_ref().is_none_or(|worst| distance > worst.distance || distance.is_nan()) {
                worst = Some(Farthest { at, point: point.clone(), distance });
            }
        }
    }
    worst
}

/// Largest distance; infinite where nothing can be compared, or where one ends before the other.
pub fn distance(a: &BTreeMap<String, Path>, b: &BTreeMap<String, Path>) -> f64 {
    let shorter = a.iter().any(|(point, path)| b.get(point).is_some_and(|other| other.len() < path.len()));
    match farthest(a, b) {
        Some(worst) if !shorter && worst.distance.is_finite() => worst.distance,
        _ => f64::INFINITY,
    }
}

/// Largest difference of two lists.
pub fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
