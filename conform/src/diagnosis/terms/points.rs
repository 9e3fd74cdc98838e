//! Shares of the Gauss points in the integrals of (18) and (21): a wrong weight multiplies one of them.

#![allow(non_snake_case)] // The paper's symbols are names here.

use super::term::{Term, term};
use crate::diagnosis::entries::rows;
use crate::diagnosis::quadrature::{Integrand, K, bracket, exact, integrands};
use ancf::equations::material as law;
use ancf::equations::shape::Vector14;
use ancf::internals::equations::volume::{GAUSS_3, GAUSS_5};
use ancf::state::ElementState;
use nalgebra::Vector3;

/// Groups of points with equal weight: name, and place in the rule along or across the element.
const GROUPS: [(&str, bool, [usize; 2]); 5] = [
    ("the Gauss points in the middle of the length", true, [2, 2]),
    ("the Gauss points next to the middle of the length", true, [1, 3]),
    ("the Gauss points nearest the ends", true, [0, 4]),
    ("the Gauss points on the axis", false, [1, 1]),
    ("the Gauss points off the axis", false, [0, 2]),
];

/// Shares of groups of points with equal weight.
pub(super) fn of(quantity: &str, state: &ElementState) -> Vec<Term> {
    if !matches!(quantity, "18.U" | "21.K_1" | "21.K_2" | "21.K_3") {
        return Vec::new();
    }
    let (e, eps_T) = (Vector14::from(state.e), state.eps_T());
    let D = law::D(state.moduli().into());
    let share = |(name, is_along, places): (&str, bool, [usize; 2])| {
        let rule = exact(state);
        debug_assert_eq!(rule.len(), GAUSS_5.len() * GAUSS_3.len());
        let place = |n: usize| if is_along { n / GAUSS_3.len() } else { n % GAUSS_3.len() };
        let own: Vec<_> =
            rule.into_iter().enumerate().filter(|(n, _)| places.contains(&place(*n))).map(|(_, p)| p).collect();
        let all = integrands(&e, &state.element(), &own);
        let [one, two, three] = [0, 1, 2].map(|k| move |s: &Integrand| bracket(s, &eps_T, k));
        let numbers = match quantity {
            "18.U" => {
                let density = |s: &Integrand| {
                    let eps = Vector3::new(one(s), two(s), three(s)) * 0.5;
                    0.5 * eps.component_mul(&Vector3::new(1.0, 1.0, 2.0)).dot(&(D * eps)) * s.dV
                };
                vec![all.iter().map(density).sum()]
            }
            "21.K_1" => rows(&K(&all, |s| [one(s), two(s), 0.0])),
            "21.K_2" => rows(&K(&all, |s| [two(s), one(s), 0.0])),
            _ => rows(&K(&all, |s| [0.0, 0.0, three(s)])),
        };
        term(format!("the share of {name}"), numbers)
    };
    GROUPS.map(share).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{State, Suite};

    #[test]
    fn the_shares_add_up_to_the_integral() {
        for case in &Suite::embedded().unwrap().cases {
            let State::Element(state) = &case.state else { continue };
            for quantity in ["18.U", "21.K_1", "21.K_2", "21.K_3"] {
                let shares = of(quantity, state);
                for groups in [&shares[..3], &shares[3..]] {
                    let sum = |n: usize| groups.iter().map(|term| term.numbers[n]).sum::<f64>();
                    let reference = &case.values[quantity];
                    let sums: Vec<f64> = (0..reference.numbers.len()).map(sum).collect();
                    let worst = reference.worst_entry(&sums).1;
                    assert!(worst <= 30.0, "{quantity} in {}: {worst}", case.id);
                }
            }
        }
    }
}
