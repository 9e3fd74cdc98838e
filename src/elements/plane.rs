//! Vectors and 2 × 2 blocks of the plane, for one element: x and y are computed in one instruction of the processor.

use std::ops::{Add, Mul, Sub};

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

/// Products of plane vectors.
pub(super) trait Vector {
    fn dot(self, other: Self) -> f64;

    /// Rotated by a right angle: a × b = turn(a)·b.
    fn turn(self) -> Self;
}

impl Vector for Vec2 {
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
