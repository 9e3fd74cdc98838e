//! `shapes.json`: the axis of every rod over time, for pictures and other programs.

use std::io::{self, Write};

use ancf::model::{Method, Scene};
use ancf::run::AxisPoint;
use schemars::JsonSchema;
use serde::Serialize;

use crate::frames::Frames;

/// Writes the content of `shapes.json`; `id` is that of the run's table.
///
/// # Errors
/// What `out` reports.
pub fn write_shapes(out: &mut dyn Write, id: &str, scene: &Scene, frames: &Frames) -> io::Result<()> {
    let of = |read: fn(&crate::frames::Frame) -> f64| frames.list.iter().map(read).collect();
    let rods = scene.rods.iter().zip(&frames.at).enumerate().map(|(n, (rod, at))| {
        let points = |read: fn(&AxisPoint) -> f64| {
            frames.list.iter().map(|frame| frame.rods[n].iter().map(read).collect()).collect::<Vec<Vec<f64>>>()
        };
        let section = scene.section(rod);
        RodShapes {
            name: &rod.name,
            height: section.height,
            width: section.width,
            at,
            x: points(|point| point.position[0]),
            y: points(|point| point.position[1]),
            director_x: points(|point| point.director[0]),
            director_y: points(|point| point.director[1]),
            strain: points(|point| point.strain),
            curvature: points(|point| point.curvature),
            temperature: frames.list.iter().map(|frame| frame.rods[n][0].temperature).collect(),
            thermal_strain: frames.list.iter().map(|frame| frame.rods[n][0].thermal_strain).collect(),
        }
    });
    let shapes = ShapesFile {
        run: id,
        t: of(|frame| frame.t),
        load: (scene.time.method == Method::Static).then(|| of(|frame| frame.load)),
        rods: rods.collect(),
    };
    serde_json::to_writer(&mut *out, &shapes)?;
    writeln!(out)
}

/// Content of `shapes.json`: the axis of every rod over time. SI units; lists over points are within lists over instants.
#[derive(Serialize, JsonSchema)]
pub struct ShapesFile<'a> {
    /// Run id, as in `summary.json`.
    run: &'a str,
    /// Instants, s; in statics load factors, or the numbers of the rows of an arc-length path.
    t: Vec<f64>,
    /// Load factors of the instants; only in statics.
    #[serde(skip_serializing_if = "Option::is_none")]
    load: Option<Vec<f64>>,
    /// Rods in the scene's order.
    rods: Vec<RodShapes<'a>>,
}

/// Axis of a rod over time.
#[derive(Serialize, JsonSchema)]
struct RodShapes<'a> {
    /// Name of the rod.
    name: &'a str,
    /// Height of the section in the plane, m.
    height: f64,
    /// Width of the section across the plane, m.
    width: f64,
    /// Points, as fractions of the rod's length.
    at: &'a [f64],
    /// Positions along x, m.
    x: Vec<Vec<f64>>,
    /// Positions along y, m.
    y: Vec<Vec<f64>>,
    /// Components along x of the slope ∂r/∂y: the material point at y is the position plus y times the slope.
    director_x: Vec<Vec<f64>>,
    /// Components along y of the slope ∂r/∂y.
    director_y: Vec<Vec<f64>>,
    /// Axial strains, heat included: Green–Lagrange; |r_x| − 1 for Euler–Bernoulli elements.
    strain: Vec<Vec<f64>>,
    /// Curvatures, 1/m: rotation of the section per initial length, positive counterclockwise.
    curvature: Vec<Vec<f64>>,
    /// Temperature changes of the rod, K.
    temperature: Vec<f64>,
    /// Strains αΔT that heat causes freely.
    thermal_strain: Vec<f64>,
}
