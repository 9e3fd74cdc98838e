//! The pendulum's five models over two seconds, with the change that a coarser step and mesh make.

use serde::Serialize;

use super::figure::{Curve, Panel, svg};
use super::in_parallel;
use super::oracle::Rigid;
use crate::error::{Error, Result};
use crate::run::{Trajectory, run};
use crate::scene::{Method, Scene};

/// What is drawn and tabled. The explicit method at this step resolves the axial and thickness waves of a heat shock.
pub const ELEMENTS: usize = 16;
pub const STEP: f64 = 1e-5;
const END: f64 = 2.0;
/// A twelfth of the axial wave's period of 25 ms.
const INTERVAL: f64 = 2e-3;
/// Times of the tables, s.
pub const TIMES: [f64; 8] = [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0];

/// The built-in scenes and their names in pictures and tables.
const SCENES: [(&str, &str); 5] = [
    ("pendulum-flexible", "flexible"),
    ("pendulum-1d", "1D, sudden"),
    ("pendulum-2d", "2D, sudden"),
    ("pendulum-1d-relaxed", "1D, relaxed"),
    ("pendulum-2d-relaxed", "2D, relaxed"),
];

/// A built-in scene with its own mesh and step, explicit.
pub struct Variant {
    pub scene: &'static str,
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
    pub name: &'static str,
    pub scene: &'static str,
    pub tip: Tip,
    with_twice_the_step: Tip,
    with_half_the_elements: Tip,
}

/// A model's tip at one of the table's times, m and s.
#[derive(Serialize)]
pub struct Row {
    pub model: &'static str,
    pub t: f64,
    pub tip: [f64; 2],
    /// Distance to the same run with twice the step; the error of Verlet's rule is about a third of it.
    pub change_with_twice_the_step: f64,
    /// Distance to the same run with half the elements.
    pub change_with_half_the_elements: f64,
}

impl Model {
    /// The table's rows.
    pub fn rows(&self) -> impl Iterator<Item = Row> {
        TIMES.iter().map(|&t| {
            let tip = self.tip.at(t);
            Row {
                model: self.scene,
                t,
                tip,
                change_with_twice_the_step: self.with_twice_the_step.distance(t, tip),
                change_with_half_the_elements: self.with_half_the_elements.distance(t, tip),
            }
        })
    }
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
    scene.rods[0].elements = variant.elements;
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
    let variant = |scene, elements, step| Variant { scene, elements, step, end: END, interval: INTERVAL };
    let of_scene =
        |scene| [(ELEMENTS, STEP), (ELEMENTS, 2.0 * STEP), (ELEMENTS / 2, STEP)].map(|(n, dt)| variant(scene, n, dt));
    let variants: Vec<Variant> = SCENES.iter().flat_map(|(scene, _)| of_scene(scene)).collect();
    let mut tips = in_parallel("models", &variants, tip)?.into_iter();
    let mut models = Vec::new();
    for (scene, name) in SCENES {
        if let (Some(tip), Some(with_twice_the_step), Some(with_half_the_elements)) =
            (tips.next(), tips.next(), tips.next())
        {
            models.push(Model { name, scene, tip, with_twice_the_step, with_half_the_elements });
        }
    }
    Ok(models)
}

/// The curves of the pictures as a table.
pub fn curves(models: &[Model]) -> Trajectory {
    let names = models.iter().flat_map(|model| ["x", "y"].map(|component| format!("{}.{component}", model.scene)));
    let times = models.first().map_or(&[][..], |model| &model.tip.t);
    let row = |(n, &t): (usize, &f64)| [t].into_iter().chain(models.iter().flat_map(|m| m.tip.r[n])).collect();
    Trajectory {
        columns: ["t".to_string()].into_iter().chain(names).collect(),
        rows: times.iter().enumerate().map(row).collect(),
    }
}

/// The paper's Figure 3, and its Figure 4 for both starts.
pub fn pictures(models: &[Model], rigid: &Rigid) -> Result<Vec<(&'static str, String)>> {
    const COMPONENTS: [&str; 2] = ["x", "y"];
    let [flexible, sudden_1d, sudden_2d, relaxed_1d, relaxed_2d] = models else { return Ok(Vec::new()) };
    let curve = |name, colour, tip: &Tip, component: usize| Curve {
        name,
        colour,
        faint: false,
        points: tip.t.iter().zip(&tip.r).map(|(t, r)| (*t, r[component])).collect(),
    };
    let rigid = Tip { t: rigid.t.clone(), r: rigid.tip.clone() };
    let displacement = |component: usize| {
        let mut curves = vec![curve("rigid (elliptic functions)", 4, &rigid, component)];
        curves.extend(
            [flexible, sudden_1d, sudden_2d].iter().enumerate().map(|(n, m)| curve(m.name, n, &m.tip, component)),
        );
        for point in curves.iter_mut().flat_map(|curve| &mut curve.points) {
            point.1 -= flexible.tip.r[0][component];
        }
        Panel { quantity: format!("displacement of A along {}, m", COMPONENTS[component]), curves }
    };
    let difference = |of: [&Model; 2], component: usize| {
        let less_flexible = |(n, model): (usize, &&Model)| {
            let mut curve = curve(model.name, n + 1, &model.tip, component);
            for (point, r) in curve.points.iter_mut().zip(&flexible.tip.r) {
                point.1 -= r[component];
            }
            curve
        };
        let curves = of.iter().enumerate().map(less_flexible).collect();
        Panel { quantity: format!("difference along {}, m", COMPONENTS[component]), curves }
    };
    let four = |title: &str, of: [&Model; 2]| svg(title, &[difference(of, 0), difference(of, 1)]);
    Ok(vec![
        (
            "figure3.svg",
            svg(
                "Figure 3: displacement of the tip A; 1D and 2D heated suddenly by 200 K",
                &[displacement(0), displacement(1)],
            )?,
        ),
        ("figure4.svg", four("Figure 4: difference from the flexible model, heated suddenly", [sudden_1d, sudden_2d])?),
        (
            "figure4-relaxed.svg",
            four("Figure 4 with a relaxed start: difference from the flexible model", [relaxed_1d, relaxed_2d])?,
        ),
    ])
}
