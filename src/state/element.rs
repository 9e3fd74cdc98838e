//! The paper's element in one state: the value of every equation (1)–(22) and (A.1)–(A.5), of [`axis`] and of
//! [`uniaxial`].

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Vector2, Vector3};

use super::beam::ElementState;
use super::entries::rows;
use crate::equations::element::{Element, Matrix14};
use crate::equations::material::LameConstants;
use crate::equations::shape::Vector14;
use crate::equations::{axis, force, inertia, material, motion, shape, strain, uniaxial};
use crate::model::ThermalModel;

impl ElementState {
    /// Thermal strain ε_T of the state's model, in global axes: (8), or its part along or across
    /// the rod.
    pub fn eps_T(&self) -> Vector3<f64> {
        match self.model {
            ThermalModel::TwoD => strain::eps_T(self.alpha, self.dT),
            ThermalModel::OneD => strain::eps_T_1d(self.alpha, self.dT, self.theta),
            ThermalModel::Transverse => strain::eps_T_1d(self.alpha, self.dT, self.theta + FRAC_PI_2),
            ThermalModel::None => Vector3::zeros(),
        }
    }

    /// Thermal strain ε_T of the state's model, in the rod's own axes.
    pub fn eps_T_own(&self) -> Vector3<f64> {
        let [along, across] = self.model.strains(self.alpha * self.dT);
        Vector3::new(along, across, 0.0)
    }

    /// Element in its initial configuration.
    pub fn element(&self) -> Element {
        Element { l: self.l, h: self.h, w: self.w, e_0: Vector14::from(self.e0) }
    }
}

/// Value of a `quantity` of `equations/contents.rs` for the state of an element.
///
/// Matrices row by row; point quantities one point after the other. `None` for an unknown quantity, and for (22) where the
/// mass matrix is not positive definite.
///
/// ```
/// use ancf::state::{ElementState, evaluate};
///
/// # let text = r#"{"l": 2.0, "h": 0.1, "w": 0.05, "theta": 0.0, "e0": [0, 0, 0, 1, 1, 0, 1, 0, 0, 1, 2, 0, 0, 1],
/// #     "e": [0, 0, 0, 1, 1, 0, 1, 0, 0, 1, 2, 0, 0, 1], "edot": [1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0], "E": 2e8,
/// #     "nu": 0.25, "rho": 7200.0, "alpha": 1e-5, "dT": 0.0, "model": "2d", "points": [[0.5, 0.02]]}"#;
/// let state = ElementState::parse(text, "state.json")?; // at rest in its length, moving with 1 m/s
/// let T = evaluate("6.T", &state).unwrap();
/// assert!((T[0] - 0.5 * 7200.0 * 2.0 * 0.1 * 0.05).abs() < 1e-11);
/// assert_eq!(evaluate("17.mu", &state), Some(vec![8e7]));
/// assert_eq!(evaluate("24.X", &state), None);
/// # Ok::<(), ancf::error::Error>(())
/// ```
pub fn evaluate(quantity: &str, state: &ElementState) -> Option<Vec<f64>> {
    let &ElementState { l, theta, rho, .. } = state;
    let (moduli, lame) = (state.moduli(), LameConstants::from(state.moduli()));
    let (e, e_dot, element, eps_T) =
        (Vector14::from(state.e), Vector14::from(state.edot), state.element(), state.eps_T());
    let eps_T_own = state.eps_T_own();
    let nodes = shape::nodes(&e);

    let at_points = |f: &dyn Fn(f64, f64) -> Vec<f64>| Some(state.points.iter().flat_map(|&[x, y]| f(x, y)).collect());
    let S_abc = |x, y| strain::S_abc(x, y, &element);
    let S_abc_theta = |x, y| strain::S_abc_theta(x, y, l, theta);
    let eps_123 = |x, y| {
        let (S_a, S_b, S_c) = S_abc(x, y);
        (strain::eps_1(&e, &S_a), strain::eps_2(&e, &S_b), strain::eps_3(&e, &S_c))
    };
    let eps_f = |x, y| {
        let (eps_1, eps_2, eps_3) = eps_123(x, y);
        strain::eps_f(eps_1, eps_2, eps_3)
    };
    let eps = |x, y| strain::eps(&eps_f(x, y), &eps_T);
    let K_123 =
        || (force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element), force::K_3(&e, &eps_T, &element));
    let K_of = |sum: fn(LameConstants, &Matrix14, &Matrix14, &Matrix14) -> Matrix14| {
        let (K_1, K_2, K_3) = K_123();
        sum(lame, &K_1, &K_2, &K_3)
    };
    let Q_w = || inertia::Q_w_gravity(&Vector2::from(state.gravity), rho, &element);
    let M = || inertia::M(rho, &element);
    let e_ddot = || motion::acceleration(&M(), &force::Q_e(&e, &K_of(force::K)), &Q_w());

    match quantity {
        "1.r" => at_points(&|x, y| rows(&shape::r(x, y, &e, l))),
        "2.S" | "A.5.S" => at_points(&|x, y| rows(&shape::S(x, y, l))),
        "3.S" => at_points(&|x, y| shape::S_i(x, y, l).to_vec()),
        "3.S_x" => at_points(&|x, y| shape::S_i_x(x, y, l).to_vec()),
        "3.S_y" => at_points(&|x, y| shape::S_i_y(x, y, l).to_vec()),
        "4.nodes" => Some(
            [nodes.r_i, nodes.r_y_i, nodes.r_j, nodes.r_x_j, nodes.r_y_j, nodes.r_k, nodes.r_y_k]
                .iter()
                .flat_map(rows)
                .collect(),
        ),
        "5.rdot" => at_points(&|x, y| rows(&shape::r_dot(x, y, &e_dot, l))),
        "6.T" => Some(vec![inertia::T_integral(&e_dot, rho, &element)]),
        "6.T/matrix" => Some(vec![inertia::T(&M(), &e_dot)]),
        "7.M" => Some(rows(&M())),
        "8.epsilon_T" => Some(rows(&eps_T)),
        "9.J_0" => at_points(&|x, y| rows(&strain::J_0(x, y, &element))),
        "9.J_0/theta" => at_points(&|_, _| rows(&strain::J_0_theta(theta))),
        "9.J" => at_points(&|x, y| rows(&strain::J(x, y, &e, &element))),
        "10.epsilon_m" => at_points(&|x, y| rows(&strain::eps_m(&strain::J(x, y, &e, &element)))),
        "11.S_a" => at_points(&|x, y| rows(&S_abc_theta(x, y).0)),
        "11.S_b" => at_points(&|x, y| rows(&S_abc_theta(x, y).1)),
        "11.S_c" => at_points(&|x, y| rows(&S_abc_theta(x, y).2)),
        "11.S_a/general" => at_points(&|x, y| rows(&S_abc(x, y).0)),
        "11.S_b/general" => at_points(&|x, y| rows(&S_abc(x, y).1)),
        "11.S_c/general" => at_points(&|x, y| rows(&S_abc(x, y).2)),
        "12.epsilon_f" => at_points(&|x, y| rows(&eps_f(x, y))),
        "13.epsilon_1" => at_points(&|x, y| vec![eps_123(x, y).0]),
        "13.epsilon_2" => at_points(&|x, y| vec![eps_123(x, y).1]),
        "13.epsilon_3" => at_points(&|x, y| vec![eps_123(x, y).2]),
        "14.epsilon" => at_points(&|x, y| rows(&eps(x, y))),
        "15.sigma" => at_points(&|x, y| rows(&material::sigma(&material::D(lame), &eps(x, y)))),
        "16.D" => Some(rows(&material::D(lame))),
        "17.lambda" => Some(vec![material::lambda(moduli)]),
        "17.mu" => Some(vec![material::mu(moduli)]),
        "18.U" => Some(vec![force::U(&e, &eps_T, lame, &element)]),
        "18.U/printed-shear" => Some(vec![force::U_printed(&e, &eps_T, lame, &element)]),
        "19.Q_e" => Some(rows(&force::Q_e(&e, &K_of(force::K)))),
        "19.Q_e/printed-shear" => Some(rows(&force::Q_e(&e, &K_of(force::K_printed)))),
        "20.K" => Some(rows(&K_of(force::K))),
        "20.K/printed-shear" => Some(rows(&K_of(force::K_printed))),
        "21.S_a1" => at_points(&|x, y| rows(&force::S_1(&S_abc(x, y).0))),
        "21.S_b1" => at_points(&|x, y| rows(&force::S_1(&S_abc(x, y).1))),
        "21.S_c1" => at_points(&|x, y| rows(&force::S_1(&S_abc(x, y).2))),
        "21.K_1" => Some(rows(&K_123().0)),
        "21.K_2" => Some(rows(&K_123().1)),
        "21.K_3" => Some(rows(&K_123().2)),
        "21.K_3/printed" => Some(rows(&force::K_3_printed(&e, &element))),
        "22.eddot" => Some(rows(&e_ddot()?)),
        // For an acceleration that does not solve (22): the numbers of ė, taken per second.
        "22.residual" => Some(rows(&motion::residual(&M(), &e_dot, &force::Q_e(&e, &K_of(force::K)), &Q_w()))),
        "tangent.dQ_e" => Some(rows(&force::tangent(&e, &eps_T, lame, &element))),
        "tangent.dQ_e/printed-shear" => Some(rows(&force::tangent_printed(&e, &eps_T, lame, &element))),
        "gravity.Q_w" => Some(rows(&Q_w())),
        "axis.D_0" => Some(rows(&axis::D_0(moduli))),
        "axis.epsilon" => at_points(&|x, y| rows(&axis::epsilon(x, y, &e, &eps_T_own, l))),
        "axis.U" => Some(vec![axis::U(&e, &eps_T_own, moduli, &element)]),
        "axis.Q_e" => Some(rows(&axis::Q_e(&e, &eps_T_own, moduli, &element))),
        "axis.tangent" => Some(rows(&axis::tangent(&e, &eps_T_own, moduli, &element))),
        "uniaxial.D" => Some(rows(&uniaxial::D(moduli))),
        "uniaxial.U" => Some(vec![uniaxial::U(&e, &eps_T_own, moduli, &element)]),
        "uniaxial.Q_e" => Some(rows(&uniaxial::Q_e(&e, &eps_T_own, moduli, &element))),
        "uniaxial.tangent" => Some(rows(&uniaxial::tangent(&e, &eps_T_own, moduli, &element))),
        "A.1.r" => at_points(&|x, y| rows(&shape::r_polynomial(x, y, &shape::coefficients(&nodes, l)))),
        "A.1.r_x" => at_points(&|x, y| rows(&shape::r_polynomial_x(x, y, &shape::coefficients(&nodes, l)))),
        "A.1.r_y" => at_points(&|x, y| rows(&shape::r_polynomial_y(x, y, &shape::coefficients(&nodes, l)))),
        "A.2.e" => Some(rows(&shape::e(&shape::nodal_conditions(&shape::coefficients(&nodes, l), l)))),
        "A.3.coefficients" => Some(shape::coefficients(&nodes, l).iter().flat_map(rows).collect()),
        "A.3.coefficients/printed" => Some(shape::coefficients_printed(&nodes, l).iter().flat_map(rows).collect()),
        "A.4.r" => at_points(&|x, y| rows(&shape::r_nodal(x, y, &nodes, l))),
        "A.5.e" => Some(rows(&shape::e(&nodes))),
        _ => None,
    }
}
