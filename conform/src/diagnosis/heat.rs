//! Mistakes in the thermal strain.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::Vector3;

use super::candidate::{Candidate, possible};
use super::law::{HEATED, with_heat_and_law};
use super::mistake::MistakeKind::{self, Factor, Heat, HeatAlongX, HeatOnShear, Sign, SinCos};
use ancf::equations::strain;
use ancf::state::{ElementState, ThermalModel, evaluate};

/// Candidates with each of the wrong thermal strains.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    if !matches!(quantity, "8.epsilon_T" | "14.epsilon") && !HEATED.contains(&quantity) {
        return Vec::new();
    }
    // (21) for K_3 has the shear component alone: the others make no difference there.
    let matters = |(kind, what, _): &(MistakeKind, String, Vector3<f64>)| {
        quantity != "21.K_3" || *kind != HeatAlongX && !ONLY_ALONG_THE_AXES.iter().any(|axes| what.starts_with(axes))
    };
    strains(state)
        .into_iter()
        .filter(matters)
        .map(|(kind, what, eps_T)| possible(kind, what, move || with_heat(quantity, state, &eps_T)))
        .collect()
}

/// Beginnings of the names of strains whose shear component is zero, or right.
const ONLY_ALONG_THE_AXES: [&str; 4] = ["[0, αΔT, 0]", "cos θ", "no heat", "cos θ, sin θ without"];

/// Wrong thermal strains divided by αΔT, (11, 22, 12) in global axes.
fn directions(theta: f64) -> [(MistakeKind, &'static str, [f64; 3]); 11] {
    let (sin, cos) = theta.sin_cos();
    [
        (HeatOnShear, "αΔT on all three components", [1.0, 1.0, 1.0]),
        (HeatOnShear, "2 sin θ cos θ on the shear component", [cos * cos, sin * sin, 2.0 * sin * cos]),
        (HeatOnShear, "½ sin θ cos θ on the shear component", [cos * cos, sin * sin, 0.5 * sin * cos]),
        (HeatOnShear, "−sin θ cos θ on the shear component", [cos * cos, sin * sin, -sin * cos]),
        (Heat, "cos²θ, sin²θ without the shear component", [cos * cos, sin * sin, 0.0]),
        (HeatAlongX, "[αΔT, 0, 0]", [1.0, 0.0, 0.0]),
        (Heat, "[0, αΔT, 0]", [0.0, 1.0, 0.0]),
        (SinCos, "cos θ and sin θ exchanged", [sin * sin, cos * cos, sin * cos]),
        (Heat, "cos θ and sin θ for their squares", [cos, sin, sin * cos]),
        (Heat, "cos θ, sin θ without the shear component", [cos, sin, 0.0]),
        (Heat, "no heat", [0.0; 3]),
    ]
}

/// Wrong thermal strains of a state.
fn strains(state: &ElementState) -> Vec<(MistakeKind, String, Vector3<f64>)> {
    let heat = state.alpha * state.dT;
    let right = state.eps_T();
    let mut all = Vec::new();
    for (kind, what, direction) in directions(state.theta) {
        let wrong = heat * Vector3::from(direction);
        let model = state.model;
        let only = |wanted: ThermalModel| if model == wanted { wrong } else { right };
        all.push((kind, format!("{what}, 1D model"), only(ThermalModel::OneD)));
        all.push((kind, format!("{what}, 2D model"), only(ThermalModel::TwoD)));
        all.push((kind, format!("{what}, in both models"), if model == ThermalModel::None { right } else { wrong }));
    }
    let both = Vector3::new(heat, heat, 0.0);
    let along = strain::eps_T_1d(state.alpha, state.dT, state.theta);
    let where_heated = |wrong: Vector3<f64>| if state.model == ThermalModel::None { right } else { wrong };
    // Factor on αΔT; without heat there is none.
    let scaled = |factor: f64| if heat == 0.0 { right } else { right * factor };
    let stretch = (1.0 + 2.0 * heat).max(0.0).sqrt() - 1.0;
    let unit = |model| ElementState { alpha: 1.0, dT: 1.0, model, ..state.clone() }.eps_T();
    let only = |model: ThermalModel, wrong: Vector3<f64>| if state.model == model { wrong } else { right };
    let others = [
        (HeatOnShear, "αΔT on the shear component too", where_heated(right + Vector3::z() * heat)),
        (Heat, "2D heat in the 1D model", where_heated(both)),
        (Heat, "1D heat in the 2D model", where_heated(along)),
        (Heat, "2D heat where the model is none", if state.model == ThermalModel::None { both } else { right }),
        (Heat, "1D heat where the model is none", if state.model == ThermalModel::None { along } else { right }),
        (Sign, "heat with the wrong sign", -right),
        (Factor, "half of the heat: αΔT for 2αΔT", 0.5 * right),
        (Factor, "twice the heat", 2.0 * right),
        (Heat, "(1 + ν)αΔT: thermal strain of true plane strain", (1.0 + state.nu) * right),
        (Heat, "(1 + ν)αΔT in the 1D model", only(ThermalModel::OneD, (1.0 + state.nu) * right)),
        (Heat, "(1 + ν)αΔT in the 2D model: thermal strain of true plane strain", {
            only(ThermalModel::TwoD, (1.0 + state.nu) * right)
        }),
        (Heat, "|ΔT| for ΔT: cooling expands", scaled(state.dT.signum())),
        (Heat, "2D heat whatever the model", both),
        (Heat, "1D heat whatever the model", along),
        (Heat, "½((1 + αΔT)² − 1) for αΔT", scaled(1.0 + 0.5 * heat)),
        (Heat, "√(1 + 2αΔT) − 1 for αΔT", scaled(stretch / heat)),
        (Heat, "ΔT + 273.15: ΔT is a difference of temperatures", {
            unit(state.model) * state.alpha * (state.dT + 273.15)
        }),
        (Heat, "ΔT − 273.15: ΔT is a difference of temperatures", {
            unit(state.model) * state.alpha * (state.dT - 273.15)
        }),
    ];
    all.extend(others.map(|(kind, what, eps_T)| (kind, what.to_string(), eps_T)));
    all
}

/// Value of a quantity with another thermal strain.
fn with_heat(quantity: &str, state: &ElementState, eps_T: &Vector3<f64>) -> Option<Vec<f64>> {
    match quantity {
        "8.epsilon_T" => Some(eps_T.as_slice().to_vec()),
        "14.epsilon" => Some(
            evaluate("12.epsilon_f", state)?
                .chunks(3)
                .flat_map(|eps_f| eps_f.iter().zip(eps_T.iter()).map(|(f, t)| f - t).collect::<Vec<_>>())
                .collect(),
        ),
        _ => with_heat_and_law(quantity, state, eps_T, state.moduli().into()),
    }
}
