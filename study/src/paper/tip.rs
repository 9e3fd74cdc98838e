//! Positions of a tip over time.

use serde::Deserialize;

use super::window::Window;
use crate::path::{column, distance, largest_of, tip};
use ancf::run::Run;

/// Times, s, and positions, m; fixtures call the latter `tip`.
#[derive(Clone, Debug, Deserialize)]
pub struct Tip {
    pub t: Vec<f64>,
    #[serde(rename = "tip")]
    pub r: Vec<[f64; 2]>,
}

impl Tip {
    /// The probe `tip` of a run.
    pub fn of(run: &Run) -> Tip {
        Tip { t: column(run, "t"), r: tip(run) }
    }

    /// Position at time `t`; NaN if there is no such row.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let row = self.t.iter().position(|row| (row - t).abs() < 1e-9);
        row.and_then(|row| self.r.get(row).copied()).unwrap_or([f64::NAN; 2])
    }

    /// Distance at time `t` from a position, m.
    pub fn distance(&self, t: f64, position: [f64; 2]) -> f64 {
        distance(self.at(t), position)
    }

    /// Largest distance of another tip at its times for which `included` holds, m.
    pub fn largest_distance(&self, other: &Tip, included: impl Fn(f64) -> bool) -> f64 {
        let rows = other.t.iter().zip(&other.r).filter(|(t, _)| included(**t));
        largest_of(rows.map(|(t, r)| self.distance(*t, *r)))
    }

    /// Largest distance of another tip at its times in a window, m.
    pub fn largest_distance_in(&self, other: &Tip, window: Window) -> f64 {
        self.largest_distance(other, |t| window.contains(t))
    }
}
