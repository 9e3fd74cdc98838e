//! Mass matrix, factorised once and solved with in every explicit step.
//!
//! Each element's M is a scalar matrix times the plane unit matrix: it couples nodal vectors, but not x with y. The
//! *free* vectors of a rod, those neither shared nor held in any direction, are solved for along the rod ([`MassChain`]),
//! x and y together. The others, shared between rods or held in one direction, are the *border*:
//!
//! M_ff a_f + M_fb a_b = f_f,  M_bf a_f + M_bb a_b = f_b  ⇒  (M_bb − M_bf W) a_b = f_b − M_bf M_ff⁻¹ f_f,  a_f = M_ff⁻¹ f_f − W a_b,
//!
//! with W = M_ff⁻¹ M_fb, computed once. Multipliers couple everything; with them a [`BorderedLu`] is used.

mod chain;
mod condensed_chain;
mod node_chain;

use std::collections::BTreeMap;
use std::ops::Range;

use nalgebra::{DVector, Vector2};

use self::chain::MassChain;
use self::condensed_chain::CondensedChain;
use self::node_chain::NodeChain;
use super::Structure;
use super::node_dofs::NodeDofs;
use super::numbering::order;
use super::rod::Rod;
use super::rod_elements::ElementMatrix;
use crate::lanes::Path;
use crate::linear::{BandLu, BandMatrix, BlockLayout, BorderedLu, Layout, SingularAt, flush_negligible};

/// Most border vectors of a rod: positions and slopes of both ends and of a pivot.
const MOST_BORDER_VECTORS: usize = 6;

/// Factors of a structure's mass matrix.
#[derive(Debug)]
pub struct MassFactors(MassKind);

#[derive(Debug)]
enum MassKind {
    Condensed(Condensed),
    Multipliers(BorderedLu),
}

/// Factors in the condensed form.
#[derive(Debug)]
struct Condensed {
    rods: Vec<RodFactors>,
    /// Border vectors, numbered by `unknowns`.
    border: Vec<NodeDofs>,
    /// Unknowns of the border in the structure's numbering.
    unknowns: Vec<usize>,
    corner: BandLu,
    /// Buffer for the border's part of a right-hand side.
    border_rhs: DVector<f64>,
}

/// Factors of one rod.
#[derive(Debug)]
struct RodFactors {
    /// Unknowns of the rod's own.
    own: Range<usize>,
    /// First unknowns of the free vectors.
    free: Vec<u32>,
    /// Solution for the free vectors among the rod's own unknowns.
    chain: Box<dyn MassChain>,
    /// Border vectors that the rod touches.
    touches: Vec<usize>,
    /// Coupling M_fb: free vector, index of the touched vector, entry.
    coupling: Vec<(usize, usize, f64)>,
    /// Matrix W by rows: for each free vector one entry per touched vector.
    response: Vec<f64>,
}

/// Entries of one rod's mass matrix, by indices in its chain of nodal vectors.
struct RodMass<'a> {
    rod: &'a Rod,
}

impl RodMass<'_> {
    fn entry(&self, a: usize, b: usize) -> f64 {
        let (vectors, stride) = (self.rod.mesh.vectors().len(), self.rod.stride());
        let both = (a.max(b) / stride).min(self.rod.elements - 1);
        // A node's vectors belong to two elements.
        let local =
            |vector: usize, element: usize| vector.checked_sub(element * stride).filter(|local| *local < vectors);
        let of = |element| Some(self.rod.mesh.mass(local(a, element)?, local(b, element)?));
        (both.saturating_sub(1)..=both).filter_map(of).sum()
    }

    /// Indices of the vectors that share an element with a vector.
    fn neighbours(&self, vector: usize) -> std::ops::Range<usize> {
        let reach = self.rod.mesh.vectors().len() - 1;
        vector.saturating_sub(reach)..(vector + reach + 1).min(self.rod.chain.len())
    }
}

impl Condensed {
    fn new(rods: &[Rod], layout: &Layout, path: Path) -> Result<Condensed, SingularAt> {
        // Border vectors: a shared one has the same unknowns in every rod.
        let is_free = |vector: &NodeDofs| matches!(vector.unknowns, [Some(x), Some(_)] if x < layout.border);
        let mut known: BTreeMap<[Option<usize>; 2], usize> = BTreeMap::new();
        let mut vectors: Vec<NodeDofs> = Vec::new();
        let mut touches = Vec::new();
        for rod in rods {
            let of_border = rod.chain.iter().filter(|vector| !is_free(vector) && vector.unknowns != [None; 2]);
            let numbers = of_border.map(|vector| {
                *known.entry(vector.unknowns).or_insert_with(|| {
                    vectors.push(*vector);
                    vectors.len() - 1
                })
            });
            touches.push(numbers.collect::<Vec<usize>>());
        }
        // Numbered along the structure, so that their band is narrow.
        let mut unknowns = Vec::new();
        let mut border = vectors.clone();
        for vector in order(vectors.len(), &touches) {
            border[vector].unknowns = vectors[vector].unknowns.map(|unknown| {
                unknowns.push(unknown?);
                Some(unknowns.len() - 1)
            });
        }
        let spread = |touched: &Vec<usize>| {
            let numbers = || touched.iter().flat_map(|&vector| border[vector].unknowns).flatten();
            numbers().max().zip(numbers().min()).map_or(0, |(last, first)| last - first)
        };
        let band = touches.iter().map(spread).max().unwrap_or(0);
        let mut corner = BandMatrix::zeros(unknowns.len(), band);
        let mut factors = Vec::new();
        for ((rod, block), touches) in rods.iter().zip(&layout.blocks).zip(touches) {
            let place_of = |vector: &NodeDofs| touches.iter().position(|&n| vectors[n].unknowns == vector.unknowns);
            factors.push(RodFactors::new(
                &RodMass { rod },
                (block, path),
                is_free,
                place_of,
                &touches,
                &border,
                &mut corner,
            )?);
        }
        let corner = corner.lu().map_err(|SingularAt(pivot)| SingularAt(unknowns[pivot]))?;
        let border_rhs = DVector::zeros(unknowns.len());
        Ok(Condensed { rods: factors, border, unknowns, corner, border_rhs })
    }

    fn solve(&mut self, b: &mut [f64]) {
        let Condensed { rods, border, unknowns, corner, border_rhs } = self;
        rods.iter().for_each(|rod| rod.chain.solve(&mut b[rod.own.clone()]));
        border_rhs.iter_mut().zip(&*unknowns).for_each(|(border_rhs, &unknown)| *border_rhs = b[unknown]);
        for rod in &*rods {
            for &(free, touched, mass) in &rod.coupling {
                let a = vector_at(b, rod.free[free]);
                border[rod.touches[touched]].add(&(-mass * a), border_rhs);
            }
        }
        corner.solve(border_rhs.as_mut_slice());
        border_rhs.iter().zip(&*unknowns).for_each(|(a, &unknown)| b[unknown] = *a);
        for rod in &*rods {
            rod.respond(border, border_rhs, b);
        }
    }
}

fn vector_at(b: &[f64], place: u32) -> Vector2<f64> {
    Vector2::new(b[place as usize], b[place as usize + 1])
}

impl RodFactors {
    /// Factors of a rod; its part of M_bb − M_bf W is added to the corner.
    fn new(
        mass: &RodMass,
        (block, path): (&BlockLayout, Path),
        is_free: impl Fn(&NodeDofs) -> bool,
        place_of: impl Fn(&NodeDofs) -> Option<usize>,
        touches: &[usize],
        border: &[NodeDofs],
        corner: &mut BandMatrix,
    ) -> Result<RodFactors, SingularAt> {
        let chain = &mass.rod.chain;
        let places: Vec<usize> = (0..chain.len()).filter(|&vector| is_free(&chain[vector])).collect();
        let free: Vec<u32> = places.iter().filter_map(|&vector| chain[vector].unknowns[0]).map(|x| x as u32).collect();
        let own = block.first..block.first + block.size;
        let own_free: Vec<NodeDofs> = chain.iter().map(|vector| own_dofs(vector, is_free(vector), own.start)).collect();
        let vectors = mass.rod.mesh.vectors().len();
        let factors = mass_chain(vectors, &own_free, |row, column| mass.rod.mesh.mass(row, column), path)
            .map_err(|SingularAt(vector)| SingularAt(chain[vector].unknowns[0].unwrap_or_default()))?;

        // Indices in the chain of the border vectors, and the coupling of free vectors with them.
        let bordering: Vec<(usize, usize)> =
            (0..chain.len()).filter_map(|vector| Some((vector, place_of(&chain[vector])?))).collect();
        let mut coupling = Vec::new();
        for &(vector, touched) in &bordering {
            for neighbour in mass.neighbours(vector) {
                if let Ok(free) = places.binary_search(&neighbour) {
                    coupling.push((free, touched, mass.entry(vector, neighbour)));
                }
            }
        }
        let mut rod = RodFactors {
            own,
            free,
            chain: factors,
            touches: touches.to_vec(),
            coupling,
            response: vec![0.0; places.len() * touches.len()],
        };
        rod.find_response();
        for &(row, s) in &bordering {
            for &(column, t) in &bordering {
                let own = if mass.neighbours(row).contains(&column) { mass.entry(row, column) } else { 0.0 };
                let its = rod.coupling.iter().filter(|coupling| coupling.1 == s);
                let taken: f64 = its.map(|&(free, _, mass)| mass * rod.response[free * touches.len() + t]).sum();
                add_entry(own - taken, &border[touches[s]], &border[touches[t]], corner);
            }
        }
        Ok(rod)
    }

    /// Matrix W, column by column: the chain is solved for vectors with y = 0.
    fn find_response(&mut self) {
        let (count, first) = (self.touches.len(), self.own.start);
        let mut column = vec![0.0; self.own.len()];
        for touched in 0..count {
            column.fill(0.0);
            for &(free, _, mass) in self.coupling.iter().filter(|coupling| coupling.1 == touched) {
                column[self.free[free] as usize - first] = mass;
            }
            self.chain.solve(&mut column);
            for (free, place) in self.free.iter().enumerate() {
                self.response[free * count + touched] = column[*place as usize - first];
            }
        }
    }

    /// Subtracts W a_b from the free vectors.
    fn respond(&self, border: &[NodeDofs], border_rhs: &DVector<f64>, b: &mut [f64]) {
        if self.touches.is_empty() {
            return;
        }
        let mut of_border = [Vector2::zeros(); MOST_BORDER_VECTORS];
        of_border.iter_mut().zip(&self.touches).for_each(|(a, &touched)| *a = border[touched].get(border_rhs));
        for (row, &place) in self.response.chunks_exact(self.touches.len()).zip(&self.free) {
            let mut a = vector_at(b, place);
            row.iter().zip(&of_border).for_each(|(response, of_border)| a -= *response * of_border);
            b[place as usize..place as usize + 2].copy_from_slice(a.as_slice());
        }
    }
}

/// Factors of a rod of elements with `vectors` nodal vectors each. `free` are the chain's vectors, without unknowns where they are
/// not free; `entry` is an element's M, by its nodal vectors.
///
/// # Errors
/// Index in the chain of a vector whose pivot is not positive.
fn mass_chain(
    vectors: usize,
    free: &[NodeDofs],
    entry: impl Fn(usize, usize) -> f64,
    path: Path,
) -> Result<Box<dyn MassChain>, SingularAt> {
    Ok(if vectors == 4 {
        Box::new(NodeChain::new(free, entry, path)?)
    } else {
        Box::new(CondensedChain::new(free, entry, path)?)
    })
}

/// Unknowns of a free vector, counted from the rod's first; none of another one.
fn own_dofs(vector: &NodeDofs, is_free: bool, first: usize) -> NodeDofs {
    let unknowns = vector.unknowns.map(|unknown| unknown.filter(|_| is_free).map(|unknown| unknown - first));
    NodeDofs { unknowns, turn: None }
}

/// Adds `mass` · 1, which couples two nodal vectors, in the axes of each of them.
fn add_entry(mass: f64, row: &NodeDofs, column: &NodeDofs, corner: &mut BandMatrix) {
    for (axis, j) in [Vector2::x(), Vector2::y()].into_iter().zip(column.unknowns) {
        let along = column.turn.map_or(axis, |turn| turn * axis);
        let own = row.turn.map_or(along, |turn| turn.inverse() * along);
        for (value, i) in own.iter().zip(row.unknowns) {
            if let (Some(i), Some(j)) = (i, j) {
                corner.add(i, j, mass * value);
            }
        }
    }
}

impl MassFactors {
    /// Solves M a = f in place; with multipliers M a + Φ_qᵀ λ = f, Φ_q a = 0.
    pub fn solve(&mut self, f: &mut DVector<f64>) {
        match &mut self.0 {
            MassKind::Condensed(condensed) => condensed.solve(f.as_mut_slice()),
            MassKind::Multipliers(factors) => factors.solve(f),
        }
        flush_negligible(f);
    }
}

impl Structure {
    /// Factorises the mass matrix, bordered by the constraints if there are multipliers.
    ///
    /// # Errors
    /// Unknown of a vanishing pivot; [`location`](Structure::location) describes it.
    pub fn factorize_mass(&self) -> Result<MassFactors, SingularAt> {
        if self.rows.is_empty() {
            return Ok(MassFactors(MassKind::Condensed(Condensed::new(&self.rods, &self.layout, self.path)?)));
        }
        let mut sum = self.assemble_matrix(|_| ElementMatrix::Mass);
        self.add_constraints(1.0, &mut sum);
        Ok(MassFactors(MassKind::Multipliers(sum.equilibrated_lu()?)))
    }
}
