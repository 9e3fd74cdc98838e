//! Natural frequencies and shapes of a structure about an equilibrium.

use nalgebra::DVector;

use super::equilibrium_scene::{About, equilibrium_scene};
use super::simulation::Simulation;
use crate::error::{Error, Result};
use crate::model::{self, Model, Scene};
use crate::structure::Structure;

pub use crate::structure::Kind;

/// Most modes: their vectors are kept, and each is a vector of all unknowns.
const MOST_MODES: usize = 200;

/// Points of a rod in a shape, at least, and for each element.
const POINTS: (usize, usize) = (17, 4);

/// Most points of a rod in a shape.
const MOST_POINTS: usize = 129;

/// Mode of a structure.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Mode {
    /// Square of the angular frequency, (rad/s)²; zero for a motion without a force, negative for a deviation that grows.
    pub square: f64,
    /// What moves.
    pub kind: Kind,
    /// Displacements [x, y] of the axes, rod by rod in the scene's order, at [`Modes::at`]; the largest is 1.
    pub shape: Vec<Vec<[f64; 2]>>,
}

impl Mode {
    /// Frequency, Hz; `None` for a deviation that grows.
    pub fn frequency(&self) -> Option<f64> {
        (self.square >= 0.0).then(|| self.square.sqrt() / std::f64::consts::TAU)
    }

    /// Rate μ of a deviation that grows like e^(μt), 1/s.
    pub fn growth(&self) -> Option<f64> {
        (self.square < 0.0).then(|| (-self.square).sqrt())
    }
}

/// Modes of a structure about an equilibrium, slowest first.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Modes {
    /// State that they are about.
    pub about: About,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Fractions of the length at which each rod's shape is sampled.
    pub at: Vec<Vec<f64>>,
    /// Positions [x, y] of the axes in the equilibrium, m.
    pub equilibrium: Vec<Vec<[f64; 2]>>,
    /// Motions without a force, then deviations that grow, then vibrations.
    pub modes: Vec<Mode>,
}

impl Modes {
    /// Number of modes of a kind.
    pub fn count(&self, kind: Kind) -> usize {
        self.modes.iter().filter(|mode| mode.kind == kind).count()
    }
}

/// The `number` slowest vibrations of a model's structure about an equilibrium, after all motions without a force and all
/// deviations that grow. Loads and heat are those at the scene's end.
///
/// ```
/// use ancf::model::{Element, Material, Rod, Scene, Section, Support};
/// use ancf::run::{About, Kind, modes};
///
/// let scene = Scene::new(Material::new(2e8, 0.0, 7750.0), Section::new(0.02, 0.02))
///     .point("a", [0.0, 0.0])
///     .point("b", [1.0, 0.0])
///     .rod(Rod::new("rod", "a", "b").elements(Element::Ancf, 16));
/// let free = modes(&scene.clone().build()?, About::Unloaded, 3)?;
/// assert_eq!((free.count(Kind::Rigid), free.count(Kind::Vibration)), (3, 3));
///
/// let held = scene.support(Support::pinned("a")).support(Support::sliding("b", [1.0, 0.0]));
/// let first = &modes(&held.build()?, About::Unloaded, 3)?.modes[0];
/// let euler = 0.5 * std::f64::consts::PI * (2e8 * 0.02_f64.powi(2) / 12.0 / 7750.0).sqrt();
/// assert!((first.frequency().unwrap() / euler - 1.0).abs() < 1e-3);
/// # Ok::<(), ancf::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Scene`] for no mode or more than 200; [`Error::Drifts`] for the equilibrium of a mechanism under loads or heat, and the
/// other errors of statics.
pub fn modes(model: &Model, about: About, number: usize) -> Result<Modes> {
    if !(1..=MOST_MODES).contains(&number) {
        let allowed = format!("a whole number from 1 to {MOST_MODES}");
        return Err(refused("number", number.to_string(), allowed));
    }
    let own = equilibrium_scene(model.scene(), about, 1.0)?;
    let scene = own.scene().clone();
    // Under loads or heat there is none: statics refuses mechanisms.
    let free = if about == About::Unloaded { Structure::degrees_of_freedom(&own)? } else { 0 };
    let (structure, u, load) = if about == About::Unloaded {
        let structure = Structure::new(own)?;
        let start = structure.start().clone();
        (structure, start, 0.0)
    } else {
        let mut statics = Simulation::of(own)?;
        statics.run_until(1.0)?;
        (statics.structure().clone(), statics.state().u.clone(), statics.state().load)
    };
    let found = structure.slowest_vibrations(&u, &structure.thermal_strains(load), free, number, square_scale(&scene));
    let not_found = || {
        let allowed = "fewer modes, or a structure of fewer rods: these did not converge; the slowest vibrations of a long \
                       chain are lost in the rounding of the fastest";
        refused("number", number.to_string(), allowed.into())
    };
    let found = found.ok_or_else(not_found)?;
    let at = fractions(&scene);
    let modes = found.iter().map(|mode| {
        let shape = shape(&structure, &scene, &at, &mode.shape)?;
        Ok(Mode { square: mode.square, kind: mode.kind, shape })
    });
    Ok(Modes {
        about,
        unknowns: structure.size(),
        equilibrium: axes(&structure, &scene, &at, &u)?,
        modes: modes.collect::<Result<_>>()?,
        at,
    })
}

pub(super) fn refused(key: &str, value: String, allowed: String) -> Error {
    Error::Scene { file: "modes".into(), key: key.into(), value, allowed }
}

/// Square of the angular frequency of the slowest rod by itself, simply supported.
fn square_scale(scene: &Scene) -> f64 {
    let of = |rod: &model::Rod| {
        let (material, height) = (scene.material(rod), scene.section(rod).height);
        let wave = std::f64::consts::PI / scene.length(rod);
        material.youngs_modulus * height * height / (12.0 * material.rho) * wave.powi(4)
    };
    scene.rods.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// Fractions at which the rods are sampled.
pub(super) fn fractions(scene: &Scene) -> Vec<Vec<f64>> {
    let (least, each) = POINTS;
    let of = |rod: &model::Rod| {
        let count = (each * rod.elements + 1).clamp(least, MOST_POINTS);
        (0..count).map(|n| n as f64 / (count - 1) as f64).collect()
    };
    scene.rods.iter().map(of).collect()
}

/// Positions of the axes.
pub(super) fn axes(
    structure: &Structure,
    scene: &Scene,
    at: &[Vec<f64>],
    u: &DVector<f64>,
) -> Result<Vec<Vec<[f64; 2]>>> {
    let of = |(rod, at): (&model::Rod, &Vec<f64>)| {
        let rod = structure.rod(&rod.name)?;
        Ok(at.iter().map(|&at| structure.axis(rod, at, u).0.into()).collect())
    };
    scene.rods.iter().zip(at).map(of).collect()
}

/// Displacements of the axes, scaled to a largest one of 1. The first point that moves nearly so far moves to the left of its rod, or
/// forward.
pub(super) fn shape(
    structure: &Structure,
    scene: &Scene,
    at: &[Vec<f64>],
    shape: &DVector<f64>,
) -> Result<Vec<Vec<[f64; 2]>>> {
    let scaled = shape / structure.farthest(shape);
    let of = |(rod, at): (&model::Rod, &Vec<f64>)| {
        let rod = structure.rod(&rod.name)?;
        Ok(at.iter().map(|&at| structure.axis_displacement(rod, at, &scaled).into()).collect())
    };
    scene.rods.iter().zip(at).map(of).collect()
}
