//! Mass of a rod of the paper's elements: interior nodes by constants, then a chain of nodes.
//!
//! ```text
//!  an element's M, by nodal vectors:         what is left of it, once node j is eliminated:
//!
//!        r_i d_i │r_j r_x d_j│ r_k d_k
//!   r_i   ●      │ ●   ●     │  ●                  r_i d_i   r_k d_k
//!   d_i       ●  │         ● │      ●         r_i   ●         ●
//!        ────────┼───────────┼────────        d_i       ●         ●
//!   r_j   ●      │ ●   ●     │  ●             r_k   ●         ●
//!   r_x   ●      │ ●   ●     │  ●             d_k       ●         ●
//!   d_j       ●  │         ● │      ●
//!        ────────┼───────────┼────────        two chains of numbers, one for r and one for d,
//!   r_k   ●      │ ●   ●     │  ●             each for x and for y: a row of four numbers a node,
//!   d_k       ●  │         ● │      ●         (r_x, r_y, d_x, d_y)
//! ```
//!
//! With A = M_jj of (r_j, r_x, d_j), G = A⁻¹ M_j,ik, forces f_j and the nodes' chain S = M_nn − M_nj G = L T Lᵀ:
//!
//! * forward, element by element: f_n ← f_n − Gᵀ f_j, then y = f − w y(before), where w = S T⁻¹ below the diagonal;
//! * backward: a = T⁻¹ y − w a(after), then a_j = A⁻¹ f_j − G a_n.
//!
//! A vector that is not free, being held or shared, takes no part: its entries of A⁻¹, G and T⁻¹ are 0, and it is not written.

use super::chain::{MassChain, inverse, inverse_of_two, is_free, scale_of};
use crate::lanes::{LANES, Lanes, Path, Task, for_lanes};
use crate::linear::SingularAt;
use crate::structure::node_dofs::NodeDofs;
use crate::structure::row::Row;

/// Nodal vectors from an element to the next.
const STRIDE: usize = 5;

/// Factors of one rod.
#[derive(Debug)]
pub(super) struct CondensedChain {
    rows: Vec<Row<14>>,
    interiors: Vec<Interior>,
    nodes: Vec<Node>,
    path: Path,
}

/// Constants of four elements' interior nodes, one lane an element; 0 in lanes without one.
#[derive(Clone, Debug, Default)]
struct Interior {
    /// A⁻¹ of (r_j, r_x): both diagonal entries, and the one beside them.
    inverse: [[f64; LANES]; 3],
    /// A⁻¹ of d_j.
    inverse_d: [f64; LANES],
    /// −G of r_j with r_i and r_k, then of r_x.
    position: [[[f64; LANES]; 2]; 2],
    /// −G of d_j with d_i and d_k.
    director: [[f64; LANES]; 2],
}

/// Constants of a node, as its row of four numbers has them.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// T⁻¹.
    inverse: [f64; LANES],
    /// −w to the next node.
    next: [f64; LANES],
}

/// Chain of one kind of nodal vector, while it is factorised.
#[derive(Clone, Copy, Default)]
struct Pivot {
    /// What earlier elements left on the node.
    left: f64,
    inverse: f64,
    next: f64,
}

impl Pivot {
    /// Passes to the next node with S of the element between: on the node, beside it and on the next.
    fn pass(&mut self, [on, beside, on_next]: [f64; 3], free: bool, vector: usize) -> Result<(), SingularAt> {
        self.inverse = if free { inverse(self.left + on, vector)? } else { 0.0 };
        self.next = -beside * self.inverse;
        self.left = on_next + self.next * beside;
        Ok(())
    }
}

impl CondensedChain {
    pub fn new(
        free: &[NodeDofs],
        entry: impl Fn(usize, usize) -> f64,
        path: Path,
    ) -> Result<CondensedChain, SingularAt> {
        let elements = (free.len() - 2) / STRIDE;
        let scale = scale_of(entry(0, 0));
        let entry = |row: usize, column: usize| scale * entry(row, column);
        let mut chain = CondensedChain {
            rows: Row::of(free),
            interiors: vec![Interior::default(); elements.div_ceil(LANES)],
            nodes: Vec::with_capacity(elements + 1),
            path,
        };
        let (mut r, mut d) = (Pivot::default(), Pivot::default());
        for element in 0..elements {
            let (interior, lane) = (&mut chain.interiors[element / LANES], element % LANES);
            let first = element * STRIDE;
            let [on_j, on_x, on_d] = [2, 3, 4].map(|n| is_free(&free[first + n]));
            // A⁻¹ of (r_j, r_x), over those that are free.
            let (jj, jx, xx) = (entry(2, 2), entry(2, 3), entry(3, 3));
            let [own_j, beside, own_x] = match (on_j, on_x) {
                (true, true) => inverse_of_two([jj, jx, xx], first + 2)?,
                (true, false) => [inverse(jj, first + 2)?, 0.0, 0.0],
                (false, true) => [0.0, 0.0, inverse(xx, first + 3)?],
                (false, false) => [0.0; 3],
            };
            let own_d = if on_d { inverse(entry(4, 4), first + 4)? } else { 0.0 };
            for (n, own) in [own_j, own_x, beside].into_iter().enumerate() {
                interior.inverse[n][lane] = scale * own;
            }
            interior.inverse_d[lane] = scale * own_d;
            let mut g = [[0.0; 2]; 3];
            for (end, [position, director]) in [[0, 1], [5, 6]].into_iter().enumerate() {
                let (from_j, from_x) = (entry(2, position), entry(3, position));
                g[0][end] = own_j * from_j + beside * from_x;
                g[1][end] = beside * from_j + own_x * from_x;
                g[2][end] = own_d * entry(4, director);
                interior.position[0][end][lane] = -g[0][end];
                interior.position[1][end][lane] = -g[1][end];
                interior.director[end][lane] = -g[2][end];
            }
            let (positions, directors) = ([0, 5], [1, 6]);
            let s = |a: usize, b: usize| {
                let of = |n: usize, g: &[f64; 2]| entry(positions[a], n) * g[b];
                entry(positions[a], positions[b]) - of(2, &g[0]) - of(3, &g[1])
            };
            let s_d = |a: usize, b: usize| entry(directors[a], directors[b]) - entry(directors[a], 4) * g[2][b];
            r.pass([s(0, 0), s(1, 0), s(1, 1)], is_free(&free[first]), first)?;
            d.pass([s_d(0, 0), s_d(1, 0), s_d(1, 1)], is_free(&free[first + 1]), first + 1)?;
            chain.push(scale, &r, &d);
        }
        let first = elements * STRIDE;
        r.pass([0.0; 3], is_free(&free[first]), first)?;
        d.pass([0.0; 3], is_free(&free[first + 1]), first + 1)?;
        chain.push(scale, &r, &d);
        Ok(chain)
    }

    fn push(&mut self, scale: f64, r: &Pivot, d: &Pivot) {
        let row = |r: f64, d: f64| [r, r, d, d];
        self.nodes.push(Node { inverse: row(scale * r.inverse, scale * d.inverse), next: row(r.next, d.next) });
    }
}

impl MassChain for CondensedChain {
    fn solve(&self, b: &mut [f64]) {
        self.path.run(Solve { chain: self, b });
    }
}

/// Solution in place.
struct Solve<'a> {
    chain: &'a CondensedChain,
    b: &'a mut [f64],
}

impl Task for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) {
        let Solve { chain, b } = self;
        let y = forward::<L>(token, chain, b);
        backward(token, chain, y, b);
    }
}

/// Forward elimination; y of every node but the last into its place, that of the last one returned.
#[inline(always)]
fn forward<L: Lanes>(token: L::Token, chain: &CondensedChain, b: &mut [f64]) -> L {
    let zero = L::splat(token, 0.0);
    // y of the node before, −w from there, and what the row before leaves on its last node.
    let (mut y, mut next, mut left) = (zero, zero, zero);
    let (mut number, mut last) = (0, zero);
    for (row, own) in chain.rows.iter().zip(&chain.interiors) {
        let [j_x, j_y, x_x, x_y, d_x, d_y] = row.interior::<L>(token, b);
        let [of_j, of_x] = [&own.position[0], &own.position[1]];
        let (ji, xi) = (L::load(token, &of_j[0]), L::load(token, &of_x[0]));
        let (jk, xk) = (L::load(token, &of_j[1]), L::load(token, &of_x[1]));
        let (di, dk) = (L::load(token, &own.director[0]), L::load(token, &own.director[1]));
        let on_k = [sum_of(jk, j_x, xk, x_x), sum_of(jk, j_y, xk, x_y), dk * d_x, dk * d_y];
        let on_nodes = L::transpose([
            sum_of(ji, j_x, xi, x_x) + on_k[0].shifted(zero),
            sum_of(ji, j_y, xi, x_y) + on_k[1].shifted(zero),
            di.mul_add(d_x, on_k[2].shifted(zero)),
            di.mul_add(d_y, on_k[3].shifted(zero)),
        ]);
        let own_nodes = &chain.nodes[number..];
        for_lanes!(lane < row.count(), {
            let force = row.node::<L>(token, lane, b) + on_nodes[lane];
            y = next.mul_add(y, if lane == 0 { force + left } else { force });
            row.set_node(lane, y, b);
            next = L::load(token, &own_nodes[lane].next);
        });
        number += row.count();
        let of_k = L::transpose(on_k);
        left = match row.count() {
            1 => of_k[0],
            2 => of_k[1],
            3 => of_k[2],
            _ => of_k[3],
        };
        last = row.node(token, row.count(), b);
    }
    next.mul_add(y, last + left)
}

/// a x + b y.
#[inline(always)]
fn sum_of<L: Lanes>(a: L, x: L, b: L, y: L) -> L {
    a.mul_add(x, b * y)
}

/// Back substitution from y of the last node.
#[inline(always)]
fn backward<L: Lanes>(token: L::Token, chain: &CondensedChain, y: L, b: &mut [f64]) {
    let mut number = chain.nodes.len() - 1;
    let mut a = L::load(token, &chain.nodes[number].inverse) * y;
    if let Some(row) = chain.rows.last() {
        row.set_node(row.count(), a, b);
    }
    for (row, own) in chain.rows.iter().zip(&chain.interiors).rev() {
        let after = a;
        let mut nodes = [a; LANES];
        number -= row.count();
        let own_nodes = &chain.nodes[number..];
        for_lanes!(rev lane < row.count(), {
            let node = &own_nodes[lane];
            let free = L::load(token, &node.inverse) * row.node::<L>(token, lane, b);
            a = L::load(token, &node.next).mul_add(a, free);
            row.set_node(lane, a, b);
            nodes[lane] = a;
        });
        // Node k of an element is node i of the next one; lanes without an element hold the last node.
        let i = L::transpose(nodes);
        let k = L::transpose([nodes[1], nodes[2], nodes[3], after]);
        let [j_x, j_y, x_x, x_y, d_x, d_y] = row.interior::<L>(token, b);
        let [of_j, of_x] = [&own.position[0], &own.position[1]];
        let (ji, xi) = (L::load(token, &of_j[0]), L::load(token, &of_x[0]));
        let (jk, xk) = (L::load(token, &of_j[1]), L::load(token, &of_x[1]));
        let (di, dk) = (L::load(token, &own.director[0]), L::load(token, &own.director[1]));
        let [jj, xx, jx] =
            [L::load(token, &own.inverse[0]), L::load(token, &own.inverse[1]), L::load(token, &own.inverse[2])];
        let dd = L::load(token, &own.inverse_d);
        row.set_interior(
            [
                jj.mul_add(j_x, jx.mul_add(x_x, sum_of(ji, i[0], jk, k[0]))),
                jj.mul_add(j_y, jx.mul_add(x_y, sum_of(ji, i[1], jk, k[1]))),
                jx.mul_add(j_x, xx.mul_add(x_x, sum_of(xi, i[0], xk, k[0]))),
                jx.mul_add(j_y, xx.mul_add(x_y, sum_of(xi, i[1], xk, k[1]))),
                dd.mul_add(d_x, sum_of(di, i[2], dk, k[2])),
                dd.mul_add(d_y, sum_of(di, i[3], dk, k[3])),
            ],
            b,
        );
    }
}
