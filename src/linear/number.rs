//! The numbers of matrices.

use nalgebra::ComplexField;

/// A number that matrices are made of: real, or complex for methods whose stages are coupled.
pub trait Number: ComplexField<RealField = f64> + Copy {}
impl<F: ComplexField<RealField = f64> + Copy> Number for F {}
