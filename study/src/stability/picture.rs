//! The pictures: error over the swept parameter, with the bounds; both axes are logarithmic, but for angles.

use plotters::coord::combinators::BindKeyPoints;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;

use super::row::{StabilityRow, Verdict};
use super::study::Swept;
use crate::axis::{decades, power_label, ticks};
use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;
use crate::palette::{BLACK, GREY, of_method};
use ancf::internals::model::Words;
use ancf::model::Method;

/// Methods that a variant's name may contain. An adaptive method's word contains that of the other, and comes first.
const METHODS: [Method; 7] = [
    Method::GaussAdaptive,
    Method::NystromAdaptive,
    Method::EnergyMomentum,
    Method::GeneralizedAlpha,
    Method::Gauss,
    Method::Explicit,
    Method::Nystrom,
];

/// Colour of variants without a method.
const OTHER: RGBColor = BLACK;

/// Errors below are drawn here: a logarithmic axis has no zero.
const LEAST: f64 = 1e-18;

const PANEL_HEIGHT: u32 = 250;
const COLUMNS: usize = 3;
const FONT: (&str, u32) = ("sans-serif", 12);

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
    let size = Size { width: 1200, head: 92, body: PANEL_HEIGHT * rows as u32, parts: 1 };
    canvas::svg("Stiff and extreme cases", size, |key, body| {
        legend(key)?;
        body.split_evenly((rows, COLUMNS)).iter().zip(drawn).try_for_each(|(area, swept)| panel(area, swept))
    })
}

/// The marks in one line, the colours in the next.
fn legend(area: &Area) -> Drawn {
    let text = |words: &str, x: i32, y: i32| area.draw(&Text::new(words.to_string(), (x, y - 6), FONT));
    let dot = |x: i32, style: ShapeStyle| area.draw(&Circle::new((x, 10), 3, style));
    dot(20, GREY.filled())?;
    text("error", 30, 10)?;
    area.draw(&PathElement::new([(95, 10), (125, 10)], GREY.mix(0.5).stroke_width(2)))?;
    text("its bound", 132, 10)?;
    area.draw(&Cross::new((220, 10), 4, GREY.stroke_width(1)))?;
    text("refused, with the reason", 230, 10)?;
    dot(400, GREY.stroke_width(1))?;
    text("for comparison, not judged: the total form of slenderness", 410, 10)?;
    dot(770, RED.filled())?;
    text("WRONG", 780, 10)?;
    let methods = METHODS.map(|method| (method.word(), of_method(method)));
    for (number, (name, colour)) in methods.into_iter().chain([("statics, and others", OTHER)]).enumerate() {
        let x = 20 + 145 * number as i32;
        area.draw(&Circle::new((x, 32), 4, colour.filled()))?;
        text(name, x + 10, 32)?;
    }
    Ok(())
}

/// The colour of a variant.
fn colour(variant: &str) -> RGBColor {
    METHODS.into_iter().find(|method| variant.contains(method.word())).map_or(OTHER, of_method)
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
    let rows = || swept.rows.iter();
    let numbers = rows().flat_map(|row| [row.error, row.bound, row.beside]).flatten();
    let errors = decades(numbers.filter(|number| !number.is_nan()).map(|number| number.max(LEAST)));
    let up = |value: f64| value.is_finite().then(|| value.clamp(errors.start, errors.end));
    // Above the errors there is room for the crosses of refused rows.
    let above = |part: f64| errors.end * (errors.end / errors.start).powf(part);
    let (top, end) = (above(0.06), above(0.1));
    // The unit of other rows, in brackets, is in the table only.
    let unit = swept.case.unit.split(" (").next().unwrap_or_default();
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption(swept.case.name, ("sans-serif", 15))
        .x_label_area_size(38)
        .y_label_area_size(58)
        .build_cartesian_2d(axis, (errors.start..end).log_scale().with_key_points(ticks(&errors)))?;
    chart
        .configure_mesh()
        .x_desc(title)
        .y_desc(format!("error, {unit}"))
        .label_style(FONT)
        .light_line_style(WHITE)
        .x_label_formatter(label)
        .y_label_formatter(&power_label)
        .draw()?;
    let mut variants: Vec<&str> = rows().map(|row| row.variant.as_str()).collect();
    variants.dedup();
    for variant in variants {
        let colour = colour(variant);
        let own = || rows().filter(|row| row.variant == variant);
        let place = |row: &StabilityRow, value: Option<f64>| Some((across(row.value)?, up(value?)?));
        let mut bounds: Vec<(f64, f64)> = own().filter_map(|row| place(row, row.bound)).collect();
        bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
        chart.draw_series(LineSeries::new(bounds, colour.mix(0.5).stroke_width(1)))?;
        let is_wrong = |row: &StabilityRow| row.verdict == Verdict::Wrong;
        let style = |row: &StabilityRow| if is_wrong(row) { RED.filled() } else { colour.filled() };
        chart.draw_series(own().filter_map(|row| Some(Circle::new(place(row, row.error)?, 3, style(row)))))?;
        let beside = own().filter_map(|row| Some(Circle::new(place(row, row.beside)?, 3, colour.stroke_width(1))));
        chart.draw_series(beside)?;
        let refused = own().filter(|row| row.error.is_none());
        chart.draw_series(refused.filter_map(|row| Some(Cross::new((across(row.value)?, top), 4, style(row)))))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_that_of_the_longest_word() {
        assert_eq!(colour("gauss-adaptive, 4 elements"), of_method(Method::GaussAdaptive));
        assert_eq!(colour("statics"), OTHER);
        assert_eq!(colour("gauss, euler-bernoulli"), of_method(Method::Gauss));
    }
}
