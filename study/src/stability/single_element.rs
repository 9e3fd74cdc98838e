//! One straight clamped element of 1 m through `equations/`, in absolute coordinates as in the paper.

#![allow(non_snake_case)] // The paper's symbols are names here: K_1, K_2, K_3.

use nalgebra::{DMatrix, DVector, Vector2, Vector3};

use ancf::equations::element::{Element, Matrix14};
use ancf::equations::force;
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::shape::Vector14;

/// An element with its Lamé constants; no heat.
pub struct SingleElement {
    pub element: Element,
    pub moduli: LameConstants,
}

impl SingleElement {
    /// A square section of this height, along the direction θ.
    pub fn new(height: f64, theta: f64, moduli: YoungPoisson) -> SingleElement {
        SingleElement { element: Element::straight(1.0, height, height, theta), moduli: moduli.into() }
    }

    /// Elastic forces (19).
    pub fn forces(&self, e: &Vector14) -> Vector14 {
        let (element, no_heat) = (&self.element, Vector3::zeros());
        let K_1 = force::K_1(e, &no_heat, element);
        let K_2 = force::K_2(e, &no_heat, element);
        let K_3 = force::K_3(e, &no_heat, element);
        force::Q_e(e, &force::K(self.moduli, &K_1, &K_2, &K_3))
    }

    /// Tangent of the forces, of the consistent or of the printed form.
    pub fn tangent(&self, e: &Vector14, printed: bool) -> Matrix14 {
        let tangent = if printed { force::tangent_printed } else { force::tangent };
        tangent(e, &Vector3::zeros(), self.moduli, &self.element)
    }
}

/// Directions in which a clamped element can move: r_yⁱ along `n`, as the clamp holds its direction, and all coordinates after it.
pub fn free_directions(n: Vector2<f64>) -> DMatrix<f64> {
    let mut free = DMatrix::zeros(14, 11);
    (free[(2, 0)], free[(3, 0)]) = (n.x, n.y);
    free.view_mut((4, 1), (10, 10)).fill_with_identity();
    free
}

/// Solution of `tangent · x = load` in the free directions; `None` if there is none.
pub fn solve(tangent: &Matrix14, load: &Vector14, free: &DMatrix<f64>) -> Option<DVector<f64>> {
    let dense = DMatrix::from_column_slice(14, 14, tangent.as_slice());
    let right = free.transpose() * DVector::from_column_slice(load.as_slice());
    Some(free * (free.transpose() * dense * free).lu().solve(&right)?)
}
