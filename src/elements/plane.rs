//! Vectors and 2 × 2 blocks of the plane, and polynomials of them along an element. Numbers are computed side by side, several in
//! one instruction of the processor: x and y of one element, or the same number of four elements.
//!
//! With ζ = −1 … 1 along the element, vectors along it are polynomials c₀ + c₁ζ + c₂ζ². Forces and stiffnesses of sections enter
//! an element by their *moments* Σ w ζⁿ f, the forces on the coefficients; what is left to the nodes is a small linear map.

#![allow(non_snake_case)] // The matrix K.

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::SVector;
use wide::{f64x2, f64x4};

/// A vector (x, y).
pub(super) type Vec2 = f64x2;

/// A 2 × 2 matrix by columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block(pub [Vec2; 2]);

/// Coefficients c₀, c₁, c₂.
pub(super) type Quadratic<T> = [T; 3];

/// What can be added and scaled: vectors, blocks.
pub(super) trait Linear: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {}
impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Linear for T {}

impl Block {
    pub const ZERO: Block = Block([Vec2::ZERO; 2]);

    /// s · 1.
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

/// Elements whose forces are computed side by side.
pub const LANES: usize = 4;

/// A number of one element, or of several side by side.
pub(super) trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The same number everywhere.
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

/// A vector of one element ([`Vec2`]) or of several ([`Lanes`]).
pub(super) trait Vector: Linear + Neg<Output = Self> {
    const ZERO: Self;
    type Number: Scalar;

    /// The same vector everywhere.
    fn of(vector: Vec2) -> Self;

    fn times(self, s: Self::Number) -> Self;

    fn dot(self, other: Self) -> Self::Number;

    /// Turned by a right angle: a × b = turn(a)·b.
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

/// A vector of each of [`LANES`] elements.
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

/// The nodal vectors of elements side by side, from their coordinates.
#[inline(always)]
pub(super) fn side_by_side<const V: usize, const N: usize>(u: &[SVector<f64, N>; LANES]) -> [Lanes; V] {
    let component = |i: usize| f64x4::new(std::array::from_fn(|lane| u[lane][i]));
    std::array::from_fn(|n| Lanes { x: component(2 * n), y: component(2 * n + 1) })
}

/// The coordinates of each of them, from their nodal vectors.
#[inline(always)]
pub(super) fn each<const V: usize, const N: usize>(vectors: &[Lanes; V]) -> [SVector<f64, N>; LANES] {
    let components = vectors.map(|vector| [vector.x.to_array(), vector.y.to_array()]);
    std::array::from_fn(|lane| SVector::from_fn(|i, _| components[i / 2][i % 2][lane]))
}

/// A Gauss point of the axis: weight (m) and ζ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station {
    pub weight: f64,
    pub zeta: f64,
}

/// The stations of a rule on an element of length `l`.
pub(super) fn stations<const Q: usize>(rule: &[(f64, f64); Q], l: f64) -> [Station; Q] {
    rule.map(|(zeta, weight)| Station { weight: l / 2.0 * weight, zeta })
}

/// A polynomial's value at ζ.
#[inline(always)]
pub(super) fn at<T: Linear>(zeta: f64, c: &Quadratic<T>) -> T {
    c[0] + (c[1] + c[2] * zeta) * zeta
}

/// Its derivative with respect to ζ.
#[inline(always)]
pub(super) fn slope_at<T: Linear>(zeta: f64, c: &Quadratic<T>) -> T {
    c[1] + c[2] * (2.0 * zeta)
}

/// Adds a force on a polynomial's value at ζ to those on its coefficients.
#[inline(always)]
pub(super) fn add_at<T: Linear>(zeta: f64, f: T, Q: &mut Quadratic<T>) {
    Q[0] = Q[0] + f;
    Q[1] = Q[1] + f * zeta;
    Q[2] = Q[2] + f * (zeta * zeta);
}

/// Adds a force on a polynomial's slope at ζ.
#[inline(always)]
pub(super) fn add_slope_at<T: Linear>(zeta: f64, f: T, Q: &mut Quadratic<T>) {
    Q[1] = Q[1] + f;
    Q[2] = Q[2] + f * (2.0 * zeta);
}

/// Adds a section's part to the moments, the n-th of them times ζⁿ.
#[inline(always)]
pub(super) fn add_moments(zeta: f64, section: Block, moments: &mut [Block; 5]) {
    let zeta_2 = zeta * zeta;
    moments[0] = moments[0] + section;
    moments[1] = moments[1] + section * zeta;
    moments[2] = moments[2] + section * zeta_2;
    moments[3] = moments[3] + section * (zeta * zeta_2);
    moments[4] = moments[4] + section * (zeta_2 * zeta_2);
}

/// The nodal vectors of an element from its coordinates.
#[inline(always)]
pub(super) fn nodal<const V: usize>(u: &[f64]) -> [Vec2; V] {
    std::array::from_fn(|n| vec2(u[2 * n], u[2 * n + 1]))
}

/// The coordinates of nodal vectors.
#[inline(always)]
pub(super) fn coordinates<const V: usize, const N: usize>(vectors: &[Vec2; V]) -> [f64; N] {
    let components = vectors.map(Vec2::to_array);
    std::array::from_fn(|i| components[i / 2][i % 2])
}

/// An element's matrix, by columns, from that of the coefficients: `to_nodes` is the map of forces on coefficients to forces on
/// nodal vectors, which acts on rows and on columns alike.
#[inline(always)]
pub(super) fn matrix<const C: usize, const V: usize, const N: usize>(
    of_coefficients: &[[Block; C]; C],
    to_nodes: impl Fn(&[Block; C]) -> [Block; V],
) -> [[f64; N]; N] {
    // By row coefficients and nodal columns.
    let columns = of_coefficients.each_ref().map(&to_nodes);
    let mut K = [[0.0; N]; N];
    for column in 0..V {
        let rows = to_nodes(&std::array::from_fn(|row| columns[row][column]));
        for (row, block) in rows.iter().enumerate() {
            for (c, values) in block.0.iter().enumerate() {
                K[2 * column + c][2 * row..2 * row + 2].copy_from_slice(&values.to_array());
            }
        }
    }
    K
}
