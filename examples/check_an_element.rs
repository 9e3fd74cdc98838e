//! Checking an element of one's own against the fixtures in a unit test: here the paper's element written in another way, in the rod's
//! own axes, with its strain energy.
//!
//! `cargo run --release --example check_an_element`; the test below: `cargo test --example check_an_element`

use std::process::ExitCode;

use ancf::model::ThermalModel;
use ancf::state::ElementState;
use serde_json::Value;

/// Gauss points and weights on [−1, 1], exact to degree 9 and 5.
const ALONG: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];
const ACROSS: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
    (0.0, 0.888_888_888_888_888_8),
    (0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
];

/// ∂r/∂x and ∂r/∂y at x = l (1 + s)/2: the axis is a cubic through three nodes with the slope of the middle one, r_y a parabola.
fn gradient(s: f64, y: f64, e: &[f64; 14], l: f64) -> [[f64; 2]; 2] {
    let vector = |n: usize| [e[2 * n], e[2 * n + 1]];
    let [r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k] = [0, 1, 2, 3, 4, 5, 6].map(vector);
    let at = |c: usize| {
        let (slope, square) = (0.5 * l * r_x_j[c], 0.5 * (r_i[c] + r_k[c]) - r_j[c]);
        let cube = 0.5 * (r_k[c] - r_i[c]) - slope;
        let (linear, bow) = (0.5 * (r_y_k[c] - r_y_i[c]), 0.5 * (r_y_i[c] + r_y_k[c]) - r_y_j[c]);
        let axis_s = slope + 2.0 * square * s + 3.0 * cube * s * s;
        [2.0 / l * (axis_s + y * (linear + 2.0 * bow * s)), r_y_j[c] + linear * s + bow * s * s]
    };
    let ([x_x, x_y], [y_x, y_y]) = (at(0), at(1));
    [[x_x, y_x], [x_y, y_y]]
}

/// Strain energy of St Venant–Kirchhoff's law, J: ∫ ½ λ (tr ε)² + μ ε : ε dV, with ε = ½ (FᵀF − I) − ε_T.
fn strain_energy(state: &ElementState) -> f64 {
    let &ElementState { l, h, w, E: modulus, nu, .. } = state;
    let (lambda, mu) = (modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 * modulus / (1.0 + nu));
    let expansion = state.alpha * state.dT;
    let [heat_x, heat_y] = match state.model {
        ThermalModel::TwoD => [expansion, expansion],
        ThermalModel::OneD => [expansion, 0.0],
        ThermalModel::None => [0.0, 0.0],
        other => panic!("{other}: not known to this element"),
    };
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let mut energy = 0.0;
    for (s, along) in ALONG {
        for (t, across) in ACROSS {
            let [r_x, r_y] = gradient(s, 0.5 * h * t, &state.e, l);
            let (xx, yy) = (0.5 * (dot(r_x, r_x) - 1.0) - heat_x, 0.5 * (dot(r_y, r_y) - 1.0) - heat_y);
            let xy = 0.5 * dot(r_x, r_y);
            let density = 0.5 * lambda * (xx + yy).powi(2) + mu * (xx * xx + yy * yy + 2.0 * xy * xy);
            energy += density * 0.25 * l * h * along * across * w;
        }
    }
    energy
}

/// Name of each state, the element's value, the reference and the allowed difference.
fn compare(quantity: &str, own: impl Fn(&ElementState) -> f64) -> Vec<(String, f64, f64, f64)> {
    let fixture: Value = serde_json::from_str(ancf_fixtures::EQUATIONS).expect("the fixture is JSON");
    let states = fixture["states"].as_array().expect("it has states");
    let compared = states.iter().map(|case| {
        let state: ElementState = serde_json::from_value(case["state"].clone()).expect("a state");
        let reference = &case["values"][quantity];
        let [expected, allowed] = ["f64", "absolute"].map(|key| reference[key].as_f64().expect("a number"));
        (case["id"].as_str().expect("a name").to_string(), own(&state), expected, allowed)
    });
    compared.collect()
}

fn main() -> ExitCode {
    let mut all_right = true;
    for (id, own, expected, allowed) in compare("18.U", strain_energy) {
        let is_right = (own - expected).abs() <= allowed;
        all_right &= is_right;
        let verdict = if is_right { "right" } else { "WRONG" };
        println!("{verdict}  {id:30} {own:+.12e} J, reference {expected:+.12e} J, allowed {allowed:.0e} J");
    }
    if all_right { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strain_energy_is_right_in_every_state() {
        for (id, own, expected, allowed) in compare("18.U", strain_energy) {
            assert!((own - expected).abs() <= allowed, "{id}: {own} J, reference {expected} J");
        }
    }
}
