//! `"form": "printed-shear"`: the paper's element with the shear counted once (E3), as a structure runs it.
//!
//! Source: the oracle's values of the printed energy, force and tangent; sections by hand. Goal: whoever asks what the printed
//! term does to a scene of theirs gets that element and no other, from statics and from every method.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;
#[path = "common/states.rs"]
mod states;

use ancf::equations::material::LameConstants;
use ancf::equations::shape::Vector14;
use ancf::internals::elements::{Beam, Ends, PrintedShear};
use ancf::model::Model;
use ancf::run::{Run, run};
use ancf::state::ThermalModel;
use common::scale::scale;
use common::{Equations, TOLERANCE, within, worst_ratio};
use nalgebra::SMatrix;
use proptest::prelude::*;
use states::{State, assert_within, cases, five_point, rows, states, unit};

#[test]
fn the_element_meets_the_oracle() {
    for case in Equations::load().cases() {
        let s = &case.state;
        let element = PrintedShear::new(
            s.l,
            s.h,
            s.w,
            s.theta,
            LameConstants { lambda: case.scalar("17.lambda"), mu: case.scalar("17.mu") },
        );
        let heat = s.alpha * s.dT;
        let eps_T = match s.model {
            ThermalModel::TwoD => [heat, heat],
            ThermalModel::OneD => [heat, 0.0],
            _ => [0.0, 0.0],
        };
        let u = Vector14::from(s.e) - Vector14::from(s.e0);
        for (quantity, actual) in [
            ("18.U/printed-shear", vec![element.energy(&u, eps_T)]),
            ("19.Q_e/printed-shear", element.force(&u, eps_T).as_slice().to_vec()),
            ("tangent.dQ_e/printed-shear", rows(&element.tangent(&u, eps_T))),
        ] {
            let (expected, scale) = (case.value(quantity), scale(quantity, &case));
            let ratio = worst_ratio(&actual, &expected, &scale);
            assert!(within(TOLERANCE, &actual, &expected, &scale), "{quantity} {}: {ratio:.1e}", case.id);
        }
    }
}

fn element(s: &State) -> PrintedShear {
    PrintedShear::new(s.l, s.h, s.w, s.theta, s.lame())
}

fn displacements(s: &State) -> [Vector14; 2] {
    [0, 1].map(|time| s.e(time) - s.element().e_0)
}

fn ends<'a>(s: &State, u: &'a [Vector14; 2]) -> Ends<'a, Vector14> {
    Ends { u_0: &u[0], u_1: &u[1], thermal_0: s.eps_T_own(0), thermal_1: s.eps_T_own(1) }
}

proptest! {
    #![proptest_config(cases(32))]

    /// Q̄·(u₁ − u₀) + heating work = U₁ − U₀, as in `kernel.rs`; four energies, and two more for their differences in ε_T.
    #[test]
    fn the_mean_force_does_the_work_of_the_step(s in states()) {
        let (element, u) = (element(&s), displacements(&s));
        let ends = ends(&s, &u);
        let work = element.mean_force(&ends).dot(&(u[1] - u[0])) + element.heating_work(&ends);
        let change = element.energy(&u[1], ends.thermal_1) - element.energy(&u[0], ends.thermal_0);
        let sizes = s.sizes(&s.e(0).abs().sup(&s.e(1).abs()));
        assert_within("work", &[work], &[change], &[6.0 * sizes.energy()]);
    }

    /// Q̄ is cubic in u₁, so the five-point difference is exact.
    #[test]
    fn the_mean_tangent_is_a_derivative(s in states()) {
        let (element, u) = (element(&s), displacements(&s));
        let sizes = s.sizes(&s.e(0).abs().sup(&s.e(1).abs())).beyond(2.0);
        let (D, force) = (sizes.D, sizes.force());
        let columns: [Vector14; 14] = std::array::from_fn(|i| {
            five_point(|step| element.mean_force(&ends(&s, &[u[0], u[1] + unit(i, step)])), 1.0 / D[i])
        });
        let scale: Vec<f64> = force.iter().flat_map(|f| D.map(|d| 1.5 * f * d)).collect();
        let tangent = element.mean_tangent(&ends(&s, &u));
        assert_within("∂Q̄/∂u₁", &rows(&tangent), &rows(&SMatrix::from_columns(&columns)), &scale);
    }

    /// The force at `u` of the strains that a linear change from `before` expects is K(expected) e. Along d the strains are
    /// quadratic, so that what is expected at u + d of a step that starts there is their tangent: at `before` = `u` nothing is missing,
    /// and two steps in opposite directions miss the same, K of the square of the step.
    #[test]
    fn the_mixed_tangent_leaves_out_the_square_of_the_step(s in states()) {
        let (element, [u, v], eps_T) = (element(&s), displacements(&s), s.eps_T_own(0));
        let sizes = s.sizes(&s.e(0).abs().sup(&s.e(1).abs())).beyond(2.0);
        let own = rows(&element.mixed_tangent(&u, &u, eps_T));
        assert_within("at u", &own, &rows(&element.tangent(&u, eps_T)), &sizes.tangent());
        let d = v - u;
        let missed = |d: Vector14| element.tangent(&u, eps_T) - element.mixed_tangent(&(u - d), &u, eps_T);
        assert_within("±", &rows(&missed(d)), &rows(&missed(-d)), &sizes.tangent());
        assert_within("square", &rows(&missed(0.5 * d)), &rows(&(0.25 * missed(d))), &sizes.tangent());
    }
}

/// A clamped rod of 1 m × 10 mm in the direction `degrees`, with a force at its tip along it and across it.
fn cantilever(form: &str, degrees: f64, [along, across]: [f64; 2], time: &str) -> Run {
    let (sin, cos) = f64::to_radians(degrees).sin_cos();
    let force = [along * cos - across * sin, along * sin + across * cos];
    let text = format!(
        r#"{{"schema": "ancf-scene/1", "form": "{form}",
            "material": {{"E": 2e8, "nu": 0.0, "rho": 7750.0}}, "section": {{"height": 0.01, "width": 0.01}},
            "points": {{"o": [0, 0], "a": [{cos}, {sin}]}},
            "rods": [{{"name": "rod", "from": "o", "to": "a", "elements": 4}}],
            "supports": [{{"point": "o", "fix": ["x", "y"], "clamp": "rod"}}],
            "forces": [{{"point": "a", "force": {force:?}}}],
            "time": {time}, "probes": [{{"name": "a", "point": "a", "of": ["position"]}}]}}"#
    );
    run(Model::parse(&text, "cantilever").unwrap().into_scene()).unwrap()
}

/// How far the tip goes along the rod and across it.
fn tip(run: &Run, degrees: f64) -> [f64; 2] {
    let row = |rows: &[f64]| [rows[1], rows[2]];
    let (first, last) = (row(&run.trajectory.rows[0]), row(run.trajectory.rows.last().unwrap()));
    let ([x, y], (sin, cos)) = ([last[0] - first[0], last[1] - first[1]], f64::to_radians(degrees).sin_cos());
    [x * cos + y * sin, y * cos - x * sin]
}

/// At 45° compliance is 1/(1 − ¼) in bending and (1 − ¼)/(1 − ½) along the axis of what it is at 0°, as derived in the case of the
/// stiff table; shear, 1/100 of the height a length, takes at most (h/L)² of either.
#[test]
fn inclined_rods_give_in() {
    let statics = r#"{"method": "static", "load_steps": 1}"#;
    for (force, of, factor) in [([0.0, 1e-6], 1, 4.0 / 3.0), ([1e-3, 0.0], 0, 1.5)] {
        let moved = |form, degrees| tip(&cantilever(form, degrees, force, statics), degrees)[of];
        let consistent = moved("consistent", 45.0) / moved("consistent", 0.0);
        let printed = moved("printed-shear", 45.0) / moved("printed-shear", 0.0);
        assert!((consistent - 1.0).abs() < 1e-6, "{consistent}");
        assert!((printed - factor).abs() < 1e-4 * factor, "{printed}, not {factor}");
    }
}

/// The energy is another one, and kept all the same; a sign of a force and a tangent that fit it.
#[test]
fn motions_keep_the_printed_energy() {
    // Measured: 9e-13, 7e-9, 2e-7.
    for (method, allowed) in [("energy-momentum", 1e-11), ("gauss", 1e-7), ("explicit", 2e-6)] {
        let step = if method == "explicit" { 1e-5 } else { 1e-3 };
        let time = format!(r#"{{"end": 0.02, "step": {step}, "method": "{method}"}}"#);
        let run = cantilever("printed-shear", 30.0, [0.0, -0.05], &time);
        let size = |name: &str| run.trajectory.column(name).unwrap().iter().fold(0.0, |most: f64, e| most.max(e.abs()));
        let balance = size("energy.balance") / size("energy.kinetic");
        assert!(balance < allowed, "{method}: {balance:e}");
        assert!(run.warnings.iter().any(|warning| warning.contains("printed-shear")), "{:?}", run.warnings);
    }
}

#[test]
fn only_the_papers_element_is_printed() {
    let text = |rod: &str| {
        format!(
            r#"{{"schema": "ancf-scene/1", "form": "printed-shear", "material": {{"E": 2e8, "nu": 0.0, "rho": 7750.0}},
                "section": {{"height": 0.01, "width": 0.01}}, "points": {{"o": [0, 0], "a": [1, 0]}},
                "rods": [{{"name": "rod", "from": "o", "to": "a", {rod}}}], "time": {{"end": 0.01}}}}"#
        )
    };
    assert!(Model::parse(&text(r#""elements": 2"#), "scene").is_ok());
    for rod in [r#""element": "euler-bernoulli""#, r#""poisson": "axis""#, r#""law": "uniaxial""#] {
        let message = Model::parse(&text(rod), "scene").unwrap_err().to_string();
        assert!(message.contains("form") && message.contains("`rod`"), "{message}");
    }
}
