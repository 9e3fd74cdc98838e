//! The paper's element, consistent form. Three things differ from the paper's arrangement; none changes a result:
//!
//! * **Through the thickness by hand.** With y across the section, r(x, y) = r₀(x) + y d(x): a cubic axis r₀ and a
//!   quadratic director d. All strains are polynomials in y,
//!   ε₁₁ = a₀ + a₁y + a₂y², ε₂₂ = c, 2ε₁₂ = g₀ + g₁y, so ∫dy needs only A = wh, I = wh³/12 and wh⁵/80, and
//!   five Gauss points along the axis remain of the fifteen.
//! * **In the rod's own axes.** The consistent energy is the same in every frame, so J₀ is the identity.
//! * **In displacements.** With u = e − e₀, p = u₀', δ = u_d, κ = u_d' and the initial unit vectors t and n:
//!   a₀ = t·p + ½p·p, c = n·δ + ½δ·δ, g₀ = t·δ + n·p + p·δ, a₁ = r'·κ, g₁ = d·κ, a₂ = ½κ·κ. No 1 is
//!   subtracted from a number near 1, so small strains keep their digits.

#![allow(non_snake_case)] // The symbols of the derivation are names here: A, I, H, N, eps_T.

use nalgebra::Vector2;
use wide::f64x2;

use super::Meaning::{Position, SlopeX, SlopeY};
use super::plane::{
    Block, Linear, Pair, Quadratic, Scalar, Station, Vec2, Vector, add_at, add_moments, add_slope_at, at, coordinates,
    matrix, nodal, pairs, slope_at, spread, stations, vec2,
};
use super::{Beam, Ends, NodalVector, ThermalStrain};
use crate::equations::force::Matrix14;
use crate::equations::shape::{S, Vector14};
use crate::equations::volume::GAUSS_5;
use crate::scene::Poisson;

/// The plane law of the section: Lamé's constants, Pa, and where Poisson's terms act.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// Lamé's first constant.
    pub lambda: f64,
    /// Shear modulus.
    pub mu: f64,
    /// Across the section, as in the paper, or on the axis ([`equations::axis`](crate::equations::axis)).
    pub poisson: Poisson,
}

/// One straight element: everything about it that does not change in time.
#[derive(Clone, Debug)]
pub struct Ancf {
    t: Vec2,
    n: Vec2,
    /// 1/l
    per_length: f64,
    stations: [Station<f64>; 5],
    pairs: [Station<f64x2>; 3],
    law: SectionLaw,
}

/// The element's displacement as polynomials along it: p = u₀' and δ, whose slope is l/2 κ.
struct Shape<V> {
    p: Quadratic<V>,
    delta: Quadratic<V>,
}

impl Shape<Vec2> {
    /// The same for two stations at once.
    #[inline(always)]
    fn pair(&self) -> Shape<Pair> {
        Shape { p: spread(&self.p), delta: spread(&self.delta) }
    }
}

/// The current vectors of a section: tangent r', director d and its rate κ = d'.
#[derive(Clone, Copy)]
struct Section<V> {
    r_x: V,
    d: V,
    kappa: V,
}

/// Generalized strains of a section, or the forces that do work on them, or rates of either.
#[derive(Clone, Copy)]
struct Resultants<S> {
    /// ε₁₁ = a₀ + a₁y + a₂y².
    a: [S; 3],
    /// ε₂₂ = c.
    c: S,
    /// 2ε₁₂ = g₀ + g₁y.
    g: [S; 2],
}

impl<S: Scalar> Resultants<S> {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        Resultants {
            a: [0, 1, 2].map(|n| f(self.a[n], other.a[n])),
            c: f(self.c, other.c),
            g: [0, 1].map(|n| f(self.g[n], other.g[n])),
        }
    }

    #[inline(always)]
    fn map(self, f: impl Fn(S) -> S) -> Self {
        Resultants { a: self.a.map(&f), c: f(self.c), g: self.g.map(&f) }
    }

    #[inline(always)]
    fn mean(self, other: Self) -> Self {
        self.zip(other, |a, b| S::of(0.5) * (a + b))
    }

    #[inline(always)]
    fn dot(self, other: Self) -> S {
        let Resultants { a, c, g } = self.zip(other, |a, b| a * b);
        a[0] + a[1] + a[2] + c + g[0] + g[1]
    }
}

/// ∫ dy of the law: the section's forces from its strains.
#[derive(Clone, Copy, Debug)]
struct SectionLaw {
    /// (λ + 2μ)A.
    axial: f64,
    /// Bending's modulus times I and times ∫ y⁴ dA.
    bending: [f64; 2],
    /// μA and μI.
    shear: [f64; 2],
    /// λA, and λI where Poisson's terms act across the section. `None` without them: ν = 0.
    coupling: Option<[f64; 2]>,
}

impl SectionLaw {
    /// Where Poisson's terms act across the section, λ couples ε₂₂ = c with all of ε₁₁ = a₀ + a₁y + a₂y²; where they act on the
    /// axis, with a₀ alone, and bending feels E/(1 − ν²).
    fn new(Law { lambda, mu, poisson }: Law, h: f64, w: f64) -> SectionLaw {
        let (A, I, I_4) = (w * h, w * h.powi(3) / 12.0, w * h.powi(5) / 80.0);
        let stiff = lambda + 2.0 * mu;
        let bending = match poisson {
            Poisson::Full => stiff,
            Poisson::Axis => 4.0 * mu * (lambda + mu) / stiff,
        };
        SectionLaw {
            axial: stiff * A,
            bending: [bending * I, bending * I_4],
            shear: [mu * A, mu * I],
            coupling: (lambda != 0.0).then_some(SectionLaw::coupling(lambda, poisson, A, I)),
        }
    }

    fn coupling(lambda: f64, poisson: Poisson, A: f64, I: f64) -> [f64; 2] {
        [lambda * A, if poisson == Poisson::Full { lambda * I } else { 0.0 }]
    }

    /// The section's forces: C times its strains.
    #[inline(always)]
    fn forces<S: Scalar>(&self, strains: &Resultants<S>) -> Resultants<S> {
        let Resultants { a, c, g } = *strains;
        let (EA, [EI, EI_4]) = (S::of(self.axial), self.bending.map(S::of));
        let mut N = Resultants {
            a: [EA * a[0] + EI * a[2], EI * a[1], EI * a[0] + EI_4 * a[2]],
            c: EA * c,
            g: [S::of(self.shear[0]) * g[0], S::of(self.shear[1]) * g[1]],
        };
        if let Some([on_axis, across]) = self.coupling.map(|coupling| coupling.map(S::of)) {
            N.a[0] = N.a[0] + on_axis * c;
            N.a[2] = N.a[2] + across * c;
            N.c = N.c + on_axis * a[0] + across * a[2];
        }
        N
    }
}

/// Second derivative of a station's energy: blocks in p, δ and κ.
type Stiffness = [[Block; 3]; 3];

/// Moments Σ w ζⁿ H of the stations' stiffnesses, n = 0 … 4.
type Moments = [[[Block; 5]; 3]; 3];

impl<V: Vector> Section<V> {
    #[inline(always)]
    fn midpoint(&self, other: &Self) -> Self {
        let half = V::Number::of(0.5);
        Section {
            r_x: (self.r_x + other.r_x).times(half),
            d: (self.d + other.d).times(half),
            kappa: (self.kappa + other.kappa).times(half),
        }
    }
}

impl Section<Vec2> {
    /// Change of the strains at the rates of `before`, when p, δ and κ change from there to here.
    fn change_since(&self, before: &Self) -> Resultants<f64> {
        let Section { r_x, d, kappa } = *before;
        let (dp, ddelta, dkappa) = (self.r_x - r_x, self.d - d, self.kappa - kappa);
        Resultants {
            a: [r_x.dot(dp), kappa.dot(dp) + r_x.dot(dkappa), kappa.dot(dkappa)],
            c: d.dot(ddelta),
            g: [d.dot(dp) + r_x.dot(ddelta), kappa.dot(ddelta) + d.dot(dkappa)],
        }
    }

    /// `weight` · (Bᵀ C B₁ + the second derivative of the strains, contracted with the forces `N`), with
    /// B = ∂(strains)/∂(p, δ, κ) here and B₁ at another section (the same one, but for an energy–momentum step).
    ///
    /// a₀ changes by r'·p, a₁ by κ·p + r'·κ, a₂ by κ·κ, c by d·δ, g₀ by d·p + r'·δ, g₁ by κ·δ + d·κ.
    #[inline(always)]
    fn stiffness(&self, other: &Self, law: &SectionLaw, N: &Resultants<f64>, weight: f64) -> Stiffness {
        let (r, d, k) = (self.r_x, self.d, self.kappa);
        let (r_1, d_1, k_1) = (other.r_x, other.d, other.kappa);
        let SectionLaw { axial: EA, bending: [EI, EI_4], shear: [GA, GI], coupling } = *law;
        let [EA, EI, EI_4, GA, GI] = [EA, EI, EI_4, GA, GI].map(|stiffness| weight * stiffness);
        let Resultants { a, c, g } = N.map(|force| weight * force);
        let outer = Block::outer;
        let pk = outer(EI, k, r_1) + outer(EI, r, k_1);
        let mut H = [
            [outer(EA, r, r_1) + outer(EI, k, k_1) + outer(GA, d, d_1), outer(GA, d, r_1), pk],
            [outer(GA, r, d_1), outer(EA, d, d_1) + outer(GA, r, r_1) + outer(GI, k, k_1), outer(GI, k, d_1)],
            [pk, outer(GI, d, k_1), outer(EI, r, r_1) + outer(EI_4, k, k_1) + outer(GI, d, d_1)],
        ];
        if let Some([on_axis, across]) = coupling.map(|coupling| coupling.map(|stiffness| weight * stiffness)) {
            H[0][1] = H[0][1] + outer(on_axis, r, d_1);
            H[1][0] = H[1][0] + outer(on_axis, d, r_1);
            H[2][1] = H[2][1] + outer(across, k, d_1);
            H[1][2] = H[1][2] + outer(across, d, k_1);
        }
        let geometric = [[a[0], g[0], a[1]], [g[0], c, g[1]], [a[1], g[1], a[2]]];
        for (row, geometric) in H.iter_mut().zip(geometric) {
            for (block, geometric) in row.iter_mut().zip(geometric) {
                *block = *block + Block::identity(geometric);
            }
        }
        H
    }
}

impl Ancf {
    /// An element of length `l`, section `h` × `w` (m) and inclination `theta` (rad).
    pub fn new(l: f64, h: f64, w: f64, theta: f64, law: Law) -> Ancf {
        let stations = stations(&GAUSS_5, l);
        let (sin, cos) = theta.sin_cos();
        let law = SectionLaw::new(law, h, w);
        Ancf { t: vec2(cos, sin), n: vec2(-sin, cos), per_length: 1.0 / l, pairs: pairs(&stations), stations, law }
    }

    /// The same element with Poisson's terms computed, be they zero or not.
    pub fn with_poissons_terms(mut self, Law { lambda, poisson, .. }: Law, h: f64, w: f64) -> Ancf {
        self.law.coupling = Some(SectionLaw::coupling(lambda, poisson, w * h, w * h.powi(3) / 12.0));
        self
    }

    /// The polynomials of a displacement. A cubic axis through the end points and the middle, with its slope there, has
    /// r' = r'ʲ + 2(rⁱ + rᵏ − 2rʲ)/l ζ + 3((rᵏ − rⁱ)/l − r'ʲ) ζ².
    #[inline(always)]
    fn shape(&self, u: &Vector14) -> Shape<Vec2> {
        let [r_i, d_i, r_j, r_x_j, d_j, r_k, d_k] = nodal(u.as_slice());
        // Differences of neighbours first: they carry no rounding error of a displacement far from the start.
        let (first, second) = ((r_j - r_i) * self.per_length, (r_k - r_j) * self.per_length);
        let (d_first, d_second) = (d_j - d_i, d_k - d_j);
        Shape {
            p: [r_x_j, (second - first) * 2.0, (first + second - r_x_j) * 3.0],
            delta: [d_j, (d_first + d_second) * 0.5, (d_second - d_first) * 0.5],
        }
    }

    /// Forces on the nodal vectors from those on the polynomials' coefficients, p's and then δ's: the transpose of
    /// [`shape`](Ancf::shape).
    #[inline(always)]
    fn to_nodes<T: Linear>(&self, [p_0, p_1, p_2, d_0, d_1, d_2]: &[T; 6]) -> [T; 7] {
        let (p_1, p_2_end) = (*p_1 * (2.0 * self.per_length), *p_2 * (3.0 * self.per_length));
        let (d_1, d_2_end) = (*d_1 * 0.5, *d_2 * 0.5);
        [p_1 - p_2_end, d_2_end - d_1, p_1 * -2.0, *p_0 - *p_2 * 3.0, *d_0 - *d_2, p_1 + p_2_end, d_2_end + d_1]
    }

    /// Section vectors and elastic strains at a station, or at two.
    #[inline(always)]
    fn section<V: Vector>(
        &self,
        station: &Station<V::Number>,
        shape: &Shape<V>,
        eps_T: ThermalStrain,
    ) -> (Section<V>, Resultants<V::Number>) {
        let [half, along, across] = [0.5, eps_T[0], eps_T[1]].map(V::Number::of);
        let (t, n) = (V::of(self.t), V::of(self.n));
        let (p, delta) = (at(station.zeta, &shape.p), at(station.zeta, &shape.delta));
        let kappa = slope_at(station.zeta, &shape.delta).times(V::Number::of(2.0 * self.per_length));
        let (r_x, d) = (t + p, n + delta);
        let strains = Resultants {
            a: [t.dot(p) + half * p.dot(p) - along, r_x.dot(kappa), half * kappa.dot(kappa)],
            c: n.dot(delta) + half * delta.dot(delta) - across,
            g: [t.dot(delta) + n.dot(p) + p.dot(delta), d.dot(kappa)],
        };
        (Section { r_x, d, kappa }, strains)
    }

    /// Adds the force Bᵀ N of a station, or of two, to those on the coefficients of p and of δ.
    #[inline(always)]
    fn add_force<V: Vector>(
        &self,
        station: &Station<V::Number>,
        section: &Section<V>,
        N: &Resultants<V::Number>,
        [Q_p, Q_delta]: &mut [Quadratic<V>; 2],
    ) {
        let Section { r_x, d, kappa } = *section;
        let Resultants { a, c, g } = N.map(|force| station.weight * force);
        let per_half_length = V::Number::of(2.0 * self.per_length);
        let f_p = r_x.times(a[0]) + d.times(g[0]) + kappa.times(a[1]);
        let f_delta = d.times(c) + r_x.times(g[0]) + kappa.times(g[1]);
        let f_kappa = r_x.times(a[1]) + d.times(g[1]) + kappa.times(a[2]);
        add_at(station.zeta, f_p, Q_p);
        add_at(station.zeta, f_delta, Q_delta);
        add_slope_at(station.zeta, f_kappa.times(per_half_length), Q_delta);
    }

    /// Nodal forces from those on the coefficients of two stations at once.
    #[inline(always)]
    fn nodal_force(&self, [[p_0, p_1, p_2], [d_0, d_1, d_2]]: [Quadratic<Pair>; 2]) -> Vector14 {
        Vector14::from(coordinates(&self.to_nodes(&[p_0, p_1, p_2, d_0, d_1, d_2].map(Pair::sum))))
    }

    /// Adds a station's stiffness to the moments.
    fn add_stiffness(station: &Station<f64>, H: &Stiffness, moments: &mut Moments) {
        for (row, H) in moments.iter_mut().zip(H) {
            for (moments, H) in row.iter_mut().zip(H) {
                add_moments(station.zeta, *H, moments);
            }
        }
    }

    /// The element's matrix Σ Bᵀ H B. The coefficient m of δ moves δ by ζᵐ and κ by 2m ζᵐ⁻¹/l.
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

    /// √(1 + 2ε) − 1 (M2).
    fn stress_free(eps_T: ThermalStrain) -> [f64; 2] {
        eps_T.map(|strain| (1.0 + 2.0 * strain).sqrt() - 1.0)
    }

    fn axis(fraction: f64, u: &Vector14, l: f64) -> Vector2<f64> {
        S(fraction * l, 0.0, l) * u
    }

    fn energy(&self, u: &Vector14, eps_T: ThermalStrain) -> f64 {
        let shape = self.shape(u);
        let of = |station: &Station<f64>| {
            let (_, strains) = self.section(station, &shape, eps_T);
            0.5 * station.weight * strains.dot(self.law.forces(&strains))
        };
        self.stations.iter().map(of).sum()
    }

    fn force(&self, u: &Vector14, eps_T: ThermalStrain) -> Vector14 {
        let shape = self.shape(u).pair();
        let mut Q = [[Pair::ZERO; 3]; 2];
        for pair in &self.pairs {
            let (section, strains) = self.section(pair, &shape, eps_T);
            self.add_force(pair, &section, &self.law.forces(&strains), &mut Q);
        }
        self.nodal_force(Q)
    }

    fn tangent(&self, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let shape = self.shape(u);
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        for station in &self.stations {
            let (section, strains) = self.section(station, &shape, eps_T);
            let H = section.stiffness(&section, &self.law, &self.law.forces(&strains), station.weight);
            Ancf::add_stiffness(station, &H, &mut moments);
        }
        self.matrix(&moments)
    }

    fn mixed_tangent(&self, before: &Vector14, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let (shape_before, shape) = (self.shape(before), self.shape(u));
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        for station in &self.stations {
            let (section_before, strains) = self.section(station, &shape_before, eps_T);
            let (section, _) = self.section(station, &shape, eps_T);
            let expected = strains.zip(section.change_since(&section_before), |a, b| a + b);
            let H = section.stiffness(&section, &self.law, &self.law.forces(&expected), station.weight);
            Ancf::add_stiffness(station, &H, &mut moments);
        }
        self.matrix(&moments)
    }

    fn mean_force(&self, ends: &Ends<Vector14>) -> Vector14 {
        let (shape_0, shape_1) = (self.shape(ends.u_0).pair(), self.shape(ends.u_1).pair());
        let mut Q = [[Pair::ZERO; 3]; 2];
        for pair in &self.pairs {
            let (section_0, strains_0) = self.section(pair, &shape_0, ends.thermal_0);
            let (section_1, strains_1) = self.section(pair, &shape_1, ends.thermal_1);
            let N = self.law.forces(&strains_0.mean(strains_1));
            self.add_force(pair, &section_0.midpoint(&section_1), &N, &mut Q);
        }
        self.nodal_force(Q)
    }

    fn mean_tangent(&self, ends: &Ends<Vector14>) -> Matrix14 {
        let (shape_0, shape_1) = (self.shape(ends.u_0), self.shape(ends.u_1));
        let mut moments = [[[Block::ZERO; 5]; 3]; 3];
        for station in &self.stations {
            let (section_0, strains_0) = self.section(station, &shape_0, ends.thermal_0);
            let (section_1, strains_1) = self.section(station, &shape_1, ends.thermal_1);
            let N = self.law.forces(&strains_0.mean(strains_1));
            let H = section_0.midpoint(&section_1).stiffness(&section_1, &self.law, &N, 0.5 * station.weight);
            Ancf::add_stiffness(station, &H, &mut moments);
        }
        self.matrix(&moments)
    }

    fn heating_work(&self, ends: &Ends<Vector14>) -> f64 {
        let (shape_0, shape_1) = (self.shape(ends.u_0), self.shape(ends.u_1));
        let change = [ends.thermal_1[0] - ends.thermal_0[0], ends.thermal_1[1] - ends.thermal_0[1]];
        let of = |station: &Station<f64>| {
            let (_, strains_0) = self.section(station, &shape_0, ends.thermal_0);
            let (_, strains_1) = self.section(station, &shape_1, ends.thermal_1);
            let N = self.law.forces(&strains_0.mean(strains_1));
            -station.weight * (N.a[0] * change[0] + N.c * change[1])
        };
        self.stations.iter().map(of).sum()
    }
}
