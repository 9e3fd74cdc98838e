//! Places of a row's coordinates where held, shared or turned vectors come between.

use crate::lanes::{LANES, Lanes, load, store};
use crate::linear::NO_UNKNOWN;

/// Coordinates of a row whose unknowns do not follow one another.
#[derive(Clone, Debug)]
pub(super) struct Apart {
    /// Places of four coordinates each, block by block, and in a block one for each lane.
    pub quads: Vec<[Quad; LANES]>,
    /// Rotations of the nodal vectors from their own axes to the global ones; empty where there is none.
    pub turns: Vec<Turn>,
}

/// Unknowns of four coordinates in a row.
#[derive(Clone, Copy, Debug)]
pub(super) enum Quad {
    /// From here on.
    Together(usize),
    /// Each by itself; [`NO_UNKNOWN`] where held.
    Apart([u32; LANES]),
}

/// Cosine and sine of the angle by which a nodal vector's axes are turned, of each element.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    pub cos: [f64; LANES],
    pub sin: [f64; LANES],
}

impl Apart {
    /// Place of node `node` of a row of `count` elements; the last node is in the block `last`.
    #[inline(always)]
    pub fn node(&self, node: usize, count: usize, last: usize) -> &Quad {
        if node < count { &self.quads[0][node] } else { &self.quads[last][count - 1] }
    }
}

/// Whether unknowns follow one another.
pub(super) fn follow(unknowns: &[u32]) -> bool {
    unknowns.windows(2).all(|pair| pair[0] != NO_UNKNOWN && pair[0] + 1 == pair[1])
        && unknowns.last() != Some(&NO_UNKNOWN)
}

impl Quad {
    #[inline(always)]
    pub fn load<L: Lanes>(&self, token: L::Token, u: &[f64]) -> L {
        match self {
            Quad::Together(first) => load(token, u, *first),
            Quad::Apart([a, b, c, d]) => L::load(token, &[value(u, *a), value(u, *b), value(u, *c), value(u, *d)]),
        }
    }

    #[inline(always)]
    pub fn add<L: Lanes>(&self, token: L::Token, row: L, factor: L, sum: &mut [f64]) {
        match self {
            Quad::Together(first) => store(row.mul_add(factor, load(token, sum, *first)), sum, *first),
            Quad::Apart(unknowns) => {
                for (unknown, force) in unknowns.iter().zip((row * factor).to_array()) {
                    if let Some(sum) = sum.get_mut(*unknown as usize) {
                        *sum += force;
                    }
                }
            }
        }
    }

    #[inline(always)]
    pub fn set<L: Lanes>(&self, row: L, u: &mut [f64]) {
        match self {
            Quad::Together(first) => store(row, u, *first),
            Quad::Apart(unknowns) => {
                for (unknown, value) in unknowns.iter().zip(row.to_array()) {
                    if let Some(u) = u.get_mut(*unknown as usize) {
                        *u = value;
                    }
                }
            }
        }
    }

    /// Unknowns of the first two coordinates.
    #[inline(always)]
    fn pair(&self) -> [usize; 2] {
        match self {
            Quad::Together(first) => [*first, first + 1],
            Quad::Apart([a, b, ..]) => [*a as usize, *b as usize],
        }
    }

    /// Adds forces on the first two coordinates.
    #[inline(always)]
    pub fn add_pair(&self, forces: [f64; 2], sum: &mut [f64]) {
        for (unknown, force) in self.pair().into_iter().zip(forces) {
            if let Some(sum) = sum.get_mut(unknown) {
                *sum += force;
            }
        }
    }

    /// Writes the first two coordinates.
    #[inline(always)]
    pub fn set_pair(&self, values: [f64; 2], u: &mut [f64]) {
        for (unknown, value) in self.pair().into_iter().zip(values) {
            if let Some(u) = u.get_mut(unknown) {
                *u = value;
            }
        }
    }
}

/// Value of an unknown; 0 where there is none.
#[inline(always)]
fn value(u: &[f64], unknown: u32) -> f64 {
    u.get(unknown as usize).copied().unwrap_or(0.0)
}

impl Turn {
    #[inline(always)]
    pub fn load<L: Lanes>(&self, token: L::Token) -> [L; 2] {
        [L::load(token, &self.cos), L::load(token, &self.sin)]
    }
}
