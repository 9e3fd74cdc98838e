//! The cable's axis at a Gauss point: stretch and curvature, with their derivatives in p = u_x and s = u_xx.

#![allow(non_snake_case)] // A, B and H are matrices.

use crate::elements::plane::{Block, Vec2, Vector, vec2};

/// Stretch of the axis at a Gauss point.
#[derive(Clone, Copy)]
pub(super) struct Stretch {
    pub r_x: Vec2,
    /// |r_x|
    pub length: f64,
    /// 1/|r_x|
    pub inverse: f64,
    /// |r_x| − 1
    pub strain: f64,
}

/// Curvature of the axis at a Gauss point.
#[derive(Clone, Copy)]
pub(super) struct Bend {
    pub r_x: Vec2,
    pub r_xx: Vec2,
    /// r_x × r_xx, 1/m
    pub cross: f64,
    /// r_x · r_x
    pub square: f64,
    /// 1/(r_x · r_x)
    pub inverse: f64,
}

/// A vector in (p, s): part in p, part in s.
pub(super) type Both = [Vec2; 2];

/// A matrix in (p, s) as four blocks.
pub(super) type Blocks = [[Block; 2]; 2];

/// Dyadic product a bᵀ of vectors in (p, s).
#[inline(always)]
pub(super) fn outers(a: Both, b: Both) -> Blocks {
    a.map(|a| b.map(|b| Block::outer(1.0, a, b)))
}

/// Linear combination a A + b B.
#[inline(always)]
pub(super) fn combined(a: f64, A: &Blocks, b: f64, B: &Blocks) -> Blocks {
    [0, 1].map(|row| [0, 1].map(|column| A[row][column] * a + B[row][column] * b))
}

/// Second derivative ∂²(r_x × r_xx)/∂(p, s)²: p × s = p₁s₂ − p₂s₁.
pub(super) fn cross_rate_rate() -> Blocks {
    let ps = Block([vec2(0.0, -1.0), vec2(1.0, 0.0)]);
    let sp = Block([vec2(0.0, 1.0), vec2(-1.0, 0.0)]);
    [[Block::ZERO, ps], [sp, Block::ZERO]]
}

impl Stretch {
    /// Derivative of the axial strain, ∂ε/∂p.
    #[inline(always)]
    pub fn rate(&self) -> Vec2 {
        self.r_x * self.inverse
    }
}

impl Stretch {
    /// Second derivative of the axial strain, ∂²ε/∂p².
    #[inline(always)]
    pub fn rate_rate(&self) -> Block {
        let n = self.rate();
        (Block::identity(1.0) - Block::outer(1.0, n, n)) * self.inverse
    }
}

impl Bend {
    /// Curvature κ = (r_x × r_xx)/|r_x|², 1/m.
    #[inline(always)]
    pub fn kappa(&self) -> f64 {
        self.cross * self.inverse
    }

    /// Derivative of the curvature, ∂κ/∂(p, s), from κ |r_x|² = r_x × r_xx.
    #[inline(always)]
    pub fn rate(&self) -> Both {
        let Bend { r_x, r_xx, inverse, .. } = *self;
        let kappa = self.kappa();
        [-r_xx.turn() - r_x * (kappa + kappa), r_x.turn()].map(|rate| rate * inverse)
    }
}

impl Bend {
    /// Second derivative of the curvature, ∂²κ/∂(p, s)², from κ |r_x|² = r_x × r_xx differentiated twice.
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
