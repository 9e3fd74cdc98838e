//! What stands at t = 0: positions, coordinates, masses, accelerations, the strain energy of the heat.

use std::collections::BTreeMap;

use super::comparison::Comparison;
use super::frames::{Path, distance, largest_difference};
use super::mass::mass_result;
use super::matching::observed_near;
use super::mistake::Made;
use super::mistakes::mistakes;
use super::motion::initial_acceleration;
use super::outcome::{Named, StartResult};
use super::rods::Rods;
use super::setup::Setup;

const MASS: &str = "mass matrix M";
const ACCELERATIONS: &str = "accelerations q̈";
const STRAIN_ENERGY: &str = "strain energy";
/// Part of the strain energy at t = 0 by which it may be off: programs print few digits of energies.
const ENERGY_TOLERANCE: f64 = 1e-3;

impl Comparison<'_> {
    /// What stands at t = 0.
    pub fn start(&self) -> Vec<StartResult> {
        let (run, _) = self.last();
        let mut all = Vec::new();
        let frames = &run.sampled.frames;
        if frames.t.first() == Some(&0.0) {
            let first = |table: &BTreeMap<String, Path>| -> BTreeMap<String, Path> {
                table.iter().filter_map(|(point, path)| Some((point.clone(), vec![*path.first()?]))).collect()
            };
            let off = distance(&first(&frames.position), &first(&self.right(run).position));
            all.push(StartResult {
                what: "positions".into(),
                right: off <= self.allowed(run, 0),
                detail: format!("off by {off:.1e} m"),
            });
        }
        let Some(rods) = Rods::new(&Setup::of(self.reference.scene.clone())) else { return all };
        let mut vector = |what: &str, own: &Option<Vec<f64>>, right: &[f64], tolerance: f64| {
            let Some(own) = own else { return };
            let scale = right.iter().fold(1.0, |scale: f64, a| scale.max(a.abs()));
            let (right_here, detail) = match own.len() == right.len() {
                true => {
                    let off = largest_difference(own, right);
                    (off <= tolerance * scale, format!("off by {off:.1e}, the largest is {scale:.3}"))
                }
                false => (false, format!("{} numbers; allowed: {}, in the fixtures' order", own.len(), right.len())),
            };
            all.push(StartResult { what: what.into(), right: right_here, detail });
        };
        let nodal = self.reference.nodal.clone().unwrap_or_else(|| rods.start.as_slice().to_vec());
        vector("nodal coordinates q", &run.written.nodal, &nodal, 1e-9);
        let a = self.reference.acceleration.clone().unwrap_or_else(|| initial_acceleration(&rods).as_slice().to_vec());
        vector(ACCELERATIONS, &run.written.acceleration, &a, 1e-6);
        if let Some(mass) = &run.written.mass {
            all.push(mass_result(mass, &rods.mass));
        }
        all.extend(self.strain_at_the_start(&rods));
        all
    }

    /// The strain energy at t = 0, which no step enters: that of the heat, where heat acts at once.
    fn strain_at_the_start(&self, rods: &Rods) -> Option<StartResult> {
        let own = self.own_strain_at_the_start()?;
        let right = self.reference.frames.energy.get("strain").and_then(|list| list.first().copied());
        let right = right.unwrap_or_else(|| rods.strain_at_the_start());
        // A program may count from what the heat alone stores, which is anybody's choice.
        let counts_from_the_start = own.abs() <= ENERGY_TOLERANCE * right;
        let off = (own - right).abs();
        let is_right = counts_from_the_start || off <= ENERGY_TOLERANCE * right.abs() + self.least_energy();
        Some(StartResult {
            what: STRAIN_ENERGY.into(),
            right: is_right,
            detail: format!("{own:.6} J, expected {right:.6}: {:.4} of it", own / right),
        })
    }

    fn own_strain_at_the_start(&self) -> Option<f64> {
        let (run, _) = self.last();
        let frames = &run.sampled.frames;
        frames.energy.get("strain")?.first().copied().filter(|_| frames.t.first() == Some(&0.0))
    }

    /// An energy that counts as none, J.
    fn least_energy(&self) -> f64 {
        let all = self.reference.frames.energy.values().flatten();
        1e-6 * all.fold(0.0, |most: f64, energy| most.max(energy.abs()))
    }

    /// Mistakes that give the program's mass, accelerations or strain energy at t = 0, where these are wrong. Of the energy, which is one
    /// number alone, only those count whose motion is as near as the program's own error `own_error` allows.
    pub fn named_at_the_start(&self, start: &[StartResult], own_error: f64) -> Vec<Named> {
        let (run, off) = self.last();
        let wrong = |what: &str| start.iter().any(|start| start.what == what && !start.right);
        let (mass, acceleration, strain) = (wrong(MASS), wrong(ACCELERATIONS), wrong(STRAIN_ENERGY));
        let mut named = Vec::new();
        if !(mass || acceleration || strain) {
            return named;
        }
        for mistake in mistakes(&self.reference.scene, None) {
            let Made::Setup(setup) = &mistake.made else { continue };
            let Some(rods) = Rods::new(setup) else { continue };
            let mass = mass && run.written.mass.as_ref().is_some_and(|mass| mass_result(mass, &rods.mass).right);
            let acceleration = acceleration
                && run.written.acceleration.as_ref().is_some_and(|own| {
                    let a = initial_acceleration(&rods);
                    own.len() == a.len() && largest_difference(own, a.as_slice()) <= 1e-6 * a.amax().max(1.0)
                });
            let energy = rods.strain_at_the_start();
            let near = 3.0 * own_error.max(0.02 * off);
            let strain = strain
                && self
                    .own_strain_at_the_start()
                    .is_some_and(|own| (own - energy).abs() <= ENERGY_TOLERANCE * energy.abs())
                && observed_near(&run.sampled.frames, &rods, near);
            if mass || acceleration || strain {
                named.push(Named {
                    what: format!("at t = 0: {}", mistake.what),
                    look_at: mistake.look_at.into(),
                    distance: 0.0,
                });
            }
        }
        named.truncate(4);
        named
    }
}
