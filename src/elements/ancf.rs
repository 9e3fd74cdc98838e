//! The paper's element, consistent form, by four changes of arrangement. None changes a result
//! (`oracle/DERIVATION.md#8-for-speed-the-section-by-hand`):
//!
//! * **Integration through the thickness by hand.** With y across the section, r(x, y) = r₀(x) + y d(x): a cubic axis r₀ and a
//!   quadratic director d. All strains are polynomials in y: ε₁₁ = a₀ + a₁y + a₂y², ε₂₂ = c, 2ε₁₂ = g₀ + g₁y. So ∫dy needs only
//!   A = wh, I = wh³/12 and wh⁵/80, and of the fifteen Gauss points the five along the axis remain.
//! * **The rod's own axes.** The consistent energy is equal in every frame, so J₀ is the identity.
//! * **Displacements.** With u = e − e₀, p = u₀', δ = u_d, κ = u_d' and the initial unit vectors t and n:
//!   a₀ = t·p + ½p·p, c = n·δ + ½δ·δ, g₀ = t·δ + n·p + p·δ, a₁ = r'·κ, g₁ = d·κ, a₂ = ½κ·κ. No 1 is
//!   subtracted from a number near 1, so small strains keep their digits.
//! * **Coefficients.** p and δ are quadratic in ζ = 2x/l − 1. Sections act on the coefficients by the moments Σ w ζⁿ (…) over the
//!   Gauss points; a small linear map takes these to the nodes.

#![allow(non_snake_case)] // The symbols of the derivation are names here: A, I, H, N, eps_T.

mod section;
mod side_by_side;

use nalgebra::Vector2;

pub use section::Law;
use section::{Resultants, Section, SectionLaw, Stiffness, geometric};
use side_by_side::{SideBySide, Station, momenta};

use super::beam::{Beam, Ends, FourEnds, ThermalStrain};
use super::collapse::{OUTERMOST, cross, smallest};
use super::deviation::Deviation;
use super::layout::{coordinates, matrix, nodal};
use super::nodal_vector::Meaning::{Position, SlopeX, SlopeY};
use super::nodal_vector::NodalVector;
use super::plane::{Block, Linear, Vec2, Vector, vec2};
use super::polynomial::{GaussPoint, Quadratic, add_at, add_moments, add_slope_at, at, gauss_points, slope_at};
use super::section_state::SectionState;
use crate::equations::element::Matrix14;
use crate::equations::shape::{S, Vector14};
use crate::equations::volume::GAUSS_5;
use crate::lanes::Lanes;

/// The paper's element, straight and in its consistent form, arranged for speed.
///
/// It holds everything that is constant in time, and is shared by all equal elements of a rod.
#[derive(Clone, Debug)]
pub struct Ancf {
    /// Unit vector along the element.
    t: Vec2,
    /// Unit vector across it.
    n: Vec2,
    /// 1/l
    per_length: f64,
    points: [GaussPoint; 5],
    law: SectionLaw,
    /// h/2
    half_height: f64,
    /// The same for four elements side by side.
    four: SideBySide,
}

/// Displacement of an element as polynomials in ζ: p = u₀', and δ with the derivative l/2 κ.
struct Shape {
    p: Quadratic<Vec2>,
    delta: Quadratic<Vec2>,
}

/// Moments Σ w ζⁿ H of the section stiffnesses at the Gauss points, n = 0 … 4.
type Moments = [[[Block; 5]; 3]; 3];

impl Ancf {
    /// Element of length `l`, section `h` × `w` (m) and inclination `theta` (rad).
    pub fn new(l: f64, h: f64, w: f64, theta: f64, law: Law) -> Ancf {
        let points = gauss_points(&GAUSS_5, l);
        let (sin, cos) = theta.sin_cos();
        let (t, n, law) = (vec2(cos, sin), vec2(-sin, cos), SectionLaw::new(law, h, w));
        let stations = points.map(|point| Station::new(&point, &law));
        let (per_length, half_height) = (1.0 / l, 0.5 * h);
        let four = SideBySide { t: [cos, sin], n: [-sin, cos], per_length, half_height, stations };
        Ancf { t, n, per_length, points, law, half_height, four }
    }

    /// Makes the element compute the Poisson's terms of its law even where they are zero.
    pub fn with_poissons_terms(mut self, law: Law, h: f64, w: f64) -> Ancf {
        self.law.coupling = SectionLaw::coupling(law, h, w);
        self.four.stations = self.points.map(|point| Station::new(&point, &self.law));
        self
    }

    /// Polynomials of a displacement from its nodal vectors.
    ///
    /// A cubic axis through the ends and the middle, with its slope in the middle, has
    /// r' = r'ʲ + 2(rⁱ + rᵏ − 2rʲ)/l ζ + 3((rᵏ − rⁱ)/l − r'ʲ) ζ².
    #[inline(always)]
    fn shape(&self, [r_i, d_i, r_j, r_x_j, d_j, r_k, d_k]: [Vec2; 7]) -> Shape {
        // Differences of neighbours come first: they lose no digits to a large rigid displacement.
        let (first, second) = ((r_j - r_i) * self.per_length, (r_k - r_j) * self.per_length);
        let (d_first, d_second) = (d_j - d_i, d_k - d_j);
        Shape {
            p: [r_x_j, (second - first) * 2.0, (first + second - r_x_j) * 3.0],
            delta: [d_j, (d_first + d_second) * 0.5, (d_second - d_first) * 0.5],
        }
    }

    /// Polynomials of a displacement from its coordinates.
    #[inline(always)]
    fn shape_of(&self, u: &Vector14) -> Shape {
        self.shape(nodal(u.as_slice()))
    }

    /// Forces on the nodal vectors from the forces on the coefficients of p and then of δ: the transpose of
    /// [`shape`](Ancf::shape).
    #[inline(always)]
    fn to_nodes<T: Linear>(&self, [p_0, p_1, p_2, d_0, d_1, d_2]: &[T; 6]) -> [T; 7] {
        let (p_1, p_2_end) = (*p_1 * (2.0 * self.per_length), *p_2 * (3.0 * self.per_length));
        let (d_1, d_2_end) = (*d_1 * 0.5, *d_2 * 0.5);
        [p_1 - p_2_end, d_2_end - d_1, p_1 * -2.0, *p_0 - *p_2 * 3.0, *d_0 - *d_2, p_1 + p_2_end, d_2_end + d_1]
    }

    /// Section vectors and elastic strains at a Gauss point.
    #[inline(always)]
    fn section(&self, point: &GaussPoint, shape: &Shape, eps_T: ThermalStrain) -> (Section, Resultants) {
        let (t, n, [along, across]) = (self.t, self.n, eps_T);
        let (p, delta) = (at(point.zeta, &shape.p), at(point.zeta, &shape.delta));
        let kappa = slope_at(point.zeta, &shape.delta) * (2.0 * self.per_length);
        let (r_x, d) = (t + p, n + delta);
        let strains = Resultants {
            a: [t.dot(p) + 0.5 * p.dot(p) - along, r_x.dot(kappa), 0.5 * kappa.dot(kappa)],
            c: n.dot(delta) + 0.5 * delta.dot(delta) - across,
            g: [t.dot(delta) + n.dot(p) + p.dot(delta), d.dot(kappa)],
        };
        (Section { r_x, d, kappa }, strains)
    }

    /// Adds the force Bᵀ N of a Gauss point to the forces on the coefficients of p and of δ.
    #[inline(always)]
    fn add_force(
        &self,
        point: &GaussPoint,
        section: &Section,
        N: &Resultants,
        [Q_p, Q_delta]: &mut [Quadratic<Vec2>; 2],
    ) {
        let Section { r_x, d, kappa } = *section;
        let Resultants { a, c, g } = N.map(|force| point.weight * force);
        let f_p = r_x * a[0] + d * g[0] + kappa * a[1];
        let f_delta = d * c + r_x * g[0] + kappa * g[1];
        let f_kappa = r_x * a[1] + d * g[1] + kappa * a[2];
        add_at(point.zeta, f_p, Q_p);
        add_at(point.zeta, f_delta, Q_delta);
        add_slope_at(point.zeta, f_kappa * (2.0 * self.per_length), Q_delta);
    }

    /// Elastic forces on the nodal vectors.
    #[inline(always)]
    fn nodal_force(&self, u: [Vec2; 7], eps_T: ThermalStrain) -> [Vec2; 7] {
        let shape = self.shape(u);
        let mut Q = [[Vec2::ZERO; 3]; 2];
        for point in &self.points {
            let (section, strains) = self.section(point, &shape, eps_T);
            self.add_force(point, &section, &self.law.forces(&strains), &mut Q);
        }
        let [[p_0, p_1, p_2], [d_0, d_1, d_2]] = Q;
        self.to_nodes(&[p_0, p_1, p_2, d_0, d_1, d_2])
    }

    /// Forces of an energy–momentum step on the nodal vectors.
    #[inline(always)]
    fn nodal_mean_force(&self, [u_0, u_1]: [[Vec2; 7]; 2], [eps_T0, eps_T1]: [ThermalStrain; 2]) -> [Vec2; 7] {
        let (shape_0, shape_1) = (self.shape(u_0), self.shape(u_1));
        let mut Q = [[Vec2::ZERO; 3]; 2];
        for point in &self.points {
            let (section_0, strains_0) = self.section(point, &shape_0, eps_T0);
            let (section_1, strains_1) = self.section(point, &shape_1, eps_T1);
            let N = self.law.forces(&strains_0.mean(strains_1));
            self.add_force(point, &section_0.midpoint(&section_1), &N, &mut Q);
        }
        let [[p_0, p_1, p_2], [d_0, d_1, d_2]] = Q;
        self.to_nodes(&[p_0, p_1, p_2, d_0, d_1, d_2])
    }

    /// Adds the stiffness of a Gauss point to the moments.
    fn add_stiffness(point: &GaussPoint, H: &Stiffness, moments: &mut Moments) {
        for (row, H) in moments.iter_mut().zip(H) {
            for (moments, H) in row.iter_mut().zip(H) {
                add_moments(point.zeta, *H, moments);
            }
        }
    }

    /// Initial coordinates e₀, node i at the origin.
    fn at_rest(&self) -> Vector14 {
        let of = |(meaning, at): &NodalVector| match meaning {
            Position => self.t * (at / self.per_length),
            SlopeX => self.t,
            SlopeY => self.n,
        };
        Vector14::from_iterator(Self::VECTORS.iter().flat_map(|vector| of(vector).to_array()))
    }

    /// Matrix of the element, Σ Bᵀ H B. The coefficient m of δ changes δ by ζᵐ and κ by 2m ζᵐ⁻¹/l.
    fn matrix(&self, moments: &Moments) -> Matrix14 {
        let [[pp, pd, pk], [dp, dd, dk], [kp, kd, kk]] = moments;
        let slope = |m: usize| 2.0 * self.per_length * m as f64;
        let mut of_coefficients = [[Block::ZERO; 6]; 6];
        for n in 0..3 {
            for m in 0..3 {
                let power: usize = n + m;
                let below = power.saturating_sub(1);
                of_coefficients[n][m] = pp[power];
                of_coefficients[n][3 + m] = pd[power] + pk[below] * slope(m);
                of_coefficients[3 + n][m] = dp[power] + kp[below] * slope(n);
                of_coefficients[3 + n][3 + m] = dd[power]
                    + dk[below] * slope(m)
                    + kd[below] * slope(n)
                    + kk[below.saturating_sub(1)] * (slope(n) * slope(m));
            }
        }
        Matrix14::from(matrix(&of_coefficients, |forces| self.to_nodes(forces)))
    }
}

impl Beam<14> for Ancf {
    const VECTORS: &'static [NodalVector] = &[
        (Position, 0.0),
        (SlopeY, 0.0),
        (Position, 0.5),
        (SlopeX, 0.5),
        (SlopeY, 0.5),
        (Position, 1.0),
        (SlopeY, 1.0),
    ];

    /// √(1 + 2ε_T) − 1 (M2).
    fn stress_free(eps_T: ThermalStrain) -> [f64; 2] {
        eps_T.map(|strain| (1.0 + 2.0 * strain).sqrt() - 1.0)
    }

    fn axis(fraction: f64, u: &Vector14, l: f64) -> Vector2<f64> {
        S(fraction * l, 0.0, l) * u
    }

    /// The strain is a₀, that of (13) along the rod. The director d turns by (d × d')/|d|² per length.
    fn section_state(&self, fraction: f64, u: &Vector14) -> SectionState {
        let (zeta, shape): (f64, Shape) = (2.0 * fraction - 1.0, self.shape_of(u));
        let (p, d) = (at(zeta, &shape.p), self.n + at(zeta, &shape.delta));
        let kappa = slope_at(zeta, &shape.delta) * (2.0 * self.per_length);
        SectionState {
            director: d.to_array().into(),
            strain: self.t.dot(p) + 0.5 * p.dot(p),
            curvature: cross(d, kappa) / d.dot(d),
        }
    }

    /// With J = [r₀' + yκ, d], det J is r₀' × d + y κ × d. It is linear in y, so it is smallest at an outermost Gauss point.
    fn min_det_j(&self, _before: &Vector14, u: &Vector14) -> f64 {
        let shape: Shape = self.shape_of(u);
        let delta: &Quadratic<Vec2> = &shape.delta;
        smallest(self.points.iter().map(|point| {
            let (r_x, d) = (self.t + at(point.zeta, &shape.p), self.n + at(point.zeta, delta));
            let kappa = slope_at(point.zeta, delta) * (2.0 * self.per_length);
            cross(r_x, d) - OUTERMOST * self.half_height * cross(kappa, d).abs()
        }))
    }

    fn energy(&self, u: &Vector14, eps_T: ThermalStrain) -> f64 {
        let shape = self.shape_of(u);
        let of = |point: &GaussPoint| {
            let (_, strains) = self.section(point, &shape, eps_T);
            0.5 * point.weight * strains.dot(self.law.forces(&strains))
        };
        self.points.iter().map(of).sum()
    }

    fn force(&self, u: &Vector14, eps_T: ThermalStrain) -> Vector14 {
        Vector14::from(coordinates(&self.nodal_force(nodal(u.as_slice()), eps_T)))
    }

    #[inline(always)]
    fn forces<L: Lanes>(&self, token: L::Token, u: &[L; 14], eps_T: [L; 2]) -> [L; 14] {
        match self.law.coupling {
            None => self.four.forces::<L, false>(token, u, eps_T),
            Some(_) => self.four.forces::<L, true>(token, u, eps_T),
        }
    }

    fn tangent(&self, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let shape = self.shape_of(u);
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        for point in &self.points {
            let (section, strains) = self.section(point, &shape, eps_T);
            let H = section.stiffness(&section, &self.law, &self.law.forces(&strains), point.weight);
            Ancf::add_stiffness(point, &H, &mut moments);
        }
        self.matrix(&moments)
    }

    fn mixed_tangent(&self, before: &Vector14, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let (shape_before, shape) = (self.shape_of(before), self.shape_of(u));
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        for point in &self.points {
            let (section_before, strains) = self.section(point, &shape_before, eps_T);
            let (section, _) = self.section(point, &shape, eps_T);
            let expected = strains.zip(section.change_since(&section_before), |a, b| a + b);
            let H = section.stiffness(&section, &self.law, &self.law.forces(&expected), point.weight);
            Ancf::add_stiffness(point, &H, &mut moments);
        }
        self.matrix(&moments)
    }

    fn mean_force(&self, ends: &Ends<Vector14>) -> Vector14 {
        let u = [ends.u_0, ends.u_1].map(|u| nodal(u.as_slice()));
        Vector14::from(coordinates(&self.nodal_mean_force(u, [ends.thermal_0, ends.thermal_1])))
    }

    #[inline(always)]
    fn mean_forces<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, 14>) -> [L; 14] {
        match self.law.coupling {
            None => self.four.mean_forces::<L, false>(token, ends),
            Some(_) => self.four.mean_forces::<L, true>(token, ends),
        }
    }

    #[inline(always)]
    fn energies<L: Lanes>(&self, token: L::Token, u: &[L; 14], eps_T: [L; 2]) -> L {
        self.four.energies(token, u, eps_T)
    }

    #[inline(always)]
    fn heating_works<L: Lanes>(&self, token: L::Token, ends: &FourEnds<L, 14>) -> L {
        self.four.heating_works(token, ends)
    }

    #[inline(always)]
    fn min_det_js<L: Lanes>(&self, token: L::Token, _before: &[L; 14], u: &[L; 14]) -> L {
        self.four.min_det_js(token, u)
    }

    #[inline(always)]
    fn momenta<L: Lanes>(token: L::Token, mass: &Matrix14, a: &[L; 14]) -> [L; 14] {
        momenta(token, mass, a)
    }

    fn mean_tangent(&self, ends: &Ends<Vector14>) -> Matrix14 {
        let (shape_0, shape_1) = (self.shape_of(ends.u_0), self.shape_of(ends.u_1));
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        for point in &self.points {
            let (section_0, strains_0) = self.section(point, &shape_0, ends.thermal_0);
            let (section_1, strains_1) = self.section(point, &shape_1, ends.thermal_1);
            let N = self.law.forces(&strains_0.mean(strains_1));
            let H = section_0.midpoint(&section_1).stiffness(&section_1, &self.law, &N, 0.5 * point.weight);
            Ancf::add_stiffness(point, &H, &mut moments);
        }
        self.matrix(&moments)
    }

    /// The strains' second derivatives are constant, so A is the geometric stiffness of the stress D E_dev.
    fn deviation(&self, u: &Vector14) -> Option<Deviation<14>> {
        let shape = self.shape_of(u);
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        let (mut stress, mut energy) = ([0.0; 2], 0.0);
        for point in &self.points {
            let (_, strains) = self.section(point, &shape, [0.0; 2]);
            let N = self.law.forces(&strains).map(|force| point.weight * force);
            Ancf::add_stiffness(point, &geometric(&N).map(|row| row.map(Block::identity)), &mut moments);
            stress = [stress[0] + N.a[0], stress[1] + N.c];
            energy += 0.5 * strains.dot(N);
        }
        Some(Deviation::new(self.matrix(&moments), &self.at_rest(), stress, energy))
    }

    fn heating_work(&self, ends: &Ends<Vector14>) -> f64 {
        let (shape_0, shape_1) = (self.shape_of(ends.u_0), self.shape_of(ends.u_1));
        let change = [ends.thermal_1[0] - ends.thermal_0[0], ends.thermal_1[1] - ends.thermal_0[1]];
        let of = |point: &GaussPoint| {
            let (_, strains_0) = self.section(point, &shape_0, ends.thermal_0);
            let (_, strains_1) = self.section(point, &shape_1, ends.thermal_1);
            let N = self.law.forces(&strains_0.mean(strains_1));
            -point.weight * (N.a[0] * change[0] + N.c * change[1])
        };
        self.points.iter().map(of).sum()
    }
}
