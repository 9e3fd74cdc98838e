//! Degrees of freedom of an element.

use nalgebra::{DVector, Rotation2, SMatrix, SVector};

use super::node_dofs::NodeDofs;
use crate::elements::Ends;
use crate::linear::NO_UNKNOWN;

/// Unknowns of an element's coordinates.
#[derive(Clone, Debug)]
pub(super) struct ElementDofs<const N: usize> {
    /// Unknown of each coordinate; [`NO_UNKNOWN`] if held.
    pub unknowns: [u32; N],
    /// Nodal vectors with axes of their own: index and rotation to the global axes.
    pub turns: Vec<(usize, Rotation2<f64>)>,
}

impl<const N: usize> ElementDofs<N> {
    pub fn of(vectors: &[NodeDofs]) -> ElementDofs<N> {
        let unknown = |i: usize| vectors[i / 2].unknowns[i % 2].map_or(NO_UNKNOWN, |unknown| unknown as u32);
        let turns = vectors.iter().enumerate().filter_map(|(n, vector)| Some((n, vector.turn?)));
        ElementDofs { unknowns: std::array::from_fn(unknown), turns: turns.collect() }
    }

    /// Coordinates of the element from a vector of unknowns, in global axes.
    #[inline(always)]
    pub fn gather(&self, u: &DVector<f64>) -> SVector<f64, N> {
        let u = u.as_slice();
        let value = |i: usize| u.get(self.unknowns[i] as usize).copied().unwrap_or(0.0);
        let mut gathered = SVector::<f64, N>::from_fn(|i, _| value(i));
        for (n, turn) in &self.turns {
            let own = gathered.fixed_rows::<2>(2 * n).into_owned();
            gathered.fixed_rows_mut::<2>(2 * n).copy_from(&(turn * own));
        }
        gathered
    }

    /// Adds the element's force to a vector of unknowns.
    #[inline(always)]
    pub fn scatter(&self, mut force: SVector<f64, N>, sum: &mut DVector<f64>) {
        for (n, turn) in &self.turns {
            let own = turn.inverse() * force.fixed_rows::<2>(2 * n);
            force.fixed_rows_mut::<2>(2 * n).copy_from(&own);
        }
        let sum = sum.as_mut_slice();
        for (unknown, value) in self.unknowns.iter().zip(&force) {
            if let Some(sum) = sum.get_mut(*unknown as usize) {
                *sum += value;
            }
        }
    }

    /// Matrix of the element in the axes of its nodal vectors.
    pub fn turned(&self, mut matrix: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
        for (n, turn) in &self.turns {
            let rows = turn.inverse() * matrix.fixed_rows::<2>(2 * n);
            matrix.fixed_rows_mut::<2>(2 * n).copy_from(&rows);
            let columns = matrix.fixed_columns::<2>(2 * n) * turn;
            matrix.fixed_columns_mut::<2>(2 * n).copy_from(&columns);
        }
        matrix
    }

    /// Evaluates a function of both ends of a step for this element.
    #[inline(always)]
    pub fn over<T>(&self, ends: &Ends<DVector<f64>>, f: impl Fn(&Ends<SVector<f64, N>>) -> T) -> T {
        let (u_0, u_1) = (self.gather(ends.u_0), self.gather(ends.u_1));
        f(&Ends { u_0: &u_0, u_1: &u_1, thermal_0: ends.thermal_0, thermal_1: ends.thermal_1 })
    }
}
