//! The section of the paper's element: its generalized strains, its law integrated through the thickness, and their derivatives.
//!
//! With the strains ε₁₁ = a₀ + a₁y + a₂y², ε₂₂ = c, 2ε₁₂ = g₀ + g₁y the integrals over y are done by hand.

#![allow(non_snake_case)] // The symbols of the derivation are names here: A, I, N, H.

use crate::elements::plane::{Block, Vec2, Vector};
use crate::equations::material::{self, LameConstants, YoungPoisson};
use crate::model::Poisson;

/// Plane law of the section, with its moduli.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Plane strain, (16).
    PlaneStrain {
        /// Lamé's constants, Pa.
        lame: LameConstants,
        /// Poisson's terms across the section, as in the paper, or on the axis ([`equations::axis`](crate::equations::axis)).
        poisson: Poisson,
    },
    /// Uniaxial stress along and across ([`equations::uniaxial`](crate::equations::uniaxial)).
    Uniaxial(YoungPoisson),
}

impl Law {
    /// Modulus of a strain ε₁₁ or ε₂₂ alone: λ + 2μ or E, Pa.
    pub fn stiff(self) -> f64 {
        match self {
            Law::PlaneStrain { lame: LameConstants { lambda, mu }, .. } => lambda + 2.0 * mu,
            Law::Uniaxial(YoungPoisson { E, .. }) => E,
        }
    }

    /// Modulus of bending, Pa: E/(1 − ν²) where Poisson's terms act on the axis, else that of a strain alone.
    fn bending(self) -> f64 {
        match self {
            Law::PlaneStrain { lame: LameConstants { lambda, mu }, poisson: Poisson::Axis } => {
                4.0 * mu * (lambda + mu) / self.stiff()
            }
            _ => self.stiff(),
        }
    }

    /// Shear modulus, Pa.
    fn shear(self) -> f64 {
        match self {
            Law::PlaneStrain { lame, .. } => lame.mu,
            Law::Uniaxial(moduli) => material::mu(moduli),
        }
    }
}

/// Current vectors of a section: tangent r', director d and its derivative κ = d'.
#[derive(Clone, Copy)]
pub(super) struct Section {
    pub r_x: Vec2,
    pub d: Vec2,
    pub kappa: Vec2,
}

/// Generalized strains of a section, the forces conjugate to them, or rates of either.
#[derive(Clone, Copy)]
pub(super) struct Resultants {
    /// ε₁₁ = a₀ + a₁y + a₂y².
    pub a: [f64; 3],
    /// ε₂₂ = c.
    pub c: f64,
    /// 2ε₁₂ = g₀ + g₁y.
    pub g: [f64; 2],
}

impl Resultants {
    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Resultants {
            a: [0, 1, 2].map(|n| f(self.a[n], other.a[n])),
            c: f(self.c, other.c),
            g: [0, 1].map(|n| f(self.g[n], other.g[n])),
        }
    }

    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Resultants { a: self.a.map(&f), c: f(self.c), g: self.g.map(&f) }
    }

    #[inline(always)]
    pub fn mean(self, other: Self) -> Self {
        self.zip(other, |a, b| 0.5 * (a + b))
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> f64 {
        let Resultants { a, c, g } = self.zip(other, |a, b| a * b);
        a[0] + a[1] + a[2] + c + g[0] + g[1]
    }
}

/// Section law, ∫ dy of the plane law: section forces from section strains.
#[derive(Clone, Copy, Debug)]
pub(super) struct SectionLaw {
    /// (λ + 2μ)A, or EA.
    pub axial: f64,
    /// Modulus of bending times I, and times ∫ y⁴ dA.
    pub bending: [f64; 2],
    /// μA and μI.
    pub shear: [f64; 2],
    /// λA, and λI where Poisson's terms act across the section. `None` without them: ν = 0, or the uniaxial law.
    pub coupling: Option<[f64; 2]>,
}

impl SectionLaw {
    /// Law of a section `h` × `w` (m).
    ///
    /// Poisson's terms across the section couple ε₂₂ = c with all of ε₁₁ = a₀ + a₁y + a₂y² by λ. On the axis they couple it with
    /// a₀ alone, and the modulus of bending is E/(1 − ν²).
    /// By the uniaxial law nothing couples them.
    pub fn new(law: Law, h: f64, w: f64) -> SectionLaw {
        let (A, I, I_4) = (w * h, w * h.powi(3) / 12.0, w * h.powi(5) / 80.0);
        let (bending, shear) = (law.bending(), law.shear());
        SectionLaw {
            axial: law.stiff() * A,
            bending: [bending * I, bending * I_4],
            shear: [shear * A, shear * I],
            coupling: SectionLaw::coupling(law, h, w).filter(|[on_axis, _]| *on_axis != 0.0),
        }
    }

    /// λA, and λI or 0: coupling of c with a₀ and with a₂. `None` where the law has no Poisson's terms.
    pub fn coupling(law: Law, h: f64, w: f64) -> Option<[f64; 2]> {
        let Law::PlaneStrain { lame: LameConstants { lambda, .. }, poisson } = law else { return None };
        let (A, I) = (w * h, w * h.powi(3) / 12.0);
        Some([lambda * A, if poisson == Poisson::Full { lambda * I } else { 0.0 }])
    }

    /// Section forces: C times the section strains.
    #[inline(always)]
    pub fn forces(&self, strains: &Resultants) -> Resultants {
        let Resultants { a, c, g } = *strains;
        let (EA, [EI, EI_4]) = (self.axial, self.bending);
        let mut N = Resultants {
            a: [EA * a[0] + EI * a[2], EI * a[1], EI * a[0] + EI_4 * a[2]],
            c: EA * c,
            g: [self.shear[0] * g[0], self.shear[1] * g[1]],
        };
        if let Some([on_axis, across]) = self.coupling {
            N.a[0] += on_axis * c;
            N.a[2] += across * c;
            N.c += on_axis * a[0] + across * a[2];
        }
        N
    }
}

/// Second derivative of a section's energy: blocks in p, δ and κ.
pub(super) type Stiffness = [[Block; 3]; 3];

/// Second derivative of the strains in p, δ and κ, contracted with the forces `N`: factors of unit matrices.
#[inline(always)]
pub(super) fn geometric(N: &Resultants) -> [[f64; 3]; 3] {
    let Resultants { a, c, g } = *N;
    [[a[0], g[0], a[1]], [g[0], c, g[1]], [a[1], g[1], a[2]]]
}

impl Section {
    #[inline(always)]
    pub fn midpoint(&self, other: &Self) -> Self {
        let half = 0.5;
        Section {
            r_x: (self.r_x + other.r_x) * half,
            d: (self.d + other.d) * half,
            kappa: (self.kappa + other.kappa) * half,
        }
    }
}

impl Section {
    /// Linear change of the strains from `before`: their derivatives there times the change of p, δ and κ.
    pub fn change_since(&self, before: &Self) -> Resultants {
        let Section { r_x, d, kappa } = *before;
        let (dp, ddelta, dkappa) = (self.r_x - r_x, self.d - d, self.kappa - kappa);
        Resultants {
            a: [r_x.dot(dp), kappa.dot(dp) + r_x.dot(dkappa), kappa.dot(dkappa)],
            c: d.dot(ddelta),
            g: [d.dot(dp) + r_x.dot(ddelta), kappa.dot(ddelta) + d.dot(dkappa)],
        }
    }

    /// Stiffness of the section: `weight` · (Bᵀ C B₁ + second derivative of the strains, contracted with the forces `N`).
    ///
    /// B = ∂(strains)/∂(p, δ, κ) belongs to this section and B₁ to `other`, which differs in an energy–momentum step only.
    /// a₀ changes by r'·p, a₁ by κ·p + r'·κ, a₂ by κ·κ, c by d·δ, g₀ by d·p + r'·δ, g₁ by κ·δ + d·κ.
    #[inline(always)]
    pub fn stiffness(&self, other: &Self, law: &SectionLaw, N: &Resultants, weight: f64) -> Stiffness {
        let (r, d, k) = (self.r_x, self.d, self.kappa);
        let (r_1, d_1, k_1) = (other.r_x, other.d, other.kappa);
        let SectionLaw { axial: EA, bending: [EI, EI_4], shear: [GA, GI], coupling } = *law;
        let [EA, EI, EI_4, GA, GI] = [EA, EI, EI_4, GA, GI].map(|stiffness| weight * stiffness);
        let N = N.map(|force| weight * force);
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
        for (row, geometric) in H.iter_mut().zip(geometric(&N)) {
            for (block, geometric) in row.iter_mut().zip(geometric) {
                *block = *block + Block::identity(geometric);
            }
        }
        H
    }
}
