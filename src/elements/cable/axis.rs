//! The axis at a station: its stretch and its curvature, with their derivatives in p and s.

#![allow(non_snake_case)] // A, B and H are matrices here.

use crate::elements::plane::{Block, Vec2, Vector, vec2};

/// The axis at a station of the axial strain.
#[derive(Clone, Copy)]
pub(super) struct Stretch<V: Vector> {
    pub r_x: V,
    /// |r_x|
    pub length: V::Number,
    /// 1/|r_x|
    pub inverse: V::Number,
    /// |r_x| − 1
    pub strain: V::Number,
}

/// The axis at a station of the curvature.
#[derive(Clone, Copy)]
pub(super) struct Bend<V: Vector> {
    pub r_x: V,
    pub r_xx: V,
    /// r_x × r_xx, 1/m
    pub cross: V::Number,
    /// r_x · r_x
    pub square: V::Number,
    /// Its inverse.
    pub inverse: V::Number,
}

/// A vector in (p, s): by p, by s.
pub(super) type Both<V = Vec2> = [V; 2];

/// A matrix in (p, s), by its four blocks.
pub(super) type Blocks = [[Block; 2]; 2];

/// a bᵀ.
#[inline(always)]
pub(super) fn outers(a: Both, b: Both) -> Blocks {
    a.map(|a| b.map(|b| Block::outer(1.0, a, b)))
}

/// a A + b B.
#[inline(always)]
pub(super) fn combined(a: f64, A: &Blocks, b: f64, B: &Blocks) -> Blocks {
    [0, 1].map(|row| [0, 1].map(|column| A[row][column] * a + B[row][column] * b))
}

/// ∂²(r_x × r_xx)/∂(p, s)²: p × s = p₁s₂ − p₂s₁.
pub(super) fn cross_rate_rate() -> Blocks {
    let ps = Block([vec2(0.0, -1.0), vec2(1.0, 0.0)]);
    let sp = Block([vec2(0.0, 1.0), vec2(-1.0, 0.0)]);
    [[Block::ZERO, ps], [sp, Block::ZERO]]
}

impl<V: Vector> Stretch<V> {
    /// ∂ε/∂p
    #[inline(always)]
    pub fn rate(&self) -> V {
        self.r_x.times(self.inverse)
    }
}

impl Stretch<Vec2> {
    /// ∂²ε/∂p²
    #[inline(always)]
    pub fn rate_rate(&self) -> Block {
        let n = self.rate();
        (Block::identity(1.0) - Block::outer(1.0, n, n)) * self.inverse
    }
}

impl<V: Vector> Bend<V> {
    #[inline(always)]
    pub fn kappa(&self) -> V::Number {
        self.cross * self.inverse
    }

    /// ∂κ/∂(p, s), from κ |r_x|² = r_x × r_xx.
    #[inline(always)]
    pub fn rate(&self) -> Both<V> {
        let Bend { r_x, r_xx, inverse, .. } = *self;
        let kappa = self.kappa();
        [-r_xx.turn() - r_x.times(kappa + kappa), r_x.turn()].map(|rate| rate.times(inverse))
    }
}

impl Bend<Vec2> {
    /// ∂²κ/∂(p, s)², from the same differentiated twice.
    #[inline(always)]
    pub fn rate_rate(&self) -> Blocks {
        let rate = self.rate();
        let mut H = cross_rate_rate();
        // −2 (r_x rateᵀ + rate r_xᵀ) and −2κ in p.
        H[0][0] = Block::outer(-2.0, self.r_x, rate[0]) + Block::outer(-2.0, rate[0], self.r_x)
            - Block::identity(2.0 * self.kappa());
        H[0][1] = H[0][1] + Block::outer(-2.0, self.r_x, rate[1]);
        H[1][0] = H[1][0] + Block::outer(-2.0, rate[1], self.r_x);
        H.map(|row| row.map(|block| block * self.inverse))
    }
}
