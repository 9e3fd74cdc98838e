//! The energy–momentum step of the cable: mean forces and moments, and discrete derivatives of the strains.
//!
//! The product of a discrete derivative with the change of (p, s) over the step is exactly the change of the strain.

#![allow(non_snake_case)] // EA, EI and H, as in the derivation.

use super::axis::{Bend, Blocks, Both, Stretch, combined, cross_rate_rate, outers};
use crate::elements::plane::{Block, Vec2, Vector};

/// Stretch of the axis at a Gauss point, at both ends of a step.
pub(super) struct StretchStep {
    pub start: Stretch,
    pub end: Stretch,
    pub eps_T: [f64; 2],
}

impl StretchStep {
    /// Axial force averaged over both ends, N.
    #[inline(always)]
    pub fn mean_force(&self, EA: f64) -> f64 {
        let (half_EA, heat) = (0.5 * EA, self.eps_T[0] + self.eps_T[1]);
        half_EA * (self.start.strain + self.end.strain - heat)
    }

    /// 1/(|r_x|₀ + |r_x|₁).
    #[inline(always)]
    fn per_length(&self) -> f64 {
        1.0 / (self.start.length + self.end.length)
    }

    /// Discrete derivative of the strain: its product with p₁ − p₀ is |r_x|₁ − |r_x|₀.
    ///
    /// 2 r̄_x/(|r_x|₀ + |r_x|₁), as |r_x|² changes by 2 r̄_x·(p₁ − p₀).
    #[inline(always)]
    pub fn rate(&self) -> Vec2 {
        (self.start.r_x + self.end.r_x) * self.per_length()
    }
}

impl StretchStep {
    /// Derivative of [`rate`](StretchStep::rate) with respect to p₁.
    pub fn rate_rate(&self) -> Block {
        (Block::identity(1.0) - Block::outer(1.0, self.rate(), self.end.rate())) * self.per_length()
    }
}

/// Curvature of the axis at a Gauss point, at both ends of a step.
pub(super) struct BendStep {
    pub start: Bend,
    pub end: Bend,
}

impl BendStep {
    /// Mean of the bending moments at the start and the end of the time step, N m.
    #[inline(always)]
    pub fn mean_moment(&self, EI: f64) -> f64 {
        0.5 * EI * (self.start.kappa() + self.end.kappa())
    }

    /// Mean of both ends; cross product and square are averaged too, not those of the averaged vectors.
    #[inline(always)]
    fn middle(&self) -> Bend {
        let (BendStep { start, end }, half) = (self, 0.5);
        let square = half * (start.square + end.square);
        Bend {
            r_x: (start.r_x + end.r_x) * half,
            r_xx: (start.r_xx + end.r_xx) * half,
            cross: half * (start.cross + end.cross),
            square,
            inverse: 1.0 / square,
        }
    }

    /// 1/(q₀q₁) with q = |r_x|².
    #[inline(always)]
    fn per_squares(&self) -> f64 {
        self.start.inverse * self.end.inverse
    }

    /// Discrete derivative of the curvature: its product with the change of (p, s) is κ₁ − κ₀.
    ///
    /// c = r_x × r_xx and q = |r_x|² are quadratic, so their derivatives in the middle give the changes Δc and Δq exactly: κ₁ − κ₀ = c₁/q₁ − c₀/q₀ = (q̄ Δc − c̄ Δq)/(q₀q₁).
    #[inline(always)]
    pub fn rate(&self) -> Both {
        let Bend { r_x, r_xx, cross, square, .. } = self.middle();
        [-r_xx.turn() * square - r_x * (cross + cross), r_x.turn() * square].map(|rate| rate * self.per_squares())
    }
}

impl BendStep {
    /// Derivative of [`rate`](BendStep::rate) with respect to (p₁, s₁), from rate · q₀q₁ differentiated.
    pub fn rate_rate(&self) -> Blocks {
        let Bend { r_x, r_xx, cross, square, .. } = self.middle();
        // ∂q₁ = 2 r_x1, and ∂c₁; the averages change by half as much, and so do r_x and r_xx.
        let square_1 = [self.end.r_x * 2.0, Vec2::ZERO];
        let cross_1 = [-self.end.r_xx.turn(), self.end.r_x.turn()];
        let cross_rate = [-r_xx.turn(), r_x.turn()];
        let square_rate = [r_x * 2.0, Vec2::ZERO];
        let mut H = combined(0.5, &outers(cross_rate, square_1), -0.5, &outers(square_rate, cross_1));
        H = combined(1.0, &H, 0.5 * square, &cross_rate_rate());
        H[0][0] = H[0][0] - Block::identity(cross);
        let product = outers(self.rate(), square_1);
        combined(self.per_squares(), &H, -self.start.square * self.per_squares(), &product)
    }
}
