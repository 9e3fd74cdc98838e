//! A scene that has been checked.

use super::builtin::{builtin_text, text_of};
use super::checks::check;
use super::json::parse::read_scene;
use super::scene::Scene;
use crate::error::{Error, Result};

/// A [`Scene`] that has been checked, and cannot be changed: what can be simulated.
///
/// Made by [`Scene::build`] from data, by [`Model::parse`] from JSON, by [`Model::load`] from a file or a built-in scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    scene: Scene,
}

impl Model {
    /// Reads the text of a scene file; `file` is the name used in messages.
    ///
    /// # Errors
    /// [`Error::Scene`] with the place in the file, the key, the value as it is written, and what is allowed.
    pub fn parse(text: &str, file: &str) -> Result<Model> {
        Ok(Model { scene: read_scene(text, file)? })
    }

    /// Reads a built-in scene if `name_or_path` is the name of one, else the file.
    ///
    /// # Errors
    /// [`Error::Read`] if the file cannot be read, with the nearest built-in name if there is no such file;
    /// [`Error::Scene`] if it holds something that is not allowed, or for too many scissors.
    pub fn load(name_or_path: &str) -> Result<Model> {
        // Some editors put a byte order mark before the text.
        Model::parse(text_of(name_or_path)?.trim_start_matches('\u{feff}'), name_or_path)
    }

    /// The scene, to read.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene, to change; [`Scene::build`] checks it again.
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
    /// [`Error::Scene`] with the key, the value and what is allowed.
    pub fn build(self) -> Result<Model> {
        Model::try_from(self)
    }

    /// A built-in scene; `None` if none has that name.
    pub fn builtin(name: &str) -> Option<Scene> {
        Some(Model::parse(&builtin_text(name).ok()?, name).ok()?.into_scene())
    }
}
