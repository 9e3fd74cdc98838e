//! Distances of the pendulum's models from the plane solid with the same heat, their parts, and their bounds.

use serde::Serialize;

use super::comparison::Comparison;
use super::continuum::{Continuum, Solid};
use super::pendulum::Model;
use super::reference_pendulum::Shear;
use super::window::Window;
use crate::error::Result;
use crate::path::largest_of;

/// A model's distance from the solid in one window, and its parts, m.
#[derive(Serialize)]
pub struct ErrorRow {
    pub model: &'static str,
    pub window: Window,
    pub distance: f64,
    /// Change by twice the elements.
    pub space: f64,
    /// Change by twice the step.
    pub time: f64,
    /// Uncertainty of the solid.
    pub reference: f64,
    /// Distance minus these three, a lower bound of the model's error; 0 if they may be all of the distance.
    pub model_error: f64,
}

/// The flexible model's distance from the solid in a window, m, without and with the shear correction.
#[derive(Serialize)]
pub struct ShearRow {
    pub window: Window,
    pub distance: f64,
    /// With the tip shifted by the effect of a shear correction factor of 5/6.
    pub corrected: f64,
}

/// Every model's distance from its solid.
pub fn errors(models: &[Model], continuum: &Continuum) -> Result<Vec<ErrorRow>> {
    let mut rows = Vec::new();
    for model in models {
        let solid = continuum.solid(model.kind.solid)?;
        rows.extend(continuum.windows().map(|window| error(model, &solid, window)));
    }
    Ok(rows)
}

fn error(model: &Model, solid: &Solid, window: Window) -> ErrorRow {
    let distance = model.tip.largest_distance_in(&solid.tip, window);
    let (space, time, reference) = (model.space_error(window), model.time_error(window), solid.uncertainty(window));
    let model_error = (distance - space - time - reference).max(0.0);
    ErrorRow { model: model.kind.id, window, distance, space, time, reference, model_error }
}

/// Effect of a shear correction, which the element does not have, on the distance of the flexible pendulum (M6).
pub fn shear(models: &[Model], continuum: &Continuum, shear: &Shear) -> Result<Vec<ShearRow>> {
    let Some(flexible) = models.iter().find(|model| model.kind.id == "flexible") else { return Ok(Vec::new()) };
    let solid = continuum.solid("flexible")?;
    let row = |window: Window| {
        let largest = |part: f64| {
            let shifts = shear.t.iter().zip(&shear.shift).filter(|(t, _)| window.contains(**t));
            let distance = |(t, [dx, dy]): (&f64, &[f64; 2])| {
                let [x, y] = flexible.tip.at(*t);
                solid.tip.distance(*t, [x + part * dx, y + part * dy])
            };
            largest_of(shifts.map(distance))
        };
        ShearRow { window, distance: largest(0.0), corrected: largest(1.0) }
    };
    Ok(continuum.windows().map(row).collect())
}

/// Models, ends of their comparison, s, and bounds of their distances, m.
const BARS: [(&str, f64, f64); 4] = [
    ("flexible", 1.0, 7.5e-5),
    ("flexible", 2.0, 1.5e-4),
    ("2d-relaxed", 2.0, 5e-4),
    // Later the missing shear correction makes a distance of millimetres, whatever the mesh.
    ("2d-sudden", 0.5, 5e-4),
];

/// Models, ends, s, and bounds of the solid's own uncertainty, m.
const SOLID_BARS: [(&str, f64, f64); 2] = [("flexible", 0.5, 1e-5), ("2d-sudden", 0.5, 1e-4)];

/// All bounds: of the distance from the solid, of the solid's uncertainty, and of the distance with a shear correction, half of that without.
pub fn bars(models: &[Model], rows: &[ErrorRow], shear: &[ShearRow]) -> Vec<Comparison> {
    let bar = |&(model, until, bound): &(&str, f64, f64)| {
        let step = models.iter().find(|known| known.kind.id == model).map_or(f64::NAN, |model| model.kind.mesh.step);
        let its = || rows.iter().filter(|row| row.model == model && row.window.to <= until);
        let largest = |of: fn(&ErrorRow) -> f64| largest_of(its().map(of));
        Comparison {
            run: format!("{model} to {until} s"),
            step,
            largest_distance: largest(|row| row.distance),
            oracle_error: largest(|row| row.reference),
            bound,
        }
    };
    let solid = |&(model, until, bound): &(&str, f64, f64)| Comparison {
        run: format!("solid, {model}"),
        largest_distance: bar(&(model, until, bound)).oracle_error,
        ..bar(&(model, until, bound))
    };
    let corrected = Comparison {
        run: "with shear 5/6".into(),
        largest_distance: largest_of(shear.iter().map(|row| row.corrected)),
        bound: 0.5 * largest_of(shear.iter().map(|row| row.distance)),
        ..bar(&("flexible", 2.0, 0.0))
    };
    BARS.iter().map(bar).chain(SOLID_BARS.iter().map(solid)).chain([corrected]).collect()
}
