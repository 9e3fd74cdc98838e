//! Chooses the time-stepping method of a scene.

use super::adaptive::Adaptive;
use super::arc_length::ArcLength;
use super::counts::Counts;
use super::energy_momentum::EnergyMomentum;
use super::explicit::Explicit;
use super::gauss::Gauss;
use super::generalized_alpha::GeneralizedAlpha;
use super::integrator::Integrator;
use super::newton::Newton;
use super::nystrom::Nystrom;
use super::state::State;
use super::statics::Statics;
use crate::error::Result;
use crate::model::plan::Plan;
use crate::model::{LoadPath, Method, Scene};
use crate::structure::Structure;

/// Time-stepping method of a scene, ready at `state`.
///
/// # Errors
/// [`Error::StepTooLarge`](crate::error::Error::StepTooLarge) for an explicit step above its limit;
/// [`Error::Singular`](crate::error::Error::Singular) for a singular mass matrix.
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
        Method::Static => match scene.time.path {
            LoadPath::Load => Box::new(Statics::new(structure, newton)),
            LoadPath::ArcLength => Box::new(ArcLength::new(structure, newton, 1.0 / scene.time.load_steps as f64)),
        },
    })
}
