//! Four Euler–Bernoulli elements side by side: what the others of [`Cable`]'s files compute for one, with the same symbols.
//!
//! ```text
//!  coordinates of four elements       polynomial in ζ                nodal vectors again
//!
//!  [r_i r_xi r_k r_xk]  →  p = p₀ + p₁ζ + p₂ζ²  ┐ 5 ζ: stretch      Q: forces on p₀, p₁, p₂, which the
//!   each entry: four       s = 2/l (p₁ + 2p₂ζ)  ┘ 3 ζ: curvature →  transpose of the first map takes to
//!   numbers, one of each element                                    the four nodal vectors
//! ```
//!
//! * Stretch at ζ, with r' = t + p and λ = |r'|: ε = p·(2t + p)/(1 + λ) − ε_T, and EA ε r'/λ is the force on p. Both divisions
//!   are one: 1/(λ + λ²).
//! * Curvature: κ = r' × s/q with q = r'·r'. With M = EI κ/q, the force on s is M turn(r') and the one on p is
//!   −M (turn(s) + 2κr').

use crate::elements::beam::FourEnds;
use crate::elements::collapse::OUTERMOST;
use crate::elements::pair::{Pair, at};
use crate::elements::polynomial::GaussPoint;
use crate::equations::cable::Matrix8;
use crate::lanes::Lanes;

/// Stretches of the axes at a Gauss point.
struct Stretch<L> {
    r_x: Pair<L>,
    /// |r_x|
    length: L,
    /// 1/|r_x|
    inverse: L,
    /// |r_x| − 1
    strain: L,
}

/// Curvatures of the axes at a Gauss point.
struct Bend<L> {
    r_x: Pair<L>,
    r_xx: Pair<L>,
    /// r_x × r_xx
    cross: L,
    /// r_x · r_x
    square: L,
    /// 1/(r_x · r_x)
    inverse: L,
}

/// Element as it is computed side by side.
#[derive(Clone, Debug)]
pub(super) struct SideBySide {
    /// Unit vector along the element.
    pub t: [f64; 2],
    /// 1/l
    pub per_length: f64,
    /// Gauss points of the axial strain, and of the curvature.
    pub axial: [GaussPoint; 5],
    pub bending: [GaussPoint; 3],
    pub EA: f64,
    pub EI: f64,
}

impl SideBySide {
    #[inline(always)]
    fn shape<L: Lanes>(&self, token: L::Token, u: &[L; 8]) -> [Pair<L>; 3] {
        let (half, three_halves) = (L::splat(token, 0.5), L::splat(token, 1.5));
        let (r_i, slope_i) = (Pair { x: u[0], y: u[1] }, Pair { x: u[2], y: u[3] });
        let (r_k, slope_k) = (Pair { x: u[4], y: u[5] }, Pair { x: u[6], y: u[7] });
        let (chord, mean) = ((r_k - r_i).times(L::splat(token, self.per_length)), (slope_i + slope_k).times(half));
        [
            chord.times(three_halves) - mean.times(half),
            (slope_k - slope_i).times(half),
            (mean - chord).times(three_halves),
        ]
    }

    #[inline(always)]
    fn to_nodes<L: Lanes>(&self, token: L::Token, [p_0, p_1, p_2]: &[Pair<L>; 3]) -> [L; 8] {
        let chord = (*p_0 - *p_2).times(L::splat(token, 1.5 * self.per_length));
        let mean = p_0.times_add(L::splat(token, -0.25), p_2.times(L::splat(token, 0.75)));
        let half = p_1.times(L::splat(token, 0.5));
        let (slope_i, slope_k) = (mean - half, mean + half);
        [-chord.x, -chord.y, slope_i.x, slope_i.y, chord.x, chord.y, slope_k.x, slope_k.y]
    }

    #[inline(always)]
    fn stretch<L: Lanes>(&self, token: L::Token, point: &GaussPoint, shape: &[Pair<L>; 3]) -> Stretch<L> {
        let (one, t) = (L::splat(token, 1.0), Pair::splat(token, self.t));
        let p = at(L::splat(token, point.zeta), shape);
        let r_x = t + p;
        let length = r_x.dot(r_x).sqrt();
        let more = one + length;
        let both = (length * more).recip();
        let strain = (t + r_x).dot(p) * (length * both);
        Stretch { r_x, length, inverse: more * both, strain }
    }

    #[inline(always)]
    fn bend<L: Lanes>(&self, token: L::Token, point: &GaussPoint, shape: &[Pair<L>; 3]) -> Bend<L> {
        let zeta = L::splat(token, point.zeta);
        let (two_l, two_zeta) = (L::splat(token, 2.0 * self.per_length), L::splat(token, 2.0 * point.zeta));
        let r_x = Pair::splat(token, self.t) + at(zeta, shape);
        let r_xx = shape[2].times_add(two_zeta, shape[1]).times(two_l);
        let square = r_x.dot(r_x);
        Bend { r_x, r_xx, cross: r_x.cross(r_xx), square, inverse: square.recip() }
    }

    /// Adds a force on p at a Gauss point to the forces on the coefficients.
    #[inline(always)]
    fn add_on_p<L: Lanes>(zeta: L, force: Pair<L>, sums: &mut [Pair<L>; 3]) {
        *sums = [sums[0] + force, force.times_add(zeta, sums[1]), force.times_add(zeta * zeta, sums[2])];
    }

    /// Adds a force on s = p' at a Gauss point.
    #[inline(always)]
    fn add_on_s<L: Lanes>(&self, token: L::Token, zeta: L, force: Pair<L>, sums: &mut [Pair<L>; 3]) {
        let (two_l, four_l) = (L::splat(token, 2.0 * self.per_length), L::splat(token, 4.0 * self.per_length));
        sums[1] = force.times_add(two_l, sums[1]);
        sums[2] = force.times_add(four_l * zeta, sums[2]);
    }

    /// Elastic forces.
    #[inline(always)]
    pub(super) fn forces<L: Lanes>(&self, token: L::Token, u: &[L; 8], eps_T: L) -> [L; 8] {
        let (shape, mut sums) = (self.shape(token, u), [Pair::zero(token); 3]);
        for point in &self.axial {
            let Stretch { r_x, inverse, strain, .. } = self.stretch(token, point, &shape);
            let force = r_x.times(L::splat(token, point.weight * self.EA) * (strain - eps_T) * inverse);
            SideBySide::add_on_p(L::splat(token, point.zeta), force, &mut sums);
        }
        for point in &self.bending {
            let Bend { r_x, r_xx, cross, inverse, .. } = self.bend(token, point, &shape);
            let kappa = cross * inverse;
            let moment = L::splat(token, point.weight * self.EI) * kappa * inverse;
            self.add_moment(token, L::splat(token, point.zeta), (r_x, r_xx, kappa + kappa), moment, &mut sums);
        }
        self.to_nodes(token, &sums)
    }

    /// Adds M times the derivative of r_x × r_xx − κ r_x·r_x, with `twice_kappa` held.
    #[inline(always)]
    fn add_moment<L: Lanes>(
        &self,
        token: L::Token,
        zeta: L,
        (r_x, r_xx, twice_kappa): (Pair<L>, Pair<L>, L),
        moment: L,
        sums: &mut [Pair<L>; 3],
    ) {
        let on_p = r_x.times_add(twice_kappa, r_xx.turn()).times(-moment);
        SideBySide::add_on_p(zeta, on_p, sums);
        self.add_on_s(token, zeta, r_x.turn().times(moment), sums);
    }

    /// Forces of an energy–momentum step, from the discrete derivatives of `step.rs`.
    #[inline(always)]
    pub(super) fn mean_forces<L: Lanes>(
        &self,
        token: L::Token,
        &FourEnds { u: [ref u_0, ref u_1], eps_T: [[eps_T0, _], [eps_T1, _]] }: &FourEnds<L, 8>,
    ) -> [L; 8] {
        let (shape_0, shape_1) = (self.shape(token, u_0), self.shape(token, u_1));
        let (mut sums, half, heat) = ([Pair::zero(token); 3], L::splat(token, 0.5), eps_T0 + eps_T1);
        for point in &self.axial {
            let start = self.stretch(token, point, &shape_0);
            let end = self.stretch(token, point, &shape_1);
            let per_length = (start.length + end.length).recip();
            let stiffness = L::splat(token, 0.5 * point.weight * self.EA);
            let force = stiffness * (start.strain + end.strain - heat) * per_length;
            SideBySide::add_on_p(L::splat(token, point.zeta), (start.r_x + end.r_x).times(force), &mut sums);
        }
        for point in &self.bending {
            let start = self.bend(token, point, &shape_0);
            let end = self.bend(token, point, &shape_1);
            let (r_x, r_xx) = ((start.r_x + end.r_x).times(half), (start.r_xx + end.r_xx).times(half));
            let (square, cross) = (half * (start.square + end.square), half * (start.cross + end.cross));
            let curvatures = start.cross.mul_add(start.inverse, end.cross * end.inverse);
            let stiffness = L::splat(token, 0.5 * point.weight * self.EI);
            // The derivative is that of q̄ Δc − c̄ Δq, over q₀q₁.
            let moment = stiffness * curvatures * (start.inverse * end.inverse);
            let zeta = L::splat(token, point.zeta);
            let on_p = r_x.times_add(cross + cross, r_xx.turn().times(square)).times(-moment);
            SideBySide::add_on_p(zeta, on_p, &mut sums);
            self.add_on_s(token, zeta, r_x.turn().times(square * moment), &mut sums);
        }
        self.to_nodes(token, &sums)
    }

    /// Strain energies.
    #[inline(always)]
    pub(super) fn energies<L: Lanes>(&self, token: L::Token, u: &[L; 8], eps_T: L) -> L {
        let (shape, mut sum) = (self.shape(token, u), L::splat(token, 0.0));
        for point in &self.axial {
            let strain = self.stretch(token, point, &shape).strain - eps_T;
            sum = (L::splat(token, 0.5 * point.weight * self.EA) * strain).mul_add(strain, sum);
        }
        for point in &self.bending {
            let Bend { cross, inverse, .. } = self.bend(token, point, &shape);
            let kappa = cross * inverse;
            sum = (L::splat(token, 0.5 * point.weight * self.EI) * kappa).mul_add(kappa, sum);
        }
        sum
    }

    /// Energies supplied by heating.
    #[inline(always)]
    pub(super) fn heating_works<L: Lanes>(
        &self,
        token: L::Token,
        &FourEnds { u: [ref u_0, ref u_1], eps_T: [[eps_T0, _], [eps_T1, _]] }: &FourEnds<L, 8>,
    ) -> L {
        let (shape_0, shape_1, mut sum) = (self.shape(token, u_0), self.shape(token, u_1), L::splat(token, 0.0));
        for point in &self.axial {
            let start = self.stretch(token, point, &shape_0).strain - eps_T0;
            let end = self.stretch(token, point, &shape_1).strain - eps_T1;
            sum = L::splat(token, -0.5 * point.weight * self.EA).mul_add(start + end, sum);
        }
        sum * (eps_T1 - eps_T0)
    }

    /// Smallest det J; not a number where one is.
    #[inline(always)]
    pub(super) fn min_det_js<L: Lanes>(&self, token: L::Token, [before, u]: [&[L; 8]; 2]) -> L {
        let (before, shape) = (self.shape(token, before), self.shape(token, u));
        let outermost = L::splat(token, -OUTERMOST * (3.0 * self.EI / self.EA).sqrt());
        let t = Pair::splat(token, self.t);
        let (mut least, mut sum) = (L::splat(token, f64::INFINITY), L::splat(token, 0.0));
        for point in &self.bending {
            let Bend { cross, square, inverse, .. } = self.bend(token, point, &shape);
            let fibre = outermost.mul_add((cross * inverse).abs(), square.sqrt());
            (least, sum) = (fibre.min(least), sum + fibre);
        }
        for point in &self.axial {
            let zeta = L::splat(token, point.zeta);
            let turned = (t + at(zeta, &before)).dot(t + at(zeta, &shape));
            (least, sum) = (turned.min(least), sum + turned);
        }
        // A comparison drops a NaN; a sum does not.
        sum.mul_add(L::splat(token, 0.0), least)
    }
}

/// Products M a.
#[inline(always)]
pub(super) fn momenta<L: Lanes>(token: L::Token, mass: &Matrix8, a: &[L; 8]) -> [L; 8] {
    let mut sums = [L::splat(token, 0.0); 8];
    for row in [0, 2, 4, 6] {
        let [m_0, m_1, m_2, m_3] = [
            L::splat(token, mass[(row, 0)]),
            L::splat(token, mass[(row, 2)]),
            L::splat(token, mass[(row, 4)]),
            L::splat(token, mass[(row, 6)]),
        ];
        sums[row] = m_0.mul_add(a[0], m_1.mul_add(a[2], m_2.mul_add(a[4], m_3 * a[6])));
        sums[row + 1] = m_0.mul_add(a[1], m_1.mul_add(a[3], m_2.mul_add(a[5], m_3 * a[7])));
    }
    sums
}
