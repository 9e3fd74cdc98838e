//! The matrices that methods ask a structure for, and their factors.

use nalgebra::DVector;

use super::mesh::ElementMatrix;
use super::{StepEnds, of_rod};
use crate::kernel::ThermalStrain;
use crate::linear::{BorderedLu, Chains};

/// A matrix that is factorised.
#[derive(Debug)]
pub enum Matrix<'a> {
    /// `stiffness` · (tangent, with the constraints' forces where there are multipliers) + `mass` · M.
    Tangent {
        /// Displacement.
        u: &'a DVector<f64>,
        /// Thermal strains of the rods.
        thermal: &'a [ThermalStrain],
        /// Factor of the tangent.
        stiffness: f64,
        /// Factor of M.
        mass: f64,
    },
    /// The tangent of Newton's iteration with independent stresses: those that it expected when it went from `before` to `u`
    /// ([`Beam::mixed_tangent`](crate::kernel::Beam::mixed_tangent)).
    Mixed {
        /// Displacement before the last iteration.
        before: &'a DVector<f64>,
        /// Displacement.
        u: &'a DVector<f64>,
        /// Thermal strains of the rods.
        thermal: &'a [ThermalStrain],
    },
    /// The derivative of [`mean_force`](super::Structure::mean_force) with respect to `u_1`, + `mass` · M.
    Mean {
        /// The step.
        ends: StepEnds<'a>,
        /// Factor of M.
        mass: f64,
    },
}

impl<'a> Matrix<'a> {
    pub(super) fn of_rod(&self, rod: usize) -> ElementMatrix<'a> {
        match *self {
            Matrix::Tangent { u, thermal, stiffness, mass } => {
                ElementMatrix::Tangent { u, eps_t: thermal[rod], stiffness, mass }
            }
            Matrix::Mixed { before, u, thermal } => ElementMatrix::Mixed { before, u, eps_t: thermal[rod] },
            Matrix::Mean { ref ends, mass } => ElementMatrix::Mean { ends: of_rod(ends, rod), mass },
        }
    }

    /// The factor of Φ_qᵀ beside it.
    pub(super) fn constraint_factor(&self) -> f64 {
        if let Matrix::Tangent { stiffness, .. } = self { *stiffness } else { 1.0 }
    }
}

/// LU factors of a structure's matrix, or memory for them.
#[derive(Debug)]
pub enum Factors {
    /// In the condensed form.
    Chains(Chains),
    /// With multipliers.
    Bordered(Option<BorderedLu>),
}

impl Factors {
    /// Solves A x = b in place. Without factors the solution is not a number.
    pub fn solve(&self, b: &mut DVector<f64>) {
        match self {
            Factors::Chains(chains) => chains.solve(b),
            Factors::Bordered(Some(factors)) => factors.solve(b),
            Factors::Bordered(None) => b.fill(f64::NAN),
        }
    }
}
