//! The scene file: defaults, built-in scenes, round trip, and what is derived from its numbers.

use ancf::error::Error;
use ancf::scene::{
    Direction, Method, Output, Quantity, Rod, Scene, Start, Temperature, ThermalModel, builtin_names, builtin_text,
};

/// The required keys, and nothing else.
const SMALLEST: &str = r#"{
  "schema": "ancf-scene/1",
  "material": {"E": 1, "nu": 0, "rho": 2},
  "section": {"height": 3, "width": 4},
  "points": {"p": [0, 0], "q": [5, 6]},
  "rods": [{"name": "r", "from": "p", "to": "q"}],
  "time": {"end": 0.25}
}"#;

/// [`SMALLEST`] with more keys at its top.
fn with(keys: &str) -> Scene {
    Scene::parse(&SMALLEST.replacen('{', &format!("{{{keys},"), 1), "test").unwrap()
}

#[test]
fn what_is_left_out_is_absent_or_at_its_default() {
    let scene = Scene::parse(SMALLEST, "test").unwrap();
    assert_eq!(scene.title, "");
    assert_eq!(scene.material.alpha, 0.0);
    assert_eq!(scene.rods, [Rod { name: "r".into(), from: "p".into(), to: "q".into(), elements: 8 }]);
    assert_eq!((scene.supports.len(), scene.probes.len(), scene.gravity), (0, 0, [0.0, 0.0]));
    assert_eq!(scene.temperature, None);
    assert_eq!((scene.time.step, scene.time.method), (1e-3, Method::GeneralizedAlpha));
    assert_eq!((scene.time.rho_inf, scene.time.newton_tolerance), (0.9, 1e-10));
    assert_eq!(scene.output, Output { interval: None, energy: true });
    assert_eq!((scene.steps(), scene.rows_every()), (250, 1));
}

#[test]
fn heat_without_words_is_2d_and_sudden() {
    let text = SMALLEST.replace("\"rho\": 2", "\"rho\": 2, \"alpha\": 1e-5");
    let scene = Scene::parse(&text.replacen('{', "{\"temperature\": {\"history\": [[0, 9]]},", 1), "test").unwrap();
    let history = vec![[0.0, 9.0]];
    let expected = Temperature { model: ThermalModel::TwoD, start: Start::Sudden, history };
    assert_eq!(scene.heat(), Some(&expected));
}

#[test]
fn model_none_heats_nothing_and_needs_neither_alpha_nor_history() {
    for temperature in
        [r#""temperature": {"model": "none"}"#, r#""temperature": {"model": "none", "history": [[0, 9]]}"#]
    {
        let scene = with(temperature);
        assert!(scene.temperature.is_some());
        assert_eq!(scene.heat(), None);
    }
}

/// 1 + 2αΔT = 0.005: cold, but positive.
#[test]
fn cold_is_allowed_down_to_the_limit_of_the_strain_measure() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    scene.material.alpha = 2.5e-5;
    scene.temperature.as_mut().unwrap().history = vec![[0.0, -19_900.0]];
    scene.validate("cold").unwrap();
}

#[test]
fn keys_may_come_in_any_order_and_numbers_in_any_form() {
    let text = r#"{"time": {"step": 25E-2, "end": 5e-1}, "rods": [{"to": "b", "elements": 1, "from": "a", "name": "r"}],
        "points": {"b": [1, 0], "a": [0.0e0, -0]}, "section": {"width": 1, "height": 1},
        "material": {"rho": 1, "nu": -0.5, "E": 1}, "schema": "ancf-scene\/1"}"#;
    let scene = Scene::parse(text, "test").unwrap();
    assert_eq!((scene.steps(), scene.points["b"], scene.material.nu), (2, [1.0, 0.0], -0.5));
}

#[test]
fn a_scene_reads_back_from_its_own_json() {
    let awkward = with(
        r#""gravity": [0.1, -3.3333333333333335e-1], "supports": [{"point": "q", "fix": ["y", "x"]}],
        "temperature": {"model": "none", "start": "relaxed", "history": [[-1, 0.30000000000000004], [2, -5e-324]]},
        "output": {"interval": 0.025, "energy": false}, "title": "\"ΔT\"",
        "probes": [{"name": "a probe's name", "point": "p", "of": ["acceleration", "position", "velocity"]}]"#,
    );
    let builtin = builtin_names().map(|name| Scene::builtin(name).unwrap());
    for scene in builtin.chain([awkward]) {
        let text = serde_json::to_string(&scene).unwrap();
        assert_eq!(Scene::parse(&text, "round trip").unwrap(), scene);
    }
}

#[test]
fn names_of_the_builtin_scenes() {
    let expected = [
        "pendulum-flexible",
        "pendulum-1d",
        "pendulum-2d",
        "pendulum-1d-relaxed",
        "pendulum-2d-relaxed",
        "free-rod-heated",
    ];
    assert_eq!(builtin_names().collect::<Vec<_>>(), expected);
    assert!(Scene::builtin("pendulum").is_none());
}

/// Table 1 of the paper and the text beside it: L = 1 m, A = 0.02 × 0.02 m², ρ = 7750 kg/m³, E = 2e8 N/m², ν = 0,
/// α = 2.85e-5 1/K, g = 9.8 m/s², from the horizontal; 200 K.
#[test]
fn builtin_pendulums_are_those_of_table_1() {
    let models = [
        ("pendulum-flexible", None),
        ("pendulum-1d", Some((ThermalModel::OneD, Start::Sudden))),
        ("pendulum-2d", Some((ThermalModel::TwoD, Start::Sudden))),
        ("pendulum-1d-relaxed", Some((ThermalModel::OneD, Start::Relaxed))),
        ("pendulum-2d-relaxed", Some((ThermalModel::TwoD, Start::Relaxed))),
    ];
    for (name, heat) in models {
        let scene = Scene::load(name).unwrap();
        let material = &scene.material;
        let numbers = [material.youngs_modulus, material.nu, material.rho, material.alpha];
        assert_eq!(numbers, [2e8, 0.0, 7750.0, 2.85e-5]);
        assert_eq!([scene.section.height, scene.section.width], [0.02, 0.02]);
        assert_eq!((scene.points["o"], scene.points["a"], scene.gravity), ([0.0, 0.0], [1.0, 0.0], [0.0, -9.8]));
        let [rod] = scene.rods.as_slice() else { panic!("{name}: one rod") };
        assert_eq!((rod.from.as_str(), rod.to.as_str(), rod.elements), ("o", "a", 8));
        let [support] = scene.supports.as_slice() else { panic!("{name}: one support") };
        assert_eq!((support.point.as_str(), support.fix.as_slice()), ("o", &[Direction::X, Direction::Y][..]));
        assert_eq!(scene.heat().map(|heat| (heat.model, heat.start)), heat);
        assert!(scene.heat().is_none_or(|heat| heat.history == [[0.0, 200.0]]));
        // The waves of sudden heat ask for short steps.
        let sudden = heat.is_some_and(|(_, start)| start == Start::Sudden);
        let time = if sudden { (Method::Explicit, 100_000, 500) } else { (Method::EnergyMomentum, 8000, 40) };
        assert_eq!((scene.time.method, scene.steps(), scene.rows_every()), time);
        let energies = ["energy.kinetic", "energy.strain", "energy.potential", "energy.input", "energy.balance"];
        assert_eq!(scene.columns()[..5], ["t", "tip.x", "tip.y", "tip.vx", "tip.vy"]);
        assert_eq!(scene.columns()[5..], energies);
        assert!(scene.title.contains("Table 1"), "the title says where the numbers come from");
    }
}

#[test]
fn builtin_free_rod_is_free_inclined_and_relaxed() {
    let scene = Scene::builtin("free-rod-heated").unwrap();
    assert!(scene.supports.is_empty() && scene.gravity == [0.0, 0.0]);
    assert_eq!(scene.points["a"], [0.6, 0.8]);
    assert_eq!(scene.heat().unwrap().start, Start::Relaxed);
    assert_eq!(scene.columns()[..5], ["t", "from.x", "from.y", "to.x", "to.y"]);
}

#[test]
fn builtin_text_is_the_scene() {
    for name in builtin_names() {
        assert_eq!(Scene::parse(builtin_text(name).unwrap(), name).unwrap(), Scene::builtin(name).unwrap());
    }
    let message = builtin_text("pendulum-3d").unwrap_err().to_string();
    assert!(message.contains("the nearest is `pendulum-2d`") || message.contains("`pendulum-1d`"), "{message}");
}

#[test]
fn history_is_piecewise_linear_and_constant_outside() {
    let history = vec![[0.25, 0.0], [1.25, 150.0], [1.75, -150.0]];
    let temperature = Temperature { model: ThermalModel::TwoD, start: Start::Sudden, history };
    let cases = [
        (-1.0, 0.0),
        (0.25, 0.0),
        (0.5, 37.5),
        (1.25, 150.0),
        (1.5, 0.0),
        (1.625, -75.0),
        (1.75, -150.0),
        (9.0, -150.0),
    ];
    for (t, expected) in cases {
        assert_eq!(temperature.at(t), expected, "at {t} s");
    }
    assert_eq!(Temperature { history: vec![[3.0, 7.0]], ..temperature.clone() }.at(0.0), 7.0);
    assert_eq!(Temperature { history: vec![], ..temperature }.at(0.0), 0.0);
}

#[test]
fn columns_are_in_the_order_of_the_probes() {
    let scene = with(
        r#""output": {"energy": false}, "probes": [
        {"name": "b", "point": "q", "of": ["acceleration", "position"]}, {"name": "a", "point": "q", "of": ["velocity"]}]"#,
    );
    assert_eq!(scene.probes[0].of, [Quantity::Acceleration, Quantity::Position]);
    assert_eq!(scene.columns(), ["t", "b.ax", "b.ay", "b.x", "b.y", "a.vx", "a.vy"]);
}

#[test]
fn rows_are_the_first_each_interval_and_the_last() {
    let scene = with(r#""output": {"interval": 0.1}"#);
    assert_eq!((scene.steps(), scene.rows_every()), (250, 100));
    assert_eq!((0..=250).filter(|&step| scene.is_row(step)).collect::<Vec<_>>(), [0, 100, 200, 250]);
}

/// Steps that are whole in decimals, but not in binary.
#[test]
fn rounding_does_not_refuse_a_whole_number_of_steps() {
    for (end, step, steps) in
        [("0.3", "0.1", 3), ("2.0", "2.5e-4", 8000), ("1.1", "1.1e-6", 1_000_000), ("1", "3.3333333333e-1", 3)]
    {
        let text = SMALLEST.replace("\"end\": 0.25", &format!("\"end\": {end}, \"step\": {step}"));
        assert_eq!(Scene::parse(&text, "test").map(|scene| scene.steps()).unwrap(), steps);
    }
    // Six digits of a third are a third no more.
    let text = SMALLEST.replace("\"end\": 0.25", "\"end\": 1, \"step\": 0.333333");
    assert!(matches!(Scene::parse(&text, "test"), Err(Error::Scene { key, .. }) if key == "time.end"));
}

#[test]
fn a_scene_changed_in_memory_can_be_validated() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    scene.validate("mine").unwrap();
    scene.time.step = f64::NAN;
    let message = scene.validate("mine").unwrap_err().to_string();
    assert_eq!(message, "mine: `time.step` is NaN; allowed: a finite number over 0");
    scene.time.step = 1e-3;
    scene.points.insert("a".into(), [f64::INFINITY, 0.0]);
    assert!(matches!(scene.validate("mine"), Err(Error::Scene { key, .. }) if key == "points.a[0]"));
}
