//! Check for keys that other parts of a scene require.
//!
//! In memory these keys always have a value, so that only the text shows whether they were given.

use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::model::check::{Check, require};
use crate::model::choice::Method;
use crate::model::scene::Scene;

/// Keys given in a text.
#[derive(Deserialize)]
struct Given {
    material: GivenMaterial,
    rods: Vec<GivenRod>,
    time: GivenTime,
}

#[derive(Deserialize)]
struct GivenMaterial {
    alpha: Option<IgnoredAny>,
}

#[derive(Deserialize)]
struct GivenRod {
    material: Option<GivenMaterial>,
}

#[derive(Deserialize)]
struct GivenTime {
    end: Option<IgnoredAny>,
}

/// Refuses a `scene` whose `text` leaves out a required key.
pub fn check_missing(scene: &Scene, text: &str) -> Check {
    // A text that is a scene has these parts.
    let Ok(given) = serde_json::from_str::<Given>(text) else { return Ok(()) };
    let ends = given.time.end.is_some() || scene.time.method == Method::Static;
    require(ends, "time.end", "missing", "a value here, the key is required")?;
    for (i, (rod, given_rod)) in scene.rods.iter().zip(&given.rods).enumerate() {
        let material = given_rod.material.as_ref().unwrap_or(&given.material);
        if scene.heat(rod).is_some() && material.alpha.is_none() {
            let part = |own: bool| if own { format!("rods[{i}].") } else { String::new() };
            let (material, heat) = (part(rod.material.is_some()), part(rod.temperature.is_some()));
            let allowed = format_args!("a number; `{heat}temperature` needs it");
            return require(false, format_args!("{material}material.alpha"), "missing", allowed);
        }
    }
    Ok(())
}
