//! The pendulum's models over two seconds, with the changes by another step and mesh.

use plotters::style::RGBColor;
use serde::Serialize;

use super::continuum::Continuum;
use super::pendulum_run::PendulumRun;
use super::tip::Tip;
use super::window::Window;
use crate::error::Result;
use crate::figure::{Curve, Panel, Stroke, svg};
use crate::palette::{BLACK, BLUE, GREEN, GREY, ORANGE, VERMILLION};
use crate::parallel::in_parallel;
use ancf::model::Element;
use ancf::run::Trajectory;

const END: f64 = 2.0;
/// A twelfth of the axial wave's period of 25 ms.
const INTERVAL: f64 = 2e-3;
/// Times of the tables, s.
pub const TIMES: [f64; 8] = [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0];

/// A model of the pendulum: heat, start and element.
#[derive(Clone, Copy)]
pub struct ModelKind {
    /// Name in files.
    pub id: &'static str,
    /// Name in pictures and tables.
    pub name: &'static str,
    /// The built-in scene.
    pub scene: &'static str,
    pub element: Element,
    pub mesh: Mesh,
    /// The solid with the same heat.
    pub solid: &'static str,
    colour: RGBColor,
}

/// Elements and step of a model's explicit run, and the finer mesh that shows its error in space.
#[derive(Clone, Copy)]
pub struct Mesh {
    pub elements: usize,
    /// Short enough for axial and thickness waves, s.
    pub step: f64,
    pub other_elements: usize,
}

const SMOOTH: Mesh = Mesh { elements: 16, step: 2e-5, other_elements: 32 };

/// Mesh for a heat shock.
const SHOCK: Mesh = Mesh { elements: 32, step: 5e-6, other_elements: 64 };

/// Colours of the models in all pictures.
const FLEXIBLE: RGBColor = BLACK;
const AXIS: RGBColor = ORANGE;
const PLANE: RGBColor = BLUE;
const EULER_BERNOULLI: RGBColor = GREEN;
const RIGID: RGBColor = GREY;
const SOLID: RGBColor = VERMILLION;

/// All models. "1D" with the Euler–Bernoulli element is the model that the paper compares with; with the paper's own element, it is that
/// element heated along its axis only.
const KINDS: [ModelKind; 8] = [
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
) -> ModelKind {
    ModelKind { id, name, scene, element: Element::Ancf, mesh, solid, colour }
}

/// A model with Euler–Bernoulli elements.
const fn cable(
    id: &'static str,
    name: &'static str,
    scene: &'static str,
    mesh: Mesh,
    solid: &'static str,
) -> ModelKind {
    ModelKind { element: Element::EulerBernoulli, ..kind(id, name, scene, mesh, solid, EULER_BERNOULLI) }
}

/// A model with its three runs.
pub struct Model {
    pub kind: ModelKind,
    pub tip: Tip,
    with_twice_the_step: Tip,
    with_the_other_mesh: Tip,
}

/// A model's tip at one of the table's times, m and s.
#[derive(Serialize)]
pub struct TipRow {
    pub model: &'static str,
    pub elements: usize,
    pub step: f64,
    pub t: f64,
    pub tip: [f64; 2],
    /// Distance from the run with twice the step, which is above the error.
    pub change_with_twice_the_step: f64,
    pub other_elements: usize,
    /// Distance from the run on the other mesh.
    pub change_with_the_other_mesh: f64,
}

impl Model {
    /// The table's rows.
    pub fn rows(&self) -> impl Iterator<Item = TipRow> {
        let Mesh { elements, step, other_elements } = self.kind.mesh;
        TIMES.iter().map(move |&t| {
            let tip = self.tip.at(t);
            TipRow {
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

    /// Error in space in a window: largest distance from the run on the other mesh, m.
    pub fn space_error(&self, window: Window) -> f64 {
        self.with_the_other_mesh.largest_distance_in(&self.tip, window)
    }

    /// Error in time in a window: largest distance from the run with twice the step, m; above the error, whatever the order.
    pub fn time_error(&self, window: Window) -> f64 {
        self.with_twice_the_step.largest_distance_in(&self.tip, window)
    }
}

/// Runs all models, each three times.
pub fn simulate() -> Result<Vec<Model>> {
    let runs: Vec<PendulumRun> = KINDS.iter().flat_map(runs).collect();
    let mut tips = in_parallel("models", &runs, PendulumRun::tip)?.into_iter();
    let model = |kind| {
        let (tip, with_twice_the_step, with_the_other_mesh) = (tips.next()?, tips.next()?, tips.next()?);
        Some(Model { kind, tip, with_twice_the_step, with_the_other_mesh })
    };
    Ok(KINDS.into_iter().map_while(model).collect())
}

/// The three runs of a model.
fn runs(kind: &ModelKind) -> [PendulumRun; 3] {
    let &ModelKind { scene, element, mesh: Mesh { elements, step, other_elements }, .. } = kind;
    [(elements, step), (elements, 2.0 * step), (other_elements, step)].map(|(elements, step)| PendulumRun {
        scene,
        element,
        elements,
        step,
        end: END,
        interval: INTERVAL,
    })
}

/// The curves of the pictures as columns.
pub fn curves(models: &[Model]) -> Trajectory {
    let names = models.iter().flat_map(|model| ["x", "y"].map(|component| format!("{}.{component}", model.kind.id)));
    let times = models.first().map_or(&[][..], |model| &model.tip.t);
    let row =
        |(n, &t): (usize, &f64)| [t].into_iter().chain(models.iter().flat_map(|m| m.tip.r[n])).collect::<Vec<_>>();
    Trajectory {
        columns: ["t".to_string()].into_iter().chain(names).collect(),
        rows: times.iter().enumerate().map(row).collect(),
    }
}

/// File names of [`pictures`].
pub const PICTURES: [&str; 3] = ["figure3.svg", "figure4.svg", "figure4-relaxed.svg"];

/// The paper's Figure 3, and its Figure 4 for both starts, with the solid in place of ANSYS; with their file names.
pub fn pictures(models: &[Model], rigid: &Tip, continuum: &Continuum) -> Result<Vec<(&'static str, String)>> {
    let [flexible, ..] = models else { return Ok(Vec::new()) };
    let heated = |start: &str| models.iter().filter(|model| model.kind.id.ends_with(start)).collect::<Vec<_>>();
    // Each point minus the origin at its time.
    let panel =
        |quantity: &str, mut curves: Vec<Curve<'static>>, component: usize, origin: &dyn Fn(f64) -> [f64; 2]| {
            for point in curves.iter_mut().flat_map(|curve| &mut curve.points) {
                point.1 -= origin(point.0)[component];
            }
            Panel { quantity: format!("{quantity} along {}, m", ["x", "y"][component]), curves }
        };
    let own = |model: &Model, component| curve(model.kind.name, model.kind.colour, &model.tip, component);
    let displacement = |component: usize| -> Result<Panel> {
        let mut curves = vec![curve("rigid (elliptic functions)", RIGID, rigid, component)];
        curves.extend([flexible].into_iter().chain(heated("sudden")).map(|model| own(model, component)));
        curves.push(solid("plane solid, 2D, sudden", "2d-sudden", continuum, component)?);
        Ok(panel("displacement of A", curves, component, &|_| flexible.tip.r[0]))
    };
    let difference = |start: &str, component: usize| -> Result<Panel> {
        let mut curves: Vec<Curve> = heated(start).into_iter().map(|model| own(model, component)).collect();
        curves.push(solid("plane solid, 2D, with its uncertainty", &format!("2d-{start}"), continuum, component)?);
        Ok(panel("difference", curves, component, &|t| flexible.tip.at(t)))
    };
    let figure3 = [displacement(0)?, displacement(1)?];
    let figure4 = |title: &str, start: &str| svg(title, &[difference(start, 0)?, difference(start, 1)?]);
    Ok(vec![
        ("figure3.svg", svg("Figure 3: displacement of the tip A; 1D and 2D heated suddenly by 200 K", &figure3)?),
        ("figure4.svg", figure4("Figure 4: difference from the flexible model, heated suddenly", "sudden")?),
        (
            "figure4-relaxed.svg",
            figure4("Figure 4 with a relaxed start: difference from the flexible model", "relaxed")?,
        ),
    ])
}

fn curve<'a>(name: &'a str, colour: RGBColor, tip: &Tip, component: usize) -> Curve<'a> {
    Curve::line(name, colour, tip.t.iter().zip(&tip.r).map(|(t, r)| (*t, r[component])).collect())
}

/// The solid's tip as dots with error bars: lines between its positions would hide the axial wave.
fn solid<'a>(name: &'a str, id: &str, continuum: &Continuum, component: usize) -> Result<Curve<'a>> {
    let solid = continuum.solid(id)?;
    let uncertainty =
        |t: f64| continuum.windows().find(|window| window.contains(t)).map_or(0.0, |window| solid.uncertainty(window));
    let dots = curve(name, SOLID, &solid.tip, component);
    let uncertainty = dots.points.iter().map(|point| uncertainty(point.0)).collect();
    Ok(Curve { stroke: Stroke::Dots, uncertainty, ..dots })
}
