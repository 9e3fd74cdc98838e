//! Advice works: each row is a scene that fails or is warned of, what the message says, and the scene that follows the advice to the
//! letter, which runs and is not warned of it.

use ancf::error::Error;
use ancf::model::{
    Constraints, Element, Force, Imperfection, Law, LoadPath, Material, Method, Motion, Poisson, Probe, Quantity, Rod,
    Scene, Section, Support, Temperature, ThermalModel,
};
use ancf::run::{Run, run, run_estimated};

/// How a scene is run.
#[derive(Clone, Copy, PartialEq)]
enum How {
    Plain,
    Estimated,
}

/// Change of a scene that follows advice.
type Change = Box<dyn Fn(&mut Scene)>;

struct Row {
    name: &'static str,
    scene: Scene,
    how: How,
    /// Part of the error or of the warning that tells what is wrong.
    says: &'static str,
    /// Parts of the message that give advice, each with what follows it.
    cures: Vec<(&'static str, Change)>,
}

fn row(name: &'static str, how: How, says: &'static str, scene: Scene) -> Row {
    Row { name, scene, how, says, cures: Vec::new() }
}

impl Row {
    fn cure(mut self, words: &'static str, follow: impl Fn(&mut Scene) + 'static) -> Row {
        self.cures.push((words, Box::new(follow)));
        self
    }
}

/// The error, or the warnings.
fn messages(scene: &Scene, how: How) -> Result<Vec<String>, String> {
    let result: Result<Run, Error> = match how {
        How::Plain => run(scene),
        How::Estimated => run_estimated(scene, |_| ()),
    };
    result.map(|run| run.warnings).map_err(|error| error.to_string())
}

fn pendulum(method: Method, step: f64) -> Scene {
    let mut scene = Scene::builtin("pendulum-flexible").unwrap().method(method, step).until(0.2);
    (scene.output.interval, scene.output.energy) = (None, true);
    scene.rods[0].elements = 4;
    scene
}

/// The pendulum with a force of 5000 N at its tip, from t = 0 on.
fn pulled(method: Method, step: f64) -> Scene {
    let mut scene = pendulum(method, step);
    scene.forces.push(Force { point: "a".into(), force: [3e4, 0.0], history: None });
    scene
}

/// The pendulum, suddenly heated.
fn shocked(method: Method, step: f64) -> Scene {
    let mut scene = pendulum(method, step);
    scene.temperature = Some(Temperature::new(ThermalModel::TwoD, vec![[0.0, 200.0]]));
    scene.until(0.05)
}

/// A steel rod of 0.1 m that spins at 1000 rad/s.
fn spinner(method: Method, step: f64) -> Scene {
    let mut scene = Scene::new(Material::new(2e11, 0.0, 7800.0), Section::new(0.01, 0.01))
        .point("a", [-0.05, 0.0])
        .point("b", [0.05, 0.0])
        .rod(Rod::new("rod", "a", "b").elements(Element::Ancf, 2))
        .probe(Probe::point("a", "a", &[Quantity::Position]))
        .method(method, step)
        .until(0.1);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega: 1000.0, about: [0.0; 2] });
    scene
}

/// Five pinned rods of 0.2 m that fall as a chain.
fn chain(step: f64) -> Scene {
    let mut scene = Scene::new(Material::new(2e9, 0.0, 2700.0), Section::new(0.01, 0.01));
    for n in 0..=5 {
        scene = scene.point(&format!("p{n}"), [0.12 * f64::from(n), 0.16 * f64::from(n)]);
    }
    for n in 0..5 {
        scene =
            scene.rod(Rod::new(&format!("r{n}"), &format!("p{n}"), &format!("p{}", n + 1)).elements(Element::Ancf, 2));
    }
    scene.support(Support::pinned("p0")).gravity([0.0, -9.8]).method(Method::Gauss, step).until(0.2)
}

/// A cantilever under a force across its tip.
fn cantilever(force: f64, load_steps: usize) -> Scene {
    let mut scene = Scene::builtin("cantilever").unwrap();
    (scene.forces[0].force, scene.time.load_steps) = ([0.0, force], load_steps);
    scene
}

/// A strut of 1 m, L/h = 50, of a material with ν = 0.3.
fn strut() -> Scene {
    let clamp = Support { clamp: Some("rod".into()), ..Support::pinned("a") };
    let mut scene = Scene::new(Material::new(7e10, 0.3, 2700.0), Section::new(0.02, 0.02))
        .point("a", [0.0, 0.0])
        .point("b", [1.0, 0.0])
        .rod(Rod::new("rod", "a", "b"))
        .support(clamp);
    scene.forces.push(Force { point: "b".into(), force: [0.0, -0.001], history: None });
    scene.time.method = Method::Static;
    scene
}

/// A clamped column of 1 m, L/h = 50, under a force along it: a multiple of its Euler load.
fn column(share: f64) -> Scene {
    let mut scene = strut();
    scene.material.nu = 0.0;
    let critical = 7e10 * 0.02_f64.powi(4) / 12.0 * (0.5 * std::f64::consts::PI).powi(2);
    scene.forces[0].force = [-share * critical, 0.0];
    scene
}

/// Two stubby rods, a shallow roof with a force at its top, beyond the one at which it snaps through.
fn truss() -> Scene {
    let mut scene = Scene::new(Material::new(7e10, 0.0, 2700.0), Section::new(0.02, 0.02))
        .point("left", [-1.0, 0.0])
        .point("top", [0.0, 0.1])
        .point("right", [1.0, 0.0])
        .rod(Rod::new("l", "left", "top").elements(Element::Ancf, 1))
        .rod(Rod::new("r", "top", "right").elements(Element::Ancf, 1))
        .support(Support::pinned("left"))
        .support(Support::pinned("right"));
    scene.forces.push(Force { point: "top".into(), force: [0.0, -1.5e4], history: None });
    scene.time.method = Method::Static;
    scene
}

/// The allowed number that follows `words` in a message.
fn number_after(message: &str, words: &str) -> f64 {
    let from = message.find(words).unwrap_or_else(|| panic!("no {words:?} in {message}")) + words.len();
    let number: String = message[from..].chars().take_while(|c| c.is_ascii_digit() || ".e-+".contains(*c)).collect();
    number.trim_end_matches('.').parse().unwrap_or_else(|_| panic!("no number after {words:?} in {message}"))
}

/// Follows the advice on a rotation: the step, as a whole part of the end.
fn resolved(scene: &mut Scene) {
    let said = messages(scene, How::Plain).map_or_else(|error| error, |warnings| warnings.join("; "));
    let step = scene.time.end / (scene.time.end / number_after(&said, "a `time.step` of ")).ceil();
    *scene = scene.clone().method(Method::EnergyMomentum, step);
}

fn history(scene: &mut Scene) {
    scene.forces[0].history = Some(vec![[0.0, 0.0], [0.1, 1.0]]);
}

fn rows() -> Vec<Row> {
    use How::{Estimated, Plain};
    let step = |step: f64| move |scene: &mut Scene| scene.time.step = step;
    let method = |method| move |scene: &mut Scene| scene.time.method = method;
    vec![
        row("gauss at long steps", Plain, "one tangent serves both stages", pendulum(Method::Gauss, 0.04))
            .cure("a much smaller `time.step`", step(0.004)),
        row("gauss moves five pinned rods", Plain, "one tangent serves both stages", chain(0.01))
            .cure("\"energy-momentum\"", method(Method::EnergyMomentum))
            .cure("a much smaller `time.step`", step(1e-4)),
        row("rotation, energy-momentum", Plain, "rad in a step", spinner(Method::EnergyMomentum, 1e-3))
            .cure("keeps the angle", resolved),
        row("rotation, generalized-α", Plain, "rad in a step", spinner(Method::GeneralizedAlpha, 1e-3))
            .cure("keeps the angle", resolved),
        row("explicit step", Plain, "largest frequency", pendulum(Method::Explicit, 1e-3))
            .cure("allowed: at most", step(5e-5)),
        row("nystrom step", Plain, "largest frequency", pendulum(Method::Nystrom, 1e-3))
            .cure("allowed: at most", step(1e-4)),
        row("sudden force, energy-momentum", Plain, "did not converge", pulled(Method::EnergyMomentum, 1e-2))
            .cure("\"explicit\"", |scene| *scene = scene.clone().method(Method::Explicit, 2e-5))
            .cure("a smaller `time.step`", step(1e-4))
            .cure("`history`", history),
        row("sudden force, generalized-α", Plain, "has collapsed", pulled(Method::GeneralizedAlpha, 1e-2))
            .cure("a smaller `time.step`", step(1e-4))
            .cure("`history`", history),
        row("heat shock, generalized-α", Plain, "more than the", shocked(Method::GeneralizedAlpha, 1e-2))
            .cure("\"energy-momentum\"", method(Method::EnergyMomentum))
            .cure("\"explicit\"", |scene| *scene = scene.clone().method(Method::Explicit, 2e-5))
            .cure("a smaller `time.step`", step(1e-5)),
        row("heat shock, energy-momentum", Plain, "does not resolve", shocked(Method::EnergyMomentum, 1e-3))
            .cure("a smaller step", step(1e-5))
            .cure("\"explicit\"", |scene| *scene = scene.clone().method(Method::Explicit, 2e-5)),
        row("lost in rounding", Plain, "rounding errors of the elastic forces", {
            let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
            scene.material.youngs_modulus = 2e20;
            scene
        })
        .cure("a smaller `E`", |scene| scene.material.youngs_modulus = 2e12),
        row("tolerance of an adaptive method", Plain, "the step would have to be shorter", {
            let mut scene = shocked(Method::NystromAdaptive, 1e-2).until(0.01);
            (scene.time.tolerance, scene.material.youngs_modulus) = (1e-22, 2e12);
            scene
        })
        .cure("a larger `time.tolerance`", |scene| scene.time.tolerance = 1e-5),
        row("a mechanism in statics", Plain, "move without a strain", {
            let mut scene = cantilever(-1.0, 10);
            scene.supports[0].clamp = None;
            scene
        })
        .cure("`supports` and pins that hold every rod", |scene| scene.supports[0].clamp = Some("rod".into())),
        row("two elements bend far", Estimated, "not even the first digit is sure", {
            let mut scene = cantilever(0.0, 20);
            (scene.section.height, scene.section.width, scene.rods[0].elements) = (1e-4, 0.1, 2);
            scene.forces[0].force[1] = 0.1 * Scene::builtin("cantilever").unwrap().forces[0].force[1];
            scene
        })
        .cure("more `elements`", |scene| scene.rods[0].elements = 16),
        row(
            "a coarse step",
            Estimated,
            "not even the first digit is sure",
            pendulum(Method::EnergyMomentum, 0.25).until(1.0),
        )
        .cure("shorter steps help (`time.step`", step(5e-3)),
        row("a rod that locks", Plain, "locks", strut())
            .cure("\"poisson\": \"axis\"", |scene| scene.rods[0].poisson = Poisson::Axis)
            .cure("\"law\": \"uniaxial\"", |scene| scene.rods[0].law = Law::Uniaxial),
        row("a pulse within a step", Plain, "rises and falls, or begins with the end, within no more than the step", {
            let mut scene = pulled(Method::EnergyMomentum, 1e-3);
            scene.forces[0].force = [10.0, 0.0];
            scene.forces[0].history = Some(vec![[0.0, 0.0], [0.05, 0.0], [0.0502, 1.0], [0.0504, 0.0]]);
            scene
        })
        .cure("a smaller step", step(1e-4))
        .cure("an adaptive method", method(Method::GaussAdaptive)),
        row("a pulse that no estimate sees", Estimated, "the error cannot be estimated", {
            let mut scene = pulled(Method::EnergyMomentum, 1e-3);
            scene.forces[0].force = [10.0, 0.0];
            scene.forces[0].history = Some(vec![[0.0, 0.0], [0.02, 0.0], [0.02002, 1.0], [0.02004, 0.0]]);
            scene.until(0.03)
        })
        .cure("a smaller `time.step`", step(1e-5)),
        row("values that ring", Plain, "ring from row to row", {
            let mut scene = pendulum(Method::EnergyMomentum, 2e-3);
            scene.material.youngs_modulus *= 100.0;
            scene.output.interval = Some(0.02);
            scene.time.end = 0.4;
            scene.probes = vec![Probe::point("tip", "a", &[Quantity::Acceleration])];
            scene
        })
        .cure("a probe's `mean` over a window of time", |scene| scene.probes[0].mean = Some(0.1)),
        row("an end between steps", Plain, "a step of", pendulum(Method::EnergyMomentum, 3e-3)).cure(
            "divides it",
            |scene| {
                scene.time.step = number_after(&messages(scene, Plain).unwrap_err(), "a step of ");
            },
        ),
        row("rows between steps", Plain, "a step of", {
            let mut scene = pendulum(Method::EnergyMomentum, 4e-3);
            scene.output.interval = Some(0.01);
            scene
        })
        .cure("divides it", |scene| {
            scene.time.step = number_after(&messages(scene, Plain).unwrap_err(), "a step of ");
        }),
        row("multipliers without their method", Plain, "`constraints`", {
            let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
            scene.constraints = Constraints::Multipliers;
            scene
        })
        .cure("\"condensed\"", |scene| scene.constraints = Constraints::Condensed)
        .cure("the method \"generalized-alpha\"", method(Method::GeneralizedAlpha)),
        row("a window between steps", Plain, "`probes[0].mean`", {
            let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
            scene.probes[0].mean = Some(1.5e-3);
            scene
        })
        .cure("a whole number of steps", |scene| scene.probes[0].mean = Some(2e-3)),
        row("a name that nothing has", Plain, "nearest", {
            let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
            scene.probes[0].point = Some("A".into());
            scene
        })
        .cure("`a`", |scene| scene.probes[0].point = Some("a".into())),
        row("too many elements", Plain, "`rods[0].elements`", {
            let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
            scene.rods[0].elements = 3_000_000;
            scene
        })
        .cure("a whole number from 1 to 100000", |scene| scene.rods[0].elements = 4),
        row("an unstable motion", Estimated, "the motion is unstable", {
            let mut scene = pendulum(Method::EnergyMomentum, 5e-3).until(3.0);
            scene.points.insert("a".into(), [0.0, 1.0]);
            scene
        })
        .cure("an `imperfection`", |scene| scene.imperfection = Some(Imperfection::of_rod("rod", 1e-3)))
        .cure("a small force across", |scene| {
            scene.forces.push(Force { point: "a".into(), force: [1.0, 0.0], history: None });
        }),
        row("a column above its Euler load", Plain, "are unstable", column(1.1))
            .cure("an `imperfection`", |scene| scene.imperfection = Some(Imperfection::of_rod("rod", 1e-3)))
            .cure("a small force across", |scene| scene.forces[0].force[1] = 1.0),
        row("an estimate of it", Estimated, "equilibrium on the way is unstable", column(1.1))
            .cure("an `imperfection`", |scene| scene.imperfection = Some(Imperfection::of_rod("rod", 1e-3)))
            .cure("a small force across", |scene| scene.forces[0].force[1] = 1.0),
        row("a truss that snaps through", Plain, "cannot be followed beyond", truss())
            .cure("`\"path\": \"arc-length\"` in `time`", |scene| scene.time.path = LoadPath::ArcLength),
        row("a setting without effect", Plain, "which has no use for it", {
            let mut scene = pendulum(Method::EnergyMomentum, 1e-3);
            scene.time.rho_inf = 0.5;
            scene
        })
        .cure("nothing with the method", |scene| scene.time.rho_inf = 0.9)
        .cure("\"generalized-alpha\"", method(Method::GeneralizedAlpha)),
    ]
}

#[test]
fn advice_that_is_followed_works() {
    let rows = rows();
    let mut faults = Vec::new();
    for Row { name, scene, how, says, cures } in &rows {
        let said = match messages(scene, *how) {
            Ok(warnings) => warnings.join("; "),
            Err(error) => error,
        };
        if said.is_empty() || !said.contains(says) {
            faults.push(format!("{name}: says {said:?}, not {says:?}"));
        }
        for (words, follow) in cures {
            let mut cured = scene.clone();
            follow(&mut cured);
            match messages(&cured, *how) {
                _ if !said.contains(words) => faults.push(format!("{name}: {words:?} is not in {said:?}")),
                Ok(warnings) if warnings.iter().any(|warning| !says.is_empty() && warning.contains(says)) => {
                    faults.push(format!("{name}: {words:?} is followed, and still {warnings:?}"));
                }
                Ok(_) => (),
                Err(error) => faults.push(format!("{name}: {words:?} is followed, and now {error}")),
            }
        }
    }
    assert!(rows.len() >= 25);
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// With the step of the warning a quarter of it changes the angle by less than allowed.
#[test]
fn a_resolved_rotation_is_right() {
    let mut scene = spinner(Method::EnergyMomentum, 1e-3);
    resolved(&mut scene);
    let [own, finer] = [1.0, 4.0].map(|parts| {
        let mut scene = scene.clone();
        scene.time.step /= parts;
        run(scene).unwrap().trajectory.rows.last().unwrap().to_vec()
    });
    assert!((own[1] - finer[1]).hypot(own[2] - finer[2]) < 0.01 * 0.05, "{own:?} {finer:?}");
}
