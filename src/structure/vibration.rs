//! Slowest vibrations about an equilibrium: K x = ω² M x.
//!
//! Eigenvalues of (K + σM)⁻¹ M are 1/(ω² + σ), the largest ones those of the slowest vibrations. With a shift σ > 0 the matrix
//! has factors also where K is singular, as that of a mechanism is. The inertia of K − ω² M then tells whether the slowest ones
//! found are all that there are.

use nalgebra::DVector;

use super::{Factors, Matrix, Structure};
use crate::elements::ThermalStrain;
use crate::linear::largest_eigenvalues;

/// Start vectors of the first attempt: one more than a free rod has rigid motions.
const BLOCK: usize = 4;

/// Most attempts, with more start vectors or another shift.
const ATTEMPTS: usize = 4;

/// Factor from one shift to the next.
const SHIFT_FACTOR: f64 = 64.0;

/// Part of ω² + σ by which an eigenvalue may be off in its count.
const COUNTED: f64 = 1e-6;

/// Part of the shift that the fastest wanted vibration must reach. With a larger shift the slowest ones lie close together.
const LEAST_SQUARE: f64 = 1e-3;

/// Largest part by which the shift is lowered: with motions without a force alone, any shift is as good.
const LEAST_SHIFT: f64 = 1e-6;

/// What moves in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The structure as one rigid body, without a force.
    Rigid,
    /// Rods as rigid bodies against one another, without a force.
    Mechanism,
    /// A vibration about the equilibrium.
    Vibration,
    /// A deviation that grows: the equilibrium is unstable.
    Unstable,
}

/// Mode of an equilibrium.
#[derive(Clone, Debug)]
pub struct Vibration {
    /// ω², (rad/s)²; zero for a motion without a force, negative for a deviation that grows.
    pub square: f64,
    /// What moves.
    pub kind: Kind,
    /// Displacement, normalised by xᵀ M x = 1.
    pub shape: DVector<f64>,
}

impl Structure {
    /// The `wanted` slowest vibrations about an equilibrium, after what grows and after `free` motions without a force, as many as
    /// the structure has degrees of freedom without strain. `scale` is the square of a slow angular frequency, as an estimate. For
    /// structures in the condensed form; `None` without convergence.
    pub fn slowest_vibrations(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        free: usize,
        wanted: usize,
        scale: f64,
    ) -> Option<Vec<Vibration>> {
        let growing = self.eigenvalues_below(0.0, u, thermal, &mut self.factors()).filter(|_| free == 0).unwrap_or(0);
        let mut found = self.lowest_modes(u, thermal, growing + free + wanted, scale)?;
        let mut zeros: Vec<DVector<f64>> = Vec::new();
        if free > 0 {
            // Rounding makes their ω² anything about zero.
            found.sort_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()));
            zeros = found.drain(..free.min(found.len())).map(|(_, shape)| shape).collect();
        }
        let [whole, rest] = self.whole_and_rest(&zeros, u);
        let without_force = [(Kind::Rigid, whole), (Kind::Mechanism, rest)]
            .into_iter()
            .flat_map(|(kind, shapes)| shapes.into_iter().map(move |shape| Vibration { square: 0.0, kind, shape }));
        let others = found.into_iter().map(|(square, shape)| Vibration {
            square,
            kind: if square < 0.0 { Kind::Unstable } else { Kind::Vibration },
            shape,
        });
        Some(without_force.chain(others).collect())
    }

    /// The `wanted` lowest eigenvalues ω², with their vectors.
    fn lowest_modes(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        wanted: usize,
        scale: f64,
    ) -> Option<Vec<(f64, DVector<f64>)>> {
        let (mut shift, mut block, mut is_lowered) = (scale, BLOCK, false);
        let mut factors = self.factors();
        for _ in 0..ATTEMPTS {
            // No eigenvalue may lie below −σ.
            while self.eigenvalues_below(-shift, u, thermal, &mut factors)? > 0 {
                shift *= SHIFT_FACTOR;
            }
            let found = self.shifted(u, thermal, wanted, shift, block, &mut factors)?;
            let last = found.last()?.0;
            if last < LEAST_SQUARE * shift && !is_lowered {
                (shift, is_lowered) = (last.max(LEAST_SHIFT * shift), true);
                continue;
            }
            let bound = last - COUNTED * (last + shift);
            let there = self.eigenvalues_below(bound, u, thermal, &mut factors)?;
            if there <= found.iter().filter(|(square, _)| *square < bound).count() {
                return Some(found);
            }
            block *= 2;
        }
        None
    }

    fn shifted(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        wanted: usize,
        shift: f64,
        block: usize,
        factors: &mut Factors,
    ) -> Option<Vec<(f64, DVector<f64>)>> {
        self.factorize(Matrix::Tangent { u, thermal, stiffness: 1.0, mass: shift }, factors).ok()?;
        let solved = |x: &DVector<f64>| {
            let mut moved = self.inertia(x);
            factors.solve(&mut moved);
            moved
        };
        let found = largest_eigenvalues(self.size(), wanted, block, solved, |x| self.inertia(x))?;
        Some(found.values.iter().map(|value| 1.0 / value - shift).zip(found.vectors).collect())
    }
}
