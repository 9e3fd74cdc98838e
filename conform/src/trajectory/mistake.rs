//! A mistake made on purpose, and what all lists of them need.

use ancf::model::{Material, Scene, Section, ThermalModel};

use super::motion::Method;
use super::setup::Setup;

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
#[derive(Debug)]
pub struct Family {
    /// Name of the mistake with a value.
    pub what: fn(f64) -> String,
    /// What to look at.
    pub look_at: &'static str,
    /// Values from which the fit starts.
    pub starts: &'static [f64],
    /// The mistake with a value, and the program's step where it is known; `None` where it has no effect.
    pub make: fn(&Setup, f64, Option<f64>) -> Option<Made>,
}

// What to look at.

/// Loads.
pub const LOADS: &str = "the loads f of (23): their sum over elements, sign and history";
/// Heat.
pub const HEAT: &str = "ε_T of (8) and the history ΔT(t)";
/// Constraints.
pub const CONSTRAINTS: &str = "Φ of (23): which coordinates are held, and where";
/// Assembly.
pub const ASSEMBLY: &str =
    "the assembly: blocks of neighbouring elements are added at the coordinates of their common node";
/// Law.
pub const LAW: &str = "D of (16), (17) and the shear of (18)";
/// Inertia.
pub const INERTIA: &str = "M of (7), ρ and the section";
/// Input.
pub const INPUT: &str = "the numbers that are read in";
/// Method.
pub const METHOD: &str = "the time-stepping method";
/// Output.
pub const OUTPUT: &str = "what is written: point, component, sign, unit, time";
/// Mesh.
pub const MESH: &str = "the number and kind of elements";

/// Adds a mistake: what is wrong, what to look at, the change of the setup.
pub type Add<'a> = dyn FnMut(&str, &'static str, &dyn Fn(&mut Setup)) + 'a;

/// Whether there is any weight.
pub fn has_gravity(scene: &Scene) -> bool {
    scene.gravity != [0.0; 2]
}

/// Whether any rod is heated.
pub fn is_heated(scene: &Scene) -> bool {
    scene.rods.iter().filter_map(|rod| scene.heat(rod)).any(|heat| heat.model != ThermalModel::None)
}

/// Changes every material of a scene.
pub fn each_material(scene: &mut Scene, change: impl Fn(&mut Material)) {
    change(&mut scene.material);
    scene.rods.iter_mut().filter_map(|rod| rod.material.as_mut()).for_each(change);
}

/// Changes every section of a scene.
pub fn each_section(scene: &mut Scene, change: impl Fn(&mut Section)) {
    change(&mut scene.section);
    scene.rods.iter_mut().filter_map(|rod| rod.section.as_mut()).for_each(change);
}
