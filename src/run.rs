//! One scene from start to end.

mod doubts;
mod energy;
mod loads;

use std::time::Instant;

use nalgebra::DVector;

use doubts::Watch;
use energy::Energy;
pub(crate) use loads::moves;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::estimate::Accuracy;
use crate::integrators::{self, Motion, State};
use crate::plan::Plan;
use crate::scene::{Element, Form, Method, Poisson, Probe, Quantity, Rod, Scene, Start};
use crate::structure::{Instant as Now, Structure};

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
    /// Statics: in how many independent directions the equilibrium at the end is unstable; 0 in motion, and where that is not told.
    pub unstable_directions: usize,
    /// Estimated errors; those of [`run_estimated`](crate::estimate::run_estimated) only.
    pub accuracy: Accuracy,
}

/// Runs a scene.
///
/// # Errors
/// [`Error::Scene`] for a scene that is not valid; those of its method: see [`integrators`]; [`Error::NotFinite`] for a row that is
/// no longer made of numbers.
pub fn run(scene: &Scene) -> Result<Run> {
    run_with_progress(scene, |_| ())
}

/// Runs a scene and tells `on_step`, after each of the times that the scene asks for, how many of [`Scene::steps`] are done.
///
/// # Errors
/// Those of [`run`].
pub fn run_with_progress(scene: &Scene, on_step: impl FnMut(usize)) -> Result<Run> {
    run_planned(scene, &Plan::of(scene), on_step)
}

/// The same with a plan that computes more than the scene needs.
///
/// # Errors
/// Those of [`run`].
pub fn run_planned(scene: &Scene, plan: &Plan, mut on_step: impl FnMut(usize)) -> Result<Run> {
    let clock = Instant::now();
    scene.validate("scene")?;
    let structure = Structure::planned(scene, plan)?;
    let mut counts = Counts::default();
    let mut state = State::at_start(&structure);
    let mut before = state.clone();
    let mut method = integrators::integrator(scene, plan, &structure, &state, &mut counts)?;
    let mut recorder = Recorder::new(scene, plan, &structure, &state, &mut counts)?;

    recorder.record(&state, method.multipliers(), &mut counts)?;
    let mut watch = Watch::new(scene, &structure);
    // Nothing in this loop asks for memory.
    for step in 1..=scene.steps() {
        let t = scene.time_after(step);
        while state.t < t {
            let works = recorder.works();
            if works {
                before.copy_from(&state);
            }
            method.step(&structure, &mut state, t, &mut counts)?;
            if works {
                match method.work(&structure, &before, &state) {
                    Some(work) => recorder.put_in(work),
                    None => recorder.work(&before, &state),
                }
            }
            if state.t < t || !scene.is_row(step) {
                watch.step(&structure, &state)?;
            }
        }
        if scene.is_row(step) {
            recorder.record(&state, method.multipliers(), &mut counts)?;
            watch.row(&structure, &state)?;
        }
        on_step(step);
    }
    let mut warnings = warnings(scene);
    let unstable_directions = watch.end(&structure, &state, &mut warnings)?;
    warnings.extend(recorder.doubt());
    let (trajectory, wall_seconds) = (recorder.trajectory(), clock.elapsed().as_secs_f64());
    Ok(Run { trajectory, counts, wall_seconds, warnings, unstable_directions, accuracy: Accuracy::default() })
}

/// Steps per crossing of an element by the axial wave below which a heat shock is badly resolved. Measured on the
/// suddenly heated pendulum (2D) with four elements against the oracle, 0–0.5 s, by both implicit methods: six steps leave
/// 1.1 to 1.5 mm, sixteen 0.2 to 0.3 mm, thirty-one 0.2 mm.
const STEPS_PER_CROSSING: f64 = 20.0;

/// Doubts that the scene itself raises.
fn warnings(scene: &Scene) -> Vec<String> {
    shock_warning(scene).into_iter().chain(locking_warning(scene)).chain(form_warning(scene)).collect()
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

/// The printed shear term makes a rod's stiffness depend on how it lies.
fn form_warning(scene: &Scene) -> Option<String> {
    (scene.form == Form::PrintedShear).then(|| {
        "\"form\": \"printed-shear\" counts the shear once, as printed: a rod at 45° gives in 1.33 times as much in bending and 1.50 \
         times along its axis; the results are for comparison"
            .into()
    })
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
    fn new(
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
    fn works(&self) -> bool {
        self.energy.as_ref().is_some_and(|energy| energy.works)
    }

    /// Adds work that the method knows.
    fn put_in(&mut self, work: f64) {
        if let Some(energy) = &mut self.energy {
            energy.put_in(work);
        }
    }

    fn work(&mut self, before: &State, after: &State) {
        if let Some(energy) = &mut self.energy {
            energy.work(self.structure, before, after);
        }
    }

    fn record(&mut self, state: &State, multipliers: Option<&DVector<f64>>, counts: &mut Counts) -> Result<()> {
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
    fn doubt(&self) -> Option<String> {
        self.energy.as_ref()?.warning(self.structure, self.scene.time.method)
    }

    fn trajectory(mut self) -> Trajectory {
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
