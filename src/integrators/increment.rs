//! The unknown of an implicit step of a structure, with what Newton's iteration needs beside it.

use nalgebra::DVector;

use super::newton::Failure;
use crate::elements::ThermalStrain;
use crate::error::Error;
use crate::linear::SingularAt;
use crate::structure::{Factors, Structure};

/// The unknown of a step, what is added to a displacement that is known before, with what an iteration needs beside it.
#[derive(Debug)]
pub struct Increment {
    /// The unknown, with multipliers in their places.
    pub du: DVector<f64>,
    /// The known displacement with it.
    pub u: DVector<f64>,
    /// What should vanish.
    pub value: DVector<f64>,
    /// The last improvement of `du`.
    improvement: DVector<f64>,
    /// Of the matrix.
    pub factors: Factors,
}

impl Increment {
    /// Workspace for a structure's increments.
    pub fn new(structure: &Structure) -> Increment {
        let zeros = || DVector::zeros(structure.size());
        Increment { du: zeros(), u: zeros(), value: zeros(), improvement: zeros(), factors: structure.factors() }
    }

    /// Moves `u` to the increment from the known displacement `u_0`.
    pub fn move_from(&mut self, u_0: &DVector<f64>) {
        self.u.copy_from(u_0);
        self.u += &self.du;
    }

    /// Whether no entry of what should vanish is above `times` the rounding error of the elastic forces.
    pub fn at_rounding(&self, structure: &Structure, thermal: &[ThermalStrain], times: f64) -> bool {
        structure.within_rounding(&self.value, &self.u, thermal, times)
    }

    /// [`Equations::improve`](super::newton::Equations::improve).
    pub fn improve(&mut self) {
        self.improvement.copy_from(&self.value);
        self.factors.solve(&mut self.improvement);
        self.du -= &self.improvement;
    }

    /// [`Equations::undo`](super::newton::Equations::undo).
    pub fn undo(&mut self) {
        self.du += &self.improvement;
    }
}

/// The error of a step that ends at `time`.
pub fn step_failed(failure: Failure, structure: &Structure, time: f64) -> Error {
    match failure {
        Failure::NotConverged { iterations, residual, tolerance, at_rounding } => {
            Error::NewtonFailed { time, iterations, residual, tolerance, at_rounding }
        }
        Failure::Singular { iteration, at: SingularAt(unknown) } => {
            Error::Singular { time, iteration, place: structure.place(unknown) }
        }
    }
}
