//! Savings: run time with and without each economy on a scene where it applies, in turns, and the change of the results.

use std::cell::RefCell;

use serde::Serialize;

use super::timing::{Lap, Timing};
use super::turns::{Runner, take_turns};
use crate::error::{Error, Result};
use crate::path::largest_of;
use crate::scene::{Change, builtin};
use ancf::internals::model::Plan;
use ancf::internals::run::run_planned;
use ancf::model::{Constraints, Element, Method, Quantity, Scene};
use ancf::run::Run;

/// An economy: its saving of run time, and the change of the results.
#[derive(Clone, Debug, Serialize)]
pub struct Economy {
    /// The part that is left out.
    pub what: &'static str,
    /// The measured scene.
    pub scene: String,
    /// Run time without that part.
    pub without: Timing,
    /// Run time with it.
    pub with: Timing,
    /// Largest distance of the probe's positions between the two, m.
    pub difference: f64,
}

/// A run, and what is read of it meanwhile.
#[derive(Clone)]
struct Job {
    scene: Scene,
    plan: Plan,
    /// Steps from one reading of the rods' axes, as for the page of a run, to the next.
    axes_every: Option<usize>,
}

/// Two jobs: without and with the part.
struct Pair {
    what: &'static str,
    without: Job,
    with: Job,
}

/// Measures all economies.
///
/// # Errors
/// Those of the runs.
pub fn measure() -> Result<Vec<Economy>> {
    pairs()?.into_iter().map(measured).collect()
}

const PENDULUM: &str = "pendulum-flexible";
const SCISSORS: &str = "scissors-3";

/// Time from row to row of a run that records no more than a plot needs, s.
const ROWS: f64 = 0.05;

/// Points of a rod's axis in a frame of a run's page.
const AXIS: [f64; 17] = {
    let mut at = [0.0; 17];
    let mut n = 0;
    while n < 17 {
        at[n] = n as f64 / 16.0;
        n += 1;
    }
    at
};

fn job(name: &'static str, method: Method, step: f64, elements: usize) -> Result<Job> {
    let mut scene = builtin(name)?.meshed(Element::Ancf, elements).solved(method, step, 1.0).rows_every(ROWS);
    scene.output.energy = false;
    scene.probes.iter_mut().for_each(|probe| probe.of.retain(|quantity| *quantity == Quantity::Position));
    scene.probes.retain(|probe| !probe.of.is_empty());
    Ok(Job { plan: Plan::of(&scene), scene, axes_every: None })
}

impl Job {
    /// With another scene.
    fn changed(&self, change: impl FnOnce(&mut Scene)) -> Job {
        let mut scene = self.scene.clone();
        change(&mut scene);
        Job { plan: Plan::of(&scene), scene, axes_every: self.axes_every }
    }

    fn run(&self) -> Result<Run> {
        let mut axes = Vec::new();
        let run = run_planned(&self.scene, &self.plan, |simulation| {
            if self.axes_every.is_some_and(|every| simulation.steps_done().is_multiple_of(every)) {
                axes.extend(self.scene.rods.iter().map(|rod| simulation.axis(&rod.name, &AXIS)));
            }
        })?;
        Ok(run)
    }
}

fn pairs() -> Result<Vec<Pair>> {
    let explicit = job(PENDULUM, Method::Explicit, 5e-5, 8)?;
    let implicit = job(PENDULUM, Method::GeneralizedAlpha, 1e-3, 8)?;
    let scissors = job(SCISSORS, Method::GeneralizedAlpha, 1e-3, 4)?;
    let every_step = |job: &Job| job.changed(|scene| scene.output.interval = Some(scene.time.step));
    let cable =
        |job: &Job| job.changed(|scene| *scene = scene.clone().meshed(Element::EulerBernoulli, scene.rods[0].elements));
    let new_matrices = |job: &Job| {
        let mut fresh = job.clone();
        fresh.plan.new_matrices = true;
        fresh
    };
    let rows = every_step(&explicit);
    let energies = rows.changed(|scene| scene.output.energy = true);
    let frames = Job { axes_every: Some(100), ..explicit.clone() };
    let pinned = scissors.changed(|scene| scene.constraints = Constraints::Multipliers);
    let (explicit_cable, implicit_cable, scissors_cable) = (cable(&explicit), cable(&implicit), cable(&scissors));
    let pair = |what, without: &Job, with: &Job| Pair { what, without: without.clone(), with: with.clone() };
    Ok(vec![
        pair("a row each step", &explicit, &rows),
        pair("energies each step", &rows, &energies),
        pair("axes of the rods for the page of a run, 200 frames", &explicit, &frames),
        pair(
            "shear and the section's stretch: Euler–Bernoulli in place of the paper's element",
            &explicit_cable,
            &explicit,
        ),
        pair("the same, implicit", &implicit_cable, &implicit),
        pair("the same, pinned rods", &scissors_cable, &scissors),
        pair("multipliers: pins as shared coordinates", &scissors, &pinned),
        pair("new matrices in each iteration", &implicit, &new_matrices(&implicit)),
        pair("the same, Euler–Bernoulli", &implicit_cable, &new_matrices(&implicit_cable)),
        pair("the same, pinned rods", &scissors, &new_matrices(&scissors)),
    ])
}

fn measured(Pair { what, without, with }: Pair) -> Result<Economy> {
    let ends = RefCell::new([None, None]);
    let runner = |job: &Job, n: usize| -> Runner {
        let (job, ends) = (job.clone(), &ends);
        Box::new(move || {
            let (run, lap): (_, Lap) = Lap::of(|| job.run());
            ends.borrow_mut()[n] = Some(run?);
            Ok(lap)
        })
    };
    let timings = take_turns(&mut [runner(&without, 0), runner(&with, 1)])?;
    let ends = ends.into_inner();
    let (Ok([Some(first), Some(second)]), [Some(a), Some(b)]) = (<[Option<Timing>; 2]>::try_from(timings), &ends)
    else {
        return Err(Error::fixture("economies", "nothing was measured"));
    };
    Ok(Economy { what, scene: name(&with.scene), without: first, with: second, difference: difference(a, b) })
}

/// The scene with its mesh, step and end.
fn name(scene: &Scene) -> String {
    let name = if scene.rods.len() == 1 { PENDULUM } else { SCISSORS };
    let elements = scene.rods.first().map_or(0, |rod| rod.elements);
    format!("{name}, {}, {elements} elements, {:e} s, to {} s", scene.time.method, scene.time.step, scene.time.end)
}

/// Largest difference of a position's component at the rows of both, m.
fn difference(a: &Run, b: &Run) -> f64 {
    let same = |row: &&[f64]| b.trajectory.rows.iter().find(|other| (other[0] - row[0]).abs() < 1e-9);
    let pairs = a.trajectory.rows.iter().filter_map(|row| Some((row, same(&row)?)));
    let count = a.trajectory.columns.iter().filter(|name| name.ends_with(".x") || name.ends_with(".y")).count();
    let values = pairs.flat_map(|(a, b)| a[1..=count].iter().zip(&b[1..=count]).map(|(a, b)| (a - b).abs()));
    largest_of(values)
}
