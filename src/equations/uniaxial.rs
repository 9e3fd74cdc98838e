//! A law for struts: uniaxial stress along the rod and across it, in place of the paper's plane strain.
//!
//! (16) is the law of a body that cannot move across the plane: a strip of a wide plate. Bending then feels
//! E/(1 − ν²), with [`axis`](super::axis), or λ + 2μ in the paper's element, which locks (M3,
//! `oracle/DERIVATION.md#m3-free-of-locking-only-without-poissons-ratio`). The sides of a strut are free. Its fibres are bars: they
//! contract across, which nothing resists, and feel E alone.
//!
//! Here fibres along the rod and across it are such bars, and the angle between them feels the shear modulus:
//!
//! U = ½ ∫_V E (ε₁₁² + ε₂₂²) + G (2ε₁₂)² dV,  G = E/\[2(1 + ν)\].
//!
//! So EA, EI and GA are those of a beam, and nothing locks. **There is no Poisson contraction**: a stretched rod keeps the height
//! that the strain ε₂₂ = 0 has. ν acts on G alone. Heat strains the rod as in (8): along and across in the 2D model, along only
//! in the 1D model. As nothing couples the directions, heat across moves the section alone.
//!
//! An alternative to the paper's law, in no equation of the paper. It depends on the frame, so strains are in the **rod's own
//! axes**, its directions at the start, with the engineering shear: ε of [`axis::epsilon`](super::axis::epsilon). Green–Lagrange
//! strains do not change with a rotation of the moving rod, and so neither does U. At ν = 0 it is the paper's.

use super::axis::{epsilon, epsilon_ee};
use super::element::{Element, Matrix14};
use super::material::{self, YoungPoisson};
use super::shape::Vector14;
use super::volume::gauss_points;
use nalgebra::{Matrix3, Vector3};

/// Elasticity matrix of the uniaxial law: D = diag(E, E, G), 3 × 3, Pa.
pub fn D(moduli: YoungPoisson) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(moduli.E, moduli.E, material::mu(moduli)))
}

/// Strain energy of the uniaxial law, J: U = ½ ∫_V εᵀ D ε dV.
pub fn U(e: &Vector14, eps_T: &Vector3<f64>, moduli: YoungPoisson, element: &Element) -> f64 {
    let (D, Element { l, h, w, .. }) = (D(moduli), *element);
    let mut U = 0.0;
    for p in gauss_points(l, h, w) {
        let eps = epsilon(p.x, p.y, e, eps_T, l);
        U += 0.5 * eps.dot(&(D * eps)) * p.dV;
    }
    U
}

/// Elastic forces of the uniaxial law: Q_e = ∂U/∂e = ∫_V Σ σₙ ∂εₙ/∂e dV, σ = D ε; N on positions, N m on slopes.
pub fn Q_e(e: &Vector14, eps_T: &Vector3<f64>, moduli: YoungPoisson, element: &Element) -> Vector14 {
    let (D, Element { l, h, w, .. }) = (D(moduli), *element);
    let mut Q_e = Vector14::zeros();
    for p in gauss_points(l, h, w) {
        let sigma = D * epsilon(p.x, p.y, e, eps_T, l);
        for (n, S) in epsilon_ee(p.x, p.y, l).iter().enumerate() {
            Q_e += sigma[n] * S * e * p.dV;
        }
    }
    Q_e
}

/// Tangent of the uniaxial law: ∂Q_e/∂e = ∫_V Σ Dₙₙ (∂εₙ/∂e)(∂εₙ/∂e)ᵀ + σₙ ∂²εₙ/∂e² dV, symmetric.
pub fn tangent(e: &Vector14, eps_T: &Vector3<f64>, moduli: YoungPoisson, element: &Element) -> Matrix14 {
    let (D, Element { l, h, w, .. }) = (D(moduli), *element);
    let mut K = Matrix14::zeros();
    for p in gauss_points(l, h, w) {
        let sigma = D * epsilon(p.x, p.y, e, eps_T, l);
        for (n, S) in epsilon_ee(p.x, p.y, l).iter().enumerate() {
            let epsilon_e = S * e;
            K += (D[(n, n)] * epsilon_e * epsilon_e.transpose() + sigma[n] * S) * p.dV;
        }
    }
    K
}
