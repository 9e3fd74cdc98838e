//! The beam element as a structure sees it: energy, forces and tangents of a displacement u = e − e₀.

#![allow(non_snake_case)] // eps_T is ε_T, as in the equations.

use nalgebra::{SMatrix, SVector, Vector2};

use super::deviation::Deviation;
use super::nodal_vector::NodalVector;
use super::section_state::SectionState;
use crate::lanes::Lanes;

/// Thermal strain (along, across) in the rod's own axes: (α_T ΔT, α_T ΔT) in the 2D model, (α_T ΔT, 0) in the 1D model.
pub type ThermalStrain = [f64; 2];

/// Displacements and thermal strains at both ends of a step, of one element or of a structure with one thermal strain a rod.
#[derive(Clone, Copy, Debug)]
pub struct Ends<'a, V: ?Sized, T = ThermalStrain> {
    /// Displacement at the start of the step.
    pub u_0: &'a V,
    /// Displacement at the end of the step.
    pub u_1: &'a V,
    /// Thermal strain at the start of the step.
    pub thermal_0: T,
    /// Thermal strain at the end of the step.
    pub thermal_1: T,
}

/// Both ends of a step, of four elements side by side.
pub struct FourEnds<L, const N: usize> {
    /// Displacements at the start and at the end of the step.
    pub u: [[L; N]; 2],
    /// Thermal strains there.
    pub eps_T: [[L; 2]; 2],
}

/// Straight beam element with `N` nodal coordinates.
///
/// Displacements u = e − e₀ have positions in m and slopes without unit, in global axes. Forces are in N on positions and N m on
/// slopes.
pub trait Beam<const N: usize> {
    /// Nodal vectors in the order of e.
    ///
    /// The first two are node i's, the last two node k's. Neighbouring elements of a rod share them.
    const VECTORS: &'static [NodalVector];

    /// Smallest size of the numbers whose difference is a strain: the rounding error of a strain is ε_mach times as large.
    ///
    /// 1 where 1 is subtracted from a squared stretch; 0 where strains are formed from displacements alone.
    const ROUNDING_SCALE: f64 = 0.0;

    /// Stress-free stretches minus 1 (along, across) of a thermal strain.
    fn stress_free(eps_T: ThermalStrain) -> [f64; 2];

    /// Displacement of the axis at a fraction of the length, m.
    fn axis(fraction: f64, u: &SVector<f64, N>, l: f64) -> Vector2<f64>;

    /// State of the section at a fraction of the length.
    fn section_state(&self, fraction: f64, u: &SVector<f64, N>) -> SectionState;

    /// Smallest det J over the quadrature points; ≤ 0 or NaN: the element has collapsed.
    ///
    /// `before` is a displacement from which `u` was reached in a few steps.
    fn min_det_j(&self, before: &SVector<f64, N>, u: &SVector<f64, N>) -> f64;

    /// Strain energy, J.
    fn energy(&self, u: &SVector<f64, N>, eps_T: ThermalStrain) -> f64;

    /// Elastic forces Q_e = ∂U/∂e.
    fn force(&self, u: &SVector<f64, N>, eps_T: ThermalStrain) -> SVector<f64, N>;

    /// Elastic forces ([`force`](Beam::force)) of four elements side by side.
    fn forces<L: Lanes>(&self, token: L::Token, u: &[L; N], eps_T: [L; 2]) -> [L; N];

    /// Tangent ∂Q_e/∂e, symmetric.
    fn tangent(&self, u: &SVector<f64, N>, eps_T: ThermalStrain) -> SMatrix<f64, N, N>;

    /// Tangent of the mixed Newton iteration: section forces are unknowns too, eliminated at each Gauss point
    /// (Magisano, Leonetti and Garcea 2017).
    ///
    /// It differs from [`tangent`](Beam::tangent) in the geometric part alone. There the section forces are those that the last
    /// step, `before` → `u`, predicted with a linear change of strain. Where the axis bends far in one step, the strains of `u`
    /// are quadratic in that step and far too large; the predicted forces are not. With `before` = `u` both tangents are equal.
    fn mixed_tangent(&self, before: &SVector<f64, N>, u: &SVector<f64, N>, eps_T: ThermalStrain) -> SMatrix<f64, N, N>;

    /// Mean force Q̄ of the energy–momentum step from `u_0` to `u_1`.
    ///
    /// Stresses are averaged over both ends. They act through a derivative of the strains whose product with u₁ − u₀ is exactly
    /// the change of strain. So the work of the force is exact, with [`heating_work`](Beam::heating_work) for the last term:
    /// Q̄·(u₁ − u₀) = U₁ − U₀ + ∫ σ̄ : (ε_T1 − ε_T0) dV.
    fn mean_force(&self, ends: &Ends<SVector<f64, N>>) -> SVector<f64, N>;

    /// Mean forces ([`mean_force`](Beam::mean_force)) of four elements side by side.
    fn mean_forces<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, N>) -> [L; N];

    /// Strain energies ([`energy`](Beam::energy)) of four elements side by side, J.
    fn energies<L: Lanes>(&self, token: L::Token, u: &[L; N], eps_T: [L; 2]) -> L;

    /// Energies supplied by heating ([`heating_work`](Beam::heating_work)) of four elements side by side, J.
    fn heating_works<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, N>) -> L;

    /// Smallest det J ([`min_det_j`](Beam::min_det_j)) of four elements side by side.
    fn min_det_js<L: Lanes>(&self, token: L::Token, before: &[L; N], u: &[L; N]) -> L;

    /// Products M a of four elements side by side, with their mass matrix.
    fn momenta<L: Lanes>(token: L::Token, mass: &SMatrix<f64, N, N>, a: &[L; N]) -> [L; N];

    /// Derivative of [`mean_force`](Beam::mean_force) with respect to `u_1`; not symmetric.
    fn mean_tangent(&self, ends: &Ends<SVector<f64, N>>) -> SMatrix<f64, N, N>;

    /// Terms that a stress-free deviation by `u` adds. `None` where strains are not quadratic in the coordinates.
    fn deviation(&self, u: &SVector<f64, N>) -> Option<Deviation<N>> {
        let _ = u;
        None
    }

    /// Energy supplied by heating over a step, J: −∫ σ̄ : (ε_T1 − ε_T0) dV with the averaged stress σ̄.
    fn heating_work(&self, ends: &Ends<SVector<f64, N>>) -> f64;
}
