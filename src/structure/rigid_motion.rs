//! Tells motions of the whole structure from those of its parts.

use nalgebra::{DMatrix, DVector, Vector2};

use super::Structure;
use super::rod::Rod;
use crate::elements::Meaning;

/// Part of a motion of the whole structure that may lie outside a space of motions, squared: rounding, not a support.
const OUTSIDE: f64 = 1e-6;

/// Part of a vector that is independent of others.
const INDEPENDENT: f64 = 1e-3;

impl Structure {
    /// The space of some M-orthonormal motions, by other ones: those of the whole structure as one body, and the rest.
    pub(super) fn whole_and_rest(&self, motions: &[DVector<f64>], u: &DVector<f64>) -> [Vec<DVector<f64>>; 2] {
        let whole = self.whole_motions(u, motions);
        let mut all = self.orthonormal(whole.iter().chain(motions).cloned());
        let rest = all.split_off(whole.len());
        [all, rest]
    }

    /// Motions of the whole structure as one body within the space of these motions, M-orthonormal.
    fn whole_motions(&self, u: &DVector<f64>, zeros: &[DVector<f64>]) -> Vec<DVector<f64>> {
        if zeros.is_empty() {
            return Vec::new();
        }
        let bodies = self.orthonormal((0..3).map(|n| self.body_motion(n, u)));
        // Singular values of the bodies' components among the zeros: 1 for a motion that is one of both.
        let component = |i: usize, j: usize| zeros[i].dot(&self.inertia(&bodies[j]));
        let components = DMatrix::from_fn(zeros.len(), bodies.len(), component);
        let eigen = components.tr_mul(&components).symmetric_eigen();
        let shared = (0..bodies.len()).filter(|n| eigen.eigenvalues[*n] > 1.0 - OUTSIDE);
        let combined = |n: usize| {
            let parts = bodies.iter().enumerate();
            parts.fold(DVector::zeros(self.size()), |sum, (i, body)| sum + eigen.eigenvectors[(i, n)] * body)
        };
        shared.map(combined).collect()
    }

    /// Vectors of a sequence that are independent of the ones before, M-orthonormal.
    fn orthonormal(&self, vectors: impl Iterator<Item = DVector<f64>>) -> Vec<DVector<f64>> {
        let mut basis: Vec<DVector<f64>> = Vec::new();
        for mut vector in vectors {
            let size = |vector: &DVector<f64>| vector.dot(&self.inertia(vector)).max(0.0).sqrt();
            let whole = size(&vector);
            for _ in 0..2 {
                for own in &basis {
                    let part = own.dot(&self.inertia(&vector));
                    vector.axpy(-part, own, 1.0);
                }
            }
            let rest = size(&vector);
            if rest > INDEPENDENT * whole {
                basis.push(vector / rest);
            }
        }
        basis
    }

    /// Motion of everything along x, along y, or about the origin; components that supports hold are left out.
    fn body_motion(&self, number: usize, u: &DVector<f64>) -> DVector<f64> {
        let mut motion = DVector::zeros(self.size());
        for rod in &*self.rods {
            for (n, vector) in rod.chain.iter().enumerate() {
                let (meaning, at) = place(rod, n, u);
                let by = match number {
                    0 | 1 if meaning != Meaning::Position => Vector2::zeros(),
                    0 => Vector2::x(),
                    1 => Vector2::y(),
                    _ => quarter_turn(at),
                };
                vector.set(&by, &mut motion);
            }
        }
        motion
    }
}

/// Meaning and present value of a rod's nodal vector.
fn place(rod: &Rod, vector: usize, u: &DVector<f64>) -> (Meaning, Vector2<f64>) {
    let (meaning, place) = rod.nodal(vector);
    let t = rod.along.normalize();
    let initial = match meaning {
        Meaning::Position => rod.from + place * rod.along,
        Meaning::SlopeX => t,
        Meaning::SlopeY => quarter_turn(t),
    };
    (meaning, initial + rod.chain[vector].get(u))
}

fn quarter_turn(v: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v.y, v.x)
}
