//! What is simulated: a [`Scene`] is plain data, a [`Model`] is a checked scene.
//!
//! A scene is JSON text in SI units (m, kg, s, N, K) with names chosen by the user, or it is made in code from
//! [`Scene::new`]. [`Scene::build`] checks it and returns a [`Model`]. The rest of the library relies on that check: it
//! divides by the step and looks up points by name. Unknown keys, duplicate keys and numbers that are not finite are
//! refused. The error names the key, the value and what is allowed.

mod builtin;
mod check;
mod checked;
mod checks;
mod choice;
mod heat;
mod history;
mod imperfection;
mod json;
mod loads;
mod method_settings;
mod motion;
mod nearest;
pub(crate) mod plan;
mod probes;
mod rod;
mod scene;
mod scissors;
mod shapes;
mod supports;
mod time;

pub(crate) use check::Refusal;
pub use checked::Model;
pub use choice::{
    Constraints, Direction, Element, Form, Law, LoadPath, Method, Poisson, Quantity, Schema, Start, ThermalModel,
};
pub use heat::Temperature;
pub(crate) use history::{interpolate, times_of};
pub use imperfection::Imperfection;
pub(crate) use json::parse::{read_json, refuse_in_file};
pub use loads::Force;
pub use motion::Motion;
pub(crate) use nearest::or_nearest;
pub use probes::Probe;
pub use rod::{Material, Rod, Section};
pub use scene::Scene;
pub use shapes::Shapes;
pub use supports::Support;
pub use time::{Output, Time};

/// Items for the project's own crates only.
pub(crate) mod inside {
    pub use crate::model::builtin::{builtin_names, builtin_text, scene_text};
    pub use crate::model::json::words::Words;
    pub use crate::model::nearest::nearest;
    pub use crate::model::plan::{Part, Plan};
    pub use crate::model::probes::ENERGY_COLUMNS;
    pub use crate::model::scissors::Scissors;
}
