//! Mistakes in (9), (10) and in the products of (21).

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Matrix2;

use super::{Candidate, Kind, candidate, rows};
use ancf::equations::element::Matrix14;
use ancf::equations::force::S_1;
use ancf::equations::shape::{self, Vector14};
use ancf::equations::strain;
use ancf::state::ElementState;

/// What a mistake makes of them.
type Mistake = fn(&Gradients) -> Vec<f64>;

/// At every point of the state.
fn at_points<'a, const N: usize>(
    state: &'a ElementState,
    list: [(Kind, &'static str, Mistake); N],
) -> Vec<Candidate<'a>> {
    let value = move |of: Mistake| state.points.iter().flat_map(|&[x, y]| of(&Gradients::at(state, x, y))).collect();
    list.map(|(kind, what, of)| candidate(kind, what, move || value(of))).into()
}

/// What (9) to (11) are made of at one point.
struct Gradients {
    /// ∂r/∂(x, y) of e.
    now: Matrix2<f64>,
    /// The same of e₀: J_0.
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

fn I() -> Matrix2<f64> {
    Matrix2::identity()
}

/// Of one quantity.
pub(super) fn of<'a>(quantity: &str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    match quantity {
        "9.J" => at_points(
            state,
            [
                (Kind::Transpose, "J_0⁻ᵀ for J_0⁻¹", |g| rows(&(g.now * g.inverse.transpose()))),
                (Kind::Transpose, "J_0⁻¹ from the left", |g| rows(&(g.inverse * g.now))),
                (Kind::Transpose, "the gradient transposed before J_0⁻¹", |g| {
                    rows(&(g.now.transpose() * g.inverse))
                }),
                (Kind::Other, "J_0 for J_0⁻¹", |g| rows(&(g.now * g.first))),
                (Kind::Other, "without J_0⁻¹", |g| rows(&g.now)),
                (Kind::Other, "the inverse: ∂r_0/∂r", |g| rows(&g.J.try_inverse().unwrap_or_else(Matrix2::zeros))),
                (Kind::Other, "the initial r_x for that of now", |g| {
                    rows(&(Matrix2::from_columns(&[g.first.column(0), g.now.column(1)]) * g.inverse))
                }),
                (Kind::Other, "the initial r_y for that of now", |g| {
                    rows(&(Matrix2::from_columns(&[g.now.column(0), g.first.column(1)]) * g.inverse))
                }),
            ],
        ),
        "10.epsilon_m" => at_points(
            state,
            [
                (Kind::Transpose, "J Jᵀ for Jᵀ J", |g| rows(&(0.5 * (g.J * g.J.transpose() - I())))),
                (Kind::Transpose, "J J for Jᵀ J", |g| rows(&(0.5 * (g.J * g.J - I())))),
                (Kind::Other, "½ (J + Jᵀ) − I, the small strain", |g| {
                    rows(&(0.5 * (g.J + g.J.transpose()) - I()))
                }),
                (Kind::Other, "½ (I − J⁻ᵀJ⁻¹), the strain of Almansi", |g| {
                    let back = g.J.try_inverse().unwrap_or_else(Matrix2::zeros);
                    rows(&(0.5 * (I() - back.transpose() * back)))
                }),
                (Kind::Other, "½ (J − I)ᵀ(J − I)", |g| {
                    let H = g.J - I();
                    rows(&(0.5 * H.transpose() * H))
                }),
            ],
        ),
        "21.S_a1" => at_points(state, [(Kind::Transpose, "S_a for S_aᵀ + S_a", |g| rows(&g.S[0]))]),
        "21.S_b1" => at_points(state, [(Kind::Transpose, "S_b for S_bᵀ + S_b", |g| rows(&g.S[1]))]),
        "21.S_c1" => at_points(
            state,
            [
                (Kind::Transpose, "S_c + S_c for S_cᵀ + S_c", |g| rows(&(2.0 * g.S[2]))),
                (Kind::Transpose, "S_cᵀ + S_cᵀ for S_cᵀ + S_c", |g| rows(&(2.0 * g.S[2].transpose()))),
                (Kind::Transpose, "S_c for S_cᵀ + S_c", |g| rows(&g.S[2])),
                (Kind::Transpose, "S_cᵀ for S_cᵀ + S_c", |g| rows(&g.S[2].transpose())),
                (Kind::Sign, "S_cᵀ − S_c", |g| rows(&(g.S[2].transpose() - g.S[2]))),
                (Kind::Sign, "S_c − S_cᵀ", |g| rows(&(g.S[2] - g.S[2].transpose()))),
                (Kind::Other, "S_cᵀ S_c for S_cᵀ + S_c", |g| rows(&(g.S[2].transpose() * g.S[2]))),
            ],
        ),
        "11.S_c" => at_points(
            state,
            [(Kind::Factor, "S_cᵀ + S_c: the shear counted twice, symmetrised already", |g| rows(&S_1(&g.S[2])))],
        ),
        _ => Vec::new(),
    }
}
