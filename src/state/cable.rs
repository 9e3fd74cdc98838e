//! One cable element in one state, as `fixtures/cable.json` has it, and the value of every function of [`cable`] for it.

use super::{ThermalModel, rows};
use crate::equations::cable::{self, Vector8};
use crate::equations::motion;
use nalgebra::Vector2;
use serde::{Deserialize, Serialize};

/// A state of the cable element. As [`ElementState`](super::ElementState), with its eight nodal coordinates; SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CableState {
    /// Length, m.
    pub l: f64,
    /// Height of the section (in the plane), m.
    pub h: f64,
    /// Width of the section (across the plane), m.
    pub w: f64,
    /// Initial inclination, rad. What this element computes does not depend on it.
    pub theta: f64,
    /// Nodal coordinates rⁱ, r_xⁱ, rᵏ, r_xᵏ of the initial configuration; not used either.
    pub e0: [f64; 8],
    /// Nodal coordinates.
    pub e: [f64; 8],
    /// Their rates.
    pub edot: [f64; 8],
    /// Young's modulus, Pa.
    pub E: f64,
    /// Poisson's ratio; not used.
    pub nu: f64,
    /// Density, kg/m³.
    pub rho: f64,
    /// Coefficient of thermal expansion, 1/K.
    pub alpha: f64,
    /// Change of temperature, K.
    pub dT: f64,
    /// Whether there is heat: 1D and 2D are the same for an axis.
    pub model: ThermalModel,
    /// Points (x, 0) of the axis at which point quantities are evaluated, m.
    pub points: Vec<[f64; 2]>,
    /// Gravity, m/s²; \[0, 0\] where left out.
    #[serde(default)]
    pub gravity: [f64; 2],
}

/// The value of a quantity `cable.…` of [`CONTENTS`](crate::equations::CONTENTS), row by row; for a point quantity one point
/// after the other. `None` where there is no such quantity.
pub fn evaluate_cable(quantity: &str, state: &CableState) -> Option<Vec<f64>> {
    let &CableState { l, h, w, E, rho, .. } = state;
    let (e, e_dot) = (Vector8::from(state.e), Vector8::from(state.edot));
    let (EA, EI, rho_A) = (E * h * w, E * w * h.powi(3) / 12.0, rho * h * w);
    let eps_T = match state.model {
        ThermalModel::None => 0.0,
        ThermalModel::OneD | ThermalModel::TwoD => state.alpha * state.dT,
    };

    let at_points = |f: &dyn Fn(f64) -> Vec<f64>| Some(state.points.iter().flat_map(|&[x, _]| f(x)).collect());
    let (r_x, r_xx) = (|x| cable::r_x(x, &e, l), |x| cable::r_xx(x, &e, l));
    let M = || cable::M(rho_A, l);
    let Q_e = || cable::Q_e(&e, eps_T, EA, EI, l);
    let Q_w = || cable::Q_w_gravity(&Vector2::from(state.gravity), rho_A, l);

    match quantity {
        "cable.S" => at_points(&|x| cable::S_i(x, l).to_vec()),
        "cable.S_x" => at_points(&|x| cable::S_i_x(x, l).to_vec()),
        "cable.S_xx" => at_points(&|x| cable::S_i_xx(x, l).to_vec()),
        "cable.r" => at_points(&|x| rows(&cable::r(x, &e, l))),
        "cable.r_x" => at_points(&|x| rows(&r_x(x))),
        "cable.r_xx" => at_points(&|x| rows(&r_xx(x))),
        "cable.epsilon" => at_points(&|x| vec![cable::epsilon(&r_x(x), eps_T)]),
        "cable.kappa" => at_points(&|x| vec![cable::kappa(&r_x(x), &r_xx(x))]),
        "cable.T" => Some(vec![cable::T(&M(), &e_dot)]),
        "cable.M" => Some(rows(&M())),
        "cable.U" => Some(vec![cable::U(&e, eps_T, EA, EI, l)]),
        "cable.Q_e" => Some(rows(&Q_e())),
        "cable.tangent" => Some(rows(&cable::tangent(&e, eps_T, EA, EI, l))),
        "cable.Q_w" => Some(rows(&Q_w())),
        "cable.eddot" => Some(rows(&motion::acceleration(&M(), &Q_e(), &Q_w())?)),
        _ => None,
    }
}
