//! The chain of the paper's computation, from the shape functions to forces and tangent, with replaceable values.
//!
//! A mistake is a wrong value of one quantity, its root. What follows from it is the value of any later quantity: each is computed from
//! its inputs, at the state's points and at quadrature points, with the wrong value in place of the right one.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use nalgebra::Matrix2;

use super::entries::rows;
use super::formulas::{BY_GRADIENT, BY_STIFFNESS, BY_STRESS, Formula, Inputs, SHARED};
use super::quadrature::exact;
use ancf::equations::shape::Vector14;
use ancf::internals::equations::volume::Point;
use ancf::state::{ElementState, evaluate};

/// Values of quantities, row by row; those of a point for every point of the chain.
pub(super) type Values = BTreeMap<&'static str, Rc<Vec<f64>>>;

/// Routes from the shape functions to the force.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Route {
    /// The paper's, over K.
    Stiffness,
    /// Over stresses and the products of (11).
    Stress,
    /// Over stresses and the deformation gradient.
    Gradient,
}

impl Route {
    const ALL: [Route; 3] = [Route::Stiffness, Route::Stress, Route::Gradient];

    fn of(replaced: &Values) -> Route {
        let acts = |roots: &[&str]| replaced.keys().any(|root| roots.contains(root));
        if acts(ROOTS_OF_GRADIENT) {
            Route::Gradient
        } else if acts(ROOTS_OF_STRESS) {
            Route::Stress
        } else {
            Route::Stiffness
        }
    }

    fn formulas(self) -> &'static [Formula] {
        match self {
            Route::Stiffness => BY_STIFFNESS,
            Route::Stress => BY_STRESS,
            Route::Gradient => BY_GRADIENT,
        }
    }
}

/// Roots that act on the force only by the route over the deformation gradient.
const ROOTS_OF_GRADIENT: &[&str] = &["9.J", "10.epsilon_m"];
/// Roots that act on the force only by a route over stresses.
const ROOTS_OF_STRESS: &[&str] = &[
    "9.J",
    "10.epsilon_m",
    "12.epsilon_f",
    "13.epsilon_1",
    "13.epsilon_2",
    "13.epsilon_3",
    "14.epsilon",
    "15.sigma",
    "16.D",
];

/// Whether some of these roots act on the force only by the route over stresses.
pub(super) fn is_by_stress(roots: &[&str]) -> bool {
    roots.iter().any(|root| ROOTS_OF_STRESS.contains(root))
}

fn formula_of(quantity: &str, route: Route) -> Option<&'static Formula> {
    route.formulas().iter().chain(SHARED).find(|formula| formula.quantity == quantity)
}

/// Quantities before `quantity` in the chain, by all routes.
pub(super) fn ancestors(quantity: &str) -> BTreeSet<&'static str> {
    let mut all = BTreeSet::new();
    for route in Route::ALL {
        let inputs = formula_of(quantity, route).map_or(&[][..], |formula| formula.inputs);
        for input in inputs {
            if all.insert(*input) {
                all.extend(ancestors(input));
            }
        }
    }
    all
}

/// Whether a quantity depends on one of the replaced ones.
fn depends(quantity: &str, route: Route, replaced: &Values) -> bool {
    replaced.contains_key(quantity)
        || formula_of(quantity, route)
            .is_some_and(|formula| formula.inputs.iter().any(|input| depends(input, route, replaced)))
}

/// The chain in one state.
pub(super) struct Chain {
    /// The state; its points are its own, then those of the quadrature.
    pub everywhere: ElementState,
    /// Number of the state's own points.
    own_points: usize,
    rule: Vec<Point>,
    right: RefCell<Values>,
}

impl Chain {
    /// The chain in a state.
    pub fn new(state: &ElementState) -> Chain {
        let rule = exact(state);
        let mut everywhere = state.clone();
        everywhere.points.extend(rule.iter().map(|point| [point.x, point.y]));
        Chain { everywhere, own_points: state.points.len(), rule, right: RefCell::default() }
    }

    /// Right value of a quantity, everywhere.
    pub fn right(&self, quantity: &'static str) -> Option<Rc<Vec<f64>>> {
        let known = self.right.borrow().get(quantity).cloned();
        known.or_else(|| {
            let value = Rc::new(evaluate(quantity, &self.everywhere)?);
            self.right.borrow_mut().insert(quantity, Rc::clone(&value));
            Some(value)
        })
    }

    /// The J_0 with which a wrong J is the gradient times its inverse; `None` if it has none.
    pub fn multiplied_from_the_right(&self, J: &[f64]) -> Option<Vec<f64>> {
        let (right, J_0) = (self.right("9.J")?, self.right("9.J_0")?);
        let mut all = Vec::new();
        for ((wrong, right), J_0) in J.chunks_exact(4).zip(right.chunks_exact(4)).zip(J_0.chunks_exact(4)) {
            let [wrong, right, J_0] = [wrong, right, J_0].map(Matrix2::from_row_slice);
            // The gradient is J J_0, so that J_0 follows from wrong = J J_0 X⁻¹.
            all.extend(rows(&(wrong.try_inverse()? * right * J_0)));
        }
        Some(all)
    }

    /// Value of a quantity, at the state's own points, with replaced values of others; `None` if it does not depend on them.
    pub fn value(&self, quantity: &str, replaced: &Values) -> Option<Vec<f64>> {
        let route = Route::of(replaced);
        if !depends(quantity, route, replaced) {
            return None;
        }
        let value = self.with(quantity, route, replaced, &mut Values::new())?;
        let points = self.everywhere.points.len();
        // A quantity of a point has a multiple of the number of points, and the element's quantities have not.
        match is_of_a_point(quantity) {
            true => value.get(..value.len() / points * self.own_points).map(<[f64]>::to_vec),
            false => Some(value.to_vec()),
        }
    }

    fn with(&self, quantity: &str, route: Route, replaced: &Values, known: &mut Values) -> Option<Rc<Vec<f64>>> {
        if let Some(value) = replaced.get(quantity).or_else(|| known.get(quantity)) {
            return Some(Rc::clone(value));
        }
        let formula = formula_of(quantity, route)?;
        let input = |this: &Chain, known: &mut Values, name: &'static str| {
            if depends(name, route, replaced) { this.with(name, route, replaced, known) } else { this.right(name) }
        };
        let of = formula.inputs.iter().map(|name| input(self, known, name)).collect::<Option<Vec<_>>>()?;
        let state = &self.everywhere;
        let (e, edot) = (Vector14::from(state.e), Vector14::from(state.edot));
        let inputs = Inputs { state, e, edot, rule: &self.rule, own_points: self.own_points, of };
        let value = Rc::new((formula.value)(&inputs)?);
        known.insert(formula.quantity, Rc::clone(&value));
        Some(value)
    }
}

/// Whether a quantity of the chain has a value at each point.
pub(super) fn is_of_a_point(quantity: &str) -> bool {
    const OF_THE_ELEMENT: [&str; 6] = ["6.T", "7.M", "8.epsilon_T", "16.D", "17.lambda", "17.mu"];
    let equation = quantity.split('.').next().unwrap_or_default();
    !OF_THE_ELEMENT.contains(&quantity)
        && !quantity.starts_with("21.K_")
        && !matches!(equation, "4" | "18" | "19" | "20" | "22" | "gravity" | "tangent")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{State, Suite};

    /// The chain with right values gives the reference values by both routes: from (3) on, and from every formula's inputs.
    #[test]
    fn the_chain_gives_the_reference_values() {
        for case in &Suite::embedded().unwrap().cases {
            let State::Element(state) = &case.state else { continue };
            let chain = Chain::new(state);
            let roots = |names: &[&'static str]| -> Values {
                names.iter().map(|name| (*name, chain.right(name).unwrap())).collect()
            };
            let from_functions = roots(&["3.S", "3.S_x", "3.S_y"]);
            let mut by_stress = from_functions.clone();
            by_stress.extend(roots(&["16.D"]));
            let mut by_gradient = from_functions.clone();
            by_gradient.extend(roots(&["9.J"]));
            for formula in SHARED.iter().chain(BY_STIFFNESS) {
                for replaced in [&from_functions, &by_stress, &by_gradient] {
                    let Some(value) = chain.value(formula.quantity, replaced) else { continue };
                    let reference = &case.values[formula.quantity];
                    let worst = reference.worst_entry(&value).1;
                    assert!(worst <= 30.0, "{} in {}: {worst}", formula.quantity, case.id);
                }
            }
            for formula in SHARED.iter().chain(BY_STIFFNESS).chain(BY_STRESS).chain(BY_GRADIENT) {
                let replaced = roots(&formula.inputs[..1]);
                let value = chain.value(formula.quantity, &replaced).unwrap();
                let worst = case.values[formula.quantity].worst_entry(&value).1;
                assert!(worst <= 30.0, "{} in {}: {worst}", formula.quantity, case.id);
            }
        }
    }
}
