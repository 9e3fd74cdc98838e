//! Time integration of M q̈ + Q_e(q, ΔT) = Q_w, one method a file.

mod adaptive;
pub mod counts;
mod energy_momentum;
mod explicit;
mod gauss;
mod generalized_alpha;
pub mod newton;
mod nystrom;
pub mod statics;
mod work;

use nalgebra::DVector;

use crate::elements::ThermalStrain;
use crate::error::{Error, Result};
use crate::integrators::counts::Counts;
use crate::integrators::newton::Newton;
use crate::integrators::statics::Statics;
use crate::linear::SingularAt;
use crate::model::plan::Plan;
use crate::model::{Method, Scene};
use crate::structure::{MassFactors, Structure};

pub(crate) use adaptive::same_time;
pub use adaptive::{Adaptive, Embedded};
pub use energy_momentum::EnergyMomentum;
pub use explicit::Explicit;
pub use gauss::Gauss;
pub use generalized_alpha::GeneralizedAlpha;
pub use nystrom::Nystrom;

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

impl State {
    /// A structure's state at t = 0.
    pub fn at_start(structure: &Structure) -> State {
        State { step: 0, t: 0.0, u: structure.start().clone(), v: structure.start_velocity().clone() }
    }

    /// One step more, to time `t`.
    pub(crate) fn advance(&mut self, t: f64) {
        (self.step, self.t) = (self.step + 1, t);
    }

    /// Takes over another state of the same structure.
    pub fn copy_from(&mut self, other: &State) {
        (self.step, self.t) = (other.step, other.t);
        self.u.copy_from(&other.u);
        self.v.copy_from(&other.v);
    }
}

/// A one-step method.
pub trait Integrator {
    /// Moves the state on by one step: to time `t_1`, or less far with steps of its own choice.
    ///
    /// # Errors
    /// Where the step cannot be made or trusted; the state is then meaningless.
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()>;

    /// The multipliers λ that belong to the state, in their places; `None` for methods without.
    fn multipliers(&self) -> Option<&DVector<f64>> {
        None
    }

    /// Work of forces and heat over the last step, J; `None` for methods of order two, for which the ends of the step say enough.
    fn work(&mut self, structure: &Structure, before: &State, after: &State) -> Option<f64> {
        let _ = (structure, before, after);
        None
    }
}

/// The method that a scene asks for, ready at the state `state`.
///
/// # Errors
/// [`Error::StepTooLarge`] for an explicit step over its limit; [`Error::Singular`] for a mass matrix that is.
pub fn integrator(
    scene: &Scene,
    plan: &Plan,
    structure: &Structure,
    state: &State,
    counts: &mut Counts,
) -> Result<Box<dyn Integrator>> {
    let (step, tolerance) = (scene.time.step, scene.time.newton_tolerance);
    let newton = if plan.new_matrices { Newton::with_new_matrices(tolerance) } else { Newton::new(tolerance) };
    Ok(match scene.time.method {
        Method::GeneralizedAlpha => {
            Box::new(GeneralizedAlpha::new(structure, state, step, scene.time.rho_inf, newton, counts)?)
        }
        Method::EnergyMomentum => Box::new(EnergyMomentum::new(structure, step, newton)),
        Method::Explicit => Box::new(Explicit::new(structure, state, step, counts)?),
        Method::Gauss => Box::new(Gauss::new(structure, step, newton)),
        Method::Nystrom => Box::new(Nystrom::new(structure, state, step, counts)?),
        Method::GaussAdaptive => {
            let method = Gauss::new(structure, step, newton);
            Box::new(Adaptive::new(method, structure, state, scene.time.tolerance, step))
        }
        Method::NystromAdaptive => {
            let method = Nystrom::unchecked(structure, state, step, counts)?;
            Box::new(Adaptive::new(method, structure, state, scene.time.tolerance, step))
        }
        Method::Static => Box::new(Statics::new(structure, newton)),
    })
}

/// Factors of the mass matrix, with the constraints beside and below it where there are multipliers.
///
/// # Errors
/// [`Error::Singular`].
pub fn mass_factors(structure: &Structure, counts: &mut Counts) -> Result<MassFactors> {
    counts.factorizations += 1;
    structure.factorize_mass().map_err(|at| singular_mass(structure, at))
}

fn singular_mass(structure: &Structure, SingularAt(unknown): SingularAt) -> Error {
    Error::Singular { time: 0.0, iteration: 0, place: structure.place(unknown) }
}

/// Accelerations, and multipliers λ in their places, from the equation of motion:
/// M q̈ + Φ_qᵀ λ = Q_w − Q_e with Φ_q q̈ = 0, the second derivative of Φ(q) = 0 for constraints that are linear in q.
pub fn acceleration(
    structure: &Structure,
    mass: &mut MassFactors,
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

/// The equation of motion, ready to be asked for one acceleration after the other.
#[derive(Debug)]
pub struct Motion {
    mass: MassFactors,
    /// The last acceleration; multipliers, if there are any, in their places.
    pub a: DVector<f64>,
    force: DVector<f64>,
    thermal: Vec<ThermalStrain>,
}

impl Motion {
    /// The equation with the factors of its mass matrix.
    ///
    /// # Errors
    /// [`Error::Singular`].
    pub fn new(structure: &Structure, counts: &mut Counts) -> Result<Motion> {
        let zeros = || DVector::zeros(structure.size());
        let thermal = structure.thermal_strains(0.0);
        Ok(Motion { mass: mass_factors(structure, counts)?, a: zeros(), force: zeros(), thermal })
    }

    /// The acceleration at a displacement and a time into `a`.
    pub fn accelerate(&mut self, structure: &Structure, u: &DVector<f64>, t: f64, counts: &mut Counts) {
        structure.thermal_strains_into(t, &mut self.thermal);
        structure.force(u, &self.thermal, &mut self.force);
        structure.load_into(t, &mut self.a);
        self.a -= &self.force;
        self.mass.solve(&mut self.a);
        counts.force_calls += 1;
        counts.solves += 1;
    }
}

/// Refuses an explicit step over the stability limit `limit`/ω of the largest frequency ω.
fn check_step(structure: &Structure, method: Method, step: f64, limit: f64) -> Result<()> {
    let frequency = structure.largest_frequency().map_err(|at| singular_mass(structure, at))?;
    let largest = limit / frequency;
    // A limit that is not a number is refused too.
    if step > largest || largest.is_nan() {
        return Err(Error::StepTooLarge { method: method.to_string(), step, largest, frequency, limit });
    }
    Ok(())
}
