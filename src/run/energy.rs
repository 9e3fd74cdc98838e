//! Energy balance of a run: initial energy, energy supplied since, and present energies.

use nalgebra::DVector;

use crate::elements::ThermalStrain;
use crate::error::{Error, Result};
use crate::integrators::State;
use crate::model::{Method, Scene};
use crate::structure::{StepEnds, Structure};

/// Imbalance that causes a warning, relative to the changes of the energies. In every built-in scene with every method
/// it is below a third of this, except where heat comes suddenly and the method damps the wave. Then positions are off
/// by a centimetre (4 elements) or by nothing (16).
const WARNED: f64 = 0.01;

/// Energy balance of a run, J.
pub struct Energy {
    /// Initial energy.
    initial: f64,
    /// Initial kinetic energy.
    initial_kinetic: f64,
    input: f64,
    /// Largest energy that forces, heat and falling weights have supplied so far.
    supply: f64,
    /// Whether forces or heat supply energy.
    pub has_work: bool,
    /// Least and greatest kinetic (from zero on), strain and potential energy of the rows.
    ranges: [[f64; 2]; 3],
    /// Largest imbalance of all rows.
    imbalance: f64,
    /// Buffers.
    thermal: [Vec<ThermalStrain>; 2],
    vector: DVector<f64>,
}

impl Energy {
    pub fn new(scene: &Scene, structure: &Structure, state: &State) -> Energy {
        let thermal = structure.thermal_strains(0.0);
        // Before a sudden start there is no strain energy; the heat that then appears supplies that of t = 0.
        let input = structure.strain_energy(&state.u, &thermal);
        let mut vector = DVector::zeros(structure.size());
        let kinetic = structure.kinetic_energy(&state.v, &mut vector);
        let start = kinetic - structure.gravity().dot(&state.u);
        let heats = scene.rods.iter().any(|rod| scene.heat(rod).is_some_and(|heat| heat.history.len() > 1));
        let has_work = !scene.forces.is_empty() || heats;
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let ranges = [[0.0, 0.0], nothing, nothing];
        let thermal = [thermal.clone(), thermal];
        Energy {
            initial: start,
            initial_kinetic: kinetic,
            input,
            supply: 0.0,
            has_work,
            ranges,
            imbalance: 0.0,
            thermal,
            vector,
        }
    }

    /// Adds work known from the method.
    pub fn add_work(&mut self, work: f64) {
        self.input += work;
    }

    /// Adds the work of forces and heat over a step from the states at its ends: second order, and exact for the
    /// energy–momentum rule.
    pub fn add_step_work(&mut self, structure: &Structure, before: &State, after: &State) {
        let [thermal_0, thermal_1] = &mut self.thermal;
        structure.thermal_strains_into(before.t, thermal_0);
        structure.thermal_strains_into(after.t, thermal_1);
        if thermal_0 != thermal_1 {
            let ends = StepEnds { u_0: &before.u, u_1: &after.u, thermal_0, thermal_1 };
            self.input += structure.heating_work(&ends);
        }
        let force = &mut self.vector;
        force.fill(0.0);
        structure.add_point_forces(before.t, 0.5, force);
        structure.add_point_forces(after.t, 0.5, force);
        self.input += force.dot(&after.u) - force.dot(&before.u);
    }

    /// Kinetic, strain and potential energy, input and balance of a row.
    pub fn row(&mut self, structure: &Structure, state: &State) -> [f64; 5] {
        let kinetic = structure.kinetic_energy(&state.v, &mut self.vector);
        let [thermal, _] = &mut self.thermal;
        structure.thermal_strains_into(state.t, thermal);
        let strain = structure.strain_energy(&state.u, thermal);
        let potential = 0.0 - structure.gravity().dot(&state.u);
        [kinetic, strain, potential, self.input, kinetic + strain + potential - self.initial - self.input]
    }

    /// Records a row, and refuses a state with twice the energy supplied. No method may create energy; a step far too
    /// long for a sudden load does.
    ///
    /// # Errors
    /// [`Error::EnergyAppeared`] with the excess and advice.
    pub fn check(&mut self, row: [f64; 5], structure: &Structure, state: &State, method: Method) -> Result<()> {
        let [kinetic, strain, potential, input, created] = row;
        for ([least, most], energy) in self.ranges.iter_mut().zip([kinetic, strain, potential]) {
            (*least, *most) = (least.min(energy), most.max(energy));
        }
        if created.abs() > self.imbalance.abs() {
            self.imbalance = created;
        }
        self.supply = self
            .supply
            .max(self.initial_kinetic + input.abs() + (potential - (self.initial - self.initial_kinetic)).abs());
        if created > self.supply + structure.energy_rounding() {
            let (time, step, supply) = (state.t, state.step, self.supply);
            let cause = cause(method);
            return Err(Error::EnergyAppeared { time, step, created, supply, cause, cure: cure(method) });
        }
        Ok(())
    }

    /// Warning about an imbalance above a hundredth of the energies' changes and above rounding.
    pub fn warning(&self, structure: &Structure, method: Method) -> Option<String> {
        let changes: f64 = self.ranges.iter().map(|[least, most]| most - least).sum();
        let missed = self.imbalance.abs();
        if missed <= WARNED * changes + structure.energy_rounding() {
            return None;
        }
        let share = 100.0 * missed / changes;
        let (moved, why) = match method {
            _ if self.imbalance > 0.0 => ("appeared", "its steps are too long for a sudden load".to_string()),
            Method::GeneralizedAlpha | Method::Nystrom | Method::NystromAdaptive => {
                ("was lost", format!("\"{method}\" damps vibrations that its steps do not resolve"))
            }
            _ => ("was lost", "its steps are too long".into()),
        };
        Some(format!(
            "energy {moved}: {missed:.1e} J, {share:.1} % of what the energies change by; {why}; a smaller step \
             or another method shows whether positions suffer"
        ))
    }
}

/// What makes energy appear.
fn cause(method: Method) -> String {
    match method {
        Method::NystromAdaptive => "its steps do not resolve the fastest vibrations, those of thin or stiff sections",
        _ if method.is_adaptive() => "the tolerance is far too large",
        _ => "the step is far too long for a load, or for a vibration of the rods",
    }
    .into()
}

/// Advice for steps that are too long for a load.
fn cure(method: Method) -> String {
    let shorter = if method.is_adaptive() { "time.tolerance" } else { "time.step" };
    let others = match method {
        Method::EnergyMomentum => ", or \"explicit\"",
        Method::NystromAdaptive => ", or \"gauss-adaptive\"",
        _ if method.is_explicit() => "",
        _ => ", or \"energy-momentum\" or \"explicit\"",
    };
    format!("a smaller `{shorter}` helps, or loads whose `history` grows from 0{others}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_method_is_told_to_use_itself() {
        for (method, part) in [
            (Method::GeneralizedAlpha, "`history` grows from 0, or \"energy-momentum\" or \"explicit\""),
            (Method::EnergyMomentum, "`history` grows from 0, or \"explicit\""),
            (Method::Explicit, "a smaller `time.step` helps, or loads whose `history` grows from 0"),
            (Method::NystromAdaptive, "loads whose `history` grows from 0, or \"gauss-adaptive\""),
        ] {
            assert!(cure(method).ends_with(part), "{}", cure(method));
        }
    }
}
