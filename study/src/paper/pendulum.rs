//! The pendulum's models over two seconds, with the change that a coarser step and mesh make.

use plotters::style::RGBColor;
use serde::Serialize;

use super::continuum::{Continuum, Window};
use super::reference_pendulum::Rigid;
use crate::error::{Error, Result};
use crate::figure::{Curve, Panel, Stroke, svg};
use crate::palette::{BLACK, BLUE, GREEN, GREY, ORANGE, VERMILLION};
use crate::parallel::in_parallel;
use ancf::model::{Element, Method, Scene};
use ancf::run::{Trajectory, run};

const END: f64 = 2.0;
/// A twelfth of the axial wave's period of 25 ms.
const INTERVAL: f64 = 2e-3;
/// Times of the tables, s.
pub const TIMES: [f64; 8] = [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0];

/// One of the models that are drawn and tabled.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Its name in files.
    pub id: &'static str,
    /// Its name in pictures and tables.
    pub name: &'static str,
    /// The built-in scene.
    pub scene: &'static str,
    pub element: Element,
    pub mesh: Mesh,
    /// The solid that is heated alike.
    pub solid: &'static str,
    colour: RGBColor,
}

/// Elements and step of a model's explicit run, and the finer mesh, to which its distance is the error in space.
#[derive(Clone, Copy)]
pub struct Mesh {
    pub elements: usize,
    /// Resolves axial and thickness waves.
    pub step: f64,
    pub other_elements: usize,
}

const SMOOTH: Mesh = Mesh { elements: 16, step: 2e-5, other_elements: 32 };

/// A heat shock needs more.
const SHOCK: Mesh = Mesh { elements: 32, step: 5e-6, other_elements: 64 };

/// Colours of the models in all pictures.
const FLEXIBLE: RGBColor = BLACK;
const AXIS: RGBColor = ORANGE;
const PLANE: RGBColor = BLUE;
const EULER_BERNOULLI: RGBColor = GREEN;
const RIGID: RGBColor = GREY;
const SOLID: RGBColor = VERMILLION;

/// All models. "1D" with the Euler–Bernoulli element is the paper's competitor, with its own element the paper's own model
/// heated along the axis only.
const KINDS: [Kind; 8] = [
    kind("flexible", "flexible", "pendulum-flexible", SMOOTH, "flexible", FLEXIBLE),
    cable("flexible-eb", "flexible, Euler–Bernoulli", "pendulum-flexible", SMOOTH, "flexible"),
    kind("1d-sudden", "1D, sudden", "pendulum-1d", SHOCK, "1d-sudden", AXIS),
    cable("1d-eb-sudden", "1D, Euler–Bernoulli, sudden", "pendulum-1d", SHOCK, "1d-sudden"),
    kind("2d-sudden", "2D, sudden", "pendulum-2d", SHOCK, "2d-sudden", PLANE),
    kind("1d-relaxed", "1D, relaxed", "pendulum-1d-relaxed", SMOOTH, "1d-relaxed", AXIS),
    cable("1d-eb-relaxed", "1D, Euler–Bernoulli, relaxed", "pendulum-1d-relaxed", SMOOTH, "1d-relaxed"),
    kind("2d-relaxed", "2D, relaxed", "pendulum-2d-relaxed", SMOOTH, "2d-relaxed", PLANE),
];

const fn kind(
    id: &'static str,
    name: &'static str,
    scene: &'static str,
    mesh: Mesh,
    solid: &'static str,
    colour: RGBColor,
) -> Kind {
    Kind { id, name, scene, element: Element::Ancf, mesh, solid, colour }
}

/// A model of Euler–Bernoulli elements.
const fn cable(id: &'static str, name: &'static str, scene: &'static str, mesh: Mesh, solid: &'static str) -> Kind {
    Kind { element: Element::EulerBernoulli, ..kind(id, name, scene, mesh, solid, EULER_BERNOULLI) }
}

/// A built-in scene with its own mesh and step, explicit.
pub struct Variant {
    pub scene: &'static str,
    pub element: Element,
    pub elements: usize,
    pub step: f64,
    pub end: f64,
    pub interval: f64,
}

/// Positions of the tip over time, m and s.
pub struct Tip {
    pub t: Vec<f64>,
    pub r: Vec<[f64; 2]>,
}

/// One model.
pub struct Model {
    pub kind: Kind,
    pub tip: Tip,
    with_twice_the_step: Tip,
    with_the_other_mesh: Tip,
}

/// A model's tip at one of the table's times, m and s.
#[derive(Serialize)]
pub struct Row {
    pub model: &'static str,
    pub elements: usize,
    pub step: f64,
    pub t: f64,
    pub tip: [f64; 2],
    /// Distance to the same run with twice the step, which is above the error.
    pub change_with_twice_the_step: f64,
    pub other_elements: usize,
    /// Distance to the same run with the other number of elements.
    pub change_with_the_other_mesh: f64,
}

impl Model {
    /// The table's rows.
    pub fn rows(&self) -> impl Iterator<Item = Row> {
        let Mesh { elements, step, other_elements } = self.kind.mesh;
        TIMES.iter().map(move |&t| {
            let tip = self.tip.at(t);
            Row {
                model: self.kind.id,
                elements,
                step,
                t,
                tip,
                change_with_twice_the_step: self.with_twice_the_step.distance(t, tip),
                other_elements,
                change_with_the_other_mesh: self.with_the_other_mesh.distance(t, tip),
            }
        })
    }

    /// Largest distance in a window to the same run with the other number of elements, m.
    pub fn space_error(&self, window: Window) -> f64 {
        largest_distance(&self.tip, &self.with_the_other_mesh, window)
    }

    /// Largest distance in a window to the same run with twice the step, m: above the error, whatever the order.
    pub fn time_error(&self, window: Window) -> f64 {
        largest_distance(&self.tip, &self.with_twice_the_step, window)
    }
}

/// Largest distance of two tips in a window, at the times of the first, m.
pub fn largest_distance(first: &Tip, second: &Tip, window: Window) -> f64 {
    let within = first.t.iter().zip(&first.r).filter(|(t, _)| window.contains(**t));
    within.map(|(t, r)| second.distance(*t, *r)).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

impl Tip {
    /// The position at time `t`, not a number where there is no such row.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let row = self.t.iter().position(|row| (row - t).abs() < 1e-9);
        row.map_or([f64::NAN; 2], |row| self.r[row])
    }

    /// Distance at time `t` from a position, m.
    pub fn distance(&self, t: f64, [x, y]: [f64; 2]) -> f64 {
        let [own_x, own_y] = self.at(t);
        (own_x - x).hypot(own_y - y)
    }
}

/// Runs a variant and keeps its tip.
pub fn tip(variant: &Variant) -> Result<Tip> {
    let mut scene = Scene::builtin(variant.scene)
        .ok_or_else(|| Error::Fixture { name: variant.scene, reason: "there is no such scene".into() })?;
    (scene.rods[0].element, scene.rods[0].elements) = (variant.element, variant.elements);
    scene.time.method = Method::Explicit;
    (scene.time.step, scene.time.end) = (variant.step, variant.end);
    (scene.output.interval, scene.output.energy) = (Some(variant.interval), false);
    let trajectory = run(&scene)?.trajectory;
    let column = |name| trajectory.column(name).unwrap_or_default();
    let r = column("tip.x").into_iter().zip(column("tip.y")).map(|(x, y)| [x, y]).collect();
    Ok(Tip { t: column("t"), r })
}

/// Runs all models, each three times.
pub fn simulate() -> Result<Vec<Model>> {
    let variants: Vec<Variant> = KINDS.iter().flat_map(variants).collect();
    let mut tips = in_parallel("models", &variants, tip)?.into_iter();
    let mut models = Vec::new();
    for kind in KINDS {
        if let (Some(tip), Some(with_twice_the_step), Some(with_the_other_mesh)) =
            (tips.next(), tips.next(), tips.next())
        {
            models.push(Model { kind, tip, with_twice_the_step, with_the_other_mesh });
        }
    }
    Ok(models)
}

/// A model's three runs.
fn variants(kind: &Kind) -> [Variant; 3] {
    let &Kind { scene, element, mesh: Mesh { elements, step, other_elements }, .. } = kind;
    [(elements, step), (elements, 2.0 * step), (other_elements, step)].map(|(elements, step)| Variant {
        scene,
        element,
        elements,
        step,
        end: END,
        interval: INTERVAL,
    })
}

/// The curves of the pictures as a table.
pub fn curves(models: &[Model]) -> Trajectory {
    let names = models.iter().flat_map(|model| ["x", "y"].map(|component| format!("{}.{component}", model.kind.id)));
    let times = models.first().map_or(&[][..], |model| &model.tip.t);
    let row = |(n, &t): (usize, &f64)| [t].into_iter().chain(models.iter().flat_map(|m| m.tip.r[n])).collect();
    Trajectory {
        columns: ["t".to_string()].into_iter().chain(names).collect(),
        rows: times.iter().enumerate().map(row).collect(),
    }
}

/// The paper's Figure 3, and its Figure 4 for both starts, with the solid in place of ANSYS.
pub fn pictures(models: &[Model], rigid: &Rigid, continuum: &Continuum) -> Result<Vec<(&'static str, String)>> {
    let [flexible, ..] = models else { return Ok(Vec::new()) };
    let rigid = Tip { t: rigid.t.clone(), r: rigid.tip.clone() };
    let heated = |start: &str| models.iter().filter(|model| model.kind.id.ends_with(start)).collect::<Vec<_>>();
    let displacement = |component: usize| -> Result<Panel> {
        let mut curves = vec![curve("rigid (elliptic functions)", RIGID, &rigid, component)];
        let drawn = [flexible].into_iter().chain(heated("sudden"));
        curves.extend(drawn.map(|model| curve(model.kind.name, model.kind.colour, &model.tip, component)));
        curves.push(solid("plane solid, 2D, sudden", "2d-sudden", continuum, component)?);
        for point in curves.iter_mut().flat_map(|curve| &mut curve.points) {
            point.1 -= flexible.tip.r[0][component];
        }
        Ok(Panel { quantity: format!("displacement of A along {}, m", COMPONENTS[component]), curves })
    };
    let difference = |start: &str, component: usize| -> Result<Panel> {
        let mut curves = Vec::new();
        for model in heated(start) {
            curves.push(curve(model.kind.name, model.kind.colour, &model.tip, component));
        }
        curves.push(solid("plane solid, 2D, with its uncertainty", &format!("2d-{start}"), continuum, component)?);
        for point in curves.iter_mut().flat_map(|curve| &mut curve.points) {
            point.1 -= flexible.tip.at(point.0)[component];
        }
        Ok(Panel { quantity: format!("difference along {}, m", COMPONENTS[component]), curves })
    };
    let four = |title: &str, start: &str| svg(title, &[difference(start, 0)?, difference(start, 1)?]);
    Ok(vec![
        (
            "figure3.svg",
            svg(
                "Figure 3: displacement of the tip A; 1D and 2D heated suddenly by 200 K",
                &[displacement(0)?, displacement(1)?],
            )?,
        ),
        ("figure4.svg", four("Figure 4: difference from the flexible model, heated suddenly", "sudden")?),
        ("figure4-relaxed.svg", four("Figure 4 with a relaxed start: difference from the flexible model", "relaxed")?),
    ])
}

const COMPONENTS: [&str; 2] = ["x", "y"];

fn curve<'a>(name: &'a str, colour: RGBColor, tip: &Tip, component: usize) -> Curve<'a> {
    Curve::line(name, colour, tip.t.iter().zip(&tip.r).map(|(t, r)| (*t, r[component])).collect())
}

/// The solid's tip as dots with bars: its positions are too far apart in time for the axial wave to be joined by lines.
fn solid<'a>(name: &'a str, id: &str, continuum: &Continuum, component: usize) -> Result<Curve<'a>> {
    let solid = continuum.solid(id)?;
    let uncertainty = |t: f64| {
        let window = continuum.windows().find(|window| window.contains(t));
        window.map_or(0.0, |window| solid.uncertainty(window))
    };
    let dots = curve(name, SOLID, &solid.tip, component);
    let uncertainty = dots.points.iter().map(|point| uncertainty(point.0)).collect();
    Ok(Curve { stroke: Stroke::Dots, uncertainty, ..dots })
}
