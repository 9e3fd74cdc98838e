//! Pictures of Section 4, and the positions of a4.

use plotters::style::RGBColor;
use serde::Serialize;

use super::animation;
use super::claims_section4::WINDOW;
use super::scissors::{Family, RODS, STEP, ScissorsRun, Structure};
use super::time_series::Signal;
use crate::error::{Error, Result};
use crate::figure::{Curve, Panel, Stroke, svg};
use crate::palette::{BLACK, BLUE, ORANGE};
use crate::path::distance;
use crate::picture::Picture;
use crate::scene::builtin;
use crate::snapshot::{self, Name, Snapshot};
use ancf::run::Trajectory;

/// Instants of the structure's picture and of a4's table, s.
pub const TIMES: [f64; 6] = [0.5, 1.0, 1.5, 2.0, 2.5, 3.0];

/// Colours of the models, as in the pendulum's pictures.
const FLEXIBLE: RGBColor = BLACK;
const HEATED: RGBColor = BLUE;

/// a4 at one of the table's times, m and s.
#[derive(Serialize)]
pub struct A4Row {
    pub model: &'static str,
    pub t: f64,
    pub a4: [f64; 2],
    /// Distance from the run with twice the step.
    pub change_with_twice_the_step: f64,
    /// Distance from the run with half the elements.
    pub change_with_half_the_elements: f64,
}

/// Positions of a4, flexible and heated (2D).
pub fn rows(structure: &Structure) -> Vec<A4Row> {
    let Structure { fine, coarse, twice_the_step: twice, .. } = structure;
    let models = [
        ("flexible", &fine.flexible, &coarse.flexible, &twice.flexible),
        ("2D", &fine.axis_and_section, &coarse.axis_and_section, &twice.axis_and_section),
    ];
    let row = |(model, fine, coarse, twice): (&'static str, &ScissorsRun, &ScissorsRun, &ScissorsRun), t: f64| {
        let a4 = fine.position("a4", t);
        let change = |other: &ScissorsRun| distance(other.position("a4", t), a4);
        let (change_with_twice_the_step, change_with_half_the_elements) = (change(twice), change(coarse));
        A4Row { model, t, a4, change_with_twice_the_step, change_with_half_the_elements }
    };
    models.into_iter().flat_map(|model| TIMES.map(|t| row(model, t))).collect()
}

/// File names of [`pictures`].
pub const PICTURES: [&str; 6] =
    ["deployment.svg", "structure.svg", "figure6.svg", "figure7.svg", "figure8-x.svg", "figure8-y.svg"];

/// Instants of the structure's picture, s.
const INSTANTS: [f64; 6] = [0.0, 0.6, 1.2, 1.8, 2.4, 3.0];

/// The structure at six instants, and Figures 6, 7 and 8.
pub fn pictures(structure: &Structure) -> Result<Vec<Picture>> {
    let (flexible, heated, axis) = (&structure.fine.flexible, &structure.fine.axis_and_section, &structure.fine.axis);
    let curve = |name, colour, signal: &Signal| Curve::line(name, colour, signal.times(1e3).points());
    let broad = |curve| Curve { stroke: Stroke::Broad, ..curve };
    // The deflection of each rod, and what heat changes of it below.
    let deflection = |rod: &str| {
        let less = |run: &ScissorsRun| run.deflection(rod).less(&flexible.deflection(rod));
        let curves = vec![
            broad(curve("flexible", FLEXIBLE, &flexible.deflection(rod))),
            curve("2D heat", HEATED, &heated.deflection(rod)),
        ];
        let changes =
            vec![curve("1D less flexible", ORANGE, &less(axis)), curve("2D less flexible", HEATED, &less(heated))];
        [
            Panel { quantity: format!("{rod}, mm"), curves, log: false },
            Panel { quantity: "change, mm".into(), curves: changes, log: false },
        ]
    };
    let instants = INSTANTS.map(|t| snapshot(heated, t));
    Ok(vec![
        Picture {
            file: PICTURES[0],
            caption: "Three scissors deploy under heat and cold: the rods have the colour of their temperature.",
            svg: animation::svg(heated, &history()?),
        },
        Picture {
            file: PICTURES[1],
            caption: "The structure under heat at six instants. b1 is held, a1 slides along y and is driven by 50 N towards b1.",
            svg: snapshot::svg("Three scissors deploy under heat", &instants)?,
        },
        Picture {
            file: PICTURES[2],
            caption: "Change of temperature over time. The corners are the paper's inflection points; straight lines between them are assumed.",
            svg: svg("Figure 6: change of temperature", &[temperature()?])?,
        },
        Picture {
            file: PICTURES[3],
            caption: "Deflection of the middles of three rods, and below each what heat changes of it.",
            svg: svg("Figure 7: deflection of the rods' middles", RODS.map(deflection).as_flattened())?,
        },
        Picture { file: PICTURES[4], caption: FIGURE_8, svg: figure8(structure, 0)? },
        Picture { file: PICTURES[5], caption: FIGURE_8, svg: figure8(structure, 1)? },
    ])
}

const FIGURE_8: &str = "Displacement, velocity and acceleration of a4. Of the acceleration: its mean over 20 ms, and the band in which it vibrates, \
                        without damping and with the numerical damping of an engineer's integrator.";

/// The temperature over time, s and K.
fn history() -> Result<Vec<[f64; 2]>> {
    let name = "scissors-3-thermal";
    Ok(builtin(name)?.temperature.ok_or_else(|| Error::fixture(name, "it has no temperature"))?.history)
}

fn temperature() -> Result<Panel<'static>> {
    let points = history()?.iter().map(|&[t, change]| (t, change)).collect();
    let curves = vec![Curve::line("temperature", HEATED, points)];
    Ok(Panel { quantity: "change of temperature, K".into(), curves, log: false })
}

/// Displacement, velocity and acceleration of a4 along one axis. The acceleration at an instant does not converge with the mesh.
fn figure8(structure: &Structure, axis: usize) -> Result<String> {
    let signal = |run: &ScissorsRun, quantity: &str| {
        let [x, y] = run.of_point("a4", quantity);
        [x, y][axis].clone()
    };
    let lines = |family: &Family, quantity: &str, change: &dyn Fn(Signal) -> Signal| -> Vec<Curve<'static>> {
        let [flexible, heated] =
            models(family).map(|(name, colour, run)| Curve::line(name, colour, change(signal(run, quantity)).points()));
        vec![Curve { stroke: Stroke::Broad, ..flexible }, heated]
    };
    // The heated model vibrates more: its band is below the other.
    let vibrations = |family: &Family| -> Vec<Curve<'static>> {
        let band = |(name, colour, run): (&'static str, RGBColor, &ScissorsRun)| {
            let [upper, lower] = signal(run, "a").envelope(WINDOW);
            Curve::band(name, colour, upper, lower)
        };
        models(family).into_iter().rev().map(band).collect()
    };
    let (fine, damped) = (&structure.fine, &structure.damped);
    let start = fine.flexible.position("a4", 0.0)[axis];
    let name = ["x", "y"][axis];
    let panel = |quantity: &str, curves| Panel { quantity: quantity.into(), curves, log: false };
    let panels = [
        panel("displacement, m", lines(fine, "", &|signal| signal.shifted(-start))),
        panel("velocity, m/s", lines(fine, "v", &|signal| signal)),
        panel("mean acceleration, m/s²", lines(fine, "a", &|signal| signal.mean(WINDOW))),
        panel("its band, m/s²", vibrations(fine)),
        panel("band, damped, m/s²", vibrations(damped)),
    ];
    svg(&format!("Figure 8: a4 along {name}"), &panels)
}

/// Name, colour and run of the two models that are compared.
fn models(family: &Family) -> [(&'static str, RGBColor, &ScissorsRun); 2] {
    [("flexible", FLEXIBLE, &family.flexible), ("2D heat", HEATED, &family.axis_and_section)]
}

/// The rods through end, pivot and end; b1 stays at the origin.
fn snapshot(run: &ScissorsRun, t: f64) -> Snapshot {
    let point = |name: String| {
        let [x, y] = if name == "b1" { [0.0, 0.0] } else { run.position(&name, t) };
        (x, y)
    };
    let rod = |from: &str, to: &str, k: usize| {
        vec![point(format!("{from}{k}")), point(format!("m{k}")), point(format!("{to}{}", k + 1))]
    };
    let name = |rail: &str, k: usize, above: bool| {
        let text = format!("{rail}{k}");
        Name { at: point(text.clone()), text, above }
    };
    let (a1, length) = (point("a1".into()), 0.6);
    Snapshot {
        title: format!("t = {t} s"),
        held: vec![point("b1".into())],
        guided: vec![a1],
        force: Some([(a1.0, a1.1 + length), a1]),
        rods: (1..=3).flat_map(|k| [rod("a", "b", k), rod("b", "a", k)]).collect(),
        names: (1..=4).flat_map(|k| [name("a", k, true), name("b", k, false)]).collect(),
    }
}

/// The curves of Figures 7 and 8 as columns, every 2 ms.
pub fn curves(structure: &Structure) -> Trajectory {
    let models = [
        ("flexible", &structure.fine.flexible),
        ("1d", &structure.fine.axis),
        ("2d", &structure.fine.axis_and_section),
    ];
    let (mut columns, mut signals) = (vec!["t".to_string()], Vec::new());
    for (model, run) in models {
        for quantity in ["", "v", "a"] {
            for (axis, signal) in ["x", "y"].iter().zip(run.of_point("a4", quantity)) {
                columns.push(format!("{model}.a4.{quantity}{axis}"));
                signals.push(signal.points());
            }
        }
        for rod in RODS {
            columns.push(format!("{model}.{rod}.w"));
            signals.push(run.deflection(rod).points());
        }
    }
    let every = (2e-3 / STEP).round() as usize;
    let rows = signals.first().map_or(0, Vec::len);
    let row =
        |n: usize| std::iter::once(signals[0][n].0).chain(signals.iter().map(|signal| signal[n].1)).collect::<Vec<_>>();
    Trajectory { columns, rows: (0..rows).step_by(every).map(row).collect() }
}
