//! Error estimate of a run, in time and in space (Richardson, without assuming an order).
//!
//! The run is repeated with half the step and a tenth of Newton's tolerance, and with twice the elements. For adaptive
//! methods the longest step is halved and the tolerance divided by ten; in statics the load steps are doubled. The
//! change of the positions is most of the error where the error falls fast, and half of it where it only halves: the
//! estimate is twice the change.
//!
//! Compared are the positions of all points, and deflections of probes and of rods between supported points, whether a
//! probe asks for them or not; and at the rows every column: velocities, accelerations, reactions, energies. Where no
//! digit of a column is sure, one more run doubles the step or the elements' length, and shows whether the column
//! converges at all. Neither a conserved energy nor the sum of an adaptive method's local errors says as much.
//! The first knows nothing of positions, the second nothing of how errors grow or cancel.
//!
//! All of these runs may agree on a motion that is unstable. A run with a small deviation at the start has the verdict
//! on that (`perturbed`); of an equilibrium the eigenvalues of its tangent have it.
//!
//! **Instants.** Methods with fixed steps are compared after each step (in long runs after every few) and at the rows,
//! since a damped vibration is gone from both runs before a late row. The error is the largest over all these instants.
//! Adaptive methods are compared at the rows, statics at its load steps.
//!
//! What both runs miss does not show. Where a history comes and goes within a step (`unresolved_loads`), the step is
//! divided into as many finer ones as are needed to resolve it, sixteen at most; otherwise there is no estimate.
//!
//! **No reliable digit.** Each error is compared with the motion of its own point: from its start, or relative to the
//! rigid drift of its connected part, whichever is shorter. So neither a long journey nor the swing of another part
//! hides it. A point that moves by less than a millionth of the structure's size is compared with the one that moves
//! farthest.

use super::accuracy::{Accuracy, ColumnAccuracy, Convergence, Estimate};
use super::column_errors::{changes, column_errors, convergence, is_unsure};
use super::load_scale::has_loads;
use super::observer::{Observations, Observer, SAFETY};
use super::perturbed::{self, Errors};
use super::result::Run;
use super::simulation::Simulation;
use super::unresolved_loads::unresolved_load;
use crate::error::{Error, Result};
use crate::model::{Method, Model, Scene};

/// Newton tolerance below which rounding ends the iteration.
const LEAST_TOLERANCE: f64 = 1e-12;

/// Most halvings of an adaptive method's longest step until it makes more steps.
const HALVINGS: usize = 6;

/// Required ratio of steps, finer run to run: a tenth of the tolerance makes 1.8 times as many.
const STEP_RATIO: f64 = 1.5;

/// Most finer steps per step, for loads that come and go within it.
const MOST_PARTS: usize = 16;

/// Runs a model and estimates its errors; `on_step` gets the simulation after each step of the run itself.
///
/// ```
/// use ancf::model::{Method, Scene};
/// use ancf::run::run_estimated;
///
/// let scene = Scene::builtin("pendulum-flexible").unwrap().method(Method::EnergyMomentum, 1e-3).until(0.2);
/// let accuracy = run_estimated(&scene, |_| ())?.accuracy;
/// let (time, space) = (accuracy.time.unwrap(), accuracy.space.unwrap());
/// assert!(time.value < 1e-4 && space.value < 1e-2, "{} {}", time.value, space.value);
/// # Ok::<(), ancf::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`run`](super::run()); [`Error::Scene`] for an arc-length path; [`Error::NoEstimate`] where a finer run
/// fails, [`Error::Inaccurate`] where the sum of both errors exceeds a tenth of the motion, [`Error::Unstable`] for an
/// unstable equilibrium, and [`Error::UnstableMotion`] for an unstable motion.
pub fn run_estimated<M>(model: M, on_step: impl FnMut(&Simulation)) -> Result<Run>
where
    M: TryInto<Model>,
    Error: From<M::Error>,
{
    let model = model.try_into()?;
    Simulation::of(model)?.finish_estimated(on_step)
}

impl Simulation {
    /// [`finish_with_progress`](Simulation::finish_with_progress) with an estimate of the errors, from a simulation that has made no
    /// step yet. Where the estimate fails, the rows are still to be read.
    ///
    /// # Errors
    /// Those of [`run_estimated`].
    pub fn finish_estimated(&mut self, on_step: impl FnMut(&Simulation)) -> Result<Run> {
        let model = self.model().clone();
        let scene = model.scene();
        if scene.time.has_load_column() {
            let allowed = "\"load\" with an estimate: with \"arc-length\" the rows of runs with other steps or elements lie \
                           elsewhere on the path, and cannot be compared";
            let (file, key, value) = ("estimate".into(), "time.path".into(), format!("\"{}\"", scene.time.path));
            return Err(Error::Scene { file, key, value, allowed: allowed.into() });
        }
        let observer = Observer::of(scene);
        let (mut own, seen) = observer.run_with_progress(self, on_step)?;
        match accuracy(&observer, &model, &own, &seen) {
            Ok(accuracy) => own.accuracy = accuracy,
            Err(error) => {
                self.put_back(own.trajectory);
                return Err(error);
            }
        }
        Ok(own)
    }
}

/// Estimated errors of a run that was observed.
fn accuracy(observer: &Observer, model: &Model, own: &Run, seen: &Observations) -> Result<Accuracy> {
    let scene = observer.scene;
    let (finer, in_time, seen_in_time, how) = refine_in_time(observer, scene, own.counts.steps)?;
    let time = observer.changes(seen, &seen_in_time, |_| true);

    // Explicit steps must be shorter on a finer mesh, so that the comparison uses equally short ones.
    let explicit = scene.time.method.is_explicit();
    let (base, run_of_base, seen_of_base) =
        if explicit { (&finer, &in_time, &seen_in_time) } else { (scene, own, seen) };
    let mut mesh = base.clone();
    mesh.rods.iter_mut().for_each(|rod| rod.elements *= 2);
    let on_mesh = if explicit { format!("twice the elements at {how}") } else { "twice the elements".into() };
    let (on_finer, seen_on_finer) = stable_simulation(mesh)
        .and_then(|mut mesh| observer.run_with_progress(&mut mesh, |_| ()))
        .map_err(|error| no_estimate(&on_mesh, error))?;
    let space = observer.changes(seen_of_base, &seen_on_finer, |_| true);

    let directions = [own, &in_time, &on_finer].map(|run| run.unstable_directions).into_iter().max().unwrap_or(0);
    if directions > 0 {
        return Err(Error::Unstable { directions });
    }
    let time_changes = changes(&own.trajectory, &in_time.trajectory);
    let space_changes = changes(&run_of_base.trajectory, &on_finer.trajectory);
    let mut columns = column_errors(&own.trajectory, &time_changes, &space_changes);
    let mut amplification = None;
    if scene.time.method != Method::Static {
        let observed = time.iter().zip(&space).map(|(time, space)| time + space).collect();
        let errors = Errors { observed, columns: &columns };
        amplification = Some(perturbed::amplification(observer, model.clone(), own, seen, &errors)?);
    }
    observer.judge(seen, &time, &space)?;
    if !has_loads(scene) {
        // Without loads only rounding is left of most columns, which another run would not show.
        let unsure = columns.iter_mut().filter(|column| is_unsure(column, column.total()));
        unsure.for_each(|column| column.convergence = Convergence::Unsure);
    } else {
        // A run that fails shows nothing about convergence.
        if columns.iter().any(|column| is_unsure(column, column.time)) {
            let coarser = observer.run(&coarser_steps(scene)).ok();
            let first = coarser.map(|(run, _)| changes(&run.trajectory, &own.trajectory));
            let second = first.is_some().then_some(&*time_changes);
            judge_convergence(&mut columns, |column| column.time, first.as_deref().unwrap_or(&time_changes), second);
        }
        if columns.iter().any(|column| is_unsure(column, column.space)) {
            let coarser = coarser_mesh(base).and_then(|coarser| observer.run(&coarser).ok());
            let first = coarser.map(|(run, _)| changes(&run.trajectory, &run_of_base.trajectory));
            let second = first.is_some().then_some(&*space_changes);
            judge_convergence(&mut columns, |column| column.space, first.as_deref().unwrap_or(&space_changes), second);
        }
    }
    let worst = |errors: Vec<f64>| errors.into_iter().fold(0.0, f64::max);
    let pairs = [(seen, &seen_in_time), (seen_of_base, &seen_on_finer)];
    let at_rows = pairs.map(|(own, finer)| worst(observer.changes(own, finer, |is_row| is_row))).iter().sum();
    let [time, space] = [time, space].map(worst);
    let when = observer.schedule();
    let estimate = |value, method: &str| {
        let method = format!("{SAFETY} × the largest change of a position, {when}, by {method}");
        Some(Estimate { value, unit: "m", method })
    };
    let (time, space) = (estimate(time, &how), estimate(space, &on_mesh));
    Ok(Accuracy { time, space, at_rows: Some(at_rows), columns, amplification })
}

/// Marks the columns without a sure digit, because of one of their errors: whether they change by as much when halved
/// once more. Without a second change they may converge.
fn judge_convergence(
    columns: &mut [ColumnAccuracy],
    error: impl Fn(&ColumnAccuracy) -> f64,
    first: &[f64],
    second: Option<&[f64]>,
) {
    for (n, column) in columns.iter_mut().enumerate() {
        if is_unsure(column, error(column)) && column.convergence != Convergence::None {
            let found = second.map(|second| convergence(first[n], second[n]));
            column.convergence = found.unwrap_or(Convergence::Unsure);
        }
    }
}

/// Scene with twice the step, half the load steps, or ten times the tolerance. It may be none that runs.
fn coarser_steps(scene: &Scene) -> Scene {
    let mut coarser = scene.clone();
    // Their interval need not be a whole number of the longer steps.
    coarser.output.shapes = None;
    let time = &mut coarser.time;
    match time.method {
        Method::Static => time.load_steps /= 2,
        method if method.is_adaptive() => time.tolerance *= 10.0,
        _ => {
            time.step *= 2.0;
            coarser.output.interval = Some(coarser.output.interval.unwrap_or(0.0).max(time.step));
        }
    }
    coarser
}

/// Scene with half the elements of every rod; `None` where a number is odd.
fn coarser_mesh(scene: &Scene) -> Option<Scene> {
    let mut coarser = scene.clone();
    coarser.rods.iter_mut().for_each(|rod| rod.elements /= 2);
    let halved = scene.rods.iter().zip(&coarser.rods).all(|(rod, half)| rod.elements == 2 * half.elements);
    halved.then_some(coarser)
}

fn no_estimate(what: &str, error: Error) -> Error {
    Error::NoEstimate { what: what.into(), reason: error.to_string() }
}

/// Scene with finer steps than those of `scene`, which made `steps`; its run and observations, and the refinement in
/// words.
fn refine_in_time(observer: &Observer, scene: &Scene, steps: usize) -> Result<(Scene, Run, Observations, String)> {
    let mut finer = scene.clone();
    let how = match scene.time.method {
        Method::Static => {
            finer.time.load_steps *= 2;
            "twice the load steps".into()
        }
        method if method.is_adaptive() => {
            divide(&mut finer, 2);
            finer.time.tolerance /= 10.0;
            // Where the tolerance asks for less than the longest step, the step decides.
            "a tenth of the tolerance and half the longest step".into()
        }
        _ => {
            let parts = subdivisions(scene)?;
            divide(&mut finer, parts);
            if parts == 2 { "half the step".into() } else { format!("1/{parts} of the step") }
        }
    };
    let (mut run_of_it, mut seen, how) = with_finer_newton(observer, &mut finer, how)?;
    // Where rows and corners of histories are closer than half the longest step, all steps would be the same.
    for _ in 0..HALVINGS {
        if !scene.time.method.is_adaptive() || run_of_it.counts.steps as f64 >= STEP_RATIO * steps as f64 {
            break;
        }
        divide(&mut finer, 2);
        (run_of_it, seen) = observer.run(&finer).map_err(|error| no_estimate(&how, error))?;
    }
    Ok((finer, run_of_it, seen, how))
}

/// Runs the scene with a tenth of Newton's tolerance; with the tolerance itself where rounding prevents less.
fn with_finer_newton(observer: &Observer, finer: &mut Scene, how: String) -> Result<(Run, Observations, String)> {
    let tolerance = finer.time.newton_tolerance;
    // Steps of any length end their iteration alike.
    if !finer.time.method.is_explicit() && tolerance > LEAST_TOLERANCE {
        finer.time.newton_tolerance = (tolerance / 10.0).max(LEAST_TOLERANCE);
        let how = format!("{how}, a tenth of Newton's tolerance");
        match observer.run(finer) {
            Err(Error::NewtonFailed { at_rounding: true, .. }) => finer.time.newton_tolerance = tolerance,
            Err(error) => return Err(no_estimate(&how, error)),
            Ok((run, seen)) => return Ok((run, seen, how)),
        }
    }
    let (run, seen) = observer.run(finer).map_err(|error| no_estimate(&how, error))?;
    Ok((run, seen, how))
}

/// Number of parts into which a step must be divided until no history comes and goes within one.
fn subdivisions(scene: &Scene) -> Result<usize> {
    let step = scene.time.step;
    let sees_all = |parts: &usize| unresolved_load(scene, step / *parts as f64).is_none();
    (2..=MOST_PARTS).find(sees_all).ok_or_else(|| {
        let short = unresolved_load(scene, step / MOST_PARTS as f64).map_or(String::new(), |short| {
            format!(
                "{} rises and falls, or begins with the end, within less than that, in as little as {:.1e} s; a smaller `time.step` helps, or an \
                 adaptive method",
                short.what, short.length
            )
        });
        Error::NoEstimate { what: format!("1/{MOST_PARTS} of the step"), reason: short }
    })
}

/// Divides the step, keeping the output rows.
fn divide(scene: &mut Scene, parts: usize) {
    scene.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
    scene.time.step /= parts as f64;
}

/// Simulation of the scene, with its explicit step divided until it is stable.
fn stable_simulation(mut scene: Scene) -> Result<Simulation> {
    match Simulation::new(&scene) {
        Err(Error::StepTooLarge { step, largest, .. }) => {
            divide(&mut scene, (step / largest).ceil() as usize);
            Simulation::new(scene)
        }
        simulation => simulation,
    }
}
