//! The elements of [`equations`](crate::equations), arranged for speed: [`Ancf`] is the paper's, [`Cable`] its competitor;
//! and, not for speed, [`PrintedShear`], the paper's as printed.
//!
//! A structure asks both for the same things ([`Beam`]). They take displacements u = e − e₀ and thermal strains in the
//! rod's own axes, and subtract no 1 from a number near 1, so that small strains keep their digits.

#![allow(non_snake_case)] // ε_T is eps_T here too.

mod ancf;
mod cable;
mod plane;
mod printed;

use nalgebra::{SMatrix, SVector, Vector2};

pub use ancf::{Ancf, Law};
pub use cable::Cable;
pub use plane::LANES;
pub use printed::PrintedShear;

/// Thermal strain (along, across) in the rod's own axes; both α_T ΔT in the 2D model, (α_T ΔT, 0) in the 1D one.
pub type ThermalStrain = [f64; 2];

/// What a nodal vector is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meaning {
    /// r.
    Position,
    /// ∂r/∂x.
    SlopeX,
    /// ∂r/∂y.
    SlopeY,
}

/// A nodal vector of an element: what it is, and at which fraction of the length.
pub type NodalVector = (Meaning, f64);

/// Both ends of a step, for one element or, with a thermal strain a rod, for a whole structure.
#[derive(Clone, Copy, Debug)]
pub struct Ends<'a, V, T = ThermalStrain> {
    /// Displacement at the step's start.
    pub u_0: &'a V,
    /// Displacement at its end.
    pub u_1: &'a V,
    /// Thermal strain at its start.
    pub thermal_0: T,
    /// Thermal strain at its end.
    pub thermal_1: T,
}

/// A straight beam element with `N` nodal coordinates.
pub trait Beam<const N: usize> {
    /// Its nodal vectors in the order of e. The first two are node i's, the last two node k's, and elements of one rod share
    /// them there.
    const VECTORS: &'static [NodalVector];

    /// Least size of the numbers that a strain is the difference of: 0 where those are displacements alone, as small as the strain.
    const ROUNDED: f64 = 0.0;

    /// Stretches less 1 (along, across) at which a thermal strain makes no stress.
    fn stress_free(eps_T: ThermalStrain) -> [f64; 2];

    /// Displacement of the axis at a fraction of the length, m.
    fn axis(fraction: f64, u: &SVector<f64, N>, l: f64) -> Vector2<f64>;

    /// What is left of the volume at the quadrature point where that is least, of what was there at first: det J. Not over 0, or not a
    /// number, where the element has collapsed. `before` is a displacement from which `u` was reached in few steps.
    fn left(&self, before: &SVector<f64, N>, u: &SVector<f64, N>) -> f64;

    /// Strain energy, J.
    fn energy(&self, u: &SVector<f64, N>, eps_T: ThermalStrain) -> f64;

    /// Elastic forces ∂U/∂e, N and N m, of the displacement `u` = e − e₀.
    fn force(&self, u: &SVector<f64, N>, eps_T: ThermalStrain) -> SVector<f64, N>;

    /// The same of elements side by side.
    fn forces(&self, u: &[SVector<f64, N>; LANES], eps_T: ThermalStrain) -> [SVector<f64, N>; LANES];

    /// Tangent ∂Q_e/∂e, symmetric.
    fn tangent(&self, u: &SVector<f64, N>, eps_T: ThermalStrain) -> SMatrix<f64, N, N>;

    /// Tangent of Newton's iteration with the section forces as unknowns of their own, eliminated station by station
    /// (Magisano, Leonetti and Garcea 2017): everything at `u`, but the geometric part from the forces that the last step,
    /// `before` → `u`, expected of a linear change of strain. Where the axis bends far in one step the strains of `u` are
    /// quadratic in that step and hugely wrong; the expected forces are not. With `before` = `u` it is
    /// [`tangent`](Beam::tangent).
    fn mixed_tangent(&self, before: &SVector<f64, N>, u: &SVector<f64, N>, eps_T: ThermalStrain) -> SMatrix<f64, N, N>;

    /// Force of the energy–momentum step from `u_0` to `u_1`: stresses averaged over the two ends, times a derivative of the
    /// strains whose product with u₁ − u₀ is exactly their change. So its work is exactly the change of strain energy plus the
    /// [`heating_work`](Beam::heating_work) taken off: Q̄·(u₁ − u₀) = U₁ − U₀ + ∫ σ̄ : (ε_T1 − ε_T0) dV.
    fn mean_force(&self, ends: &Ends<SVector<f64, N>>) -> SVector<f64, N>;

    /// The same of elements side by side.
    fn mean_forces(&self, ends: &Ends<[SVector<f64, N>; LANES]>) -> [SVector<f64, N>; LANES];

    /// Derivative of [`mean_force`](Beam::mean_force) with respect to `u_1`; not symmetric.
    fn mean_tangent(&self, ends: &Ends<SVector<f64, N>>) -> SMatrix<f64, N, N>;

    /// Energy that heating puts in over a step, J: −∫ σ̄ : (ε_T1 − ε_T0) dV with the averaged stress.
    fn heating_work(&self, ends: &Ends<SVector<f64, N>>) -> f64;
}
