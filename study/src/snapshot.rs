//! Pictures of a structure at several instants.

use plotters::prelude::*;

use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;
use crate::figure::{TITLE_HEIGHT, WIDTH, extent};
use crate::palette::{BLUE, ORANGE, VERMILLION};

/// A structure at one instant.
pub struct Snapshot {
    /// Title above it.
    pub title: String,
    /// Its rods, from point to point, m.
    pub rods: Vec<Vec<(f64, f64)>>,
    /// Names of its points.
    pub names: Vec<Name>,
    /// Points that are held, and points that slide along y.
    pub held: Vec<(f64, f64)>,
    pub guided: Vec<(f64, f64)>,
    /// A force, from the tail of its arrow to the head.
    pub force: Option<[(f64, f64); 2]>,
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
    const LABELS: (u32, u32) = (40, 60);
    const CAPTION: u32 = 22;
    let of_snapshot = |snapshot: &'_ Snapshot| {
        let rods = snapshot.rods.iter().flatten().copied();
        rods.chain(snapshot.force.into_iter().flatten()).collect::<Vec<_>>()
    };
    let points = || snapshots.iter().flat_map(of_snapshot);
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
        chart
            .configure_mesh()
            .x_desc("x, m")
            .y_desc("y, m")
            .label_style(("sans-serif", 13))
            .light_line_style(WHITE)
            .draw()?;
        for (n, rod) in snapshot.rods.iter().enumerate() {
            let style = [ORANGE, BLUE][n % 2].stroke_width(2);
            chart.draw_series(LineSeries::new(rod.iter().copied(), style).point_size(3))?;
        }
        let triangle =
            |at: &(f64, f64)| EmptyElement::at(*at) + Polygon::new(vec![(0, 0), (-7, 12), (7, 12)], BLACK.mix(0.6));
        chart.draw_series(snapshot.held.iter().map(triangle))?;
        let guide = |at: &(f64, f64)| {
            EmptyElement::at(*at)
                + Circle::new((-6, 0), 4, BLACK.mix(0.6).stroke_width(1))
                + PathElement::new(vec![(-11, -12), (-11, 12)], BLACK.mix(0.6).stroke_width(2))
        };
        chart.draw_series(snapshot.guided.iter().map(guide))?;
        if let Some([tail, head]) = snapshot.force {
            chart.draw_series([PathElement::new([tail, head], VERMILLION.stroke_width(3))])?;
            let tip = Polygon::new(vec![(0, 0), (-5, -10), (5, -10)], VERMILLION);
            chart.draw_series([EmptyElement::at(head) + tip])?;
        }
        for Name { text, at, above } in &snapshot.names {
            let is_held = snapshot.held.contains(at);
            // Beside the arrow, and below the triangle of a support.
            let (across, down) = if *above { (6, -18) } else { (-6, if is_held { 14 } else { 6 }) };
            let label = Text::new(text.clone(), (across, down), ("sans-serif", 12));
            chart.draw_series([EmptyElement::at(*at) + label])?;
        }
    }
    Ok(())
}
