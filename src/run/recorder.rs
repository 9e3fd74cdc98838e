//! What is recorded of a run: the rows of its trajectory.

use nalgebra::DVector;

use super::Trajectory;
use super::energy::Energy;
use crate::error::{Error, Result};
use crate::integrators::counts::Counts;
use crate::integrators::{Motion, State};
use crate::model::plan::Plan;
use crate::model::{Probe, Quantity, Scene};
use crate::structure::{Instant as Now, Structure};

/// Writes rows.
pub struct Recorder<'a> {
    scene: &'a Scene,
    structure: &'a Structure,
    /// Memory for all rows, and how many are written.
    rows: Vec<Vec<f64>>,
    written: usize,
    /// There if a probe asks for an acceleration, or for a reaction that follows from it.
    motion: Option<Motion>,
    /// Accelerations and multipliers of the equation of motion; zero where nothing asks for them.
    a: DVector<f64>,
    multipliers: DVector<f64>,
    /// There if the scene asks for energies.
    energy: Option<Energy>,
}

impl<'a> Recorder<'a> {
    pub fn new(
        scene: &'a Scene,
        plan: &Plan,
        structure: &'a Structure,
        state: &State,
        counts: &mut Counts,
    ) -> Result<Recorder<'a>> {
        let columns = scene.columns().len();
        let rows = (0..=scene.steps()).filter(|step| scene.is_row(*step));
        let zeros = || DVector::zeros(structure.size());
        Ok(Recorder {
            scene,
            structure,
            rows: rows.map(|_| Vec::with_capacity(columns)).collect(),
            written: 0,
            motion: plan.acceleration.then(|| Motion::new(structure, counts)).transpose()?,
            a: zeros(),
            multipliers: zeros(),
            energy: plan.energy.then(|| Energy::new(scene, structure, state)),
        })
    }

    /// Whether forces or heat put energy in that has to be known.
    pub fn works(&self) -> bool {
        self.energy.as_ref().is_some_and(|energy| energy.works)
    }

    /// Adds work that the method knows.
    pub fn put_in(&mut self, work: f64) {
        if let Some(energy) = &mut self.energy {
            energy.put_in(work);
        }
    }

    pub fn work(&mut self, before: &State, after: &State) {
        if let Some(energy) = &mut self.energy {
            energy.work(self.structure, before, after);
        }
    }

    pub fn record(&mut self, state: &State, multipliers: Option<&DVector<f64>>, counts: &mut Counts) -> Result<()> {
        let structure = self.structure;
        if let Some(motion) = &mut self.motion {
            motion.accelerate(structure, &state.u, state.t, counts);
            self.a.copy_from(&motion.a);
            structure.take_multipliers_into(&mut self.a, &mut self.multipliers);
        }
        let now = Now { u: &state.u, a: &self.a, t: state.t, multipliers: multipliers.unwrap_or(&self.multipliers) };
        let Some(row) = self.rows.get_mut(self.written) else { return Ok(()) };
        row.push(state.t);
        for (probe, quantity) in self.scene.probes.iter().flat_map(|probe| probe.of.iter().map(move |of| (probe, of))) {
            match look(structure, probe, *quantity, state, now) {
                Value::Vector(vector) => row.extend(vector),
                Value::Number(number) => row.push(number),
            }
        }
        let energies = self.energy.as_mut().map(|energy| energy.row(structure, state));
        if self.scene.has_energies() {
            row.extend(energies.iter().flatten());
        }
        if !row.iter().all(|value| value.is_finite()) {
            return Err(Error::NotFinite { quantity: "the output", time: state.t, step: state.step });
        }
        if let (Some(energy), Some(energies)) = (&mut self.energy, energies) {
            energy.check(energies, structure, state, self.scene.time.method)?;
        }
        self.written += 1;
        Ok(())
    }

    /// Energies that do not balance.
    pub fn doubt(&self) -> Option<String> {
        self.energy.as_ref()?.warning(self.structure, self.scene.time.method)
    }

    pub fn trajectory(mut self) -> Trajectory {
        self.rows.truncate(self.written);
        Trajectory { columns: self.scene.columns(), rows: self.rows }
    }
}

/// What a probe reads.
enum Value {
    Vector([f64; 2]),
    Number(f64),
}

/// Reads one quantity of a probe; the scene was validated, so that what the quantity needs is there.
fn look(structure: &Structure, probe: &Probe, quantity: Quantity, state: &State, now: Now) -> Value {
    let point = probe.point.as_deref().unwrap_or_default();
    let rod = probe.rod.as_deref();
    Value::Vector(match quantity {
        Quantity::Position => structure.position(point, &state.u),
        Quantity::Velocity => structure.at_point(point, &state.v),
        Quantity::Acceleration => structure.at_point(point, now.a),
        Quantity::Reaction => match rod {
            Some(rod) => structure.force_on_rod(point, rod, now),
            None => structure.reaction(point, now),
        },
        Quantity::Deflection => {
            let place = probe.at.unwrap_or_default();
            return Value::Number(structure.deflection(rod.unwrap_or_default(), place, &state.u));
        }
    })
}
