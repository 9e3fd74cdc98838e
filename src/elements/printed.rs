//! The paper's element with the shear term as printed (E3), to see what that does to a rod. Nothing is arranged for speed: every
//! force and tangent comes from [`equations`](crate::equations), in global axes, in which alone the printed energy is defined.
//!
//! The rest needs no other formula. K is linear in the strains and quadratic in e, U quadratic in ε_T, and of a quadratic function
//! half the difference of its values at ±x is exactly its derivative along x.

#![allow(non_snake_case)] // K, Q, eps_T, as in the paper.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Vector2, Vector3};

use super::{Ancf, Beam, Ends, LANES, Law, NodalVector, ThermalStrain};
use crate::equations::force::{self, Element, Matrix14};
use crate::equations::shape::{self, Vector14};
use crate::equations::strain;
use crate::model::Poisson;

/// One straight element with the energy [`force::U_printed`].
#[derive(Clone, Debug)]
pub struct PrintedShear {
    element: Element,
    theta: f64,
    lambda: f64,
    mu: f64,
    /// The same body: its volume tells when it collapses.
    body: Ancf,
}

impl PrintedShear {
    /// An element of length `l`, section `h` × `w` (m), inclination `theta` (rad) and Lamé's constants `lambda`, `mu` (Pa).
    pub fn new(l: f64, h: f64, w: f64, theta: f64, lambda: f64, mu: f64) -> PrintedShear {
        let (sin, cos) = theta.sin_cos();
        let (t, n, r_i) = (Vector2::new(cos, sin), Vector2::new(-sin, cos), Vector2::zeros());
        let (r_j, r_k) = (0.5 * l * t, l * t);
        let e_0 = shape::e(&shape::Nodes { r_i, r_y_i: n, r_j, r_x_j: t, r_y_j: n, r_k, r_y_k: n });
        let body = Ancf::new(l, h, w, theta, Law { lambda, mu, poisson: Poisson::Full });
        PrintedShear { element: Element { l, h, w, e_0 }, theta, lambda, mu, body }
    }

    /// ε_T in global axes: each part is that of the 1D model, in its own direction.
    fn eps_T(&self, [along, across]: ThermalStrain) -> Vector3<f64> {
        strain::eps_T_1d(1.0, along, self.theta) + strain::eps_T_1d(1.0, across, self.theta + FRAC_PI_2)
    }

    fn U(&self, u: &Vector14, eps_T: &Vector3<f64>) -> f64 {
        force::U_printed(&(self.element.e_0 + u), eps_T, self.lambda, self.mu, &self.element)
    }

    /// K of nodal coordinates `e`.
    fn K(&self, e: &Vector14, eps_T: &Vector3<f64>) -> Matrix14 {
        let K_1 = force::K_1(e, eps_T, &self.element);
        let K_2 = force::K_2(e, eps_T, &self.element);
        let K_3 = force::K_3(e, eps_T, &self.element);
        force::K_printed(self.lambda, self.mu, &K_1, &K_2, &K_3)
    }

    /// K of the strains averaged over both ends of a step, and e in its middle.
    fn middle(&self, ends: &Ends<Vector14>) -> (Matrix14, Vector14) {
        let K_0 = self.K(&(self.element.e_0 + ends.u_0), &self.eps_T(ends.thermal_0));
        let K_1 = self.K(&(self.element.e_0 + ends.u_1), &self.eps_T(ends.thermal_1));
        (0.5 * (K_0 + K_1), self.element.e_0 + 0.5 * (ends.u_0 + ends.u_1))
    }
}

impl Beam<14> for PrintedShear {
    const VECTORS: &'static [NodalVector] = Ancf::VECTORS;

    /// 1 is subtracted from squares of stretches.
    const ROUNDED: f64 = 1.0;

    fn stress_free(eps_T: ThermalStrain) -> [f64; 2] {
        Ancf::stress_free(eps_T)
    }

    fn axis(fraction: f64, u: &Vector14, l: f64) -> Vector2<f64> {
        Ancf::axis(fraction, u, l)
    }

    fn left(&self, before: &Vector14, u: &Vector14) -> f64 {
        self.body.left(before, u)
    }

    fn energy(&self, u: &Vector14, eps_T: ThermalStrain) -> f64 {
        self.U(u, &self.eps_T(eps_T))
    }

    fn force(&self, u: &Vector14, eps_T: ThermalStrain) -> Vector14 {
        let e = self.element.e_0 + u;
        force::Q_e(&e, &self.K(&e, &self.eps_T(eps_T)))
    }

    fn forces(&self, u: &[Vector14; LANES], eps_T: ThermalStrain) -> [Vector14; LANES] {
        u.each_ref().map(|u| self.force(u, eps_T))
    }

    fn tangent(&self, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let e = self.element.e_0 + u;
        force::tangent_printed(&e, &self.eps_T(eps_T), self.lambda, self.mu, &self.element)
    }

    /// A linear change of strain leaves out what is quadratic in the step.
    fn mixed_tangent(&self, before: &Vector14, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let none = Vector3::zeros();
        let quadratic = self.K(&(u - before), &none) - self.K(&Vector14::zeros(), &none);
        self.tangent(u, eps_T) - quadratic
    }

    fn mean_force(&self, ends: &Ends<Vector14>) -> Vector14 {
        let (K, e) = self.middle(ends);
        force::Q_e(&e, &K)
    }

    fn mean_forces(&self, ends: &Ends<[Vector14; LANES]>) -> [Vector14; LANES] {
        let &Ends { thermal_0, thermal_1, .. } = ends;
        std::array::from_fn(|lane| {
            self.mean_force(&Ends { u_0: &ends.u_0[lane], u_1: &ends.u_1[lane], thermal_0, thermal_1 })
        })
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
