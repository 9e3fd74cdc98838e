//! The picture: of each case one error with its bound over the swept parameter. Both axes are logarithmic, but for angles.

use std::collections::BTreeMap;

use plotters::coord::combinators::BindKeyPoints;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;

use super::row::{StabilityRow, Verdict};
use super::study::Swept;
use crate::axis::{decades, power_label, ticks};
use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;
use crate::palette::{BLUE, GREY, VERMILLION};

/// Errors below are drawn here: a logarithmic axis has no zero.
const LEAST: f64 = 1e-18;

const PANEL_HEIGHT: u32 = 250;
const COLUMNS: usize = 3;
const FONT: (&str, u32) = ("sans-serif", 16);

/// A panel for each case that is a sweep: errors at two values or more.
///
/// # Errors
/// [`Error::Picture`](crate::error::Error::Picture) with the library's reason.
pub fn svg(cases: &[Swept]) -> Result<String> {
    let is_swept = |swept: &&Swept| {
        let mut values = swept.rows.iter().filter(|row| row.error.is_some()).map(|row| row.value);
        values.next().is_some_and(|first| values.any(|value| value != first))
    };
    let drawn: Vec<&Swept> = cases.iter().filter(is_swept).collect();
    let rows = drawn.len().div_ceil(COLUMNS).max(1);
    let size = Size { width: 1020, head: 72, body: PANEL_HEIGHT * rows as u32, parts: 1 };
    canvas::svg("Stiff and extreme cases", size, |key, body| {
        legend(key)?;
        body.split_evenly((rows, COLUMNS)).iter().zip(drawn).try_for_each(|(area, swept)| panel(area, swept))
    })
}

/// The marks.
fn legend(area: &Area) -> Drawn {
    let text = |words: &str, x: i32| area.draw(&Text::new(words.to_string(), (x, 4), FONT));
    let dot = |x: i32, style: ShapeStyle| area.draw(&Circle::new((x, 12), 5, style));
    dot(20, BLUE.filled())?;
    text("error nearest to its bound", 32)?;
    dot(255, BLUE.stroke_width(2))?;
    text("… with a warning", 267)?;
    area.draw(&PathElement::new([(415, 12), (455, 12)], GREY.stroke_width(3)))?;
    text("its bound", 462)?;
    area.draw(&Cross::new((560, 12), 5, VERMILLION.stroke_width(2)))?;
    text("something refused, with the reason", 572)?;
    dot(860, RED.filled())?;
    text("WRONG", 872)
}

/// At each value of the parameter the variant whose error is nearest to its bound, in order of values.
fn nearest(rows: &[StabilityRow]) -> Vec<&StabilityRow> {
    let mut of: BTreeMap<u64, &StabilityRow> = BTreeMap::new();
    let part = |row: &StabilityRow| row.error.zip(row.bound).map_or(0.0, |(error, bound)| error / bound);
    for row in rows.iter().filter(|row| row.error.is_some()) {
        let known = of.entry(row.value.to_bits()).or_insert(row);
        // A row that is WRONG is shown, whatever stands beside it.
        let is_shown = |row: &StabilityRow| (row.verdict == Verdict::Wrong, part(row));
        if is_shown(row) > is_shown(known) {
            *known = row;
        }
    }
    let mut nearest: Vec<&StabilityRow> = of.into_values().collect();
    nearest.sort_by(|a, b| a.value.total_cmp(&b.value));
    nearest
}

/// The panel of a case, with the axis that suits its parameter.
fn panel(area: &Area, swept: &Swept) -> Drawn {
    let parameter = swept.case.parameter;
    if parameter.ends_with('°') {
        return chart(area, swept, parameter, 0.0..90.0, &|degrees| format!("{degrees}"), Some);
    }
    let from_half = parameter == "ν";
    let values = || swept.rows.iter().map(|row| row.value);
    // Poisson's ratios crowd towards ½.
    let size = move |value: f64| if from_half { 0.5 - value } else { value.abs() };
    let title = match parameter {
        "ν" => "½ − ν".into(),
        _ if values().any(|value| value < 0.0) => format!("|{parameter}|"),
        _ => parameter.into(),
    };
    let range = decades(values().map(size));
    let axis = range.clone().log_scale().with_key_points(ticks(&range));
    let place = |value: f64| {
        let size = Some(size(value)).filter(|size| size.is_finite() && (*size > 0.0 || !from_half));
        size.map(|size| size.clamp(range.start, range.end))
    };
    chart(area, swept, &title, axis, &power_label, place)
}

fn chart<X: AsRangedCoord<Value = f64>>(
    area: &Area,
    swept: &Swept,
    title: &str,
    axis: X,
    label: &dyn Fn(&f64) -> String,
    across: impl Fn(f64) -> Option<f64>,
) -> Drawn
where
    X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let rows = nearest(&swept.rows);
    let numbers = rows.iter().flat_map(|row| [row.error, row.bound]).flatten();
    let errors = decades(numbers.filter(|number| !number.is_nan()).map(|number| number.max(LEAST)));
    let up = |value: f64| value.is_finite().then(|| value.clamp(errors.start, errors.end));
    // Above the errors there is room for the crosses of refused rows.
    let above = |part: f64| errors.end * (errors.end / errors.start).powf(part);
    let (top, end) = (above(0.06), above(0.12));
    // The unit of other rows, in brackets, is in the table only.
    let unit = swept.case.unit.split(" (").next().unwrap_or_default();
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(16)
        .caption(swept.case.name, ("sans-serif", 18))
        .x_label_area_size(46)
        .y_label_area_size(66)
        .build_cartesian_2d(axis, (errors.start..end).log_scale().with_key_points(ticks(&errors)))?;
    chart
        .configure_mesh()
        .x_desc(title)
        .y_desc(format!("error, {unit}"))
        .label_style(FONT)
        .axis_desc_style(FONT)
        .light_line_style(WHITE)
        .x_label_formatter(label)
        .y_label_formatter(&power_label)
        .draw()?;
    let place = |row: &StabilityRow, value: Option<f64>| Some((across(row.value)?, up(value?)?));
    let bounds = rows.iter().filter_map(|row| place(row, row.bound));
    chart.draw_series(LineSeries::new(bounds, GREY.stroke_width(3)))?;
    let style = |row: &StabilityRow| match row.verdict {
        Verdict::Wrong => RED.filled(),
        Verdict::Warned => BLUE.stroke_width(2),
        _ => BLUE.filled(),
    };
    chart.draw_series(rows.iter().filter_map(|row| Some(Circle::new(place(row, row.error)?, 4, style(row)))))?;
    let refused = swept.rows.iter().filter(|row| row.error.is_none());
    let crosses = refused.filter_map(|row| {
        let style = if row.verdict == Verdict::Wrong { RED } else { VERMILLION };
        Some(Cross::new((across(row.value)?, top), 4, style.stroke_width(2)))
    });
    chart.draw_series(crosses)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_row_nearest_to_its_bound_is_drawn_and_a_wrong_one_before_it() {
        let row = |value, error, bound, verdict| StabilityRow {
            case: "",
            variant: String::new(),
            parameter: "",
            value,
            error,
            bound,
            size: Some(1.0),
            loose: false,
            unit: "m",
            why: String::new(),
            beside: None,
            counts: Default::default(),
            verdict,
            note: String::new(),
        };
        let rows = [
            row(2.0, Some(1e-9), Some(1e-8), Verdict::Right),
            row(2.0, Some(1e-7), Some(1e-5), Verdict::Right),
            row(1.0, Some(9e-9), Some(1e-8), Verdict::Right),
            row(1.0, Some(1e-9), Some(1e-8), Verdict::Wrong),
            row(3.0, None, None, Verdict::Refused),
        ];
        let shown: Vec<_> = nearest(&rows).iter().map(|row| (row.value, row.error)).collect();
        assert_eq!(shown, [(1.0, Some(1e-9)), (2.0, Some(1e-9))]);
    }
}
