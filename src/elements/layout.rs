//! Order of an element's coordinates: nodal vectors one after the other, x before y.

#![allow(non_snake_case)] // The matrix K.

use super::plane::{Block, Vec2, vec2};

/// Nodal vectors of an element from its coordinates.
#[inline(always)]
pub(super) fn nodal<const V: usize>(u: &[f64]) -> [Vec2; V] {
    std::array::from_fn(|n| vec2(u[2 * n], u[2 * n + 1]))
}

/// Coordinates of an element from its nodal vectors.
#[inline(always)]
pub(super) fn coordinates<const V: usize, const N: usize>(vectors: &[Vec2; V]) -> [f64; N] {
    let components = vectors.map(Vec2::to_array);
    std::array::from_fn(|i| components[i / 2][i % 2])
}

/// Matrix of an element, by columns, from the matrix of its polynomials' coefficients.
///
/// `to_nodes` maps forces on coefficients to forces on nodal vectors. It acts on rows and on columns alike.
#[inline(always)]
pub(super) fn matrix<const C: usize, const V: usize, const N: usize>(
    of_coefficients: &[[Block; C]; C],
    to_nodes: impl Fn(&[Block; C]) -> [Block; V],
) -> [[f64; N]; N] {
    // Rows by coefficients, columns by nodal vectors.
    let columns = of_coefficients.each_ref().map(&to_nodes);
    let mut K = [[0.0; N]; N];
    for column in 0..V {
        let rows = to_nodes(&std::array::from_fn(|row| columns[row][column]));
        for (row, block) in rows.iter().enumerate() {
            for (c, values) in block.0.iter().enumerate() {
                K[2 * column + c][2 * row..2 * row + 2].copy_from_slice(&values.to_array());
            }
        }
    }
    K
}
