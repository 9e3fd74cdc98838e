//! Pictures of curves over time, in panels one above the other.

use std::ops::Range;

use plotters::prelude::*;

use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;

/// A curve of a panel.
pub struct Curve<'a> {
    /// Its name in the legend.
    pub name: &'a str,
    /// Its colour: a model has one in every picture.
    pub colour: RGBColor,
    /// How it is drawn.
    pub stroke: Stroke,
    /// (time, value).
    pub points: Vec<(f64, f64)>,
}

impl<'a> Curve<'a> {
    /// A line.
    pub fn line(name: &'a str, colour: RGBColor, points: Vec<(f64, f64)>) -> Curve<'a> {
        Curve { name, colour, stroke: Stroke::Line, points }
    }

    /// The area between two curves with the same times.
    pub fn band(name: &'a str, colour: RGBColor, upper: Vec<(f64, f64)>, lower: Vec<(f64, f64)>) -> Curve<'a> {
        let points = upper.into_iter().chain(lower.into_iter().rev()).collect();
        Curve { name, colour, stroke: Stroke::Band, points }
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stroke {
    Line,
    /// Broad and pale, so that a line on top of it does not hide it.
    Broad,
    /// The area inside of the points, pale.
    Band,
}

/// One panel: a quantity over time.
pub struct Panel<'a> {
    /// Label of its axis, with the unit.
    pub quantity: String,
    /// Its curves.
    pub curves: Vec<Curve<'a>>,
    /// Whether its axis has powers of ten.
    pub log: bool,
}

pub const WIDTH: u32 = 960;
/// Height of a panel; in pictures of many the lesser one.
const PANEL_HEIGHTS: [u32; 2] = [320, 200];
const MANY: usize = 3;
const LEGEND_HEIGHT: u32 = 20;
pub const TITLE_HEIGHT: u32 = 44;

/// Parts of a pixel.
const FINE: u32 = 4;

/// Draws the panels under a title.
///
/// # Errors
/// [`Error::Picture`](crate::error::Error::Picture) with the library's reason.
pub fn svg(title: &str, panels: &[Panel]) -> Result<String> {
    let height = PANEL_HEIGHTS[usize::from(panels.len() > MANY)];
    let size = Size { width: WIDTH, head: TITLE_HEIGHT, body: height * panels.len() as u32, parts: FINE };
    canvas::svg(title, size, |_, body| {
        let points = panels.iter().flat_map(|panel| &panel.curves).flat_map(|curve| &curve.points);
        let times = extent(points.map(|point| point.0), 0.0);
        for (n, (area, panel)) in body.split_evenly((panels.len(), 1)).iter().zip(panels).enumerate() {
            // One legend for all panels with the same curves.
            let differs = legend_entries(panel) != legend_entries(&panels[0]);
            let last = n + 1 == panels.len();
            let mut area = area.clone();
            if n == 0 || differs {
                let (legend, rest) = area.split_vertically(LEGEND_HEIGHT * FINE);
                draw_legend(&legend, panel)?;
                area = rest;
            }
            draw_panel(&area, panel, times.clone(), last)?;
        }
        Ok(())
    })
}

fn legend_entries<'a>(panel: &'a Panel<'a>) -> impl PartialEq + 'a {
    panel.curves.iter().map(|curve| (curve.name, curve.stroke)).collect::<Vec<_>>()
}

/// Draws a panel, with the label of the time's axis if it is the last one.
fn draw_panel(area: &Area, panel: &Panel, times: Range<f64>, last: bool) -> Drawn {
    let place = |value: f64| if panel.log { value.log10() } else { value };
    let placed = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let shown = points.iter().map(|(t, value)| (*t, place(*value)));
        shown.filter(|(_, value)| value.is_finite()).collect()
    };
    let points = panel.curves.iter().flat_map(|curve| placed(&curve.points));
    let values = extent(points.map(|point| point.1), 0.05);
    let mut chart = ChartBuilder::on(area)
        .margin(10 * FINE)
        .x_label_area_size(if last { 40 } else { 22 } * FINE)
        .y_label_area_size(80 * FINE)
        .build_cartesian_2d(times.clone(), values.clone())?;
    chart
        .configure_mesh()
        .x_desc(if last { "time t, s" } else { "" })
        .y_desc(panel.quantity.as_str())
        .label_style(("sans-serif", 14 * FINE))
        .axis_style(BLACK.stroke_width(FINE))
        .bold_line_style(BLACK.mix(0.2).stroke_width(FINE))
        .light_line_style(WHITE)
        .set_all_tick_mark_size(5 * FINE)
        .y_label_formatter(&|value| match panel.log {
            true if value.fract() == 0.0 => format!("{}", 10f64.powf(*value)),
            true => String::new(),
            // Adding 0 turns −0 into 0.
            false => format!("{}", (value * 1e6).round() / 1e6 + 0.0).replace('-', "−"),
        })
        .draw()?;
    for curve in &panel.curves {
        let points = placed(&curve.points);
        match curve.stroke {
            Stroke::Band => chart.draw_series([Polygon::new(points, style(curve))])?,
            _ => chart.draw_series(LineSeries::new(envelope(&points), style(curve)))?,
        };
    }
    Ok(())
}

/// The curves' names in one line, each after its colour.
fn draw_legend(area: &Area, panel: &Panel) -> Drawn {
    const LEFT: i32 = 90;
    const SAMPLE: i32 = 22;
    const CHARACTER: f64 = 6.6;
    let fine = FINE as i32;
    let mut x = LEFT;
    for curve in &panel.curves {
        let [from, to] = [x * fine, (x + SAMPLE) * fine];
        match curve.stroke {
            Stroke::Band => area.draw(&Rectangle::new([(from, 7 * fine), (to, 17 * fine)], style(curve)))?,
            _ => area.draw(&PathElement::new([(from, 12 * fine), (to, 12 * fine)], style(curve)))?,
        }
        let text = ("sans-serif", 14 * FINE).into_font();
        area.draw(&Text::new(curve.name.to_string(), (to + 5 * fine, 5 * fine), text))?;
        x += SAMPLE + 18 + (CHARACTER * curve.name.chars().count() as f64) as i32;
    }
    Ok(())
}

/// How a curve is drawn.
fn style(curve: &Curve) -> ShapeStyle {
    let colour = curve.colour;
    match curve.stroke {
        Stroke::Broad => colour.mix(0.35).stroke_width(4 * FINE),
        Stroke::Line => colour.stroke_width(2 * FINE),
        Stroke::Band => colour.mix(0.25).filled(),
    }
}

/// The points; or, of more than the picture can resolve, the least and the largest value of each piece of time, in their order, so that
/// no peak is lost.
fn envelope(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let piece = points.len() / WIDTH as usize;
    if piece < 3 {
        return points.to_vec();
    }
    let extremes = |points: &[(f64, f64)]| {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let mut both = [points.iter().min_by(by_value), points.iter().max_by(by_value)]
            .map(|extreme| extreme.copied().unwrap_or_default());
        both.sort_by(|a, b| a.0.total_cmp(&b.0));
        both
    };
    points.chunks(piece).flat_map(extremes).collect()
}

/// Range of the values, widened on either side by a fraction of itself.
pub fn extent(values: impl Iterator<Item = f64>, margin: f64) -> Range<f64> {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
    let widen = margin * (high - low);
    low - widen..high + widen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_envelope_keeps_every_peak() {
        let points: Vec<(f64, f64)> = (0..20_000).map(|n| (f64::from(n), if n == 7_777 { 9.0 } else { 0.0 })).collect();
        let drawn = envelope(&points);
        assert!(drawn.contains(&(7_777.0, 9.0)) && drawn.len() < 2_100, "{}", drawn.len());
        assert!(drawn.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        assert_eq!(envelope(&points[..500]), &points[..500]);
    }
}
