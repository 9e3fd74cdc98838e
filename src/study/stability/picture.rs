//! The pictures: error over the swept parameter, both logarithmic, with the bounds drawn in.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;

use super::Swept;
use super::row::{Row, Verdict};
use crate::error::{Error, Result};

/// Okabe and Ito's colours, as in the other pictures.
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(230, 159, 0),
    RGBColor(0, 158, 115),
    RGBColor(213, 94, 0),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(90, 90, 90),
];

const WIDTH: u32 = 1120;
const PANEL_HEIGHT: u32 = 380;
const TITLE_HEIGHT: u32 = 44;
const COLUMNS: usize = 2;

/// What is less than this is drawn there: there is no zero on a logarithmic axis.
const LEAST: f64 = 1e-18;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type DrawingResult<'a> = std::result::Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

/// A panel for each case that has a parameter to sweep.
///
/// # Errors
/// [`Error::Picture`] with the library's reason.
pub fn svg(cases: &[Swept]) -> Result<String> {
    let drawn: Vec<&Swept> = cases.iter().filter(|swept| swept.rows.iter().any(|row| row.error.is_some())).collect();
    let height = TITLE_HEIGHT + PANEL_HEIGHT * drawn.len().div_ceil(COLUMNS).max(1) as u32;
    let title = "Stiff and extreme cases: errors (marks), bounds (lines), refused (crosses at the top)";
    let mut text = String::new();
    draw(title, &drawn, SVGBackend::with_string(&mut text, (WIDTH, height)))
        .map_err(|reason| Error::Picture { title: title.into(), reason: reason.to_string() })?;
    Ok(text)
}

fn draw<'a>(title: &str, cases: &[&Swept], backend: SVGBackend<'a>) -> DrawingResult<'a> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (head, body) = root.split_vertically(TITLE_HEIGHT);
    head.titled(title, ("sans-serif", 20))?;
    let rows = cases.len().div_ceil(COLUMNS).max(1);
    for (area, swept) in body.split_evenly((rows, COLUMNS)).iter().zip(cases) {
        panel(area, swept)?;
    }
    root.present()
}

/// The size of a parameter: some are negative, and logarithms know no sign.
fn size(row: &Row) -> f64 {
    row.value.abs()
}

fn panel<'a>(area: &Area<'a>, swept: &Swept) -> DrawingResult<'a> {
    let rows = || swept.rows.iter();
    let values = decades(rows().map(size));
    let numbers = rows().flat_map(|row| [row.error, row.bound, row.beside]).flatten();
    let errors = decades(numbers.map(|value| value.max(LEAST)));
    let top = errors.end;
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .caption(swept.case.name, ("sans-serif", 16))
        .x_label_area_size(40)
        .y_label_area_size(70)
        .build_cartesian_2d(values.clone().log_scale(), errors.clone().log_scale())?;
    let power = |value: &f64| format!("{value:.0e}");
    chart
        .configure_mesh()
        .x_desc(format!("|{}|", swept.case.parameter))
        .y_desc(format!("error, {}", swept.case.unit))
        .label_style(("sans-serif", 12))
        .light_line_style(WHITE)
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .draw()?;
    let mut variants: Vec<&str> = rows().map(|row| row.variant.as_str()).collect();
    variants.dedup();
    for (number, variant) in variants.iter().enumerate() {
        let colour = PALETTE[number % PALETTE.len()];
        let own = || rows().filter(|row| row.variant == *variant);
        let place = |row: &Row, value: Option<f64>| {
            let value = value.filter(|value| value.is_finite())?;
            Some((size(row).clamp(values.start, values.end), value.clamp(errors.start, errors.end)))
        };
        let mut bounds: Vec<(f64, f64)> = own().filter_map(|row| place(row, row.bound)).collect();
        bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
        chart.draw_series(LineSeries::new(bounds, colour.mix(0.5).stroke_width(1)))?;
        let style = |row: &Row| if row.verdict == Verdict::Wrong { RED.filled() } else { colour.filled() };
        let marks = own().filter_map(|row| Some(Circle::new(place(row, row.error)?, 3, style(row))));
        chart.draw_series(marks)?;
        let beside = own().filter_map(|row| Some(Circle::new(place(row, row.beside)?, 3, colour.stroke_width(1))));
        chart.draw_series(beside)?;
        let refused = own().filter(|row| row.error.is_none());
        chart.draw_series(
            refused.map(|row| Cross::new((size(row).clamp(values.start, values.end), top), 4, style(row))),
        )?;
    }
    Ok(())
}

/// The decades that hold the positive values.
fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values
        .filter(|value| value.is_finite() && *value > 0.0)
        .fold((f64::MAX, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
    if high == 0.0 {
        return 1e-1..1e1;
    }
    let (low, high) = (low.log10().floor(), high.log10().ceil());
    10f64.powf(low)..10f64.powf(high.max(low + 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_what_is_positive() {
        let range = decades([0.0, -1.0, f64::NAN, 3e-5, 200.0].into_iter());
        assert!((range.start / 1e-5 - 1.0).abs() < 1e-12 && (range.end / 1e3 - 1.0).abs() < 1e-12);
        assert_eq!(decades([0.0].into_iter()), 1e-1..1e1);
    }
}
