//! `modes.json`: frequencies and shapes with every digit.

use std::io::{self, Write};

use ancf::model::Scene;
use ancf::run::{Buckling, Mode, Modes};
use schemars::JsonSchema;
use serde::Serialize;

use super::word;

/// Writes the content of `modes.json`.
///
/// # Errors
/// What `out` reports.
pub fn write(out: &mut dyn Write, file: &ModesFile) -> io::Result<()> {
    serde_json::to_writer(&mut *out, file)?;
    writeln!(out)
}

/// Content of `modes.json`: frequencies and shapes of a structure about an equilibrium, in SI units.
#[derive(Serialize, JsonSchema)]
pub struct ModesFile<'a> {
    /// Run id, as in the page beside this file.
    run: &'a str,
    /// Version of the program.
    version: &'static str,
    /// State that the modes are about: "unloaded", "heated" or "loaded".
    about: &'static str,
    /// Number of unknowns of the structure.
    unknowns: usize,
    /// Axes of the rods in the equilibrium, in the scene's order.
    rods: Vec<RodAxis<'a>>,
    /// Modes: motions without a force, deviations that grow, then vibrations, slowest first.
    modes: Vec<ModeEntry>,
    /// Factors of loads and heat at which the structure buckles; left out where they were not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    buckling: Option<BucklingEntry>,
}

/// Axis of a rod.
#[derive(Serialize, JsonSchema)]
struct RodAxis<'a> {
    /// Name of the rod.
    name: &'a str,
    /// Points, as fractions of the rod's length.
    at: &'a [f64],
    /// Positions along x, m.
    x: Vec<f64>,
    /// Positions along y, m.
    y: Vec<f64>,
}

/// A mode.
#[derive(Serialize, JsonSchema)]
struct ModeEntry {
    /// Number in the order of the table, from 1.
    number: usize,
    /// What moves: "rigid", the structure as one body; "mechanism", its rods against one another; "vibration"; "unstable", a
    /// deviation that grows.
    kind: &'static str,
    /// Square of the angular frequency, (rad/s)²; negative for a deviation that grows.
    square: f64,
    /// Frequency, Hz; zero for a motion without a force, left out for a deviation that grows.
    #[serde(skip_serializing_if = "Option::is_none")]
    frequency: Option<f64>,
    /// Rate of a deviation that grows, 1/s; left out for others.
    #[serde(skip_serializing_if = "Option::is_none")]
    growth: Option<f64>,
    /// Displacements of the axes, rod by rod; the largest is 1.
    shape: Vec<RodShape>,
}

/// Displacements of a rod's axis.
#[derive(Serialize, JsonSchema)]
struct RodShape {
    /// Along x.
    x: Vec<f64>,
    /// Along y.
    y: Vec<f64>,
}

/// Factors at which a structure buckles.
#[derive(Serialize, JsonSchema)]
struct BucklingEntry {
    /// Lowest positive factor of the linearised stiffness; left out where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    linearised: Option<f64>,
    /// Factor at which the stiffness turns singular on the path of equilibria; left out where it does not as far as that was followed.
    #[serde(skip_serializing_if = "Option::is_none")]
    factor: Option<f64>,
    /// Factor to which the path was followed.
    followed: f64,
    /// Displacements of the axes in the linearised buckling, rod by rod; the largest is 1.
    shape: Vec<RodShape>,
}

impl<'a> ModesFile<'a> {
    /// Content for the modes of a scene; `run` is the id.
    pub fn of(run: &'a str, scene: &'a Scene, found: &'a Modes, buckled: Option<&Buckling>) -> ModesFile<'a> {
        let rods = scene.rods.iter().zip(&found.at).zip(&found.equilibrium);
        let axis = |((rod, at), axis): ((&'a ancf::model::Rod, &'a Vec<f64>), &Vec<[f64; 2]>)| {
            let RodShape { x, y } = rod_shape(axis);
            RodAxis { name: &rod.name, at, x, y }
        };
        let entry = |(n, mode): (usize, &Mode)| ModeEntry {
            number: n + 1,
            kind: word(mode.kind),
            square: mode.square,
            frequency: mode.frequency(),
            growth: mode.growth(),
            shape: mode.shape.iter().map(|rod| rod_shape(rod)).collect(),
        };
        ModesFile {
            run,
            version: env!("CARGO_PKG_VERSION"),
            about: found.about.word(),
            unknowns: found.unknowns,
            rods: rods.map(axis).collect(),
            modes: found.modes.iter().enumerate().map(entry).collect(),
            buckling: buckled.map(|buckled| BucklingEntry {
                linearised: buckled.linearised,
                factor: buckled.factor,
                followed: buckled.followed,
                shape: buckled.shape.iter().map(|rod| rod_shape(rod)).collect(),
            }),
        }
    }
}

fn rod_shape(points: &[[f64; 2]]) -> RodShape {
    let along = |axis: usize| points.iter().map(|point| point[axis]).collect();
    RodShape { x: along(0), y: along(1) }
}
