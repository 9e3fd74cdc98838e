//! Stress-free deviation of the initial shape: of one rod, or of all in the shape of a vibration mode.

use std::f64::consts::PI;

use nalgebra::{DVector, Vector2};

use super::rod::Rod;
use super::{Matrix, Structure};
use crate::elements::Meaning;
use crate::error::{Error, Result};
use crate::linear::{Modes, smallest_modes};
use crate::model::{self, Imperfection, Scene, Support};

/// Relative difference of two frequencies ω² below which any mix of their modes is a mode too.
const SAME_FREQUENCY: f64 = 1e-6;

/// Part of the largest displacement from which a node counts as equally far, and a direction as not zero.
const EQUALLY_FAR: f64 = 1e-6;

/// Maximum of sin(πξ) sin(πξ/2): 4/(3√3).
const ONE_CLAMP_MAXIMUM: f64 = 0.769_800_358_919_501;

/// Shape of a bowed rod over ξ = x/L, from 0 to 1 and with 1 as its largest value.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bow {
    /// sin(πξ): both ends turn freely.
    Free,
    /// sin²(πξ): the sections at both ends are clamped.
    Clamped,
    /// sin(πξ) sin(πξ/2), scaled: the section at the start is clamped.
    ClampedAtStart,
    /// The same from the other end.
    ClampedAtEnd,
}

impl Bow {
    /// Shape of a rod whose sections are held by the supports at its ends.
    fn of(rod: &model::Rod, supports: &[Support]) -> Bow {
        let clamped = |point: &str| {
            supports.iter().any(|support| support.point == point && support.clamp.as_deref() == Some(&rod.name))
        };
        match (clamped(&rod.from), clamped(&rod.to)) {
            (false, false) => Bow::Free,
            (true, true) => Bow::Clamped,
            (true, false) => Bow::ClampedAtStart,
            (false, true) => Bow::ClampedAtEnd,
        }
    }

    /// Value and derivative at ξ.
    fn at(self, xi: f64) -> (f64, f64) {
        let (sin, cos) = (PI * xi).sin_cos();
        match self {
            Bow::Free => (sin, PI * cos),
            Bow::Clamped => (sin * sin, 2.0 * PI * sin * cos),
            Bow::ClampedAtStart => {
                let (half_sin, half_cos) = (0.5 * PI * xi).sin_cos();
                let slope = PI * (cos * half_sin + 0.5 * sin * half_cos);
                (sin * half_sin / ONE_CLAMP_MAXIMUM, slope / ONE_CLAMP_MAXIMUM)
            }
            Bow::ClampedAtEnd => {
                let (value, slope) = Bow::ClampedAtStart.at(1.0 - xi);
                (value, -slope)
            }
        }
    }
}

/// Changes of the nodal vectors to the deviated shape, in global axes, rod by rod along their chains.
pub(super) struct Deviation(Vec<Vec<Vector2<f64>>>);

impl Deviation {
    /// Writes the deviation into a vector of unknowns.
    pub fn set(&self, rods: &[Rod], u: &mut DVector<f64>) {
        for (vector, change) in rods.iter().zip(&self.0).flat_map(|(rod, changes)| rod.chain.iter().zip(changes)) {
            vector.set(change, u);
        }
    }
}

impl Structure {
    /// Deviation of this structure, which is in the condensed form.
    ///
    /// # Errors
    /// [`Error::Scene`] for a mode that the structure does not have, or that is no shape of its own.
    pub(super) fn deviation(&self, scene: &Scene, imperfection: &Imperfection) -> Result<Deviation> {
        if let Some(mode) = imperfection.mode {
            let u = self.in_mode(mode, imperfection.amplitude)?;
            let changes = |rod: &Rod| rod.chain.iter().map(|vector| vector.get(&u)).collect();
            return Ok(Deviation(self.rods.iter().map(changes).collect()));
        }
        let changes = |(rod, mesh): (&model::Rod, &Rod)| {
            if Some(&rod.name) == imperfection.rod.as_ref() {
                bowed(mesh, Bow::of(rod, &scene.supports), imperfection.amplitude)
            } else {
                vec![Vector2::zeros(); mesh.chain.len()]
            }
        };
        Ok(Deviation(scene.rods.iter().zip(&*self.rods).map(changes).collect()))
    }

    /// Structure deviated in the shape of its n-th vibration mode, cold and without loads.
    fn in_mode(&self, number: usize, amplitude: f64) -> Result<DVector<f64>> {
        let refused = |allowed: String| {
            let (file, key, value) = ("scene".into(), "imperfection.mode".into(), number.to_string());
            Error::Scene { file, key, value, allowed }
        };
        let modes = self.slowest_modes(number + 1);
        let modes = modes.ok_or_else(|| refused("a mode whose computation converges; a lower one, or `rod`".into()))?;
        let Some(shape) = modes.shapes.get(number - 1) else {
            return Err(refused(format!(
                "a whole number up to {}, the structure's number of modes",
                modes.shapes.len()
            )));
        };
        let square = |n: usize| modes.squares.get(n).copied();
        let own = modes.squares[number - 1];
        let near = |other: f64| (other - own).abs() <= SAME_FREQUENCY * own;
        let twin = [number.checked_sub(2), Some(number)].into_iter().flatten().find(|n| square(*n).is_some_and(near));
        if let Some(twin) = twin {
            let allowed = format!(
                "a mode with a frequency of its own; modes {number} and {} have the same, and any mix of their shapes is a mode: \
                 `rod` has one shape",
                twin + 1
            );
            return Err(refused(allowed));
        }
        Ok(shape * (amplitude / self.farthest(shape)))
    }

    /// Slowest vibrations of the cold, unloaded structure; `None` where they do not converge.
    fn slowest_modes(&self, number: usize) -> Option<Modes> {
        let (at_rest, cold) = (DVector::zeros(self.size()), vec![[0.0; 2]; self.rods.len()]);
        let mut factors = self.factors();
        let stiffness = Matrix::Tangent { u: &at_rest, thermal: &cold, stiffness: 1.0, mass: 0.0 };
        self.factorize(stiffness, &mut factors).ok()?;
        smallest_modes(self.size(), number, |x| self.inertia(x), |x| factors.solve(x))
    }

    /// Displacement of the node that moves farthest, with the sign that it is positive by: to the left of its rod's
    /// direction, or along it where it does not move across.
    pub fn farthest(&self, u: &DVector<f64>) -> f64 {
        let nodes = || {
            self.rods.iter().flat_map(|rod| {
                let positions = (0..rod.chain.len()).filter(|n| rod.nodal(*n).0 == Meaning::Position);
                positions.map(move |n| (rod.along.normalize(), rod.chain[n].get(u)))
            })
        };
        let largest = nodes().map(|(_, moved)| moved.norm()).fold(0.0, f64::max);
        let first = nodes().find(|(_, moved)| moved.norm() >= (1.0 - EQUALLY_FAR) * largest);
        let is_negative = first.is_some_and(|(t, moved)| {
            let across = t.perp(&moved);
            if across.abs() > EQUALLY_FAR * largest { across < 0.0 } else { t.dot(&moved) < 0.0 }
        });
        if is_negative { -largest } else { largest }
    }
}

/// Changes of the nodal vectors of a rod that is bowed between its ends. Its sections stay normal to the axis and keep their
/// height.
fn bowed(rod: &Rod, bow: Bow, amplitude: f64) -> Vec<Vector2<f64>> {
    let (length, t) = (rod.elements as f64 * rod.along.norm(), rod.along.normalize());
    let n = Vector2::new(-t.y, t.x);
    let change = |number: usize| {
        let (meaning, place) = rod.nodal(number);
        let (value, slope) = bow.at(place / rod.elements as f64);
        let (w, w_x) = (amplitude * value, amplitude * slope / length);
        match meaning {
            Meaning::Position => w * n,
            Meaning::SlopeX => w_x * n,
            // From n to the normal of the axis.
            Meaning::SlopeY => (n - w_x * t) / w_x.hypot(1.0) - n,
        }
    };
    (0..rod.chain.len()).map(change).collect()
}
