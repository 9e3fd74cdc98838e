//! The volume integral ∫_V … dV over an element, by Gauss quadrature.
//!
//! **Which degree, and why.** For a straight element J₀ is constant. Then r_x is of degree 2 in x and 1 in y, and r_y
//! of degree 2 in x and 0 in y. So a strain is of degree 4 in x and 2 in y. The integrands of (18) and (21) are products
//! of two strains, or of a strain with S_a1: degree 8 in x and 4 in y. A Gauss rule with n points is exact to degree
//! 2n − 1: **five points along x and three across y** integrate them exactly. The integrands of (6) and (7) are of degree
//! 6 in x and 2 in y, so these points are exact for them too.
//! (M5, `oracle/DERIVATION.md#m5-how-many-gauss-points-are-exact`.)
//!
//! ```
//! use ancf::internals::equations::volume::gauss_points;
//!
//! let (l, h, w) = (2.0, 0.1, 0.05);
//! // ∫ y² dV = l w h³/12
//! let integral: f64 = gauss_points(l, h, w).iter().map(|p| p.y * p.y * p.dV).sum();
//! assert!((integral / (l * w * h * h * h / 12.0) - 1.0).abs() < 1e-14);
//! ```

/// A Gauss point of an element's volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Coordinate along the axis, m.
    pub x: f64,
    /// Coordinate across the section, m.
    pub y: f64,
    /// Its share of the volume, m³.
    pub dV: f64,
}

/// Nodes and weights of the five-point Gauss rule on \[−1, 1\], exact to degree 9: the roots of the Legendre polynomial P₅.
pub const GAUSS_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// Nodes and weights of the three-point Gauss rule on \[−1, 1\], exact to degree 5: the roots of the Legendre polynomial P₃.
pub const GAUSS_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
    (0.0, 0.888_888_888_888_888_8),
    (0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
];

/// Gauss points (x, dx) of a rule on an axis of length `l`, in m; Σ dx = l.
pub fn axis_points<const N: usize>(rule: &[(f64, f64); N], l: f64) -> [(f64, f64); N] {
    rule.map(|(xi, w_xi)| (l / 2.0 * (1.0 + xi), l / 2.0 * w_xi))
}

/// Gauss points, 5 × 3, of a straight element of length `l`, height `h` and width `w` (m); Σ dV = l h w.
pub fn gauss_points(l: f64, h: f64, w: f64) -> [Point; 15] {
    let along = axis_points(&GAUSS_5, l);
    std::array::from_fn(|n| {
        let ((x, dx), (eta, w_eta)) = (along[n / 3], GAUSS_3[n % 3]);
        Point { x, y: h / 2.0 * eta, dV: dx * h / 2.0 * w_eta * w }
    })
}
