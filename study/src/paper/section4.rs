//! Pictures of Section 4, and the positions of a4.

use plotters::style::RGBColor;
use serde::Serialize;

use super::claims_section4::WINDOW;
use super::scissors::{Family, RODS, STEP, ScissorsRun, Structure};
use super::time_series::Signal;
use crate::error::{Error, Result};
use crate::figure::{Curve, Panel, Stroke, svg};
use crate::palette::{BLACK, BLUE, ORANGE};
use crate::path::distance;
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
    ["figure6.svg", "figure7.svg", "figure7-change.svg", "figure8-x.svg", "figure8-y.svg", "structure.svg"];

/// Figures 6, 7 and 8, the change of Figure 7 by heat, and the structure at six instants, with their file names.
pub fn pictures(structure: &Structure) -> Result<Vec<(&'static str, String)>> {
    let (flexible, heated, axis) = (&structure.fine.flexible, &structure.fine.axis_and_section, &structure.fine.axis);
    let curve = |name, colour, signal: &Signal| Curve::line(name, colour, signal.points());
    let broad = |curve| Curve { stroke: Stroke::Broad, ..curve };
    let deflection = RODS.map(|rod| Panel {
        quantity: format!("deflection of {rod}, m"),
        curves: vec![
            broad(curve("flexible", FLEXIBLE, &flexible.deflection(rod))),
            curve("2D heat", HEATED, &heated.deflection(rod)),
        ],
    });
    let difference = RODS.map(|rod| {
        let less = |run: &ScissorsRun| run.deflection(rod).less(&flexible.deflection(rod));
        Panel {
            quantity: format!("change of deflection of {rod}, m"),
            curves: vec![curve("1D heat", ORANGE, &less(axis)), curve("2D heat", HEATED, &less(heated))],
        }
    });
    Ok(vec![
        (
            "figure6.svg",
            svg("Figure 6: change of temperature over time (assumed between the corners)", &[temperature()?])?,
        ),
        ("figure7.svg", svg("Figure 7: deflection of the rods' middles", &deflection)?),
        ("figure7-change.svg", svg("Figure 7: change of the deflection by heat (heated minus flexible)", &difference)?),
        ("figure8-x.svg", figure8(structure, 0)?),
        ("figure8-y.svg", figure8(structure, 1)?),
        (
            "structure.svg",
            snapshot::svg("The flexible structure at six instants", &TIMES.map(|t| snapshot(flexible, t)))?,
        ),
    ])
}

fn temperature() -> Result<Panel<'static>> {
    let name = "scissors-3-thermal";
    let temperature = builtin(name)?.temperature.ok_or_else(|| Error::fixture(name, "it has no temperature"))?;
    let points = temperature.history.iter().map(|&[t, change]| (t, change)).collect();
    Ok(Panel { quantity: "change of temperature, K".into(), curves: vec![Curve::line("temperature", HEATED, points)] })
}

/// Displacement, velocity and acceleration of a4 along one axis. The acceleration at an instant does not converge with the mesh; below it
/// are its mean over 20 ms, and the acceleration with numerical damping.
fn figure8(structure: &Structure, axis: usize) -> Result<String> {
    let curve = |name, colour, run: &ScissorsRun, quantity: &str, stroke, change: &dyn Fn(Signal) -> Signal| {
        let [x, y] = run.of_point("a4", quantity);
        Curve { stroke, ..Curve::line(name, colour, change([x, y][axis].clone()).points()) }
    };
    let lines = |family: &Family, quantity: &str, change: &dyn Fn(Signal) -> Signal| {
        vec![
            curve("flexible", FLEXIBLE, &family.flexible, quantity, Stroke::Broad, change),
            curve("2D heat", HEATED, &family.axis_and_section, quantity, Stroke::Line, change),
        ]
    };
    // The smaller vibration is on top.
    let vibrations = |family: &Family| {
        vec![
            curve("2D heat", HEATED, &family.axis_and_section, "a", Stroke::Faint, &|signal| signal),
            curve("flexible", FLEXIBLE, &family.flexible, "a", Stroke::Thin, &|signal| signal),
        ]
    };
    let (fine, damped) = (&structure.fine, &structure.damped);
    let start = fine.flexible.position("a4", 0.0)[axis];
    let name = ["x", "y"][axis];
    let panel = |quantity: String, curves: Vec<Curve<'static>>| Panel { quantity, curves };
    let panels = [
        panel(format!("displacement along {name}, m"), lines(fine, "", &|signal| signal.shifted(-start))),
        panel(format!("velocity along {name}, m/s"), lines(fine, "v", &|signal| signal)),
        panel(format!("acceleration along {name}, m/s²"), vibrations(fine)),
        panel("its mean over 20 ms, m/s²".into(), lines(fine, "a", &|signal| signal.mean(WINDOW))),
        panel("acceleration, with damping, m/s²".into(), vibrations(damped)),
    ];
    let title = "acceleration at an instant does not converge with the mesh, see its mean";
    svg(&format!("Figure 8: a4 along {name}; {title}"), &panels)
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
    Snapshot {
        title: format!("t = {t} s"),
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
