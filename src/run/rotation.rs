//! Watches how far rods turn in a step θ: the energy–momentum rule lags behind by θ³/12 a step, others by more.

use crate::error::Error;
use crate::integrators::State;
use crate::model::{Method, Scene};
use crate::structure::Structure;

/// Rotation of a rod in one step that is warned of, rad.
const WARNED: f64 = 0.1;

/// Error of the angle at the end that the advised step allows, rad.
const ALLOWED: f64 = 0.01;

/// Fastest rotation of a rod at the rows.
pub struct RotationWatch {
    /// Fixed step, s; `None` for adaptive methods, which resolve rotations, and in statics.
    step: Option<f64>,
    end: f64,
    /// Largest rotation in a step, rad, the time of it, s, and the rod.
    largest: (f64, f64, String),
}

impl RotationWatch {
    pub fn new(scene: &Scene) -> RotationWatch {
        let step = (scene.moves() && !scene.time.method.is_adaptive()).then_some(scene.time.step);
        RotationWatch { step, end: scene.time.end, largest: (0.0, 0.0, String::new()) }
    }

    /// Looks at the state of a row.
    pub fn row(&mut self, structure: &Structure, state: &State) {
        let Some(step) = self.step else { return };
        let (rate, rod) = structure.fastest_rotation(&state.u, &state.v);
        if rate * step > self.largest.0.max(WARNED) {
            self.largest = (rate * step, state.t, rod.into());
        }
    }

    /// Warning about rotations that the steps do not resolve.
    pub fn warning(&self) -> Option<String> {
        let (turn, t, rod) = &self.largest;
        let cure = self.cure()?;
        Some(format!(
            "the rod `{rod}` turns by {turn:.2} rad in a step, at t = {t:.3e} s: its angle lags behind or runs ahead, the more the \
             longer it turns; {cure}"
        ))
    }

    /// Error of a row; rotations that steps do not resolve are told as the cause of energy from nowhere.
    pub fn explain(&self, error: Error) -> Error {
        match (error, self.cure()) {
            (Error::EnergyAppeared { time, step, created, supply, .. }, Some(cure)) => {
                let cause = format!("the rod `{}` turns by {:.2} rad in a step", self.largest.2, self.largest.0);
                Error::EnergyAppeared { time, step, created, supply, cause, cure }
            }
            (error, _) => error,
        }
    }

    /// Method and step that resolve the fastest rotation ω to the end T; `None` if all are resolved. The energy–momentum
    /// rule is off by ωT (ωΔt)²/12.
    fn cure(&self) -> Option<String> {
        let (turn, ..) = self.largest;
        let rate = turn / self.step.filter(|_| turn > WARNED)?;
        let step = (12.0 * ALLOWED / (rate * self.end)).sqrt().min(WARNED) / rate;
        let method = Method::EnergyMomentum;
        Some(format!("\"{method}\" with a `time.step` of {step:.1e} s keeps the angle at the end within {ALLOWED} rad"))
    }
}
