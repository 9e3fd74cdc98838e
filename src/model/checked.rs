//! Checked scenes: valid by construction.

use super::builtin::{builtin_text, scene_text};
use super::checks::check;
use super::json::parse::read_scene;
use super::scene::Scene;
use crate::error::{Error, Result};

/// Checked [`Scene`] that cannot be changed: ready to be simulated.
///
/// Made by [`Scene::build`] from data, by [`Model::parse`] from JSON, and by [`Model::load`] from a file or a built-in
/// scene.
///
/// ```
/// use ancf::model::Model;
///
/// let model = Model::load("pendulum-flexible")?;
/// assert_eq!(model.scene().rods[0].name, "rod");
///
/// let mut scene = model.into_scene();
/// scene.time.step = 0.0;
/// let error = scene.build().unwrap_err().to_string();
/// assert!(error.starts_with("scene: `time.step` is 0.0; allowed: a finite number over 0"), "{error}");
/// # Ok::<(), ancf::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    scene: Scene,
}

impl Model {
    /// Reads the text of a scene file; `file` is its name in messages.
    ///
    /// ```
    /// use ancf::model::{Model, Scene};
    ///
    /// let text = Scene::builtin("pendulum-flexible").unwrap().to_text();
    /// assert!(Model::parse(&text, "pendulum.json").is_ok());
    ///
    /// let error = Model::parse(&text.replace("\"nu\"", "\"mu\""), "pendulum.json").unwrap_err();
    /// assert!(error.to_string().contains("`material.mu` is an unknown key"), "{error}");
    /// ```
    ///
    /// # Errors
    /// [`Error::Scene`] with place in the file, key, value as written, and what is allowed.
    pub fn parse(text: &str, file: &str) -> Result<Model> {
        Ok(Model { scene: read_scene(text, file)? })
    }

    /// Reads the built-in scene of this name, or else the file.
    ///
    /// ```
    /// use ancf::model::{Model, ThermalModel};
    ///
    /// let model = Model::load("scissors-5-thermal")?;
    /// assert_eq!(model.scene().rods.len(), 10);
    /// assert_eq!(model.scene().temperature.as_ref().unwrap().model, ThermalModel::TwoD);
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Read`] if the file cannot be read, with the nearest built-in name if it does not exist;
    /// [`Error::Scene`] for a value that is not allowed, or for too many scissors.
    pub fn load(name_or_path: &str) -> Result<Model> {
        // Some editors put a byte order mark before the text.
        Model::parse(scene_text(name_or_path)?.trim_start_matches('\u{feff}'), name_or_path)
    }

    /// Scene, to read.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Scene, to change; [`Scene::build`] checks it again.
    pub fn into_scene(self) -> Scene {
        self.scene
    }
}

impl TryFrom<Scene> for Model {
    type Error = Error;

    /// Checks the scene.
    fn try_from(scene: Scene) -> Result<Model> {
        match check(&scene) {
            Ok(()) => Ok(Model { scene }),
            Err(refusal) => Err(refusal.into_error("scene", None)),
        }
    }
}

impl TryFrom<&Scene> for Model {
    type Error = Error;

    /// Checks a copy of the scene.
    fn try_from(scene: &Scene) -> Result<Model> {
        scene.clone().build()
    }
}

impl Scene {
    /// Checks the scene.
    ///
    /// # Errors
    /// [`Error::Scene`] with key, value and what is allowed.
    pub fn build(self) -> Result<Model> {
        Model::try_from(self)
    }

    /// Built-in scene, to read or to change; `None` if there is none of this name.
    ///
    /// ```
    /// use ancf::model::Scene;
    ///
    /// assert_eq!(Scene::builtin("scissors-3").unwrap().rods.len(), 6);
    /// assert!(Scene::builtin("no-such-scene").is_none());
    /// ```
    pub fn builtin(name: &str) -> Option<Scene> {
        Some(Model::parse(&builtin_text(name).ok()?, name).ok()?.into_scene())
    }
}
