//! The picture: error over run time, a panel a scene.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::group::Group;
use super::pareto::front;
use super::point::{Point, Status};
use super::technique::Technique;
use crate::error::{Error, Result};
use crate::palette::{BLACK, GREY, of_method};
use ancf::model::Method;

const PEER: RGBColor = BLACK;
const AT_LIMIT: RGBColor = RGBColor(185, 185, 185);

/// How much is left of a colour of points that were timed once.
const PALE: f64 = 0.35;

/// Above the last decade, for runs that failed: where they are drawn, and where the panel ends.
const FAILED: [f64; 2] = [1.5, 2.2];

const WIDTH: u32 = 1120;
const PANEL_HEIGHT: u32 = 430;
const TITLE_HEIGHT: u32 = 44;
const LEGEND_HEIGHT: u32 = 90;
const COLUMNS: usize = 2;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type DrawingResult<'a> = std::result::Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

/// What a point is drawn as.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Disc,
    Triangle,
    Square,
}

/// Draws the groups, those of one scene in one panel.
///
/// # Errors
/// [`Error::Picture`] with the library's reason.
pub fn svg(groups: &[Group]) -> Result<String> {
    let mut scenes: Vec<&str> = groups.iter().map(|group| group.scene).collect();
    scenes.dedup();
    let columns = scenes.len().clamp(1, COLUMNS);
    let height = TITLE_HEIGHT + LEGEND_HEIGHT + PANEL_HEIGHT * scenes.len().div_ceil(columns) as u32;
    let title = "Error against run time";
    let mut text = String::new();
    draw(title, groups, &scenes, columns, SVGBackend::with_string(&mut text, (WIDTH, height)))
        .map_err(|reason| Error::Picture { title: title.into(), reason: reason.to_string() })?;
    Ok(text)
}

fn draw<'a>(
    title: &str,
    groups: &[Group],
    scenes: &[&str],
    columns: usize,
    backend: SVGBackend<'a>,
) -> DrawingResult<'a> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (head, body) = root.split_vertically(TITLE_HEIGHT);
    head.titled(title, ("sans-serif", 20))?;
    let (legend, body) = body.split_vertically(LEGEND_HEIGHT);
    draw_legend(&legend, groups)?;
    let rows = scenes.len().div_ceil(columns);
    for (area, scene) in body.split_evenly((rows, columns)).iter().zip(scenes) {
        let of_scene: Vec<&Group> = groups.iter().filter(|group| group.scene == *scene).collect();
        draw_panel(area, scene, &of_scene)?;
    }
    root.present()
}

/// Colours, shapes and lines.
fn draw_legend<'a>(area: &Area<'a>, groups: &[Group]) -> DrawingResult<'a> {
    const LINES: [i32; 3] = [14, 42, 70];
    const CHARACTER: f64 = 7.2;
    let font = ("sans-serif", 14).into_font();
    let label = |x: &mut i32, line: i32, words: &str| {
        let drawn = area.draw(&Text::new(words.to_string(), (*x + 12, line - 6), font.clone()));
        *x += 34 + (CHARACTER * words.chars().count() as f64) as i32;
        drawn
    };
    let mut x = 30;
    let used =
        |method: Method| groups.iter().any(|group| group.points.iter().any(|point| point.method == method.word()));
    for technique in Technique::of_each_method().filter(|technique| used(technique.method)) {
        mark(area, (x, LINES[0]), Shape::Disc, of_method(technique.method).filled())?;
        label(&mut x, LINES[0], technique.method.word())?;
    }
    let peer = groups.iter().flat_map(Group::own_peers).next();
    if let Some(peer) = peer {
        mark(area, (x, LINES[0]), Shape::Square, PEER.stroke_width(1))?;
        label(&mut x, LINES[0], &peer.program)?;
    }
    let mut x = 30;
    mark(area, (x, LINES[1]), Shape::Disc, GREY.filled())?;
    label(&mut x, LINES[1], "the paper's element")?;
    mark(area, (x, LINES[1]), Shape::Triangle, GREY.filled())?;
    label(&mut x, LINES[1], "Euler–Bernoulli")?;
    mark(area, (x, LINES[1]), Shape::Disc, AT_LIMIT.stroke_width(1))?;
    label(&mut x, LINES[1], "at the reference's limit")?;
    area.draw(&Cross::new((x, LINES[1]), 4, GREY.stroke_width(2)))?;
    label(&mut x, LINES[1], "failed (at the time it took)")?;
    mark(area, (x, LINES[1]), Shape::Disc, GREY.mix(PALE).filled())?;
    label(&mut x, LINES[1], "pale: outclassed, timed once")?;
    let mut x = 30;
    let end = |x: i32| [(x - 8, LINES[2]), (x + 10, LINES[2])];
    for (words, pale) in [("Pareto front of the paper's element", false), ("of Euler–Bernoulli", true)] {
        area.draw(&PathElement::new(end(x), line(pale)))?;
        x += 8;
        label(&mut x, LINES[2], words)?;
    }
    if let Some(peer) = peer {
        area.draw(&DashedPathElement::new(end(x), 4, 4, PEER.stroke_width(1)))?;
        x += 8;
        label(&mut x, LINES[2], &format!("of {}", peer.program))?;
    }
    Ok(())
}

fn line(second: bool) -> ShapeStyle {
    if second { BLACK.mix(0.35).stroke_width(2) } else { BLACK.stroke_width(2) }
}

/// A mark at a pixel.
fn mark<'a>(area: &Area<'a>, at: (i32, i32), shape: Shape, style: ShapeStyle) -> DrawingResult<'a> {
    match shape {
        Shape::Disc => area.draw(&Circle::new(at, 5, style)),
        Shape::Triangle => area.draw(&TriangleMarker::new(at, 6, style)),
        Shape::Square => area.draw(&Rectangle::new([(at.0 - 4, at.1 - 4), (at.0 + 4, at.1 + 4)], style)),
    }
}

fn draw_panel<'a>(area: &Area<'a>, scene: &str, groups: &[&Group]) -> DrawingResult<'a> {
    let points = || groups.iter().flat_map(|group| group.points.iter().chain(group.own_peers()));
    let known = || points().filter_map(|point| Some((point.seconds()?, point.error()?)));
    let times = decades(known().map(|(time, _)| time).chain(points().filter_map(|point| point.failed_after)));
    let errors = decades(known().map(|(_, error)| error));
    let failed_at = FAILED[0] * errors.end;
    let errors = errors.start..FAILED[1] * errors.end;
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .caption(scene, ("sans-serif", 16))
        .x_label_area_size(40)
        .y_label_area_size(70)
        .build_cartesian_2d(times.clone().log_scale(), errors.clone().log_scale())?;
    let power = |value: &f64| format!("{value:.0e}");
    chart
        .configure_mesh()
        .x_desc("run time, s (median)")
        .y_desc("error of the position, m")
        .label_style(("sans-serif", 13))
        .light_line_style(WHITE)
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .draw()?;
    for group in groups {
        let front: Vec<(f64, f64)> =
            group.front().iter().filter_map(|point| Some((point.seconds()?, point.error()?))).collect();
        chart.draw_series(LineSeries::new(front, line(group.is_second())))?;
        let peers: Vec<&Point> = group.own_peers().iter().collect();
        let their_front = front_line(&peers);
        chart.draw_series(DashedLineSeries::new(their_front, 4, 4, PEER.stroke_width(1)))?;
        for point in group.own_peers().iter().chain(&group.points) {
            let shape = if group.own_peers().iter().any(|peer| std::ptr::eq(peer, point)) {
                Shape::Square
            } else if group.is_second() {
                Shape::Triangle
            } else {
                Shape::Disc
            };
            let colour = colour(point, shape);
            match (point.status, point.seconds(), point.error()) {
                (Status::Failed, _, _) => {
                    let at = (point.failed_after.unwrap_or(times.start).max(times.start), failed_at);
                    chart.draw_series([Cross::new(at, 4, colour.stroke_width(2))])?;
                }
                (status, Some(time), Some(error)) => {
                    let at = (time, error.max(errors.start));
                    let style = match status {
                        Status::AtLimit => AT_LIMIT.stroke_width(1),
                        Status::Outclassed => colour.mix(PALE).filled(),
                        _ if shape == Shape::Square => colour.stroke_width(1),
                        _ => colour.filled(),
                    };
                    match shape {
                        Shape::Disc => chart.draw_series([Circle::new(at, 3, style)]).map(|_| ())?,
                        Shape::Triangle => chart.draw_series([TriangleMarker::new(at, 4, style)]).map(|_| ())?,
                        Shape::Square => {
                            let square = EmptyElement::at(at) + Rectangle::new([(-3, -3), (3, 3)], style);
                            chart.draw_series([square]).map(|_| ())?;
                        }
                    }
                }
                _ => {}
            }
        }
    }
    Ok(())
}

fn front_line(points: &[&Point]) -> Vec<(f64, f64)> {
    front(points).iter().filter_map(|point| Some((point.seconds()?, point.error()?))).collect()
}

fn colour(point: &Point, shape: Shape) -> RGBColor {
    let technique = Technique::of_each_method().find(|technique| technique.method.word() == point.method);
    match technique {
        Some(technique) if shape != Shape::Square => of_method(technique.method),
        _ => PEER,
    }
}

/// The decades that hold the values; of errors that are nothing as far as numbers go, those above a billionth of the largest
/// only.
fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    const MOST: f64 = 1e-9;
    let values: Vec<f64> = values.filter(|value| value.is_finite() && *value > 0.0).collect();
    let most = values.iter().copied().fold(0.0, f64::max);
    let least = values.iter().copied().filter(|value| *value > MOST * most).fold(f64::INFINITY, f64::min);
    if most == 0.0 {
        return 1e-6..1.0;
    }
    let (low, high) = (least.log10().floor(), most.log10().ceil());
    10f64.powf(low)..10f64.powf(high.max(low + 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_the_values() {
        let range = decades([2e-3, 5e-6, 0.0, f64::NAN].into_iter());
        assert!((range.start / 1e-6 - 1.0).abs() < 1e-12 && (range.end / 1e-2 - 1.0).abs() < 1e-12);
        assert_eq!(decades([].into_iter()), 1e-6..1.0);
        assert!(decades([1.0].into_iter()).end > 1.0);
    }
}
