//! Energies and velocities of the program beside the reference's.

use std::collections::BTreeMap;

use super::comparison::Comparison;
use super::frames::{farthest, largest_difference};
use super::outcome::{EnergyResult, Named};

/// Part of the largest energy, or velocity, by which it may be off where positions agree.
const ENERGY_OFF: f64 = 0.02;

impl Comparison<'_> {
    /// Energies of the program beside the reference's.
    pub fn energies(&self) -> Vec<EnergyResult> {
        let (run, _) = self.last();
        let (mut own, mut right) = (run.sampled.frames.energy.clone(), self.right(run).energy);
        for (name, list) in &mut own {
            // Those of the solid are not known to the end.
            list.truncate(right.get(name).map_or(0, Vec::len));
        }
        for table in [&mut own, &mut right] {
            // The height from which the potential counts is anybody's choice.
            let potential = table.get_mut("potential");
            potential.into_iter().for_each(|list| {
                let first = list.first().copied().unwrap_or(0.0);
                list.iter_mut().for_each(|energy| *energy -= first);
            });
        }
        let scale = right
            .iter()
            .filter(|(name, _)| *name != "input")
            .flat_map(|(_, list)| list)
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        let mut all = Vec::new();
        for name in ["kinetic", "strain", "potential"] {
            let (Some(own), Some(right)) = (own.get(name), right.get(name)) else { continue };
            let square: f64 = right.iter().map(|b| b * b).sum();
            let along: f64 = own.iter().zip(right).map(|(a, b)| a * b).sum();
            all.push(EnergyResult {
                name: name.into(),
                off: largest_difference(own, right),
                at_the_end: own.last().zip(right.last()).map_or(0.0, |(a, b)| a - b),
                scale,
                factor: Some(along / square),
            });
        }
        if all.len() == 3 {
            let total = |table: &BTreeMap<String, Vec<f64>>, n: usize| -> f64 {
                ["kinetic", "strain", "potential"].iter().filter_map(|name| table.get(*name)?.get(n)).sum()
            };
            let off: Vec<f64> =
                (0..own.values().map(Vec::len).min().unwrap_or(0)).map(|n| total(&own, n) - total(&right, n)).collect();
            all.push(EnergyResult {
                name: "total".into(),
                off: off.iter().fold(0.0, |a: f64, b| a.max(b.abs())),
                at_the_end: off.last().copied().unwrap_or(0.0),
                scale,
                factor: None,
            });
        }
        all
    }

    /// Velocities and energies that are wrong although positions agree.
    pub fn wrong_besides(&self, energies: &[EnergyResult]) -> Vec<Named> {
        let (run, _) = self.last();
        let (right, expected) = (self.right(run), self.expected());
        let mut all = Vec::new();
        let fastest = right.velocity.values().flatten().fold(0.0, |a: f64, v| a.max(v[0].hypot(v[1])));
        if let Some(worst) = farthest(&run.sampled.frames.velocity, &right.velocity) {
            let own = expected.map_or(f64::INFINITY, |expected| 3.0 * expected.velocity);
            if worst.distance > ENERGY_OFF * fastest + own {
                all.push(Named {
                    what: format!(
                        "positions agree, velocities do not: {} is off by {:.1e} m/s",
                        worst.point, worst.distance
                    ),
                    look_at: "what is written as velocity, and at which time of the step".into(),
                    distance: 0.0,
                });
            }
        }
        for energy in energies.iter().filter(|energy| energy.name != "total") {
            let own = expected
                .map_or(f64::INFINITY, |expected| 3.0 * expected.energy.get(&energy.name).copied().unwrap_or(0.0));
            let of_model = self.model.energy.get(&energy.name).copied().unwrap_or(0.0);
            let uncertain = of_model + self.reference.energy_uncertainty;
            if energy.off > ENERGY_OFF * energy.scale + own + uncertain {
                let factor = energy.factor.map(|factor| format!(", best factor {factor:.3}")).unwrap_or_default();
                all.push(Named {
                    what: format!(
                        "positions agree, the {} energy does not: off by {:.1e} J{factor}",
                        energy.name, energy.off
                    ),
                    look_at: "how this energy is computed, and from which heat it counts".into(),
                    distance: 0.0,
                });
            }
        }
        all
    }
}
