//! The paper's competitor, [`equations::cable`](crate::equations::cable), in displacements.
//!
//! With u = e − e₀, p = u_x, s = u_xx and the initial unit vector t: r_x = t + p, r_xx = s, and
//! |r_x| − 1 = (2t·p + p·p)/(1 + |r_x|), which subtracts no 1 from a number near 1.

#![allow(non_snake_case)] // The symbols of the derivation are names here: EA, EI, N, M, J, H.

use nalgebra::{Matrix2, Matrix4, Vector2, Vector4};

use super::Meaning::{Position, SlopeX};
use super::{Beam, Ends, NodalVector, ThermalStrain};
use crate::equations::cable::{Matrix8, S_i, S_i_x, S_i_xx, Vector8};
use crate::equations::volume::{GAUSS_3, GAUSS_5, axis_points};

/// A Gauss point of the axial strain, or of the curvature: weight (m) and shape functions there.
#[derive(Clone, Copy, Debug)]
struct Station {
    weight: f64,
    s_x: [f64; 4],
    s_xx: [f64; 4],
}

/// One straight element: everything about it that does not change in time.
#[derive(Clone, Debug)]
pub struct Cable {
    t: Vector2<f64>,
    axial: [Station; 5],
    bending: [Station; 3],
    EA: f64,
    EI: f64,
}

/// The axis at a station of the axial strain.
#[derive(Clone, Copy)]
struct Stretch {
    r_x: Vector2<f64>,
    /// |r_x|
    length: f64,
    /// |r_x| − 1
    strain: f64,
}

/// The axis at a station of the curvature.
#[derive(Clone, Copy)]
struct Bend {
    r_x: Vector2<f64>,
    r_xx: Vector2<f64>,
    /// r_x × r_xx, 1/m
    cross: f64,
    /// r_x · r_x
    square: f64,
}

impl Stretch {
    /// ∂ε/∂p
    fn rate(&self) -> Vector2<f64> {
        self.r_x / self.length
    }

    /// ∂²ε/∂p²
    fn rate_rate(&self) -> Matrix2<f64> {
        let n = self.rate();
        (Matrix2::identity() - n * n.transpose()) / self.length
    }
}

impl Bend {
    fn kappa(&self) -> f64 {
        self.cross / self.square
    }

    /// ∂κ/∂(p, s), from κ |r_x|² = r_x × r_xx.
    fn rate(&self) -> Vector4<f64> {
        let Bend { r_x, r_xx, square, .. } = self;
        stack(-turn(r_xx) - 2.0 * self.kappa() * r_x, turn(r_x)) / *square
    }

    /// ∂²κ/∂(p, s)², from the same differentiated twice.
    fn rate_rate(&self) -> Matrix4<f64> {
        let along = stack(self.r_x, Vector2::zeros());
        let product = along * self.rate().transpose();
        let mut H = cross_rate_rate() - 2.0 * (product + product.transpose());
        H[(0, 0)] -= 2.0 * self.kappa();
        H[(1, 1)] -= 2.0 * self.kappa();
        H / self.square
    }
}

/// A vector turned by a right angle: a × b = turn(a)·b.
fn turn(v: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v.y, v.x)
}

/// ∂²(r_x × r_xx)/∂(p, s)².
fn cross_rate_rate() -> Matrix4<f64> {
    let mut H = Matrix4::zeros();
    (H[(0, 3)], H[(3, 0)]) = (1.0, 1.0);
    (H[(1, 2)], H[(2, 1)]) = (-1.0, -1.0);
    H
}

fn stack(p: Vector2<f64>, s: Vector2<f64>) -> Vector4<f64> {
    Vector4::new(p.x, p.y, s.x, s.y)
}

fn sum(shape: &[f64; 4], u: &Vector8) -> Vector2<f64> {
    shape.iter().enumerate().fold(Vector2::zeros(), |sum, (n, s)| sum + *s * Vector2::new(u[2 * n], u[2 * n + 1]))
}

impl Station {
    fn new(l: f64, (x, weight): (f64, f64)) -> Station {
        Station { weight, s_x: S_i_x(x, l), s_xx: S_i_xx(x, l) }
    }

    /// Adds Bᵀ f for a force f on p.
    fn add_axial(&self, f: Vector2<f64>, Q: &mut Vector8) {
        for (n, s_x) in self.s_x.iter().enumerate() {
            Q[2 * n] += s_x * f.x;
            Q[2 * n + 1] += s_x * f.y;
        }
    }

    /// Adds Bᵀ f for a force f on (p, s).
    fn add_bending(&self, f: Vector4<f64>, Q: &mut Vector8) {
        for (n, (s_x, s_xx)) in self.s_x.iter().zip(&self.s_xx).enumerate() {
            Q[2 * n] += s_x * f[0] + s_xx * f[2];
            Q[2 * n + 1] += s_x * f[1] + s_xx * f[3];
        }
    }

    /// Adds Bᵀ H B for a stiffness H in p.
    fn add_axial_stiffness(&self, H: &Matrix2<f64>, K: &mut Matrix8) {
        for (j, s_j) in self.s_x.iter().enumerate() {
            for (i, s_i) in self.s_x.iter().enumerate() {
                let mut target = K.fixed_view_mut::<2, 2>(2 * i, 2 * j);
                target += s_i * s_j * H;
            }
        }
    }

    /// Adds Bᵀ H B for a stiffness H in (p, s).
    fn add_bending_stiffness(&self, H: &Matrix4<f64>, K: &mut Matrix8) {
        let block = |row: usize, column: usize| H.fixed_view::<2, 2>(2 * row, 2 * column).into_owned();
        let (pp, ps, sp, ss) = (block(0, 0), block(0, 1), block(1, 0), block(1, 1));
        for (j, (x_j, xx_j)) in self.s_x.iter().zip(&self.s_xx).enumerate() {
            let (p_column, s_column) = (*x_j * pp + *xx_j * ps, *x_j * sp + *xx_j * ss);
            for (i, (x_i, xx_i)) in self.s_x.iter().zip(&self.s_xx).enumerate() {
                let mut target = K.fixed_view_mut::<2, 2>(2 * i, 2 * j);
                target += *x_i * p_column + *xx_i * s_column;
            }
        }
    }
}

impl Cable {
    /// An element of length `l` (m), inclination `theta` (rad) and the stiffnesses `EA` (N) and `EI` (N m²).
    pub fn new(l: f64, theta: f64, EA: f64, EI: f64) -> Cable {
        let (sin, cos) = theta.sin_cos();
        let (axial, bending) = (axis_points(&GAUSS_5, l), axis_points(&GAUSS_3, l));
        let station = |point| Station::new(l, point);
        Cable { t: Vector2::new(cos, sin), axial: axial.map(station), bending: bending.map(station), EA, EI }
    }

    fn stretch(&self, station: &Station, u: &Vector8) -> Stretch {
        let p = sum(&station.s_x, u);
        let r_x = self.t + p;
        let length = r_x.norm();
        Stretch { r_x, length, strain: (2.0 * self.t.dot(&p) + p.dot(&p)) / (1.0 + length) }
    }

    fn bend(&self, station: &Station, u: &Vector8) -> Bend {
        let (r_x, r_xx) = (self.t + sum(&station.s_x, u), sum(&station.s_xx, u));
        Bend { r_x, r_xx, cross: r_x.perp(&r_xx), square: r_x.norm_squared() }
    }
}

impl Beam<8> for Cable {
    const VECTORS: &'static [NodalVector] = &[(Position, 0.0), (SlopeX, 0.0), (Position, 1.0), (SlopeX, 1.0)];

    /// The strain itself; the section keeps its size.
    fn stress_free([along, _]: ThermalStrain) -> [f64; 2] {
        [along, 0.0]
    }

    fn axis(fraction: f64, u: &Vector8, l: f64) -> Vector2<f64> {
        sum(&S_i(fraction * l, l), u)
    }

    fn energy(&self, u: &Vector8, [eps_T, _]: ThermalStrain) -> f64 {
        let axial = self.axial.iter().map(|station| {
            let epsilon = self.stretch(station, u).strain - eps_T;
            0.5 * station.weight * self.EA * epsilon * epsilon
        });
        let bending = self.bending.iter().map(|station| {
            let kappa = self.bend(station, u).kappa();
            0.5 * station.weight * self.EI * kappa * kappa
        });
        axial.sum::<f64>() + bending.sum::<f64>()
    }

    fn force(&self, u: &Vector8, [eps_T, _]: ThermalStrain) -> Vector8 {
        let mut Q = Vector8::zeros();
        for station in &self.axial {
            let stretch = self.stretch(station, u);
            let N = self.EA * (stretch.strain - eps_T);
            station.add_axial(station.weight * N * stretch.rate(), &mut Q);
        }
        for station in &self.bending {
            let bend = self.bend(station, u);
            station.add_bending(station.weight * self.EI * bend.kappa() * bend.rate(), &mut Q);
        }
        Q
    }

    fn tangent(&self, u: &Vector8, eps_T: ThermalStrain) -> Matrix8 {
        self.mixed_tangent(u, u, eps_T)
    }

    fn mixed_tangent(&self, before: &Vector8, u: &Vector8, [eps_T, _]: ThermalStrain) -> Matrix8 {
        let Cable { EA, EI, .. } = *self;
        let mut K = Matrix8::zeros();
        for station in &self.axial {
            let (stretch_before, stretch) = (self.stretch(station, before), self.stretch(station, u));
            let change = stretch_before.rate().dot(&(stretch.r_x - stretch_before.r_x));
            let expected = EA * (stretch_before.strain + change - eps_T);
            let rate = stretch.rate();
            let H = EA * rate * rate.transpose() + expected * stretch.rate_rate();
            station.add_axial_stiffness(&(station.weight * H), &mut K);
        }
        for station in &self.bending {
            let (bend_before, bend) = (self.bend(station, before), self.bend(station, u));
            let change = stack(bend.r_x - bend_before.r_x, bend.r_xx - bend_before.r_xx).dot(&bend_before.rate());
            let expected = EI * (bend_before.kappa() + change);
            let rate = bend.rate();
            let H = EI * rate * rate.transpose() + expected * bend.rate_rate();
            station.add_bending_stiffness(&(station.weight * H), &mut K);
        }
        K
    }

    fn mean_force(&self, ends: &Ends<Vector8>) -> Vector8 {
        let mut Q = Vector8::zeros();
        for station in &self.axial {
            let step = self.stretches(station, ends);
            station.add_axial(station.weight * step.mean_force(self.EA) * step.rate(), &mut Q);
        }
        for station in &self.bending {
            let step = self.bends(station, ends);
            station.add_bending(station.weight * step.mean_moment(self.EI) * step.rate(), &mut Q);
        }
        Q
    }

    fn mean_tangent(&self, ends: &Ends<Vector8>) -> Matrix8 {
        let Cable { EA, EI, .. } = *self;
        let mut K = Matrix8::zeros();
        for station in &self.axial {
            let step = self.stretches(station, ends);
            let H = 0.5 * EA * step.rate() * step.end.rate().transpose() + step.mean_force(EA) * step.rate_rate();
            station.add_axial_stiffness(&(station.weight * H), &mut K);
        }
        for station in &self.bending {
            let step = self.bends(station, ends);
            let H = 0.5 * EI * step.rate() * step.end.rate().transpose() + step.mean_moment(EI) * step.rate_rate();
            station.add_bending_stiffness(&(station.weight * H), &mut K);
        }
        K
    }

    fn heating_work(&self, ends: &Ends<Vector8>) -> f64 {
        let change = ends.thermal_1[0] - ends.thermal_0[0];
        let work = |station: &Station| -station.weight * self.stretches(station, ends).mean_force(self.EA) * change;
        self.axial.iter().map(work).sum()
    }
}

/// A station of the axial strain at both ends of a step.
struct StretchStep {
    start: Stretch,
    end: Stretch,
    eps_T: [f64; 2],
}

impl StretchStep {
    fn mean_force(&self, EA: f64) -> f64 {
        0.5 * EA * (self.start.strain - self.eps_T[0] + self.end.strain - self.eps_T[1])
    }

    fn mean_r_x(&self) -> Vector2<f64> {
        0.5 * (self.start.r_x + self.end.r_x)
    }

    /// Vector whose product with p₁ − p₀ is |r_x|₁ − |r_x|₀: 2 r̄_x/(|r_x|₀ + |r_x|₁), as |r_x|² changes by 2 r̄_x·(p₁ − p₀).
    fn rate(&self) -> Vector2<f64> {
        2.0 * self.mean_r_x() / (self.start.length + self.end.length)
    }

    /// Its derivative with respect to p₁.
    fn rate_rate(&self) -> Matrix2<f64> {
        (Matrix2::identity() - self.rate() * self.end.rate().transpose()) / (self.start.length + self.end.length)
    }
}

/// A station of the curvature at both ends of a step.
struct BendStep {
    start: Bend,
    end: Bend,
}

impl BendStep {
    fn mean_moment(&self, EI: f64) -> f64 {
        0.5 * EI * (self.start.kappa() + self.end.kappa())
    }

    /// The axis in the middle of the step; the cross product and the square averaged, not those of the middle.
    fn middle(&self) -> Bend {
        let BendStep { start, end } = self;
        Bend {
            r_x: 0.5 * (start.r_x + end.r_x),
            r_xx: 0.5 * (start.r_xx + end.r_xx),
            cross: 0.5 * (start.cross + end.cross),
            square: 0.5 * (start.square + end.square),
        }
    }

    /// Vector whose product with the change Δ of (p, s) is κ₁ − κ₀. With c = r_x × r_xx and q = |r_x|², both quadratic, so that
    /// their derivatives in the middle give Δc and Δq exactly: κ₁ − κ₀ = c₁/q₁ − c₀/q₀ = (q̄ Δc − c̄ Δq)/(q₀q₁).
    fn rate(&self) -> Vector4<f64> {
        let Bend { r_x, r_xx, cross, square } = self.middle();
        stack(-square * turn(&r_xx) - 2.0 * cross * r_x, square * turn(&r_x)) / (self.start.square * self.end.square)
    }

    /// Its derivative with respect to (p₁, s₁), from rate · q₀q₁ differentiated.
    fn rate_rate(&self) -> Matrix4<f64> {
        let Bend { r_x, r_xx, cross, square } = self.middle();
        // ∂q₁ = 2 r_x1, ∂c₁; the averages change by half of that, and so do r_x and r_xx.
        let square_1 = stack(2.0 * self.end.r_x, Vector2::zeros());
        let cross_1 = stack(-turn(&self.end.r_xx), turn(&self.end.r_x));
        let cross_rate = stack(-turn(&r_xx), turn(&r_x));
        let square_rate = stack(2.0 * r_x, Vector2::zeros());
        let mut H = 0.5 * (cross_rate * square_1.transpose() - square_rate * cross_1.transpose());
        H += 0.5 * square * cross_rate_rate();
        H[(0, 0)] -= cross;
        H[(1, 1)] -= cross;
        (H - self.rate() * (self.start.square * square_1).transpose()) / (self.start.square * self.end.square)
    }
}

impl Cable {
    fn stretches(&self, station: &Station, ends: &Ends<Vector8>) -> StretchStep {
        let (start, end) = (self.stretch(station, ends.u_0), self.stretch(station, ends.u_1));
        StretchStep { start, end, eps_T: [ends.thermal_0[0], ends.thermal_1[0]] }
    }

    fn bends(&self, station: &Station, ends: &Ends<Vector8>) -> BendStep {
        BendStep { start: self.bend(station, ends.u_0), end: self.bend(station, ends.u_1) }
    }
}
