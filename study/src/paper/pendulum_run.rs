//! An explicit run of a built-in pendulum.

use super::tip::Tip;
use crate::error::Result;
use crate::scene::{Change, builtin};
use ancf::model::{Element, Method};
use ancf::run::run;

/// A built-in pendulum with its own mesh and step, explicit.
pub struct PendulumRun {
    pub scene: &'static str,
    pub element: Element,
    pub elements: usize,
    pub step: f64,
    pub end: f64,
    pub interval: f64,
}

impl PendulumRun {
    /// Runs it, and returns its tip.
    pub fn tip(&self) -> Result<Tip> {
        let scene = builtin(self.scene)?.meshed(self.element, self.elements);
        let mut scene = scene.solved(Method::Explicit, self.step, self.end).rows_every(self.interval);
        scene.output.energy = false;
        Ok(Tip::of(&run(&scene)?))
    }
}
