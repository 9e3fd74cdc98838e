//! Checks of the imperfection: one shape, a size that it can have, and elements that can be deviated.

use super::topology::check_rod;
use crate::model::check::{Check, require};
use crate::model::choice::{Element, Form, Start};
use crate::model::imperfection::Imperfection;
use crate::model::scene::Scene;

/// Highest number of a mode.
const HIGHEST_MODE: usize = 50;

/// Largest amplitude relative to the structure's size, or to the bowed rod: beyond, a sine is no longer the shape of a
/// rod that keeps its length.
const LARGEST_AMPLITUDE: f64 = 0.1;

/// Checks the imperfection.
pub(in crate::model) fn check_imperfection(scene: &Scene) -> Check {
    let Some(Imperfection { mode, rod, amplitude }) = &scene.imperfection else { return Ok(()) };
    let shapes = usize::from(mode.is_some()) + usize::from(rod.is_some());
    let value = if shapes == 2 { "both `mode` and `rod`" } else { "neither `mode` nor `rod`" };
    require(shapes == 1, "imperfection", value, "one of the two shapes: `mode` or `rod`")?;
    check_elements(scene)?;
    let size = match rod {
        Some(rod) => check_bowed(scene, rod)?,
        None => scene.size(),
    };
    if let Some(mode) = mode {
        let allowed = format_args!("a whole number from 1 to {HIGHEST_MODE}");
        require((1..=HIGHEST_MODE).contains(mode), "imperfection.mode", mode, allowed)?;
    }
    let largest = LARGEST_AMPLITUDE * size;
    let allowed = format_args!("a number between {:?} and {largest:?} m, a tenth of the size, but not 0", -largest);
    let holds = *amplitude != 0.0 && amplitude.abs() <= largest;
    require(holds, "imperfection.amplitude", format_args!("{amplitude:?}"), allowed)
}

/// Strains that are measured from a deviated shape have to be quadratic in the coordinates.
fn check_elements(scene: &Scene) -> Check {
    let other = scene.rods.iter().find(|rod| rod.element != Element::Ancf);
    let name = other.map_or("", |rod| &rod.name);
    let allowed = format_args!(
        "no imperfection of Euler–Bernoulli elements, whose curvature is not quadratic in their coordinates (here: the rod \
         `{name}`); \"element\": \"ancf\" can be deviated, or a small force across it takes the place of the imperfection"
    );
    require(other.is_none(), "imperfection", "given", allowed)?;
    let allowed = "no imperfection with \"form\": \"printed-shear\", whose energy depends on the frame: a rotation of the \
                   deviated rod would strain it; \"consistent\" has it";
    require(scene.form == Form::Consistent, "imperfection", "given", allowed)?;
    let relaxed = scene.rods.iter().filter_map(|rod| scene.heat(rod)).any(|heat| heat.start == Start::Relaxed);
    let allowed = "no imperfection with \"start\": \"relaxed\", whose stress-free stretch is that of a straight rod; \
                   \"sudden\" with a history from 0 on heats a deviated one";
    require(!relaxed, "imperfection", "given", allowed)
}

/// Length of the bowed rod, m. Nothing may hold it between its ends.
fn check_bowed(scene: &Scene, name: &str) -> Result<f64, crate::model::check::Refusal> {
    check_rod(scene, "imperfection.rod", name, None)?;
    let pivot = scene.rods.iter().find(|rod| rod.name == name && rod.pivot.is_some());
    let allowed = "a rod without `pivot`, where others would be pulled along; an imperfection in the shape of a `mode` moves them \
                   together";
    require(pivot.is_none(), "imperfection.rod", format_args!("{name:?}"), allowed)?;
    Ok(scene.rods.iter().find(|rod| rod.name == name).map_or(0.0, |rod| scene.length(rod)))
}
