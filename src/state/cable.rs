//! The cable element in one state: the value of every function of [`cable`].

#![allow(non_snake_case)] // The symbols of the equations are names here.

use nalgebra::Vector2;

use super::beam::CableState;
use super::entries::rows;
use crate::equations::cable::{self, Vector8};
use crate::equations::motion;

/// Value of a `quantity` (`cable.…`) of `equations/contents.rs` for the state of a cable element.
///
/// Matrices row by row; point quantities one point after the other. `None` for an unknown quantity, and for the acceleration
/// where the mass matrix is not positive definite.
///
/// ```
/// use ancf::state::{CableState, evaluate_cable};
///
/// # let text = r#"{"l": 2.0, "h": 0.1, "w": 0.05, "theta": 0.0, "e0": [0, 0, 1, 0, 2, 0, 1, 0], "e": [0, 0, 1.1, 0, 2.2, 0, 1.1, 0],
/// #     "edot": [0, 0, 0, 0, 0, 0, 0, 0], "E": 2e8, "nu": 0.0, "rho": 7200.0, "alpha": 1e-5, "dT": 100.0, "model": "1d",
/// #     "points": [[0.5, 0.0]]}"#;
/// let state = CableState::parse(text, "cable.json")?; // stretched to 1.1 of its length, αΔT = 0.001
/// let epsilon = evaluate_cable("cable.epsilon", &state).unwrap();
/// assert!((epsilon[0] - (0.1 - 0.001)).abs() < 1e-15);
/// # Ok::<(), ancf::error::Error>(())
/// ```
pub fn evaluate_cable(quantity: &str, state: &CableState) -> Option<Vec<f64>> {
    let &CableState { l, h, w, E, rho, .. } = state;
    let (e, e_dot) = (Vector8::from(state.e), Vector8::from(state.edot));
    let (EA, EI, rho_A) = (E * h * w, E * w * h.powi(3) / 12.0, rho * h * w);
    let [eps_T, _] = state.model.strains(state.alpha * state.dT);

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
