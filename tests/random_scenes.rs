//! Scenes that nobody would write: valid by construction, extreme by choice. None may panic, hang, or write a number that is
//! not one; and what succeeds with `--estimate` is not missed by the estimate.

mod common;

use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::sync::mpsc;
use std::time::{Duration, Instant};

use ancf::error::Error;
use ancf::model::{Element, Method, Model, Scene};
use ancf::run::run_estimated;
use ancf::run::{Run, run};
use common::evidence;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use serde_json::{Value, json};

/// A power of ten, uniform in the exponent.
fn decades(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|exponent| 10f64.powf(exponent))
}

/// One of the values, or one drawn.
fn or<T: Clone + std::fmt::Debug + 'static>(
    special: Vec<T>,
    drawn: impl Strategy<Value = T> + 'static,
) -> impl Strategy<Value = T> {
    prop_oneof![prop::sample::select(special), drawn]
}

/// What a scene is made of; lengths in units of the rods, times in those of their waves.
#[derive(Clone, Debug)]
struct Drawn {
    kind: usize,
    modulus: f64,
    nu: f64,
    rho: f64,
    size: f64,
    slenderness: f64,
    angle: f64,
    offset: f64,
    elements: usize,
    euler_bernoulli: bool,
    on_axis: bool,
    /// Strain of the heat, sudden or slow, along the axis or everywhere.
    heat: Option<(f64, bool, bool)>,
    /// Whether it is there from a relaxed start on, where rods and supports allow one.
    relaxed: bool,
    /// Force over EI/L² · 12, weight over EA, ω L over the speed of waves, force at the first point, which most of them hold.
    loads: [f64; 4],
    /// Corners of the force's history: times over the end, which the last may be after, and factors.
    corners: Option<[(f64, f64); 3]>,
    /// In their place a pulse: its start over the end, and how long it rises, and falls, over a step.
    pulse: Option<(f64, f64)>,
    method: usize,
    multipliers: bool,
    /// Step over the time of a wave along a rod, number of steps.
    step: f64,
    steps: usize,
    newton: f64,
    rho_inf: f64,
    probes: usize,
}

const METHODS: [&str; 8] = [
    "generalized-alpha",
    "energy-momentum",
    "explicit",
    "gauss",
    "nystrom",
    "gauss-adaptive",
    "nystrom-adaptive",
    "static",
];

fn drawn() -> impl Strategy<Value = Drawn> {
    let material = (decades(-3.0, 15.0), or(vec![0.0, 0.3], -0.999..0.4999), decades(-3.0, 6.0), decades(-6.0, 6.0));
    let shape =
        (decades(-1.0, 6.0), or(vec![0.0, 90.0, 45.0], -180.0..180.0), or(vec![0.0], decades(-2.0, 6.0)), 1usize..12);
    let sign = prop::sample::select(vec![-1.0, 1.0]);
    let heat = (decades(-12.0, 0.5), sign, any::<bool>(), any::<bool>());
    let load = || or(vec![0.0, 0.0], decades(-14.0, 1.0));
    let corner = || (0.01..1.5f64, -1.0..1.0f64);
    let pulse = prop::option::weighted(0.2, (0.0..1.0f64, decades(-1.5, 0.0)));
    let loads = ([load(), load(), load(), load()], prop::option::of([corner(), corner(), corner()]), pulse);
    let time = (decades(-4.0, 3.0), 1usize..30, decades(-15.0, -2.0), or(vec![0.0, 1.0], 0.0..1.0));
    let choices = (0usize..7, 0usize..METHODS.len(), any::<[bool; 4]>(), 0usize..3);
    (material, shape, prop::option::of(heat), loads, time, choices).prop_map(
        |((modulus, nu, rho, size), (slenderness, angle, offset, elements), heat, loads, time, choices)| {
            let (step, steps, newton, rho_inf) = time;
            let (kind, method, [euler_bernoulli, on_axis, multipliers, relaxed], probes) = choices;
            let (loads, mut corners, pulse) = loads;
            corners.iter_mut().for_each(|corners| corners.sort_by(|a, b| a.0.total_cmp(&b.0)));
            let heat = heat.map(|(strain, sign, sudden, along)| {
                // Within the measure of both elements.
                (if sign < 0.0 { -strain.min(0.499) } else { strain }, sudden, along)
            });
            Drawn {
                kind,
                modulus,
                nu,
                rho,
                size,
                slenderness,
                angle,
                offset,
                elements,
                euler_bernoulli,
                on_axis,
                heat,
                relaxed,
                loads,
                corners,
                pulse,
                method,
                multipliers,
                step,
                steps,
                newton,
                rho_inf,
                probes,
            }
        },
    )
}

impl Drawn {
    /// The scene as a file.
    fn json(&self) -> Value {
        let Drawn { modulus, rho, size, .. } = *self;
        let h = size / self.slenderness;
        let (sin, cos) = self.angle.to_radians().sin_cos();
        let place =
            |x: f64, y: f64| [size * (x * cos - y * sin + self.offset), size * (x * sin + y * cos - 0.3 * self.offset)];
        let method = METHODS[self.method];
        let is_static = method == "static";
        let rods = |pairs: &[(&str, &str)], pivot: Option<&str>| -> Vec<Value> {
            let rod = |(from, to): &(&str, &str)| {
                let even = self.euler_bernoulli && pivot.is_some();
                let elements = if even { 2 * self.elements } else { self.elements };
                let mut rod = json!({"name": format!("{from}{to}"), "from": from, "to": to, "elements": elements});
                if let Some(pivot) = pivot {
                    rod["pivot"] = json!(pivot);
                }
                if self.euler_bernoulli {
                    rod["element"] = json!("euler-bernoulli");
                } else if self.on_axis {
                    rod["poisson"] = json!("axis");
                }
                rod
            };
            pairs.iter().map(rod).collect()
        };
        // Statics needs what holds every rod.
        let kind = if is_static { self.kind % 3 } else { self.kind };
        let (points, rods, supports) = match kind {
            0 => (
                json!({"a": place(0.0, 0.0), "b": place(1.0, 0.0)}),
                rods(&[("a", "b")], None),
                json!([{"point": "a", "fix": ["x", "y"], "clamp": "ab"}]),
            ),
            1 => (
                json!({"a": place(0.0, 0.0), "b": place(1.0, 0.0), "c": place(0.4, 0.9)}),
                rods(&[("a", "c"), ("c", "b")], None),
                json!([{"point": "a", "fix": ["x", "y"]}, {"point": "b", "fix": ["x", "y"]}]),
            ),
            2 => (
                json!({"a": place(0.0, 0.0), "b": place(1.0, 1.0), "c": place(1.0, 0.0), "d": place(0.0, 1.0)}),
                rods(&[("a", "b"), ("c", "d")], Some("m")),
                json!([{"point": "a", "fix": ["x", "y"]}, {"point": "c", "fix": ["x", "y"]}]),
            ),
            3 => (
                json!({"a": place(0.0, 0.0), "b": place(1.0, 0.0)}),
                rods(&[("a", "b")], None),
                json!([{"point": "a", "fix": ["x", "y"]}]),
            ),
            4 => (
                json!({"a": place(0.0, 0.0), "b": place(1.0, 0.0), "c": place(2.0, 0.2)}),
                rods(&[("a", "b"), ("b", "c")], None),
                json!([{"point": "a", "fix": ["x", "y"]}]),
            ),
            5 => (json!({"a": place(0.0, 0.0), "b": place(1.0, 0.0)}), rods(&[("a", "b")], None), json!([])),
            _ => (
                json!({"a": place(0.0, 0.0), "b": place(1.0, 1.0), "c": place(1.0, 0.0), "d": place(0.0, 1.0)}),
                rods(&[("a", "b"), ("c", "d")], Some("m")),
                json!([{"point": "a", "fix": ["x", "y"]}, {"point": "d", "slide": [sin + 0.1, 1.0]}]),
            ),
        };
        let stiffness = modulus * h * h;
        let [force, weight, spin, held] = self.loads;
        let wave = size / (modulus / rho).sqrt();
        // The first is that of `b`, which every kind has.
        let others = points.as_object().unwrap().keys().map(String::as_str).filter(|name| *name != "b");
        let probe = |name| json!({"name": name, "point": name, "of": ["position"]});
        let probes: Vec<Value> = std::iter::once("b").chain(others).map(probe).collect();
        let mut scene = json!({
            "schema": "ancf-scene/1",
            "material": {"E": modulus, "nu": self.nu, "rho": rho, "alpha": 1e-5},
            "section": {"height": h, "width": h},
            "points": points, "rods": rods,
            "gravity": [0.0, -weight * modulus / (rho * size)],
            "forces": [{"point": "b", "force": [0.3 * force * stiffness, -force * stiffness]},
                       {"point": "a", "force": [held * stiffness, 0.5 * held * stiffness]}],
            "time": {"method": method},
            "probes": probes,
        });
        if !matches!(method, "explicit" | "nystrom" | "nystrom-adaptive") {
            scene["time"]["newton_tolerance"] = json!(self.newton);
        }
        if method == "generalized-alpha" {
            scene["time"]["rho_inf"] = json!(self.rho_inf);
        }
        if let Some((strain, sudden, along)) = self.heat {
            let history = if sudden || is_static {
                json!([[0.0, strain / 1e-5]])
            } else {
                json!([[0.0, 0.0], [wave, strain / 1e-5]])
            };
            scene["temperature"] = json!({"model": if along { "1d" } else { "2d" }, "history": history});
            // A single rod, free or on a hinge.
            if self.relaxed && matches!(kind, 0 | 3 | 5) {
                scene["temperature"]["start"] = json!("relaxed");
            }
        }
        if is_static {
            scene["time"]["load_steps"] = json!(1 + self.steps / 4);
        } else {
            // Steps of a method's own choice have to resolve what a thin section vibrates with, or wave from node to node.
            let short = if method.ends_with("adaptive") {
                let fastest = (self.slenderness + self.elements as f64) * self.elements as f64;
                self.step.min(300.0 / (self.steps as f64 * fastest))
            } else {
                self.step
            };
            let step = short * wave;
            scene["time"]["step"] = json!(step);
            scene["time"]["end"] = json!(step * self.steps as f64);
            if method.ends_with("adaptive") {
                scene["time"]["tolerance"] = json!(1e-4 * size);
            }
            if let Some(corners) = self.corners {
                let end = step * self.steps as f64;
                scene["forces"][0]["history"] = corners.iter().map(|(t, factor)| json!([t * end, factor])).collect();
            }
            if let Some((start, width)) = self.pulse {
                let (start, width) = (start * step * self.steps as f64, width * step);
                scene["forces"][0]["history"] = json!([[start, 0.0], [start + width, 1.0], [start + 2.0 * width, 0.0]]);
            }
            if self.multipliers && method == "generalized-alpha" {
                scene["constraints"] = json!("multipliers");
            }
            if spin > 0.0 && matches!(kind, 3..=5) {
                scene["motion"] = json!({"omega": spin / wave, "about": place(0.0, 0.0)});
            }
            match self.probes {
                0 => scene["probes"][0]["of"] = json!(["position", "velocity", "acceleration"]),
                1 => scene["output"] = json!({"energy": false}),
                _ => {}
            }
        }
        scene["supports"] = supports;
        scene
    }
}

/// What came of a scene.
enum Outcome {
    Ran(Box<Run>),
    Failed(Error),
    Panicked,
}

/// Longer than this no scene may take, with its finer runs; the slowest of 10,000 takes a second.
const LONGEST: Duration = Duration::from_secs(120);

/// Makes something of a scene on a thread of its own, so that it can be given up.
fn outcome(scene: &Scene, work: impl Fn(&Scene) -> Result<Run, Error> + Send + 'static) -> Outcome {
    let (send, receive) = mpsc::channel();
    let own = scene.clone();
    std::thread::spawn(move || {
        let made = catch_unwind(std::panic::AssertUnwindSafe(|| work(&own)));
        // Nobody listens any more after the time.
        send.send(made).ok();
    });
    match receive.recv_timeout(LONGEST) {
        Ok(Ok(Ok(run))) => Outcome::Ran(Box::new(run)),
        Ok(Ok(Err(error))) => Outcome::Failed(error),
        Ok(Err(_)) => Outcome::Panicked,
        Err(_) => panic!("not done after {LONGEST:?}:\n{}", serde_json::to_string(scene).unwrap()),
    }
}

/// Failures by their kind, the variant of the error.
type Failures = BTreeMap<String, usize>;

fn count(failures: &mut Failures, error: &Error) {
    *failures.entry(format!("{error:?}").split([' ', '{']).next().unwrap().to_string()).or_insert(0) += 1;
}

/// The same scenes each time.
fn runner(seed: u8) -> TestRunner {
    TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]))
}

/// Runs `number` scenes; those that ran, with their scenes.
fn random(number: usize, seed: u8) -> Vec<(Scene, Run)> {
    let mut runner = runner(seed);
    let strategy = drawn();
    let (mut ran, mut refused, mut failed, mut slowest) = (Vec::new(), 0, Failures::new(), Duration::ZERO);
    for n in 0..number {
        let drawn = strategy.new_tree(&mut runner).unwrap().current();
        let text = drawn.json().to_string();
        let scene = match Model::parse(&text, "random") {
            Ok(model) => model.into_scene(),
            // Numbers may be out of what a scene allows, which is said.
            Err(Error::Scene { .. }) => {
                refused += 1;
                continue;
            }
            Err(other) => panic!("scene {n}: {other}\n{text}"),
        };
        let clock = Instant::now();
        let came = outcome(&scene, |scene| run(scene));
        slowest = slowest.max(clock.elapsed());
        match came {
            Outcome::Panicked => panic!("scene {n} panics:\n{text}"),
            Outcome::Ran(run) => {
                let finite = run.trajectory.rows.iter().flatten().all(|value| value.is_finite());
                assert!(finite, "scene {n} has a number that is none:\n{text}");
                let mut csv = Vec::new();
                run.trajectory.write_csv(&mut csv).unwrap();
                let csv = String::from_utf8(csv).unwrap();
                assert!(!csv.contains("NaN") && !csv.contains("inf"), "scene {n}:\n{text}");
                ran.push((scene, *run));
            }
            Outcome::Failed(error) => {
                let message = error.to_string();
                assert!(message.len() > 20, "scene {n}: {message}");
                count(&mut failed, &error);
            }
        }
    }
    println!(
        "{number} scenes: {} ran, {refused} not valid, failed: {failed:?}; the slowest took {slowest:?}",
        ran.len()
    );
    assert!(ran.len() * 4 > number, "hardly any scene runs: {}", ran.len());
    ran
}

#[test]
fn random_scenes_neither_panic_nor_give_what_is_no_number() {
    let number = if cfg!(debug_assertions) { 400 } else { 10_000 };
    let ran = random(number, 1).len();
    if !cfg!(debug_assertions) {
        evidence::number("random.scenes", number);
        evidence::number("random.ran", ran);
        evidence::number("random.refused", number - ran);
    }
}

/// Those that ran, with an estimate, beside the same much finer: no estimate is missed by more than 20 times. A finer run may fail
/// where the scene's own does not: rounding is more of its loads, a tolerance of 1e-14 out of its reach, an element of it pressed to
/// nothing where a long one is not. These are counted by their errors, and few.
#[test]
fn estimates_of_random_scenes_hold() {
    let (wanted, number) = if cfg!(debug_assertions) { (8, 100) } else { (500, 10_000) };
    let (mut compared, mut stable, mut refused, mut no_finer) = (0, 0, Failures::new(), Failures::new());
    for (scene, _) in random(number, 2) {
        if compared == wanted {
            break;
        }
        // Finer runs of more are too long for a test.
        if scene.rods.iter().map(|rod| rod.elements).sum::<usize>() > 12 {
            continue;
        }
        let text = || serde_json::to_string(&scene).unwrap();
        let own = match outcome(&scene, |scene| run_estimated(scene, |_| ())) {
            Outcome::Ran(run) => run,
            Outcome::Failed(error) => {
                count(&mut refused, &error);
                continue;
            }
            Outcome::Panicked => panic!("panics:\n{}", text()),
        };
        // What a deviation does not change is stable.
        if own.accuracy.amplification.is_some_and(|amplification| amplification < 100.0) {
            let warns = own.warnings.iter().any(|warning| warning.contains("the motion is unstable"));
            assert!(!warns, "{:?}:\n{}", own.warnings, text());
            stable += 1;
        }
        let fine = match outcome(&scene, finer) {
            Outcome::Ran(run) => run,
            Outcome::Failed(error) => {
                // No panic, and no number that is none.
                assert!(!matches!(error, Error::Scene { .. } | Error::NotFinite { .. }), "{error}:\n{}", text());
                count(&mut no_finer, &error);
                continue;
            }
            Outcome::Panicked => panic!("panics, finer:\n{}", text()),
        };
        let (estimate, off) = (own.accuracy.total().unwrap(), distance(&own, &fine));
        // Rounding of the output's places, counted from the origin, is no error of the method.
        let far = scene.points.values().flatten().fold(0.0, |far: f64, place| far.max(place.abs()));
        let slack = 1e-12 * size(&scene) + 4.0 * f64::EPSILON * far;
        assert!(off <= 20.0 * estimate + slack, "estimated {estimate:.1e} m, off by {off:.1e} m:\n{}", text());
        compared += 1;
    }
    println!(
        "{compared} estimates compared; {stable} stable ones without a warning; no estimate: {refused:?}; no finer run: {no_finer:?}"
    );
    assert_eq!(compared, wanted);
    if !cfg!(debug_assertions) {
        evidence::number("random.estimated", compared);
    }
    assert!(no_finer.values().sum::<usize>() * 10 <= wanted, "{no_finer:?}");
}

/// Runs the same with an eighth of the step and four times the elements.
fn finer(scene: &Scene) -> Result<Run, Error> {
    let mut fine = scene.clone();
    let every = if scene.time.method == Method::Static { 8 } else { 1 };
    fine.rods.iter_mut().for_each(|rod| rod.elements *= 4);
    fine.time.load_steps *= every;
    if scene.time.method != Method::Static {
        fine.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
        if scene.time.method.is_adaptive() {
            fine.time.tolerance /= 1000.0;
        }
        // Bending of Euler–Bernoulli elements a quarter as long is sixteen times as fast; a tolerance above all motion bounds no step.
        let explicit = scene.time.method.is_explicit();
        fine.time.step /= if explicit && scene.rods[0].element == Element::EulerBernoulli { 32.0 } else { 8.0 };
    }
    let mut fine = run(&fine)?;
    fine.trajectory.rows = fine.trajectory.rows.iter().step_by(every).collect();
    Ok(fine)
}

/// The largest distance of all points.
fn distance(a: &Run, b: &Run) -> f64 {
    assert_eq!(a.trajectory.rows.len(), b.trajectory.rows.len(), "numbers of rows differ");
    let names = &a.trajectory.columns;
    let places: Vec<usize> = (0..names.len()).filter(|column| names[*column].ends_with(".x")).collect();
    let rows = a.trajectory.rows.iter().zip(&b.trajectory.rows);
    let apart = |(a, b): (&[f64], &[f64])| {
        let distances = places.iter().map(|x| (a[*x] - b[*x]).hypot(a[x + 1] - b[x + 1]));
        distances.fold(0.0, f64::max)
    };
    rows.map(apart).fold(0.0, f64::max)
}

/// The diagonal of the rectangle around the points.
fn size(scene: &Scene) -> f64 {
    let reach = |axis: usize| {
        let places = || scene.points.values().map(move |point| point[axis]);
        places().fold(f64::MIN, f64::max) - places().fold(f64::MAX, f64::min)
    };
    reach(0).hypot(reach(1))
}
