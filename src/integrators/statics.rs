//! Statics: equilibrium Q_e(u, θ(s)) = f(s), as the load factor s grows from 0 to 1.
//!
//! **Branch.** Newton's iteration finds some equilibrium, not always the one to which the structure moves. Beyond the
//! Euler load of a column with a small force across, the mirrored shape is an equilibrium as well, and a stable one. A
//! load step is therefore accepted only if its displacement agrees with the rates du/ds at both of its ends
//! ([`Equilibrium::agree`]). Otherwise it is halved, down to 2⁻²⁰ of itself. That the solutions of a step and of its
//! halves are equal would not be enough: both may have jumped to the same branch.
//!
//! The rate at the start of a step is the first iteration of the next one, so that the check costs one factorisation a
//! run, and one evaluation of products a step. Solutions beyond a half are kept: they are accepted without another
//! iteration if the path leads to them.
//!
//! **Corners** of histories inside a load step are ends of its parts.
//!
//! The equilibrium found need not be stable: a perfect column stays straight above its Euler load.

use super::counts::Counts;
use super::equilibrium::{Equilibrium, PathPoint, no_equilibrium};
use super::integrator::{Integrator, same_time};
use super::newton::{Failure, Newton};
use super::state::State;
use crate::error::{Error, Result, time_text};
use crate::linear::SingularAt;
use crate::structure::Structure;

/// Shortest part of a load step: some million times shorter.
const SHORTEST_PART: f64 = 1.0 / (1 << 20) as f64;

/// Number of accepted equilibria after which a solution farther on that still does not agree is made anew. Most such
/// solutions are right, and one more equilibrium before them shows it.
const PATIENCE: usize = 2;

/// Advice for a path that ends: most structures snap through there.
const ADVICE: &str = "if it snaps through there, `\"path\": \"arc-length\"` in `time` follows it; if it buckles, an `imperfection` or a small force across \
                      shows where to; more `elements` help where rods bend far";

/// Advice for loads with histories, which an arc length cannot follow.
const ADVICE_WITH_HISTORIES: &str = "if it snaps through there, `\"path\": \"arc-length\"` in `time` follows it where loads and heat have no \
                                     `history`; if it buckles, an `imperfection` or a small force across shows where to; more `elements` help where rods \
                                     bend far";

/// Static method: load steps, with the load factor in place of time.
#[derive(Debug)]
pub struct Statics {
    solver: Equilibrium,
    /// Last accepted equilibrium, and whether its rate is that of the present stretch.
    reached: PathPoint,
    has_rate: bool,
    /// Equilibria to be reached in the present step, the next one last; beyond them, memory for more.
    targets: Vec<Target>,
    ahead: usize,
}

/// Equilibrium to be reached.
#[derive(Debug)]
struct Target {
    point: PathPoint,
    /// Outcome of the last attempt; `None` before the first.
    outcome: Option<std::result::Result<(), Failure>>,
    /// Accepted equilibria since that attempt.
    age: usize,
}

impl Statics {
    /// Statics of a structure; [`Newton::with_new_matrices`] converges best.
    pub fn new(structure: &Structure, newton: Newton) -> Statics {
        let (solver, reached) = (Equilibrium::new(structure, newton), PathPoint::new(structure));
        Statics { solver, reached, has_rate: false, targets: Vec::new(), ahead: 0 }
    }

    /// Puts an equilibrium at the load factor `load` before all others ahead.
    fn aim(&mut self, structure: &Structure, load: f64) {
        if self.ahead == self.targets.len() {
            self.targets.push(Target { point: PathPoint::new(structure), outcome: None, age: 0 });
        }
        let target = &mut self.targets[self.ahead];
        (target.point.load, target.outcome, target.age) = (load, None, 0);
        self.ahead += 1;
    }

    /// Takes the present state as the start of the path, unless it is the last one reached.
    fn start_at(&mut self, state: &State) {
        if self.reached.load != state.load || self.reached.u != state.u {
            self.reached.load = state.load;
            self.reached.u.copy_from(&state.u);
            self.has_rate = false;
        }
    }

    /// Follows the path to the next corner before the load factor `t_1`, or to `t_1`; no part of it is shorter than
    /// `shortest`.
    fn follow(&mut self, structure: &Structure, t_1: f64, shortest: f64, counts: &mut Counts) -> Result<()> {
        let (here, near) = (self.reached.load, same_time(t_1));
        let [_, corner] = structure.stretch(here + near);
        let end = if corner < t_1 - near { corner } else { t_1 };
        let advice = if structure.corners().is_empty() { ADVICE } else { ADVICE_WITH_HISTORIES };
        if self.solver.enter(structure, here + near) || !self.has_rate {
            let rate = self.solver.set_rate(structure, &mut self.reached, counts);
            rate.map_err(|at: SingularAt| {
                no_equilibrium(Some(Failure::Singular { iteration: 0, at }), structure, here, None, advice)
            })?;
            self.has_rate = true;
        }
        self.ahead = 0;
        self.aim(structure, end);
        while let Some(last) = self.ahead.checked_sub(1) {
            let Statics { solver, reached, targets, .. } = self;
            let target = &mut targets[last];
            let length = target.point.load - reached.load;
            let mut agrees = matches!(target.outcome, Some(Ok(()))) && solver.agree(structure, reached, &target.point);
            let is_old = target.age > if length > shortest { PATIENCE } else { 0 };
            if !agrees && (target.outcome.is_none() || is_old) {
                let outcome = solver.solve(structure, reached, &mut target.point, counts);
                (target.outcome, target.age) = (Some(outcome), 0);
                agrees = outcome.is_ok() && solver.agree(structure, reached, &target.point);
            }
            if agrees {
                std::mem::swap(reached, &mut target.point);
                self.ahead = last;
                self.targets[..last].iter_mut().for_each(|target| target.age += 1);
                continue;
            }
            if length <= shortest {
                let failure = target.outcome.and_then(std::result::Result::err);
                let collapsed = solver.collapse_ahead(structure, reached, shortest);
                return Err(no_equilibrium(failure, structure, reached.load, collapsed, advice));
            }
            counts.rejected += 1;
            let middle = reached.load + 0.5 * length;
            self.aim(structure, middle);
        }
        Ok(())
    }
}

impl Integrator for Statics {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        // Also where it is not a number.
        if !(t_1 > state.load && t_1.is_finite()) {
            let allowed = format!("load factors over {}", time_text(state.load));
            return Err(Error::NotATime { time: t_1, allowed, statics: true });
        }
        self.start_at(state);
        let shortest = SHORTEST_PART * (t_1 - state.load);
        while self.reached.load < t_1 {
            self.follow(structure, t_1, shortest, counts)?;
        }
        state.u.copy_from(&self.reached.u);
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}
