//! Mistakes made on purpose: what each is called, what to look at, and how it moves.

use ancf::model::{Direction, Element, Law as RodLaw, Scene, Start, Support, ThermalModel};

use super::motion::Method;
use super::setup::{Blocks, Joint, Mass, Setup, StartStretch, Weight};

/// A mistake made on purpose.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// What is wrong, in words.
    pub what: String,
    /// What to look at.
    pub look_at: &'static str,
    /// How it moves.
    pub made: Made,
}

/// How a mistake is made.
#[derive(Clone, Debug)]
pub enum Made {
    /// Another setup, moved finely.
    Setup(Box<Setup>),
    /// The right setup, moved by a method with a step.
    Method(Method),
    /// The right motion, written otherwise.
    Output(Output),
}

/// How a right motion is written wrongly.
#[derive(Clone, Debug)]
pub enum Output {
    /// The times are these: factor and shift, s.
    Times(f64, f64),
    /// A map of positions, column by column, and what is subtracted first: nothing, or the initial place.
    Map([[f64; 2]; 2], bool),
    /// Positions of another point.
    Point(String),
}

/// A mistake with a number that is fitted.
pub struct Family {
    /// Name of the mistake with a value.
    pub what: fn(f64) -> String,
    /// What to look at.
    pub look_at: &'static str,
    /// Values from which the fit starts.
    pub starts: &'static [f64],
    /// The setup, or the output, with a value; `None` where it has no effect.
    pub make: fn(&Setup, f64) -> Option<Made>,
}

const LOADS: &str = "the loads f of (23): their sum over elements, sign and history";
const HEAT: &str = "ε_T of (8) and the history ΔT(t)";
const CONSTRAINTS: &str = "Φ of (23): which coordinates are held, and where";
const ASSEMBLY: &str =
    "the assembly: blocks of neighbouring elements are added at the coordinates of their common node";
const LAW: &str = "D of (16), (17) and the shear of (18)";
const INERTIA: &str = "M of (7), ρ and the section";
const INPUT: &str = "the numbers that are read in";
const METHOD: &str = "the time-stepping method";
const OUTPUT: &str = "what is written: point, component, sign, unit, time";
const MESH: &str = "the number and kind of elements";

/// Mistakes without a number that is fitted. `step` is the program's, where it is known.
pub fn mistakes(scene: &Scene, step: Option<f64>) -> Vec<Mistake> {
    let right = Setup::of(scene.clone());
    let mut all = Vec::new();
    let mut add = |what: &str, look_at: &'static str, change: &dyn Fn(&mut Setup)| {
        let mut setup = right.clone();
        change(&mut setup);
        all.push(Mistake { what: what.into(), look_at, made: Made::Setup(Box::new(setup)) });
    };
    loads(scene, &mut add);
    heat(scene, &mut add);
    supports(scene, &mut add);
    joints(scene, &mut add);
    assembly(scene, &mut add);
    material(scene, &mut add);
    mesh(scene, &mut add);
    all.extend(outputs(scene));
    all.extend(step.into_iter().flat_map(methods));
    all
}

type Add<'a> = dyn FnMut(&str, &'static str, &dyn Fn(&mut Setup)) + 'a;

fn has_gravity(scene: &Scene) -> bool {
    scene.gravity != [0.0; 2]
}

fn loads(scene: &Scene, add: &mut Add) {
    if has_gravity(scene) {
        add("the weight is lost", LOADS, &|setup| setup.scene.gravity = [0.0; 2]);
        add("the weight acts upwards", LOADS, &|setup| setup.scene.gravity = setup.scene.gravity.map(|g| -g));
        add("the weight acts along x", LOADS, &|setup| setup.scene.gravity.swap(0, 1));
        add("g is 9.81 m/s²", INPUT, &|setup| {
            setup.scene.gravity = setup.scene.gravity.map(|g| g.signum() * 9.81 * f64::from(g != 0.0))
        });
        add("the weight is twice as large", LOADS, &|setup| setup.scene.gravity = setup.scene.gravity.map(|g| 2.0 * g));
        add("half of the weight is lost", LOADS, &|setup| setup.scene.gravity = setup.scene.gravity.map(|g| 0.5 * g));
        add("half of each element's weight on each of its ends", LOADS, &|setup| setup.weight = Weight::HalfOnEnds);
        add("all of a rod's weight at its last point", LOADS, &|setup| setup.weight = Weight::AtTheEnd);
    }
    for n in 0..scene.forces.len() {
        let name = &scene.forces[n].point;
        add(&format!("the force at {name} is lost"), LOADS, &|setup| _ = setup.scene.forces.remove(n));
        add(&format!("the force at {name} has the wrong sign"), LOADS, &|setup| {
            setup.scene.forces[n].force = setup.scene.forces[n].force.map(|f| -f);
        });
        add(&format!("the force at {name} is twice as large"), LOADS, &|setup| {
            setup.scene.forces[n].force = setup.scene.forces[n].force.map(|f| 2.0 * f);
        });
        add(&format!("half of the force at {name}"), LOADS, &|setup| {
            setup.scene.forces[n].force = setup.scene.forces[n].force.map(|f| 0.5 * f);
        });
        add(&format!("x and y of the force at {name} exchanged"), LOADS, &|setup| {
            setup.scene.forces[n].force.swap(0, 1)
        });
        add(&format!("the force at {name} does not follow its history"), LOADS, &|setup| {
            setup.scene.forces[n].history = None
        });
        for point in scene.points.keys().filter(|point| *point != name) {
            let what = format!("the force of {name} acts at {point}");
            add(&what, LOADS, &|setup| setup.scene.forces[n].point.clone_from(point));
        }
    }
}

/// Changes the heat of all rods.
fn each_heat(scene: &mut Scene, change: impl Fn(&mut ancf::model::Temperature)) {
    scene.temperature.iter_mut().for_each(&change);
    scene.rods.iter_mut().filter_map(|rod| rod.temperature.as_mut()).for_each(&change);
}

fn heat(scene: &Scene, add: &mut Add) {
    let heats = || scene.rods.iter().filter_map(|rod| scene.heat(rod)).filter(|heat| heat.model != ThermalModel::None);
    if heats().next().is_none() {
        return;
    }
    let relaxed = heats().any(|heat| heat.start == Start::Relaxed);
    add("there is no heat", HEAT, &|setup| setup.heat = [0.0; 2]);
    add("the heat is doubled", HEAT, &|setup| setup.heat = [2.0; 2]);
    add("half of the heat", HEAT, &|setup| setup.heat = [0.5; 2]);
    add("the heat has the wrong sign", HEAT, &|setup| setup.heat = [-1.0; 2]);
    if heats().any(|heat| heat.model == ThermalModel::TwoD) && scene.rods.iter().any(|rod| rod.element == Element::Ancf)
    {
        add("1D heat in place of 2D: no thermal strain across the rod", HEAT, &|setup| setup.heat = [1.0, 0.0]);
        add("the thermal strain across the rod only", HEAT, &|setup| setup.heat = [0.0, 1.0]);
        add("the thermal strain across the rod is doubled", HEAT, &|setup| setup.heat = [1.0, 2.0]);
        add("the thermal strain along the rod is doubled", HEAT, &|setup| setup.heat = [2.0, 1.0]);
        if relaxed {
            add("the relaxed start is not stretched across the rod", HEAT, &|setup| {
                setup.start_at_rest = StartStretch::AlongOnly
            });
        }
    }
    if heats().any(|heat| heat.model == ThermalModel::OneD) && scene.rods.iter().any(|rod| rod.element == Element::Ancf)
    {
        add("2D heat in place of 1D", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| heat.model = ThermalModel::TwoD)
        });
        add("the thermal strain across the rod in place of along", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| heat.model = ThermalModel::TwoD);
            setup.heat = [0.0, 1.0];
        });
    }
    if heats().any(|heat| heat.at(0.0) != 0.0) {
        let (what, other) = match relaxed {
            true => ("a sudden start in place of a relaxed one", Start::Sudden),
            false => ("a relaxed start in place of a sudden one", Start::Relaxed),
        };
        add(what, HEAT, &|setup| each_heat(&mut setup.scene, |heat| heat.start = other));
        for ramp in [0.01, 0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0] {
            let what = format!("the heat grows over {ramp} s in place of acting from t = 0");
            add(&what, HEAT, &|setup| {
                setup.ramp = ramp;
                each_heat(&mut setup.scene, |heat| heat.start = Start::Sudden);
            });
        }
    }
    if heats().any(|heat| heat.history.len() > 1) {
        add("the heat is constant: that of the history's end", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| {
                heat.history.drain(..heat.history.len().saturating_sub(1)).for_each(drop)
            });
        });
        add("the heat jumps: steps in place of straight lines", HEAT, &|setup| each_heat(&mut setup.scene, stepped));
        add("the heat's largest value from t = 0", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| {
                let largest = heat
                    .history
                    .iter()
                    .map(|pair| pair[1])
                    .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
                heat.history = vec![[0.0, largest]];
            });
        });
    }
    for n in 0..scene.rods.len() {
        if scene.rods.len() < 2 {
            continue;
        }
        let name = &scene.rods[n].name;
        add(&format!("rod {name} is not heated"), HEAT, &|setup| {
            let none = scene.heat(&scene.rods[n]).cloned();
            setup.scene.rods[n].temperature = none.map(|mut heat| {
                heat.model = ThermalModel::None;
                heat
            });
        });
        for other in (0..scene.rods.len()).filter(|other| *other != n) {
            add(&format!("rod {name} has the heat of rod {}", scene.rods[other].name), HEAT, &|setup| {
                setup.scene.rods[n].temperature = scene.heat(&scene.rods[other]).cloned();
            });
        }
        let own = scene.heat(&scene.rods[n]).map(|heat| heat.model);
        let other = match own {
            Some(ThermalModel::TwoD) => Some((ThermalModel::OneD, "1D heat in place of 2D")),
            Some(ThermalModel::OneD) => Some((ThermalModel::TwoD, "2D heat in place of 1D")),
            _ => None,
        };
        if let Some((model, what)) = other {
            add(&format!("{what} in rod {name}"), HEAT, &|setup| {
                let mut heat = scene.heat(&scene.rods[n]).cloned();
                heat.iter_mut().for_each(|heat| heat.model = model);
                setup.scene.rods[n].temperature = heat;
            });
        }
    }
}

/// A history that keeps each value until the next entry.
fn stepped(heat: &mut ancf::model::Temperature) {
    const JUMP: f64 = 1e-9;
    let mut steps = Vec::new();
    for (n, [t, value]) in heat.history.iter().enumerate() {
        if let Some([_, before]) = n.checked_sub(1).and_then(|n| heat.history.get(n)) {
            steps.push([t - JUMP, *before]);
        }
        steps.push([*t, *value]);
    }
    heat.history = steps;
}

fn supports(scene: &Scene, add: &mut Add) {
    for (n, support) in scene.supports.iter().enumerate() {
        let point = &support.point;
        let change = |setup: &mut Setup, change: &dyn Fn(&mut Support)| change(&mut setup.scene.supports[n]);
        let rod = scene.rods.iter().find(|rod| rod.from == *point || rod.to == *point);
        add(&format!("{point} is not held"), CONSTRAINTS, &|setup| _ = setup.scene.supports.remove(n));
        if support.fix.len() == 2 {
            add(&format!("{point} is held along x only"), CONSTRAINTS, &|setup| {
                change(setup, &|s| s.fix = vec![Direction::X])
            });
            add(&format!("{point} is held along y only"), CONSTRAINTS, &|setup| {
                change(setup, &|s| s.fix = vec![Direction::Y])
            });
        }
        if let Some([x, y]) = support.slide {
            let slides = [
                ("across its direction", Some([-y, x]), vec![]),
                ("along its direction mirrored in x", Some([x, -y]), vec![]),
                ("along x", Some([1.0, 0.0]), vec![]),
                ("along y", Some([0.0, 1.0]), vec![]),
                ("not at all: it is held in both directions", None, vec![Direction::X, Direction::Y]),
            ];
            for (what, slide, fix) in slides {
                add(&format!("{point} slides {what}"), CONSTRAINTS, &|setup| {
                    change(setup, &|support| (support.slide, support.fix) = (slide, fix.clone()));
                });
            }
        }
        if support.clamp.is_some() {
            add(&format!("{point} is hinged in place of clamped"), CONSTRAINTS, &|setup| {
                change(setup, &|s| s.clamp = None)
            });
        } else if let Some(rod) = rod {
            add(&format!("{point} is clamped: the section keeps its direction"), CONSTRAINTS, &|setup| {
                change(setup, &|support| support.clamp = Some(rod.name.clone()));
            });
        }
        add(&format!("all of the section's vector is held at {point}"), CONSTRAINTS, &|setup| {
            setup.held_section = Some(point.clone());
        });
        if let Some(rod) = rod {
            let other = if rod.from == *point { &rod.to } else { &rod.from };
            add(&format!("{other} is held in place of {point}"), CONSTRAINTS, &|setup| {
                change(setup, &|support| support.point.clone_from(other));
            });
            if support.clamp.is_none() {
                add(&format!("{other} is held as well as {point}"), CONSTRAINTS, &|setup| {
                    let mut second = support.clone();
                    second.point.clone_from(other);
                    setup.scene.supports.push(second);
                });
            }
        }
    }
}

fn joints(scene: &Scene, add: &mut Add) {
    let meeting = |point: &str| {
        let has = |rod: &&ancf::model::Rod| rod.from == point || rod.to == point || rod.pivot.as_deref() == Some(point);
        scene.rods.iter().filter(has).count()
    };
    let pivots = scene.rods.iter().filter_map(|rod| rod.pivot.clone());
    let mut points: Vec<String> =
        scene.points.keys().cloned().chain(pivots).filter(|point| meeting(point) > 1).collect();
    points.sort();
    points.dedup();
    for point in points {
        for (joint, what) in [
            (Joint::Open, "are not pinned"),
            (Joint::OnlyX, "are pinned along x only"),
            (Joint::OnlyY, "are pinned along y only"),
            (Joint::Welded, "are welded: they keep their angle"),
        ] {
            add(&format!("the rods at {point} {what}"), CONSTRAINTS, &|setup| {
                setup.joint = Some((point.clone(), joint))
            });
        }
    }
}

fn assembly(scene: &Scene, add: &mut Add) {
    let most = scene.rods.iter().map(|rod| rod.elements).max().unwrap_or(1);
    type Term = (&'static str, fn(&mut Setup, Blocks));
    let terms: [Term; 4] = [
        ("mass", |setup, blocks| setup.mass_blocks = blocks),
        ("elastic force", |setup, blocks| setup.force_blocks = blocks),
        ("weight", |setup, blocks| setup.weight_blocks = blocks),
        ("mass, elastic force and weight", |setup, blocks| {
            (setup.mass_blocks, setup.force_blocks, setup.weight_blocks) = (blocks, blocks, blocks);
        }),
    ];
    for (term, set) in terms {
        if term == "weight" && !has_gravity(scene) {
            continue;
        }
        if most > 1 {
            let nodes = "at nodes that elements share";
            add(
                &format!("{term} assembled once {nodes}: the last element's block replaces the other"),
                ASSEMBLY,
                &|setup| {
                    set(setup, Blocks::Last);
                },
            );
            add(&format!("{term} assembled once {nodes}: the first element's block is kept"), ASSEMBLY, &|setup| {
                set(setup, Blocks::First);
            });
            add(&format!("{term} assembled twice {nodes}"), ASSEMBLY, &|setup| set(setup, Blocks::Twice));
        }
        for element in 0..most {
            let what = format!("{term} of element {} of {most} is left out", element + 1);
            if most > 1 {
                add(&what, ASSEMBLY, &|setup| set(setup, Blocks::Without(element)));
            }
        }
    }
    add("a diagonal mass, scaled to the rod's", INERTIA, &|setup| setup.mass = Mass::ScaledDiagonal);
    add("the mass matrix's diagonal alone", INERTIA, &|setup| setup.mass = Mass::Diagonal);
}

/// Changes every material of a scene.
fn each_material(scene: &mut Scene, change: impl Fn(&mut ancf::model::Material)) {
    change(&mut scene.material);
    scene.rods.iter_mut().filter_map(|rod| rod.material.as_mut()).for_each(change);
}

/// Changes every section of a scene.
fn each_section(scene: &mut Scene, change: impl Fn(&mut ancf::model::Section)) {
    change(&mut scene.section);
    scene.rods.iter_mut().filter_map(|rod| rod.section.as_mut()).for_each(change);
}

fn material(scene: &Scene, add: &mut Add) {
    let ancf = scene.rods.iter().any(|rod| rod.element == Element::Ancf);
    let has_nu = scene.rods.iter().any(|rod| scene.material(rod).nu != 0.0);
    if ancf {
        add("E3: the shear of the global axes counted once", LAW, &|setup| setup.law.printed_shear = true);
        add("the shear counted once: 2μ for 4μ", LAW, &|setup| setup.law.shear = 0.5);
        add("the shear counted twice", LAW, &|setup| setup.law.shear = 2.0);
        add("a shear correction factor of 5/6", LAW, &|setup| setup.law.shear = 5.0 / 6.0);
        add("no shear stiffness", LAW, &|setup| setup.law.shear = 0.0);
        add("no stiffness across the rod", LAW, &|setup| setup.law.across = 0.0);
        add("strains linear in the displacement", "ε of (10), (14): it is quadratic in the gradient", &|setup| {
            setup.law.linear = true
        });
        for nu in [0.3, 0.25, 0.2].into_iter().filter(|_| !has_nu) {
            add(&format!("ν is {nu} in place of 0"), INPUT, &|setup| each_material(&mut setup.scene, |m| m.nu = nu));
        }
        for points in [[4, 3], [3, 3], [4, 2], [3, 2], [2, 2], [2, 3], [2, 1], [3, 1], [5, 2], [5, 1], [1, 1]] {
            let what = format!("{} × {} Gauss points in the elastic force", points[0], points[1]);
            add(&what, "the quadrature of (18)–(21): 5 × 3 points are exact", &|setup| setup.law.points = points);
        }
        if has_nu {
            add("ν is 0", INPUT, &|setup| each_material(&mut setup.scene, |material| material.nu = 0.0));
            add("no coupling by ν: the uniaxial law", LAW, &|setup| {
                setup.scene.rods.iter_mut().for_each(|rod| rod.law = RodLaw::Uniaxial);
            });
            add("plane stress in place of plane strain", LAW, &|setup| {
                // E and ν of a material whose plane strain is the plane stress of this one.
                each_material(&mut setup.scene, |material| {
                    let nu = material.nu;
                    material.youngs_modulus *= (1.0 + 2.0 * nu) / (1.0 + nu).powi(2);
                    material.nu = nu / (1.0 + nu);
                });
            });
        }
    }
    if scene.rods.iter().any(|rod| scene.section(rod).height != scene.section(rod).width) {
        add("height and width of the section exchanged", INPUT, &|setup| {
            each_section(&mut setup.scene, |section| std::mem::swap(&mut section.height, &mut section.width));
        });
    }
    add("half the section's height", INPUT, &|setup| each_section(&mut setup.scene, |section| section.height *= 0.5));
    add("twice the section's height: y from −h to h", INPUT, &|setup| {
        each_section(&mut setup.scene, |section| section.height *= 2.0)
    });
    add("I is w h³/3 in place of w h³/12", INPUT, &|setup| setup.law.depth = 2.0);
    add("I is w h³/6 in place of w h³/12", INPUT, &|setup| setup.law.depth = 2f64.sqrt());
    if scene.rods.len() > 1 {
        add("all rods have the scene's material", INPUT, &|setup| {
            setup.scene.rods.iter_mut().for_each(|rod| rod.material = None)
        });
        add("all rods have the scene's section", INPUT, &|setup| {
            setup.scene.rods.iter_mut().for_each(|rod| rod.section = None)
        });
    }
}

fn mesh(scene: &Scene, add: &mut Add) {
    let can_be = |element: Element, elements: usize| {
        // A pivot is a node of the Euler–Bernoulli element for even numbers only.
        element == Element::Ancf || elements.is_multiple_of(2) || scene.rods.iter().all(|rod| rod.pivot.is_none())
    };
    if scene.rods.len() == 1 {
        for (element, kind) in
            [(Element::Ancf, "elements of the paper"), (Element::EulerBernoulli, "Euler–Bernoulli elements")]
        {
            for elements in [1, 2, 3, 4, 5, 6, 8, 10] {
                let rod = &scene.rods[0];
                if (rod.element, rod.elements) == (element, elements) || !can_be(element, elements) {
                    continue;
                }
                let what = format!("{elements} {kind} in place of {}", rod.elements);
                add(&what, MESH, &|setup| {
                    (setup.scene.rods[0].element, setup.scene.rods[0].elements) = (element, elements)
                });
            }
        }
        return;
    }
    for (factor, what) in [(2, "twice as many elements in each rod"), (4, "four times as many elements in each rod")] {
        add(what, MESH, &|setup| setup.scene.rods.iter_mut().for_each(|rod| rod.elements *= factor));
    }
    add("one element in each rod", MESH, &|setup| setup.scene.rods.iter_mut().for_each(|rod| rod.elements = 1));
    if scene.rods.iter().all(|rod| can_be(Element::EulerBernoulli, rod.elements)) {
        add("Euler–Bernoulli elements in place of the paper's", MESH, &|setup| {
            setup.scene.rods.iter_mut().for_each(|rod| rod.element = Element::EulerBernoulli);
        });
    }
}

fn outputs(scene: &Scene) -> Vec<Mistake> {
    let maps = [
        ("x has the wrong sign", [[-1.0, 0.0], [0.0, 1.0]], false),
        ("y has the wrong sign", [[1.0, 0.0], [0.0, -1.0]], false),
        ("x and y are exchanged", [[0.0, 1.0], [1.0, 0.0]], false),
        ("lengths in mm", [[1e3, 0.0], [0.0, 1e3]], false),
        ("displacements in place of positions", [[1.0, 0.0], [0.0, 1.0]], true),
    ];
    let output = |what: &str, output| Mistake { what: what.into(), look_at: OUTPUT, made: Made::Output(output) };
    let mut all: Vec<Mistake> =
        maps.into_iter().map(|(what, map, relative)| output(what, Output::Map(map, relative))).collect();
    all.push(output("times in ms", Output::Times(1e-3, 0.0)));
    if scene.rods.len() > 1 {
        let names = scene.points.keys();
        all.extend(names.map(|name| output(&format!("positions of {name}"), Output::Point(name.clone()))));
    }
    all
}

/// Methods that lose an order or energy, with the program's step; and outputs a step late or early.
fn methods(step: f64) -> Vec<Mistake> {
    let newmark = |beta: f64, gamma: f64| ([0.5 - beta, beta], [1.0 - gamma, gamma]);
    let named = [
        ("a first-order method: implicit Euler", ([0.0, 1.0], [0.0, 1.0])),
        ("a first-order method: explicit Euler", ([0.0, 0.0], [1.0, 0.0])),
        ("a first-order method: semi-implicit Euler", ([1.0, 0.0], [1.0, 0.0])),
        ("a first-order method: positions without ½ h² q̈", ([0.0, 0.0], [0.5, 0.5])),
        ("a first-order method: Newmark's with γ = 0.6, damped", newmark(0.3025, 0.6)),
        ("a first-order method: Newmark's with γ = 0.75, damped", newmark(0.390_625, 0.75)),
        ("a first-order method: Newmark's with γ = 1, damped", newmark(0.5625, 1.0)),
    ];
    let method = |(what, (c, d)): (&str, _)| Mistake {
        what: what.into(),
        look_at: METHOD,
        made: Made::Method(Method::Steps { step, c, d }),
    };
    let mut all: Vec<Mistake> = named.into_iter().map(method).collect();
    for (what, shift) in [("written a step late", -step), ("written a step early", step)] {
        all.push(Mistake { what: what.into(), look_at: OUTPUT, made: Made::Output(Output::Times(1.0, shift)) });
    }
    all
}

/// Methods of second order that keep energy, with the program's step: what a right program is off by.
pub fn right_methods(step: f64) -> [Method; 2] {
    [Method::Steps { step, c: [0.25, 0.25], d: [0.5, 0.5] }, Method::Steps { step, c: [0.5, 0.0], d: [0.5, 0.5] }]
}

fn setup(right: &Setup, change: impl Fn(&mut Setup)) -> Option<Made> {
    let mut setup = right.clone();
    change(&mut setup);
    Some(Made::Setup(Box::new(setup)))
}

fn heated(right: &Setup) -> bool {
    let scene = &right.scene;
    scene.rods.iter().filter_map(|rod| scene.heat(rod)).any(|heat| heat.model != ThermalModel::None)
}

const FACTORS: &[f64] = &[0.25, 0.6, 0.95, 1.05, 1.6, 4.0];

/// Mistakes with a number that is fitted.
pub const FAMILIES: &[Family] = &[
    Family {
        what: |factor| format!("the weight times {factor:.4}"),
        look_at: LOADS,
        starts: FACTORS,
        make: |right, factor| {
            has_gravity(&right.scene)
                .then(|| setup(right, |setup| setup.scene.gravity = setup.scene.gravity.map(|g| factor * g)))?
        },
    },
    Family {
        what: |factor| format!("E times {factor:.4}"),
        look_at: INPUT,
        starts: FACTORS,
        make: |right, factor| {
            setup(right, |s| each_material(&mut s.scene, |material| material.youngs_modulus *= factor))
        },
    },
    Family {
        what: |factor| format!("ρ times {factor:.4}"),
        look_at: INPUT,
        starts: FACTORS,
        make: |right, factor| setup(right, |s| each_material(&mut s.scene, |material| material.rho *= factor)),
    },
    Family {
        what: |factor| format!("the thermal strain times {factor:.4}"),
        look_at: HEAT,
        starts: &[-1.0, 0.25, 0.6, 0.95, 1.05, 1.6, 3.0],
        make: |right, factor| heated(right).then(|| setup(right, |setup| setup.heat = [factor; 2]))?,
    },
    Family {
        what: |factor| format!("the heat grows over {factor:.4} s"),
        look_at: HEAT,
        starts: &[0.003, 0.007, 0.015, 0.03, 0.05, 0.07, 0.1, 0.13, 0.16, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45],
        make: |right, ramp| {
            let at_once = |right: &Setup| {
                right.scene.temperature.as_ref().is_some_and(|heat| heat.at(0.0) != 0.0 && heat.start == Start::Sudden)
            };
            (at_once(right) && ramp > 0.0).then(|| setup(right, |setup| setup.ramp = ramp))?
        },
    },
    Family {
        what: |factor| format!("I times {:.4}", factor * factor),
        look_at: INPUT,
        starts: &[0.5, 0.8, 1.25, 2.0],
        make: |right, factor| setup(right, |setup| setup.law.depth = factor),
    },
    Family {
        what: |factor| format!("the section's height times {factor:.4}"),
        look_at: INPUT,
        starts: &[0.5, 0.8, 1.25, 2.0],
        make: |right, factor| setup(right, |setup| each_section(&mut setup.scene, |section| section.height *= factor)),
    },
    Family {
        what: |factor| format!("the shear stiffness times {factor:.4}"),
        look_at: LAW,
        starts: &[0.3, 0.8, 1.3, 3.0],
        make: |right, factor| setup(right, |setup| setup.law.shear = factor),
    },
    Family {
        what: |rate| format!("damping, {rate:.4} /s times the mass"),
        look_at: METHOD,
        starts: &[0.1, 1.0, 10.0],
        make: |right, rate| setup(right, |setup| setup.mass_damping = rate),
    },
    Family {
        what: |time| format!("damping, {time:.2e} s times the stiffness"),
        look_at: METHOD,
        starts: &[1e-6, 1e-5],
        // A longer time of retardation leaves no step that the fine motion could take.
        make: |right, time| (time < 3e-5).then(|| setup(right, |setup| setup.retardation = time))?,
    },
    Family {
        what: |factor| format!("times times {factor:.4}"),
        look_at: OUTPUT,
        starts: &[0.5, 0.97, 1.03, 2.0],
        make: |_, factor| (factor > 0.0).then_some(Made::Output(Output::Times(factor, 0.0))),
    },
    Family {
        what: |shift| format!("written {:.2e} s {}", shift.abs(), if shift < 0.0 { "late" } else { "early" }),
        look_at: OUTPUT,
        starts: &[-1e-2, 1e-2],
        make: |_, shift| Some(Made::Output(Output::Times(1.0, shift))),
    },
];
