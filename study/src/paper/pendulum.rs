//! The pendulum's models over two seconds, with the changes by another step and mesh.

use plotters::style::RGBColor;
use serde::Serialize;

use super::continuum::{Continuum, Solid};
use super::pendulum_run::PendulumRun;
use super::tip::Tip;
use super::window::Window;
use crate::error::Result;
use crate::figure::{Curve, Panel, Stroke, svg};
use crate::palette::{BLACK, BLUE, GREEN, GREY, ORANGE, VERMILLION};
use crate::parallel::in_parallel;
use crate::picture::Picture;
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
pub const PICTURES: [&str; 2] = ["figure3.svg", "figure4.svg"];

/// The paper's Figure 3, and its Figure 4 as distances from the solid, which stands in for ANSYS.
pub fn pictures(models: &[Model], rigid: &Tip, continuum: &Continuum) -> Result<Vec<Picture>> {
    let [flexible, ..] = models else { return Ok(Vec::new()) };
    let heated = |start: &str| models.iter().filter(|model| model.kind.id.ends_with(start)).collect::<Vec<_>>();
    let origin = flexible.tip.r[0];
    let displacement = |component: usize| -> Result<Panel> {
        let curve = |name, colour, tip: &Tip| {
            let points = tip.t.iter().zip(&tip.r).map(|(t, r)| (*t, r[component] - origin[component]));
            Curve::line(name, colour, points.collect())
        };
        let solid = curve("plane solid", SOLID, &continuum.solid("2d-sudden")?.tip);
        let mut curves = vec![Curve { stroke: Stroke::Broad, ..solid }, curve("rigid", RIGID, rigid)];
        let own = |model: &Model| curve(model.kind.name, model.kind.colour, &model.tip);
        curves.extend([flexible].into_iter().chain(heated("sudden")).map(own));
        let quantity = format!("displacement of A along {}, m", ["x", "y"][component]);
        Ok(Panel { quantity, curves, log: false })
    };
    let distance = |start: &str| -> Result<Panel> {
        let solid = continuum.solid(&format!("2d-{start}"))?;
        let mut curves: Vec<Curve> = (heated(start).into_iter())
            .map(|model| Curve::line(model.kind.name, model.kind.colour, distances(&model.tip, &solid)))
            .collect();
        let uncertainty = |window: Window| [window.from, window.to].map(|t| (t, 1e3 * solid.uncertainty(window)));
        let uncertainty = continuum.windows().flat_map(uncertainty).collect();
        curves.push(Curve::line("the solid's own uncertainty", RIGID, uncertainty));
        Ok(Panel { quantity: format!("distance from the solid, {start}, mm"), curves, log: true })
    };
    Ok(vec![
        Picture {
            file: PICTURES[0],
            caption: "Displacement of the tip A over two seconds, heated suddenly by 200 K: rigid, flexible, with 1D and 2D heat, and the plane \
                      solid. All heated curves lie on each other; the next picture tells them apart.",
            svg: svg("Figure 3: displacement of the tip A", &[displacement(0)?, displacement(1)?])?,
        },
        Picture {
            file: PICTURES[1],
            caption: "Distance of the tip from the plane solid under the same heat, with a relaxed start (above) and a sudden one (below). Lower is \
                      better. Grey: what the solid itself is known to.",
            svg: svg("Figure 4: distance of each model from the solid", &[distance("relaxed")?, distance("sudden")?])?,
        },
    ])
}

/// Largest distance from the solid in each piece of time, mm: the distance at an instant passes zero when curves cross.
fn distances(tip: &Tip, solid: &Solid) -> Vec<(f64, f64)> {
    const PIECE: usize = 5;
    let at: Vec<(f64, f64)> = (solid.tip.t.iter().zip(&solid.tip.r))
        .filter(|(t, _)| **t > 0.0)
        .map(|(t, r)| (*t, 1e3 * tip.distance(*t, *r)))
        .collect();
    at.chunks(PIECE).filter_map(|piece| piece.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))).collect()
}
