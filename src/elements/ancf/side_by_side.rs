//! Four of the paper's elements side by side: what the others of [`Ancf`]'s files compute for one, with the same symbols.
//!
//! ```text
//!  coordinates of four elements        polynomials in ζ               nodal vectors again
//!
//!  [r_i d_i r_j r_x d_j r_k d_k]  →  p = p₀ + p₁ζ + p₂ζ²   ┐         Q_p, Q_δ, Q_κ: forces on the coefficients,
//!   each entry: four numbers,        δ = δ₀ + δ₁ζ + δ₂ζ²   │ at 5    which the transpose of the first map
//!   one of each element              κ = κ₀ + κ₁ζ          ┘ ζ  →   takes to the seven nodal vectors
//! ```
//!
//! At each ζ, with r' = t + p and d = n + δ and the weight in the moduli:
//!
//! * strains a₀ = p·(t + p/2), c = δ·(n + δ/2), a₁ = r'·κ, 2a₂ = κ·κ, g₀ = r'·δ + n·p, g₁ = d·κ, less heat in a₀ and c;
//! * forces N = C (a₀, a₁, a₂, c, g₀, g₁), the law of [`SectionLaw`](super::section::SectionLaw) with ½ of each modulus for 2a₂;
//! * on p: r'N₀ + dG₀ + κN₁, on δ: dC + r'G₀ + κG₁, on κ: r'N₁ + dG₁ + κN₂; times 1, ζ, ζ² to the coefficients.
//!
//! Since κ = 2/l δ', κ₀ = 2/l δ₁ and κ₁ = 4/l δ₂; so a force on κ₀ is 2/l of one on δ₁, and one on κ₁ is 4/l of one on δ₂.

use super::section::SectionLaw;
use crate::elements::beam::FourEnds;
use crate::elements::collapse::OUTERMOST;
use crate::elements::pair::{Pair, at};
use crate::elements::polynomial::GaussPoint;
use crate::equations::element::Matrix14;
use crate::lanes::Lanes;

/// Gauss point with the moduli of the section, times its weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station {
    zeta: f64,
    axial: f64,
    /// Modulus of bending times I, and half of it.
    bending: [f64; 2],
    /// Half the modulus of bending times ∫ y⁴ dA.
    half_bending_4: f64,
    shear: [f64; 2],
    /// Coupling of c with a₀ and with a₂, and half of the latter; 0 where there is none.
    coupling: [f64; 3],
}

impl Station {
    pub fn new(point: &GaussPoint, law: &SectionLaw) -> Station {
        let GaussPoint { weight, zeta } = *point;
        let [on_axis, across] = law.coupling.unwrap_or_default();
        Station {
            zeta,
            axial: weight * law.axial,
            bending: [weight * law.bending[0], 0.5 * weight * law.bending[0]],
            half_bending_4: 0.5 * weight * law.bending[1],
            shear: law.shear.map(|shear| weight * shear),
            coupling: [weight * on_axis, weight * across, 0.5 * weight * across],
        }
    }
}

/// Displacements as polynomials.
struct Shape<L> {
    p: [Pair<L>; 3],
    delta: [Pair<L>; 3],
    kappa: [Pair<L>; 2],
}

/// Vectors of a section.
struct Section<L> {
    r_x: Pair<L>,
    d: Pair<L>,
    kappa: Pair<L>,
}

/// Strains of a section, or forces.
#[derive(Clone, Copy)]
struct Resultants<L> {
    a_0: L,
    a_1: L,
    /// 2a₂ of strains, N₂ of forces.
    a_2: L,
    c: L,
    g_0: L,
    g_1: L,
}

/// Forces on the coefficients.
struct Sums<L> {
    p: [Pair<L>; 3],
    delta: [Pair<L>; 3],
    kappa: [Pair<L>; 2],
}

impl<L: Lanes> Section<L> {
    #[inline(always)]
    fn middle(&self, other: &Section<L>, half: L) -> Section<L> {
        Section {
            r_x: (self.r_x + other.r_x).times(half),
            d: (self.d + other.d).times(half),
            kappa: (self.kappa + other.kappa).times(half),
        }
    }
}

impl<L: Lanes> Resultants<L> {
    #[inline(always)]
    fn mean(&self, other: &Resultants<L>, half: L) -> Resultants<L> {
        Resultants {
            a_0: (self.a_0 + other.a_0) * half,
            a_1: (self.a_1 + other.a_1) * half,
            a_2: (self.a_2 + other.a_2) * half,
            c: (self.c + other.c) * half,
            g_0: (self.g_0 + other.g_0) * half,
            g_1: (self.g_1 + other.g_1) * half,
        }
    }
}

impl<L: Lanes> Sums<L> {
    #[inline(always)]
    fn zero(token: L::Token) -> Sums<L> {
        let zero = Pair::zero(token);
        Sums { p: [zero; 3], delta: [zero; 3], kappa: [zero; 2] }
    }

    #[inline(always)]
    fn add(&mut self, zeta: L, section: &Section<L>, forces: &Resultants<L>) {
        let (Section { r_x, d, kappa }, zeta_2) = (section, zeta * zeta);
        let Resultants { a_0, a_1, a_2, c, g_0, g_1 } = *forces;
        let on_p = r_x.times_add(a_0, d.times_add(g_0, kappa.times(a_1)));
        let on_delta = d.times_add(c, r_x.times_add(g_0, kappa.times(g_1)));
        let on_kappa = r_x.times_add(a_1, d.times_add(g_1, kappa.times(a_2)));
        self.p = [self.p[0] + on_p, on_p.times_add(zeta, self.p[1]), on_p.times_add(zeta_2, self.p[2])];
        self.delta = [
            self.delta[0] + on_delta,
            on_delta.times_add(zeta, self.delta[1]),
            on_delta.times_add(zeta_2, self.delta[2]),
        ];
        self.kappa = [self.kappa[0] + on_kappa, on_kappa.times_add(zeta, self.kappa[1])];
    }
}

/// Element as it is computed side by side.
#[derive(Clone, Debug)]
pub(super) struct SideBySide {
    /// Unit vectors along the element and across it.
    pub t: [f64; 2],
    pub n: [f64; 2],
    /// 1/l
    pub per_length: f64,
    /// h/2
    pub half_height: f64,
    pub stations: [Station; 5],
}

impl SideBySide {
    #[inline(always)]
    fn shape<L: Lanes>(&self, token: L::Token, u: &[L; 14]) -> Shape<L> {
        let (l, half) = (L::splat(token, self.per_length), L::splat(token, 0.5));
        let (two_l, two, three) = (L::splat(token, 2.0 * self.per_length), L::splat(token, 2.0), L::splat(token, 3.0));
        let vector = [
            Pair { x: u[0], y: u[1] },
            Pair { x: u[2], y: u[3] },
            Pair { x: u[4], y: u[5] },
            Pair { x: u[6], y: u[7] },
            Pair { x: u[8], y: u[9] },
            Pair { x: u[10], y: u[11] },
            Pair { x: u[12], y: u[13] },
        ];
        let [r_i, d_i, r_j, r_x_j, d_j, r_k, d_k] = vector;
        let (first, second) = ((r_j - r_i).times(l), (r_k - r_j).times(l));
        let (d_first, d_second) = (d_j - d_i, d_k - d_j);
        let (sum, change) = (d_first + d_second, d_second - d_first);
        Shape {
            p: [r_x_j, (second - first).times(two), (first + second - r_x_j).times(three)],
            delta: [d_j, sum.times(half), change.times(half)],
            kappa: [sum.times(l), change.times(two_l)],
        }
    }

    #[inline(always)]
    fn to_nodes<L: Lanes>(&self, token: L::Token, sums: &Sums<L>) -> [L; 14] {
        let (two_l, half) = (L::splat(token, 2.0 * self.per_length), L::splat(token, 0.5));
        let (three, three_l) = (L::splat(token, 3.0), L::splat(token, 3.0 * self.per_length));
        let four_l = L::splat(token, 4.0 * self.per_length);
        let Sums { p, delta, kappa } = sums;
        let delta_2 = kappa[1].times_add(four_l, delta[2]);
        let (d_1, d_2) = (kappa[0].times_add(two_l, delta[1]).times(half), delta_2.times(half));
        let (p_1, p_2) = (p[1].times(two_l), p[2].times(three_l));
        let (r_i, d_i) = (p_1 - p_2, d_2 - d_1);
        let (r_x_j, d_j) = (p[0] - p[2].times(three), delta[0] - delta_2);
        let (r_k, d_k) = (p_1 + p_2, d_2 + d_1);
        let r_j = Pair { x: -(p_1.x + p_1.x), y: -(p_1.y + p_1.y) };
        [r_i.x, r_i.y, d_i.x, d_i.y, r_j.x, r_j.y, r_x_j.x, r_x_j.y, d_j.x, d_j.y, r_k.x, r_k.y, d_k.x, d_k.y]
    }

    #[inline(always)]
    fn sections<L: Lanes>(&self, token: L::Token, zeta: L, shape: &Shape<L>) -> (Section<L>, [Pair<L>; 2]) {
        let (p, delta) = (at(zeta, &shape.p), at(zeta, &shape.delta));
        let (t, n) = (Pair::splat(token, self.t), Pair::splat(token, self.n));
        let kappa = shape.kappa[1].times_add(zeta, shape.kappa[0]);
        (Section { r_x: t + p, d: n + delta, kappa }, [p, delta])
    }

    /// Sections at a Gauss point, and their strains.
    #[inline(always)]
    fn strains<L: Lanes>(
        &self,
        token: L::Token,
        zeta: L,
        shape: &Shape<L>,
        eps_T: [L; 2],
    ) -> (Section<L>, Resultants<L>) {
        let (section, [p, delta]) = self.sections(token, zeta, shape);
        let (t, n) = (Pair::splat(token, self.t), Pair::splat(token, self.n));
        let half = L::splat(token, 0.5);
        let strains = Resultants {
            a_0: p.dot_add(p.times_add(half, t), -eps_T[0]),
            a_1: section.r_x.dot(section.kappa),
            a_2: section.kappa.dot(section.kappa),
            c: delta.dot_add(delta.times_add(half, n), -eps_T[1]),
            g_0: section.r_x.dot_add(delta, n.dot(p)),
            g_1: section.d.dot(section.kappa),
        };
        (section, strains)
    }

    #[inline(always)]
    fn section_forces<L: Lanes, const COUPLED: bool>(
        token: L::Token,
        station: &Station,
        strains: &Resultants<L>,
    ) -> Resultants<L> {
        let Resultants { a_0, a_1, a_2, c, g_0, g_1 } = *strains;
        let (axial, bending) = (L::splat(token, station.axial), L::splat(token, station.bending[0]));
        let (half_bending, half_4) = (L::splat(token, station.bending[1]), L::splat(token, station.half_bending_4));
        let mut forces = Resultants {
            a_0: axial.mul_add(a_0, half_bending * a_2),
            a_1: bending * a_1,
            a_2: bending.mul_add(a_0, half_4 * a_2),
            c: axial * c,
            g_0: L::splat(token, station.shear[0]) * g_0,
            g_1: L::splat(token, station.shear[1]) * g_1,
        };
        if COUPLED {
            let (on_axis, across) = (L::splat(token, station.coupling[0]), L::splat(token, station.coupling[1]));
            forces.a_0 = on_axis.mul_add(c, forces.a_0);
            forces.a_2 = across.mul_add(c, forces.a_2);
            forces.c = on_axis.mul_add(a_0, L::splat(token, station.coupling[2]).mul_add(a_2, forces.c));
        }
        forces
    }

    /// Elastic forces; with `COUPLED` the terms of Poisson too.
    #[inline(always)]
    pub(super) fn forces<L: Lanes, const COUPLED: bool>(&self, token: L::Token, u: &[L; 14], eps_T: [L; 2]) -> [L; 14] {
        let (shape, mut sums) = (self.shape(token, u), Sums::zero(token));
        for station in &self.stations {
            let zeta = L::splat(token, station.zeta);
            let (section, strains) = self.strains(token, zeta, &shape, eps_T);
            sums.add(zeta, &section, &SideBySide::section_forces::<L, COUPLED>(token, station, &strains));
        }
        self.to_nodes(token, &sums)
    }

    /// Forces of an energy–momentum step.
    #[inline(always)]
    pub(super) fn mean_forces<L: Lanes, const COUPLED: bool>(
        &self,
        token: L::Token,
        &FourEnds { u: [ref u_0, ref u_1], eps_T }: &FourEnds<L, 14>,
    ) -> [L; 14] {
        let (shape_0, shape_1, mut sums) = (self.shape(token, u_0), self.shape(token, u_1), Sums::zero(token));
        let half = L::splat(token, 0.5);
        for station in &self.stations {
            let zeta = L::splat(token, station.zeta);
            let (section_0, strains_0) = self.strains(token, zeta, &shape_0, eps_T[0]);
            let (section_1, strains_1) = self.strains(token, zeta, &shape_1, eps_T[1]);
            let forces = SideBySide::section_forces::<L, COUPLED>(token, station, &strains_0.mean(&strains_1, half));
            sums.add(zeta, &section_0.middle(&section_1, half), &forces);
        }
        self.to_nodes(token, &sums)
    }

    /// Strain energies.
    #[inline(always)]
    pub(super) fn energies<L: Lanes>(&self, token: L::Token, u: &[L; 14], eps_T: [L; 2]) -> L {
        let (shape, half) = (self.shape(token, u), L::splat(token, 0.5));
        let mut sum = L::splat(token, 0.0);
        for station in &self.stations {
            let (_, strains) = self.strains(token, L::splat(token, station.zeta), &shape, eps_T);
            let forces = SideBySide::section_forces::<L, true>(token, station, &strains);
            sum = forces.a_0.mul_add(strains.a_0, forces.a_1.mul_add(strains.a_1, sum));
            sum = forces.a_2.mul_add(half * strains.a_2, forces.c.mul_add(strains.c, sum));
            sum = forces.g_0.mul_add(strains.g_0, forces.g_1.mul_add(strains.g_1, sum));
        }
        half * sum
    }

    /// Energies supplied by heating.
    #[inline(always)]
    pub(super) fn heating_works<L: Lanes>(
        &self,
        token: L::Token,
        &FourEnds { u: [ref u_0, ref u_1], eps_T }: &FourEnds<L, 14>,
    ) -> L {
        let (shape_0, shape_1, half) = (self.shape(token, u_0), self.shape(token, u_1), L::splat(token, 0.5));
        let (along, across) = (eps_T[1][0] - eps_T[0][0], eps_T[1][1] - eps_T[0][1]);
        let mut sum = L::splat(token, 0.0);
        for station in &self.stations {
            let zeta = L::splat(token, station.zeta);
            let (_, strains_0) = self.strains(token, zeta, &shape_0, eps_T[0]);
            let (_, strains_1) = self.strains(token, zeta, &shape_1, eps_T[1]);
            let forces = SideBySide::section_forces::<L, true>(token, station, &strains_0.mean(&strains_1, half));
            sum = forces.a_0.mul_add(along, forces.c.mul_add(across, sum));
        }
        -sum
    }

    /// Smallest det J; not a number where one is.
    #[inline(always)]
    pub(super) fn min_det_js<L: Lanes>(&self, token: L::Token, u: &[L; 14]) -> L {
        let shape = self.shape(token, u);
        let outermost = L::splat(token, -OUTERMOST * self.half_height);
        let (mut least, mut sum) = (L::splat(token, f64::INFINITY), L::splat(token, 0.0));
        for station in &self.stations {
            let (Section { r_x, d, kappa }, _) = self.sections(token, L::splat(token, station.zeta), &shape);
            let det = outermost.mul_add(kappa.cross(d).abs(), r_x.cross(d));
            (least, sum) = (det.min(least), sum + det);
        }
        // A comparison drops a NaN; a sum does not.
        sum.mul_add(L::splat(token, 0.0), least)
    }
}

/// Products M a. Across the section r_y is odd, so M couples positions and r_x with one another, and r_y with r_y.
#[inline(always)]
pub(super) fn momenta<L: Lanes>(token: L::Token, mass: &Matrix14, a: &[L; 14]) -> [L; 14] {
    let mut sums = [L::splat(token, 0.0); 14];
    for row in [0, 4, 6, 10] {
        let [m_i, m_j, m_x, m_k] = [
            L::splat(token, mass[(row, 0)]),
            L::splat(token, mass[(row, 4)]),
            L::splat(token, mass[(row, 6)]),
            L::splat(token, mass[(row, 10)]),
        ];
        sums[row] = m_i.mul_add(a[0], m_j.mul_add(a[4], m_x.mul_add(a[6], m_k * a[10])));
        sums[row + 1] = m_i.mul_add(a[1], m_j.mul_add(a[5], m_x.mul_add(a[7], m_k * a[11])));
    }
    for row in [2, 8, 12] {
        let [m_i, m_j, m_k] =
            [L::splat(token, mass[(row, 2)]), L::splat(token, mass[(row, 8)]), L::splat(token, mass[(row, 12)])];
        sums[row] = m_i.mul_add(a[2], m_j.mul_add(a[8], m_k * a[12]));
        sums[row + 1] = m_i.mul_add(a[3], m_j.mul_add(a[9], m_k * a[13]));
    }
    sums
}
