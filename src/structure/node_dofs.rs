//! Where a nodal vector is among the unknowns.

use nalgebra::{DVector, Rotation2, Vector2};

/// Where the components of a nodal vector are among the unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NodeDofs {
    /// `None` where a support holds the component.
    pub unknowns: [Option<usize>; 2],
    /// From the vector's own axes to the global ones, where they differ.
    pub turn: Option<Rotation2<f64>>,
}

impl NodeDofs {
    /// The nodal vector in a vector of unknowns, in global axes; zero where it is held.
    pub fn get(&self, u: &DVector<f64>) -> Vector2<f64> {
        let own = Vector2::from(self.unknowns.map(|unknown| unknown.map_or(0.0, |unknown| u[unknown])));
        self.turn.map_or(own, |turn| turn * own)
    }

    /// Adds a nodal vector, in global axes, to the unknowns; what is held takes none.
    pub fn add(&self, vector: &Vector2<f64>, sum: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                sum[unknown] += value;
            }
        }
    }

    /// Puts a nodal vector, in global axes, in its place.
    pub fn set(&self, vector: &Vector2<f64>, u: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                u[unknown] = *value;
            }
        }
    }
}
