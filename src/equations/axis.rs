//! A cure for the element's thickness locking at ν ≠ 0: Poisson's terms act on the axis only.
//!
//! Where a section bends, the strain along the rod is linear in y and Poisson's effect wants ε₂₂ to be so too. A section
//! that is r₀ + y r_y, with one r_y for all y, cannot follow: the element of the paper resists and gives (1 − 2ν)/(1 − ν)² of a
//! slender beam's deflection (M3, `oracle/DERIVATION.md#m3-free-of-locking-only-without-poissons-ratio`). The cure, that of the references \[22–24\] of the paper: the section works with
//! D₀ = diag(E*, E*, μ), E* = E/(1 − ν²), which couples nothing, and what D has beyond D₀ acts on the axis y = 0:
//!
//! U = ½ ∫_V εᵀ D₀ ε dV + ½ hw ∫ ε(x, 0)ᵀ (D − D₀) ε(x, 0) dx.
//!
//! An option beside the paper's element, in no equation of the paper. D₀ is not the same in every frame, so strains are in the
//! **rod's own axes** here, with the engineering shear: ε = \[ε₁₁, ε₂₂, 2ε₁₂\]ᵀ. At ν = 0 D₀ = D, and nothing changes.

use super::force::{Element, Matrix14, S_1};
use super::shape::{S_x, S_y, Vector14};
use super::volume::{GAUSS_5, axis_points, gauss_points};
use nalgebra::{Matrix3, Vector3};

/// D₀ = diag(E*, E*, μ), Pa, with E* = E/(1 − ν²).
pub fn D_0(E: f64, nu: f64) -> Matrix3<f64> {
    let E_star = E / (1.0 - nu * nu);
    Matrix3::from_diagonal(&Vector3::new(E_star, E_star, E / (2.0 * (1.0 + nu))))
}

/// D of (16) for strains with the engineering shear, Pa: μ in place of 2μ.
fn D(E: f64, nu: f64) -> Matrix3<f64> {
    let (lambda, mu) = (super::material::lambda(E, nu), super::material::mu(E, nu));
    let mut D = super::material::D(lambda, mu);
    D[(2, 2)] = mu;
    D
}

/// Strain that makes stress, in the own axes of a straight element: ½(r_x·r_x − 1), ½(r_y·r_y − 1), r_x·r_y, less
/// ε_T, which is \[αΔT, αΔT, 0\] there, or \[αΔT, 0, 0\] in the 1D model.
pub fn epsilon(x: f64, y: f64, e: &Vector14, eps_T: &Vector3<f64>, l: f64) -> Vector3<f64> {
    let (r_x, r_y) = (S_x(x, y, l) * e, S_y(x, y, l) * e);
    Vector3::new(0.5 * (r_x.dot(&r_x) - 1.0), 0.5 * (r_y.dot(&r_y) - 1.0), r_x.dot(&r_y)) - eps_T
}

/// ∂²ε/∂e² of the three strains: S_xᵀS_x, S_yᵀS_y, S_xᵀS_y + S_yᵀS_x. With e they give ∂ε/∂e, as ε is quadratic.
fn epsilon_ee(x: f64, y: f64, l: f64) -> [Matrix14; 3] {
    let (S_x, S_y) = (S_x(x, y, l), S_y(x, y, l));
    [S_x.transpose() * S_x, S_y.transpose() * S_y, S_1(&(S_x.transpose() * S_y))]
}

/// Every point of both integrals, with what weighs it: D₀ dV across the section, (D − D₀) hw dx on the axis.
fn stations(E: f64, nu: f64, element: &Element) -> impl Iterator<Item = (f64, f64, Matrix3<f64>)> {
    let Element { l, h, w, .. } = *element;
    let (D_0, D) = (D_0(E, nu), D(E, nu));
    let section = gauss_points(l, h, w).into_iter().map(move |p| (p.x, p.y, D_0 * p.dV));
    let axis = axis_points(&GAUSS_5, l).into_iter().map(move |(x, dx)| (x, 0.0, (D - D_0) * (h * w * dx)));
    section.chain(axis)
}

/// Strain energy, J, with Poisson's terms on the axis.
pub fn U(e: &Vector14, eps_T: &Vector3<f64>, E: f64, nu: f64, element: &Element) -> f64 {
    let mut U = 0.0;
    for (x, y, D_dV) in stations(E, nu, element) {
        let eps = epsilon(x, y, e, eps_T, element.l);
        U += 0.5 * eps.dot(&(D_dV * eps));
    }
    U
}

/// Elastic forces ∂U/∂e = Σ ∂ε/∂eᵀ σ; N on positions, N m on slopes.
pub fn Q_e(e: &Vector14, eps_T: &Vector3<f64>, E: f64, nu: f64, element: &Element) -> Vector14 {
    let mut Q_e = Vector14::zeros();
    for (x, y, D_dV) in stations(E, nu, element) {
        let sigma = D_dV * epsilon(x, y, e, eps_T, element.l);
        for (n, S) in epsilon_ee(x, y, element.l).iter().enumerate() {
            Q_e += sigma[n] * S * e;
        }
    }
    Q_e
}

/// Tangent ∂Q_e/∂e, symmetric: Σ ∂ε/∂eᵀ D ∂ε/∂e + Σ σₙ ∂²εₙ/∂e².
pub fn tangent(e: &Vector14, eps_T: &Vector3<f64>, E: f64, nu: f64, element: &Element) -> Matrix14 {
    let mut K = Matrix14::zeros();
    for (x, y, D_dV) in stations(E, nu, element) {
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
