//! All runs of the deployable structure of Section 4.

use super::reading::Reading;
use super::time_series::Signal;
use crate::error::Result;
use crate::parallel::in_parallel;
use crate::scene::point_probe;
use ancf::internals::model::Scissors;
use ancf::model::{Method, Quantity, Scene, ThermalModel};
use ancf::run::{Trajectory, run};

/// Mesh and step of the main runs; others have half the elements or twice the step.
pub const ELEMENTS: usize = 8;
pub const STEP: f64 = 5e-4;

/// Step and spectral radius of the runs with numerical damping, as engineering programs have it.
pub const DAMPED_STEP: f64 = 1e-3;
pub const DAMPED_RHO: f64 = 0.9;

/// All named points except b1, which is fixed.
pub const POINTS: [&str; 10] = ["a1", "a2", "a3", "a4", "b2", "b3", "b4", "m1", "m2", "m3"];

/// Rods whose deflection the paper plots.
pub const RODS: [&str; 3] = ["b1a2", "b2a3", "b3a4"];

/// Temperature history with its hot half only: it returns to 0 with the same slope and stays there.
const HOT_HALF: [[f64; 2]; 4] = [[0.0, 0.0], [0.25, 150.0], [1.25, 150.0], [1.5, 0.0]];

/// End of the runs with that half, s: the statement about it ends there.
const HOT_HALF_END: f64 = 2.5;

/// Heat of the rods.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Heat {
    None,
    Axis,
    Section,
    AxisAndSection,
    /// Axis and section, without the cold half.
    HotHalf,
}

impl Heat {
    /// Whether nothing but deflections is asked of its runs.
    fn has_deflections_only(self) -> bool {
        matches!(self, Heat::Section | Heat::HotHalf)
    }
}

/// Setup of one run.
#[derive(Clone, Copy, Debug)]
struct ScissorsSetup {
    reading: Reading,
    heat: Heat,
    elements: usize,
    step: f64,
    damped: bool,
    energy: bool,
}

/// Runs with one mesh, step and method, and all five kinds of heat.
pub struct Family {
    pub flexible: ScissorsRun,
    pub axis: ScissorsRun,
    /// Its columns are deflections only, as are those of `hot_half`, which ends early.
    pub section: ScissorsRun,
    pub axis_and_section: ScissorsRun,
    pub hot_half: ScissorsRun,
}

/// All families of runs.
pub struct Structure {
    /// Energy–momentum, without damping.
    pub fine: Family,
    /// Energy–momentum with half the elements.
    pub coarse: Family,
    /// Generalized-α with numerical damping.
    pub damped: Family,
    /// Energy–momentum with twice the step.
    pub twice_the_step: Family,
}

/// Columns of a run over time.
pub struct ScissorsRun {
    step: f64,
    trajectory: Trajectory,
}

impl ScissorsRun {
    /// A column; empty if there is none of that name.
    pub fn signal(&self, column: &str) -> Signal {
        Signal::new(self.step, self.trajectory.column(column).unwrap_or_default())
    }

    /// The two components of a point's position (""), velocity ("v") or acceleration ("a").
    pub fn of_point(&self, point: &str, quantity: &str) -> [Signal; 2] {
        ["x", "y"].map(|axis| self.signal(&format!("{point}.{quantity}{axis}")))
    }

    /// Deflection of a rod's middle.
    pub fn deflection(&self, rod: &str) -> Signal {
        self.signal(&format!("{rod}.w"))
    }

    /// Position of a point at time `t`; NaN if there is no such row.
    pub fn position(&self, point: &str, t: f64) -> [f64; 2] {
        let row = (t / self.step).round() as usize;
        self.of_point(point, "").map(|signal| signal.points().get(row).map_or(f64::NAN, |point| point.1))
    }

    /// Largest imbalance of energy, and energy put in at the end, J.
    pub fn energy_balance(&self) -> [f64; 2] {
        let input = self.trajectory.column("energy.input").and_then(|column| column.last().copied());
        [self.signal("energy.balance").largest(), input.unwrap_or(f64::NAN)]
    }
}

impl Structure {
    /// Runs all families of a reading.
    pub fn simulate(reading: &Reading) -> Result<Structure> {
        let family = |elements, step, damped, energy| {
            [Heat::None, Heat::Axis, Heat::Section, Heat::AxisAndSection, Heat::HotHalf].map(|heat| ScissorsSetup {
                reading: *reading,
                heat,
                elements,
                step,
                damped,
                energy: energy && !heat.has_deflections_only(),
            })
        };
        let families = [
            family(ELEMENTS, STEP, false, true),
            family(ELEMENTS, DAMPED_STEP, true, false),
            family(ELEMENTS, 2.0 * STEP, false, false),
            family(ELEMENTS / 2, STEP, false, false),
        ];
        let mut runs = in_parallel("scissors", families.as_flattened(), simulate)?.into_iter();
        let mut next = || runs.next().unwrap_or(ScissorsRun { step: STEP, trajectory: Trajectory::default() });
        let mut family =
            || Family { flexible: next(), axis: next(), section: next(), axis_and_section: next(), hot_half: next() };
        let (fine, damped, twice_the_step, coarse) = (family(), family(), family(), family());
        Ok(Structure { fine, damped, twice_the_step, coarse })
    }
}

/// Runs a setup. Every step is a row, so that means over a window are complete.
fn simulate(setup: &ScissorsSetup) -> Result<ScissorsRun> {
    Ok(ScissorsRun { step: setup.step, trajectory: run(&scene(setup)?)?.trajectory })
}

fn scene(setup: &ScissorsSetup) -> Result<Scene> {
    let model = match setup.heat {
        Heat::None => ThermalModel::None,
        Heat::Axis => ThermalModel::OneD,
        Heat::Section => ThermalModel::Transverse,
        Heat::AxisAndSection | Heat::HotHalf => ThermalModel::TwoD,
    };
    let Reading { angle, .. } = setup.reading;
    let mut scene = Scissors { elements: setup.elements, model, angle, ..Scissors::new(3) }.scene()?;
    if let (Heat::HotHalf, Some(temperature)) = (setup.heat, &mut scene.temperature) {
        temperature.history = HOT_HALF.to_vec();
        scene.time.end = HOT_HALF_END;
    }
    setup.reading.apply(&mut scene);
    if setup.damped {
        (scene.time.method, scene.time.rho_inf) = (Method::GeneralizedAlpha, DAMPED_RHO);
    }
    scene.time.step = setup.step;
    (scene.output.interval, scene.output.energy) = (None, setup.energy);
    let of = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration];
    scene.probes.retain(|probe| probe.rod.is_some());
    if !setup.heat.has_deflections_only() {
        scene.probes.extend(POINTS.map(|name| point_probe(name, &of)));
    }
    Ok(scene)
}
