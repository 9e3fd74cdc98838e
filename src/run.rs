//! One scene from start to end.

use std::time::Instant;

use nalgebra::DVector;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::integrators::{self, State};
use crate::linear::BorderedLu;
use crate::scene::{Element, Method, Poisson, Probe, Quantity, Rod, Scene, Start};
use crate::structure::{Instant as Now, StepEnds, Structure};

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
    run_with_progress(scene, |_| ())
}

/// Runs a scene and tells `on_step` the number of steps made after each of them.
///
/// # Errors
/// Those of [`run`].
pub fn run_with_progress(scene: &Scene, mut on_step: impl FnMut(usize)) -> Result<Run> {
    let clock = Instant::now();
    scene.validate("scene")?;
    let structure = Structure::new(scene)?;
    let mut counts = Counts::default();
    let u = structure.start().clone();
    let mut state = State { step: 0, t: 0.0, v: DVector::zeros(structure.size()), u };
    let mut method = integrators::integrator(scene, &structure, &state, &mut counts)?;
    let mut recorder = Recorder::new(scene, &structure, &state, &mut counts)?;

    recorder.record(&state, method.multipliers(), &mut counts)?;
    for step in 1..=scene.steps() {
        let t = scene.time_after(step);
        let before = recorder.works(state.t, t).then(|| state.clone());
        method.step(&structure, &mut state, t, &mut counts)?;
        (state.step, state.t) = (step, t);
        counts.steps += 1;
        if let Some(before) = before {
            recorder.work(&before, &state);
        }
        if scene.is_row(step) {
            recorder.record(&state, method.multipliers(), &mut counts)?;
        }
        on_step(step);
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
    shock_warning(scene).into_iter().chain(locking_warning(scene)).collect()
}

/// Rods of the paper's element with ν ≠ 0 are too stiff in bending, whatever the mesh.
fn locking_warning(scene: &Scene) -> Option<String> {
    let locks =
        |rod: &&Rod| rod.element == Element::Ancf && rod.poisson == Poisson::Full && scene.material(rod).nu != 0.0;
    let rod = scene.rods.iter().find(locks)?;
    let nu = scene.material(rod).nu;
    let share = 100.0 * (1.0 - 2.0 * nu) / (1.0 - nu).powi(2);
    Some(format!(
        "with nu = {nu} the paper's element locks: a slender rod bends {share:.1} % of what it should (rod `{}`); \
         \"poisson\": \"axis\" cures it",
        rod.name
    ))
}

/// Implicit steps that do not resolve the wave of a heat shock.
fn shock_warning(scene: &Scene) -> Option<String> {
    let crossing = Structure::wave_crossing_time(scene);
    let shock = scene.rods.iter().any(|rod| {
        scene.heat(rod).is_some_and(|heat| {
            let sudden = heat.start == Start::Sudden && heat.at(0.0) != 0.0;
            // Heat within the time that the wave takes along the rod is as good as sudden.
            let wave = Structure::wave_time(scene, rod);
            sudden || heat.history.windows(2).any(|pair| pair[1][1] != pair[0][1] && pair[1][0] - pair[0][0] < wave)
        })
    });
    let step = scene.time.step;
    // The explicit method's own stability limit is short enough.
    let implicit = matches!(scene.time.method, Method::GeneralizedAlpha | Method::EnergyMomentum);
    if shock && implicit && step * STEPS_PER_CROSSING > crossing {
        return Some(format!(
            "sudden heat starts an axial wave that crosses an element in {crossing:.1e} s, which the step of {step:e} s \
             does not resolve: positions may be off by millimetres and more, which no energy balance shows; \
             compare with a smaller step, or use \"explicit\""
        ));
    }
    None
}

/// Writes rows.
struct Recorder<'a> {
    scene: &'a Scene,
    structure: &'a Structure,
    trajectory: Trajectory,
    /// There if a probe asks for an acceleration, or for a reaction that follows from it.
    mass: Option<BorderedLu>,
    /// There if the scene asks for energies.
    energy: Option<Energy>,
}

/// The energy that was there at the start and what has been put in since, J.
struct Energy {
    start: f64,
    input: f64,
    /// The most that forces, heat and the fall of weights have put in so far.
    supply: f64,
}

impl Energy {
    fn new(structure: &Structure, state: &State) -> Energy {
        // Before a sudden start there is no strain energy; the heat that then appears puts in what is there at t = 0.
        let input = structure.strain_energy(&state.u, &structure.thermal_strains(0.0));
        Energy { start: 0.0 - structure.gravity().dot(&state.u), input, supply: 0.0 }
    }

    /// Refuses a state with twice the energy that was put in: no method may create any, and one whose step is far too long
    /// for a sudden load does.
    fn check(&mut self, row: [f64; 5], structure: &Structure, state: &State) -> Result<()> {
        let [_, _, potential, input, created] = row;
        self.supply = self.supply.max(input.abs() + (potential - self.start).abs());
        if created > self.supply + structure.energy_rounding() {
            let (time, step, supply) = (state.t, state.step, self.supply);
            return Err(Error::EnergyAppeared { time, step, created, supply });
        }
        Ok(())
    }

    /// Kinetic, strain and potential energy, input and balance.
    fn row(&self, structure: &Structure, state: &State) -> [f64; 5] {
        let kinetic = structure.kinetic_energy(&state.v);
        let strain = structure.strain_energy(&state.u, &structure.thermal_strains(state.t));
        let potential = 0.0 - structure.gravity().dot(&state.u);
        [kinetic, strain, potential, self.input, kinetic + strain + potential - self.start - self.input]
    }
}

impl<'a> Recorder<'a> {
    fn new(scene: &'a Scene, structure: &'a Structure, state: &State, counts: &mut Counts) -> Result<Recorder<'a>> {
        let moves = scene.time.method != Method::Static;
        let asked = |quantity| scene.probes.iter().any(|probe| probe.of.contains(&quantity));
        let accelerates = moves && (asked(Quantity::Acceleration) || asked(Quantity::Reaction));
        Ok(Recorder {
            scene,
            structure,
            trajectory: Trajectory { columns: scene.columns(), rows: Vec::new() },
            mass: accelerates.then(|| integrators::mass_factors(structure, counts)).transpose()?,
            energy: scene.has_energies().then(|| Energy::new(structure, state)),
        })
    }

    /// Whether forces or heat put energy in between two times.
    fn works(&self, t_0: f64, t_1: f64) -> bool {
        let heats = || self.structure.thermal_strains(t_0) != self.structure.thermal_strains(t_1);
        self.energy.is_some() && (!self.scene.forces.is_empty() || heats())
    }

    /// Adds the work of forces and of heating over a step.
    fn work(&mut self, before: &State, after: &State) {
        let structure = self.structure;
        let (thermal_0, thermal_1) = (structure.thermal_strains(before.t), structure.thermal_strains(after.t));
        let heating = if thermal_0 == thermal_1 {
            0.0
        } else {
            let ends = StepEnds { u_0: &before.u, u_1: &after.u, thermal_0: &thermal_0, thermal_1: &thermal_1 };
            structure.heating_work(&ends)
        };
        let force = structure.point_forces(before.t) + structure.point_forces(after.t);
        if let Some(energy) = &mut self.energy {
            energy.input += heating + 0.5 * force.dot(&(&after.u - &before.u));
        }
    }

    fn record(&mut self, state: &State, multipliers: Option<&DVector<f64>>, counts: &mut Counts) -> Result<()> {
        let structure = self.structure;
        let mut a = match &self.mass {
            Some(mass) => integrators::acceleration(structure, mass, &state.u, state.t, counts),
            None => DVector::zeros(structure.size()),
        };
        let of_motion = structure.take_multipliers(&mut a);
        let now = Now { u: &state.u, a: &a, t: state.t, multipliers: multipliers.unwrap_or(&of_motion) };
        let mut row = vec![state.t];
        for (probe, quantity) in self.scene.probes.iter().flat_map(|probe| probe.of.iter().map(move |of| (probe, of))) {
            match look(structure, probe, *quantity, state, now) {
                Value::Vector(vector) => row.extend(vector),
                Value::Number(number) => row.push(number),
            }
        }
        let energies = self.energy.as_ref().map(|energy| energy.row(structure, state));
        row.extend(energies.iter().flatten());
        if !row.iter().all(|value| value.is_finite()) {
            return Err(Error::NotFinite { quantity: "the output", time: state.t, step: state.step });
        }
        if let (Some(energy), Some(energies)) = (&mut self.energy, energies) {
            energy.check(energies, structure, state)?;
        }
        self.trajectory.rows.push(row);
        Ok(())
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
