//! Runs a model: step by step with a [`Simulation`], or from start to end with [`run()`].

mod accuracy;
mod axis;
mod buckling;
mod column_errors;
mod energy;
mod equilibria;
mod equilibrium_scene;
mod estimate;
mod growth;
mod load_scale;
mod modes;
mod monitor;
mod observer;
mod perturbed;
mod recorder;
mod result;
mod ringing;
mod rotation;
mod simulation;
mod trajectory;
mod unresolved_loads;
mod warnings;
mod window_mean;

pub use accuracy::{Accuracy, ColumnAccuracy, Convergence, Estimate};
pub use axis::AxisPoint;
pub use buckling::{Buckling, buckling};
pub use equilibrium_scene::About;
pub use estimate::run_estimated;
pub use modes::{Kind, Mode, Modes, modes};
pub use result::Run;
pub use simulation::{Energies, Simulation, run, run_with_progress};
pub use trajectory::{Rows, Trajectory};

/// Items for the project's own crates only.
pub(crate) mod inside {
    pub use crate::run::simulation::{run_planned, run_watched};
}
