//! The pictures: error over the swept parameter, with the bounds drawn in; both logarithmic, but for angles.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint};
use plotters::prelude::*;

use super::Swept;
use super::axis::Axis;
use super::row::{Row, Verdict};
use crate::error::{Error, Result};
use crate::palette::{GREEN, GREY, of_method};
use ancf::model::Method;

/// Methods whose words may be in a variant's name. An adaptive method's word holds that of the other, and comes first.
const METHODS: [Method; 7] = [
    Method::GaussAdaptive,
    Method::NystromAdaptive,
    Method::EnergyMomentum,
    Method::GeneralizedAlpha,
    Method::Gauss,
    Method::Explicit,
    Method::Nystrom,
];

/// Of what no method is named.
const OTHER: RGBColor = GREEN;

const WIDTH: u32 = 1200;
const PANEL_HEIGHT: u32 = 250;
const HEAD_HEIGHT: u32 = 92;
const COLUMNS: usize = 3;
const FONT: (&str, u32) = ("sans-serif", 12);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type DrawingResult<'a> = std::result::Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

/// A panel for each case that is a sweep: errors at two values and more.
///
/// # Errors
/// [`Error::Picture`] with the library's reason.
pub fn svg(cases: &[Swept]) -> Result<String> {
    let is_swept = |swept: &&Swept| {
        let mut values = swept.rows.iter().filter(|row| row.error.is_some()).map(|row| row.value);
        values.next().is_some_and(|first| values.any(|value| value != first))
    };
    let drawn: Vec<&Swept> = cases.iter().filter(is_swept).collect();
    let height = HEAD_HEIGHT + PANEL_HEIGHT * drawn.len().div_ceil(COLUMNS).max(1) as u32;
    let title = "Stiff and extreme cases";
    let mut text = String::new();
    draw(title, &drawn, SVGBackend::with_string(&mut text, (WIDTH, height)))
        .map_err(|reason| Error::Picture { title: title.into(), reason: reason.to_string() })?;
    Ok(text)
}

fn draw<'a>(title: &str, cases: &[&Swept], backend: SVGBackend<'a>) -> DrawingResult<'a> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (head, body) = root.split_vertically(HEAD_HEIGHT);
    let key = head.titled(title, ("sans-serif", 20))?;
    legend(&key)?;
    let rows = cases.len().div_ceil(COLUMNS).max(1);
    for (area, swept) in body.split_evenly((rows, COLUMNS)).iter().zip(cases) {
        panel(area, swept)?;
    }
    root.present()
}

/// The marks in one line, the colours in the next.
fn legend<'a>(area: &Area<'a>) -> DrawingResult<'a> {
    let text = |words: &str, x: i32, y: i32| Text::new(words.to_string(), (x, y - 6), FONT);
    let grey = GREY;
    area.draw(&Circle::new((20, 10), 3, grey.filled()))?;
    area.draw(&text("error", 30, 10))?;
    area.draw(&PathElement::new([(95, 10), (125, 10)], grey.mix(0.5).stroke_width(2)))?;
    area.draw(&text("its bound", 132, 10))?;
    area.draw(&Cross::new((220, 10), 4, grey.stroke_width(1)))?;
    area.draw(&text("refused, with the reason", 230, 10))?;
    area.draw(&Circle::new((400, 10), 3, grey.stroke_width(1)))?;
    area.draw(&text("beside it, not judged: the total form of slenderness", 410, 10))?;
    area.draw(&Circle::new((720, 10), 4, RED.filled()))?;
    area.draw(&text("WRONG", 730, 10))?;
    let methods = METHODS.map(|method| (method.word(), of_method(method)));
    let other = ("statics, and others", OTHER);
    for (number, (name, colour)) in methods.into_iter().chain([other]).enumerate() {
        let x = 20 + 145 * number as i32;
        area.draw(&Circle::new((x, 32), 4, colour.filled()))?;
        area.draw(&text(name, x + 10, 32))?;
    }
    Ok(())
}

/// A linear scale with ticks of its own.
struct Scale {
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Ranged for Scale {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// The colour of a variant.
fn colour(variant: &str) -> RGBColor {
    METHODS.into_iter().find(|method| variant.contains(method.word())).map_or(OTHER, of_method)
}

fn panel<'a>(area: &Area<'a>, swept: &Swept) -> DrawingResult<'a> {
    let rows = || swept.rows.iter();
    let across = Axis::of_parameter(swept.case, rows().map(|row| row.value));
    let numbers = rows().flat_map(|row| [row.error, row.bound, row.beside]).flatten();
    // What rows of another kind are of, in brackets, is in the table.
    let unit = swept.case.unit.split(" (").next().unwrap_or_default();
    let up = Axis::of_errors(format!("error, {unit}"), numbers);
    let Range { start, end } = up.range;
    // Room for the crosses of what is refused.
    let top = end + 0.06 * (end - start);
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption(swept.case.name, ("sans-serif", 15))
        .x_label_area_size(38)
        .y_label_area_size(58)
        .build_cartesian_2d(
            Scale { range: across.range.clone(), ticks: across.ticks.clone() },
            Scale { range: start..top + 0.04 * (end - start), ticks: up.ticks.clone() },
        )?;
    chart
        .configure_mesh()
        .x_desc(&across.title)
        .y_desc(&up.title)
        .label_style(FONT)
        .light_line_style(WHITE)
        .x_label_formatter(&|x| across.label(*x))
        .y_label_formatter(&|y| up.label(*y))
        .draw()?;
    let mut variants: Vec<&str> = rows().map(|row| row.variant.as_str()).collect();
    variants.dedup();
    for variant in variants {
        let colour = colour(variant);
        let own = || rows().filter(|row| row.variant == variant);
        let place = |row: &Row, value: Option<f64>| Some((across.place(row.value)?, up.place(value?)?));
        let mut bounds: Vec<(f64, f64)> = own().filter_map(|row| place(row, row.bound)).collect();
        bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
        chart.draw_series(LineSeries::new(bounds, colour.mix(0.5).stroke_width(1)))?;
        let is_wrong = |row: &Row| row.verdict == Verdict::Wrong;
        let style = |row: &Row| if is_wrong(row) { RED.filled() } else { colour.filled() };
        chart.draw_series(own().filter_map(|row| Some(Circle::new(place(row, row.error)?, 3, style(row)))))?;
        let beside = own().filter_map(|row| Some(Circle::new(place(row, row.beside)?, 3, colour.stroke_width(1))));
        chart.draw_series(beside)?;
        let refused = own().filter(|row| row.error.is_none());
        chart
            .draw_series(refused.filter_map(|row| Some(Cross::new((across.place(row.value)?, top), 4, style(row)))))?;
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
