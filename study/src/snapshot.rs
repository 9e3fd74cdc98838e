//! Pictures of a structure at several instants.

use plotters::prelude::*;

use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;
use crate::figure::{TITLE_HEIGHT, WIDTH, extent};
use crate::palette::{BLUE, ORANGE};

/// A structure at one instant.
pub struct Snapshot {
    /// Title above it.
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
    /// Position of the point, m.
    pub at: (f64, f64),
    /// Written above the point, or below.
    pub above: bool,
}

const COLUMNS: usize = 2;
const HEIGHT: u32 = 240;

/// Draws snapshots in rows of two, all to one scale, x and y alike.
///
/// # Errors
/// [`Error::Picture`](crate::error::Error::Picture) with the library's reason.
pub fn svg(title: &str, snapshots: &[Snapshot]) -> Result<String> {
    let rows = snapshots.len().div_ceil(COLUMNS);
    let size = Size { width: WIDTH, head: TITLE_HEIGHT, body: HEIGHT * rows as u32, parts: 1 };
    canvas::svg(title, size, |_, body| draw(body, snapshots, rows))
}

fn draw(body: &Area, snapshots: &[Snapshot], rows: usize) -> Drawn {
    const MARGIN: u32 = 10;
    const LABELS: (u32, u32) = (30, 60);
    const CAPTION: u32 = 22;
    let points = || snapshots.iter().flat_map(|snapshot| snapshot.rods.iter().flatten());
    let (x, y) = (extent(points().map(|point| point.0), 0.05), extent(points().map(|point| point.1), 0.15));
    // One metre is as long on both axes: the axis with room to spare reaches farther.
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
    Ok(())
}
