//! Time integration of M q̈ + Q_e(q, ΔT) = Q_w, one method per file; and statics.

mod adaptive;
mod arc_length;
mod counts;
mod energy_momentum;
mod equation_of_motion;
mod equilibrium;
mod explicit;
mod gauss;
mod generalized_alpha;
mod increment;
mod integrator;
mod method;
mod newton;
mod nystrom;
mod state;
mod statics;
mod work;

pub use counts::Counts;
pub use equation_of_motion::EquationOfMotion;
pub(crate) use integrator::same_time;
pub use integrator::{Integrator, check_end};
pub(crate) use method::integrator;
pub use state::State;

/// Items for the project's own crates only.
pub(crate) mod inside {
    pub use crate::integrators::adaptive::{Adaptive, Embedded};
    pub use crate::integrators::energy_momentum::EnergyMomentum;
    pub use crate::integrators::explicit::Explicit;
    pub use crate::integrators::gauss::Gauss;
    pub use crate::integrators::generalized_alpha::GeneralizedAlpha;
    pub use crate::integrators::method::integrator;
    pub use crate::integrators::newton::{Equations, Failure, Newton, Residual};
    pub use crate::integrators::nystrom::Nystrom;
    pub use crate::integrators::statics::Statics;
}
