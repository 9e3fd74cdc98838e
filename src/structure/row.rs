//! Rows: up to four neighbouring elements of a rod, computed side by side.
//!
//! ```text
//!  unknowns of a rod in memory, here of the paper's element: ten from an element to the next
//!
//!  … │r_i d_i│r_j r_x d_j│r_k d_k│r_j r_x d_j│r_k d_k│…      row of elements e, e + 1, e + 2, e + 3
//!    └ element e ────────────────┘                            │ loads of four numbers: one line an element
//!                        └ element e + 1 ────────┘            ▼
//!      e:     r_ix r_iy d_ix d_iy │ r_jx r_jy r_xx r_xy │ …    transposed in registers: one line a coordinate,
//!      e + 1: r_ix r_iy d_ix d_iy │ …                      →   r_ix: e, e + 1, e + 2, e + 3
//!      …                                                       r_iy: e, e + 1, e + 2, e + 3 …
//!
//!  forces go back the same way. Node k of an element is node i of the next, so
//!      force on node i of a row = of i of (e, e + 1, e + 2, e + 3) + of k of (–, e, e + 1, e + 2), moved by a lane;
//!  the last node's rest is added by itself.
//! ```
//!
//! Most rows stand in memory like this. Not so at ends and pivots, where unknowns are held, shared or turned: there each load of
//! four is told where its numbers are, and vectors with axes of their own are turned in the registers.

mod quad;

use self::quad::{Apart, Quad, Turn, follow};
use super::node_dofs::NodeDofs;
use crate::lanes::{LANES, Lanes, for_lanes, load, store};
use crate::linear::NO_UNKNOWN;

/// Coordinates of a node, which neighbours share.
const SHARED: usize = 4;

/// Up to four neighbouring elements with `N` coordinates each.
#[derive(Clone, Debug)]
pub(super) struct Row<const N: usize> {
    /// Number of elements.
    count: usize,
    place: Place,
}

/// Where the coordinates of a row are among the unknowns.
#[derive(Clone, Debug)]
enum Place {
    /// One after the other, from here on.
    Together(usize),
    /// Anywhere.
    Apart(Apart),
}

impl<const N: usize> Row<N> {
    /// Coordinates from an element to the next.
    const STRIDE: usize = N - SHARED;
    /// Block of node k's coordinates.
    const LAST: usize = N.div_ceil(LANES) - 1;

    /// Rows of a rod with this chain of nodal vectors.
    pub fn of(chain: &[NodeDofs]) -> Vec<Row<N>> {
        let elements = (2 * chain.len() - SHARED) / Self::STRIDE;
        let row = |first: usize| {
            let count = LANES.min(elements - first);
            let vectors = &chain[first * Self::STRIDE / 2..][..(count * Self::STRIDE + SHARED) / 2];
            Row { count, place: Self::place(vectors, count) }
        };
        (0..elements).step_by(LANES).map(row).collect()
    }

    fn place(vectors: &[NodeDofs], count: usize) -> Place {
        let of = |unknown: Option<usize>| unknown.map_or(NO_UNKNOWN, |unknown| unknown as u32);
        let unknowns: Vec<u32> = vectors.iter().flat_map(|vector| vector.unknowns.map(of)).collect();
        let is_turned = vectors.iter().any(|vector| vector.turn.is_some());
        if !is_turned && follow(&unknowns) {
            return Place::Together(unknowns[0] as usize);
        }
        let first = |lane: usize| lane.min(count - 1) * Self::STRIDE;
        let lanes = [0, 1, 2, 3];
        let blocks = (0..N).step_by(LANES).map(|block| block.min(N - LANES));
        let quads = blocks.chain((N == 14).then_some(BESIDE)).map(|block| {
            lanes.map(|lane| {
                let own = &unknowns[first(lane) + block..][..LANES];
                if follow(own) {
                    Quad::Together(own[0] as usize)
                } else {
                    Quad::Apart([own[0], own[1], own[2], own[3]])
                }
            })
        });
        let turn = |n: usize| {
            let of_lane = lanes.map(|lane| vectors[first(lane) / 2 + n].turn.unwrap_or_default());
            Turn { cos: of_lane.map(|turn| turn.matrix()[(0, 0)]), sin: of_lane.map(|turn| turn.matrix()[(1, 0)]) }
        };
        let turns = if is_turned { (0..N / 2).map(turn).collect() } else { Vec::new() };
        Place::Apart(Apart { quads: quads.collect(), turns })
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Coordinates of the elements, in global axes; lanes without an element repeat the last one.
    #[inline(always)]
    pub fn coordinates<L: Lanes>(&self, token: L::Token, u: &[f64]) -> [L; N] {
        let mut columns = [L::splat(token, 0.0); N];
        match &self.place {
            Place::Together(first) => {
                let u = &u[*first..first + self.count * Self::STRIDE + SHARED];
                let [b, c, d] = [
                    1.min(self.count - 1) * Self::STRIDE,
                    2.min(self.count - 1) * Self::STRIDE,
                    (self.count - 1) * Self::STRIDE,
                ];
                for block in (0..N).step_by(LANES) {
                    // The last block begins earlier where N is no multiple of four.
                    let at = block.min(N - LANES);
                    let rows =
                        [load(token, u, at), load(token, u, b + at), load(token, u, c + at), load(token, u, d + at)];
                    columns[at..at + LANES].copy_from_slice(&L::transpose(rows));
                }
            }
            Place::Apart(Apart { quads, turns }) => {
                for block in (0..N).step_by(LANES) {
                    let (at, [a, b, c, d]) = (block.min(N - LANES), &quads[block / LANES]);
                    let rows = [a.load(token, u), b.load(token, u), c.load(token, u), d.load(token, u)];
                    columns[at..at + LANES].copy_from_slice(&L::transpose(rows));
                }
                if turns.len() == N / 2 {
                    for n in 0..N / 2 {
                        let ([x, y], [cos, sin]) = ([columns[2 * n], columns[2 * n + 1]], turns[n].load::<L>(token));
                        columns[2 * n] = cos.mul_add(x, -(sin * y));
                        columns[2 * n + 1] = sin.mul_add(x, cos * y);
                    }
                }
            }
        }
        columns
    }

    /// Coordinates of node `node` of the row, in its own axes; 0 where held.
    #[inline(always)]
    pub fn node<L: Lanes>(&self, token: L::Token, node: usize, u: &[f64]) -> L {
        match &self.place {
            Place::Together(first) => load(token, u, first + node * Self::STRIDE),
            Place::Apart(apart) => apart.node(node, self.count, Self::LAST).load(token, u),
        }
    }

    /// Writes the coordinates of node `node` of the row, in its own axes.
    #[inline(always)]
    pub fn set_node<L: Lanes>(&self, node: usize, row: L, u: &mut [f64]) {
        match &self.place {
            Place::Together(first) => store(row, u, first + node * Self::STRIDE),
            Place::Apart(apart) => apart.node(node, self.count, Self::LAST).set(row, u),
        }
    }

    /// Adds `factor` times the elements' forces to a vector of unknowns.
    #[inline(always)]
    pub fn add<L: Lanes>(&self, token: L::Token, mut forces: [L; N], factor: f64, sum: &mut [f64]) {
        let factor = L::splat(token, factor);
        if let Place::Apart(Apart { turns, .. }) = &self.place
            && turns.len() == N / 2
        {
            for n in 0..N / 2 {
                let ([x, y], [cos, sin]) = ([forces[2 * n], forces[2 * n + 1]], turns[n].load::<L>(token));
                forces[2 * n] = cos.mul_add(x, sin * y);
                forces[2 * n + 1] = cos.mul_add(y, -(sin * x));
            }
        }
        let (zero, k) = (L::splat(token, 0.0), Self::STRIDE);
        let node = L::transpose([
            forces[0] + forces[k].shifted(zero),
            forces[1] + forces[k + 1].shifted(zero),
            forces[2] + forces[k + 2].shifted(zero),
            forces[3] + forces[k + 3].shifted(zero),
        ]);
        let last = L::transpose([forces[k], forces[k + 1], forces[k + 2], forces[k + 3]]);
        let last = match self.count {
            1 => last[0],
            2 => last[1],
            3 => last[2],
            _ => last[3],
        };
        match &self.place {
            Place::Together(first) => {
                let sum = &mut sum[*first..first + self.count * k + SHARED];
                self.add_rows(token, &node, 0, factor, sum);
                let mut at = SHARED;
                while at + LANES <= k {
                    let block = L::transpose([forces[at], forces[at + 1], forces[at + 2], forces[at + 3]]);
                    self.add_rows(token, &block, at, factor, sum);
                    at += LANES;
                }
                // One nodal vector is left of the paper's element.
                if at < k {
                    let (x, y) = ((forces[at] * factor).to_array(), (forces[at + 1] * factor).to_array());
                    for_lanes!(lane < self.count, {
                        sum[lane * k + at] += x[lane];
                        sum[lane * k + at + 1] += y[lane];
                    });
                }
                store(last.mul_add(factor, load(token, sum, self.count * k)), sum, self.count * k);
            }
            Place::Apart(Apart { quads, .. }) => {
                self.add_quads(token, &node, &quads[0], factor, sum);
                let mut at = SHARED;
                while at + LANES <= k {
                    let block = L::transpose([forces[at], forces[at + 1], forces[at + 2], forces[at + 3]]);
                    self.add_quads(token, &block, &quads[at / LANES], factor, sum);
                    at += LANES;
                }
                if at < k {
                    let (x, y) = ((forces[at] * factor).to_array(), (forces[at + 1] * factor).to_array());
                    let quads = &quads[at / LANES];
                    for_lanes!(lane < self.count, { quads[lane].add_pair([x[lane], y[lane]], sum) });
                }
                quads[Self::LAST][self.count - 1].add(token, last, factor, sum);
            }
        }
    }

    #[inline(always)]
    fn add_rows<L: Lanes>(&self, token: L::Token, rows: &[L; LANES], at: usize, factor: L, sum: &mut [f64]) {
        for_lanes!(lane < self.count, {
            let at = lane * Self::STRIDE + at;
            store(rows[lane].mul_add(factor, load(token, sum, at)), sum, at);
        });
    }

    #[inline(always)]
    fn add_quads<L: Lanes>(
        &self,
        token: L::Token,
        rows: &[L; LANES],
        quads: &[Quad; LANES],
        factor: L,
        sum: &mut [f64],
    ) {
        for_lanes!(lane < self.count, { quads[lane].add(token, rows[lane], factor, sum) });
    }
}

/// First coordinate of the paper's element that a second load of its interior node begins with: r_x, then r_y.
const BESIDE: usize = 6;

impl Row<14> {
    /// Coordinates of the elements' interior nodes, in their own axes; 0 where held. Nothing of the other nodes is read: a load that
    /// meets a number just written waits for it.
    #[inline(always)]
    pub fn interior<L: Lanes>(&self, token: L::Token, u: &[f64]) -> [L; 6] {
        let (first, second) = match &self.place {
            Place::Together(first) => {
                let u = &u[*first..first + self.count * Self::STRIDE + SHARED];
                let [b, c, d] = [
                    1.min(self.count - 1) * Self::STRIDE,
                    2.min(self.count - 1) * Self::STRIDE,
                    (self.count - 1) * Self::STRIDE,
                ];
                let rows = |at: usize| [at, b + at, c + at, d + at];
                let ([a, b, c, d], [p, q, r, s]) = (rows(SHARED), rows(BESIDE));
                (
                    [load::<L>(token, u, a), load(token, u, b), load(token, u, c), load(token, u, d)],
                    [load::<L>(token, u, p), load(token, u, q), load(token, u, r), load(token, u, s)],
                )
            }
            Place::Apart(Apart { quads, .. }) => {
                let ([a, b, c, d], [p, q, r, s]) = (&quads[1], &quads[4]);
                (
                    [a.load(token, u), b.load(token, u), c.load(token, u), d.load(token, u)],
                    [p.load(token, u), q.load(token, u), r.load(token, u), s.load(token, u)],
                )
            }
        };
        let ([j_x, j_y, x_x, x_y], [_, _, d_x, d_y]) = (L::transpose(first), L::transpose(second));
        [j_x, j_y, x_x, x_y, d_x, d_y]
    }

    /// Writes the coordinates of the elements' interior nodes, in their own axes.
    #[inline(always)]
    pub fn set_interior<L: Lanes>(&self, columns: [L; 6], u: &mut [f64]) {
        let rows = L::transpose([columns[0], columns[1], columns[2], columns[3]]);
        let (x, y) = (columns[4].to_array(), columns[5].to_array());
        match &self.place {
            Place::Together(first) => {
                let u = &mut u[*first..first + self.count * Self::STRIDE + SHARED];
                for_lanes!(lane < self.count, {
                    let at = lane * Self::STRIDE + SHARED;
                    store(rows[lane], u, at);
                    u[at + LANES] = x[lane];
                    u[at + LANES + 1] = y[lane];
                });
            }
            Place::Apart(Apart { quads, .. }) => for_lanes!(lane < self.count, {
                quads[1][lane].set(rows[lane], u);
                quads[2][lane].set_pair([x[lane], y[lane]], u);
            }),
        }
    }
}

#[cfg(test)]
mod tests;
