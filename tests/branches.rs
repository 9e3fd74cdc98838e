//! Statics follows its branch: columns beyond their Euler load, a toggle across its limit points, loads one after the
//! other; and says which rows are unstable.
//!
//! Source: closed forms, derived beside each test; the elastica in `common/column.rs`. Goal: the side of the load, in any
//! direction; limit points passed along the arc length, and named along the load.

mod common;

use std::f64::consts::{PI, TAU};

use ancf::error::Error;
use ancf::model::{
    Direction, Element, Force, LoadPath, Material, Method, Model, Probe, Quantity, Rod, Scene, Section, Support,
    Temperature, ThermalModel,
};
use ancf::run::{Run, run, run_estimated};
use common::column::Column;
use common::motion::{Placing, must_run};

/// Directions in which a structure is turned.
const TURNS: usize = 12;

fn turns() -> impl Iterator<Item = Placing> {
    (0..TURNS).map(|n| Placing { mirrored: false, angle: TAU * n as f64 / TURNS as f64 + 0.1, by: [0.0; 2] })
}

fn column(run: &Run, name: &str) -> Vec<f64> {
    run.trajectory.column(name).unwrap()
}

/// Two bars from feet at (±1, 0) to an apex at (0, a), under the dead load `factor` · P* downwards: 2 EA a³/(3√3 L³).
fn toggle(factor: f64, load_steps: usize, placing: Placing) -> Scene {
    let force = factor * 2.0 * EA * RISE.powi(3) / (27f64.sqrt() * length().powi(3));
    let mut scene = Scene::new(Material::new(EA / (HEIGHT * HEIGHT), 0.0, 1.0), Section::new(HEIGHT, HEIGHT))
        .point("left", placing.point([-1.0, 0.0]))
        .point("right", placing.point([1.0, 0.0]))
        .point("apex", placing.point([0.0, RISE]))
        .rod(Rod::new("one", "left", "apex").elements(Element::Ancf, 2))
        .rod(Rod::new("two", "apex", "right").elements(Element::Ancf, 2))
        .support(Support::pinned("left"))
        .support(Support::pinned("right"))
        .force(Force::new("apex", placing.vector([0.0, -force])))
        .probe(Probe::point("apex", "apex", &[Quantity::Position]));
    (scene.time.method, scene.time.load_steps) = (Method::Static, load_steps);
    scene
}

const EA: f64 = 1e6;
/// Bars so high that they do not buckle: ε ≥ −a²/2L² = −0.005, Euler's strain is −π²h²/12L² = −0.033.
const HEIGHT: f64 = 0.2;
const RISE: f64 = 0.1;

fn length() -> f64 {
    1f64.hypot(RISE)
}

/// Height of the apex, in the toggle's own axes.
fn heights(run: &Run, placing: Placing) -> Vec<f64> {
    let up = placing.vector([0.0, 1.0]);
    column(run, "apex.x").into_iter().zip(column(run, "apex.y")).map(|(x, y)| up[0] * x + up[1] * y).collect()
}

/// Load factor at a height z. A bar of the length l has the strain ε = (l² − L²)/2L² = (z² − a²)/2L² and the energy ½ EA L ε²,
/// so that P = −2 EA L ε z/L² = EA z (a² − z²)/L³, largest at z = a/√3.
fn load_at(z: f64, factor: f64) -> f64 {
    let share = z / RISE * (1.0 - (z / RISE).powi(2));
    share * 27f64.sqrt() / 2.0 / factor
}

/// The path passes both limit points, z = ±a/√3, on the closed form, in every direction. Rows between them are unstable.
#[test]
fn a_toggle_snaps_through_along_its_arc_length() {
    for placing in turns() {
        let mut scene = toggle(1.2, 10, placing);
        scene.time.path = LoadPath::ArcLength;
        let run = must_run(&scene);
        let (loads, z) = (column(&run, "load"), heights(&run, placing));
        assert_eq!(run.trajectory.columns[..2], ["t", "load"]);
        let rows: Vec<f64> = (0..z.len()).map(|row| row as f64).collect();
        assert_eq!(column(&run, "t"), rows);
        for (load, z) in loads.iter().zip(&z) {
            // Newton's tolerance, relative to the axial force.
            assert!((load - load_at(*z, 1.2)).abs() <= 1e-8, "{load} at {z}, not {}", load_at(*z, 1.2));
        }
        // Down to the lower limit point at −P*, through it, and on to the whole load.
        let least = loads.iter().copied().fold(0.0, f64::min);
        assert!((-1.0 / 1.2 - 1e-9..-0.9 / 1.2).contains(&least), "{least}");
        assert!(z.windows(2).all(|pair| pair[1] < pair[0]), "it turns back: {z:?}");
        assert_eq!(*loads.last().unwrap(), 1.0);
        assert_eq!(run.unstable_directions, 1);
        let warning = run.warnings.iter().find(|warning| warning.contains("unstable")).unwrap();
        assert!(warning.contains("the last one is stable again"), "{warning}");
    }
}

/// Along the load the path ends at the limit point: never across it, whatever the steps. The advice is followed to the
/// letter and runs.
#[test]
fn a_toggle_ends_at_its_limit_point_along_the_load() {
    for (factor, load_steps) in [(1.2, 1), (1.2, 10), (1.2, 97), (1.0001, 3), (30.0, 1), (30.0, 10), (1e3, 10)] {
        for placing in turns().take(3) {
            let scene = toggle(factor, load_steps, placing);
            match run(&scene) {
                Err(error @ Error::NoEquilibrium { factor: reached, .. }) => {
                    assert!((reached * factor - 1.0).abs() <= 4e-6 * factor, "{factor}, {load_steps}: {reached}");
                    assert!(error.to_string().contains("`\"path\": \"arc-length\"` in `time` follows it"), "{error}");
                    assert!(!error.is_bad_input());
                }
                other => panic!("{factor}, {load_steps}: {:?}", other.map(|run| heights(&run, placing))),
            }
            if factor < 2.0 {
                let text = scene.build().unwrap().into_scene().to_text();
                let advised =
                    text.replace("\"method\": \"static\"", "\"method\": \"static\", \"path\": \"arc-length\"");
                assert_ne!(text, advised);
                must_run(Model::parse(&advised, "toggle").unwrap().scene());
            }
        }
    }
    // Below its limit point it stands.
    for load_steps in [1, 10] {
        let placing = turns().next().unwrap();
        let run = must_run(&toggle(0.99, load_steps, placing));
        let z = *heights(&run, placing).last().unwrap();
        assert!(z > RISE / 3f64.sqrt() && (load_at(z, 0.99) - 1.0).abs() <= 1e-8, "{z}");
        assert_eq!(run.unstable_directions, 0);
    }
}

/// The column at 1.173 P_cr with 1 % across, the default load steps: the side of the load, (0.6996, 0.6291) on the elastica.
/// L/h = 100; measured off by 6e-4.
#[test]
fn the_column_goes_to_the_side_of_its_load() {
    let text = r#"{"schema": "ancf-scene/1", "material": {"E": 7e10, "nu": 0.0, "rho": 2700.0},
        "section": {"height": 0.01, "width": 0.01}, "points": {"a": [0, 0], "b": [1, 0]},
        "rods": [{"name": "r", "from": "a", "to": "b", "elements": 16}], "time": {"method": "static"},
        "supports": [{"point": "a", "fix": ["x", "y"], "clamp": "r"}],
        "forces": [{"point": "b", "force": [-168.81992597523075, 1.4393173084921984]}],
        "probes": [{"name": "b", "point": "b", "of": ["position"]}]}"#;
    let run = run(Model::parse(text, "column").unwrap()).unwrap();
    let [x, y] = ["b.x", "b.y"].map(|name| *column(&run, name).last().unwrap());
    assert!((x - 0.6996).hypot(y - 0.6291) <= 1e-3, "({x}, {y})");
    assert!(run.warnings.is_empty(), "{:?}", run.warnings);
}

/// A few of the family of `columns.rs`, and small shares across, along the load and along the arc length.
#[test]
fn columns_go_to_the_side_of_their_loads_in_every_direction() {
    for (n, placing) in turns().enumerate() {
        let (load, share) = ([1.05, 1.2, 2.0, 2.6][n % 4], [1e-4, 1e-3, 0.05][n % 3]);
        let (load_steps, elements) = ([5, 7, 12, 31, 60][n % 5], [8, 16][n % 2]);
        let own = Column { load, share, load_steps, elements, angle: placing.angle };
        let exact = own.elastica();
        for path in [LoadPath::Load, LoadPath::ArcLength] {
            let mut scene = own.scene();
            scene.time.path = path;
            let run = must_run(&scene);
            let tip = own.tip(&run);
            let off = (tip[0] - exact[0]).hypot(tip[1] - exact[1]);
            println!("{own:?}, {path}: {tip:?}, off by {off:.1e}, {:?}", run.counts);
            // As in `columns.rs`; near P_cr the elastica moves far with a small change of the load.
            assert!(
                tip[1] > 0.0 && off <= 1e-2 + 15.0 / (elements as f64).powi(3),
                "{own:?}, {path}: {tip:?}, not {exact:?}"
            );
            assert_eq!(run.unstable_directions, 0, "{own:?}, {path}");
        }
    }
}

/// A perfect column stays straight, and says from where on that is unstable. The advice, a small force across, is followed.
#[test]
fn a_perfect_column_is_unstable_from_its_euler_load_on() {
    for placing in turns() {
        let perfect = Column { load: 2.0, share: 0.0, load_steps: 10, elements: 8, angle: placing.angle };
        let run = must_run(&perfect.scene());
        assert!(perfect.tip(&run)[1].abs() <= 1e-6, "{:?}", perfect.tip(&run));
        assert_eq!(run.unstable_directions, 1);
        let [warning] = &run.warnings[..] else { panic!("{:?}", run.warnings) };
        // P_cr is at 0.5; the element's strain measure moves it by less than a hundredth.
        assert!(
            warning.starts_with("the equilibria from 0.6 of the load on are unstable (stable up to 0.5)")
                || warning.starts_with("the equilibria from 0.5 of the load on are unstable (stable up to 0.4)"),
            "{warning}"
        );
        assert!(matches!(run_estimated(perfect.scene(), |_| ()), Err(Error::Unstable { directions: 1 })));
        let advised = Column { share: 1e-4, ..perfect };
        let run = must_run(&advised.scene());
        assert!(advised.tip(&run)[1] > 0.5 && run.warnings.is_empty(), "{:?} {:?}", advised.tip(&run), run.warnings);
    }
}

/// Loaded beyond the Euler load and unloaded again: the last row is stable, and yet there is no estimate.
#[test]
fn an_unstable_row_on_the_way_is_not_estimated() {
    let mut scene = Column { load: 2.0, share: 0.0, load_steps: 10, elements: 4, angle: 0.3 }.scene();
    scene.forces[0].history = Some(vec![[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]);
    let run = must_run(&scene);
    assert!(
        run.unstable_directions == 1 && run.warnings[0].contains("the last one is stable again"),
        "{:?}",
        run.warnings
    );
    assert!(matches!(run_estimated(&scene, |_| ()), Err(Error::Unstable { directions: 1 })));
}

fn clamped(point: &str) -> Support {
    Support { fix: vec![Direction::X, Direction::Y], ..Support::pinned(point).clamping("rod") }
}

/// A clamped rod of 1 m, heated.
fn heated(history: Vec<[f64; 2]>, placing: Placing) -> Scene {
    let mut scene =
        Scene::new(Material::new(2e8, 0.0, 7750.0).alpha(2.85e-5), Section::new(HEIGHT / 10.0, HEIGHT / 10.0))
            .point("o", placing.point([0.0, 0.0]))
            .point("a", placing.point([1.0, 0.0]))
            .rod(Rod::new("rod", "o", "a").elements(Element::Ancf, 8))
            .support(clamped("o"))
            .support(clamped("a"))
            .temperature(Temperature::new(ThermalModel::TwoD, history))
            .probe(Probe::point("o", "o", &[Quantity::Reaction]))
            .probe(Probe::deflection("rod", "rod", 0.5));
    scene.time.method = Method::Static;
    scene
}

/// Heated to three times its critical heat, αΔT = π² h²/3L², a clamped rod is said to be unstable in every direction, from the
/// same row on, with the same force.
#[test]
fn a_heated_rod_is_unstable_in_every_direction() {
    let critical = PI.powi(2) * (HEIGHT / 10.0).powi(2) / 3.0 / 2.85e-5;
    let force = 2e8 * (HEIGHT / 10.0).powi(2) * 2.85e-5 * 3.0 * critical;
    let warnings = turns().map(|placing| {
        let run = must_run(&heated(vec![[0.0, 3.0 * critical]], placing));
        let [x, y] = ["o.rx", "o.ry"].map(|name| *column(&run, name).last().unwrap());
        let along = placing.vector([force, 0.0]);
        assert!((x - along[0]).hypot(y - along[1]) <= 1e-6 * force, "{placing:?}: ({x}, {y}), not {along:?}");
        assert!(column(&run, "rod.w").last().unwrap().abs() <= 1e-6);
        run.warnings
    });
    let warnings: Vec<Vec<String>> = warnings.collect();
    assert!(warnings[0].len() == 1 && warnings[0][0].contains("unstable (stable up to 0.3)"), "{:?}", warnings[0]);
    assert!(warnings.iter().all(|own| *own == warnings[0]), "{warnings:?}");
}

/// A clamped rod, loaded along its axis at its middle, then heated. The force presses one half and pulls the other, by F/2
/// each; heat adds −EAαΔT to both. The corner at 0.35 lies inside a load step, and rows on both sides of it.
#[test]
fn heat_comes_after_the_preload() {
    let (force, change) = (1e-3, 5.0);
    for placing in turns() {
        let mut scene = heated(vec![[0.35, 0.0], [1.0, change]], placing);
        scene.rods = vec![
            Rod::new("rod", "o", "m").elements(Element::Ancf, 4),
            Rod::new("other", "m", "a").elements(Element::Ancf, 4),
        ];
        let middle = placing.point([0.5, 0.0]);
        scene.points.insert("m".into(), middle);
        scene.supports = vec![
            Support { clamp: Some("rod".into()), ..Support::pinned("o") },
            Support { clamp: Some("other".into()), ..Support::pinned("a") },
        ];
        scene.forces = vec![Force::new("m", placing.vector([force, 0.0])).history(vec![[0.0, 0.0], [0.35, 1.0]])];
        scene.probes =
            vec![Probe::point("o", "o", &[Quantity::Reaction]), Probe::point("m", "m", &[Quantity::Position])];
        let run = must_run(&scene);
        let along = placing.vector([1.0, 0.0]);
        let thermal = 2e8 * (HEIGHT / 10.0).powi(2) * 2.85e-5 * change;
        for ((s, x), y) in column(&run, "t").into_iter().zip(column(&run, "o.rx")).zip(column(&run, "o.ry")) {
            let (preload, heat) = ((s / 0.35).min(1.0), ((s - 0.35) / 0.65).max(0.0));
            let expected = -0.5 * force * preload + thermal * heat;
            let own = along[0] * x + along[1] * y;
            // The strain of F is F/EA = 1e-8, and its square is left out; so is the product with the thermal strain.
            assert!((own - expected).abs() <= 1e-8 * thermal, "{s}: {own}, not {expected}");
        }
    }
}

/// A cantilever, bent and heated by 300 K: elastic, so that load and heat, heat and load, and both together end in the same
/// equilibrium. The corner at 0.45 lies inside a load step.
#[test]
fn the_order_of_load_and_heat_leaves_the_end() {
    let end = |force: Vec<[f64; 2]>, heat: Vec<[f64; 2]>| {
        let mut scene = heated(heat, turns().next().unwrap());
        scene.supports.truncate(1);
        scene.forces = vec![Force::new("a", [0.3, -0.4]).history(force)];
        scene.probes = vec![Probe::point("a", "a", &[Quantity::Position])];
        let run = must_run(&scene);
        ["a.x", "a.y"].map(|name| *column(&run, name).last().unwrap())
    };
    let (first, last, whole) =
        (vec![[0.0, 0.0], [0.45, 1.0]], vec![[0.45, 0.0], [1.0, 1.0]], vec![[0.0, 0.0], [1.0, 1.0]]);
    let hot = |history: &[[f64; 2]]| history.iter().map(|&[s, value]| [s, 300.0 * value]).collect::<Vec<_>>();
    let together = end(whole.clone(), hot(&whole));
    for [x, y] in [end(first.clone(), hot(&last)), end(last.clone(), hot(&first))] {
        assert!((x - together[0]).hypot(y - together[1]) <= 1e-9, "({x}, {y}), not {together:?}");
    }
}

/// What statics cannot follow is refused with the key and the reason.
#[test]
fn what_statics_cannot_follow_is_refused() {
    let refused = |change: &dyn Fn(&mut Scene), key: &str, reason: &str| {
        let mut scene = heated(vec![[0.0, 1.0]], turns().next().unwrap());
        change(&mut scene);
        let error = scene.build().unwrap_err().to_string();
        assert!(error.contains(key) && error.contains(reason), "{error}");
    };
    let along = |scene: &mut Scene| scene.time.path = LoadPath::ArcLength;
    let history = |scene: &mut Scene, values: [f64; 2]| {
        scene.temperature.as_mut().unwrap().history = vec![[0.0, values[0]], [1.0, values[1]]];
    };
    refused(
        &|scene| history(scene, [3.0, 5.0]),
        "`temperature.history` is 3.0 at the load factor 0",
        "0 at the load factor 0",
    );
    refused(&|scene| (along(scene), history(scene, [0.0, 5.0])).1, "temperature.history", "no history with \"path\"");
    refused(&|scene| (along(scene), scene.time.method = Method::Gauss).1, "`time.path` is \"arc-length\"", "\"gauss\"");
    let mut scene = heated(vec![[0.0, 1.0]], turns().next().unwrap());
    along(&mut scene);
    let error = run_estimated(&scene, |_| ()).unwrap_err();
    assert!(error.is_bad_input() && error.to_string().contains("`time.path` is \"arc-length\""), "{error}");
}

/// A path that uses up its rows, twenty for a load step, says so.
#[test]
fn a_path_that_runs_out_of_rows_says_so() {
    let mut scene = Column { load: 1.2, share: 1e-3, load_steps: 1, elements: 4, angle: 0.0 }.scene();
    scene.time.path = LoadPath::ArcLength;
    let short = must_run(&scene);
    assert!(short.trajectory.rows.len() == 21 && *column(&short, "load").last().unwrap() < 1.0);
    let warned =
        |run: &Run| run.warnings.iter().any(|warning| warning.contains("more `time.load_steps` allow more rows"));
    assert!(warned(&short), "{:?}", short.warnings);
    // The advice, followed.
    scene.time.load_steps = 10;
    let whole = must_run(&scene);
    assert!(*column(&whole, "load").last().unwrap() == 1.0 && !warned(&whole), "{:?}", whole.warnings);
}

/// Where loads move nothing the path has no length, and the load grows all the same.
#[test]
fn a_path_without_length_reaches_the_whole_load() {
    let mut scene = toggle(1.0, 4, turns().next().unwrap());
    scene.time.path = LoadPath::ArcLength;
    scene.forces[0].point = "left".into();
    let run = must_run(&scene);
    assert_eq!(column(&run, "load"), [0.0, 0.25, 0.5, 0.75, 1.0]);
}

/// A rod that is bent too far for its elements: the advice is more of them, and that runs. One load step takes it through 90°.
#[test]
fn rods_that_bend_far_run_with_more_elements() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    scene.forces[0].force = scene.forces[0].force.map(|f| 1e3 * f);
    scene.rods[0] = Rod::new("rod", "o", "a").elements(Element::Ancf, 4);
    let error = run(&scene).unwrap_err().to_string();
    assert!(error.contains("more `elements` help where rods bend far"), "{error}");
    scene.rods[0] = Rod::new("rod", "o", "a").elements(Element::Ancf, 8);
    let hanging = must_run(&scene);
    assert!(*column(&hanging, "tip.y").last().unwrap() < -0.95);
    // Also where it turns by more than a right angle between two rows.
    scene.forces[0].force = [-0.5, -0.05];
    scene.rods[0] = Rod::new("rod", "o", "a").elements(Element::EulerBernoulli, 16);
    let bent = must_run(&scene);
    assert!(*column(&bent, "tip.x").last().unwrap() < -0.5, "{:?}", bent.trajectory.rows);
}

/// Bent and heated together: along the arc length the path ends in the equilibrium of the load steps, for both elements.
#[test]
fn heat_and_load_grow_together_along_the_arc_length() {
    for element in [Element::Ancf, Element::EulerBernoulli] {
        let end = |path| {
            let mut scene = heated(vec![[0.0, 300.0]], turns().next().unwrap());
            scene.rods[0].element = element;
            scene.supports.truncate(1);
            scene.forces = vec![Force::new("a", [0.3, -0.4])];
            scene.probes = vec![Probe::point("a", "a", &[Quantity::Position])];
            scene.time.path = path;
            let run = must_run(&scene);
            ["a.x", "a.y"].map(|name| *column(&run, name).last().unwrap())
        };
        let ([x, y], [along_x, along_y]) = (end(LoadPath::Load), end(LoadPath::ArcLength));
        assert!((x - along_x).hypot(y - along_y) <= 1e-9, "{element}: ({x}, {y}), ({along_x}, {along_y})");
    }
}
