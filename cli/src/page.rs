//! `report.html` of a run: one file with the structure in motion, its probes and energies, and what is known of the run.
//!
//! Everything is in the file, in the order of `assets/run/page.html`: style, data as JSON, scripts. Numbers are rounded to
//! what a screen can show; the data files hold every digit.

use ancf::internals::model::ENERGY_COLUMNS;
use ancf::model::{Method, Scene};
use ancf::run::{AxisPoint, Trajectory};
use ancf_study::escape;
use serde::Serialize;

use crate::ends::LOAD;
use crate::frames::{Frame, Frames};
use crate::quantity::Reading;
use crate::summary::Summary;

const PAGE: &str = include_str!("../assets/run/page.html");
const STYLE: &str = include_str!("../assets/run/page.css");
const SCRIPTS: [&str; 4] = [
    include_str!("../assets/run/colours.js"),
    include_str!("../assets/run/stage.js"),
    include_str!("../assets/run/charts.js"),
    include_str!("../assets/run/page.js"),
];

/// Most rows that a chart shows one by one.
const MOST_ROWS: usize = 1500;

/// Groups of rows in a longer chart, each with its smallest and largest value.
const GROUPS: usize = 600;

/// Significant digits of numbers in charts, of what changes.
const DIGITS: usize = 6;

/// Text of the page.
pub fn page_text(summary: &Summary, scene: &Scene, trajectory: &Trajectory, frames: &Frames) -> String {
    // Equal inputs give equal pages: the time of the clock is in summary.json alone.
    let mut summary = serde_json::json!(summary);
    summary.as_object_mut().and_then(|keys| keys.remove("wall_seconds"));
    let data = Data {
        program: concat!("ancf ", env!("CARGO_PKG_VERSION")),
        summary,
        statics: scene.time.method == Method::Static,
        rows_each: rows_each(trajectory),
        rows: rounded(&thinned_times(trajectory), DIGITS + 3),
        charts: charts(scene, trajectory),
        motion: motion(scene, frames),
    };
    // Within a script no `<` may begin a tag or a comment. Data of this crate's own types is always JSON.
    let json = serde_json::to_string(&data).unwrap_or_default().replace('<', "\\u003c");
    let title = if scene.title.is_empty() { "a run of ancf" } else { &scene.title };
    // A title in braces is no place to be filled in.
    PAGE.replace("{{title}}", &escape::html(title).replace('{', "&#123;"))
        .replace("{{style}}", STYLE)
        .replace("{{script}}", &SCRIPTS.concat())
        .replace("{{data}}", &json)
}

/// Everything that the page's scripts read.
#[derive(Serialize)]
struct Data<'a> {
    program: &'static str,
    /// Content of `summary.json`, without the time that the run took.
    summary: serde_json::Value,
    statics: bool,
    /// Rows in each group of a thinned chart; 1 where every row is shown.
    rows_each: usize,
    /// Times of the charts.
    rows: Vec<f64>,
    charts: Vec<Chart>,
    motion: Motion<'a>,
}

/// Lines over time with one unit.
#[derive(Serialize)]
struct Chart {
    /// Name of the probe, or what the chart shows.
    name: String,
    /// Quantity in words; empty where the name says it.
    of: &'static str,
    unit: &'static str,
    /// Window of means, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    mean: Option<f64>,
    lines: Vec<Line>,
}

#[derive(Serialize)]
struct Line {
    /// Name of the column.
    column: String,
    /// Short name beside the line.
    label: String,
    values: Vec<f64>,
}

/// Axes of the rods over time as whole numbers of a quantum each.
#[derive(Serialize)]
struct Motion<'a> {
    t: Vec<f64>,
    load: Vec<f64>,
    /// Quantum of displacements, m.
    quantum: f64,
    /// Quanta of the axial strain, of the elastic one and of the curvature.
    strain_quantum: f64,
    elastic_quantum: f64,
    curvature_quantum: f64,
    rods: Vec<RodMotion<'a>>,
}

/// Lists over points, one instant after another.
#[derive(Serialize)]
struct RodMotion<'a> {
    at: &'a [f64],
    /// Height of the section, m.
    height: f64,
    /// Displacements from the undeformed rod along x and y.
    x: Vec<i64>,
    y: Vec<i64>,
    strain: Vec<i64>,
    elastic: Vec<i64>,
    curvature: Vec<i64>,
    /// Temperature change at each instant, K.
    temperature: Vec<f64>,
}

/// Charts of a run: probes in the scene's order, the load factor of a path, energies, their balance.
fn charts(scene: &Scene, trajectory: &Trajectory) -> Vec<Chart> {
    let line = |column: &String, label: &str| {
        let values = thinned(&trajectory.column(column).unwrap_or_default());
        Line { column: column.clone(), label: label.into(), values: rounded(&values, digits_of(&values)) }
    };
    let mut charts: Vec<Chart> = Vec::new();
    for column in trajectory.columns.iter().skip(1).filter(|column| !ENERGY_COLUMNS.contains(&column.as_str())) {
        if column == LOAD {
            let lines = vec![line(column, "")];
            charts.push(Chart { name: "load factor".into(), of: "", unit: "", mean: None, lines });
            continue;
        }
        let Reading { probe, component, quantity, unit } = Reading::of(column);
        match charts.last_mut().filter(|chart| chart.name == probe && chart.of == quantity) {
            Some(chart) => chart.lines.push(line(column, component)),
            None => {
                let mean = scene.probes.iter().find(|known| known.name == probe).and_then(|known| known.mean);
                let lines = vec![line(column, component)];
                charts.push(Chart { name: probe.into(), of: quantity, unit, mean, lines });
            }
        }
    }
    let energies = trajectory.columns.iter().filter(|column| ENERGY_COLUMNS.contains(&column.as_str()));
    let (balance, energies): (Vec<&String>, Vec<&String>) =
        energies.partition(|column| column.as_str() == "energy.balance");
    for (name, columns) in [("energies", energies), ("energy balance", balance)] {
        let label = |column: &String| column.rsplit('.').next().unwrap_or_default().to_string();
        let lines: Vec<Line> = columns.into_iter().map(|column| line(column, &label(column))).collect();
        if !lines.is_empty() {
            charts.push(Chart { name: name.into(), of: "", unit: "J", mean: None, lines });
        }
    }
    charts
}

fn motion<'a>(scene: &Scene, frames: &'a Frames) -> Motion<'a> {
    let undeformed = |rod: usize, at: f64| {
        let [from, to] = [&scene.rods[rod].from, &scene.rods[rod].to].map(|name| scene.points[name]);
        [0, 1].map(|axis| from[axis] + at * (to[axis] - from[axis]))
    };
    let displacement =
        |rod: usize, at: f64, point: &AxisPoint, axis: usize| point.position[axis] - undeformed(rod, at)[axis];
    let elastic = |point: &AxisPoint| point.strain - point.thermal_strain;
    let points = || frames.list.iter().flat_map(|frame| frame.rods.iter().flatten());
    let largest = |read: &dyn Fn(&AxisPoint) -> f64| points().map(|point| read(point).abs()).fold(0.0, f64::max);
    let moved = frames.list.iter().flat_map(|frame| frame.rods.iter().enumerate()).flat_map(|(rod, axis)| {
        let pairs = axis.iter().zip(&frames.at[rod]);
        pairs.flat_map(move |(point, at)| [0, 1].map(|k| displacement(rod, *at, point, k).abs()))
    });
    // Displacements that are magnified need more digits than colours.
    let quantum = quantum(moved.fold(0.0, f64::max), 1e-7);
    let strain_quantum = self::quantum(largest(&|point| point.strain), 1e-4);
    let elastic_quantum = self::quantum(largest(&elastic), 1e-4);
    let curvature_quantum = self::quantum(largest(&|point| point.curvature), 1e-4);
    let whole = |value: f64, quantum: f64| (value / quantum).round() as i64;
    let rods = scene.rods.iter().enumerate().map(|(n, rod)| {
        let all = |read: &dyn Fn(&AxisPoint, f64) -> i64| {
            let of_frame = |frame: &'a Frame| frame.rods[n].iter().zip(&frames.at[n]);
            frames.list.iter().flat_map(of_frame).map(|(point, at)| read(point, *at)).collect::<Vec<i64>>()
        };
        let temperatures: Vec<f64> = frames.list.iter().map(|frame| frame.rods[n][0].temperature).collect();
        RodMotion {
            at: &frames.at[n],
            height: scene.section(rod).height,
            x: all(&|point, at| whole(displacement(n, at, point, 0), quantum)),
            y: all(&|point, at| whole(displacement(n, at, point, 1), quantum)),
            strain: all(&|point, _| whole(point.strain, strain_quantum)),
            elastic: all(&|point, _| whole(elastic(point), elastic_quantum)),
            curvature: all(&|point, _| whole(point.curvature, curvature_quantum)),
            temperature: rounded(&temperatures, DIGITS),
        }
    });
    let times = |read: fn(&Frame) -> f64| {
        let times: Vec<f64> = frames.list.iter().map(read).collect();
        rounded(&times, DIGITS + 3)
    };
    Motion {
        t: times(|frame| frame.t),
        load: if scene.time.method == Method::Static { times(|frame| frame.load) } else { Vec::new() },
        quantum,
        strain_quantum,
        elastic_quantum,
        curvature_quantum,
        rods: rods.collect(),
    }
}

/// Digits that a line needs: more where it changes by little of its size, which a chart then shows.
fn digits_of(values: &[f64]) -> usize {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let more = (most.abs().max(least.abs()) / (most - least)).log10().ceil();
    // Of a constant the ratio is infinite; it needs no more.
    if more.is_finite() { (DIGITS + more.max(0.0) as usize).min(15) } else { DIGITS }
}

/// Part of the largest value in which values are counted; 1 where all are zero.
fn quantum(largest: f64, part: f64) -> f64 {
    if largest > 0.0 && largest.is_finite() { digits(largest * part, 3) } else { 1.0 }
}

fn rounded(values: &[f64], count: usize) -> Vec<f64> {
    values.iter().map(|value| digits(*value, count)).collect()
}

/// A number with so many significant digits.
fn digits(value: f64, count: usize) -> f64 {
    format!("{value:.*e}", count - 1).parse().unwrap_or(value)
}

/// Rows of a group, or 1 where all rows are shown.
fn rows_each(trajectory: &Trajectory) -> usize {
    if trajectory.rows.len() > MOST_ROWS { trajectory.rows.len().div_ceil(GROUPS) } else { 1 }
}

/// Times of what [`thinned`] leaves.
fn thinned_times(trajectory: &Trajectory) -> Vec<f64> {
    let times: Vec<f64> = trajectory.rows.iter().map(|row| row[0]).collect();
    if times.len() <= MOST_ROWS {
        return times;
    }
    let two = |group: &[f64]| [group[0], group[group.len() / 2]];
    times.chunks(rows_each(trajectory)).flat_map(two).collect()
}

/// Values as they are, or of many the smallest and the largest of each group in the order in which they come.
fn thinned(values: &[f64]) -> Vec<f64> {
    if values.len() <= MOST_ROWS {
        return values.to_vec();
    }
    let two = |group: &[f64]| {
        let place = |sign: f64| (0..group.len()).max_by(|a, b| (sign * group[*a]).total_cmp(&(sign * group[*b])));
        let (least, most) = (place(-1.0).unwrap_or_default(), place(1.0).unwrap_or_default());
        [group[least.min(most)], group[least.max(most)]]
    };
    values.chunks(values.len().div_ceil(GROUPS)).flat_map(two).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_charts_keep_their_extremes() {
        let mut values: Vec<f64> = (0..60_000).map(|n| (n as f64 * 1e-3).sin()).collect();
        (values[12_345], values[54_321]) = (7.0, -9.0);
        let thin = thinned(&values);
        assert_eq!(thin.len(), 2 * GROUPS);
        assert_eq!(thin.iter().copied().fold(0.0, f64::max), 7.0);
        assert_eq!(thin.iter().copied().fold(0.0, f64::min), -9.0);
        assert_eq!(thinned(&values[..MOST_ROWS]), values[..MOST_ROWS]);
    }

    #[test]
    fn numbers_are_rounded_to_digits() {
        assert_eq!([1.0 / 3.0, -0.0, 123456789.0].map(|value| digits(value, 6)), [0.333333, 0.0, 123457000.0]);
        assert_eq!(quantum(0.0, 1e-7), 1.0);
        assert_eq!([&[0.0, 3.0][..], &[1.0, 1.00001], &[2.0, 2.0]].map(digits_of), [6, 12, 6]);
    }
}
