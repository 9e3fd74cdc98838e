//! Number types of matrices.

use nalgebra::ComplexField;

/// Number type of a matrix: real, or complex for methods with coupled stages.
pub trait Number: ComplexField<RealField = f64> + Copy {}
impl<F: ComplexField<RealField = f64> + Copy> Number for F {}
