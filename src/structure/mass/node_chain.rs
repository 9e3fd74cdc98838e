//! Mass of a rod of Euler–Bernoulli elements: a chain of nodes.
//!
//! ```text
//!  M of the rod, by nodes (r, r_x):      a node's row of four numbers: (r_x, r_y, slope_x, slope_y).
//!
//!   T₀ S₁ᵀ                               A block ⎡a b⎤ takes it to
//!   S₁ T₁ S₂ᵀ                                    ⎣c d⎦   (a, a, d, d) ∘ row + (b, b, c, c) ∘ row with its halves
//!      S₂ T₂ …                                           exchanged, for x and for y alike.
//! ```
//!
//! M = L T Lᵀ with W = S T⁻¹ below the diagonal: y = f − W y(before), then a = T⁻¹ y − Wᵀ a(after). A vector that is not free, being
//! held or shared, takes no part: its entries of T⁻¹ are 0, and it is not written.

use super::chain::{MassChain, inverse, inverse_of_two, is_free, scale_of};
use crate::lanes::{LANES, Lanes, Path, Task, for_lanes};
use crate::linear::SingularAt;
use crate::structure::node_dofs::NodeDofs;
use crate::structure::row::Row;

/// Factors of one rod.
#[derive(Debug)]
pub(super) struct NodeChain {
    rows: Vec<Row<8>>,
    nodes: Vec<Node>,
    path: Path,
}

/// A 2 × 2 block as a node's row needs it: the diagonal, and the entries beside it.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    diagonal: [f64; LANES],
    beside: [f64; LANES],
}

/// Constants of a node.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// T⁻¹.
    inverse: Block,
    /// −W to the next node, and its transpose.
    next: Block,
    next_transposed: Block,
}

impl Block {
    fn of([[a, b], [c, d]]: [[f64; 2]; 2]) -> Block {
        Block { diagonal: [a, a, d, d], beside: [b, b, c, c] }
    }

    /// Product with a node's row, plus `sum`.
    #[inline(always)]
    fn times_add<L: Lanes>(&self, token: L::Token, row: L, sum: L) -> L {
        // The halves are exchanged while the diagonal is multiplied.
        let sum = L::load(token, &self.diagonal).mul_add(row, sum);
        L::load(token, &self.beside).mul_add(row.halves_swapped(), sum)
    }
}

impl NodeChain {
    pub fn new(free: &[NodeDofs], entry: impl Fn(usize, usize) -> f64, path: Path) -> Result<NodeChain, SingularAt> {
        let elements = free.len() / 2 - 1;
        let scale = scale_of(entry(0, 0));
        let entry = |row: usize, column: usize| scale * entry(row, column);
        let mut nodes = Vec::with_capacity(elements + 1);
        let block = |row: usize, column: usize| [0, 1].map(|a| [0, 1].map(|b| entry(row + a, column + b)));
        // What elements before left on the node.
        let mut left = [[0.0; 2]; 2];
        for node in 0..=elements {
            let (mut own, is_last) = (left, node == elements);
            if !is_last {
                own = sum(own, block(0, 0));
            }
            let inverse = inverse_over(own, [0, 1].map(|n| is_free(&free[2 * node + n])), 2 * node)?;
            let next = if is_last { [[0.0; 2]; 2] } else { times(block(2, 0), inverse).map(|row| row.map(|w| -w)) };
            left = sum(block(2, 2), times(next, block(0, 2)));
            nodes.push(Node {
                inverse: Block::of(inverse.map(|row| row.map(|entry| scale * entry))),
                next: Block::of(next),
                next_transposed: Block::of([[next[0][0], next[1][0]], [next[0][1], next[1][1]]]),
            });
        }
        Ok(NodeChain { rows: Row::of(free), nodes, path })
    }
}

/// Inverse of a symmetric block over its free rows.
fn inverse_over([[a, b], [_, d]]: [[f64; 2]; 2], free: [bool; 2], vector: usize) -> Result<[[f64; 2]; 2], SingularAt> {
    Ok(match free {
        [true, true] => {
            let [own_a, beside, own_d] = inverse_of_two([a, b, d], vector)?;
            [[own_a, beside], [beside, own_d]]
        }
        [true, false] => [[inverse(a, vector)?, 0.0], [0.0; 2]],
        [false, true] => [[0.0; 2], [0.0, inverse(d, vector + 1)?]],
        [false, false] => [[0.0; 2]; 2],
    })
}

fn sum(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][j] + b[i][j]))
}

fn times(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

impl MassChain for NodeChain {
    fn solve(&self, b: &mut [f64]) {
        self.path.run(Solve { chain: self, b });
    }
}

/// Solution in place.
struct Solve<'a> {
    chain: &'a NodeChain,
    b: &'a mut [f64],
}

impl Task for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) {
        let (NodeChain { rows, nodes, .. }, b) = (self.chain, self.b);
        let (mut y, mut number, none) = (L::splat(token, 0.0), 0, Block::default());
        let mut next = &none;
        for row in rows {
            let own_nodes = &nodes[number..];
            for_lanes!(lane < row.count(), {
                y = next.times_add(token, y, row.node(token, lane, b));
                row.set_node(lane, y, b);
                next = &own_nodes[lane].next;
            });
            number += row.count();
        }
        let Some(last) = rows.last() else { return };
        y = next.times_add(token, y, last.node(token, last.count(), b));
        let mut a = nodes[number].inverse.times_add(token, y, L::splat(token, 0.0));
        last.set_node(last.count(), a, b);
        for row in rows.iter().rev() {
            number -= row.count();
            let own_nodes = &nodes[number..];
            for_lanes!(rev lane < row.count(), {
                let (node, y) = (&own_nodes[lane], row.node::<L>(token, lane, b));
                let free = node.inverse.times_add(token, y, L::splat(token, 0.0));
                a = node.next_transposed.times_add(token, a, free);
                row.set_node(lane, a, b);
            });
        }
    }
}
