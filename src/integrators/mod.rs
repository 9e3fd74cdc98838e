//! Time integration of M q̈ + Q_e(q, ΔT) = Q_w, one method a file.

mod energy_momentum;
mod explicit;
mod generalized_alpha;

use nalgebra::DVector;

use crate::counts::Counts;
use crate::error::{Error, Result};
use crate::linear::{BorderedLu, SingularAt};
use crate::scene::{Method, Scene};
use crate::statics::Statics;
use crate::structure::Structure;

pub use energy_momentum::EnergyMomentum;
pub use explicit::Explicit;
pub use generalized_alpha::GeneralizedAlpha;

/// Displacement and velocity of all unknowns at a time.
#[derive(Clone, Debug)]
pub struct State {
    /// Number of steps made.
    pub step: usize,
    /// Time, s.
    pub t: f64,
    /// Displacement from the initial configuration.
    pub u: DVector<f64>,
    /// Its rate.
    pub v: DVector<f64>,
}

/// A one-step method.
pub trait Integrator {
    /// Moves the state on by one step, to time `t_1`.
    ///
    /// # Errors
    /// Where the step cannot be made or trusted; the state is then meaningless.
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()>;

    /// The multipliers λ that belong to the state, in their places; `None` for methods without.
    fn multipliers(&self) -> Option<&DVector<f64>> {
        None
    }
}

/// The method that a scene asks for, ready at the state `state`.
///
/// # Errors
/// [`Error::StepTooLarge`] for an explicit step over its limit; [`Error::Singular`] for a mass matrix that is.
pub fn integrator(
    scene: &Scene,
    structure: &Structure,
    state: &State,
    counts: &mut Counts,
) -> Result<Box<dyn Integrator>> {
    let step = scene.time.step;
    Ok(match scene.time.method {
        Method::GeneralizedAlpha => Box::new(GeneralizedAlpha::new(
            structure,
            state,
            step,
            scene.time.rho_inf,
            scene.time.newton_tolerance,
            counts,
        )?),
        Method::EnergyMomentum => Box::new(EnergyMomentum::new(step, scene.time.newton_tolerance)),
        Method::Explicit => Box::new(Explicit::new(structure, state, step, counts)?),
        Method::Static => Box::new(Statics::new(structure, scene.time.newton_tolerance)),
    })
}

/// Factors of the mass matrix, with the constraints beside and below it where there are multipliers.
///
/// # Errors
/// [`Error::Singular`].
pub fn mass_factors(structure: &Structure, counts: &mut Counts) -> Result<BorderedLu> {
    counts.factorizations += 1;
    structure.mass_factors().map_err(|SingularAt(unknown)| Error::Singular {
        time: 0.0,
        iteration: 0,
        place: structure.place(unknown),
    })
}

/// Accelerations, and multipliers λ in their places, from the equation of motion:
/// M q̈ + Φ_qᵀ λ = Q_w − Q_e with Φ_q q̈ = 0, the second derivative of Φ(q) = 0 for constraints that are linear in q.
pub fn acceleration(
    structure: &Structure,
    mass: &BorderedLu,
    u: &DVector<f64>,
    t: f64,
    counts: &mut Counts,
) -> DVector<f64> {
    let mut force = DVector::zeros(structure.size());
    structure.force(u, &structure.thermal_strains(t), &mut force);
    let mut a = structure.load(t) - force;
    mass.solve(&mut a);
    counts.force_calls += 1;
    counts.solves += 1;
    a
}
