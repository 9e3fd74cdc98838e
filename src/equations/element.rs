//! The element that the equations are integrated over: its length, its section and its initial nodal coordinates.

use super::shape::{Nodes, Vector14, e};
use nalgebra::{SMatrix, Vector2};

/// A 14 × 14 matrix, such as M of (7), S_a of (11) or K of (20).
pub type Matrix14 = SMatrix<f64, 14, 14>;

/// One element in its initial, stress-free configuration. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// Length, m.
    pub l: f64,
    /// Height of the section, in the plane of motion, m.
    pub h: f64,
    /// Width of the section, normal to the plane, m.
    pub w: f64,
    /// Initial nodal coordinates e₀ in the order of (4): positions in m, slopes without unit.
    pub e_0: Vector14,
}

impl Element {
    /// A straight, unstretched element from the origin, at the angle `theta` (rad) to the global x axis.
    ///
    /// With t = (cos θ, sin θ) along it and n = (−sin θ, cos θ) across it:
    ///
    /// e₀ = \[0  n  (l/2) t  t  n  l t  n\].
    ///
    /// So (9) has J₀ = \[t n\], a rotation, on which the closed form (11) rests.
    ///
    /// ```
    /// use ancf::equations::element::Element;
    /// use ancf::equations::{shape, strain};
    ///
    /// let theta = 0.3_f64;
    /// let element = Element::straight(2.0, 0.1, 0.05, theta);
    /// let tip = shape::r(2.0, 0.0, &element.e_0, element.l);
    /// assert!((tip.x - 2.0 * theta.cos()).abs() < 1e-15 && (tip.y - 2.0 * theta.sin()).abs() < 1e-15);
    ///
    /// let J_0 = strain::J_0(0.7, 0.02, &element);
    /// assert!((J_0 - strain::J_0_theta(theta)).amax() < 1e-14);
    /// ```
    pub fn straight(l: f64, h: f64, w: f64, theta: f64) -> Element {
        let (sin, cos) = theta.sin_cos();
        let (t, n, r_i) = (Vector2::new(cos, sin), Vector2::new(-sin, cos), Vector2::zeros());
        let nodes = Nodes { r_i, r_y_i: n, r_j: 0.5 * l * t, r_x_j: t, r_y_j: n, r_k: l * t, r_y_k: n };
        Element { l, h, w, e_0: e(&nodes) }
    }
}
