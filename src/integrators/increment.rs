//! Unknown increment of an implicit step, with the buffers of Newton's iteration.

use nalgebra::DVector;

use super::newton::Failure;
use crate::elements::ThermalStrain;
use crate::error::Error;
use crate::linear::SingularAt;
use crate::structure::{Factors, Structure};

/// Unknown increment over a known displacement, with the buffers of Newton's iteration.
#[derive(Debug)]
pub struct Increment {
    /// Unknown increment, with multipliers in their entries.
    pub du: DVector<f64>,
    /// Displacement: the known one plus the increment.
    pub u: DVector<f64>,
    /// Residual.
    pub residual: DVector<f64>,
    /// Last improvement of `du`.
    improvement: DVector<f64>,
    /// Factors of the matrix.
    pub factors: Factors,
}

impl Increment {
    /// Allocates the increment of a structure.
    pub fn new(structure: &Structure) -> Increment {
        let zeros = || DVector::zeros(structure.size());
        Increment { du: zeros(), u: zeros(), residual: zeros(), improvement: zeros(), factors: structure.factors() }
    }

    /// Sets `u` to the known displacement `u_0` plus the increment.
    pub fn move_from(&mut self, u_0: &DVector<f64>) {
        self.u.copy_from(u_0);
        self.u += &self.du;
    }

    /// Whether every entry of the residual is within `times` the rounding error of the elastic forces.
    pub fn at_rounding(&self, structure: &Structure, thermal: &[ThermalStrain], times: f64) -> bool {
        structure.within_rounding(&self.residual, &self.u, thermal, times)
    }

    /// Applies an improvement, see [`Equations::improve`](super::newton::Equations::improve).
    pub fn improve(&mut self) {
        self.improvement.copy_from(&self.residual);
        self.factors.solve(&mut self.improvement);
        self.du -= &self.improvement;
    }

    /// Last improvement, which was subtracted.
    pub fn improvement(&self) -> &DVector<f64> {
        &self.improvement
    }

    /// Takes the last improvement back, see [`Equations::undo`](super::newton::Equations::undo).
    pub fn undo(&mut self) {
        self.du += &self.improvement;
    }
}

/// Error of a failed step that ends at `time`; several stages may share a tangent.
pub fn step_failed(failure: Failure, structure: &Structure, time: f64, shared_tangent: bool) -> Error {
    match failure {
        Failure::NotConverged { iterations, residual, tolerance, at_rounding } => {
            Error::NewtonFailed { time, iterations, residual, tolerance, at_rounding, shared_tangent }
        }
        Failure::Singular { iteration, at: SingularAt(unknown) } => {
            Error::Singular { time, iteration, place: structure.location(unknown) }
        }
    }
}
