//! Readings along the axis of a rod.

use nalgebra::{DVector, Vector2};

use super::Structure;
use super::probes::RodId;
use crate::elements::SectionState;

impl Structure {
    /// Position of a rod's axis at a fraction of its length, m, and the state of the section there.
    pub fn axis(&self, rod: RodId, fraction: f64, u: &DVector<f64>) -> (Vector2<f64>, SectionState) {
        let rod = &self.rods[rod.0];
        let place = fraction * rod.elements as f64;
        (rod.from + place * rod.along + rod.mesh.axis(place, u), rod.mesh.section_state(place, u))
    }

    /// Displacement of a rod's axis at a fraction of its length, m.
    pub fn axis_displacement(&self, rod: RodId, fraction: f64, u: &DVector<f64>) -> Vector2<f64> {
        let rod = &self.rods[rod.0];
        rod.mesh.axis(fraction * rod.elements as f64, u)
    }

    /// Temperature change ΔT of a rod at time `t` (load factor in statics), K, and the axial strain that it causes freely:
    /// αΔT, or none where heat strains the rod across only. Both are zero for a rod that no heat strains.
    pub fn heat(&self, rod: RodId, t: f64) -> [f64; 2] {
        let rod = &self.rods[rod.0];
        let Some(heat) = &rod.heat else { return [0.0; 2] };
        let temperature = if self.heat_grows(rod) { t * heat.temperature.at(0.0) } else { heat.temperature.at(t) };
        let [along, _] = heat.temperature.model.strains(heat.alpha * temperature);
        [temperature, along]
    }
}
