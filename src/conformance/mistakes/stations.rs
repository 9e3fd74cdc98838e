//! The integrals of (18) and (21) with their parts apart, so that each can be left out or changed.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Vector3;

use crate::equations::force::{Element, Matrix14, S_1};
use crate::equations::shape::Vector14;
use crate::equations::strain::S_abc;
use crate::equations::volume::gauss_points;

/// What the integrands are made of at one point.
pub(super) struct Station {
    /// S_a, S_b, S_c.
    pub S: [Matrix14; 3],
    /// Their symmetric parts, S_a1, S_b1, S_c1.
    pub S_1: [Matrix14; 3],
    /// eᵀS e of each.
    pub form: [f64; 3],
    /// Volume.
    pub dV: f64,
}

/// All points.
pub(super) fn stations(e: &Vector14, element: &Element) -> Vec<Station> {
    let at = |p: crate::equations::volume::Point| {
        let (S_a, S_b, S_c) = S_abc(p.x, p.y, element);
        let S = [S_a, S_b, S_c];
        Station { S_1: S.map(|S| S_1(&S)), form: S.map(|S| e.dot(&(S * e))), S, dV: p.dV }
    };
    gauss_points(element.l, element.h, element.w).into_iter().map(at).collect()
}

/// ¼ ∫ Σ weightₖ S_k1 dV with weights by the station.
pub(super) fn K(stations: &[Station], weights: impl Fn(&Station) -> [f64; 3]) -> Matrix14 {
    let mut K = Matrix14::zeros();
    for station in stations {
        let weights = weights(station);
        for (S_1, weight) in station.S_1.iter().zip(weights) {
            if weight != 0.0 {
                K += S_1 * (0.25 * weight * station.dV);
            }
        }
    }
    K
}

/// ¼ ∫ Σ weightₖₙ (S_k1 e)(S_n1 e)ᵀ dV: what K's own change with e adds to the tangent.
pub(super) fn material(stations: &[Station], e: &Vector14, weights: [[f64; 3]; 3]) -> Matrix14 {
    let mut sum = Matrix14::zeros();
    for station in stations {
        let B = station.S_1.map(|S_1| S_1 * e);
        for (k, row) in weights.iter().enumerate() {
            for (n, weight) in row.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                sum += B[k] * B[n].transpose() * (0.25 * weight * station.dV);
            }
        }
    }
    sum
}

/// ∫ εₖ εₙ dV.
pub(super) fn product(stations: &[Station], eps_T: &Vector3<f64>, k: usize, n: usize) -> f64 {
    let eps = |station: &Station, k: usize| 0.5 * (station.form[k] - [1.0, 1.0, 0.0][k]) - eps_T[k];
    stations.iter().map(|station| eps(station, k) * eps(station, n) * station.dV).sum()
}
