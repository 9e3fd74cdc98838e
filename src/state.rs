//! One element in one state, a [`cable`] element too, or the terms of (23) for a structure, and the value of every equation for it.
//!
//! The JSON shape of an element state is a contract: fixtures and other programs use it too.

#![allow(non_snake_case)] // The paper's symbols are names here.

use crate::equations::force::{Element, Matrix14};
use crate::equations::shape::Vector14;
use crate::equations::{axis, force, inertia, material, motion, shape, strain};
pub use crate::model::ThermalModel;
use nalgebra::{DMatrix, DVector, Dim, Matrix, RawStorage, Vector2, Vector3};
use serde::{Deserialize, Serialize};

pub mod cable;
mod check;

pub use cable::{CableState, evaluate_cable};

/// An element state: geometry, motion, material, temperature and the points to look at. SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ElementState {
    /// Length, m.
    pub l: f64,
    /// Height of the section (in the plane), m.
    pub h: f64,
    /// Width of the section (across the plane), m.
    pub w: f64,
    /// Initial inclination, rad.
    pub theta: f64,
    /// Nodal coordinates of the initial configuration, in the order of (4).
    pub e0: [f64; 14],
    /// Nodal coordinates.
    pub e: [f64; 14],
    /// Their rates.
    pub edot: [f64; 14],
    /// Young's modulus, Pa.
    pub E: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Density, kg/m³.
    pub rho: f64,
    /// Coefficient of thermal expansion, 1/K.
    pub alpha: f64,
    /// Change of temperature, K.
    pub dT: f64,
    /// Direction of the thermal strain.
    pub model: ThermalModel,
    /// Points (x, y) of the element at which point quantities are evaluated, m.
    pub points: Vec<[f64; 2]>,
    /// Gravity, m/s²; \[0, 0\] where left out.
    #[serde(default)]
    pub gravity: [f64; 2],
}

impl ElementState {
    /// Thermal strain of the state's model, in global axes.
    pub fn eps_T(&self) -> Vector3<f64> {
        match self.model {
            ThermalModel::TwoD => strain::eps_T(self.alpha, self.dT),
            ThermalModel::OneD => strain::eps_T_1d(self.alpha, self.dT, self.theta),
            ThermalModel::None => Vector3::zeros(),
        }
    }

    /// The same in the rod's own axes.
    pub fn eps_T_own(&self) -> Vector3<f64> {
        match self.model {
            ThermalModel::OneD => strain::eps_T_1d(self.alpha, self.dT, 0.0),
            ThermalModel::TwoD | ThermalModel::None => self.eps_T(),
        }
    }

    /// The element in its initial configuration.
    pub fn element(&self) -> Element {
        Element { l: self.l, h: self.h, w: self.w, e_0: Vector14::from(self.e0) }
    }
}

/// The numbers of a matrix, row by row.
fn rows<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(matrix: &Matrix<f64, R, C, S>) -> Vec<f64> {
    matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect()
}

/// The value of a quantity of [`CONTENTS`](crate::equations::CONTENTS), row by row; for a point quantity one point after the other.
///
/// `None` where there is no such quantity or, for (22), where the mass matrix is not positive definite.
pub fn evaluate(quantity: &str, state: &ElementState) -> Option<Vec<f64>> {
    let &ElementState { l, theta, E, nu, rho, .. } = state;
    let (e, e_dot, element, eps_T) =
        (Vector14::from(state.e), Vector14::from(state.edot), state.element(), state.eps_T());
    let eps_T_own = state.eps_T_own();
    let (lambda, mu) = (material::lambda(E, nu), material::mu(E, nu));
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
    let K_of = |sum: fn(f64, f64, &Matrix14, &Matrix14, &Matrix14) -> Matrix14| {
        let (K_1, K_2, K_3) = K_123();
        sum(lambda, mu, &K_1, &K_2, &K_3)
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
        "15.sigma" => at_points(&|x, y| rows(&material::sigma(&material::D(lambda, mu), &eps(x, y)))),
        "16.D" => Some(rows(&material::D(lambda, mu))),
        "17.lambda" => Some(vec![lambda]),
        "17.mu" => Some(vec![mu]),
        "18.U" => Some(vec![force::U(&e, &eps_T, lambda, mu, &element)]),
        "18.U/printed-shear" => Some(vec![force::U_printed(&e, &eps_T, lambda, mu, &element)]),
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
        "tangent.dQ_e" => Some(rows(&force::tangent(&e, &eps_T, lambda, mu, &element))),
        "tangent.dQ_e/printed-shear" => Some(rows(&force::tangent_printed(&e, &eps_T, lambda, mu, &element))),
        "gravity.Q_w" => Some(rows(&Q_w())),
        "axis.D_0" => Some(rows(&axis::D_0(E, nu))),
        "axis.epsilon" => at_points(&|x, y| rows(&axis::epsilon(x, y, &e, &eps_T_own, l))),
        "axis.U" => Some(vec![axis::U(&e, &eps_T_own, E, nu, &element)]),
        "axis.Q_e" => Some(rows(&axis::Q_e(&e, &eps_T_own, E, nu, &element))),
        "axis.tangent" => Some(rows(&axis::tangent(&e, &eps_T_own, E, nu, &element))),
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

/// The terms of (23) for a structure of n coordinates and c constraints. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemState {
    /// Mass matrix, n × n.
    pub m: DMatrix<f64>,
    /// Accelerations, n.
    pub q_ddot: DVector<f64>,
    /// Elastic forces k(ΔT) q, n.
    pub kq: DVector<f64>,
    /// Derivative of the constraints, c × n.
    pub Phi_q: DMatrix<f64>,
    /// Multipliers, c.
    pub lambda: DVector<f64>,
    /// External forces, n.
    pub f: DVector<f64>,
}

/// The value of a quantity of (23) in [`CONTENTS`](crate::equations::CONTENTS).
///
/// `None` where there is no such quantity, the printed form is not defined, or the matrix of (23) is singular.
pub fn evaluate_system(quantity: &str, state: &SystemState) -> Option<Vec<f64>> {
    let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = state;
    let force = || motion::constraint_force(Phi_q, lambda);
    let force_printed = || motion::constraint_force_printed(Phi_q, lambda);
    let residual = |force: &DVector<f64>| rows(&motion::system_residual(m, q_ddot, kq, force, f));
    match quantity {
        "23.constraint_force" => Some(rows(&force())),
        "23.constraint_force/printed" => Some(rows(&force_printed()?)),
        "23.residual" => Some(residual(&force())),
        "23.residual/printed" => Some(residual(&force_printed()?)),
        "23.acceleration" => Some(rows(&motion::system_acceleration(m, kq, Phi_q, f)?.0)),
        "23.lambda" => Some(rows(&motion::system_acceleration(m, kq, Phi_q, f)?.1)),
        _ => None,
    }
}
