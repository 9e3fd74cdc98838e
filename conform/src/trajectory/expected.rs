//! Errors that right methods make with a step, and what beams differ from the solid by.

use std::collections::BTreeMap;

use ancf::model::{Constraints, Element, Scene};
use ancf::run::Simulation;

use super::frames::{Frames, distance, largest_difference};
use super::mistakes::methods::right_methods;
use super::motion::{Method, frames};
use super::reference::Reference;
use super::rods::Rods;
use super::setup::Setup;

/// Beams differ from the solid by this many distances of a beam of eight or sixteen elements.
const BEAM_OFF: f64 = 1.5;

/// Errors of right methods with a step.
#[derive(Clone, Debug, Default)]
pub struct Expected {
    /// Largest error of positions, m.
    pub position: f64,
    /// Of velocities, m/s.
    pub velocity: f64,
    /// Of energies by name, J.
    pub energy: BTreeMap<String, f64>,
    /// The methods' motions.
    pub motions: Vec<Frames>,
}

impl Expected {
    /// Largest errors of right methods with a step; `right` has the reference at the program's times. `None` if no method gets to the end.
    pub fn with_step(reference: &Reference, right: &Frames, step: f64) -> Option<Expected> {
        let rods = Rods::new(&Setup::of(reference.scene.clone()))?;
        let of_beams = reference.is_solid.then(|| frames(&rods, Method::Fine, &right.t, |_| false));
        let right = of_beams.as_ref().unwrap_or(right);
        let own = right_methods(step).into_iter().map(|method| frames(&rods, method, &right.t, |_| false));
        let mut found = Expected::default();
        // The energy–momentum rule goes on where others fail: at long steps under sudden heat.
        for moved in own.chain(energy_momentum(&reference.scene, step, right)) {
            let position = distance(&right.position, &moved.position);
            if !position.is_finite() {
                continue;
            }
            found.position = found.position.max(position);
            found.velocity = found.velocity.max(distance(&right.velocity, &moved.velocity));
            for (name, off) in energies_off(right, &moved) {
                let worst = found.energy.entry(name).or_default();
                *worst = worst.max(off);
            }
            found.motions.push(moved);
        }
        (!found.motions.is_empty()).then_some(found)
    }

    /// What beams differ from the solid by; nothing for rods.
    pub fn of_beams(reference: &Reference, right: &Frames) -> Expected {
        let mut found = Expected::default();
        if !reference.is_solid {
            return found;
        }
        for elements in [8, 16] {
            let mut setup = Setup::of(reference.scene.clone());
            setup.scene.rods.iter_mut().for_each(|rod| (rod.element, rod.elements) = (Element::Ancf, elements));
            let Some(rods) = Rods::new(&setup) else { continue };
            let moved = frames(&rods, Method::Fine, &right.t, |_| false);
            found.position = found.position.max(BEAM_OFF * distance(&right.position, &moved.position));
            for (name, off) in energies_off(right, &moved) {
                let worst = found.energy.entry(name).or_default();
                *worst = worst.max(BEAM_OFF * off);
            }
        }
        found
    }
}

/// Largest difference of each energy, over the times for which both have it.
fn energies_off(right: &Frames, moved: &Frames) -> Vec<(String, f64)> {
    let off =
        |(name, list): (&String, &Vec<f64>)| Some((name.clone(), largest_difference(list, moved.energy.get(name)?)));
    right.energy.iter().filter_map(off).collect()
}

/// Motion by the library's energy–momentum rule at the times of the right one; `None` if it fails.
fn energy_momentum(scene: &Scene, step: f64, right: &Frames) -> Option<Frames> {
    let interval = right.t.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    let mut scene = scene.clone();
    (scene.time.method, scene.constraints) = (ancf::model::Method::EnergyMomentum, Constraints::Condensed);
    (scene.time.step, scene.time.end) = (interval / (interval / step * (1.0 - 1e-9)).ceil(), *right.t.last()?);
    scene.output.interval = None;
    scene.probes.clear();
    let mut simulation = Simulation::new(scene).ok()?;
    let mut moved = Frames { t: right.t.clone(), ..Frames::default() };
    for t in &right.t {
        simulation.run_until(*t).ok()?;
        for point in right.position.keys() {
            moved.position.entry(point.clone()).or_default().push(simulation.position(point).ok()?);
            moved.velocity.entry(point.clone()).or_default().push(simulation.velocity(point).ok()?);
        }
        let energy = simulation.energy();
        for (name, energy) in [("kinetic", energy.kinetic), ("strain", energy.strain), ("potential", energy.potential)]
        {
            moved.energy.entry(name.into()).or_default().push(energy);
        }
    }
    Some(moved)
}
