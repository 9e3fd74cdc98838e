//! Vectors and 2 × 2 blocks of the plane, for one element or for several side by side.
//!
//! x and y of one element are computed in one instruction of the processor. [`Vector`] and [`Scalar`] let a formula be
//! written once for one element and for several (`lanes.rs`).

use std::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

/// A vector (x, y).
pub(super) type Vec2 = f64x2;

/// A 2 × 2 matrix by columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block(pub [Vec2; 2]);

/// Values that can be added and scaled: vectors, blocks.
pub(super) trait Linear: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {}
impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Linear for T {}

impl Block {
    pub const ZERO: Block = Block([Vec2::ZERO; 2]);

    /// s I.
    #[inline(always)]
    pub fn identity(s: f64) -> Block {
        Block([vec2(s, 0.0), vec2(0.0, s)])
    }

    /// s a bᵀ.
    #[inline(always)]
    pub fn outer(s: f64, a: Vec2, b: Vec2) -> Block {
        let [x, y] = (b * s).to_array();
        Block([a * x, a * y])
    }
}

impl Add for Block {
    type Output = Block;
    #[inline(always)]
    fn add(self, other: Block) -> Block {
        Block([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }
}

impl Sub for Block {
    type Output = Block;
    #[inline(always)]
    fn sub(self, other: Block) -> Block {
        Block([self.0[0] - other.0[0], self.0[1] - other.0[1]])
    }
}

impl Mul<f64> for Block {
    type Output = Block;
    #[inline(always)]
    fn mul(self, s: f64) -> Block {
        Block([self.0[0] * s, self.0[1] * s])
    }
}

#[inline(always)]
pub(super) fn vec2(x: f64, y: f64) -> Vec2 {
    Vec2::new([x, y])
}

/// A number of one element, or of several side by side.
pub(super) trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// `number` in every element.
    fn of(number: f64) -> Self;

    fn sqrt(self) -> Self;
}

impl Scalar for f64 {
    #[inline(always)]
    fn of(number: f64) -> f64 {
        number
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        self.sqrt()
    }
}

/// A vector of one element ([`Vec2`]), or of several side by side.
pub(super) trait Vector: Linear + Neg<Output = Self> {
    const ZERO: Self;
    type Number: Scalar;

    /// `vector` in every element.
    fn of(vector: Vec2) -> Self;

    fn times(self, s: Self::Number) -> Self;

    fn dot(self, other: Self) -> Self::Number;

    /// Rotated by a right angle: a × b = turn(a)·b.
    fn turn(self) -> Self;
}

impl Vector for Vec2 {
    const ZERO: Vec2 = f64x2::ZERO;
    type Number = f64;

    #[inline(always)]
    fn of(vector: Vec2) -> Vec2 {
        vector
    }

    #[inline(always)]
    fn times(self, s: f64) -> Vec2 {
        self * s
    }

    #[inline(always)]
    fn dot(self, other: Vec2) -> f64 {
        (self * other).reduce_add()
    }

    #[inline(always)]
    fn turn(self) -> Vec2 {
        let [x, y] = self.to_array();
        vec2(-y, x)
    }
}
