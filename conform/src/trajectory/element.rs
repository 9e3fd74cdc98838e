//! Elastic force and energy of an element as Gauss sums over shape functions.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::equations::{cable, shape};
use ancf::model::{Element, Law as RodLaw, Material, Rod, Section};

use super::gauss::GAUSS;
use super::section_point::Point;
use super::setup::Law;
use super::stiffness::Stiffness;

/// Gauss points and stiffness of an element.
#[derive(Debug)]
pub enum ElementData {
    /// The paper's.
    Ancf {
        /// Gauss points.
        points: Vec<Point<7>>,
        /// The law.
        law: Stiffness,
    },
    /// Euler and Bernoulli's.
    Cable {
        /// Gauss points of the axial energy.
        axial: Vec<Point<4>>,
        /// Gauss points of the bending energy.
        bending: Vec<Point<4>>,
        /// Axial stiffness, N.
        EA: f64,
        /// Bending stiffness, N m².
        EI: f64,
    },
}

/// Vectors of an element, and those by which neighbours are apart.
pub const fn vectors(element: Element) -> (usize, usize) {
    match element {
        Element::Ancf => (7, 5),
        Element::EulerBernoulli => (4, 2),
    }
}

impl ElementData {
    /// The paper's element.
    pub fn ancf(law: &Law, rod: &Rod, material: &Material, section: &Section, l: f64, retardation: f64) -> ElementData {
        let [along, across] = law.points.map(|count| GAUSS.get(count.saturating_sub(1)).copied().unwrap_or(GAUSS[4]));
        let mut points = Vec::new();
        for (xi, w_xi) in along {
            for (eta, w_eta) in across {
                let (x, y) = (l / 2.0 * (1.0 + xi), law.depth * section.height / 2.0 * eta);
                let weight = l * section.height * section.width * w_xi * w_eta / 4.0;
                points.push(Point { a: shape::S_i_x(x, y, l), b: shape::S_i_y(x, y, l), weight });
            }
        }
        let (E, nu) = (material.youngs_modulus, material.nu);
        let mu = E / (2.0 * (1.0 + nu));
        let (direct, lambda) = match rod.law {
            RodLaw::Uniaxial => (E, 0.0),
            _ => {
                let lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
                (lambda + 2.0 * mu, lambda)
            }
        };
        let law = Stiffness {
            along: law.along * direct,
            across: law.across * direct,
            coupling: law.coupling * lambda,
            shear: law.shear * 2.0 * mu,
            printed: if law.printed_shear { 2.0 * mu } else { 0.0 },
            linear: law.linear,
            retardation,
        };
        ElementData::Ancf { points, law }
    }

    /// The Euler–Bernoulli element.
    pub fn cable(law: &Law, material: &Material, section: &Section, l: f64) -> ElementData {
        let points = |rule: &[(f64, f64)]| {
            let place = |(xi, w_xi): &(f64, f64)| {
                let x = l / 2.0 * (1.0 + xi);
                Point { a: cable::S_i_x(x, l), b: cable::S_i_xx(x, l), weight: l / 2.0 * w_xi }
            };
            rule.iter().map(place).collect()
        };
        let EA = material.youngs_modulus * section.height * section.width;
        let EI = EA * (law.depth * section.height).powi(2) / 12.0;
        ElementData::Cable {
            axial: points(GAUSS[4]),
            bending: points(GAUSS[2]),
            EA: law.along * EA,
            EI: law.along * EI,
        }
    }

    /// Q_e of an element with coordinates `q` and rates `v`.
    pub fn force(&self, q: &[f64], v: &[f64], heat: [f64; 2], t: [f64; 2], Q_e: &mut [f64; 14]) {
        match self {
            ElementData::Ancf { points, law } => {
                for point in points {
                    let [r_x, r_y] = point.slopes(q);
                    let rates = (law.retardation != 0.0).then(|| point.slopes(v));
                    let [on_x, on_y] = law.forces(r_x, r_y, rates, heat, t);
                    point.add(on_x, on_y, Q_e);
                }
            }
            ElementData::Cable { axial, bending, EA, EI } => {
                for point in axial {
                    let [g, _] = point.slopes(q);
                    let norm = g[0].hypot(g[1]);
                    let factor = EA * (norm - 1.0 - heat[0]) / norm;
                    point.add(g.map(|g| factor * g), [0.0; 2], Q_e);
                }
                for point in bending {
                    let [g, c] = point.slopes(q);
                    let metric = g[0] * g[0] + g[1] * g[1];
                    let kappa = (g[0] * c[1] - g[1] * c[0]) / metric;
                    let factor = EI * kappa / metric;
                    let on_g = [factor * (c[1] - 2.0 * kappa * g[0]), factor * (-c[0] - 2.0 * kappa * g[1])];
                    point.add(on_g, [-factor * g[1], factor * g[0]], Q_e);
                }
            }
        }
    }

    /// Strain energy of an element.
    pub fn energy(&self, q: &[f64], heat: [f64; 2], t: [f64; 2]) -> f64 {
        match self {
            ElementData::Ancf { points, law } => {
                let of = |point: &Point<7>| {
                    let [r_x, r_y] = point.slopes(q);
                    let strains = law.strains(r_x, r_y, heat, t);
                    let stresses = law.stresses(strains, t);
                    0.5 * point.weight * (0..3).map(|n| strains[n] * stresses[n]).sum::<f64>()
                };
                points.iter().map(of).sum()
            }
            ElementData::Cable { axial, bending, EA, EI } => {
                let stretch = axial.iter().map(|point| {
                    let [g, _] = point.slopes(q);
                    0.5 * EA * point.weight * (g[0].hypot(g[1]) - 1.0 - heat[0]).powi(2)
                });
                let bend = bending.iter().map(|point| {
                    let [g, c] = point.slopes(q);
                    let kappa = (g[0] * c[1] - g[1] * c[0]) / (g[0] * g[0] + g[1] * g[1]);
                    0.5 * EI * point.weight * kappa * kappa
                });
                stretch.sum::<f64>() + bend.sum::<f64>()
            }
        }
    }
}
