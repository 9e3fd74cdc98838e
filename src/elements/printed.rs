//! The paper's element with the shear term as printed (E3), to show what it does to a rod.
//!
//! Nothing is arranged for speed. Every force and tangent comes from [`equations`](crate::equations), in global axes, as the
//! printed energy is defined in these alone.
//!
//! No other formula is needed. K is linear in the strains and quadratic in e, and U is quadratic in ε_T. Half the difference of a
//! quadratic function's values at ±x is exactly its derivative along x.

#![allow(non_snake_case)] // K, Q, eps_T, as in the paper.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Vector2, Vector3};

use super::ancf::{Ancf, Law};
use super::beam::{Beam, Ends, FourEnds, ThermalStrain};
use super::nodal_vector::NodalVector;
use super::one_by_one::{each, over_each, side_by_side};
use super::section_state::SectionState;
use crate::equations::element::{Element, Matrix14};
use crate::equations::material::LameConstants;
use crate::equations::shape::Vector14;
use crate::equations::{force, strain};
use crate::lanes::Lanes;
use crate::model::Poisson;

/// The paper's element, straight, with the printed energy [`force::U_printed`].
#[derive(Clone, Debug)]
pub struct PrintedShear {
    element: Element,
    theta: f64,
    lame: LameConstants,
    /// The element in its consistent form, for the collapse check and the section's state.
    body: Ancf,
}

impl PrintedShear {
    /// Element of length `l`, section `h` × `w` (m), inclination `theta` (rad) and Lamé's constants `lame`.
    pub fn new(l: f64, h: f64, w: f64, theta: f64, lame: LameConstants) -> PrintedShear {
        let body = Ancf::new(l, h, w, theta, Law::PlaneStrain { lame, poisson: Poisson::Full });
        PrintedShear { element: Element::straight(l, h, w, theta), theta, lame, body }
    }

    /// Thermal strain in global axes: each part is that of the 1D model in its own direction.
    fn eps_T(&self, [along, across]: ThermalStrain) -> Vector3<f64> {
        strain::eps_T_1d(1.0, along, self.theta) + strain::eps_T_1d(1.0, across, self.theta + FRAC_PI_2)
    }

    fn U(&self, u: &Vector14, eps_T: &Vector3<f64>) -> f64 {
        force::U_printed(&(self.element.e_0 + u), eps_T, self.lame, &self.element)
    }

    /// Stiffness matrix K of (20) as printed, at the nodal coordinates `e`.
    fn K(&self, e: &Vector14, eps_T: &Vector3<f64>) -> Matrix14 {
        let K_1 = force::K_1(e, eps_T, &self.element);
        let K_2 = force::K_2(e, eps_T, &self.element);
        let K_3 = force::K_3(e, eps_T, &self.element);
        force::K_printed(self.lame, &K_1, &K_2, &K_3)
    }

    /// K averaged over both ends of a step, and e in the middle of it.
    fn middle(&self, ends: &Ends<Vector14>) -> (Matrix14, Vector14) {
        let K_0 = self.K(&(self.element.e_0 + ends.u_0), &self.eps_T(ends.thermal_0));
        let K_1 = self.K(&(self.element.e_0 + ends.u_1), &self.eps_T(ends.thermal_1));
        (0.5 * (K_0 + K_1), self.element.e_0 + 0.5 * (ends.u_0 + ends.u_1))
    }
}

impl Beam<14> for PrintedShear {
    const VECTORS: &'static [NodalVector] = Ancf::VECTORS;

    /// 1 is subtracted from squared stretches.
    const ROUNDING_SCALE: f64 = 1.0;

    fn stress_free(eps_T: ThermalStrain) -> [f64; 2] {
        Ancf::stress_free(eps_T)
    }

    fn axis(fraction: f64, u: &Vector14, l: f64) -> Vector2<f64> {
        Ancf::axis(fraction, u, l)
    }

    fn section_state(&self, fraction: f64, u: &Vector14) -> SectionState {
        self.body.section_state(fraction, u)
    }

    fn min_det_j(&self, before: &Vector14, u: &Vector14) -> f64 {
        self.body.min_det_j(before, u)
    }

    fn energy(&self, u: &Vector14, eps_T: ThermalStrain) -> f64 {
        self.U(u, &self.eps_T(eps_T))
    }

    fn force(&self, u: &Vector14, eps_T: ThermalStrain) -> Vector14 {
        let e = self.element.e_0 + u;
        force::Q_e(&e, &self.K(&e, &self.eps_T(eps_T)))
    }

    fn forces<L: Lanes>(&self, token: L::Token, u: &[L; 14], eps_T: [L; 2]) -> [L; 14] {
        let (u, eps_T) = (each(u), each(&eps_T));
        side_by_side(token, &std::array::from_fn(|n| self.force(&u[n], eps_T[n].into())))
    }

    fn tangent(&self, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let e = self.element.e_0 + u;
        force::tangent_printed(&e, &self.eps_T(eps_T), self.lame, &self.element)
    }

    /// [`tangent`](Beam::tangent) minus the part of K that is quadratic in the step, as the change of strain is linear.
    fn mixed_tangent(&self, before: &Vector14, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let none = Vector3::zeros();
        let quadratic = self.K(&(u - before), &none) - self.K(&Vector14::zeros(), &none);
        self.tangent(u, eps_T) - quadratic
    }

    fn mean_force(&self, ends: &Ends<Vector14>) -> Vector14 {
        let (K, e) = self.middle(ends);
        force::Q_e(&e, &K)
    }

    fn mean_forces<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, 14>) -> [L; 14] {
        side_by_side(token, &over_each(ends, |ends| self.mean_force(ends)))
    }

    fn energies<L: Lanes>(&self, token: L::Token, u: &[L; 14], eps_T: [L; 2]) -> L {
        let (u, eps_T) = (each(u), each(&eps_T));
        L::load(token, &std::array::from_fn(|n| self.energy(&u[n], eps_T[n].into())))
    }

    fn heating_works<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, 14>) -> L {
        L::load(token, &over_each(ends, |ends| self.heating_work(ends)))
    }

    #[inline(always)]
    fn min_det_js<L: Lanes>(&self, token: L::Token, before: &[L; 14], u: &[L; 14]) -> L {
        self.body.min_det_js(token, before, u)
    }

    #[inline(always)]
    fn momenta<L: Lanes>(token: L::Token, mass: &Matrix14, a: &[L; 14]) -> [L; 14] {
        Ancf::momenta(token, mass, a)
    }

    /// ½ K̄ + ½ (∂K₁/∂e₁) ē.
    fn mean_tangent(&self, ends: &Ends<Vector14>) -> Matrix14 {
        let (K, middle) = self.middle(ends);
        let (e_1, none) = (self.element.e_0 + ends.u_1, Vector3::zeros());
        let columns: [Vector14; 14] = std::array::from_fn(|n| {
            let x = Vector14::ith(n, 1.0);
            0.5 * (self.K(&(e_1 + x), &none) - self.K(&(e_1 - x), &none)) * middle
        });
        0.5 * (K + Matrix14::from_columns(&columns))
    }

    fn heating_work(&self, ends: &Ends<Vector14>) -> f64 {
        let (eps_T0, eps_T1) = (self.eps_T(ends.thermal_0), self.eps_T(ends.thermal_1));
        let half = 0.5 * (eps_T1 - eps_T0);
        let at = |u, eps_T| self.U(u, &(eps_T + half)) - self.U(u, &(eps_T - half));
        0.5 * (at(ends.u_0, eps_T0) + at(ends.u_1, eps_T1))
    }
}
