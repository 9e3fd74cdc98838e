//! The deployable structure of Section 4 in all runs that its pictures and statements need.

use super::time_series::Signal;
use crate::error::Result;
use crate::parallel::in_parallel;
use ancf::model::{Method, Probe, Quantity, Scene, Scissors, ThermalModel};
use ancf::run::{Trajectory, run};

/// What is drawn and tabled; half the elements and twice the step are beside it.
pub const ELEMENTS: usize = 8;
pub const STEP: f64 = 5e-4;

/// Step and spectral radius of the runs with numerical damping, as an engineer's program would have it.
pub const DAMPED_STEP: f64 = 1e-3;
pub const DAMPED_RHO: f64 = 0.9;

/// All named points but b1, which is fixed.
pub const POINTS: [&str; 10] = ["a1", "a2", "a3", "a4", "b2", "b3", "b4", "m1", "m2", "m3"];

/// Rods whose deflection the paper plots.
pub const RODS: [&str; 3] = ["b1a2", "b2a3", "b3a4"];

/// The hot half of the temperature's curve: it returns to 0 with the same slope and stays there.
const HOT_HALF: [[f64; 2]; 4] = [[0.0, 0.0], [0.25, 150.0], [1.25, 150.0], [1.5, 0.0]];

/// How the rods are heated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heat {
    None,
    Axis,
    AxisAndSection,
    /// Axis and section, but without the cold half.
    HotHalf,
}

/// One run.
#[derive(Clone, Copy, Debug)]
struct Variant {
    heat: Heat,
    elements: usize,
    step: f64,
    damped: bool,
    energy: bool,
}

/// The same mesh, step and method with the four ways of heating.
pub struct Family {
    pub flexible: Motion,
    pub axis: Motion,
    pub axis_and_section: Motion,
    pub hot_half: Motion,
}

/// Everything that Section 4 is judged by.
pub struct Structure {
    /// Energy–momentum, which damps nothing.
    pub fine: Family,
    /// The same with half the elements.
    pub coarse: Family,
    /// Generalized-α with numerical damping.
    pub damped: Family,
    /// The same as `fine` with twice the step.
    pub twice_the_step: Family,
}

/// A run's columns over time.
pub struct Motion {
    step: f64,
    trajectory: Trajectory,
}

impl Motion {
    /// A column; no samples if there is none of that name.
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

    /// Position of a point at time `t`; not a number where there is no such row.
    pub fn position(&self, point: &str, t: f64) -> [f64; 2] {
        let row = (t / self.step).round() as usize;
        self.of_point(point, "").map(|signal| signal.points().get(row).map_or(f64::NAN, |point| point.1))
    }

    /// Largest imbalance of energy over the energy put in at the end; both in J.
    pub fn energy_balance(&self) -> [f64; 2] {
        let input = self.trajectory.column("energy.input").and_then(|column| column.last().copied());
        [self.signal("energy.balance").largest(), input.unwrap_or(f64::NAN)]
    }
}

impl Structure {
    /// Makes all runs.
    pub fn simulate() -> Result<Structure> {
        let family = |elements, step, damped, energy| {
            [Heat::None, Heat::Axis, Heat::AxisAndSection, Heat::HotHalf].map(|heat| Variant {
                heat,
                elements,
                step,
                damped,
                energy,
            })
        };
        let families = [
            family(ELEMENTS, STEP, false, true),
            family(ELEMENTS, DAMPED_STEP, true, false),
            family(ELEMENTS, 2.0 * STEP, false, false),
            family(ELEMENTS / 2, STEP, false, false),
        ];
        let mut motions = in_parallel("scissors", families.as_flattened(), motion)?.into_iter();
        let mut next = || motions.next().unwrap_or(Motion { step: STEP, trajectory: Trajectory::default() });
        let mut family = || Family { flexible: next(), axis: next(), axis_and_section: next(), hot_half: next() };
        let (fine, damped, twice_the_step, coarse) = (family(), family(), family(), family());
        Ok(Structure { fine, damped, twice_the_step, coarse })
    }
}

/// Runs a variant; every step is a row, so that means over a window miss nothing.
fn motion(variant: &Variant) -> Result<Motion> {
    let trajectory = run(&scene(variant)?)?.trajectory;
    Ok(Motion { step: variant.step, trajectory })
}

fn scene(variant: &Variant) -> Result<Scene> {
    let model = match variant.heat {
        Heat::None => ThermalModel::None,
        Heat::Axis => ThermalModel::OneD,
        Heat::AxisAndSection | Heat::HotHalf => ThermalModel::TwoD,
    };
    let mut scene = Scissors { elements: variant.elements, model, ..Scissors::new(3) }.scene()?;
    if let (Heat::HotHalf, Some(temperature)) = (variant.heat, &mut scene.temperature) {
        temperature.history = HOT_HALF.to_vec();
    }
    if variant.damped {
        (scene.time.method, scene.time.rho_inf) = (Method::GeneralizedAlpha, DAMPED_RHO);
    }
    scene.time.step = variant.step;
    (scene.output.interval, scene.output.energy) = (None, variant.energy);
    let of = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration];
    let point =
        |name: &str| Probe { name: name.into(), point: Some(name.into()), rod: None, at: None, of: of.to_vec() };
    scene.probes.retain(|probe| probe.rod.is_some());
    scene.probes.extend(POINTS.map(point));
    Ok(scene)
}
