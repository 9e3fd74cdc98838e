//! Degrees of freedom of a nodal vector.

use nalgebra::{DVector, Rotation2, Vector2};

/// Unknowns of a nodal vector's components.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NodeDofs {
    /// Unknown of each component; `None` if a support holds it.
    pub unknowns: [Option<usize>; 2],
    /// Rotation from the vector's own axes to the global ones, if they differ.
    pub turn: Option<Rotation2<f64>>,
}

impl NodeDofs {
    /// Nodal vector from a vector of unknowns, in global axes; zero where held.
    pub fn get(&self, u: &DVector<f64>) -> Vector2<f64> {
        let own = Vector2::from(self.unknowns.map(|unknown| unknown.map_or(0.0, |unknown| u[unknown])));
        self.turn.map_or(own, |turn| turn * own)
    }

    /// Adds a nodal vector, in global axes, to a vector of unknowns; held components are dropped.
    pub fn add(&self, vector: &Vector2<f64>, sum: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                sum[unknown] += value;
            }
        }
    }

    /// Writes a nodal vector, in global axes, into a vector of unknowns; held components are dropped.
    pub fn set(&self, vector: &Vector2<f64>, u: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                u[unknown] = *value;
            }
        }
    }
}
