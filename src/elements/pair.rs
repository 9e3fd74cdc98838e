//! Plane vectors of four elements side by side: all x in one [`Lanes`], all y in another.

use std::ops::{Add, Sub};

use crate::lanes::Lanes;

/// Vectors (x, y) of four elements.
#[derive(Clone, Copy)]
pub(super) struct Pair<L> {
    pub x: L,
    pub y: L,
}

impl<L: Lanes> Add for Pair<L> {
    type Output = Pair<L>;
    #[inline(always)]
    fn add(self, other: Pair<L>) -> Pair<L> {
        Pair { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<L: Lanes> Sub for Pair<L> {
    type Output = Pair<L>;
    #[inline(always)]
    fn sub(self, other: Pair<L>) -> Pair<L> {
        Pair { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<L: Lanes> Pair<L> {
    /// Zero vectors.
    #[inline(always)]
    pub fn zero(token: L::Token) -> Pair<L> {
        let zero = L::splat(token, 0.0);
        Pair { x: zero, y: zero }
    }

    /// `vector` in every element.
    #[inline(always)]
    pub fn splat(token: L::Token, [x, y]: [f64; 2]) -> Pair<L> {
        Pair { x: L::splat(token, x), y: L::splat(token, y) }
    }

    #[inline(always)]
    pub fn times(self, s: L) -> Pair<L> {
        Pair { x: self.x * s, y: self.y * s }
    }

    /// `self` · s + `sum`.
    #[inline(always)]
    pub fn times_add(self, s: L, sum: Pair<L>) -> Pair<L> {
        Pair { x: self.x.mul_add(s, sum.x), y: self.y.mul_add(s, sum.y) }
    }

    #[inline(always)]
    pub fn dot(self, other: Pair<L>) -> L {
        self.x.mul_add(other.x, self.y * other.y)
    }

    /// `self` · `other` + `sum`.
    #[inline(always)]
    pub fn dot_add(self, other: Pair<L>, sum: L) -> L {
        self.x.mul_add(other.x, self.y.mul_add(other.y, sum))
    }

    /// Cross product.
    #[inline(always)]
    pub fn cross(self, other: Pair<L>) -> L {
        self.x.mul_add(other.y, -(self.y * other.x))
    }

    /// Rotated by a right angle.
    #[inline(always)]
    pub fn turn(self) -> Pair<L> {
        Pair { x: -self.y, y: self.x }
    }
}

/// Value c₀ + c₁ζ + c₂ζ² of a polynomial.
#[inline(always)]
pub(super) fn at<L: Lanes>(zeta: L, [c_0, c_1, c_2]: &[Pair<L>; 3]) -> Pair<L> {
    c_2.times_add(zeta, *c_1).times_add(zeta, *c_0)
}
