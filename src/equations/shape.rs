//! Equations (1)–(5) and (A.1)–(A.5): position and velocity of a material point.
//!
//! A material point has the coordinates `x` ∈ \[0, l\] along the element and `y` ∈ \[−h/2, h/2\] across it, in m. Seven
//! vectors at three nodes (i at x = 0, j at x = l/2, k at x = l) describe its motion.
//!
//! ```
//! use ancf::equations::element::Element;
//! use ancf::equations::shape;
//!
//! let element = Element::straight(2.0, 0.1, 0.05, 0.0);
//! let point = shape::r(0.5, 0.02, &element.e_0, element.l); // (1)
//! assert!((point.x - 0.5).abs() < 1e-15 && (point.y - 0.02).abs() < 1e-15);
//! ```
//!
//! Derived step by step: `oracle/DERIVATION.md#1-position-from-a-polynomial-to-shape-functions`, there (A.1) `#a1-the-polynomial`,
//! (A.2) `#a2-what-the-nodal-vectors-are`, (A.3) `#a3-the-coefficients`, E1 `#e1-an-error-in-the-paper`,
//! (A.4) `#a4-position-by-the-nodal-vectors`, (A.5) `#a5-what-interpolation-keeps`,
//! (1) `#1-position-is-a-matrix-times-the-nodal-coordinates`, (2) `#2-the-shape-matrix`, (3) `#3-the-shape-functions`,
//! (4) `#4-the-nodal-coordinates`, (5) `#5-velocity`.

use nalgebra::{SMatrix, SVector, Vector2};

/// A column of 14 entries, such as the nodal coordinates `e` of (4).
pub type Vector14 = SVector<f64, 14>;
/// A 2 × 14 matrix, such as S of (2) and its derivatives.
pub type Matrix2x14 = SMatrix<f64, 2, 14>;

/// The seven nodal vectors of an element, in the order of (4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nodes {
    /// Position of node i (x = 0), m.
    pub r_i: Vector2<f64>,
    /// Slope ∂r/∂y at node i.
    pub r_y_i: Vector2<f64>,
    /// Position of node j (x = l/2), m.
    pub r_j: Vector2<f64>,
    /// Slope ∂r/∂x at node j.
    pub r_x_j: Vector2<f64>,
    /// Slope ∂r/∂y at node j.
    pub r_y_j: Vector2<f64>,
    /// Position of node k (x = l), m.
    pub r_k: Vector2<f64>,
    /// Slope ∂r/∂y at node k.
    pub r_y_k: Vector2<f64>,
}

/// Coefficients (a_n, b_n), n = 0…6, of the polynomial (A.1), in m^(1−p) for a term of degree p.
///
/// The paper counts them "i = 1, 2, …, 7"; the polynomial itself counts 0…6 (E5).
pub type Coefficients = [Vector2<f64>; 7];

/// (1) Position of a material point, m: r = S e.
pub fn r(x: f64, y: f64, e: &Vector14, l: f64) -> Vector2<f64> {
    S(x, y, l) * e
}

/// (2) Shape matrix, 2 × 14: S = \[S₁I S₂I S₃I S₄I S₅I S₆I S₇I\], with the 2 × 2 identity I; by (A.5).
pub fn S(x: f64, y: f64, l: f64) -> Matrix2x14 {
    row_of_identities(S_i(x, y, l))
}

/// Derivative ∂S/∂x of the shape matrix, 2 × 14, 1/m for positions; its rows are S_1x and S_2x of (9).
pub fn S_x(x: f64, y: f64, l: f64) -> Matrix2x14 {
    row_of_identities(S_i_x(x, y, l))
}

/// Derivative ∂S/∂y of the shape matrix, 2 × 14, 1/m for positions; its rows are S_1y and S_2y of (9).
pub fn S_y(x: f64, y: f64, l: f64) -> Matrix2x14 {
    row_of_identities(S_i_y(x, y, l))
}

fn row_of_identities(s: [f64; 7]) -> Matrix2x14 {
    Matrix2x14::from_fn(|row, column| if column % 2 == row { s[column / 2] } else { 0.0 })
}

/// (3) Shape functions S₁…S₇, with a = x/l and b = y/l; those of slopes (2, 4, 5, 7) in m.
pub fn S_i(x: f64, y: f64, l: f64) -> [f64; 7] {
    let (a, b) = (x / l, y / l);
    [
        1.0 - 5.0 * a + 8.0 * a.powi(2) - 4.0 * a.powi(3),
        l * b * (1.0 - 3.0 * a + 2.0 * a.powi(2)),
        4.0 * a - 4.0 * a.powi(2),
        l * a * (-2.0 + 6.0 * a - 4.0 * a.powi(2)),
        l * b * (4.0 * a - 4.0 * a.powi(2)),
        a - 4.0 * a.powi(2) + 4.0 * a.powi(3),
        l * b * (-a + 2.0 * a.powi(2)),
    ]
}

/// Derivatives of the shape functions (3) with respect to x, by da/dx = 1/l; 1/m for positions.
pub fn S_i_x(x: f64, y: f64, l: f64) -> [f64; 7] {
    let (a, b) = (x / l, y / l);
    [
        (-5.0 + 16.0 * a - 12.0 * a.powi(2)) / l,
        b * (-3.0 + 4.0 * a),
        (4.0 - 8.0 * a) / l,
        -2.0 + 12.0 * a - 12.0 * a.powi(2),
        b * (4.0 - 8.0 * a),
        (1.0 - 8.0 * a + 12.0 * a.powi(2)) / l,
        b * (-1.0 + 4.0 * a),
    ]
}

/// Derivatives of the shape functions (3) with respect to y, by db/dy = 1/l.
///
/// Only the functions of the slopes r_y depend on y, and linearly, so y itself drops out.
pub fn S_i_y(x: f64, _y: f64, l: f64) -> [f64; 7] {
    let a = x / l;
    [0.0, 1.0 - 3.0 * a + 2.0 * a.powi(2), 0.0, 0.0, 4.0 * a - 4.0 * a.powi(2), 0.0, -a + 2.0 * a.powi(2)]
}

/// (4) Nodal coordinates as one column of 14: e = \[rⁱ r_yⁱ rʲ r_xʲ r_yʲ rᵏ r_yᵏ\].
pub fn e(nodes: &Nodes) -> Vector14 {
    let Nodes { r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k } = nodes;
    let columns = [r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k];
    Vector14::from_fn(|row, _| columns[row / 2][row % 2])
}

/// (4) Nodal vectors of a column `e`: the inverse of [`e`](e()).
pub fn nodes(e: &Vector14) -> Nodes {
    let vector = |n: usize| Vector2::new(e[2 * n], e[2 * n + 1]);
    Nodes {
        r_i: vector(0),
        r_y_i: vector(1),
        r_j: vector(2),
        r_x_j: vector(3),
        r_y_j: vector(4),
        r_k: vector(5),
        r_y_k: vector(6),
    }
}

/// (5) Velocity of a material point, m/s: ṙ = S ė, as S does not depend on time.
pub fn r_dot(x: f64, y: f64, e_dot: &Vector14, l: f64) -> Vector2<f64> {
    S(x, y, l) * e_dot
}

/// (A.1) Position as a polynomial, m: r = a₀ + a₁x + a₂y + a₃xy + a₄x² + a₅x³ + a₆x²y.
pub fn r_polynomial(x: f64, y: f64, c: &Coefficients) -> Vector2<f64> {
    c[0] + c[1] * x + c[2] * y + c[3] * (x * y) + c[4] * x.powi(2) + c[5] * x.powi(3) + c[6] * (x.powi(2) * y)
}

/// Derivative ∂r/∂x of the polynomial (A.1).
pub fn r_polynomial_x(x: f64, y: f64, c: &Coefficients) -> Vector2<f64> {
    c[1] + c[3] * y + c[4] * (2.0 * x) + c[5] * (3.0 * x.powi(2)) + c[6] * (2.0 * x * y)
}

/// Derivative ∂r/∂y of the polynomial (A.1). The polynomial is linear in y, so y drops out.
pub fn r_polynomial_y(x: f64, _y: f64, c: &Coefficients) -> Vector2<f64> {
    c[2] + c[3] * x + c[6] * x.powi(2)
}

/// (A.2) Nodal conditions: positions and slopes of the polynomial (A.1) at the nodes.
pub fn nodal_conditions(c: &Coefficients, l: f64) -> Nodes {
    Nodes {
        r_i: r_polynomial(0.0, 0.0, c),
        r_y_i: r_polynomial_y(0.0, 0.0, c),
        r_k: r_polynomial(l, 0.0, c),
        r_y_k: r_polynomial_y(l, 0.0, c),
        r_j: r_polynomial(l / 2.0, 0.0, c),
        r_x_j: r_polynomial_x(l / 2.0, 0.0, c),
        r_y_j: r_polynomial_y(l / 2.0, 0.0, c),
    }
}

/// (A.3) Coefficients of (A.1) that satisfy (A.2), **consistent**.
///
/// a₁ has −rᵏ where the paper prints +rᵏ (E1). Only with −rᵏ does (A.2) hold: see [`coefficients_printed`].
pub fn coefficients(nodes: &Nodes, l: f64) -> Coefficients {
    let Nodes { r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k } = nodes;
    [
        *r_i,
        -(5.0 * r_i - 4.0 * r_j - r_k + 2.0 * l * r_x_j) / l,
        *r_y_i,
        -(3.0 * r_y_i - 4.0 * r_y_j + r_y_k) / l,
        (8.0 * r_i - 4.0 * r_j - 4.0 * r_k + 6.0 * l * r_x_j) / l.powi(2),
        -(4.0 * r_i - 4.0 * r_k + 4.0 * l * r_x_j) / l.powi(3),
        (2.0 * r_y_i - 4.0 * r_y_j + 2.0 * r_y_k) / l.powi(2),
    ]
}

/// (A.3) Coefficients of (A.1) **as printed**: a₁ with +rᵏ (E1).
///
/// The position is off by −(2x/l) rᵏ, so (A.2) fails: rʲ is off by rᵏ, r_xʲ by 2rᵏ/l and rᵏ by 2rᵏ.
pub fn coefficients_printed(nodes: &Nodes, l: f64) -> Coefficients {
    let Nodes { r_i, r_j, r_x_j, r_k, .. } = nodes;
    let mut c = coefficients(nodes, l);
    c[1] = -(5.0 * r_i - 4.0 * r_j + r_k + 2.0 * l * r_x_j) / l;
    c
}

/// (A.4) Position from the nodal vectors, m: (A.3) inserted into (A.1). (A.5) then names its parts: (2), (3) and (4).
pub fn r_nodal(x: f64, y: f64, nodes: &Nodes, l: f64) -> Vector2<f64> {
    let Nodes { r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k } = nodes;
    let (a, b) = (x / l, y / l);
    (1.0 - 5.0 * a + 8.0 * a.powi(2) - 4.0 * a.powi(3)) * r_i
        + (l * b * (1.0 - 3.0 * a + 2.0 * a.powi(2))) * r_y_i
        + (4.0 * a - 4.0 * a.powi(2)) * r_j
        + (l * a * (-2.0 + 6.0 * a - 4.0 * a.powi(2))) * r_x_j
        + (l * b * (4.0 * a - 4.0 * a.powi(2))) * r_y_j
        + (a - 4.0 * a.powi(2) + 4.0 * a.powi(3)) * r_k
        + (l * b * (-a + 2.0 * a.powi(2))) * r_y_k
}
