//! Vectors and 2 × 2 blocks of the plane, and polynomials of them along an element. Two numbers are computed side by side, in one
//! instruction of the processor: x and y, or the same of two stations.
//!
//! With ζ = −1 … 1 along the element, vectors along it are polynomials c₀ + c₁ζ + c₂ζ². Forces and stiffnesses of sections enter
//! an element by their *moments* Σ w ζⁿ f, the forces on the coefficients; what is left to the nodes is a small linear map.

#![allow(non_snake_case)] // The matrix K.

use std::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

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

/// A number at one station, or at two of them side by side.
pub(super) trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
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

impl Scalar for f64x2 {
    #[inline(always)]
    fn of(number: f64) -> f64x2 {
        f64x2::splat(number)
    }

    #[inline(always)]
    fn sqrt(self) -> f64x2 {
        f64x2::sqrt(self)
    }
}

/// A vector at one station ([`Vec2`]) or at two ([`Pair`]).
pub(super) trait Vector: Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> {
    type Number: Scalar;

    /// The same vector everywhere.
    fn of(vector: Vec2) -> Self;

    fn times(self, s: Self::Number) -> Self;

    fn dot(self, other: Self) -> Self::Number;

    /// Turned by a right angle: a × b = turn(a)·b.
    fn turn(self) -> Self;
}

impl Vector for Vec2 {
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

/// A vector at two stations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    x: f64x2,
    y: f64x2,
}

impl Pair {
    pub const ZERO: Pair = Pair { x: f64x2::ZERO, y: f64x2::ZERO };

    /// The sum of both.
    #[inline(always)]
    pub fn sum(self) -> Vec2 {
        vec2(self.x.reduce_add(), self.y.reduce_add())
    }
}

impl Add for Pair {
    type Output = Pair;
    #[inline(always)]
    fn add(self, other: Pair) -> Pair {
        Pair { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Pair {
    type Output = Pair;
    #[inline(always)]
    fn sub(self, other: Pair) -> Pair {
        Pair { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Pair {
    type Output = Pair;
    #[inline(always)]
    fn neg(self) -> Pair {
        Pair { x: -self.x, y: -self.y }
    }
}

impl Vector for Pair {
    type Number = f64x2;

    #[inline(always)]
    fn of(vector: Vec2) -> Pair {
        let [x, y] = vector.to_array();
        Pair { x: f64x2::splat(x), y: f64x2::splat(y) }
    }

    #[inline(always)]
    fn times(self, s: f64x2) -> Pair {
        Pair { x: self.x * s, y: self.y * s }
    }

    #[inline(always)]
    fn dot(self, other: Pair) -> f64x2 {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    fn turn(self) -> Pair {
        Pair { x: -self.y, y: self.x }
    }
}

/// A Gauss point of the axis, or two of them: weight (m) and ζ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station<S> {
    pub weight: S,
    pub zeta: S,
}

/// The stations of a rule on an element of length `l`.
pub(super) fn stations<const Q: usize>(rule: &[(f64, f64); Q], l: f64) -> [Station<f64>; Q] {
    rule.map(|(zeta, weight)| Station { weight: l / 2.0 * weight, zeta })
}

/// The same two by two; the last one, if it is alone, beside one of no weight.
pub(super) fn pairs<const Q: usize, const P: usize>(stations: &[Station<f64>; Q]) -> [Station<f64x2>; P] {
    let station = |n: usize| stations.get(n).copied().unwrap_or(Station { weight: 0.0, zeta: 0.0 });
    std::array::from_fn(|pair| {
        let (a, b) = (station(2 * pair), station(2 * pair + 1));
        Station { weight: f64x2::new([a.weight, b.weight]), zeta: f64x2::new([a.zeta, b.zeta]) }
    })
}

/// A polynomial for the stations of another kind.
#[inline(always)]
pub(super) fn spread<V: Vector>(c: &Quadratic<Vec2>) -> Quadratic<V> {
    c.map(V::of)
}

/// A polynomial's value at ζ.
#[inline(always)]
pub(super) fn at<V: Vector>(zeta: V::Number, c: &Quadratic<V>) -> V {
    c[0] + (c[1] + c[2].times(zeta)).times(zeta)
}

/// Its derivative with respect to ζ.
#[inline(always)]
pub(super) fn slope_at<V: Vector>(zeta: V::Number, c: &Quadratic<V>) -> V {
    c[1] + c[2].times(zeta + zeta)
}

/// Adds a force on a polynomial's value at ζ to those on its coefficients.
#[inline(always)]
pub(super) fn add_at<V: Vector>(zeta: V::Number, f: V, Q: &mut Quadratic<V>) {
    Q[0] = Q[0] + f;
    Q[1] = Q[1] + f.times(zeta);
    Q[2] = Q[2] + f.times(zeta * zeta);
}

/// Adds a force on a polynomial's slope at ζ.
#[inline(always)]
pub(super) fn add_slope_at<V: Vector>(zeta: V::Number, f: V, Q: &mut Quadratic<V>) {
    Q[1] = Q[1] + f;
    Q[2] = Q[2] + f.times(zeta + zeta);
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
