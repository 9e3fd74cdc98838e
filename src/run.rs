//! One scene from start to end.

use std::time::Instant;

use nalgebra::DVector;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::integrators::{self, State};
use crate::kernel::Ends;
use crate::linear::BandLu;
use crate::scene::{Method, Quantity, Scene, Start};
use crate::structure::Structure;

/// A table over time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// Names of the columns, the first of them `t`.
    pub columns: Vec<String>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<f64>>,
}

impl Trajectory {
    /// A column by its name.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let place = self.columns.iter().position(|column| column == name)?;
        Some(self.rows.iter().map(|row| row[place]).collect())
    }
}

/// What a run gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The rows that the scene asks for.
    pub trajectory: Trajectory,
    /// The work that was done.
    pub counts: Counts,
    /// Time that it took, s.
    pub wall_seconds: f64,
    /// What a person should know before trusting the result.
    pub warnings: Vec<String>,
}

/// Runs a scene.
///
/// # Errors
/// [`Error::Scene`] for a scene that is not valid; those of its method: see [`integrators`]; [`Error::NotFinite`] for a row that is
/// no longer made of numbers.
pub fn run(scene: &Scene) -> Result<Run> {
    let clock = Instant::now();
    scene.validate("scene")?;
    let structure = Structure::new(scene)?;
    let mut counts = Counts::default();
    let u = structure.start().clone();
    let mut state = State { step: 0, t: 0.0, v: DVector::zeros(structure.size()), u };
    let mut method = integrators::integrator(scene, &structure, &state, &mut counts)?;
    let mut recorder = Recorder::new(scene, &structure, &state, &mut counts)?;

    recorder.record(&state, &mut counts)?;
    for step in 1..=scene.steps() {
        // Not a sum of steps: its rounding would grow.
        let t = step as f64 * scene.time.step;
        let heats = recorder.energy.is_some() && structure.thermal_strain(state.t) != structure.thermal_strain(t);
        let before = heats.then(|| state.clone());
        method.step(&structure, &mut state, t, &mut counts)?;
        (state.step, state.t) = (step, t);
        counts.steps += 1;
        if let (Some(energy), Some(before)) = (&mut recorder.energy, before) {
            energy.heat(&structure, &before, &state);
        }
        if scene.is_row(step) {
            recorder.record(&state, &mut counts)?;
        }
    }
    Ok(Run {
        trajectory: recorder.trajectory,
        counts,
        wall_seconds: clock.elapsed().as_secs_f64(),
        warnings: warnings(scene),
    })
}

/// Steps per crossing of an element by the axial wave below which a heat shock is badly resolved. Measured on the
/// suddenly heated pendulum (2D) with four elements against the oracle, 0–0.5 s, by both implicit methods: six steps leave
/// 1.1 to 1.5 mm, sixteen 0.2 to 0.3 mm, thirty-one 0.2 mm.
const STEPS_PER_CROSSING: f64 = 20.0;

/// Doubts that the scene itself raises.
fn warnings(scene: &Scene) -> Vec<String> {
    let crossing = Structure::wave_crossing_time(scene);
    let wave = crossing * scene.rods.iter().map(|rod| rod.elements).max().unwrap_or(1) as f64;
    let shock = scene.heat().is_some_and(|heat| {
        let sudden = heat.start == Start::Sudden && heat.at(0.0) != 0.0;
        // Heat within the time that the wave takes along a rod is as good as sudden.
        sudden || heat.history.windows(2).any(|pair| pair[1][1] != pair[0][1] && pair[1][0] - pair[0][0] < wave)
    });
    let step = scene.time.step;
    // The explicit method's own stability limit is short enough.
    if shock && scene.time.method != Method::Explicit && step * STEPS_PER_CROSSING > crossing {
        return vec![format!(
            "sudden heat starts an axial wave that crosses an element in {crossing:.1e} s, which the step of {step:e} s \
             does not resolve: positions may be off by millimetres and more, which no energy balance shows; \
             compare with a smaller step, or use \"explicit\""
        )];
    }
    Vec::new()
}

/// Writes rows.
struct Recorder<'a> {
    scene: &'a Scene,
    structure: &'a Structure,
    trajectory: Trajectory,
    /// There if a probe asks for an acceleration.
    mass: Option<BandLu>,
    /// There if the scene asks for energies.
    energy: Option<Energy>,
}

/// The energy that was there at the start and what has been put in since, J.
struct Energy {
    start: f64,
    input: f64,
}

impl Energy {
    fn new(structure: &Structure, state: &State) -> Energy {
        let thermal = structure.thermal_strain(0.0);
        // Before a sudden start there is no strain energy; the heat that then appears puts in what is there at t = 0.
        let input = structure.strain_energy(&state.u, thermal);
        Energy { start: 0.0 - structure.gravity().dot(&state.u), input }
    }

    fn heat(&mut self, structure: &Structure, before: &State, after: &State) {
        let (thermal_0, thermal_1) = (structure.thermal_strain(before.t), structure.thermal_strain(after.t));
        self.input += structure.heating_work(&Ends { u_0: &before.u, u_1: &after.u, thermal_0, thermal_1 });
    }

    /// Kinetic, strain and potential energy, input and balance.
    fn row(&self, structure: &Structure, state: &State) -> [f64; 5] {
        let kinetic = structure.kinetic_energy(&state.v);
        let strain = structure.strain_energy(&state.u, structure.thermal_strain(state.t));
        let potential = 0.0 - structure.gravity().dot(&state.u);
        [kinetic, strain, potential, self.input, kinetic + strain + potential - self.start - self.input]
    }
}

impl<'a> Recorder<'a> {
    fn new(scene: &'a Scene, structure: &'a Structure, state: &State, counts: &mut Counts) -> Result<Recorder<'a>> {
        let accelerations = scene.probes.iter().any(|probe| probe.of.contains(&Quantity::Acceleration));
        Ok(Recorder {
            scene,
            structure,
            trajectory: Trajectory { columns: scene.columns(), rows: Vec::new() },
            mass: accelerations.then(|| integrators::mass_factors(structure, counts)).transpose()?,
            energy: scene.output.energy.then(|| Energy::new(structure, state)),
        })
    }

    fn record(&mut self, state: &State, counts: &mut Counts) -> Result<()> {
        let a = self.mass.as_ref().map(|m| integrators::acceleration(self.structure, m, &state.u, state.t, counts));
        let mut row = vec![state.t];
        for probe in &self.scene.probes {
            for quantity in &probe.of {
                row.extend(match (quantity, &a) {
                    (Quantity::Position, _) => self.structure.position(&probe.point, &state.u),
                    (Quantity::Velocity, _) => self.structure.at_point(&probe.point, &state.v),
                    (Quantity::Acceleration, Some(a)) => self.structure.at_point(&probe.point, a),
                    (Quantity::Acceleration, None) => continue,
                });
            }
        }
        if let Some(energy) = &self.energy {
            row.extend(energy.row(self.structure, state));
        }
        if !row.iter().all(|value| value.is_finite()) {
            return Err(Error::NotFinite { quantity: "the output", time: state.t, step: state.step });
        }
        self.trajectory.rows.push(row);
        Ok(())
    }
}
