//! Several equal elements computed side by side: the same number of four elements in one instruction of the processor.

use std::ops::{Add, Mul, Neg, Sub};

use nalgebra::SVector;
use wide::f64x4;

use super::plane::{Scalar, Vec2, Vector};

/// Number of elements whose forces are computed side by side.
pub const LANES: usize = 4;

impl Scalar for f64x4 {
    #[inline(always)]
    fn of(number: f64) -> f64x4 {
        f64x4::splat(number)
    }

    #[inline(always)]
    fn sqrt(self) -> f64x4 {
        f64x4::sqrt(self)
    }
}

/// Vectors of [`LANES`] elements: all x in one register, all y in another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lanes {
    x: f64x4,
    y: f64x4,
}

impl Add for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn add(self, other: Lanes) -> Lanes {
        Lanes { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn sub(self, other: Lanes) -> Lanes {
        Lanes { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Mul<f64> for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn mul(self, s: f64) -> Lanes {
        self.times(f64x4::splat(s))
    }
}

impl Neg for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn neg(self) -> Lanes {
        Lanes { x: -self.x, y: -self.y }
    }
}

impl Vector for Lanes {
    const ZERO: Lanes = Lanes { x: f64x4::ZERO, y: f64x4::ZERO };
    type Number = f64x4;

    #[inline(always)]
    fn of(vector: Vec2) -> Lanes {
        let [x, y] = vector.to_array();
        Lanes { x: f64x4::splat(x), y: f64x4::splat(y) }
    }

    #[inline(always)]
    fn times(self, s: f64x4) -> Lanes {
        Lanes { x: self.x * s, y: self.y * s }
    }

    #[inline(always)]
    fn dot(self, other: Lanes) -> f64x4 {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    fn turn(self) -> Lanes {
        Lanes { x: -self.y, y: self.x }
    }
}

/// Nodal vectors of [`LANES`] elements from their coordinates.
#[inline(always)]
pub(super) fn side_by_side<const V: usize, const N: usize>(u: &[SVector<f64, N>; LANES]) -> [Lanes; V] {
    let component = |i: usize| f64x4::new(std::array::from_fn(|lane| u[lane][i]));
    std::array::from_fn(|n| Lanes { x: component(2 * n), y: component(2 * n + 1) })
}

/// Coordinates of [`LANES`] elements from their nodal vectors.
#[inline(always)]
pub(super) fn each<const V: usize, const N: usize>(vectors: &[Lanes; V]) -> [SVector<f64, N>; LANES] {
    let components = vectors.map(|vector| [vector.x.to_array(), vector.y.to_array()]);
    std::array::from_fn(|lane| SVector::from_fn(|i, _| components[i / 2][i % 2][lane]))
}
