//! The chain of the paper's computation, from the shape functions to forces and tangent, with replaceable values.
//!
//! A mistake is a wrong value of one quantity, its root. What follows from it is the value of any later quantity: each is computed from
//! its inputs, at the state's points and at quadrature points, with the wrong value in place of the right one.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use nalgebra::{Matrix2, Matrix3, RowSVector, SMatrix, Vector2, Vector3};

use super::entries::rows;
use super::quadrature::exact;
use ancf::equations::element::Matrix14;
use ancf::equations::material::{self as law, LameConstants};
use ancf::equations::motion;
use ancf::equations::shape::{Matrix2x14, Vector14};
use ancf::internals::equations::volume::Point;
use ancf::state::{ElementState, evaluate};

type Matrix14x3 = SMatrix<f64, 14, 3>;

/// Values of quantities, row by row; those of a point for every point of the chain.
pub(super) type Values = BTreeMap<&'static str, Rc<Vec<f64>>>;

/// How a quantity follows from others.
struct Formula {
    quantity: &'static str,
    inputs: &'static [&'static str],
    value: fn(&Inputs) -> Option<Vec<f64>>,
}

const fn formula(
    quantity: &'static str,
    inputs: &'static [&'static str],
    value: fn(&Inputs) -> Option<Vec<f64>>,
) -> Formula {
    Formula { quantity, inputs, value }
}

const GRADIENTS: &[&str] = &["3.S_x", "3.S_y"];
const METRICS: &[&str] = &["3.S_x", "3.S_y", "9.J_0"];
const MOTION: &[&str] = &["7.M", "19.Q_e", "gravity.Q_w"];

/// Formulas that both routes to the force share.
const SHARED: &[Formula] = &[
    formula("2.S", &["3.S"], |i| i.at_points(|p| rows(&i.row_of_identities(0, p)))),
    formula("1.r", &["2.S"], |i| i.at_points(|p| rows(&(i.matrix2x14(0, p) * i.e)))),
    formula("5.rdot", &["2.S"], |i| i.at_points(|p| rows(&(i.matrix2x14(0, p) * i.edot)))),
    formula("7.M", &["2.S"], |i| {
        let at = |p: usize| i.matrix2x14(0, p).tr_mul(&i.matrix2x14(0, p));
        Some(rows(&(i.state.rho * i.integral(Matrix14::zeros(), at))))
    }),
    formula("6.T", &["7.M"], |i| Some(vec![0.5 * i.edot.dot(&(i.matrix(0, 0) * i.edot))])),
    formula("gravity.Q_w", &["2.S"], |i| {
        let g = Vector2::from(i.state.gravity);
        let at = |p: usize| i.matrix2x14(0, p).tr_mul(&g);
        Some(rows(&(i.state.rho * i.integral(Vector14::zeros(), at))))
    }),
    formula("9.J_0", GRADIENTS, |i| {
        let e0 = Vector14::from(i.state.e0);
        i.at_points(|p| rows(&i.gradient(p, &e0)))
    }),
    formula("9.J", METRICS, |i| i.at_points(|p| rows(&(i.gradient(p, &i.e) * inverse(&i.matrix2(2, p)))))),
    formula("10.epsilon_m", &["9.J"], |i| {
        let strain = |J: Matrix2<f64>| 0.5 * (J.transpose() * J - Matrix2::identity());
        i.at_points(|p| rows(&strain(i.matrix2(0, p))))
    }),
    formula("11.S_a", METRICS, |i| i.at_points(|p| rows(&i.metric(p, 0, 0)))),
    formula("11.S_b", METRICS, |i| i.at_points(|p| rows(&i.metric(p, 1, 1)))),
    formula("11.S_c", METRICS, |i| i.at_points(|p| rows(&i.metric(p, 0, 1)))),
    formula("13.epsilon_1", &["11.S_a"], |i| i.at_points(|p| vec![0.5 * (i.form(0, p) - 1.0)])),
    formula("13.epsilon_2", &["11.S_b"], |i| i.at_points(|p| vec![0.5 * (i.form(0, p) - 1.0)])),
    formula("13.epsilon_3", &["11.S_c"], |i| i.at_points(|p| vec![0.5 * i.form(0, p)])),
    formula("12.epsilon_f", &["13.epsilon_1", "13.epsilon_2", "13.epsilon_3"], |i| {
        i.at_points(|p| (0..3).map(|k| i.of[k][p]).collect())
    }),
    formula("14.epsilon", &["12.epsilon_f", "8.epsilon_T"], |i| {
        i.at_points(|p| rows(&(i.vector3(0, p) - i.vector3(1, 0))))
    }),
    formula("16.D", &["17.lambda", "17.mu"], |i| {
        Some(rows(&law::D(LameConstants { lambda: i.of[0][0], mu: i.of[1][0] })))
    }),
    formula("15.sigma", &["16.D", "14.epsilon"], |i| {
        let D = Matrix3::from_row_slice(&i.of[0]);
        i.at_points(|p| rows(&(D * i.vector3(1, p))))
    }),
    formula("18.U", &["14.epsilon", "15.sigma"], |i| {
        let at = |p: usize| i.vector3(0, p).component_mul(&Vector3::new(0.5, 0.5, 1.0)).dot(&i.vector3(1, p));
        Some(vec![i.integral(0.0, at)])
    }),
    formula("21.S_a1", &["11.S_a"], |i| i.at_points(|p| rows(&(i.matrix(0, p) + i.matrix(0, p).transpose())))),
    formula("21.S_b1", &["11.S_b"], |i| i.at_points(|p| rows(&(i.matrix(0, p) + i.matrix(0, p).transpose())))),
    formula("21.S_c1", &["11.S_c"], |i| i.at_points(|p| rows(&(i.matrix(0, p) + i.matrix(0, p).transpose())))),
    formula("21.K_1", &["21.S_a1", "21.S_b1", "11.S_a", "11.S_b", "8.epsilon_T"], |i| {
        Some(rows(&i.stiffness(|p| [(0, i.bracket(2, 0, p)), (1, i.bracket(3, 1, p))])))
    }),
    formula("21.K_2", &["21.S_a1", "21.S_b1", "11.S_a", "11.S_b", "8.epsilon_T"], |i| {
        Some(rows(&i.stiffness(|p| [(0, i.bracket(3, 1, p)), (1, i.bracket(2, 0, p))])))
    }),
    formula("21.K_3", &["21.S_c1", "11.S_c", "8.epsilon_T"], |i| {
        Some(rows(&i.stiffness(|p| [(0, i.form(1, p) - 2.0 * i.of[2][2]), (0, 0.0)])))
    }),
    formula("20.K", &["17.lambda", "17.mu", "21.K_1", "21.K_2", "21.K_3"], |i| {
        let (lambda, mu) = (i.of[0][0], i.of[1][0]);
        let K = (lambda + 2.0 * mu) * i.matrix(2, 0) + lambda * i.matrix(3, 0) + 4.0 * mu * i.matrix(4, 0);
        Some(rows(&K))
    }),
    formula("22.residual", MOTION, |i| {
        Some(rows(&motion::residual(&i.matrix(0, 0), &i.edot, &i.vector(1), &i.vector(2))))
    }),
    formula("22.eddot", MOTION, |i| {
        motion::acceleration(&i.matrix(0, 0), &i.vector(1), &i.vector(2)).map(|a| rows(&a))
    }),
];

/// The paper's route: (19) from (20), and the tangent from K and a material part.
const BY_STIFFNESS: &[Formula] = &[
    formula("19.Q_e", &["20.K"], |i| Some(rows(&i.matrix(0, 0).tr_mul(&i.e)))),
    formula("tangent.dQ_e", &["20.K", "17.lambda", "17.mu", "21.S_a1", "21.S_b1", "21.S_c1"], |i| {
        let (lambda, mu) = (i.of[1][0], i.of[2][0]);
        let D = Matrix3::new(lambda + 2.0 * mu, lambda, 0.0, lambda, lambda + 2.0 * mu, 0.0, 0.0, 0.0, 4.0 * mu);
        Some(rows(&(i.matrix(0, 0) + i.material([3, 4, 5], &D))))
    }),
];

/// The usual route: the force is the integral of the stresses times the derivatives of the strains.
const BY_STRESS: &[Formula] = &[
    formula("19.Q_e", &["15.sigma", "21.S_a1", "21.S_b1", "21.S_c1"], |i| {
        let at = |p: usize| {
            let s = i.vector3(0, p);
            0.5 * (s[0] * i.matrix(1, p) + s[1] * i.matrix(2, p) + 2.0 * s[2] * i.matrix(3, p)) * i.e
        };
        Some(rows(&i.integral(Vector14::zeros(), at)))
    }),
    formula("tangent.dQ_e", &["15.sigma", "16.D", "21.S_a1", "21.S_b1", "21.S_c1"], |i| {
        let at = |p: usize| {
            let s = i.vector3(0, p);
            0.5 * (s[0] * i.matrix(2, p) + s[1] * i.matrix(3, p) + 2.0 * s[2] * i.matrix(4, p))
        };
        let mut D = Matrix3::from_row_slice(&i.of[1]);
        D.row_mut(2).scale_mut(2.0);
        Some(rows(&(i.integral(Matrix14::zeros(), at) + i.material([2, 3, 4], &D))))
    }),
];

/// The same route with strains from the deformation gradient: their derivatives have J in them.
const BY_GRADIENT: &[Formula] = &[
    formula("13.epsilon_1", &["10.epsilon_m"], |i| i.at_points(|p| vec![i.matrix2(0, p)[(0, 0)]])),
    formula("13.epsilon_2", &["10.epsilon_m"], |i| i.at_points(|p| vec![i.matrix2(0, p)[(1, 1)]])),
    formula("13.epsilon_3", &["10.epsilon_m"], |i| i.at_points(|p| vec![i.matrix2(0, p)[(0, 1)]])),
    formula("19.Q_e", &["3.S_x", "3.S_y", "9.J_0", "9.J", "15.sigma"], |i| {
        let at = |p: usize| {
            let (s, [one, two, three]) = (i.vector3(4, p), i.derivatives(p));
            one * s[0] + two * s[1] + three * (2.0 * s[2])
        };
        Some(rows(&i.integral(Vector14::zeros(), at)))
    }),
    formula("tangent.dQ_e", &["3.S_x", "3.S_y", "9.J_0", "9.J", "15.sigma", "16.D"], |i| {
        let mut D = Matrix3::from_row_slice(&i.of[5]);
        D.row_mut(2).scale_mut(2.0);
        let at = |p: usize| {
            let (s, [G_1, G_2]) = (i.vector3(4, p), i.functions(p));
            let mixed = G_1.tr_mul(&G_2);
            let stress = G_1.tr_mul(&G_1) * s[0] + G_2.tr_mul(&G_2) * s[1] + (mixed + mixed.transpose()) * s[2];
            let B = Matrix14x3::from_columns(&i.derivatives(p));
            stress + B * D * B.transpose()
        };
        Some(rows(&i.integral(Matrix14::zeros(), at)))
    }),
];

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

/// Inputs of a formula.
struct Inputs<'a> {
    state: &'a ElementState,
    e: Vector14,
    edot: Vector14,
    rule: &'a [Point],
    own_points: usize,
    of: Vec<Rc<Vec<f64>>>,
}

impl Inputs<'_> {
    fn at_points(&self, of: impl Fn(usize) -> Vec<f64>) -> Option<Vec<f64>> {
        let mut all = Vec::new();
        for point in 0..self.state.points.len() {
            all.extend(of(point));
        }
        Some(all)
    }

    /// ∫ … dV over the element.
    fn integral<T: std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>>(
        &self,
        zero: T,
        at: impl Fn(usize) -> T,
    ) -> T {
        self.rule.iter().enumerate().fold(zero, |sum, (n, point)| sum + at(self.own_points + n) * point.dV)
    }

    /// Entries of input `k` at point `p`.
    fn entries(&self, k: usize, p: usize, size: usize) -> &[f64] {
        self.of.get(k).and_then(|values| values.get(p * size..(p + 1) * size)).unwrap_or_default()
    }

    fn matrix(&self, k: usize, p: usize) -> Matrix14 {
        Matrix14::from_row_slice(self.entries(k, p, 196))
    }

    fn matrix2x14(&self, k: usize, p: usize) -> Matrix2x14 {
        Matrix2x14::from_row_slice(self.entries(k, p, 28))
    }

    fn matrix2(&self, k: usize, p: usize) -> Matrix2<f64> {
        Matrix2::from_row_slice(self.entries(k, p, 4))
    }

    fn vector(&self, k: usize) -> Vector14 {
        Vector14::from_row_slice(self.entries(k, 0, 14))
    }

    fn vector3(&self, k: usize, p: usize) -> Vector3<f64> {
        Vector3::from_row_slice(self.entries(k, p, 3))
    }

    /// (2) from the seven functions, input `k`.
    fn row_of_identities(&self, k: usize, p: usize) -> Matrix2x14 {
        let s = self.entries(k, p, 7);
        Matrix2x14::from_fn(|row, column| if column % 2 == row { s[column / 2] } else { 0.0 })
    }

    /// ∂r/∂(x, y) of some coordinates; inputs 0 and 1 are S_x and S_y.
    fn gradient(&self, p: usize, e: &Vector14) -> Matrix2<f64> {
        Matrix2::from_columns(&[self.row_of_identities(0, p) * e, self.row_of_identities(1, p) * e])
    }

    /// Rows of functions that give the columns of J, from the inputs S_x, S_y and J_0.
    fn functions(&self, p: usize) -> [Matrix2x14; 2] {
        let P = inverse(&self.matrix2(2, p));
        let (S_x, S_y) = (self.row_of_identities(0, p), self.row_of_identities(1, p));
        [0, 1].map(|k| S_x * P[(0, k)] + S_y * P[(1, k)])
    }

    /// Derivatives of the three strains by e, from these functions and J as input 3.
    fn derivatives(&self, p: usize) -> [Vector14; 3] {
        let ([G_1, G_2], J) = (self.functions(p), self.matrix2(3, p));
        let (J_1, J_2) = (J.column(0), J.column(1));
        [G_1.tr_mul(&J_1), G_2.tr_mul(&J_2), 0.5 * (G_1.tr_mul(&J_2) + G_2.tr_mul(&J_1))]
    }

    /// S_a, S_b or S_c by the columns of J₀⁻¹ that it multiplies; inputs are S_x, S_y and J_0.
    fn metric(&self, p: usize, one: usize, two: usize) -> Matrix14 {
        let P = inverse(&self.matrix2(2, p));
        let (S_x, S_y) = (self.entries(0, p, 7), self.entries(1, p, 7));
        let functions =
            |k: usize| -> RowSVector<f64, 7> { RowSVector::from_fn(|_, n| S_x[n] * P[(0, k)] + S_y[n] * P[(1, k)]) };
        let product = functions(one).tr_mul(&functions(two));
        Matrix14::from_fn(|row, column| if row % 2 == column % 2 { product[(row / 2, column / 2)] } else { 0.0 })
    }

    /// eᵀS e, with S as input `k`.
    fn form(&self, k: usize, p: usize) -> f64 {
        self.e.dot(&(self.matrix(k, p) * self.e))
    }

    /// Bracket of (21) with S as input `k`, and thermal strain as input 4.
    fn bracket(&self, k: usize, component: usize, p: usize) -> f64 {
        self.form(k, p) - 1.0 - 2.0 * self.of[4][component]
    }

    /// ¼ ∫ Σ S_1 weight dV, with the inputs of S_1 and their weights at each point.
    fn stiffness(&self, weights: impl Fn(usize) -> [(usize, f64); 2]) -> Matrix14 {
        let at = |p: usize| {
            let [(one, of_one), (two, of_two)] = weights(p);
            0.25 * (self.matrix(one, p) * of_one + self.matrix(two, p) * of_two)
        };
        self.integral(Matrix14::zeros(), at)
    }

    /// ¼ ∫ Bᵀ D B dV with rows of B eᵀS_1, from inputs `k`.
    fn material(&self, k: [usize; 3], D: &Matrix3<f64>) -> Matrix14 {
        let at = |p: usize| {
            let B = k.map(|k| self.matrix(k, p) * self.e);
            let mut sum = Matrix14::zeros();
            for (row, one) in B.iter().enumerate() {
                for (column, two) in B.iter().enumerate() {
                    sum += one * two.transpose() * (0.25 * D[(row, column)]);
                }
            }
            sum
        };
        self.integral(Matrix14::zeros(), at)
    }
}

fn inverse(J_0: &Matrix2<f64>) -> Matrix2<f64> {
    let det = J_0[(0, 0)] * J_0[(1, 1)] - J_0[(0, 1)] * J_0[(1, 0)];
    Matrix2::new(J_0[(1, 1)], -J_0[(0, 1)], -J_0[(1, 0)], J_0[(0, 0)]) / det
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
