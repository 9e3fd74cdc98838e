//! Checks of temperatures: histories in order of time, strains within the strain measure, and a possible start.

use std::collections::BTreeSet;
use std::fmt::Display;

use super::history::check_history;
use crate::model::check::{Check, require};
use crate::model::choice::{Element, Start, ThermalModel};
use crate::model::heat::Temperature;
use crate::model::rod::Rod;
use crate::model::scene::Scene;

/// Checks the temperatures of the scene and of its rods.
pub(in crate::model) fn check_heat(scene: &Scene) -> Check {
    if let Some(temperature) = &scene.temperature {
        check_history("temperature.history", &temperature.history)?;
    }
    for (i, rod) in scene.rods.iter().enumerate() {
        if let Some(temperature) = &rod.temperature {
            check_history(format_args!("rods[{i}].temperature.history"), &temperature.history)?;
        }
    }
    for (i, rod) in scene.rods.iter().enumerate() {
        let Some(heat) = scene.heat(rod) else { continue };
        match &rod.temperature {
            Some(_) => check_rod(scene, rod, heat, format_args!("rods[{i}].temperature"))?,
            None => check_rod(scene, rod, heat, "temperature")?,
        }
    }
    Ok(())
}

/// Checks a temperature that strains a rod; `key` is where it is given.
fn check_rod(scene: &Scene, rod: &Rod, heat: &Temperature, key: impl Display) -> Check {
    let allowed = format_args!(
        "\"2d\", \"1d\" or \"none\" for the rod `{}`: its element \"euler-bernoulli\" has no section that heat could \
         strain across, so that nothing would happen; a rod may have a `temperature` of its own",
        rod.name
    );
    let has_section = rod.element == Element::Ancf;
    require(
        has_section || heat.model != ThermalModel::Transverse,
        format_args!("{key}.model"),
        "\"transverse\"",
        allowed,
    )?;
    require(!heat.history.is_empty(), format_args!("{key}.history"), "[]", "at least one pair [t, dT]")?;
    let alpha = scene.material(rod).alpha;
    // The square of the stress-free stretch, or that stretch itself.
    let (factor, stretch) = match rod.element {
        Element::Ancf => (2.0, "1 + 2 alpha dT"),
        Element::EulerBernoulli => (1.0, "1 + alpha dT"),
    };
    // ΔT is linear between the pairs, so that the stretch is smallest at one of them.
    for (i, &[_, change]) in heat.history.iter().enumerate() {
        let limit = -1.0 / (factor * alpha);
        let side = if alpha > 0.0 { "over" } else { "under" };
        let rod = &rod.name;
        let allowed = format_args!("dT {side} {limit:.6e} K, where {stretch} stays positive in the rod `{rod}`");
        let key = format_args!("{key}.history[{i}][1]");
        require(1.0 + factor * alpha * change > 0.0, key, format_args!("{change:?}"), allowed)?;
    }
    if heat.start == Start::Sudden {
        return Ok(());
    }
    let rods = scene.rods.len();
    let held = scene.supports.iter().map(|support| &support.point).collect::<BTreeSet<_>>().len();
    let allowed = format_args!(
        "\"sudden\"; \"relaxed\" needs a single rod that is held at no more than one point, so that it can stretch \
         freely (here: rods {rods}, points held {held})"
    );
    require(rods == 1 && held <= 1, format_args!("{key}.start"), "\"relaxed\"", allowed)
}
