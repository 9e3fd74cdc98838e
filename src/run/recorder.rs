//! Records the rows of a trajectory.

use nalgebra::DVector;

use super::energy::Energy;
use super::trajectory::{Rows, Trajectory};
use super::window_mean::WindowMean;
use crate::error::{Error, Result};
use crate::integrators::{Counts, EquationOfMotion, State};
use crate::model::plan::Plan;
use crate::model::{Method, Probe, Quantity, Scene};
use crate::structure::{Instant, PointId, RodId, Structure};

/// Recorder of output rows.
pub struct Recorder {
    columns: Vec<String>,
    readings: Vec<Reading>,
    /// Whether a reading is a mean, for which each step counts.
    has_means: bool,
    /// Rows recorded, with memory for all of them.
    rows: Rows,
    /// Equation of motion, if a probe needs an acceleration or a reaction.
    motion: Option<EquationOfMotion>,
    /// Accelerations; below, multipliers of the equation of motion. Zero where no probe needs them.
    a: DVector<f64>,
    multipliers: DVector<f64>,
    /// Energy balance, if the plan has energies.
    energy: Option<Energy>,
    /// Whether energies are recorded.
    has_energies: bool,
    /// Whether the load factor is recorded.
    has_load: bool,
    method: Method,
}

impl Recorder {
    pub fn new(
        scene: &Scene,
        plan: &Plan,
        structure: &Structure,
        state: &State,
        counts: &mut Counts,
    ) -> Result<Recorder> {
        let columns = scene.columns();
        let count = (0..=scene.steps()).filter(|step| scene.is_row(*step)).count();
        let rows = Rows::with_memory(columns.len(), count).map_err(|_| Error::OutOfMemory {
            what: format!("the rows of the trajectory, {count} of {} columns,", columns.len()),
            gigabytes: 8e-9 * (count * columns.len()) as f64,
            allowed: "a longer `output.interval`, fewer probes, or a computer with more memory".into(),
        })?;
        let probed = scene.probes.iter().flat_map(|probe| probe.of.iter().map(move |quantity| (probe, *quantity)));
        let zeros = || DVector::zeros(structure.size());
        Ok(Recorder {
            readings: probed.map(|(probe, quantity)| Reading::of(structure, probe, quantity)).collect::<Result<_>>()?,
            has_means: scene.probes.iter().any(|probe| probe.mean.is_some()),
            rows,
            columns,
            motion: plan.acceleration.then(|| EquationOfMotion::new(structure, counts)).transpose()?,
            a: zeros(),
            multipliers: zeros(),
            energy: plan.energy.then(|| Energy::new(scene, structure, state)),
            has_energies: scene.has_energies(),
            has_load: scene.time.has_load_column(),
            method: scene.time.method,
        })
    }

    /// Whether the work of forces or heat is needed.
    pub fn has_work(&self) -> bool {
        self.energy.as_ref().is_some_and(|energy| energy.has_work)
    }

    /// Adds work known from the method.
    pub fn add_work(&mut self, work: f64) {
        if let Some(energy) = &mut self.energy {
            energy.add_work(work);
        }
    }

    pub fn add_step_work(&mut self, structure: &Structure, before: &State, after: &State) {
        if let Some(energy) = &mut self.energy {
            energy.add_step_work(structure, before, after);
        }
    }

    /// Adds the state after a step to the means.
    pub fn add_to_means(
        &mut self,
        structure: &Structure,
        state: &State,
        multipliers: Option<&DVector<f64>>,
        counts: &mut Counts,
    ) {
        if !self.has_means {
            return;
        }
        self.accelerate(structure, state, counts);
        let multipliers = multipliers.unwrap_or(&self.multipliers);
        let now = Now { state, instant: Instant { u: &state.u, a: &self.a, t: state.load, multipliers } };
        for Reading { place, mean, .. } in &mut self.readings {
            if let Some(mean) = mean {
                mean.add(state.t, place.read(structure, &now));
            }
        }
    }

    /// Computes accelerations and multipliers, if a probe needs them.
    fn accelerate(&mut self, structure: &Structure, state: &State, counts: &mut Counts) {
        if let Some(motion) = &mut self.motion {
            motion.accelerate(structure, &state.u, state.t, counts);
            self.a.copy_from(&motion.a);
            structure.take_multipliers_into(&mut self.a, &mut self.multipliers);
        }
    }

    /// Records a row.
    ///
    /// # Errors
    /// [`Error::NotFinite`], and those of the energies; there is no such row then.
    pub fn record(
        &mut self,
        structure: &Structure,
        state: &State,
        multipliers: Option<&DVector<f64>>,
        counts: &mut Counts,
    ) -> Result<()> {
        let before = self.rows.len();
        let recorded = self.record_row(structure, state, multipliers, counts);
        if recorded.is_err() {
            self.rows.truncate(before);
        }
        recorded
    }

    fn record_row(
        &mut self,
        structure: &Structure,
        state: &State,
        multipliers: Option<&DVector<f64>>,
        counts: &mut Counts,
    ) -> Result<()> {
        self.accelerate(structure, state, counts);
        let multipliers = multipliers.unwrap_or(&self.multipliers);
        let now = Now { state, instant: Instant { u: &state.u, a: &self.a, t: state.load, multipliers } };
        if self.rows.is_full() {
            return Ok(());
        }
        let (before, row) = (self.rows.len(), &mut self.rows);
        row.extend([state.t]);
        row.extend(self.has_load.then_some(state.load));
        for reading in &mut self.readings {
            let value = match &mut reading.mean {
                None => reading.place.read(structure, &now),
                Some(mean) => {
                    // At the start there was no step.
                    if before == 0 {
                        mean.add(state.t, reading.place.read(structure, &now));
                    }
                    mean.mean()
                }
            };
            row.extend(value.into_iter().take(reading.columns));
        }
        let energies = self.energy.as_mut().map(|energy| energy.row(structure, state));
        if self.has_energies {
            row.extend(energies.into_iter().flatten());
        }
        if !row.after(before).iter().all(|value| value.is_finite()) {
            return Err(Error::NotFinite { quantity: "the output", time: state.t, step: state.step });
        }
        if let (Some(energy), Some(energies)) = (&mut self.energy, energies) {
            energy.check(energies, structure, state, self.method)?;
        }
        Ok(())
    }

    /// Warning about energies that do not balance.
    pub fn imbalance_warning(&self, structure: &Structure) -> Option<String> {
        self.energy.as_ref()?.warning(structure, self.method)
    }

    /// Names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Rows recorded so far.
    pub fn rows(&self) -> &Rows {
        &self.rows
    }

    /// Hands over the rows recorded so far; none are left.
    pub fn take_trajectory(&mut self) -> Trajectory {
        Trajectory { columns: self.columns.clone(), rows: std::mem::take(&mut self.rows) }
    }

    /// Takes rows back.
    pub fn put_back(&mut self, trajectory: Trajectory) {
        self.rows = trajectory.rows;
    }
}

/// Quantity of a probe.
struct Reading {
    place: Place,
    /// Number of columns: 2 for a vector.
    columns: usize,
    /// Mean in place of instantaneous values.
    mean: Option<WindowMean>,
}

/// Where and what is read.
#[derive(Clone, Copy)]
enum Place {
    Position(PointId),
    Velocity(PointId),
    Acceleration(PointId),
    Reaction(PointId),
    ForceOnRod(PointId, RodId),
    /// Deflection of a rod at a fraction of its length.
    Deflection(RodId, f64),
}

/// State that is read, with its accelerations and multipliers.
struct Now<'a> {
    state: &'a State,
    instant: Instant<'a>,
}

impl Reading {
    fn of(structure: &Structure, probe: &Probe, quantity: Quantity) -> Result<Reading> {
        let point = || structure.point(probe.point.as_deref().unwrap_or_default());
        let place = match (quantity, &probe.rod) {
            (Quantity::Position, _) => Place::Position(point()?),
            (Quantity::Velocity, _) => Place::Velocity(point()?),
            (Quantity::Acceleration, _) => Place::Acceleration(point()?),
            (Quantity::Reaction, Some(rod)) => Place::ForceOnRod(point()?, structure.rod(rod)?),
            (Quantity::Reaction, None) => Place::Reaction(point()?),
            (Quantity::Deflection, rod) => {
                Place::Deflection(structure.rod(rod.as_deref().unwrap_or_default())?, probe.at.unwrap_or_default())
            }
        };
        Ok(Reading { place, columns: quantity.suffixes().len(), mean: probe.mean.map(WindowMean::new) })
    }
}

impl Place {
    /// Value now; the second component of a deflection is 0.
    fn read(self, structure: &Structure, now: &Now) -> [f64; 2] {
        let Now { state, instant } = now;
        match self {
            Place::Position(point) => structure.position(point, &state.u),
            Place::Velocity(point) => structure.at_point(point, &state.v),
            Place::Acceleration(point) => structure.at_point(point, instant.a),
            Place::Reaction(point) => structure.reaction(point, *instant),
            Place::ForceOnRod(point, rod) => structure.force_on_rod(point, rod, *instant),
            Place::Deflection(rod, at) => [structure.deflection(rod, at, &state.u), 0.0],
        }
    }
}
