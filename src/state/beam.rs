//! The state of one beam element: what the fixtures and other programs hand over as JSON.

#![allow(non_snake_case)] // The keys of the JSON contract: E, dT.

use serde::{Deserialize, Serialize};

use crate::equations::material::YoungPoisson;
use crate::model::ThermalModel;

/// State of a beam element with `N` nodal coordinates: geometry, motion, material, temperature, and the points to look at.
///
/// SI units. The paper's element has 14 coordinates ([`ElementState`]), the cable element 8 ([`CableState`]). The JSON form
/// has exactly these keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, bound(serialize = "[f64; N]: Serialize", deserialize = "[f64; N]: Deserialize<'de>"))]
pub struct BeamState<const N: usize> {
    /// Length, m.
    pub l: f64,
    /// Height of the section (in the plane), m.
    pub h: f64,
    /// Width of the section (normal to the plane), m.
    pub w: f64,
    /// Initial inclination, rad. No quantity of a cable depends on it.
    pub theta: f64,
    /// Nodal coordinates of the initial configuration. No quantity of a cable depends on them.
    pub e0: [f64; N],
    /// Nodal coordinates: in the order of (4), or rⁱ, r_xⁱ, rᵏ, r_xᵏ for a cable; m for positions.
    pub e: [f64; N],
    /// Rates of the nodal coordinates, m/s and 1/s.
    pub edot: [f64; N],
    /// Young's modulus, Pa.
    pub E: f64,
    /// Poisson's ratio. No quantity of a cable depends on it.
    pub nu: f64,
    /// Density, kg/m³.
    pub rho: f64,
    /// Coefficient of thermal expansion, 1/K.
    pub alpha: f64,
    /// Change of temperature, K.
    pub dT: f64,
    /// Directions of the thermal strain. For a cable 1D and 2D are equal.
    pub model: ThermalModel,
    /// Points (x, y) of the element at which point quantities are evaluated, m; y = 0 for a cable.
    pub points: Vec<[f64; 2]>,
    /// Gravity, m/s²; \[0, 0\] by default.
    #[serde(default)]
    pub gravity: [f64; 2],
}

/// State of the paper's element, as in `fixtures/equations.json`.
pub type ElementState = BeamState<14>;

/// State of the [`cable`](crate::equations::cable) element, as in `fixtures/cable.json`.
pub type CableState = BeamState<8>;

impl<const N: usize> BeamState<N> {
    /// Young's modulus and Poisson's ratio as one value.
    pub fn moduli(&self) -> YoungPoisson {
        YoungPoisson { E: self.E, nu: self.nu }
    }
}
