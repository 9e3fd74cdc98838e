//! A cure for the element's thickness locking at ν ≠ 0: Poisson's terms act on the axis only.
//!
//! In bending, the strain along the rod is linear in y, and Poisson's effect requires ε₂₂ to be linear in y too. The section
//! r₀ + y r_y has one r_y for all y and cannot follow. The paper's element locks: it gives (1 − 2ν)/(1 − ν)² of a slender
//! beam's deflection (M3, `oracle/DERIVATION.md#m3-free-of-locking-only-without-poissons-ratio`).
//!
//! The cure is that of the paper's references \[22–24\]. The section works with D₀ = diag(E*, E*, μ), E* = E/(1 − ν²), which
//! couples nothing. The difference D − D₀ acts on the axis y = 0:
//!
//! U = ½ ∫_V εᵀ D₀ ε dV + ½ hw ∫ ε(x, 0)ᵀ (D − D₀) ε(x, 0) dx.
//!
//! The rod stays one in **plane strain**, a strip of a wide plate: a slender one deflects by 1 − ν² of what a strut with free sides
//! does, as EI/(1 − ν²) resists it. [`uniaxial`](super::uniaxial) is the law of a strut.
//!
//! An alternative to the paper's element, in no equation of the paper. D₀ depends on the frame, so strains are in the
//! **rod's own axes** here, with the engineering shear: ε = \[ε₁₁, ε₂₂, 2ε₁₂\]ᵀ. At ν = 0, D₀ = D and nothing changes.

use super::element::{Element, Matrix14};
use super::force::S_1;
use super::material::{self, YoungPoisson};
use super::shape::{S_x, S_y, Vector14};
use super::volume::{GAUSS_5, axis_points, gauss_points};
use nalgebra::{Matrix3, Vector3};

/// Elasticity matrix of the section: D₀ = diag(E*, E*, μ), 3 × 3, Pa, with E* = E/(1 − ν²).
pub fn D_0(YoungPoisson { E, nu }: YoungPoisson) -> Matrix3<f64> {
    let E_star = E / (1.0 - nu * nu);
    Matrix3::from_diagonal(&Vector3::new(E_star, E_star, E / (2.0 * (1.0 + nu))))
}

/// Elasticity matrix D of (16) for strains with the engineering shear, Pa: μ in place of 2μ.
fn D(moduli: YoungPoisson) -> Matrix3<f64> {
    let mut D = material::D(moduli.into());
    D[(2, 2)] = material::mu(moduli);
    D
}

/// Elastic strain of a straight element in its own axes: ε = \[½(r_x·r_x − 1), ½(r_y·r_y − 1), r_x·r_y\]ᵀ − ε_T.
///
/// In these axes ε_T is \[αΔT, αΔT, 0\] in the 2D model and \[αΔT, 0, 0\] in the 1D model.
pub fn epsilon(x: f64, y: f64, e: &Vector14, eps_T: &Vector3<f64>, l: f64) -> Vector3<f64> {
    let (r_x, r_y) = (S_x(x, y, l) * e, S_y(x, y, l) * e);
    Vector3::new(0.5 * (r_x.dot(&r_x) - 1.0), 0.5 * (r_y.dot(&r_y) - 1.0), r_x.dot(&r_y)) - eps_T
}

/// Second derivatives ∂²ε/∂e² of the three strains: S_xᵀS_x, S_yᵀS_y, S_xᵀS_y + S_yᵀS_x. Times e they give ∂ε/∂e, as ε is quadratic.
pub(super) fn epsilon_ee(x: f64, y: f64, l: f64) -> [Matrix14; 3] {
    let (S_x, S_y) = (S_x(x, y, l), S_y(x, y, l));
    [S_x.transpose() * S_x, S_y.transpose() * S_y, S_1(&(S_x.transpose() * S_y))]
}

/// Gauss points (x, y) of both integrals with their weights: D₀ dV across the section, (D − D₀) hw dx on the axis.
fn weighted_points(moduli: YoungPoisson, element: &Element) -> impl Iterator<Item = (f64, f64, Matrix3<f64>)> {
    let Element { l, h, w, .. } = *element;
    let (D_0, D) = (D_0(moduli), D(moduli));
    let section = gauss_points(l, h, w).into_iter().map(move |p| (p.x, p.y, D_0 * p.dV));
    let axis = axis_points(&GAUSS_5, l).into_iter().map(move |(x, dx)| (x, 0.0, (D - D_0) * (h * w * dx)));
    section.chain(axis)
}

/// Strain energy with Poisson's terms on the axis, J.
pub fn U(e: &Vector14, eps_T: &Vector3<f64>, moduli: YoungPoisson, element: &Element) -> f64 {
    let mut U = 0.0;
    for (x, y, D_dV) in weighted_points(moduli, element) {
        let eps = epsilon(x, y, e, eps_T, element.l);
        U += 0.5 * eps.dot(&(D_dV * eps));
    }
    U
}

/// Elastic forces with Poisson's terms on the axis: Q_e = ∂U/∂e = Σ ∂ε/∂eᵀ σ; N on positions, N m on slopes.
pub fn Q_e(e: &Vector14, eps_T: &Vector3<f64>, moduli: YoungPoisson, element: &Element) -> Vector14 {
    let mut Q_e = Vector14::zeros();
    for (x, y, D_dV) in weighted_points(moduli, element) {
        let sigma = D_dV * epsilon(x, y, e, eps_T, element.l);
        for (n, S) in epsilon_ee(x, y, element.l).iter().enumerate() {
            Q_e += sigma[n] * S * e;
        }
    }
    Q_e
}

/// Tangent with Poisson's terms on the axis: ∂Q_e/∂e = Σ ∂ε/∂eᵀ D ∂ε/∂e + Σ σₙ ∂²εₙ/∂e², symmetric.
pub fn tangent(e: &Vector14, eps_T: &Vector3<f64>, moduli: YoungPoisson, element: &Element) -> Matrix14 {
    let mut K = Matrix14::zeros();
    for (x, y, D_dV) in weighted_points(moduli, element) {
        let sigma = D_dV * epsilon(x, y, e, eps_T, element.l);
        let S = epsilon_ee(x, y, element.l);
        let epsilon_e = S.map(|S| S * e);
        for m in 0..3 {
            K += sigma[m] * S[m];
            for n in 0..3 {
                K += D_dV[(m, n)] * epsilon_e[m] * epsilon_e[n].transpose();
            }
        }
    }
    K
}
