//! Step-by-step simulation of a model.

use nalgebra::DVector;

use super::accuracy::Accuracy;
use super::growth::GrowthWatch;
use super::monitor::Monitor;
use super::recorder::Recorder;
use super::result::Run;
use super::ringing;
use super::rotation::RotationWatch;
use super::trajectory::Trajectory;
use super::warnings::warnings;
use crate::error::{Error, Result, time_text};
use crate::integrators::{Counts, EquationOfMotion, Integrator, State, integrator};
use crate::linear::SingularAt;
use crate::model::plan::Plan;
use crate::model::{Method, Model, Scene};
use crate::structure::{Instant, Structure};

/// Times that differ by less than this part of a step are the same: a step that was written with ten digits, a sum of steps.
const SAME_TIME: f64 = 1e-6;

/// Simulation of a model: advanced step by step, and read in between.
///
/// ```
/// use ancf::model::{Material, Rod, Scene, Section, Support};
/// use ancf::run::Simulation;
///
/// let mut scene = Scene::new(Material::new(2e8, 0.0, 2766.67), Section::new(0.02, 0.02))
///     .point("pivot", [0.0, 0.0])
///     .point("tip", [1.0, 0.0])
///     .rod(Rod::new("rod", "pivot", "tip"))
///     .support(Support::pinned("pivot"))
///     .until(1.0);
/// scene.gravity = [0.0, -9.81];
/// let mut pendulum = Simulation::new(scene.build()?)?;
/// pendulum.run_until(0.5)?;
/// let [x, y] = pendulum.position("tip")?;
/// assert!(x < 0.2 && y < -0.9);
/// # Ok::<(), ancf::error::Error>(())
/// ```
pub struct Simulation {
    model: Model,
    structure: Structure,
    method: Box<dyn Integrator>,
    state: State,
    /// State before the last step.
    before: State,
    /// Number of steps done, of [`Scene::steps`].
    done: usize,
    /// Whether a step has failed, so that the state is meaningless.
    has_failed: bool,
    counts: Counts,
    recorder: Recorder,
    monitor: Monitor,
    /// Watch for rods that turn far in a step.
    rotation: RotationWatch,
    /// Watch for growing deviations; `None` in statics, which counts unstable directions.
    growth: Option<GrowthWatch>,
    /// Equation of motion for accelerations and reactions requested between rows.
    motion: Option<EquationOfMotion>,
}

/// Energies of a structure, J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energies {
    /// Kinetic energy ½ q̇ᵀ M q̇.
    pub kinetic: f64,
    /// Strain energy, (18).
    pub strain: f64,
    /// Potential energy of the weight, zero in the initial configuration.
    pub potential: f64,
}

impl Simulation {
    /// Starts a simulation with the method of the scene; a [`Scene`] is checked first. The first row is recorded.
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap())?;
    /// assert_eq!(pendulum.time(), 0.0);
    /// assert_eq!(pendulum.position("a")?, [1.0, 0.0]);
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Scene`] for an invalid scene, [`Error::TooLarge`] for matrices above the memory limit,
    /// [`Error::Drifts`] for statics of a mechanism, [`Error::StepTooLarge`] for an explicit step above its limit,
    /// [`Error::Singular`] for a singular mass matrix.
    pub fn new<M>(model: M) -> Result<Simulation>
    where
        M: TryInto<Model>,
        Error: From<M::Error>,
    {
        Simulation::of(model.try_into()?)
    }

    /// Starts a simulation of a checked model.
    pub(super) fn of(model: Model) -> Result<Simulation> {
        let plan = Plan::of(model.scene());
        Simulation::planned(model, &plan)
    }

    /// Starts a simulation with a given plan, which may compute more than the scene needs.
    ///
    /// # Errors
    /// Those of [`new`](Simulation::new).
    pub fn planned(model: Model, plan: &Plan) -> Result<Simulation> {
        Simulation::start(
            model,
            plan,
            |structure| Ok(State::at_start(structure)),
            |scene, structure, state, counts| integrator(scene, plan, structure, state, counts),
        )
    }

    /// Starts a simulation of a slightly displaced structure ([`Structure::perturbation`]).
    ///
    /// # Errors
    /// Those of [`new`](Simulation::new).
    pub(super) fn perturbed(model: Model, size: f64, period: f64) -> Result<Simulation> {
        let plan = Plan::of(model.scene());
        let displaced = |structure: &Structure| {
            let mut state = State::at_start(structure);
            let singular =
                |SingularAt(unknown)| Error::Singular { time: 0.0, iteration: 0, place: structure.location(unknown) };
            state.u += structure.perturbation(size, period).map_err(singular)?;
            Ok(state)
        };
        Simulation::start(model, &plan, displaced, |scene, structure, state, counts| {
            integrator(scene, &plan, structure, state, counts)
        })
    }

    /// Starts a simulation with an [`Integrator`] of your own. `make` gets the structure, its state at t = 0 and the counters. Steps
    /// are those of `time.step`; the scene's `method` only says whether it is statics. [`Integrator`] has an example.
    ///
    /// # Errors
    /// Those of [`new`](Simulation::new), and those of `make`; [`Error::Scene`] for a scene with an adaptive method.
    pub fn with_integrator(
        model: Model,
        make: impl FnOnce(&Structure, &State, &mut Counts) -> Result<Box<dyn Integrator>>,
    ) -> Result<Simulation> {
        let method = model.scene().time.method;
        if method.is_adaptive() {
            let allowed = "a method of fixed steps beside an integrator of your own".into();
            let (file, key, value) = ("scene".into(), "time.method".into(), format!("\"{method}\""));
            return Err(Error::Scene { file, key, value, allowed });
        }
        let plan = Plan::of(model.scene());
        let rest = |structure: &Structure| Ok(State::at_start(structure));
        Simulation::start(model, &plan, rest, |_, structure, state, counts| make(structure, state, counts))
    }

    fn start(
        model: Model,
        plan: &Plan,
        begin: impl FnOnce(&Structure) -> Result<State>,
        make: impl FnOnce(&Scene, &Structure, &State, &mut Counts) -> Result<Box<dyn Integrator>>,
    ) -> Result<Simulation> {
        let scene = model.scene();
        let structure = Structure::of(&model, plan)?;
        let mut counts = Counts::default();
        let state = begin(&structure)?;
        let method = make(scene, &structure, &state, &mut counts)?;
        let mut recorder = Recorder::new(scene, plan, &structure, &state, &mut counts)?;
        recorder.record(&structure, &state, method.multipliers(), &mut counts)?;
        let monitor = Monitor::new(scene, &structure);
        let growth = scene.moves().then(|| GrowthWatch::new(&structure, scene, &state));
        let rotation = RotationWatch::new(scene);
        let before = state.clone();
        Ok(Simulation {
            model,
            structure,
            method,
            state,
            before,
            done: 0,
            has_failed: false,
            counts,
            recorder,
            monitor,
            growth,
            rotation,
            motion: None,
        })
    }

    /// Advances by one step, and records a row if due. Adaptive methods advance to their next output time. Returns
    /// `false` at the end of the scene, where nothing moves any more.
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let scene = Scene::builtin("pendulum-flexible").unwrap().until(0.01);
    /// let mut pendulum = Simulation::new(scene)?;
    /// while pendulum.step()? {}
    /// assert_eq!((pendulum.steps_done(), pendulum.counts().steps), (40, 40));
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of the method; [`Error::Collapsed`], [`Error::LostInRounding`], [`Error::EnergyAppeared`] or
    /// [`Error::NotFinite`] for a state that cannot be trusted. Further steps are then refused with [`Error::HasFailed`].
    pub fn step(&mut self) -> Result<bool> {
        self.unless_failed(Simulation::next_step)
    }

    fn next_step(&mut self) -> Result<bool> {
        let scene = self.model.scene();
        if self.done == scene.steps() || self.method.is_at_end(&self.state) {
            return Ok(false);
        }
        let next = self.done + 1;
        let (t, is_row) = (scene.time_after(next), scene.is_row(next));
        self.advance(t, is_row)?;
        self.done = next;
        if is_row {
            self.rotation.row(&self.structure, &self.state);
            let recorded =
                self.recorder.record(&self.structure, &self.state, self.method.multipliers(), &mut self.counts);
            recorded.map_err(|error| self.rotation.explain(error))?;
            self.monitor.row(&self.structure, &self.state)?;
        }
        Ok(true)
    }

    /// Advances to the time `t`, s, or to the load factor `t` in statics.
    ///
    /// ```
    /// use ancf::{error::Error, model::Scene, run::Simulation};
    ///
    /// let mut pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap())?;
    /// pendulum.run_until(0.02)?;
    /// assert_eq!(pendulum.time(), 0.02);
    /// let past = pendulum.run_until(0.01);
    /// assert!(matches!(past, Err(Error::NotATime { .. })));
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotATime`] for a time in the past, after the end, or, with a fixed step, between the ends of steps; the
    /// state is unchanged. Others as for [`step`](Simulation::step).
    pub fn run_until(&mut self, t: f64) -> Result<()> {
        let scene = self.model.scene();
        let stride = scene.time_after(1);
        let (now, end, near) = (self.state.t, scene.time_after(scene.steps()), SAME_TIME * stride);
        // Rejects a NaN, too.
        if !(now - near <= t && t <= end + near) {
            return Err(self.not_a_time(t, [now, end], "to"));
        }
        let steps = t / stride;
        let is_end_of_step = (steps - steps.round()).abs() <= SAME_TIME;
        if !is_end_of_step && !scene.time.method.is_adaptive() {
            return Err(self.not_a_time(t, [steps.floor() * stride, steps.ceil() * stride], "or"));
        }
        let whole = if is_end_of_step { steps.round() } else { steps.floor() } as usize;
        while self.done < whole && self.step()? {}
        if self.done < whole {
            return Err(self.not_a_time(t, [now, self.state.t], "to"));
        }
        if !is_end_of_step && self.state.t < t {
            self.unless_failed(|own| own.advance(t, false))?;
        }
        Ok(())
    }

    fn not_a_time(&self, time: f64, [from, to]: [f64; 2], between: &str) -> Error {
        let statics = self.model.scene().time.method == Method::Static;
        let unit = if statics { "" } else { " s" };
        let allowed = format!("{} {between} {}{unit}", time_text(from), time_text(to));
        Error::NotATime { time, allowed, statics }
    }

    /// Does something that moves the state; never again once it has failed.
    fn unless_failed<T>(&mut self, advance: impl FnOnce(&mut Simulation) -> Result<T>) -> Result<T> {
        if self.has_failed {
            return Err(Error::HasFailed { time: self.state.t });
        }
        let result = advance(self);
        self.has_failed = result.is_err();
        result
    }

    /// Advances to the end of the scene and hands over its rows, counters and warnings. Where that fails, the rows until then
    /// are still to be read.
    ///
    /// ```
    /// use ancf::{model::{Method, Scene}, run::Simulation};
    ///
    /// let scene = Scene::builtin("pendulum-2d").unwrap().method(Method::EnergyMomentum, 0.01);
    /// let mut too_sudden = Simulation::new(scene)?;
    /// assert!(too_sudden.finish().is_err());
    /// assert!(too_sudden.rows().last().unwrap()[0] < 1.0);
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`step`](Simulation::step); [`Error::LostInRounding`] where rounding is most of a static displacement.
    pub fn finish(&mut self) -> Result<Run> {
        self.finish_with_progress(|_| ())
    }

    /// [`finish`](Simulation::finish) that shows itself to `on_step` after each step: for progress
    /// ([`steps_done`](Simulation::steps_done) of [`Scene::steps`]), or for readings of your own.
    ///
    /// # Errors
    /// Those of [`finish`](Simulation::finish).
    pub fn finish_with_progress(&mut self, mut on_step: impl FnMut(&Simulation)) -> Result<Run> {
        while self.step()? {
            on_step(self);
        }
        let scene = self.model.scene();
        let mut warnings = warnings(scene);
        warnings.extend((scene.time.has_load_column() && self.state.load < 1.0).then(|| short_path(&self.state)));
        let unstable_directions = self.monitor.end(&self.structure, &self.state, &mut warnings)?;
        warnings.extend(self.recorder.imbalance_warning(&self.structure));
        warnings.extend(self.rotation.warning());
        warnings.extend(self.growth.as_ref().and_then(GrowthWatch::warning));
        let (trajectory, counts) = (self.recorder.take_trajectory(), self.counts);
        warnings.extend(ringing::warning(self.model.scene(), &trajectory));
        Ok(Run { trajectory, counts, warnings, unstable_directions, accuracy: Accuracy::default() })
    }

    /// What there is of the run until now; of a run that failed the rows until then.
    pub fn into_run(mut self) -> Run {
        let trajectory = self.recorder.take_trajectory();
        let (counts, accuracy) = (self.counts, Accuracy::default());
        let mut warnings = warnings(self.model.scene());
        warnings.extend(self.rotation.warning());
        warnings.extend(self.growth.as_ref().and_then(GrowthWatch::warning));
        Run { trajectory, counts, warnings, unstable_directions: 0, accuracy }
    }

    /// Takes rows back that [`finish`](Simulation::finish) handed over.
    pub(super) fn put_back(&mut self, trajectory: Trajectory) {
        self.recorder.put_back(trajectory);
    }

    /// Makes steps of the method until the time `t`, and monitors each of them. This loop allocates no memory.
    fn advance(&mut self, t: f64, is_row: bool) -> Result<()> {
        let Simulation { structure, method, state, before, counts, recorder, monitor, growth, .. } = self;
        while state.t < t {
            let from = state.t;
            let has_work = recorder.has_work();
            if has_work {
                before.copy_from(state);
            }
            method.step(structure, state, t, counts).map_err(|error| monitor.explain(structure, state, error))?;
            if !(from < state.t && state.t <= t) {
                let allowed =
                    format!("an integrator that moves from {} s on, up to {} s", time_text(from), time_text(t));
                return Err(Error::NotATime { time: state.t, allowed, statics: false });
            }
            if has_work {
                match method.work(structure, before, state) {
                    Some(work) => recorder.add_work(work),
                    None => recorder.add_step_work(structure, before, state),
                }
            }
            // A row is checked when it is recorded.
            if state.t < t || !is_row {
                monitor.step(structure, state)?;
            }
            if let Some(growth) = growth {
                growth.step(structure, state);
            }
            recorder.add_to_means(structure, state, method.multipliers(), counts);
        }
        Ok(())
    }

    /// Present time, s; the load factor in statics.
    pub fn time(&self) -> f64 {
        self.state.t
    }

    /// Simulated model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Number of steps done, of [`Scene::steps`].
    pub fn steps_done(&self) -> usize {
        self.done
    }

    /// Counters of the work done so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// Present position [x, y] of a point, m.
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no point of this name.
    pub fn position(&self, point: &str) -> Result<[f64; 2]> {
        Ok(self.structure.position(self.structure.point(point)?, &self.state.u))
    }

    /// Present velocity [v_x, v_y] of a point, m/s.
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no point of this name.
    pub fn velocity(&self, point: &str) -> Result<[f64; 2]> {
        Ok(self.structure.at_point(self.structure.point(point)?, &self.state.v))
    }

    /// Present acceleration [a_x, a_y] of a point from the equation of motion, m/s²; zero in statics.
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no point of this name; [`Error::Singular`] for a singular mass matrix.
    pub fn acceleration(&mut self, point: &str) -> Result<[f64; 2]> {
        let point = self.structure.point(point)?;
        let (a, _) = self.accelerations()?;
        Ok(self.structure.at_point(point, &a))
    }

    /// Present force [F_x, F_y] of the supports on the structure at a point, N; zero where nothing holds the point.
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let mut cantilever = Simulation::new(Scene::builtin("cantilever").unwrap())?;
    /// cantilever.run_until(1.0)?;
    /// let load: f64 = cantilever.model().scene().forces.iter().map(|force| force.force[1]).sum();
    /// assert!((cantilever.reaction("o")?[1] + load).abs() < 1e-6 * load.abs());
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no point of this name; [`Error::Singular`] for a singular mass matrix.
    pub fn reaction(&mut self, point: &str) -> Result<[f64; 2]> {
        let point = self.structure.point(point)?;
        let (a, multipliers) = self.accelerations()?;
        let now = Instant { u: &self.state.u, a: &a, t: self.state.load, multipliers: &multipliers };
        Ok(self.structure.reaction(point, now))
    }

    /// Accelerations, and multipliers in their entries; zero in statics.
    fn accelerations(&mut self) -> Result<(DVector<f64>, DVector<f64>)> {
        let Simulation { model, structure, method, state, motion, .. } = self;
        // A reading is no work of the run.
        let counts = &mut Counts::default();
        let mut a = DVector::zeros(structure.size());
        let mut multipliers = a.clone();
        if model.scene().time.method != Method::Static {
            let motion = match motion {
                Some(motion) => motion,
                none => none.insert(EquationOfMotion::new(structure, counts)?),
            };
            motion.accelerate(structure, &state.u, state.t, counts);
            a.copy_from(&motion.a);
            structure.take_multipliers_into(&mut a, &mut multipliers);
        }
        if let Some(known) = method.multipliers() {
            multipliers.copy_from(known);
        }
        Ok((a, multipliers))
    }

    /// Present deflection of a rod, m: distance of its axis, at the fraction `at` of its length, from the chord through
    /// its ends; positive to the left of from → to.
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no rod of this name; [`Error::Scene`] for a fraction outside 0 … 1.
    pub fn deflection(&self, rod: &str, at: f64) -> Result<f64> {
        let at = checked_fraction("deflection", at)?;
        let deflection = self.structure.deflection(self.structure.rod(rod)?, at, &self.state.u);
        if !deflection.is_finite() {
            return Err(Error::NotFinite { quantity: "the deflection", time: self.state.t, step: self.state.step });
        }
        Ok(deflection)
    }

    /// Present nodal coordinates of a rod, vector by vector from its first point: r, r_y, then r_j, r_xj, r_yj, r_k,
    /// r_yk of each of the paper's elements, (4); or r, r_x, then r_k, r_xk of each Euler–Bernoulli element. Positions
    /// in m, slopes without unit.
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap())?;
    /// let e = pendulum.nodal_coordinates("rod")?;
    /// assert_eq!(e.len(), 2 + 5 * pendulum.model().scene().rods[0].elements);
    /// assert_eq!(e[..2], [[0.0, 0.0], [0.0, 1.0]]);
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no rod of this name.
    pub fn nodal_coordinates(&self, rod: &str) -> Result<Vec<[f64; 2]>> {
        Ok(self.structure.nodal_coordinates(self.structure.rod(rod)?, &self.state.u))
    }

    /// Present energies.
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let mut pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap())?;
    /// pendulum.run_until(0.05)?;
    /// let energy = pendulum.energy();
    /// assert!(energy.kinetic > 0.0 && energy.strain > 0.0 && energy.potential < 0.0);
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    pub fn energy(&self) -> Energies {
        let Simulation { structure, state, .. } = self;
        // In statics the weight grows with the load factor.
        let weight = if self.model.scene().time.method == Method::Static { state.load } else { 1.0 };
        Energies {
            kinetic: structure.kinetic_energy(&state.v, &mut DVector::zeros(structure.size())),
            strain: structure.strain_energy(&state.u, &structure.thermal_strains(state.load)),
            potential: 0.0 - weight * structure.gravity().dot(&state.u),
        }
    }

    /// Column names of [`rows`](Simulation::rows).
    pub fn columns(&self) -> &[String] {
        self.recorder.columns()
    }

    /// Rows recorded so far, each as long as [`columns`](Simulation::columns).
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let mut pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap().until(0.05))?;
    /// pendulum.run_until(0.05)?;
    /// let last = pendulum.rows().last().unwrap();
    /// assert_eq!((pendulum.columns()[0].as_str(), last[0]), ("t", 0.05));
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.recorder.rows().iter()
    }

    /// Structure, for [`Integrator`]s of your own.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// Present displacements and velocities of all unknowns.
    pub fn state(&self) -> &State {
        &self.state
    }
}

/// The fraction of a rod's length that a reading asks for.
///
/// # Errors
/// [`Error::Scene`] for a number outside 0 … 1.
pub(super) fn checked_fraction(reading: &str, at: f64) -> Result<f64> {
    if (0.0..=1.0).contains(&at) {
        return Ok(at);
    }
    let allowed = "a number from 0 to 1, both included: the place as a fraction of the rod's length".into();
    Err(Error::Scene { file: reading.into(), key: "at".into(), value: format!("{at:?}"), allowed })
}

/// Warning about an arc-length path that has used up its rows.
fn short_path(state: &State) -> String {
    let State { step, load, .. } = state;
    format!(
        "the path ends after {step} rows at {} of the load, before it reaches the whole; more `time.load_steps` allow \
         more rows, unless the path turns away from the whole load",
        time_text(*load)
    )
}

impl std::fmt::Debug for Simulation {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("Simulation").field("model", &self.model).field("time", &self.state.t).finish_non_exhaustive()
    }
}

/// Runs a model, or a scene that is checked first, from start to end.
///
/// ```
/// use ancf::model::{Method, Scene};
///
/// let mut scene = Scene::builtin("pendulum-flexible").unwrap();
/// (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 1e-3, 0.5);
/// let run = ancf::run::run(&scene)?;
/// let y = run.trajectory.column("tip.y").unwrap();
/// assert!((y.last().unwrap() + 0.99685).abs() < 1e-4);
/// # Ok::<(), ancf::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Scene`] for an invalid scene; those of [`Simulation::new`] and [`Simulation::finish`].
pub fn run<M>(model: M) -> Result<Run>
where
    M: TryInto<Model>,
    Error: From<M::Error>,
{
    Simulation::new(model)?.finish()
}

/// Runs a model; after each step `on_step` gets the simulation.
///
/// # Errors
/// Those of [`Simulation::new`] and [`Simulation::finish`].
pub fn run_with_progress<M>(model: M, on_step: impl FnMut(&Simulation)) -> Result<Run>
where
    M: TryInto<Model>,
    Error: From<M::Error>,
{
    Simulation::new(model)?.finish_with_progress(on_step)
}

/// Runs a scene with a given plan, which may compute more than the scene needs.
///
/// # Errors
/// Those of [`Simulation::planned`] and [`Simulation::finish`].
pub fn run_planned(scene: &Scene, plan: &Plan, on_step: impl FnMut(&Simulation)) -> Result<Run> {
    Simulation::planned(scene.try_into()?, plan)?.finish_with_progress(on_step)
}

/// Runs a simulation to its end; `see` is called at the start and after each step.
///
/// # Errors
/// Those of [`Simulation::finish`].
pub fn run_watched(
    simulation: &mut Simulation,
    mut on_step: impl FnMut(&Simulation),
    mut see: impl FnMut(&Simulation),
) -> Result<Run> {
    see(simulation);
    while simulation.step()? {
        see(simulation);
        on_step(simulation);
    }
    simulation.finish()
}
