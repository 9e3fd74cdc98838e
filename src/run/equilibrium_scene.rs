//! Scenes whose equilibria modes are about: a scene's loads at its end, as the loads of statics.

use crate::error::Result;
use crate::model::{Constraints, Force, LoadPath, Method, Model, Output, Scene, Temperature, ThermalModel, Time};

/// State about which a structure vibrates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// Cold and without loads, as it was built.
    Unloaded,
    /// Equilibrium under the scene's heat alone.
    Heated,
    /// Equilibrium under all of the scene's loads and heat.
    Loaded,
}

impl About {
    /// All states.
    pub const ALL: [About; 3] = [About::Unloaded, About::Heated, About::Loaded];

    /// Word of the command line and of files.
    pub fn word(self) -> &'static str {
        match self {
            About::Unloaded => "unloaded",
            About::Heated => "heated",
            About::Loaded => "loaded",
        }
    }

    /// State that a scene is about if nothing else is said: statics is about its loads, motion about its start.
    pub fn of(scene: &Scene) -> About {
        if scene.time.method == Method::Static { About::Loaded } else { About::Unloaded }
    }
}

/// Model of the state: statics under `factor` times the loads and heat that the scene has at its end. The unloaded one has none,
/// and may be a mechanism. Probes and motion are left out, and pins and supports condensed.
pub(super) fn equilibrium_scene(scene: &Scene, about: About, factor: f64) -> Result<Model> {
    let end = if scene.time.method == Method::Static { 1.0 } else { scene.time.end };
    let mut own = scene.clone();
    let frozen = |heat: &Option<Temperature>| {
        let heat = heat.as_ref().filter(|heat| heat.model != ThermalModel::None && !heat.history.is_empty())?;
        Some(Temperature::new(heat.model, vec![[0.0, factor * heat.at(end)]]))
    };
    let forces = scene.forces.iter().map(|force| Force::new(&force.point, force.at(end).map(|own| factor * own)));
    own.forces = if about == About::Loaded { forces.collect() } else { Vec::new() };
    own.gravity = if about == About::Loaded { scene.gravity.map(|own| factor * own) } else { [0.0; 2] };
    if about == About::Unloaded {
        own.temperature = None;
        own.rods.iter_mut().for_each(|rod| rod.temperature = None);
    } else {
        own.temperature = frozen(&scene.temperature);
        own.rods.iter_mut().zip(&scene.rods).for_each(|(own, rod)| own.temperature = frozen(&rod.temperature));
    }
    (own.motion, own.probes, own.output) = (None, Vec::new(), Output::default());
    own.constraints = Constraints::Condensed;
    own.time = Time::until(1.0);
    if about != About::Unloaded {
        own.time.method = Method::Static;
        if scene.time.method == Method::Static {
            (own.time.load_steps, own.time.newton_tolerance) = (scene.time.load_steps, scene.time.newton_tolerance);
            own.time.path = LoadPath::Load;
        }
    }
    own.build()
}
