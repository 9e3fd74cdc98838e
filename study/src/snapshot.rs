//! Pictures as SVG: a structure at several instants.

use plotters::prelude::*;

use super::figure::{DrawingResult, TITLE_HEIGHT, WIDTH, extent};
use super::palette::{BLUE, ORANGE};
use crate::error::{Error, Result};

/// A structure at one instant.
pub struct Snapshot {
    /// What stands above it.
    pub title: String,
    /// Its rods, from point to point, m.
    pub rods: Vec<Vec<(f64, f64)>>,
    /// Names of its points.
    pub names: Vec<Name>,
}

/// The name of a point.
pub struct Name {
    /// The name.
    pub text: String,
    /// Where the point is, m.
    pub at: (f64, f64),
    /// Whether it is written above the point, or below.
    pub above: bool,
}

const COLUMNS: usize = 2;
const HEIGHT: u32 = 240;

/// Draws snapshots beside and below each other, all to the same scale, x and y alike.
///
/// # Errors
/// [`Error::Picture`] with the library's reason.
pub fn svg(title: &str, snapshots: &[Snapshot]) -> Result<String> {
    let mut text = String::new();
    let rows = snapshots.len().div_ceil(COLUMNS);
    let height = TITLE_HEIGHT + HEIGHT * rows as u32;
    draw(title, snapshots, rows, SVGBackend::with_string(&mut text, (WIDTH, height)))
        .map_err(|reason| Error::Picture { title: title.to_string(), reason: reason.to_string() })?;
    Ok(text)
}

fn draw<'a>(title: &str, snapshots: &[Snapshot], rows: usize, backend: SVGBackend<'a>) -> DrawingResult<'a> {
    const MARGIN: u32 = 10;
    const LABELS: (u32, u32) = (30, 60);
    const CAPTION: u32 = 22;
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (head, body) = root.split_vertically(TITLE_HEIGHT);
    head.titled(title, ("sans-serif", 20))?;
    let points = || snapshots.iter().flat_map(|snapshot| snapshot.rods.iter().flatten());
    let (x, y) = (extent(points().map(|point| point.0), 0.05), extent(points().map(|point| point.1), 0.15));
    // One metre is as long on both axes: the axis with room to spare reaches further.
    let width = f64::from(WIDTH / COLUMNS as u32 - LABELS.1 - 2 * MARGIN);
    let height = f64::from(HEIGHT - LABELS.0 - CAPTION - 2 * MARGIN);
    let pixel = ((x.end - x.start) / width).max((y.end - y.start) / height);
    let (x, y) = (x.start..x.start + pixel * width, y.start..y.start + pixel * height);
    for (area, snapshot) in body.split_evenly((rows, COLUMNS)).iter().zip(snapshots) {
        let mut chart = ChartBuilder::on(area)
            .margin(MARGIN)
            .caption(&snapshot.title, ("sans-serif", 15))
            .x_label_area_size(LABELS.0)
            .y_label_area_size(LABELS.1)
            .build_cartesian_2d(x.clone(), y.clone())?;
        chart.configure_mesh().y_desc("m").label_style(("sans-serif", 13)).light_line_style(WHITE).draw()?;
        for (n, rod) in snapshot.rods.iter().enumerate() {
            let style = [ORANGE, BLUE][n % 2].stroke_width(2);
            chart.draw_series(LineSeries::new(rod.iter().copied(), style).point_size(3))?;
        }
        for Name { text, at, above } in &snapshot.names {
            let away = if *above { -18 } else { 6 };
            let label = Text::new(text.clone(), (-6, away), ("sans-serif", 12));
            chart.draw_series([EmptyElement::at(*at) + label])?;
        }
    }
    root.present()
}
