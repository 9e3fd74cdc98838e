//! Formulas of the chain: how each quantity follows from its inputs, on the paper's route and on others.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::rc::Rc;

use nalgebra::{Matrix2, Matrix3, RowSVector, SMatrix, Vector2, Vector3};

use super::entries::rows;
use ancf::equations::element::Matrix14;
use ancf::equations::material::{self as law, LameConstants};
use ancf::equations::motion;
use ancf::equations::shape::{Matrix2x14, Vector14};
use ancf::internals::equations::volume::Point;
use ancf::state::ElementState;

type Matrix14x3 = SMatrix<f64, 14, 3>;

/// How a quantity follows from others.
pub(super) struct Formula {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Names of its inputs.
    pub inputs: &'static [&'static str],
    /// Its value from theirs.
    pub value: fn(&Inputs) -> Option<Vec<f64>>,
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
pub(super) const SHARED: &[Formula] = &[
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
pub(super) const BY_STIFFNESS: &[Formula] = &[
    formula("19.Q_e", &["20.K"], |i| Some(rows(&i.matrix(0, 0).tr_mul(&i.e)))),
    formula("tangent.dQ_e", &["20.K", "17.lambda", "17.mu", "21.S_a1", "21.S_b1", "21.S_c1"], |i| {
        let (lambda, mu) = (i.of[1][0], i.of[2][0]);
        let D = Matrix3::new(lambda + 2.0 * mu, lambda, 0.0, lambda, lambda + 2.0 * mu, 0.0, 0.0, 0.0, 4.0 * mu);
        Some(rows(&(i.matrix(0, 0) + i.material([3, 4, 5], &D))))
    }),
];

/// The usual route: the force is the integral of the stresses times the derivatives of the strains.
pub(super) const BY_STRESS: &[Formula] = &[
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
pub(super) const BY_GRADIENT: &[Formula] = &[
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

/// Inputs of a formula.
pub(super) struct Inputs<'a> {
    /// The state; its points are its own, then those of the quadrature.
    pub state: &'a ElementState,
    /// Its e.
    pub e: Vector14,
    /// Its ė.
    pub edot: Vector14,
    /// Points of the quadrature.
    pub rule: &'a [Point],
    /// Number of the state's own points.
    pub own_points: usize,
    /// Values of the inputs.
    pub of: Vec<Rc<Vec<f64>>>,
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
