//! Mistakes in the force (19): K times another vector, and wrong derivatives of the strains.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Matrix2;

use super::candidate::{Candidate, candidate};
use super::entries::rows;
use super::integral::{summed, sums};
use super::mistake::MistakeKind::{Missing, Other, Transpose};
use super::quadrature::{Integrand, bracket, exact, integrands};
use ancf::equations::element::Element;
use ancf::equations::force;
use ancf::equations::material as law;
use ancf::equations::shape::{self, Vector14};
use ancf::equations::strain;
use ancf::internals::equations::volume::Point;
use ancf::state::ElementState;

/// Candidates for the force.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    if quantity != "19.Q_e" {
        return Vec::new();
    }
    let (e, e0) = (Vector14::from(state.e), Vector14::from(state.e0));
    let of_K = move |at: Vector14, times: Vector14| {
        let (element, eps_T) = (state.element(), state.eps_T());
        let [K_1, K_2, K_3] = [force::K_1, force::K_2, force::K_3].map(|K| K(&at, &eps_T, &element));
        rows(&force::Q_e(&times, &force::K(state.moduli().into(), &K_1, &K_2, &K_3)))
    };
    let mut all = vec![
        candidate(Other, "K e_0 for K e: the derivatives of the strains at the start", move || of_K(e, e0)),
        candidate(Other, "K (e − e_0) for K e", move || of_K(e, e - e0)),
        candidate(Other, "K of e_0 times e", move || of_K(e0, e)),
        candidate(Other, "K of e_0 times e − e_0: small displacements", move || of_K(e0, e - e0)),
        candidate(Missing, "S_c e for ½ (S_c + S_cᵀ) e: half of the product rule in the shear", move || {
            by_stress(state, |s, _, _, e| [s.S[0] * e, s.S[1] * e, 0.5 * s.S[2] * e])
        }),
        candidate(Missing, "S_cᵀ e for ½ (S_c + S_cᵀ) e: half of the product rule in the shear", move || {
            by_stress(state, |s, _, _, e| [s.S[0] * e, s.S[1] * e, 0.5 * s.S[2].tr_mul(e)])
        }),
        candidate(Transpose, "Jᵀ for J in the derivatives of the strains", move || {
            by_stress(state, |_, point, element, e| derivatives(point, element, &transposed(point, element, e)))
        }),
        candidate(Transpose, "Jᵀ for J in the derivatives of ε_1 and ε_2", move || {
            by_stress(state, |s, point, element, e| {
                let [one, two, _] = derivatives(point, element, &transposed(point, element, e));
                [one, two, 0.5 * s.S_1[2] * e]
            })
        }),
    ];
    let K_e = |(kind, what, sum)| candidate(kind, what, move || rows(&force::Q_e(&e, &summed(state, sum))));
    all.extend(sums().map(K_e));
    all
}

/// Derivatives of ε_1, ε_2 and ε_3 by e at a point.
type Derivatives = fn(&Integrand, &Point, &Element, &Vector14) -> [Vector14; 3];

/// ∫ Σ σ_k ∂ε_k/∂e dV with both shears, for these derivatives of the strains.
fn by_stress(state: &ElementState, of: Derivatives) -> Vec<f64> {
    let (e, element, eps_T, points) = (Vector14::from(state.e), state.element(), state.eps_T(), exact(state));
    let D = law::D(state.moduli().into());
    let at = |sum: Vector14, (s, point): (&Integrand, &Point)| {
        let stress = D * nalgebra::Vector3::from_fn(|k, _| 0.5 * bracket(s, &eps_T, k));
        let [one, two, three] = of(s, point, &element, &e);
        sum + (one * stress[0] + two * stress[1] + three * (2.0 * stress[2])) * s.dV
    };
    rows(&integrands(&e, &element, &points).iter().zip(&points).fold(Vector14::zeros(), at))
}

fn transposed(point: &Point, element: &Element, e: &Vector14) -> Matrix2<f64> {
    strain::J(point.x, point.y, e, element).transpose()
}

/// Derivatives of the strains with J in them as it is given.
fn derivatives(point: &Point, element: &Element, J: &Matrix2<f64>) -> [Vector14; 3] {
    let (S_x, S_y) = (shape::S_x(point.x, point.y, element.l), shape::S_y(point.x, point.y, element.l));
    let P = strain::J_0(point.x, point.y, element).try_inverse().unwrap_or_else(Matrix2::zeros);
    let [G_1, G_2] = [0, 1].map(|m| S_x * P[(0, m)] + S_y * P[(1, m)]);
    let (J_1, J_2) = (J.column(0), J.column(1));
    [G_1.tr_mul(&J_1), G_2.tr_mul(&J_2), 0.5 * (G_1.tr_mul(&J_2) + G_2.tr_mul(&J_1))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{State, Suite};

    #[test]
    fn the_right_derivatives_give_the_reference_force() {
        for case in &Suite::embedded().unwrap().cases {
            let State::Element(state) = &case.state else { continue };
            let reference = &case.values["19.Q_e"];
            let routes: [Derivatives; 2] = [
                |s, _, _, e| s.S_1.map(|S_1| 0.5 * S_1 * e),
                |_, point, element, e| derivatives(point, element, &strain::J(point.x, point.y, e, element)),
            ];
            for of in routes {
                let worst = reference.worst_entry(&by_stress(state, of)).1;
                assert!(worst <= 30.0, "{}: {worst}", case.id);
            }
        }
    }
}
