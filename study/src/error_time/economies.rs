//! What each economy of the plan saves: run time with and without it on a scene where it applies, and what it changes of the
//! results.

use std::time::Instant;

use serde::Serialize;

use super::timing::{RUNS, Timing};
use crate::error::{Error, Result};
use ancf::model::plan::Plan;
use ancf::model::{Constraints, Element, Method, Quantity, Scene};
use ancf::run::{Run, run_planned};

/// An economy and what it saves.
#[derive(Clone, Debug, Serialize)]
pub struct Economy {
    /// What is left out.
    pub what: &'static str,
    /// Where it was measured.
    pub scene: String,
    /// Run time without what is left out, and with it.
    pub pruned: Timing,
    /// The same with it.
    pub full: Timing,
    /// Largest distance of the probe's positions between the two, m.
    pub difference: f64,
}

impl Economy {
    /// How many times as long a run takes with what is left out.
    pub fn ratio(&self) -> f64 {
        self.full.median / self.pruned.median
    }
}

/// A scene and what it is compared with.
struct Comparison {
    what: &'static str,
    pruned: (Scene, Plan),
    full: (Scene, Plan),
}

/// Measures all of them.
///
/// # Errors
/// Those of the runs.
pub fn measure() -> Result<Vec<Economy>> {
    comparisons()?.into_iter().map(measured).collect()
}

fn scene(name: &'static str, method: Method, step: f64, elements: usize) -> Result<Scene> {
    let missing = || Error::Fixture { name, reason: "there is no such scene".into() };
    let mut scene = Scene::builtin(name).ok_or_else(missing)?;
    scene.rods.iter_mut().for_each(|rod| rod.elements = elements);
    (scene.time.method, scene.time.step, scene.time.end) = (method, step, 1.0);
    scene.output.energy = false;
    scene.output.interval = Some(0.01);
    for probe in &mut scene.probes {
        probe.of.retain(|quantity| *quantity == Quantity::Position);
    }
    scene.probes.retain(|probe| !probe.of.is_empty());
    Ok(scene)
}

/// The same scene with a plan that computes more than it needs.
fn with(what: &'static str, scene: Scene, more: impl FnOnce(&mut Plan)) -> Comparison {
    let pruned = Plan::of(&scene);
    let mut full = pruned;
    more(&mut full);
    Comparison { what, pruned: (scene.clone(), pruned), full: (scene, full) }
}

fn comparisons() -> Result<Vec<Comparison>> {
    let explicit = || scene("pendulum-flexible", Method::Explicit, 5e-5, 8);
    let implicit = || scene("pendulum-flexible", Method::GeneralizedAlpha, 1e-3, 8);
    let scissors = || scene("scissors-3", Method::GeneralizedAlpha, 1e-3, 4);
    let mut pinned = scissors()?;
    pinned.constraints = Constraints::Multipliers;
    let mut cable = implicit()?;
    cable.rods.iter_mut().for_each(|rod| rod.element = Element::EulerBernoulli);
    let shared = scissors()?;
    Ok(vec![
        with("no `temperature`: no thermal strains", explicit()?, |plan| plan.heat = true),
        with("ν = 0: no Poisson's terms", explicit()?, |plan| plan.poisson = true),
        with("no `gravity`: no weight", scissors()?, |plan| plan.weight = true),
        with("no energy columns: no energies", explicit()?, |plan| plan.energy = true),
        with("no probe of it: no accelerations and reactions", explicit()?, |plan| plan.acceleration = true),
        with("earlier tangent and factors used again", implicit()?, |plan| plan.new_matrices = true),
        with("the same, Euler–Bernoulli elements", cable, |plan| plan.new_matrices = true),
        Comparison {
            what: "pins as shared coordinates: no multipliers",
            pruned: (shared.clone(), Plan::of(&shared)),
            full: (pinned.clone(), Plan::of(&pinned)),
        },
    ])
}

/// Both runs in turn, so that slow phases of the machine hit both.
fn measured(Comparison { what, pruned, full }: Comparison) -> Result<Economy> {
    let timed = |(scene, plan): &(Scene, Plan)| -> Result<(Run, f64)> {
        let clock = Instant::now();
        let run = run_planned(scene, plan, |_| ())?;
        Ok((run, clock.elapsed().as_secs_f64()))
    };
    let ((first, _), (second, _)) = (timed(&pruned)?, timed(&full)?);
    let (mut without, mut all) = (Vec::new(), Vec::new());
    for _ in 0..RUNS {
        without.push(timed(&pruned)?.1);
        all.push(timed(&full)?.1);
    }
    let nothing = || Error::Fixture { name: "economies", reason: "nothing was measured".into() };
    Ok(Economy {
        what,
        scene: name(&pruned.0),
        pruned: Timing::of(&without).ok_or_else(nothing)?,
        full: Timing::of(&all).ok_or_else(nothing)?,
        difference: difference(&first, &second),
    })
}

fn name(scene: &Scene) -> String {
    let kind = if scene.rods.len() == 1 { "pendulum-flexible" } else { "scissors-3" };
    let elements = scene.rods.first().map_or(0, |rod| rod.elements);
    format!("{kind}, {}, {elements} elements, {:e} s, to {} s", scene.time.method, scene.time.step, scene.time.end)
}

/// Largest difference of a position's component, m.
fn difference(a: &Run, b: &Run) -> f64 {
    let rows = a.trajectory.rows.iter().zip(&b.trajectory.rows);
    let values = rows.flat_map(|(a, b)| a.iter().zip(b).skip(1).map(|(a, b)| (a - b).abs()));
    values.fold(0.0, |largest, value| if value <= largest { largest } else { value })
}
