//! Judges the stability of each static equilibrium that becomes a row.

use crate::error::time_text;
use crate::integrators::State;
use crate::structure::{StabilityCounter, Structure};

/// Stability of the equilibria of a run, row by row.
pub struct Equilibria {
    counter: StabilityCounter,
    /// Most unstable directions of a row.
    directions: usize,
    /// Load factor of the first unstable row, and of the last stable one before it.
    unstable_from: Option<f64>,
    stable_to: Option<f64>,
    /// Load factor of the first row whose stability could not be told.
    unknown_at: Option<f64>,
    is_unstable_now: bool,
    /// Whether the path is that of an arc length, along which the load may fall.
    follows_arc: bool,
}

impl Equilibria {
    pub fn new(structure: &Structure, follows_arc: bool) -> Equilibria {
        Equilibria {
            counter: StabilityCounter::new(structure),
            directions: 0,
            unstable_from: None,
            stable_to: None,
            unknown_at: None,
            is_unstable_now: false,
            follows_arc,
        }
    }

    /// Judges the equilibrium of a row.
    pub fn row(&mut self, structure: &Structure, state: &State) {
        let Some(directions) = self.counter.unstable_directions(structure, &state.u, state.load) else {
            self.unknown_at = self.unknown_at.or(Some(state.load));
            return;
        };
        self.is_unstable_now = directions > 0;
        self.directions = self.directions.max(directions);
        if self.is_unstable_now {
            self.unstable_from = self.unstable_from.or(Some(state.load));
        } else if self.unstable_from.is_none() {
            self.stable_to = Some(state.load);
        }
    }

    /// Most unstable directions of a row.
    pub fn unstable_directions(&self) -> usize {
        self.directions
    }

    /// Warnings about the rows judged.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        let unstable = self.unstable_from.map(|from| {
            let directions = self.directions;
            let before = self.stable_to.map_or(String::new(), |to| format!(" (stable up to {})", time_text(to)));
            let now = if self.is_unstable_now { "" } else { ", the last one is stable again" };
            let from = time_text(from);
            if self.follows_arc {
                return format!(
                    "the path is unstable beyond {from} of the load{before}, in {directions} direction(s){now}: under a given load the structure \
                     snaps through there, or buckles"
                );
            }
            format!(
                "the equilibria from {from} of the load on are unstable{before}, in {directions} direction(s){now}: the structure is loaded \
                 beyond its buckling load and would leave this position; an `imperfection` or a small force across shows where to"
            )
        });
        let unknown = self.unknown_at.map(|load| {
            format!(
                "whether the equilibrium at {} of the load is stable could not be told: its tangent is out of the range of \
                 numbers",
                time_text(load)
            )
        });
        unstable.into_iter().chain(unknown)
    }
}
