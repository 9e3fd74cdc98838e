//! Rotation of rods as a whole.

use nalgebra::{DVector, Vector2};

use super::Structure;

impl Structure {
    /// Largest angular velocity of a rod's chord at displacement `u` and velocity `v`, rad/s, and the rod's name. 0 for
    /// chords without length.
    pub fn fastest_rotation(&self, u: &DVector<f64>, v: &DVector<f64>) -> (f64, &str) {
        let of_rods = self.rods.iter().map(|rod| {
            let across = |x: &DVector<f64>| {
                let ends = [rod.positions().next(), rod.positions().last()];
                let [first, last] = ends.map(|node| node.map_or(Vector2::zeros(), |node| node.get(x)));
                last - first
            };
            let chord = rod.along * rod.elements as f64 + across(u);
            let turning = chord.perp(&across(v)) / chord.norm_squared();
            (if turning.is_finite() { turning.abs() } else { 0.0 }, rod.name.as_str())
        });
        of_rods.max_by(|(a, _), (b, _)| a.total_cmp(b)).unwrap_or((0.0, ""))
    }
}
