//! Values with first and second derivatives, for energies whose formulas are changed.

use std::ops::{Add, Mul, Neg, Sub};

use nalgebra::{Matrix4, Vector4};

/// Value of a function of four variables with its gradient and its second derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet {
    /// Value.
    pub value: f64,
    /// First derivatives.
    pub gradient: Vector4<f64>,
    /// Second derivatives.
    pub hessian: Matrix4<f64>,
}

impl Jet {
    /// A constant.
    pub fn constant(value: f64) -> Jet {
        Jet { value, gradient: Vector4::zeros(), hessian: Matrix4::zeros() }
    }

    /// Variable `n` of four.
    pub fn variable(value: f64, n: usize) -> Jet {
        let gradient = Vector4::from_fn(|row, _| if row == n { 1.0 } else { 0.0 });
        Jet { gradient, ..Jet::constant(value) }
    }

    /// Function of the value by its value and its two derivatives there.
    fn chained(self, f: f64, f_1: f64, f_2: f64) -> Jet {
        let hessian = self.hessian * f_1 + self.gradient * self.gradient.transpose() * f_2;
        Jet { value: f, gradient: self.gradient * f_1, hessian }
    }

    /// Power with a real exponent.
    pub fn powf(self, n: f64) -> Jet {
        let x = self.value;
        self.chained(x.powf(n), n * x.powf(n - 1.0), n * (n - 1.0) * x.powf(n - 2.0))
    }

    /// Natural logarithm.
    pub fn ln(self) -> Jet {
        let x = self.value;
        self.chained(x.ln(), 1.0 / x, -1.0 / (x * x))
    }

    /// The value as a constant, as if its derivatives had been forgotten.
    pub fn frozen(self) -> Jet {
        Jet::constant(self.value)
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, other: Jet) -> Jet {
        let (gradient, hessian) = (self.gradient + other.gradient, self.hessian + other.hessian);
        Jet { value: self.value + other.value, gradient, hessian }
    }
}

impl Neg for Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        -1.0 * self
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, other: Jet) -> Jet {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, other: Jet) -> Jet {
        let cross = self.gradient * other.gradient.transpose();
        Jet {
            value: self.value * other.value,
            gradient: self.gradient * other.value + other.gradient * self.value,
            hessian: self.hessian * other.value + other.hessian * self.value + cross + cross.transpose(),
        }
    }
}

impl Mul<Jet> for f64 {
    type Output = Jet;
    fn mul(self, jet: Jet) -> Jet {
        Jet { value: self * jet.value, gradient: jet.gradient * self, hessian: jet.hessian * self }
    }
}
