//! Savings of the plan: run time with and without each economy on a scene where it applies, and the change of the results.

use std::time::Instant;

use serde::Serialize;

use super::timing::{RUNS, Timing};
use crate::error::{Error, Result};
use crate::scene::{Change, builtin};
use ancf::internals::model::Plan;
use ancf::internals::run::run_planned;
use ancf::model::{Constraints, Element, Method, Quantity, Scene};
use ancf::run::Run;

/// An economy of the plan: its saving of run time, and the change of the results.
#[derive(Clone, Debug, Serialize)]
pub struct Economy {
    /// The part that is left out.
    pub what: &'static str,
    /// The measured scene.
    pub scene: String,
    /// Run time without that part.
    pub pruned: Timing,
    /// Run time with it.
    pub full: Timing,
    /// Largest distance of the probe's positions between the two, m.
    pub difference: f64,
}

/// Two scenes with their plans: with and without the economy.
struct PlanPair {
    what: &'static str,
    pruned: (Scene, Plan),
    full: (Scene, Plan),
}

/// Measures all economies.
///
/// # Errors
/// Those of the runs.
pub fn measure() -> Result<Vec<Economy>> {
    pairs()?.into_iter().map(measured).collect()
}

fn scene(name: &'static str, method: Method, step: f64, elements: usize) -> Result<Scene> {
    let mut scene = builtin(name)?.meshed(Element::Ancf, elements).solved(method, step, 1.0).rows_every(0.01);
    scene.output.energy = false;
    scene.probes.iter_mut().for_each(|probe| probe.of.retain(|quantity| *quantity == Quantity::Position));
    scene.probes.retain(|probe| !probe.of.is_empty());
    Ok(scene)
}

/// A scene with its own plan, and with one that computes more.
fn with(what: &'static str, scene: Scene, more: impl FnOnce(&mut Plan)) -> PlanPair {
    let pruned = Plan::of(&scene);
    let mut full = pruned;
    more(&mut full);
    PlanPair { what, pruned: (scene.clone(), pruned), full: (scene, full) }
}

fn pairs() -> Result<Vec<PlanPair>> {
    let explicit = || scene("pendulum-flexible", Method::Explicit, 5e-5, 8);
    let implicit = || scene("pendulum-flexible", Method::GeneralizedAlpha, 1e-3, 8);
    let scissors = || scene("scissors-3", Method::GeneralizedAlpha, 1e-3, 4);
    let mut pinned = scissors()?;
    pinned.constraints = Constraints::Multipliers;
    let cable = implicit()?.meshed(Element::EulerBernoulli, 8);
    let shared = scissors()?;
    Ok(vec![
        with("no `temperature`: no thermal strains", explicit()?, |plan| plan.heat = true),
        with("ν = 0: no Poisson's terms", explicit()?, |plan| plan.poisson = true),
        with("no `gravity`: no weight", scissors()?, |plan| plan.weight = true),
        with("no energy columns: no energies", explicit()?, |plan| plan.energy = true),
        with("no probe of it: no accelerations and reactions", explicit()?, |plan| plan.acceleration = true),
        with("earlier tangent and factors reused", implicit()?, |plan| plan.new_matrices = true),
        with("earlier tangent and factors, Euler–Bernoulli", cable, |plan| plan.new_matrices = true),
        PlanPair {
            what: "pins as shared coordinates: no multipliers",
            pruned: (shared.clone(), Plan::of(&shared)),
            full: (pinned.clone(), Plan::of(&pinned)),
        },
    ])
}

/// Times both runs alternately, so that slow phases of the machine affect both.
fn measured(PlanPair { what, pruned, full }: PlanPair) -> Result<Economy> {
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
    let nothing = || Error::fixture("economies", "nothing was measured");
    Ok(Economy {
        what,
        scene: name(&pruned.0),
        pruned: Timing::of(&without).ok_or_else(nothing)?,
        full: Timing::of(&all).ok_or_else(nothing)?,
        difference: difference(&first, &second),
    })
}

/// The scene with its mesh, step and end.
fn name(scene: &Scene) -> String {
    let name = if scene.rods.len() == 1 { "pendulum-flexible" } else { "scissors-3" };
    let elements = scene.rods.first().map_or(0, |rod| rod.elements);
    format!("{name}, {}, {elements} elements, {:e} s, to {} s", scene.time.method, scene.time.step, scene.time.end)
}

/// Largest difference of a position's component, m.
fn difference(a: &Run, b: &Run) -> f64 {
    let rows = a.trajectory.rows.iter().zip(&b.trajectory.rows);
    let values = rows.flat_map(|(a, b)| a.iter().zip(b).skip(1).map(|(a, b)| (a - b).abs()));
    values.fold(0.0, |largest, value| if value <= largest { largest } else { value })
}
