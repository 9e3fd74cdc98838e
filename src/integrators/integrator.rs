//! Interface of time-stepping methods.

use nalgebra::DVector;

use super::counts::Counts;
use super::state::State;
use crate::error::{Error, Result, time_text};
use crate::structure::Structure;

/// One-step time integration method.
///
/// Implement it to move a [`Simulation`](crate::run::Simulation) by a method of your own. Symplectic Euler, for
/// example:
///
/// ```
/// use ancf::error::Result;
/// use ancf::integrators::{Counts, EquationOfMotion, Integrator, State, check_end};
/// use ancf::internals::structure::Structure;
/// use ancf::{model::Scene, run::Simulation};
///
/// struct SymplecticEuler(f64, EquationOfMotion);
///
/// impl Integrator for SymplecticEuler {
///     fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
///         let SymplecticEuler(dt, motion) = self;
///         check_end(state.t, *dt, t_1)?;
///         motion.accelerate(structure, &state.u, state.t, counts);
///         state.v.axpy(*dt, &motion.a, 1.0);
///         state.u.axpy(*dt, &state.v, 1.0);
///         state.advance(t_1);
///         counts.steps += 1;
///         Ok(())
///     }
/// }
///
/// let mut scene = Scene::builtin("pendulum-flexible").unwrap().until(0.02);
/// (scene.time.step, scene.output.interval) = (2e-5, None);
/// let mut pendulum = Simulation::with_integrator(scene.build()?, |structure, _, counts| {
///     Ok(Box::new(SymplecticEuler(2e-5, EquationOfMotion::new(structure, counts)?)))
/// })?;
/// pendulum.run_until(0.02)?;
/// assert_eq!(pendulum.counts().steps, 1000);
/// # Ok::<(), ancf::error::Error>(())
/// ```
pub trait Integrator {
    /// Advances the state by one step that ends at `t_1` (s, or the load factor in statics). An adaptive method may
    /// stop before.
    ///
    /// # Errors
    /// [`Error::NotATime`] where the method's step does not end at `t_1`; the state is unchanged. Other errors if the
    /// step cannot be made or trusted; the state is then meaningless.
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()>;

    /// Whether the run ends at this state, before its last step; `false` for methods that do not choose their end.
    fn is_at_end(&self, state: &State) -> bool {
        let _ = state;
        false
    }

    /// Multipliers λ of the state, in their entries; `None` for methods without them.
    fn multipliers(&self) -> Option<&DVector<f64>> {
        None
    }

    /// Work of forces and heat over the last step, J; `None` for second-order methods, for which the ends of the step
    /// suffice.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> Option<f64> {
        let _ = (structure, before, after);
        None
    }
}

/// Largest difference of equal times up to `t`: a few times their rounding error, too short for a step.
pub fn same_time(t: f64) -> f64 {
    4.0 * f64::EPSILON * t
}

/// Refuses a time other than the end of a step of length `dt` from `t`.
///
/// ```
/// use ancf::integrators::check_end;
///
/// assert!(check_end(0.2, 0.1, 0.3).is_ok());
/// let error = check_end(0.2, 0.1, 0.5).unwrap_err().to_string();
/// assert_eq!(error, "no step ends at t = 0.5 s; allowed: 0.3 s, the end of the next step of 0.1 s");
/// ```
///
/// # Errors
/// [`Error::NotATime`] with the end of the step.
pub fn check_end(t: f64, dt: f64, t_1: f64) -> Result<()> {
    let end = t + dt;
    if (t_1 - end).abs() <= same_time(end.abs()) {
        return Ok(());
    }
    let allowed = format!("{} s, the end of the next step of {} s", time_text(end), time_text(dt));
    Err(Error::NotATime { time: t_1, allowed, statics: false })
}
