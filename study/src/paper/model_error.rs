//! How far the models of the pendulum are from the plane solid that is heated alike, what that is made of, and what it may be.

use serde::Serialize;

use super::continuum::{Continuum, Solid, Window};
use super::pendulum::{Model, largest_distance};
use super::reference_pendulum;
use crate::error::Result;

/// A model's distance from the solid that is heated alike, in one window, and what it is made of, m.
#[derive(Serialize)]
pub struct ErrorRow {
    pub model: &'static str,
    pub window: Window,
    pub distance: f64,
    /// What twice the elements change.
    pub space: f64,
    /// What twice the step changes.
    pub time: f64,
    /// Uncertainty of the solid.
    pub reference: f64,
    /// What the three leave of the distance, which is the model's own at least; nothing where they can be all of it.
    pub model_error: f64,
}

/// The flexible model's distance from the solid at the shift's times in a window, m, without and with the oracle's shift.
#[derive(Serialize)]
pub struct ShearRow {
    pub window: Window,
    pub distance: f64,
    /// The tip moved by what a shear correction factor of 5/6 would change.
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
    let distance = largest_distance(&solid.tip, &model.tip, window);
    let (space, time, reference) = (model.space_error(window), model.time_error(window), solid.uncertainty(window));
    let model_error = (distance - space - time - reference).max(0.0);
    ErrorRow { model: model.kind.id, window, distance, space, time, reference, model_error }
}

/// The model error of the flexible pendulum is the shear correction that the element does not have (M6).
pub fn shear(models: &[Model], continuum: &Continuum, shear: &reference_pendulum::Shear) -> Result<Vec<ShearRow>> {
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

/// What a model may be off, and until when, m and s.
const BARS: [(&str, f64, f64); 4] = [
    ("flexible", 1.0, 7.5e-5),
    ("flexible", 2.0, 1.5e-4),
    ("2d-relaxed", 2.0, 5e-4),
    // Later the missing shear correction parts it from the solid by millimetres, whatever the mesh.
    ("2d-sudden", 0.5, 5e-4),
];

/// What the solid's own uncertainty may be, and until when, m and s.
const SOLID_BARS: [(&str, f64, f64); 2] = [("flexible", 0.5, 1e-5), ("2d-sudden", 0.5, 1e-4)];

/// The bars: for the distance from the solid, for the solid itself, and for what a shear correction must leave of the distance.
pub fn bars(models: &[Model], rows: &[ErrorRow], shear: &[ShearRow]) -> Vec<reference_pendulum::Row> {
    let bar = |&(model, until, bound): &(&str, f64, f64)| {
        let step = models.iter().find(|known| known.kind.id == model).map_or(f64::NAN, |model| model.kind.mesh.step);
        let its = || rows.iter().filter(|row| row.model == model && row.window.to <= until);
        let largest = |of: fn(&ErrorRow) -> f64| largest_of(its().map(of));
        reference_pendulum::Row {
            run: format!("{model} to {until} s"),
            step,
            largest_distance: largest(|row| row.distance),
            oracle_error: largest(|row| row.reference),
            bound,
        }
    };
    let solid = |&(model, until, bound): &(&str, f64, f64)| reference_pendulum::Row {
        run: format!("solid, {model}"),
        largest_distance: bar(&(model, until, bound)).oracle_error,
        ..bar(&(model, until, bound))
    };
    let corrected = reference_pendulum::Row {
        run: "with shear 5/6".into(),
        largest_distance: largest_of(shear.iter().map(|row| row.corrected)),
        bound: 0.5 * largest_of(shear.iter().map(|row| row.distance)),
        ..bar(&("flexible", 2.0, 0.0))
    };
    BARS.iter().map(bar).chain(SOLID_BARS.iter().map(solid)).chain([corrected]).collect()
}

/// Not a number where there are none.
fn largest_of(values: impl Iterator<Item = f64>) -> f64 {
    values.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
