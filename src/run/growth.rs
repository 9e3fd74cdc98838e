//! Watches a motion for deviations that grow: a straight rod may stay straight in a simulation long after it would have
//! buckled.
//!
//! Signs of the tangent's eigenvalues alone are no criterion. Mechanisms have zero modes, a pushed rod or a driven
//! scissor has negative ones, and in a rod that vibrates along its axis the force passes the Euler load in every half
//! wave, too briefly to bend it. Looked for are deviations that grow by a factor of 10⁶ without a break.
//!
//! At a look the watch counts the directions that grow faster than e^(μ₀t), μ₀ = ln 10⁶ over the remaining time
//! ([`Structure::growing_directions`]). If there are any, it bounds the largest rate μ from below by doubling μ₀, and
//! the next looks come after some 0.7/μ each: a chain of looks. Where a look of a chain finds no growth, three times the
//! growth since the look before is taken back, so that a force that vibrates about zero never adds up. Growth
//! under a force that pulsates is missed in part; the perturbed run of an estimate sees it. A chain ends where nothing of it is left. If its ∫μ dt reaches ln 10⁶ the
//! motion is called unstable, and there are no more looks.

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
        Method::Explicit => 500,
        Method::Nystrom | Method::NystromAdaptive => 200,
        Method::EnergyMomentum => 32,
        Method::Gauss => 16,
        Method::GaussAdaptive => 8,
        _ => 64,
    }
}

/// Growth, in e-folds, between two looks of a chain: a rod that vibrates along its axis would have to be compressed at
/// some twenty looks in a row.
const FOLDS_BETWEEN_LOOKS: f64 = 0.7;

/// Share of the growth since the last look that is taken back where nothing grows any more.
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
        let grown_so_far = self.chain.map_or(0.0, |chain| chain.folds);
        let least = (FACTOR.ln() - grown_so_far) / (self.end - state.t);
        let factors = &mut self.factors;
        let mut grows =
            |rate: f64| structure.growing_directions(&state.u, &self.thermal, rate, factors).filter(|found| *found > 0);
        let (steps, t) = self.last;
        let step = (state.t - t) / (state.step - steps).max(1) as f64;
        self.last = (state.step, state.t);
        let after = |rate: f64, looks: usize| {
            let pause = (FOLDS_BETWEEN_LOOKS / (rate * step)) * (0.75 + 0.5 * (0.618 * looks as f64).fract());
            (pause.ceil() as usize).clamp(1, self.every)
        };
        let Some(directions) = grows(least) else {
            self.next = state.step + self.chain.map_or(self.every, |chain| after(chain.rate, self.looks));
            self.chain = self.chain.and_then(|chain| {
                let folds = chain.folds - TAKEN_BACK * chain.rate * (state.t - t);
                (folds > 0.0).then_some(Growth { folds, ..chain })
            });
            if self.chain.is_none() {
                self.next = state.step + self.every;
            }
            return;
        };
        // Where the last look of the chain has found a rate, the search begins there.
        let mut rate = self.chain.map_or(least, |chain| chain.rate.max(least));
        for _ in 0..DOUBLINGS {
            if rate <= least || grows(rate).is_some() {
                break;
            }
            rate = (rate / 2.0).max(least);
        }
        for _ in 0..DOUBLINGS {
            if grows(2.0 * rate).is_none() {
                break;
            }
            rate *= 2.0;
        }
        if grows(BETWEEN * rate).is_some() {
            rate *= BETWEEN;
        }
        let grown = match self.chain {
            Some(chain) => {
                let folds = chain.folds + chain.rate.min(rate) * (state.t - t);
                Growth { to: state.t, rate, folds, directions: chain.directions.max(directions), ..chain }
            }
            None => Growth { from: state.t, to: state.t, rate, folds: 0.0, directions },
        };
        self.next = state.step + after(rate, self.looks);
        self.chain = Some(grown);
        self.found = Some(grown).filter(|grown| grown.folds >= FACTOR.ln());
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
