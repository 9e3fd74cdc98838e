//! The scene file: defaults, built-in scenes, round trip, and what is derived from its numbers.

use ancf::error::Error;
use ancf::internals::model::{Scissors, builtin_names, builtin_text};
use ancf::model::{
    Constraints, Direction, Element, Force, Material, Method, Model, Output, Poisson, Probe, Quantity, Rod, Scene,
    Section, Start, Support, Temperature, ThermalModel,
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
    Model::parse(&SMALLEST.replacen('{', &format!("{{{keys},"), 1), "test").unwrap().into_scene()
}

#[test]
fn what_is_left_out_is_absent_or_at_its_default() {
    let scene = Model::parse(SMALLEST, "test").unwrap().into_scene();
    assert_eq!(scene.title, "");
    assert_eq!(scene.material.alpha, 0.0);
    let [rod] = &scene.rods[..] else { panic!("{:?}", scene.rods) };
    assert_eq!([&rod.name, &rod.from, &rod.to], ["r", "p", "q"]);
    assert_eq!((rod.elements, rod.element, rod.poisson), (8, Element::Ancf, Poisson::Full));
    assert_eq!((&rod.pivot, &rod.material, &rod.section, &rod.temperature), (&None, &None, &None, &None));
    assert_eq!((scene.supports.len(), scene.probes.len(), scene.gravity), (0, 0, [0.0, 0.0]));
    assert_eq!((scene.forces.len(), scene.notes.len(), scene.constraints), (0, 0, Constraints::Condensed));
    assert_eq!(scene.time.load_steps, 10);
    assert_eq!(scene.temperature, None);
    assert_eq!((scene.time.step, scene.time.method), (1e-3, Method::GeneralizedAlpha));
    assert_eq!((scene.time.rho_inf, scene.time.newton_tolerance), (0.9, 1e-10));
    assert_eq!(scene.output, Output { interval: None, energy: true, shapes: None });
    assert_eq!((scene.steps(), scene.rows_every()), (250, 1));
}

/// Section of [`SMALLEST`] with other keys.
fn section(keys: &str) -> Result<Section, String> {
    let text = SMALLEST.replace("\"height\": 3, \"width\": 4", keys);
    Model::parse(&text, "test").map(|model| model.into_scene().section).map_err(|error| error.to_string())
}

/// Of the area A and the inertia I: h = √(12 I/A), w = A/h, so that h w = A and w h³/12 = I.
#[test]
fn a_section_is_given_by_its_sides_or_by_area_and_inertia() {
    assert_eq!(section(r#""width": 4, "height": 3"#), Ok(Section::new(3.0, 4.0)));
    // 3 · 4 = 12 and 4 · 3³/12 = 9.
    assert_eq!(section(r#""area": 12, "inertia": 9"#), Ok(Section::new(3.0, 4.0)));
    for (keys, words) in [
        ("", "`section.height` is missing"),
        (r#""height": 3"#, "`section.width` is missing"),
        (r#""area": 3"#, "`section.inertia` is missing"),
        (r#""inertia": 3"#, "`section.area` is missing"),
        (r#""area": 0, "inertia": 1"#, "an `area` and an `inertia` over 0"),
        (r#""area": 1, "height": 1"#, "either `height` and `width`, or `area` and `inertia`"),
        (r#""area": 1, "inertia": 1, "height": 1, "width": 1"#, "either `height` and `width`, or `area` and `inertia`"),
        (r#""area": "1", "inertia": 1"#, "`section.area` is \"1\"; allowed: a number"),
        (r#""height": -1, "width": 1"#, "`section.height` is -1"),
    ] {
        let error = section(keys).unwrap_err();
        assert!(error.contains(words), "{keys}: {error}");
    }
}

/// A tube, 16 mm outside and 12 mm inside, as a cantilever under a small load P across: PL³/3EI, to which the paper's element adds the
/// shear of the equivalent rectangle, PL/GA.
#[test]
#[allow(non_snake_case)] // The symbols of mechanics are names here.
fn a_tube_bends_as_its_area_and_inertia_say() {
    let [outside, inside] = [0.016_f64, 0.012];
    let area = std::f64::consts::PI / 4.0 * (outside.powi(2) - inside.powi(2));
    let inertia = std::f64::consts::PI / 64.0 * (outside.powi(4) - inside.powi(4));
    let (E, L, P) = (7e10, 1.0, 1e-4);
    for (element, shear) in [(Element::EulerBernoulli, 0.0), (Element::Ancf, P * L / (0.5 * E * area))] {
        let mut scene = Scene::builtin("cantilever").unwrap();
        (scene.material, scene.section) = (Material::new(E, 0.0, 2700.0), Section::of_area(area, inertia));
        (scene.rods[0].element, scene.rods[0].elements, scene.forces[0].force) = (element, 2, [0.0, -P]);
        let run = ancf::run::run(&scene).unwrap();
        let tip = *run.trajectory.column("tip.y").unwrap().last().unwrap();
        let expected = -(P * L.powi(3) / (3.0 * E * inertia) + shear);
        assert!((tip / expected - 1.0).abs() <= 1e-6, "{element}: {tip:e}, expected {expected:e}");
    }
}

#[test]
fn heat_without_words_is_2d_and_sudden() {
    let text = SMALLEST.replace("\"rho\": 2", "\"rho\": 2, \"alpha\": 1e-5");
    let scene = Model::parse(&text.replacen('{', "{\"temperature\": {\"history\": [[0, 9]]},", 1), "test")
        .unwrap()
        .into_scene();
    let history = vec![[0.0, 9.0]];
    let expected = Temperature { model: ThermalModel::TwoD, start: Start::Sudden, history };
    assert_eq!(scene.heat(&scene.rods[0]), Some(&expected));
}

#[test]
fn model_none_heats_nothing_and_needs_neither_alpha_nor_history() {
    for temperature in
        [r#""temperature": {"model": "none"}"#, r#""temperature": {"model": "none", "history": [[0, 9]]}"#]
    {
        let scene = with(temperature);
        assert!(scene.temperature.is_some());
        assert_eq!(scene.heat(&scene.rods[0]), None);
    }
}

/// 1 + 2αΔT = 0.005: cold, but positive.
#[test]
fn cold_is_allowed_down_to_the_limit_of_the_strain_measure() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    scene.material.alpha = 2.5e-5;
    scene.temperature.as_mut().unwrap().history = vec![[0.0, -19_900.0]];
    scene.clone().build().unwrap();
}

#[test]
fn keys_may_come_in_any_order_and_numbers_in_any_form() {
    let text = r#"{"time": {"step": 25E-2, "end": 5e-1}, "rods": [{"to": "b", "elements": 1, "from": "a", "name": "r"}],
        "points": {"b": [1, 0], "a": [0.0e0, -0]}, "section": {"width": 1, "height": 1},
        "material": {"rho": 1, "nu": -0.5, "E": 1}, "schema": "ancf-scene\/1"}"#;
    let scene = Model::parse(text, "test").unwrap().into_scene();
    assert_eq!((scene.steps(), scene.points["b"], scene.material.nu), (2, [1.0, 0.0], -0.5));
}

#[test]
fn a_scene_reads_back_from_its_own_json() {
    let awkward = with(
        r#""gravity": [0.1, -3.3333333333333335e-1], "supports": [{"point": "q", "fix": ["y", "x"]}],
        "temperature": {"model": "none", "start": "relaxed", "history": [[-1, 0.30000000000000004], [2, -5e-324]]},
        "output": {"interval": 0.025, "energy": false}, "title": "\"ΔT\"",
        "notes": ["a \\ and [1, {2: \"x\"}]", "ε"],
        "forces": [{"point": "q", "force": [1e-300, -2], "history": [[0, 0.1], [1, 1]]}],
        "probes": [{"name": "a probe's name", "point": "p", "of": ["acceleration", "position", "velocity"]},
            {"name": "d", "rod": "r", "at": 0.3, "of": ["deflection"]}]"#,
    );
    let builtin = builtin_names().map(|name| Scene::builtin(name).unwrap());
    for scene in builtin.chain([awkward]) {
        let text = serde_json::to_string(&scene).unwrap();
        assert_eq!(Model::parse(&text, "round trip").unwrap().into_scene(), scene);
        assert_eq!(Model::parse(&scene.to_text(), "text for people").unwrap().into_scene(), scene);
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
        "scissors-3",
        "scissors-3-thermal",
        "cantilever",
        "scissor-static",
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
        let scene = Model::load(name).unwrap().into_scene();
        let material = &scene.material;
        let numbers = [material.youngs_modulus, material.nu, material.rho, material.alpha];
        assert_eq!(numbers, [2e8, 0.0, 7750.0, 2.85e-5]);
        assert_eq!([scene.section.height, scene.section.width], [0.02, 0.02]);
        assert_eq!((scene.points["o"], scene.points["a"], scene.gravity), ([0.0, 0.0], [1.0, 0.0], [0.0, -9.8]));
        let [rod] = scene.rods.as_slice() else { panic!("{name}: one rod") };
        assert_eq!((rod.from.as_str(), rod.to.as_str(), rod.elements), ("o", "a", 8));
        let [support] = scene.supports.as_slice() else { panic!("{name}: one support") };
        assert_eq!((support.point.as_str(), support.fix.as_slice()), ("o", &[Direction::X, Direction::Y][..]));
        assert_eq!(scene.heat(&scene.rods[0]).map(|heat| (heat.model, heat.start)), heat);
        assert!(scene.heat(&scene.rods[0]).is_none_or(|heat| heat.history == [[0.0, 200.0]]));
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
    assert_eq!(scene.heat(&scene.rods[0]).unwrap().start, Start::Relaxed);
    assert_eq!(scene.columns()[..5], ["t", "from.x", "from.y", "to.x", "to.y"]);
}

/// Table 2 of the paper: L = 2 m, A = 0.02 × 0.02 m², ρ = 2750 kg/m³, E = 7e10 N/m², ν = 0, α = 2.3e-5 1/K; 50 N at a1.
#[test]
fn builtin_scissors_are_those_of_table_2() {
    for (name, model) in [("scissors-3", None), ("scissors-3-thermal", Some(ThermalModel::TwoD))] {
        let scene = Model::load(name).unwrap().into_scene();
        let material = &scene.material;
        let numbers = [material.youngs_modulus, material.nu, material.rho, material.alpha];
        assert_eq!(numbers, [7e10, 0.0, 2750.0, 2.3e-5]);
        assert_eq!([scene.section.height, scene.section.width, scene.gravity[1]], [0.02, 0.02, 0.0]);
        let names: Vec<_> = scene.rods.iter().map(|rod| rod.name.as_str()).collect();
        assert_eq!(names, ["a1b2", "b1a2", "a2b3", "b2a3", "a3b4", "b3a4"]);
        for rod in &scene.rods {
            let ([x_0, y_0], [x_1, y_1]) = (scene.points[&rod.from], scene.points[&rod.to]);
            assert!(((x_1 - x_0).hypot(y_1 - y_0) - 2.0).abs() < 1e-15, "{}", rod.name);
            assert!(((y_1 - y_0).abs().atan2(x_1 - x_0).to_degrees() - 80.0).abs() < 1e-13, "{}", rod.name);
            assert_eq!(rod.elements, 8);
            assert_eq!(format!("{}{}", rod.from, rod.to), rod.name);
            let heat = scene.heat(rod);
            assert_eq!(heat.map(|heat| heat.model), model);
            assert!(heat.is_none_or(|heat| {
                let at = [0.0, 0.125, 0.25, 1.25, 1.5, 1.75, 2.75, 3.0].map(|t| heat.at(t));
                at == [0.0, 75.0, 150.0, 150.0, 0.0, -150.0, -150.0, 0.0]
            }));
        }
        let pivots: Vec<_> = scene.rods.iter().flat_map(|rod| rod.pivot.as_deref()).collect();
        assert_eq!(pivots, ["m1", "m1", "m2", "m2", "m3", "m3"]);
        let [b1, a1] = scene.supports.as_slice() else { panic!("two supports") };
        assert_eq!((b1.point.as_str(), b1.fix.as_slice()), ("b1", &[Direction::X, Direction::Y][..]));
        assert_eq!((a1.point.as_str(), a1.fix.as_slice()), ("a1", &[Direction::X][..]));
        assert_eq!(scene.forces, [Force { point: "a1".into(), force: [0.0, -50.0], history: None }]);
        assert_eq!((scene.time.method, scene.steps(), scene.rows_every()), (Method::EnergyMomentum, 12_000, 40));
        let columns = ["a4.x", "a4.y", "a4.vx", "a4.vy", "a4.ax", "a4.ay", "b1a2.w", "b2a3.w", "b3a4.w"];
        assert_eq!(scene.columns()[1..10], columns);
        assert!(scene.notes.len() >= 7, "each assumption is noted");
    }
}

#[test]
fn scissors_by_number_are_the_embedded_ones_for_three() {
    for name in ["scissors-3", "scissors-3-thermal"] {
        assert_eq!(Scissors::named(name).unwrap().scene().unwrap(), Model::load(name).unwrap().into_scene());
    }
    assert_eq!(Scissors::named("scissors-3"), Some(Scissors::new(3)));
}

#[test]
fn scissors_come_in_any_number() {
    for count in [1, 2, 10] {
        let name = format!("scissors-{count}-thermal");
        let scene = Model::load(&name).unwrap().into_scene();
        assert_eq!(scene, Scene::builtin(&name).unwrap());
        assert_eq!((scene.points.len(), scene.rods.len()), (2 * count + 2, 2 * count));
        assert_eq!(scene.probes[0].point, Some(format!("a{}", count + 1)));
        assert_eq!(scene.probes.len(), 1 + count.min(3));
        // Column k + 1 is k pitches away from the first.
        let pitch = scene.points["b2"][0];
        assert!((scene.points[&format!("a{}", count + 1)][0] - count as f64 * pitch).abs() < 1e-12);
        assert_eq!(builtin_text(&name).unwrap().lines().filter(|line| line.contains("pivot")).count(), 2 * count);
    }
    Model::load("scissors-6250").unwrap().into_scene();
    for name in ["scissors-0", "scissors-6251"] {
        let message = Model::load(name).unwrap_err().to_string();
        assert!(message.starts_with(name) && message.contains("from 1 to 6250"), "{message}");
    }
    for name in ["scissors-03", "scissors-", "scissors--1", "scissors-3-cold", "scissors-x", "scissors-+3"] {
        assert_eq!(Scissors::named(name), None);
        assert!(Model::load(name).is_err());
    }
}

#[test]
fn scissors_have_the_angle_force_elements_and_heat_they_are_given() {
    let scissors = Scissors { angle: 30.0, force: -20.0, elements: 3, model: ThermalModel::OneD, ..Scissors::new(2) };
    let scene = scissors.scene().unwrap();
    let [x, y] = scene.points["a2"];
    assert!((x - 3.0_f64.sqrt()).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    assert_eq!(scene.forces[0].force, [0.0, 20.0]);
    assert!(scene.rods.iter().all(|rod| rod.elements == 3));
    assert_eq!(scene.temperature.unwrap().model, ThermalModel::OneD);
    for part in ["30 degrees", "-20 N", "2 scissor-like elements", "axis only"] {
        assert!(scene.title.contains(part), "no {part:?} in: {}", scene.title);
    }
}

#[test]
fn scissors_that_cannot_be_are_refused() {
    let three = Scissors::new(3);
    let cases = [
        (Scissors { angle: 0.0, ..three.clone() }, "`angle` is 0.0"),
        (Scissors { angle: 90.0, ..three.clone() }, "`angle` is 90.0"),
        (Scissors { angle: f64::NAN, ..three.clone() }, "`angle` is NaN"),
        (Scissors { force: f64::INFINITY, ..three.clone() }, "`force` is inf"),
        (Scissors { elements: 0, ..three.clone() }, "`rods[0].elements` is 0"),
        (Scissors { elements: 16_667, ..three.clone() }, "from 1 to 2"),
        (Scissors { count: 0, ..three }, "`scissors-<n>` is 0"),
    ];
    for (scissors, part) in cases {
        let message = scissors.scene().unwrap_err().to_string();
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

/// EI = 2.1e11 · 0.001⁴/12 = 0.0175 N m², so that PL²/EI = 10 for 0.175 N.
#[test]
fn builtin_cantilever_bends_far() {
    let scene = Model::load("cantilever").unwrap().into_scene();
    let (e, h) = (scene.material.youngs_modulus, scene.section.height);
    let bending = e * scene.section.width * h.powi(3) / 12.0;
    assert!((scene.forces[0].force[1] / bending + 10.0).abs() < 1e-12);
    let support =
        Support { point: "o".into(), fix: vec![Direction::X, Direction::Y], slide: None, clamp: Some("rod".into()) };
    assert_eq!(scene.supports, [support]);
    assert_eq!((scene.steps(), scene.time_after(1), scene.rows_every()), (1, 1.0, 1));
    assert_eq!(scene.columns()[..5], ["t", "tip.x", "tip.y", "o.rx", "o.ry"]);
}

#[test]
fn builtin_scissor_stands_on_two_feet() {
    let scene = Model::load("scissor-static").unwrap().into_scene();
    assert_eq!((scene.steps(), scene.time_after(5), scene.is_row(7)), (10, 0.5, true));
    assert_eq!(scene.columns()[1..9], ["a1.x", "a1.y", "a2.x", "a2.y", "b1.rx", "b1.ry", "b2.rx", "b2.ry"]);
    assert_eq!(scene.position("m1"), Some([0.5, 0.5 * 3.0_f64.sqrt()]));
    let nodes = |rod: &Rod| [Some(rod.from.clone()), Some(rod.to.clone()), rod.pivot.clone()];
    assert!(
        scene
            .rods
            .iter()
            .all(|rod| nodes(rod).contains(&Some("m1".into())) && !nodes(rod).contains(&Some("b3".into())))
    );
}

#[test]
fn text_for_people_keeps_short_lists_on_a_line() {
    let text = with(r#""supports": [{"point": "p", "fix": ["x", "y"]}], "title": "a, b: {\"c\": [1]}""#).to_text();
    for line in [
        r#"  "title": "a, b: {\"c\": [1]}","#,
        r#"  "points": {"p": [0.0, 0.0], "q": [5.0, 6.0]},"#,
        r#"  "supports": [{"point": "p", "fix": ["x", "y"]}],"#,
    ] {
        assert!(text.lines().any(|found| found == line), "no {line:?} in:\n{text}");
    }
    assert!(text.starts_with("{\n") && text.ends_with("\n}\n"));
    let text = Model::load("scissors-3-thermal").unwrap().into_scene().to_text();
    assert!(text.contains("\n    {\"name\": \"b1a2\", \"from\": \"b1\", \"to\": \"a2\", "), "{text}");
}

#[test]
fn builtin_text_is_the_scene() {
    for name in builtin_names() {
        assert_eq!(
            Model::parse(&builtin_text(name).unwrap(), name).unwrap().into_scene(),
            Scene::builtin(name).unwrap()
        );
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
fn force_without_history_is_constant_and_keeps_its_direction() {
    let force = Force { point: "p".into(), force: [2.0, -4.0], history: None };
    assert_eq!([force.at(-1.0), force.at(7.0)], [[2.0, -4.0]; 2]);
    let force = Force { history: Some(vec![[1.0, 0.0], [2.0, 1.0]]), ..force };
    assert_eq!([force.at(0.0), force.at(1.25), force.at(9.0)], [[0.0, 0.0], [0.5, -1.0], [2.0, -4.0]]);
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
        assert_eq!(Model::parse(&text, "test").map(|model| model.scene().steps()).unwrap(), steps);
    }
    // Six digits of a third are a third no more.
    let text = SMALLEST.replace("\"end\": 0.25", "\"end\": 1, \"step\": 0.333333");
    assert!(matches!(Model::parse(&text, "test"), Err(Error::Scene { key, .. }) if key == "time.end"));
}

#[test]
fn a_scene_changed_in_memory_can_be_validated() {
    let mut scene = Scene::builtin("pendulum-2d").unwrap();
    scene.clone().build().unwrap();
    scene.time.step = f64::NAN;
    let message = scene.clone().build().unwrap_err().to_string();
    assert_eq!(message, "scene: `time.step` is NaN; allowed: a finite number over 0");
    scene.time.step = 1e-3;
    scene.points.insert("a".into(), [f64::INFINITY, 0.0]);
    assert!(matches!(scene.clone().build(), Err(Error::Scene { key, .. }) if key == "points.a[0]"));
}

/// Two rods like an X, pinned in the middle; the second is of another material and not heated.
const CROSS: &str = r#"{
  "schema": "ancf-scene/1",
  "material": {"E": 1, "nu": 0, "rho": 2, "alpha": 1e-5},
  "section": {"height": 3, "width": 4},
  "points": {"p": [0, 0], "q": [2, 2], "r": [0, 2], "s": [2, 0]},
  "rods": [{"name": "up", "from": "p", "to": "q", "pivot": "m"},
    {"name": "down", "from": "r", "to": "s", "pivot": "m", "material": {"E": 5, "nu": 0.1, "rho": 6},
     "section": {"height": 7, "width": 8}, "temperature": {"model": "none"}}],
  "temperature": {"history": [[0, 9]]},
  "supports": [{"point": "m", "slide": [3, 4], "clamp": "up"}, {"point": "m", "clamp": "down"}, {"point": "p", "fix": ["x"]},
    {"point": "p", "fix": ["y"]}],
  "time": {"end": 0.25},
  "probes": [{"name": "1", "point": "m", "of": ["position", "reaction"]}, {"name": "2", "point": "m", "rod": "up", "of": ["reaction"]},
    {"name": "3", "point": "q", "rod": "up", "of": ["reaction"]}, {"name": "4", "rod": "down", "at": 1, "of": ["deflection"]}]
}"#;

#[test]
fn rods_have_their_own_material_section_and_temperature_or_the_scenes() {
    let scene = Model::parse(CROSS, "test").unwrap().into_scene();
    let [up, down] = scene.rods.as_slice() else { panic!("two rods") };
    assert_eq!([up, down].map(|rod| scene.material(rod).youngs_modulus), [1.0, 5.0]);
    assert_eq!([up, down].map(|rod| scene.section(rod).height), [3.0, 7.0]);
    assert_eq!([up, down].map(|rod| scene.heat(rod).map(|heat| heat.at(0.0))), [Some(9.0), None]);
}

#[test]
fn pivots_are_points_at_the_middle() {
    let scene = Model::parse(CROSS, "test").unwrap().into_scene();
    assert_eq!(["p", "m", "x"].map(|point| scene.position(point)), [Some([0.0, 0.0]), Some([1.0, 1.0]), None]);
}

#[test]
fn probes_of_a_point_a_pin_and_a_rod_have_their_columns() {
    let scene = Model::parse(CROSS, "test").unwrap().into_scene();
    assert_eq!(scene.columns()[1..10], ["1.x", "1.y", "1.rx", "1.ry", "2.rx", "2.ry", "3.rx", "3.ry", "4.w"]);
    let of = vec![Quantity::Deflection];
    let bend = Probe { name: "4".into(), point: None, rod: Some("down".into()), at: Some(1.0), of, mean: None };
    assert_eq!(scene.probes[3], bend);
}

#[test]
fn a_place_on_a_rod_may_be_one_of_its_ends() {
    for at in ["0", "-0.0", "1.0"] {
        Model::parse(&CROSS.replace("\"at\": 1", &format!("\"at\": {at}")), "test").unwrap().into_scene();
    }
}

#[test]
fn statics_may_take_a_million_load_steps() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    scene.time.load_steps = 1_000_000;
    scene.clone().build().unwrap();
}

/// Supports of one point count once.
#[test]
fn a_relaxed_start_allows_one_held_point() {
    let mut scene = Scene::builtin("pendulum-2d-relaxed").unwrap();
    let clamp = Support { point: "o".into(), fix: vec![], slide: None, clamp: Some("rod".into()) };
    scene.supports.push(clamp.clone());
    scene.clone().build().unwrap();
    scene.supports.push(Support { point: "a".into(), ..clamp });
    assert!(matches!(scene.clone().build(), Err(Error::Scene { key, .. }) if key == "temperature.start"));
}

#[test]
fn an_end_is_asked_of_a_file_but_has_a_value_in_memory() {
    let message = Model::parse(&SMALLEST.replace("\"end\": 0.25", "\"step\": 0.3"), "test").unwrap_err().to_string();
    assert_eq!(message, "test:7:11: `time.end` is missing; allowed: a value here, the key is required");
    let text = SMALLEST.replace("\"end\": 0.25", "\"method\": \"static\"");
    let scene = Model::parse(&text, "test").unwrap().into_scene();
    assert_eq!((scene.time.end, scene.steps(), scene.time_after(10)), (1.0, 10, 1.0));
}

/// α = 0 is a value; only in memory does it look like a missing one.
#[test]
fn an_alpha_of_zero_is_given() {
    let text = CROSS.replace("\"alpha\": 1e-5", "\"alpha\": 0");
    assert_eq!(Model::parse(&text, "test").unwrap().into_scene().material.alpha, 0.0);
}

#[test]
fn a_pivot_may_be_off_by_rounding_only() {
    let moved = |by: f64| CROSS.replace("\"q\": [2, 2]", &format!("\"q\": [{:?}, 2]", 2.0 + by));
    // The middle moves by half, and the rods are 2.83 m long.
    Model::parse(&moved(5.6e-9), "test").unwrap().into_scene();
    assert!(matches!(Model::parse(&moved(5.8e-9), "test"), Err(Error::Scene { key, .. }) if key == "rods[1].pivot"));
}

#[test]
fn rods_may_share_both_ends_and_the_pivot() {
    let text = CROSS.replace(r#""from": "r", "to": "s""#, r#""from": "q", "to": "p""#);
    Model::parse(&text.replace(r#", "r": [0, 2], "s": [2, 0]"#, ""), "test").unwrap().into_scene();
}

/// The scene that `docs/simulate.md` shows is one.
#[test]
fn the_page_shows_a_scene_that_runs() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/simulate.md")).unwrap();
    let text = page.split("```json").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let mut scene = Model::parse(text, "simulate.md").unwrap().into_scene();
    scene.time.end = 0.06;
    let run = ancf::run::run(&scene).unwrap();
    assert_eq!(run.trajectory.rows.len(), 7);
    assert!(run.trajectory.column("bend.w").is_some() && run.trajectory.column("pin.rx").is_some());
}

/// What is no misspelling of a known name gets no suggestion, and all names to choose from.
#[test]
fn suggestions_are_alike() {
    let text = Scene::builtin("scissors-3").unwrap().to_text();
    let message = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        Model::parse(&text.replace(from, to), "mine.json").unwrap_err().to_string()
    };
    let word = message("\"energy-momentum\"", "\"rk4\"");
    assert!(word.contains("`static`") && !word.contains("nearest"), "{word}");
    let alike = message("\"energy-momentum\"", "\"energy-momentun\"");
    assert!(alike.contains("nearest: `energy-momentum`"), "{alike}");
    // The hinge of a scissor is taken away, and what looked at it is left.
    let mut scene = Scene::builtin("scissors-3").unwrap();
    let pivot = scene.rods[0].pivot.clone().unwrap();
    scene.probes[0].point = Some(pivot.clone());
    scene.rods.iter_mut().filter(|rod| rod.pivot.as_ref() == Some(&pivot)).for_each(|rod| rod.pivot = None);
    let mut renamed = scene.clone();
    renamed.probes[0].point = Some("hinge".into());
    let gone = renamed.clone().build().unwrap_err().to_string();
    for part in ["`probes[0].point` is \"hinge\"", "`a1`, ", "where a point was taken away, what stands at it goes too"]
    {
        assert!(gone.contains(part), "no {part} in: {gone}");
    }
    assert!(scene.clone().build().unwrap_err().to_string().contains(&format!("is {pivot:?}")));
}
