//! Curves over time as SVG: panels above each other that share the axis of time.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::error::{Error, Result};

/// A curve of a panel.
pub struct Curve<'a> {
    /// Its name in the legend.
    pub name: &'a str,
    /// Index into the palette, so that a model has one colour in every picture.
    pub colour: usize,
    /// (time, value).
    pub points: Vec<(f64, f64)>,
}

/// One panel: a quantity over time.
pub struct Panel<'a> {
    /// What stands at its axis, with the unit.
    pub quantity: String,
    /// Its curves.
    pub curves: Vec<Curve<'a>>,
}

/// Okabe and Ito's colours, told apart by the colour-blind too.
const PALETTE: [RGBColor; 5] =
    [RGBColor(0, 0, 0), RGBColor(230, 159, 0), RGBColor(0, 114, 178), RGBColor(0, 158, 115), RGBColor(150, 150, 150)];

const WIDTH: u32 = 960;
const PANEL_HEIGHT: u32 = 320;
const TITLE_HEIGHT: u32 = 44;

/// Draws the panels under a title.
///
/// # Errors
/// [`Error::Picture`] with the library's reason.
pub fn svg(title: &str, panels: &[Panel]) -> Result<String> {
    let mut text = String::new();
    let height = TITLE_HEIGHT + PANEL_HEIGHT * panels.len() as u32;
    draw(title, panels, SVGBackend::with_string(&mut text, (WIDTH, height)))
        .map_err(|reason| Error::Picture { title: title.to_string(), reason: reason.to_string() })?;
    Ok(text)
}

type DrawingResult<'a> = std::result::Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(title: &str, panels: &[Panel], backend: SVGBackend<'a>) -> DrawingResult<'a> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (head, body) = root.split_vertically(TITLE_HEIGHT);
    head.titled(title, ("sans-serif", 20))?;
    for (n, (area, panel)) in body.split_evenly((panels.len(), 1)).iter().zip(panels).enumerate() {
        // The colours mean the same in all panels; the first explains them.
        draw_panel(area, panel, n == 0)?;
    }
    root.present()
}

fn draw_panel<'a>(area: &DrawingArea<SVGBackend<'a>, Shift>, panel: &Panel, legend: bool) -> DrawingResult<'a> {
    let points = || panel.curves.iter().flat_map(|curve| &curve.points);
    let times = extent(points().map(|point| point.0), 0.0);
    let values = extent(points().map(|point| point.1), 0.05);
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(80)
        .build_cartesian_2d(times, values)?;
    chart
        .configure_mesh()
        .x_desc("time t, s")
        .y_desc(panel.quantity.as_str())
        .label_style(("sans-serif", 14))
        .light_line_style(WHITE)
        // Adding 0 turns −0 into 0.
        .y_label_formatter(&|value| format!("{}", (value * 1e6).round() / 1e6 + 0.0))
        .draw()?;
    for curve in &panel.curves {
        let style = PALETTE[curve.colour % PALETTE.len()].stroke_width(2);
        chart
            .draw_series(LineSeries::new(curve.points.iter().copied(), style))?
            .label(curve.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], style));
    }
    if legend {
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerLeft)
            .background_style(WHITE.mix(0.8))
            .label_font(("sans-serif", 14))
            .draw()?;
    }
    Ok(())
}

/// The range of the values, widened on either side by a fraction of itself.
fn extent(values: impl Iterator<Item = f64>, margin: f64) -> Range<f64> {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
    let widen = margin * (high - low);
    low - widen..high + widen
}
