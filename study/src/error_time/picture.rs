//! The picture: error over run time, a panel for each scene, and one of the distance from a plane solid. Fronts and methods are named where
//! they are.

use std::cell::RefCell;
use std::ops::Range;

use plotters::coord::combinators::LogCoord;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::FontDesc;

use super::group::Group;
use super::point::{Errors, Point, Status};
use super::technique::Technique;
use crate::axis::{decades, power_label, ticks};
use crate::canvas::{self, Area, Drawn, Size};
use crate::error::Result;
use crate::palette::{BLACK, GREY, of_method};
use ancf::internals::model::Words;

/// A size at which the README shows it without making it smaller.
const WIDTH: u32 = 840;
const PANEL_HEIGHT: u32 = 330;
const COLUMNS: usize = 2;

/// Opacity of points off the fronts.
const PALE: f64 = 0.3;

/// Size of the names in a panel, and of a character of them, px.
const NAME: i32 = 12;
const CHARACTER: f64 = 6.3;

/// The front of a program's element.
struct Front<'a> {
    name: &'static str,
    shape: Shape,
    /// Time, s, error, m, and the run, of the points on the front and of all.
    on: Vec<(f64, f64, &'a Point)>,
    all: Vec<(f64, f64, &'a Point)>,
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Disc,
    Triangle,
    /// Another program's, without and with shear.
    Square,
    Diamond,
}

/// What a panel shows of a point.
type Of = fn(&Errors) -> Option<f64>;

/// Draws the groups, those of a scene in one panel.
///
/// # Errors
/// [`Error::Picture`](crate::error::Error::Picture) with the library's reason.
pub fn svg(groups: &[Group]) -> Result<String> {
    let mut scenes: Vec<&str> = groups.iter().map(|group| group.scene).collect();
    scenes.dedup();
    let mut panels: Vec<(String, Vec<Front>)> = Vec::new();
    for scene in scenes {
        let of_scene = || groups.iter().filter(|group| group.scene == scene);
        panels
            .push((scene.into(), of_scene().flat_map(|group| fronts(group, |errors| Some(errors.shown()))).collect()));
        if scene == "pendulum-flexible" {
            let to_solid = of_scene().flat_map(|group| fronts(group, |errors| errors.solid)).collect();
            panels.push(("pendulum-flexible: distance from the plane solid".into(), to_solid));
        }
    }
    panels.retain(|(_, fronts)| !fronts.is_empty());
    let columns = panels.len().clamp(1, COLUMNS);
    let rows = panels.len().div_ceil(columns).max(1);
    let size = Size { width: WIDTH, head: 64, body: PANEL_HEIGHT * rows as u32, parts: 1 };
    canvas::svg("Error against run time", size, |top, body| {
        let key = "lower left is better; marks: runs, in the colour of their method; lines: what no other run beats; pale: the other runs";
        top.draw(&Text::new(key, (20, 6), font(NAME).color(&BLACK)))?;
        panels
            .iter()
            .zip(body.split_evenly((rows, columns)))
            .try_for_each(|((title, fronts), area)| panel(&area, title, fronts))
    })
}

fn font(size: i32) -> FontDesc<'static> {
    ("sans-serif", size).into_font()
}

/// The fronts of a group: ours, and the other program's of the same theory.
fn fronts(group: &Group, of: Of) -> Vec<Front<'_>> {
    let (own, other) = if group.is_euler_bernoulli() {
        (("Euler–Bernoulli", Shape::Triangle), ("Exudyn, cable", Shape::Square))
    } else {
        (("the paper's element", Shape::Disc), ("Exudyn, beam with shear", Shape::Diamond))
    };
    [front(own, &group.points, of), front(other, group.own_peers(), of)].into_iter().flatten().collect()
}

fn front<'a>((name, shape): (&'static str, Shape), points: &'a [Point], of: Of) -> Option<Front<'a>> {
    let known = points.iter().filter(|point| matches!(point.status, Status::Ok | Status::Outclassed));
    let mut all: Vec<(f64, f64, &Point)> =
        known.filter_map(|point| Some((point.seconds()?, of(point.errors.as_ref()?)?, point))).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = f64::INFINITY;
    let better = |(_, error, _): &(f64, f64, &Point)| {
        let better = *error < least;
        least = least.min(*error);
        better
    };
    let on: Vec<_> = all.iter().copied().filter(better).collect();
    (!on.is_empty()).then_some(Front { name, shape, on, all })
}

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;

/// Names that were drawn, in pixels: later ones keep off them.
#[derive(Default)]
struct Names(RefCell<Vec<(Range<i32>, Range<i32>)>>);

fn panel(area: &Area, title: &str, fronts: &[Front]) -> Drawn {
    let all = || fronts.iter().flat_map(|front| &front.all);
    let most = fronts.iter().flat_map(|front| &front.on).map(|(_, error, _)| *error).fold(0.0, f64::max);
    // Errors below a billionth of the largest are rounding, and coarse runs off the fronts do not extend the range.
    let errors = decades(all().map(|(_, error, _)| error.min(most)).filter(|error| *error > 1e-9 * most));
    let times = decades(all().map(|(time, ..)| *time));
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption(title, font(14))
        .x_label_area_size(34)
        .y_label_area_size(52)
        .build_cartesian_2d(times.clone().log_scale(), errors.clone().log_scale())?;
    chart
        .configure_mesh()
        .x_desc("run time, s")
        .y_desc("error, m")
        .label_style(font(NAME))
        .light_line_style(WHITE)
        .bold_line_style(GREY.mix(0.3))
        .x_labels(ticks(&times).len())
        .y_labels(ticks(&errors).len())
        .x_label_formatter(&power_label)
        .y_label_formatter(&power_label)
        .draw()?;
    for front in fronts {
        let off = front
            .all
            .iter()
            .filter(|(_, error, point)| *error <= errors.end && !front.on.iter().any(|on| std::ptr::eq(on.2, *point)));
        for (time, error, point) in off {
            mark(&mut chart, (*time, error.max(errors.start)), front.shape, colour(point).mix(PALE).filled(), 2)?;
        }
    }
    let names = Names::default();
    for front in fronts {
        let line: Vec<(f64, f64)> = front.on.iter().map(|(time, error, _)| (*time, error.max(errors.start))).collect();
        match front.shape {
            Shape::Disc => chart.draw_series([PathElement::new(line, BLACK.stroke_width(2))]).map(|_| ())?,
            Shape::Triangle => {
                chart.draw_series([DashedPathElement::new(line, 6, 3, BLACK.stroke_width(2))]).map(|_| ())?
            }
            _ => chart.draw_series([PathElement::new(line, GREY.stroke_width(1))]).map(|_| ())?,
        }
        for (time, error, point) in &front.on {
            let at = (*time, error.max(errors.start));
            let is_ours = matches!(front.shape, Shape::Disc | Shape::Triangle);
            let style = if is_ours { colour(point).filled() } else { BLACK.stroke_width(1) };
            mark(&mut chart, at, front.shape, style, 4)?;
            let (x, y) = chart.backend_coord(&at);
            names.0.borrow_mut().push((x - 4..x + 4, y - 4..y + 4));
        }
    }
    // The fronts' names first, then each method's at its first mark.
    for front in fronts {
        let ends = front.on.iter().map(|(time, error, _)| (*time, error.max(errors.start)));
        // Ours at the accurate end; another program's, whose front is beyond ours, at the fast one.
        match front.shape {
            Shape::Disc | Shape::Triangle => names.write(&mut chart, area, ends.rev(), front.name, BLACK)?,
            Shape::Square | Shape::Diamond => names.write(&mut chart, area, ends, front.name, BLACK)?,
        }
    }
    for technique in Technique::of_each_method() {
        let word = technique.method.word();
        let its = fronts
            .iter()
            .filter(|front| matches!(front.shape, Shape::Disc | Shape::Triangle))
            .flat_map(|front| &front.on);
        let its =
            its.filter(|(.., point)| point.method == word).map(|(time, error, _)| (*time, error.max(errors.start)));
        names.write(&mut chart, area, its, word, of_method(technique.method))?;
    }
    Ok(())
}

impl Names {
    /// Writes a name beside the first of these places that has room for it; nowhere if none has.
    fn write(
        &self,
        chart: &mut Chart,
        area: &Area,
        places: impl Iterator<Item = (f64, f64)>,
        name: &str,
        colour: RGBColor,
    ) -> Drawn {
        let width = (CHARACTER * name.chars().count() as f64) as i32;
        let (columns, rows) = area.get_pixel_range();
        let (columns, rows) = (columns.start + 62..columns.end - 8, rows.start + 28..rows.end - 44);
        for at in places {
            let (x, y) = chart.backend_coord(&at);
            for (dx, dy) in [
                (7, -14),
                (7, 3),
                (-width - 7, 3),
                (-width - 7, -14),
                (7, -28),
                (-width - 7, 17),
                (-width / 2, 8),
                (-width / 2, -20),
            ] {
                let (across, down) = (x + dx..x + dx + width, y + dy..y + dy + NAME);
                let inside = columns.contains(&across.start)
                    && across.end <= columns.end
                    && rows.contains(&down.start)
                    && down.end <= rows.end;
                let overlap = |a: &Range<i32>, b: &Range<i32>| a.start < b.end && b.start < a.end;
                let free =
                    self.0.borrow().iter().all(|(its, height)| !(overlap(&across, its) && overlap(&down, height)));
                if inside && free {
                    let text = Text::new(name.to_string(), (dx, dy), font(NAME).color(&colour));
                    chart.draw_series([EmptyElement::at(at) + text])?;
                    self.0.borrow_mut().push((across, down));
                    return Ok(());
                }
            }
        }
        Ok(())
    }
}

fn mark(chart: &mut Chart, at: (f64, f64), shape: Shape, style: ShapeStyle, size: i32) -> Drawn {
    match shape {
        Shape::Disc => chart.draw_series([Circle::new(at, size, style)]).map(|_| ()),
        Shape::Triangle => chart.draw_series([TriangleMarker::new(at, size + 1, style)]).map(|_| ()),
        Shape::Square => {
            let square = EmptyElement::at(at) + Rectangle::new([(1 - size, 1 - size), (size - 1, size - 1)], style);
            chart.draw_series([square]).map(|_| ())
        }
        Shape::Diamond => {
            let corners = [(0, -size), (size, 0), (0, size), (-size, 0), (0, -size)].to_vec();
            chart.draw_series([EmptyElement::at(at) + PathElement::new(corners, style)]).map(|_| ())
        }
    }
}

fn colour(point: &Point) -> RGBColor {
    let technique = Technique::of_each_method().find(|technique| technique.method.word() == point.method);
    technique.map_or(BLACK, |technique| of_method(technique.method))
}
