//! Watches a motion for deviations that grow: a straight rod may stay straight in a simulation long after it would have
//! buckled.
//!
//! Signs of the tangent's eigenvalues alone are no criterion. Mechanisms have zero modes, a pushed rod or a driven
//! scissor has negative ones, and in a rod that vibrates along its axis the force passes the Euler load in every half
//! wave, too briefly to bend it. Looked for are deviations that grow by a factor of 10⁶ without a break.
//!
//! At a look the watch counts the directions that grow faster than e^(μ₀t), μ₀ = ln 10⁶ over the remaining time
//! ([`Structure::growing_directions`]). If there are any, it bounds the largest rate μ from below by doubling μ₀, and
//! the next looks come after some 0.7/μ each: a chain of looks. If ∫μ dt over a chain reaches ln 10⁶ the motion is
//! called unstable, and there are no more looks.
//!
//! Where a look of a chain finds no growth, three times the growth since the look before is taken back, and the chain
//! ends if nothing of it is left. A force that vibrates about zero so never adds up. Growth under a force that pulsates
//! is missed in part; the perturbed run of an estimate sees it.

use crate::elements::ThermalStrain;
use crate::integrators::State;
use crate::model::{Method, Scene};
use crate::structure::{Factors, Structure};

/// Growth that makes a motion unstable: an unavoidable deviation becomes visible.
const FACTOR: f64 = 1e6;

/// Steps between looks while nothing grows. A look costs a tangent and its elimination: as much as six explicit steps, one
/// of generalized-α, a third of one of the energy–momentum rule, an eighth of one of Gauss collocation.
fn steps_between_looks(method: Method) -> usize {
    match method {
        Method::Explicit => 1000,
        Method::Nystrom | Method::NystromAdaptive => 300,
        Method::EnergyMomentum => 32,
        Method::Gauss => 16,
        Method::GaussAdaptive => 8,
        _ => 64,
    }
}

/// Growth, in e-folds, between two looks of a chain: a rod that vibrates along its axis would have to be compressed at
/// some twenty looks in a row.
const FOLDS_BETWEEN_LOOKS: f64 = 0.7;

/// Part of the steps between looks, one over this, after which the second look of a chain comes.
const FIRST_PAUSE: usize = 16;

/// Multiple of the growth since the last look that is taken back where nothing grows any more.
const TAKEN_BACK: f64 = 3.0;

/// Factor tried between two doublings.
const BETWEEN: f64 = 1.4;

/// Most doublings of the least rate.
const DOUBLINGS: usize = 40;

/// Watch of one motion.
pub struct GrowthWatch {
    end: f64,
    every: usize,
    /// Number of the step after which the watch looks again.
    next: usize,
    /// State at the last look: number of steps and time, s.
    last: (usize, f64),
    chain: Option<Growth>,
    found: Option<Growth>,
    looks: usize,
    eliminations: usize,
    thermal: Vec<ThermalStrain>,
    /// Memory for the factors.
    factors: Factors,
}

/// Uninterrupted growth of small deviations.
#[derive(Clone, Copy, Debug)]
struct Growth {
    from: f64,
    to: f64,
    /// Lower bound of the present growth rate, 1/s.
    rate: f64,
    /// Lower bound of ∫μ dt.
    folds: f64,
    directions: usize,
}

impl GrowthWatch {
    /// Watch of a scene's motion, after a look at its start.
    pub fn new(structure: &Structure, scene: &Scene, state: &State) -> GrowthWatch {
        let every = steps_between_looks(scene.time.method);
        let mut watch = GrowthWatch {
            end: scene.time.end,
            every,
            next: 0,
            last: (0, 0.0),
            chain: None,
            found: None,
            looks: 0,
            eliminations: 0,
            thermal: structure.thermal_strains(0.0),
            factors: structure.factors(),
        };
        watch.look(structure, state);
        // A short run is looked at again in its middle.
        watch.next = watch.next.min(scene.steps() / 2);
        watch
    }

    /// Looks at the state after a step, if that is due.
    pub fn step(&mut self, structure: &Structure, state: &State) {
        if state.step >= self.next && self.found.is_none() && state.t < self.end {
            self.look(structure, state);
        }
    }

    fn look(&mut self, structure: &Structure, state: &State) {
        self.looks += 1;
        structure.thermal_strains_into(state.t, &mut self.thermal);
        let (last_step, last_t) = self.last;
        let (steps, time) = ((state.step - last_step).max(1), state.t - last_t);
        self.last = (state.step, state.t);
        let grown = self.chain.map_or(0.0, |chain| chain.folds);
        let least = (FACTOR.ln() - grown) / (self.end - state.t);
        self.chain = match (self.directions(structure, state, least), self.chain) {
            (0, None) => None,
            (0, Some(chain)) => {
                let folds = chain.folds - TAKEN_BACK * chain.rate * time;
                (folds > 0.0).then_some(Growth { folds, ..chain })
            }
            // Most chains of a vibrating rod end with the next look: only that searches for the rate.
            (directions, None) => Some(Growth { from: state.t, to: state.t, rate: least, folds: 0.0, directions }),
            (directions, Some(chain)) => {
                let rate = self.rate(structure, state, least, chain.rate.max(least));
                let folds = chain.folds + chain.rate.min(rate) * time;
                Some(Growth { to: state.t, rate, folds, directions: chain.directions.max(directions), ..chain })
            }
        };
        self.found = self.chain.filter(|chain| chain.folds >= FACTOR.ln());
        self.next = state.step
            + match self.chain {
                None => self.every,
                Some(chain) if chain.folds == 0.0 => self.every.div_ceil(FIRST_PAUSE),
                Some(chain) => self.pause(chain.rate * time / steps as f64),
            };
    }

    /// Number of directions that grow faster than `rate`, 1/s; none where they cannot be counted.
    fn directions(&mut self, structure: &Structure, state: &State, rate: f64) -> usize {
        self.eliminations += 1;
        structure.growing_directions(&state.u, &self.thermal, rate, &mut self.factors).unwrap_or(0)
    }

    /// Lower bound of the largest growth rate, at least `least` and at most 1.43 times too small; the search begins at
    /// `rate`.
    fn rate(&mut self, structure: &Structure, state: &State, least: f64, mut rate: f64) -> f64 {
        for _ in 0..DOUBLINGS {
            if rate <= least || self.directions(structure, state, rate) > 0 {
                break;
            }
            rate = (rate / 2.0).max(least);
        }
        for _ in 0..DOUBLINGS {
            if self.directions(structure, state, 2.0 * rate) == 0 {
                break;
            }
            rate *= 2.0;
        }
        if self.directions(structure, state, BETWEEN * rate) > 0 { BETWEEN * rate } else { rate }
    }

    /// Steps to the next look of a chain that grows by `folds` in a step; irregular, so that no vibration keeps pace.
    fn pause(&self, folds: f64) -> usize {
        let irregular = 0.75 + 0.5 * (0.618 * self.looks as f64).fract();
        ((irregular * FOLDS_BETWEEN_LOOKS / folds).ceil() as usize).clamp(1, self.every)
    }

    /// Warning about a motion whose deviations grow.
    pub fn warning(&self) -> Option<String> {
        let Growth { from, to, folds, directions, .. } = self.found?;
        Some(format!(
            "the motion is unstable between t = {from:.3e} s and {to:.3e} s at least: small deviations grow by a factor of e^{folds:.0}, in \
             {directions} direction(s), as when a rod buckles; a perfect structure may stay as it is where a real one would not; \
             `--estimate` runs a slightly perturbed structure beside it, and an `imperfection` or a small force across shows where it goes"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::{Counts, integrator};
    use crate::model::Model;
    use crate::model::plan::Plan;

    /// Steps and eliminations of a built-in scene.
    fn cost(name: &str, end: f64) -> (usize, usize) {
        let model = Model::load(name).unwrap().into_scene().until(end).build().unwrap();
        let (scene, mut counts) = (model.scene(), Counts::default());
        let plan = Plan::of(scene);
        let structure = Structure::of(&model, &plan).unwrap();
        let mut state = State::at_start(&structure);
        let mut method = integrator(scene, &plan, &structure, &state, &mut counts).unwrap();
        let mut watch = GrowthWatch::new(&structure, scene, &state);
        for step in 1..=scene.steps() {
            method.step(&structure, &mut state, scene.time_after(step), &mut counts).unwrap();
            watch.step(&structure, &state);
        }
        assert!(watch.found.is_none());
        (scene.steps(), watch.eliminations)
    }

    /// At most a fiftieth of the steps, also where the suddenly heated rod is pressed in every half wave: an elimination takes as long as
    /// six explicit steps, or a third of one of the energy–momentum rule.
    #[test]
    fn looks_cost_at_most_a_fiftieth_of_the_steps() {
        for (name, explicit) in
            [("pendulum-1d", true), ("pendulum-2d", true), ("pendulum-flexible", false), ("scissors-3", false)]
        {
            let (steps, eliminations) = cost(name, 0.5);
            let in_steps = if explicit { 6.0 * eliminations as f64 } else { eliminations as f64 / 3.0 };
            assert!(eliminations > 10 && in_steps <= 0.02 * steps as f64, "{name}: {eliminations} in {steps} steps");
        }
    }
}
