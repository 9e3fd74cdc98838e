//! The paper's competitor, [`equations::cable`](crate::equations::cable), in displacements.
//!
//! With u = e − e₀, p = u_x, s = u_xx and the initial unit vector t, r_x = t + p and r_xx = s. The axial strain
//! |r_x| − 1 = (2t·p + p·p)/(1 + |r_x|) subtracts no 1 from a number near 1. p is quadratic in ζ = 2x/l − 1, and s is its
//! derivative along x, so the Gauss points act on three coefficients, as in the paper's element ([`Ancf`](super::Ancf)).

#![allow(non_snake_case)] // The symbols of the derivation are names here: EA, EI, N, M, A, B, H, K, Q.

mod axis;
mod side_by_side;
mod step;

use nalgebra::Vector2;

use axis::{Bend, Blocks, Both, Stretch, combined, outers};
use side_by_side::{SideBySide, momenta};
use step::{BendStep, StretchStep};

use super::beam::{Beam, Ends, FourEnds, ThermalStrain};
use super::collapse::{OUTERMOST, smallest};
use super::layout::{coordinates, matrix, nodal};
use super::nodal_vector::Meaning::{Position, SlopeX};
use super::nodal_vector::NodalVector;
use super::plane::{Block, Linear, Vec2, Vector, vec2};
use super::polynomial::{GaussPoint, Quadratic, add_at, add_moments, add_slope_at, at, gauss_points, slope_at};
use super::section_state::SectionState;
use crate::equations::cable::{Matrix8, S_i, Vector8};
use crate::equations::volume::{GAUSS_3, GAUSS_5};
use crate::lanes::Lanes;

/// The cable element, straight, arranged for speed.
///
/// It holds everything that is constant in time, and is shared by all equal elements of a rod.
#[derive(Clone, Debug)]
pub struct Cable {
    /// Unit vector along the element.
    t: Vec2,
    /// 1/l
    per_length: f64,
    /// Gauss points of the axial strain.
    axial: [GaussPoint; 5],
    /// Gauss points of the curvature.
    bending: [GaussPoint; 3],
    EA: f64,
    EI: f64,
    /// The same for four elements side by side.
    four: SideBySide,
}

/// Moments Σ w ζⁿ H of the stiffnesses in (p, s) at the Gauss points, n = 0 … 4.
type Moments = [[[Block; 5]; 2]; 2];

/// Adds the stiffness in (p, s) of a Gauss point to the moments.
#[inline(always)]
fn add_stiffness(point: &GaussPoint, H: &Blocks, moments: &mut Moments) {
    for (row, H) in moments.iter_mut().zip(H) {
        for (moments, H) in row.iter_mut().zip(H) {
            add_moments(point.zeta, *H, moments);
        }
    }
}

impl Cable {
    /// Element of length `l` (m), inclination `theta` (rad) and the stiffnesses `EA` (N) and `EI` (N m²).
    pub fn new(l: f64, theta: f64, EA: f64, EI: f64) -> Cable {
        let (sin, cos) = theta.sin_cos();
        let (axial, bending) = (gauss_points(&GAUSS_5, l), gauss_points(&GAUSS_3, l));
        let (t, per_length) = (vec2(cos, sin), 1.0 / l);
        let four = SideBySide { t: [cos, sin], per_length, axial, bending, EA, EI };
        Cable { t, per_length, axial, bending, EA, EI, four }
    }

    /// Polynomial p = u_x of a displacement from its nodal vectors; its derivative with respect to ζ is l/2 u_xx.
    ///
    /// With Δ = (rᵏ − rⁱ)/l, the mean m of the slopes at both ends and their difference 2d,
    /// r_x = ½(3Δ − m) + d ζ + 3/2 (m − Δ) ζ².
    #[inline(always)]
    fn shape(&self, [r_i, slope_i, r_k, slope_k]: [Vec2; 4]) -> Quadratic<Vec2> {
        let (chord, mean) = ((r_k - r_i) * self.per_length, (slope_i + slope_k) * 0.5);
        [chord * 1.5 - mean * 0.5, (slope_k - slope_i) * 0.5, (mean - chord) * 1.5]
    }

    /// Polynomial p of a displacement from its coordinates.
    #[inline(always)]
    fn shape_of(&self, u: &Vector8) -> Quadratic<Vec2> {
        self.shape(nodal(u.as_slice()))
    }

    /// Forces on the nodal vectors from the forces on the coefficients of p: the transpose of [`shape`](Cable::shape).
    #[inline(always)]
    fn to_nodes<T: Linear>(&self, [p_0, p_1, p_2]: &[T; 3]) -> [T; 4] {
        let chord = (*p_0 - *p_2) * (1.5 * self.per_length);
        let (mean, difference) = (*p_2 * 0.75 - *p_0 * 0.25, *p_1 * 0.5);
        [chord * -1.0, mean - difference, chord, mean + difference]
    }

    /// Adds a force on (p, s) at a Gauss point to the forces on the coefficients.
    #[inline(always)]
    fn add_bending(&self, point: &GaussPoint, [f_p, f_s]: Both, Q: &mut Quadratic<Vec2>) {
        add_at(point.zeta, f_p, Q);
        add_slope_at(point.zeta, f_s * (2.0 * self.per_length), Q);
    }

    /// Elastic forces on the nodal vectors.
    #[inline(always)]
    fn nodal_force(&self, u: [Vec2; 4], eps_T: f64) -> [Vec2; 4] {
        let shape = self.shape(u);
        let Cable { EA, EI, .. } = *self;
        let mut Q = [Vec2::ZERO; 3];
        for point in &self.axial {
            let stretch = self.stretch(point, &shape);
            let N = EA * (stretch.strain - eps_T);
            add_at(point.zeta, stretch.rate() * (point.weight * N), &mut Q);
        }
        for point in &self.bending {
            let bend = self.bend(point, &shape);
            let M = point.weight * EI * bend.kappa();
            self.add_bending(point, bend.rate().map(|rate| rate * M), &mut Q);
        }
        self.to_nodes(&Q)
    }

    /// Forces of an energy–momentum step on the nodal vectors.
    #[inline(always)]
    fn nodal_mean_force(&self, u: [[Vec2; 4]; 2], eps_T: [f64; 2]) -> [Vec2; 4] {
        let shapes = u.map(|u| self.shape(u));
        let mut Q = [Vec2::ZERO; 3];
        for point in &self.axial {
            let step = self.stretches(point, &shapes, eps_T);
            add_at(point.zeta, step.rate() * (point.weight * step.mean_force(self.EA)), &mut Q);
        }
        for point in &self.bending {
            let step = self.bends(point, &shapes);
            let M = point.weight * step.mean_moment(self.EI);
            self.add_bending(point, step.rate().map(|rate| rate * M), &mut Q);
        }
        self.to_nodes(&Q)
    }

    /// Matrix of the element from the moments of its axial and of its bending stiffness.
    ///
    /// The coefficient m changes p by ζᵐ and s by 2m ζᵐ⁻¹/l.
    fn matrix(&self, axial: &[Block; 5], bending: &Moments) -> Matrix8 {
        let [[pp, ps], [sp, ss]] = bending;
        let slope = |m: usize| 2.0 * self.per_length * m as f64;
        let mut of_coefficients = [[Block::ZERO; 3]; 3];
        for (n, row) in of_coefficients.iter_mut().enumerate() {
            for (m, block) in row.iter_mut().enumerate() {
                let power: usize = n + m;
                let below = power.saturating_sub(1);
                *block = axial[power]
                    + pp[power]
                    + ps[below] * slope(m)
                    + sp[below] * slope(n)
                    + ss[below.saturating_sub(1)] * (slope(n) * slope(m));
            }
        }
        Matrix8::from(matrix(&of_coefficients, |forces| self.to_nodes(forces)))
    }

    /// Stretch of the axis at a Gauss point.
    #[inline(always)]
    fn stretch(&self, point: &GaussPoint, shape: &Quadratic<Vec2>) -> Stretch {
        let (t, p) = (self.t, at(point.zeta, shape));
        let r_x = t + p;
        let length = r_x.dot(r_x).sqrt();
        // One division for both inverses: a division takes as long as ten multiplications.
        let both = 1.0 / (length * (1.0 + length));
        let strain = (2.0 * t.dot(p) + p.dot(p)) * (length * both);
        Stretch { r_x, length, inverse: (1.0 + length) * both, strain }
    }

    /// Second derivative in p of the axial energy of a Gauss point; the geometric part from the elastic strain `expected`.
    #[inline(always)]
    fn axial_stiffness(&self, point: &GaussPoint, stretch: &Stretch, expected: f64) -> Block {
        let (EA, rate) = (point.weight * self.EA, stretch.rate());
        (Block::outer(1.0, rate, rate) + stretch.rate_rate() * expected) * EA
    }

    /// Second derivative in (p, s) of the bending energy of a Gauss point; the geometric part from the curvature `expected`.
    #[inline(always)]
    fn bending_stiffness(&self, point: &GaussPoint, bend: &Bend, expected: f64) -> Blocks {
        let (EI, rate) = (point.weight * self.EI, bend.rate());
        combined(EI, &outers(rate, rate), EI * expected, &bend.rate_rate())
    }

    /// Curvature of the axis at a Gauss point.
    #[inline(always)]
    fn bend(&self, point: &GaussPoint, shape: &Quadratic<Vec2>) -> Bend {
        let r_x = self.t + at(point.zeta, shape);
        let r_xx = slope_at(point.zeta, shape) * (2.0 * self.per_length);
        let square = r_x.dot(r_x);
        Bend { r_x, r_xx, cross: r_x.turn().dot(r_xx), square, inverse: 1.0 / square }
    }
}

/// Axial thermal strains at both ends of a step.
fn along(ends: &Ends<Vector8>) -> [f64; 2] {
    [ends.thermal_0[0], ends.thermal_1[0]]
}

impl Beam<8> for Cable {
    const VECTORS: &'static [NodalVector] = &[(Position, 0.0), (SlopeX, 0.0), (Position, 1.0), (SlopeX, 1.0)];

    /// The thermal strain itself; the section keeps its size.
    fn stress_free([along, _]: ThermalStrain) -> [f64; 2] {
        [along, 0.0]
    }

    fn axis(fraction: f64, u: &Vector8, l: f64) -> Vector2<f64> {
        S_i(fraction * l, l)
            .into_iter()
            .zip(nodal::<4>(u.as_slice()))
            .fold(Vec2::ZERO, |sum, (s, r)| sum + r * s)
            .to_array()
            .into()
    }

    fn section_state(&self, fraction: f64, u: &Vector8) -> SectionState {
        let (point, shape) = (GaussPoint { weight: 0.0, zeta: 2.0 * fraction - 1.0 }, self.shape_of(u));
        let (stretch, bend) = (self.stretch(&point, &shape), self.bend(&point, &shape));
        SectionState {
            director: (bend.r_x.turn() * (1.0 / stretch.length)).to_array().into(),
            strain: stretch.strain,
            curvature: bend.kappa(),
        }
    }

    /// The section stays plane and normal to the axis and rotates by θ_x = (r_x × r_xx)/|r_x|² per length. So a fibre at y is
    /// stretched by |r_x| − y θ_x: det J of this theory. It is smallest at an outermost Gauss point across the
    /// section, whose height is √(12 EI/EA).
    ///
    /// An axis that has been pressed through zero length points backwards and is long again: no determinant shows it. But then
    /// r_x·r_x(before) < 0, unless the axis rotated by more than a right angle in a step, which no method follows either. So
    /// this product counts too.
    fn min_det_j(&self, before: &Vector8, u: &Vector8) -> f64 {
        let (before, shape) = (self.shape_of(before), self.shape_of(u));
        let half_height = (3.0 * self.EI / self.EA).sqrt();
        let fibres = self.bending.iter().map(|point| {
            let bend = self.bend(point, &shape);
            bend.square.sqrt() - OUTERMOST * half_height * bend.kappa().abs()
        });
        let turned = self.axial.iter().map(|point| {
            let r_x = |shape| self.t + at(point.zeta, shape);
            r_x(&before).dot(r_x(&shape))
        });
        smallest(fibres.chain(turned))
    }

    fn energy(&self, u: &Vector8, [eps_T, _]: ThermalStrain) -> f64 {
        let u = self.shape_of(u);
        let axial = self.axial.iter().map(|point| {
            let epsilon = self.stretch(point, &u).strain - eps_T;
            0.5 * point.weight * self.EA * epsilon * epsilon
        });
        let bending = self.bending.iter().map(|point| {
            let kappa = self.bend(point, &u).kappa();
            0.5 * point.weight * self.EI * kappa * kappa
        });
        axial.sum::<f64>() + bending.sum::<f64>()
    }

    fn force(&self, u: &Vector8, [eps_T, _]: ThermalStrain) -> Vector8 {
        Vector8::from(coordinates(&self.nodal_force(nodal(u.as_slice()), eps_T)))
    }

    #[inline(always)]
    fn forces<L: Lanes>(&self, token: L::Token, u: &[L; 8], [eps_T, _]: [L; 2]) -> [L; 8] {
        self.four.forces(token, u, eps_T)
    }

    fn tangent(&self, u: &Vector8, [eps_T, _]: ThermalStrain) -> Matrix8 {
        let u = self.shape_of(u);
        let (mut axial, mut bending) = ([Block::ZERO; 5], [[[Block::ZERO; 5]; 2]; 2]);
        for point in &self.axial {
            let stretch = self.stretch(point, &u);
            add_moments(point.zeta, self.axial_stiffness(point, &stretch, stretch.strain - eps_T), &mut axial);
        }
        for point in &self.bending {
            let bend = self.bend(point, &u);
            add_stiffness(point, &self.bending_stiffness(point, &bend, bend.kappa()), &mut bending);
        }
        self.matrix(&axial, &bending)
    }

    fn mixed_tangent(&self, before: &Vector8, u: &Vector8, [eps_T, _]: ThermalStrain) -> Matrix8 {
        let (before, u) = (self.shape_of(before), self.shape_of(u));
        let (mut axial, mut bending) = ([Block::ZERO; 5], [[[Block::ZERO; 5]; 2]; 2]);
        for point in &self.axial {
            let (stretch_before, stretch) = (self.stretch(point, &before), self.stretch(point, &u));
            let change = stretch_before.rate().dot(stretch.r_x - stretch_before.r_x);
            let expected = stretch_before.strain + change - eps_T;
            add_moments(point.zeta, self.axial_stiffness(point, &stretch, expected), &mut axial);
        }
        for point in &self.bending {
            let (bend_before, bend) = (self.bend(point, &before), self.bend(point, &u));
            let [by_p, by_s] = bend_before.rate();
            let change = by_p.dot(bend.r_x - bend_before.r_x) + by_s.dot(bend.r_xx - bend_before.r_xx);
            let expected = bend_before.kappa() + change;
            add_stiffness(point, &self.bending_stiffness(point, &bend, expected), &mut bending);
        }
        self.matrix(&axial, &bending)
    }

    fn mean_force(&self, ends: &Ends<Vector8>) -> Vector8 {
        let u = [ends.u_0, ends.u_1].map(|u| nodal(u.as_slice()));
        Vector8::from(coordinates(&self.nodal_mean_force(u, along(ends))))
    }

    #[inline(always)]
    fn mean_forces<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, 8>) -> [L; 8] {
        self.four.mean_forces(token, ends)
    }

    #[inline(always)]
    fn energies<L: Lanes>(&self, token: L::Token, u: &[L; 8], [eps_T, _]: [L; 2]) -> L {
        self.four.energies(token, u, eps_T)
    }

    #[inline(always)]
    fn heating_works<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, 8>) -> L {
        self.four.heating_works(token, ends)
    }

    #[inline(always)]
    fn min_det_js<L: Lanes>(&self, token: L::Token, before: &[L; 8], u: &[L; 8]) -> L {
        self.four.min_det_js(token, [before, u])
    }

    #[inline(always)]
    fn momenta<L: Lanes>(token: L::Token, mass: &Matrix8, a: &[L; 8]) -> [L; 8] {
        momenta(token, mass, a)
    }

    fn mean_tangent(&self, ends: &Ends<Vector8>) -> Matrix8 {
        let Cable { EA, EI, .. } = *self;
        let u = self.shapes(ends);
        let (mut axial, mut bending) = ([Block::ZERO; 5], [[[Block::ZERO; 5]; 2]; 2]);
        for point in &self.axial {
            let step = self.stretches(point, &u, along(ends));
            let w = point.weight;
            let product = Block::outer(0.5, step.rate(), step.end.rate());
            let H = product * (w * EA) + step.rate_rate() * (w * step.mean_force(EA));
            add_moments(point.zeta, H, &mut axial);
        }
        for point in &self.bending {
            let step = self.bends(point, &u);
            let w = point.weight;
            let product = outers(step.rate(), step.end.rate());
            let H = combined(0.5 * w * EI, &product, w * step.mean_moment(EI), &step.rate_rate());
            add_stiffness(point, &H, &mut bending);
        }
        self.matrix(&axial, &bending)
    }

    fn heating_work(&self, ends: &Ends<Vector8>) -> f64 {
        let u = self.shapes(ends);
        let change = ends.thermal_1[0] - ends.thermal_0[0];
        let work =
            |point: &GaussPoint| -point.weight * self.stretches(point, &u, along(ends)).mean_force(self.EA) * change;
        self.axial.iter().map(work).sum()
    }
}

impl Cable {
    /// Polynomials p at both ends of a step.
    #[inline(always)]
    fn shapes(&self, ends: &Ends<Vector8>) -> [Quadratic<Vec2>; 2] {
        [ends.u_0, ends.u_1].map(|u| self.shape_of(u))
    }

    /// Stretches of the axis at a Gauss point, at both ends of a step.
    #[inline(always)]
    fn stretches(&self, point: &GaussPoint, [u_0, u_1]: &[Quadratic<Vec2>; 2], eps_T: [f64; 2]) -> StretchStep {
        StretchStep { start: self.stretch(point, u_0), end: self.stretch(point, u_1), eps_T }
    }

    /// Curvatures of the axis at a Gauss point, at both ends of a step.
    #[inline(always)]
    fn bends(&self, point: &GaussPoint, [u_0, u_1]: &[Quadratic<Vec2>; 2]) -> BendStep {
        BendStep { start: self.bend(point, u_0), end: self.bend(point, u_1) }
    }
}
