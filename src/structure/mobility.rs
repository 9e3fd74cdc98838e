//! Mechanisms: statics needs supports and pins that leave no motion without strain.
//!
//! Each rod, taken as rigid, has three velocities: that of its first point, and ω L. Constraints are linear in them: C
//! x = 0. The structure is a mechanism if that has a solution x ≠ 0. C = Q R by rotations, and inverse iteration on RᵀR
//! finds the x that C stretches least, without the digits lost in forming CᵀC. The statement is of first order: two
//! rods in line, pinned where they meet, can move across without strain at first, and are refused.

use std::collections::BTreeMap;

use nalgebra::{DVector, Vector2, Vector3};

use super::constraints::{Constraint, pin, supports};
use super::numbering::cuthill_mckee;
use super::point::Point;
use super::rod::Rod;
use crate::elements::Meaning;
use crate::error::{Error, Result};
use crate::model::Scene;

/// Largest |C x| / |x| of a motion without strain: above the rounding of zero in thousands of rods, and below the value
/// of such a structure where it is held.
const STRAIN_FREE: f64 = 1e-12;

/// Replaces a zero on the diagonal of R.
const ZERO_PIVOT: f64 = 1e-18;

const ITERATIONS: usize = 4;

/// Most rods named in the message.
const MOST_NAMES: usize = 4;

/// Number of rigid velocities of a rod.
const RIGID_VELOCITIES: usize = 3;

/// Refuses a structure that can move without strain.
///
/// # Errors
/// [`Error::Drifts`] with the moving rods; [`Error::TooLarge`] where too many rods meet for the memory.
pub(super) fn check(scene: &Scene, points: &BTreeMap<String, Point>, rods: &[Rod]) -> Result<()> {
    let mechanism = Mechanism::new(scene, points, rods)?;
    let Some(x) = mechanism.next_motion(&[]) else { return Ok(()) };
    let moves = |rod: usize| x.rows(RIGID_VELOCITIES * mechanism.place[rod], RIGID_VELOCITIES).amax() > 1e-6 * x.amax();
    let moving: Vec<String> =
        (0..rods.len()).filter(|&rod| moves(rod)).map(|rod| format!("`{}`", rods[rod].name)).collect();
    let more = if moving.len() > MOST_NAMES { " …" } else { "" };
    Err(Error::Drifts { rods: moving[..moving.len().min(MOST_NAMES)].join(", ") + more })
}

/// Number of independent motions without strain.
///
/// # Errors
/// [`Error::TooLarge`] where too many rods meet for the memory.
pub(super) fn degrees_of_freedom(scene: &Scene, points: &BTreeMap<String, Point>, rods: &[Rod]) -> Result<usize> {
    let mechanism = Mechanism::new(scene, points, rods)?;
    let mut motions = Vec::new();
    while let Some(motion) = mechanism.next_motion(&motions) {
        motions.push(motion);
    }
    Ok(motions.len())
}

/// Rigid rods with their constraints C, and the factor R.
struct Mechanism {
    /// Position of each rod in the order of the columns.
    place: Vec<usize>,
    rows: Vec<Vec<(usize, f64)>>,
    factor: TriangularFactor,
}

impl Mechanism {
    fn new(scene: &Scene, points: &BTreeMap<String, Point>, rods: &[Rod]) -> Result<Mechanism> {
        let place = rod_positions(rods.len(), points);
        let mut rows: Vec<Vec<(usize, f64)>> = Vec::new();
        for point in points.values() {
            let mut nodes = point.nodes.clone();
            // Neighbours in the order of rods, so that the band stays narrow where many rods meet.
            nodes.sort_by_key(|node| place[node.rod]);
            let pins = nodes.windows(2).flat_map(|pair| pin(pair[0], pair[1]));
            rows.extend(pins.map(|row| rates(scene, rods, &place, &row)));
        }
        rows.extend(supports(scene, points).map(|row| rates(scene, rods, &place, &row)));
        rows.sort_by_key(|row| row.iter().map(|(column, _)| *column).min());

        let mut factor = TriangularFactor::new(RIGID_VELOCITIES * rods.len(), &rows)?;
        rows.iter().for_each(|row| factor.rotate_in(row));
        Ok(Mechanism { place, rows, factor })
    }

    /// A motion without strain beside `known` ones of unit length, of unit length and normal to them.
    fn next_motion(&self, known: &[DVector<f64>]) -> Option<DVector<f64>> {
        let phase = 1.7 + 0.3 * known.len() as f64;
        let mut x = DVector::from_fn(self.factor.size, |n, _| 1.0 + 0.5 * (phase * n as f64).sin());
        if known.len() >= x.len() {
            return None;
        }
        for _ in 0..ITERATIONS {
            self.factor.solve_transposed(&mut x);
            x /= x.amax();
            self.factor.solve(&mut x);
            x /= x.amax();
            // What rounding leaves of the first pass the second one takes.
            for motion in known.iter().chain(known) {
                x.axpy(-motion.dot(&x), motion, 1.0);
            }
            x.normalize_mut();
        }
        let stretch =
            |row: &Vec<(usize, f64)>| row.iter().map(|(column, weight)| weight * x[*column]).sum::<f64>().powi(2);
        (self.rows.iter().map(stretch).sum::<f64>().sqrt() <= STRAIN_FREE).then_some(x)
    }
}

/// Upper triangular factor of a matrix with banded rows.
struct TriangularFactor {
    size: usize,
    width: usize,
    /// Row k holds columns k … k + width − 1.
    entries: Vec<f64>,
}

impl TriangularFactor {
    /// Factor without rows yet; `rows` determine its bandwidth.
    fn new(size: usize, rows: &[Vec<(usize, f64)>]) -> Result<TriangularFactor> {
        let reach = |row: &Vec<(usize, f64)>| {
            let columns = || row.iter().map(|(column, _)| *column);
            columns().max().zip(columns().min()).map_or(0, |(last, first)| last - first)
        };
        let width = 1 + rows.iter().map(reach).max().unwrap_or(0);
        super::memory::check_memory(size, width, size.saturating_mul(width).saturating_mul(size_of::<f64>()))?;
        Ok(TriangularFactor { size, width, entries: vec![0.0; size * width] })
    }

    /// Adds a row by Givens rotations, each of which clears its first entry.
    fn rotate_in(&mut self, row: &[(usize, f64)]) {
        let Some(first) = row.iter().map(|(column, _)| *column).min() else { return };
        let mut rest = vec![0.0; self.width];
        row.iter().for_each(|(column, weight)| rest[column - first] += weight);
        for k in first..self.size {
            let own = &mut self.entries[k * self.width..(k + 1) * self.width];
            let length = own[0].hypot(rest[0]);
            if length > 0.0 {
                let (cos, sin) = (own[0] / length, rest[0] / length);
                for (own, rest) in own.iter_mut().zip(&mut rest) {
                    (*own, *rest) = (cos * *own + sin * *rest, cos * *rest - sin * *own);
                }
            }
            rest.rotate_left(1);
            rest[self.width - 1] = 0.0;
            if rest.iter().all(|entry| entry.abs() <= f64::EPSILON * f64::EPSILON) {
                return;
            }
        }
    }

    fn diagonal(&self, k: usize) -> f64 {
        let diagonal = self.entries[k * self.width];
        if diagonal.abs() > ZERO_PIVOT { diagonal } else { ZERO_PIVOT }
    }

    /// Solves R x = b in place.
    fn solve(&self, b: &mut DVector<f64>) {
        for k in (0..self.size).rev() {
            let last = (k + self.width).min(self.size);
            let row = &self.entries[k * self.width..];
            let known: f64 = (k + 1..last).map(|column| row[column - k] * b[column]).sum();
            b[k] = (b[k] - known) / self.diagonal(k);
        }
    }

    /// Solves Rᵀ x = b in place.
    fn solve_transposed(&self, b: &mut DVector<f64>) {
        for k in 0..self.size {
            b[k] /= self.diagonal(k);
            let row = &self.entries[k * self.width..];
            for column in k + 1..(k + self.width).min(self.size) {
                b[column] -= row[column - k] * b[k];
            }
        }
    }
}

/// Position of each rod in an order that keeps connected rods close together.
fn rod_positions(rods: usize, points: &BTreeMap<String, Point>) -> Vec<usize> {
    let mut touches = vec![Vec::new(); rods];
    for (n, point) in points.values().enumerate() {
        point.nodes.iter().for_each(|node| touches[node.rod].push(n));
    }
    let mut place = vec![0; rods];
    cuthill_mckee(points.len(), &touches).into_iter().enumerate().for_each(|(n, rod)| place[rod] = n);
    place
}

/// Coefficients of a constraint in the velocities (v_x, v_y, ω L) of its rods, with their columns.
fn rates(scene: &Scene, rods: &[Rod], place: &[usize], row: &Constraint) -> Vec<(usize, f64)> {
    let rate = |rod: usize, vector: usize, weight: Vector2<f64>| {
        let ends = [&scene.rods[rod].from, &scene.rods[rod].to].map(|name| Vector2::from(scene.points[name]));
        let along = (ends[1] - ends[0]).normalize();
        let across = Vector2::new(-along.y, along.x);
        let (meaning, place) = rods[rod].nodal(vector);
        match meaning {
            // r = r_from + s L t moves by v + ω s L n.
            Meaning::Position => {
                let fraction = place / rods[rod].elements as f64;
                Vector3::new(weight.x, weight.y, fraction * weight.dot(&across))
            }
            // r_x = t turns by ω n, r_y = n by −ω t.
            Meaning::SlopeX => Vector3::new(0.0, 0.0, weight.dot(&across)),
            Meaning::SlopeY => Vector3::new(0.0, 0.0, -weight.dot(&along)),
        }
    };
    let terms = row.terms.iter().flat_map(|term| {
        let rates = rate(term.rod, term.vector, term.weight);
        (0..RIGID_VELOCITIES).map(move |n| (RIGID_VELOCITIES * place[term.rod] + n, rates[n]))
    });
    terms.filter(|(_, rate)| *rate != 0.0).collect()
}
