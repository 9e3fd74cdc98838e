//! Mass matrix and weight of a rod.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::equations::{cable, shape};
use ancf::model::Element;
use nalgebra::{DMatrix, DVector};

use super::element::vectors;
use super::gauss::GAUSS;
use super::rod::Rod;
use super::setup::{Mass, Setup, Weight};

/// Sizes of an element that its mass depends on.
pub struct Body {
    /// Kind of element.
    pub element: Element,
    /// Its length, m.
    pub length: f64,
    /// Height of the section, m.
    pub height: f64,
    /// Area of the section, m².
    pub area: f64,
    /// Density, kg/m³.
    pub rho: f64,
}

impl Body {
    /// Adds the rod's mass matrix and weight.
    pub fn assemble(&self, setup: &Setup, rod: &Rod, mass: &mut DMatrix<f64>, weight: &mut DVector<f64>) {
        let (of_element, stride) = vectors(self.element);
        let (m, integral) = self.element(setup);
        let gravity = setup.scene.gravity;
        let (elements, size) = (rod.elements, 2 * of_element);
        for element in 0..elements {
            let first = rod.first + 2 * stride * element;
            for i in 0..size {
                for j in (i % 2..size).step_by(2) {
                    let share = setup.mass_blocks.share_of_matrix(element, elements, [i, j], size);
                    mass[(first + i, first + j)] += share * m[(i / 2, j / 2)];
                }
                let share = setup.weight_blocks.share(element, elements, i, size);
                weight[first + i] += share * integral[i / 2] * gravity[i % 2];
            }
        }
        if setup.weight == Weight::AtTheEnd {
            let end = rod.first + 2 * stride * elements;
            for component in 0..2 {
                weight[end + component] += self.rho * self.area * self.length * elements as f64 * gravity[component];
            }
        }
    }

    /// Mass matrix of an element for one component, and the integral of ρ S.
    fn element(&self, setup: &Setup) -> (DMatrix<f64>, Vec<f64>) {
        let (of_element, _) = vectors(self.element);
        let (mut m, mut integral) = (DMatrix::zeros(of_element, of_element), vec![0.0; of_element]);
        let [along, across] = match self.element {
            Element::Ancf => [GAUSS[4], GAUSS[2]],
            Element::EulerBernoulli => [GAUSS[4], GAUSS[0]],
        };
        for (xi, w_xi) in along {
            for (eta, w_eta) in across {
                let x = self.length / 2.0 * (1.0 + xi);
                let y = setup.law.depth_of_mass * self.height / 2.0 * eta;
                let share = self.rho * self.area * self.length * w_xi * w_eta / 4.0;
                let S: Vec<f64> = match self.element {
                    Element::Ancf => shape::S_i(x, y, self.length).into(),
                    Element::EulerBernoulli => cable::S_i(x, self.length).into(),
                };
                for i in 0..of_element {
                    integral[i] += share * S[i];
                    for j in 0..of_element {
                        m[(i, j)] += share * S[i] * S[j];
                    }
                }
            }
        }
        let of_positions: &[usize] = if self.element == Element::Ancf { &[0, 2, 5] } else { &[0, 2] };
        if setup.mass != Mass::Consistent {
            let whole = self.rho * self.area * self.length;
            let carried: f64 = of_positions.iter().map(|n| m[(*n, *n)]).sum();
            let factor = if setup.mass == Mass::ScaledDiagonal { whole / carried } else { 1.0 };
            m = DMatrix::from_diagonal(&m.diagonal()) * factor;
        }
        match setup.weight {
            Weight::Consistent => {}
            Weight::HalfOnEnds => {
                let ends = [0, of_positions.last().copied().unwrap_or_default()];
                let half = 0.5 * self.rho * self.area * self.length;
                integral
                    .iter_mut()
                    .enumerate()
                    .for_each(|(n, share)| *share = if ends.contains(&n) { half } else { 0.0 });
            }
            Weight::AtTheEnd => integral.fill(0.0),
        }
        (m, integral)
    }
}
