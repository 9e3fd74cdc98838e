//! The picture: error over run time, a panel for each scene.

use std::ops::Range;

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::group::Group;
use super::pareto::pareto_front;
use super::point::{Point, Status};
use super::technique::Technique;
use crate::axis::decades;
use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;
use crate::palette::{BLACK, GREY, of_method};
use ancf::internals::model::Words;
use ancf::model::Method;

const PEER: RGBColor = BLACK;
const AT_LIMIT: RGBColor = RGBColor(185, 185, 185);

/// Opacity of points that were timed once.
const PALE: f64 = 0.35;

/// Failed runs above the last decade: their position and the end of the panel, over its largest error.
const FAILED: [f64; 2] = [1.5, 2.2];

const PANEL_HEIGHT: u32 = 430;
const LEGEND_HEIGHT: u32 = 90;
const COLUMNS: usize = 2;

/// Shape of a point.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Disc,
    Triangle,
    Square,
}

/// Draws the groups, those of a scene in one panel.
///
/// # Errors
/// [`Error::Picture`](crate::error::Error::Picture) with the library's reason.
pub fn svg(groups: &[Group]) -> Result<String> {
    let mut scenes: Vec<&str> = groups.iter().map(|group| group.scene).collect();
    scenes.dedup();
    let columns = scenes.len().clamp(1, COLUMNS);
    let rows = scenes.len().div_ceil(columns);
    let size = Size { width: 1120, head: 44, body: LEGEND_HEIGHT + PANEL_HEIGHT * rows as u32, parts: 1 };
    canvas::svg("Error against run time", size, |_, body| {
        let (legend, panels) = body.split_vertically(LEGEND_HEIGHT);
        draw_legend(&legend, groups)?;
        panels.split_evenly((rows, columns)).iter().zip(scenes).try_for_each(|(area, scene)| {
            let of_scene: Vec<&Group> = groups.iter().filter(|group| group.scene == scene).collect();
            draw_panel(area, scene, &of_scene)
        })
    })
}

/// Colours, shapes and lines.
fn draw_legend(area: &Area, groups: &[Group]) -> Drawn {
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
    for (shape, style, words) in [
        (Shape::Disc, GREY.filled(), "the paper's element"),
        (Shape::Triangle, GREY.filled(), "Euler–Bernoulli"),
        (Shape::Disc, AT_LIMIT.stroke_width(1), "at the reference's limit"),
    ] {
        mark(area, (x, LINES[1]), shape, style)?;
        label(&mut x, LINES[1], words)?;
    }
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
fn mark(area: &Area, at: (i32, i32), shape: Shape, style: ShapeStyle) -> Drawn {
    match shape {
        Shape::Disc => area.draw(&Circle::new(at, 5, style)),
        Shape::Triangle => area.draw(&TriangleMarker::new(at, 6, style)),
        Shape::Square => area.draw(&Rectangle::new([(at.0 - 4, at.1 - 4), (at.0 + 4, at.1 + 4)], style)),
    }
}

fn draw_panel(area: &Area, scene: &str, groups: &[&Group]) -> Drawn {
    let points = || groups.iter().flat_map(|group| group.all_points());
    let known = || points().filter_map(place);
    let times = range(known().map(|(time, _)| time).chain(points().filter_map(|point| point.failed_after)));
    let errors = range(known().map(|(_, error)| error));
    let [failed_at, end] = FAILED.map(|over| over * errors.end);
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .caption(scene, ("sans-serif", 16))
        .x_label_area_size(40)
        .y_label_area_size(70)
        .build_cartesian_2d(times.clone().log_scale(), (errors.start..end).log_scale())?;
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
        let own_shape = if group.is_euler_bernoulli() { Shape::Triangle } else { Shape::Disc };
        let peers: Vec<&Point> = group.own_peers().iter().collect();
        let their_front: Vec<(f64, f64)> = pareto_front(&peers).into_iter().filter_map(place).collect();
        let front = group.pareto_front().into_iter().filter_map(place);
        chart.draw_series(LineSeries::new(front, line(group.is_euler_bernoulli())))?;
        chart.draw_series(DashedLineSeries::new(their_front, 4, 4, PEER.stroke_width(1)))?;
        let theirs = peers.into_iter().map(|point| (point, Shape::Square));
        for (point, shape) in theirs.chain(group.points.iter().map(|point| (point, own_shape))) {
            let colour = if shape == Shape::Square { PEER } else { colour(point) };
            if point.status == Status::Failed {
                let at = (point.failed_after.unwrap_or(times.start).max(times.start), failed_at);
                chart.draw_series([Cross::new(at, 4, colour.stroke_width(2))])?;
            } else if let Some((time, error)) = place(point) {
                let at = (time, error.max(errors.start));
                let style = match point.status {
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
        }
    }
    Ok(())
}

/// Time and error of a point.
fn place(point: &Point) -> Option<(f64, f64)> {
    Some((point.seconds()?, point.error()?))
}

fn colour(point: &Point) -> RGBColor {
    let technique = Technique::of_each_method().find(|technique| technique.method.word() == point.method);
    technique.map_or(PEER, |technique| of_method(technique.method))
}

/// The decades that hold the values; errors below a billionth of the largest are only rounding, and do not extend the range.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    let most = values.iter().copied().fold(0.0, f64::max);
    decades(values.into_iter().filter(|value| *value > 1e-9 * most))
}
