//! Loads of a structure over time: weight, point forces, heat.

use nalgebra::{DVector, Vector2};

use super::Structure;
use super::rod::Rod;
use crate::elements::ThermalStrain;
use crate::model::Force;

impl Structure {
    /// Generalized force of gravity, constant.
    pub fn gravity(&self) -> &DVector<f64> {
        &self.gravity
    }

    /// Adds `factor` · the generalized point forces at time `t`.
    pub fn add_point_forces(&self, t: f64, factor: f64, sum: &mut DVector<f64>) {
        for (force, place) in self.forces.iter().zip(&self.force_places) {
            place.add(&(factor * self.force_at(force, t)), sum);
        }
    }

    /// Point force at time `t`. In statics a force without history grows with the load factor `t`.
    pub(super) fn force_at(&self, force: &Force, t: f64) -> Vector2<f64> {
        let own = Vector2::from(force.at(t));
        if self.is_static && force.history.is_none() { t * own } else { own }
    }

    /// All external forces at time `t`, or at the load factor `t` in statics.
    pub fn load(&self, t: f64) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        self.load_into(t, &mut sum);
        sum
    }

    /// All external forces at time `t`, or at the load factor `t` in statics, into `sum`.
    pub fn load_into(&self, t: f64, sum: &mut DVector<f64>) {
        if self.plan.weight {
            sum.as_mut_slice().copy_from_slice(self.gravity.as_slice());
        } else {
            sum.as_mut_slice().fill(0.0);
        }
        if self.is_static {
            *sum *= t;
        }
        self.add_point_forces(t, 1.0, sum);
    }

    /// Thermal strain (along, across) of each rod at time `t`, or at the load factor `t` in statics.
    pub fn thermal_strains(&self, t: f64) -> Vec<ThermalStrain> {
        self.rods.iter().map(|rod| self.thermal_strain(rod, t)).collect()
    }

    /// Thermal strains of all rods at time `t`, into `thermal`, which [`thermal_strains`](Structure::thermal_strains)
    /// has made.
    pub fn thermal_strains_into(&self, t: f64, thermal: &mut [ThermalStrain]) {
        if !self.plan.heat {
            return;
        }
        for (rod, thermal) in self.rods.iter().zip(thermal) {
            *thermal = self.thermal_strain(rod, t);
        }
    }

    pub(super) fn thermal_strain(&self, rod: &Rod, t: f64) -> ThermalStrain {
        if !self.plan.heat {
            return [0.0; 2];
        }
        if self.heat_grows(rod) { rod.thermal_strain(0.0).map(|full| t * full) } else { rod.thermal_strain(t) }
    }

    /// Whether a rod's heat grows with the load factor: in statics a single pair is the full heat.
    pub(super) fn heat_grows(&self, rod: &Rod) -> bool {
        self.is_static && rod.heat.as_ref().is_some_and(|heat| heat.temperature.history.len() == 1)
    }
}
