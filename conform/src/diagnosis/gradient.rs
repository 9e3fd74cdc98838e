//! Mistakes in (9), (10), (11) and in the products of (21).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Matrix2;

use super::candidate::{Candidate, candidate};
use super::entries::rows;
use super::mistake::MistakeKind::{self, Factor, Missing, Other, Sign, Transpose};
use ancf::equations::element::Matrix14;
use ancf::equations::force::S_1;
use ancf::equations::shape::{self, Vector14};
use ancf::equations::strain;
use ancf::state::ElementState;

/// Value of a quantity with a mistake, at one point.
type Wrong = fn(&Gradients) -> Vec<f64>;

/// Candidates with their values at every point of the state.
fn at_points<'a, const N: usize>(
    state: &'a ElementState,
    list: [(MistakeKind, &'static str, Wrong); N],
) -> Vec<Candidate<'a>> {
    let value = move |of: Wrong| state.points.iter().flat_map(|&[x, y]| of(&Gradients::at(state, x, y))).collect();
    list.map(|(kind, what, of)| candidate(kind, what, move || value(of))).into()
}

/// Gradients and products of (9) to (11) at one point.
struct Gradients {
    /// Current gradient ∂r/∂(x, y), of e.
    now: Matrix2<f64>,
    /// Initial gradient J_0, of e₀.
    first: Matrix2<f64>,
    /// J_0⁻¹.
    inverse: Matrix2<f64>,
    /// J.
    J: Matrix2<f64>,
    /// S_a, S_b, S_c.
    S: [Matrix14; 3],
}

impl Gradients {
    fn at(state: &ElementState, x: f64, y: f64) -> Gradients {
        let (e, element) = (Vector14::from(state.e), state.element());
        let first = strain::J_0(x, y, &element);
        let now = Matrix2::from_columns(&[shape::S_x(x, y, state.l) * e, shape::S_y(x, y, state.l) * e]);
        let (S_a, S_b, S_c) = strain::S_abc(x, y, &element);
        let inverse = first.try_inverse().unwrap_or_else(Matrix2::zeros);
        Gradients { now, first, inverse, J: now * inverse, S: [S_a, S_b, S_c] }
    }
}

impl Gradients {
    /// J_0⁻¹ with its entries (1, 2) and (2, 1) multiplied.
    fn inverse_with_signs(&self, of_12: f64, of_21: f64) -> Matrix2<f64> {
        self.inverse.component_mul(&Matrix2::new(1.0, of_12, of_21, 1.0))
    }
}

/// Candidates for S_a, S_b and S_c.
fn metrics<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let which = match quantity {
        "11.S_a" => 0,
        "11.S_b" => 1,
        _ => 2,
    };
    // The closed form of (11), with its squares and with numbers in their places.
    let closed = move |squares: fn(f64, f64) -> [f64; 2], theta: f64| {
        let (sin, cos) = theta.sin_cos();
        let ([cc, ss], sc) = (squares(cos, sin), sin * cos);
        let factors = [[cc, -sc, -sc, ss], [ss, sc, sc, cc], [sc, cc, -ss, -sc]][which];
        let at = |&[x, y]: &[f64; 2]| {
            let (S_x, S_y) = (shape::S_x(x, y, state.l), shape::S_y(x, y, state.l));
            let products = [S_x.tr_mul(&S_x), S_x.tr_mul(&S_y), S_y.tr_mul(&S_x), S_y.tr_mul(&S_y)];
            rows(&products.iter().zip(factors).fold(Matrix14::zeros(), |S, (product, by)| S + product * by))
        };
        state.points.iter().flat_map(at).collect()
    };
    let theta = state.theta;
    let now = (state.e[11] - state.e[1]).atan2(state.e[10] - state.e[0]);
    let mut all = vec![
        candidate(Other, "θ of the present chord from r_i to r_k for θ", move || {
            closed(|cos, sin| [cos * cos, sin * sin], now)
        }),
        candidate(Other, "cos θ for cos²θ", move || closed(|cos, sin| [cos, sin * sin], theta)),
        candidate(Other, "sin θ for sin²θ", move || closed(|cos, sin| [cos * cos, sin], theta)),
        candidate(Other, "cos θ and sin θ for their squares", move || closed(|cos, sin| [cos, sin], theta)),
    ];
    if quantity == "11.S_c" {
        all.extend(at_points(
            state,
            [(Factor, "S_cᵀ + S_c, symmetrised already: twice the shear", |g| rows(&S_1(&g.S[2])))],
        ));
    }
    all
}

fn I() -> Matrix2<f64> {
    Matrix2::identity()
}

/// Candidates for a quantity of (9) to (11) and (21).
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    match quantity {
        "9.J" => at_points(
            state,
            [
                (Transpose, "J_0⁻ᵀ for J_0⁻¹", |g| rows(&(g.now * g.inverse.transpose()))),
                (Transpose, "J_0⁻¹ multiplied from the left", |g| rows(&(g.inverse * g.now))),
                (Transpose, "the gradient transposed before J_0⁻¹", |g| rows(&(g.now.transpose() * g.inverse))),
                (Other, "J_0 for J_0⁻¹", |g| rows(&(g.now * g.first))),
                (Missing, "without J_0⁻¹", |g| rows(&g.now)),
                (Sign, "J_0⁻¹ without its minus signs", |g| rows(&(g.now * g.inverse_with_signs(-1.0, -1.0)))),
                (Sign, "J_0⁻¹ without the minus sign of its entry (1, 2)", |g| {
                    rows(&(g.now * g.inverse_with_signs(-1.0, 1.0)))
                }),
                (Sign, "J_0⁻¹ without the minus sign of its entry (2, 1)", |g| {
                    rows(&(g.now * g.inverse_with_signs(1.0, -1.0)))
                }),
                (Other, "the inverse: ∂r_0/∂r", |g| rows(&g.J.try_inverse().unwrap_or_else(Matrix2::zeros))),
                (Other, "the initial r_x for the current one", |g| {
                    rows(&(Matrix2::from_columns(&[g.first.column(0), g.now.column(1)]) * g.inverse))
                }),
                (Other, "the initial r_y for the current one", |g| {
                    rows(&(Matrix2::from_columns(&[g.now.column(0), g.first.column(1)]) * g.inverse))
                }),
            ],
        ),
        "10.epsilon_m" => at_points(
            state,
            [
                (Transpose, "J Jᵀ for Jᵀ J", |g| rows(&(0.5 * (g.J * g.J.transpose() - I())))),
                (Transpose, "J J for Jᵀ J", |g| rows(&(0.5 * (g.J * g.J - I())))),
                (Other, "½ (J + Jᵀ) − I, the small strain", |g| rows(&(0.5 * (g.J + g.J.transpose()) - I()))),
                (Other, "½ (I − J⁻ᵀJ⁻¹), the Almansi strain", |g| {
                    let back = g.J.try_inverse().unwrap_or_else(Matrix2::zeros);
                    rows(&(0.5 * (I() - back.transpose() * back)))
                }),
                (Other, "1 subtracted from all entries of JᵀJ", |g| {
                    rows(&(0.5 * (g.J.transpose() * g.J).add_scalar(-1.0)))
                }),
                (Missing, "1 subtracted from the first entry of JᵀJ alone", |g| {
                    rows(&(0.5 * (g.J.transpose() * g.J - Matrix2::new(1.0, 0.0, 0.0, 0.0))))
                }),
                (Missing, "1 subtracted from the last entry of JᵀJ alone", |g| {
                    rows(&(0.5 * (g.J.transpose() * g.J - Matrix2::new(0.0, 0.0, 0.0, 1.0))))
                }),
                (Other, "½ (J − I)ᵀ(J − I)", |g| {
                    let H = g.J - I();
                    rows(&(0.5 * H.transpose() * H))
                }),
            ],
        ),
        "21.S_a1" => at_points(state, [(Transpose, "S_a for S_aᵀ + S_a", |g| rows(&g.S[0]))]),
        "21.S_b1" => at_points(state, [(Transpose, "S_b for S_bᵀ + S_b", |g| rows(&g.S[1]))]),
        "21.S_c1" => at_points(
            state,
            [
                (Transpose, "S_c + S_c for S_cᵀ + S_c", |g| rows(&(2.0 * g.S[2]))),
                (Transpose, "S_cᵀ + S_cᵀ for S_cᵀ + S_c", |g| rows(&(2.0 * g.S[2].transpose()))),
                (Transpose, "S_c for S_cᵀ + S_c", |g| rows(&g.S[2])),
                (Transpose, "S_cᵀ for S_cᵀ + S_c", |g| rows(&g.S[2].transpose())),
                (Sign, "S_cᵀ − S_c", |g| rows(&(g.S[2].transpose() - g.S[2]))),
                (Sign, "S_c − S_cᵀ", |g| rows(&(g.S[2] - g.S[2].transpose()))),
                (Other, "S_cᵀ S_c for S_cᵀ + S_c", |g| rows(&(g.S[2].transpose() * g.S[2]))),
            ],
        ),
        "11.S_a" | "11.S_b" | "11.S_c" => metrics(quantity, state),
        _ => Vec::new(),
    }
}
