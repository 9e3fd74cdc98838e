//! `fixtures/cable.json`, and the scale of its quantities: the reasoning of `scale.rs`, by hand from Hermite's cubics.

use ancf::state::CableState;
use nalgebra::{SMatrix, SVector, Vector2};
use serde_json::Value;
use std::ops::{Add, Mul};

use super::{Case, TOLERANCE, read};

/// The fixture.
pub fn cables() -> Value {
    read("cable.json")
}

/// How large a quantity gets, and the terms that are added up for it, on which its rounding depends: sums of terms for
/// a sum, the rule of products for a product.
#[derive(Clone, Copy)]
struct Size {
    most: f64,
    terms: f64,
}

impl Add for Size {
    type Output = Size;
    fn add(self, other: Size) -> Size {
        Size { most: self.most + other.most, terms: self.terms + other.terms }
    }
}

impl Mul for Size {
    type Output = Size;
    fn mul(self, other: Size) -> Size {
        let both = TOLERANCE * self.terms * other.terms; // what is left where both are zero but for rounding
        Size { most: self.most * other.most, terms: self.terms * other.most + self.most * other.terms + both }
    }
}

/// Of a number that is one term.
fn one(number: f64) -> Size {
    Size { most: number, terms: number }
}

/// The largest |r_x| and |r_xx| of the element: r_x is a mean of the legs of the cubic's control polygon, r_xx one of their
/// differences.
fn slopes(l: f64, e: &[f64; 8]) -> [f64; 2] {
    let vector = |n: usize| Vector2::new(e[2 * n], e[2 * n + 1]);
    let (first, last) = (vector(1), vector(3));
    let middle = 3.0 / l * (vector(2) - vector(0)) - first - last;
    let bend = (middle - first).norm().max((last - middle).norm());
    [first.norm().max(middle.norm()).max(last.norm()), 2.0 / l * bend]
}

/// Largest terms of the four shape functions and of their derivatives over the element, by coordinate.
fn largest(terms: [f64; 4]) -> [f64; 8] {
    std::array::from_fn(|i| terms[i / 2])
}

/// A quantity's scale, entry by entry, with the reason for it.
///
/// # Panics
/// For a quantity without a row.
pub fn scale(quantity: &str, case: &Case<CableState>) -> Vec<f64> {
    let s = &case.state;
    let l = s.l;
    let N = largest([1.0, l, 1.0, l]);
    let D = largest([6.0 / l, 4.0, 6.0 / l, 3.0]);
    let H = largest([12.0 / l.powi(2), 6.0 / l, 12.0 / l.powi(2), 6.0 / l]);

    let sum = |terms: &[f64; 8], e: &[f64; 8]| terms.iter().zip(e).map(|(n, e)| n * e.abs()).sum::<f64>();
    let points = |per_point: &[f64]| per_point.repeat(s.points.len());
    let of_coordinates = |of: &dyn Fn(usize) -> f64| (0..8).map(of).collect::<Vec<f64>>();
    let of_pairs = |of: &dyn Fn(usize, usize) -> f64| (0..64).map(|n| of(n / 8, n % 8)).collect::<Vec<f64>>();

    let (EA_l, EI_l) = (s.E * s.h * s.w * l, s.E * s.w * s.h.powi(3) / 12.0 * l);
    let (mass, gravity) = (s.rho * s.h * s.w * l, s.gravity[0].abs() + s.gravity[1].abs());
    // The shortest |r_x| at the state's points (the oracle's) stands for the element.
    let shortest = case.value("cable.r_x").chunks(2).map(|r_x| r_x[0].hypot(r_x[1])).fold(f64::INFINITY, f64::min);
    let [longest, bend] = slopes(l, &s.e);
    let (r_x, r_xx) = (Size { most: longest, terms: sum(&D, &s.e) }, Size { most: bend, terms: sum(&H, &s.e) });
    let inverse = Size { most: 1.0 / shortest, terms: r_x.terms / shortest.powi(2) };
    let (S_x, S_xx) = (|i: usize| one(D[i]), |i: usize| one(H[i]));
    // |r_x| − 1 − ε_T and (r_x × r_xx)/|r_x|², then their derivatives: S_xᵀn, (I − n nᵀ)/|r_x| between S_x; and a quotient's.
    let heat = (s.alpha * s.dT).abs();
    let stretch = (longest - 1.0).abs().max((shortest - 1.0).abs());
    let epsilon = Size { most: stretch + heat, terms: r_x.terms + 1.0 + heat };
    let kappa = r_x * r_xx * inverse * inverse;
    let epsilon_e = |i| S_x(i) * r_x * inverse;
    let epsilon_ee = |i, j| S_x(i) * S_x(j) * (inverse + r_x * r_x * inverse * inverse * inverse);
    let twice = one(2.0);
    let kappa_e = |i| (S_xx(i) * r_x + S_x(i) * r_xx + twice * kappa * S_x(i) * r_x) * inverse * inverse;
    let kappa_ee = |i, j| {
        let cross = S_xx(i) * S_x(j) + S_x(i) * S_xx(j);
        let product = twice * r_x * (S_x(i) * kappa_e(j) + kappa_e(i) * S_x(j));
        (cross + twice * kappa * S_x(i) * S_x(j) + product) * inverse * inverse
    };
    let force = |i| (one(EA_l) * epsilon * epsilon_e(i) + one(EI_l) * kappa * kappa_e(i)).terms;

    match quantity {
        // The functions' own size, and their sums with e.
        "cable.S" => points(&[N[0], N[2], N[4], N[6]]),
        "cable.S_x" => points(&[D[0], D[2], D[4], D[6]]),
        "cable.S_xx" => points(&[H[0], H[2], H[4], H[6]]),
        "cable.r" => points(&[sum(&N, &s.e); 2]),
        "cable.r_x" => points(&[r_x.terms; 2]),
        "cable.r_xx" => points(&[r_xx.terms; 2]),
        "cable.epsilon" => points(&[epsilon.terms]),
        "cable.kappa" => points(&[kappa.terms]),
        // ½ρA ∫ |ṙ|² and ∫ ρA SᵀS: products of two such sums.
        "cable.T" => vec![0.5 * mass * sum(&N, &s.edot).powi(2).max(f64::MIN_POSITIVE)],
        "cable.M" => of_pairs(&|i, j| mass * N[i] * N[j]),
        "cable.Q_w" => of_coordinates(&|i| mass * N[i] * gravity.max(1.0)),
        // ½ ∫ EA ε² + ½ ∫ EI κ², and its derivatives.
        "cable.U" => vec![(one(0.5 * EA_l) * epsilon * epsilon + one(0.5 * EI_l) * kappa * kappa).terms],
        "cable.Q_e" => of_coordinates(&force),
        "cable.tangent" => of_pairs(&|i, j| {
            let axial = epsilon_e(i) * epsilon_e(j) + epsilon * epsilon_ee(i, j);
            (one(EA_l) * axial + one(EI_l) * (kappa_e(i) * kappa_e(j) + kappa * kappa_ee(i, j))).terms
        }),
        // Forces through |M⁻¹|.
        "cable.eddot" => {
            let M = SMatrix::<f64, 8, 8>::from_row_slice(&case.value("cable.M"));
            let load = SVector::<f64, 8>::from_fn(|i, _| force(i) + mass * N[i] * gravity);
            (M.cholesky().unwrap().inverse().abs() * load).as_slice().to_vec()
        }
        _ => panic!("no scale for {quantity}"),
    }
}
