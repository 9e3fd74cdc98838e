//! Statics along its path: load factor and displacement are both unknown, so that the load may fall.
//!
//! Riks (1979, *Int. J. Solids Structures* 15, 529–551), with the normal plane of the predictor: from an equilibrium
//! (u₀, s₀) with the unit tangent t, ‖t‖ = 1, along the path,
//!
//! Q_e(u, θ(s)) = f(s),  ⟨t, u − u₀⟩ = ℓ.
//!
//! An iteration takes two solutions with the same factors, K δ_r = r and K δ_q = q with the residual r and the load
//! rate q; then s grows by σ = ⟨t, δ_r⟩/⟨t, δ_q⟩ and u by σ δ_q − δ_r, so that the second equation holds throughout.
//! It is linear, and has no second root that turns back. ⟨ , ⟩ is
//! [`displacement_product`](Structure::displacement_product).
//!
//! **Direction.** t is ± du/ds, with the sign of its product with the displacement of the last step; with a growing load
//! at the start.
//!
//! **Arc length.** The first predictor grows the load by a given increment, and no later one changes it by more. Within
//! that ℓ is multiplied by √(4/n) after n iterations, by at most two. A step is halved if the iteration fails, if the
//! tangent turns by more than 45° from the chord, if the load changes otherwise than the tangents at both ends say, or if
//! an element collapses: down to 2⁻²⁰ of the length it had.
//!
//! **End.** A step across the load factor 1 is replaced by one that ends there.

use nalgebra::DVector;

use super::counts::Counts;
use super::equilibrium::{Equilibrium, PathPoint, no_equilibrium};
use super::increment::Increment;
use super::integrator::Integrator;
use super::newton::{Equations, Failure, Newton, Residual};
use super::state::State;
use crate::error::Result;
use crate::linear::SingularAt;
use crate::structure::{Matrix, Structure};

/// Iterations for which the arc length stays.
const WANTED_ITERATIONS: f64 = 4.0;

/// Most by which an arc length changes from one step to the next.
const GROWTH: f64 = 2.0;

/// Most halvings of a step.
const HALVINGS: usize = 20;

/// Least cosine of the angle between a step and the tangents at its ends: 45°.
const ALIGNMENT: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Change of the load in a step beyond what the tangents at its ends say, relative to the larger one.
const LOAD_AGREEMENT: f64 = 0.5;

/// Advice for a path that ends.
const ADVICE: &str = "if it buckles there, an `imperfection` or a small force across shows where to; more `elements` help where rods bend far";

/// Arc-length method: rows along the path of equilibria.
#[derive(Debug)]
pub struct ArcLength {
    solver: Equilibrium,
    newton: Newton,
    /// Largest load increment of a predictor.
    increment: f64,
    /// Last accepted equilibrium, and the one to be found.
    reached: PathPoint,
    next: PathPoint,
    /// Displacement of the last step.
    chord: DVector<f64>,
    /// Unit tangent t at the last accepted equilibrium, and K⁻¹ q.
    tangent: DVector<f64>,
    response: DVector<f64>,
    /// Length of the next step; `None` before the first.
    length: Option<f64>,
}

impl ArcLength {
    /// Method whose first step grows the load factor by `increment`.
    pub fn new(structure: &Structure, newton: Newton, increment: f64) -> ArcLength {
        let zeros = || DVector::zeros(structure.size());
        ArcLength {
            solver: Equilibrium::new(structure, newton.clone()),
            newton,
            increment,
            reached: PathPoint::new(structure),
            next: PathPoint::new(structure),
            chord: zeros(),
            tangent: zeros(),
            response: zeros(),
            length: None,
        }
    }

    /// Sets the tangent at the last equilibrium; returns ds/dℓ there.
    fn orient(&mut self, structure: &Structure) -> f64 {
        let rate = &self.reached.rate;
        let size = structure.displacement_product(rate, rate).sqrt();
        let backwards = structure.displacement_product(rate, &self.chord) < 0.0;
        let slope = if backwards { -1.0 / size } else { 1.0 / size };
        self.tangent.copy_from(rate);
        self.tangent *= slope;
        slope
    }

    /// Tries a step of the given length and slope ds/dℓ: the outcome of the iteration, and whether the step keeps to the
    /// path.
    fn attempt(
        &mut self,
        structure: &Structure,
        length: f64,
        slope: f64,
        counts: &mut Counts,
    ) -> std::result::Result<bool, Failure> {
        let ArcLength { solver, newton, reached, next, chord, tangent, response, .. } = self;
        solver.before.copy_from(&reached.u);
        solver.increment.du.copy_from(tangent);
        solver.increment.du *= length;
        let load = reached.load + length * slope;
        let mut arc = AlongArc { structure, u_0: &reached.u, tangent, response, load, change: 0.0, solver };
        // As in `Equilibrium::solve`, nothing is remembered.
        newton.clone().solve(&mut arc, counts)?;
        next.load = arc.load;
        if reached.load < 1.0 && next.load >= 1.0 {
            next.load = 1.0;
            solver.solve(structure, reached, next, counts)?;
            if !solver.agree(structure, reached, next) {
                return Ok(false);
            }
        } else {
            next.u.copy_from(&solver.increment.u);
            let rate = solver.set_rate(structure, next, counts);
            rate.map_err(|at| Failure::Singular { iteration: 0, at })?;
        }
        chord.copy_from(&next.u);
        *chord -= &reached.u;
        let product = |a: &DVector<f64>, b: &DVector<f64>| structure.displacement_product(a, b);
        let (size, rate) = (product(chord, chord).sqrt(), product(&next.rate, &next.rate).sqrt());
        let forwards = product(chord, &next.rate) / rate;
        // What the tangents at both ends say of the change of the load.
        let (start, end) = (slope * size, size / rate * forwards.signum());
        let beyond = (next.load - reached.load - 0.5 * (start + end)).abs() - 0.5 * (start - end).abs();
        Ok(product(chord, tangent) >= ALIGNMENT * size
            && forwards.abs() >= ALIGNMENT * size
            && beyond <= LOAD_AGREEMENT * start.abs().max(end.abs())
            && structure.check_collapse(&reached.u, &next.u, next.load).is_ok())
    }
}

impl ArcLength {
    fn accept(&mut self, state: &mut State, t_1: f64, counts: &mut Counts) {
        std::mem::swap(&mut self.reached, &mut self.next);
        state.u.copy_from(&self.reached.u);
        state.advance(t_1);
        state.load = self.reached.load;
        counts.steps += 1;
    }

    /// Grows the load where that moves nothing, and the path has no length.
    fn stay(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let ArcLength { solver, reached, next, increment, .. } = self;
        next.load = (reached.load + *increment).min(1.0);
        let failure = solver.solve(structure, reached, next, counts).err();
        if failure.is_some() || !solver.agree(structure, reached, next) {
            return Err(no_equilibrium(failure, structure, reached.load, None, ADVICE));
        }
        self.accept(state, t_1, counts);
        Ok(())
    }
}

impl Integrator for ArcLength {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let singular = |at: SingularAt, load| {
            no_equilibrium(Some(Failure::Singular { iteration: 0, at }), structure, load, None, ADVICE)
        };
        if self.length.is_none() {
            self.reached.load = state.load;
            self.reached.u.copy_from(&state.u);
            self.solver.enter(structure, state.load);
            self.solver.set_rate(structure, &mut self.reached, counts).map_err(|at| singular(at, state.load))?;
        }
        let slope = self.orient(structure);
        if slope.is_infinite() {
            return self.stay(structure, state, t_1, counts);
        }
        let longest = self.increment / slope.abs();
        let mut length = self.length.map_or(longest, |length| length.min(longest));
        let mut last = None;
        for _ in 0..=HALVINGS {
            let before = counts.newton_iterations;
            match self.attempt(structure, length, slope, counts) {
                Ok(true) => {
                    let iterations = (counts.newton_iterations - before).max(1) as f64;
                    self.length = Some(length * (WANTED_ITERATIONS / iterations).sqrt().clamp(1.0 / GROWTH, GROWTH));
                    self.accept(state, t_1, counts);
                    return Ok(());
                }
                Ok(false) => last = None,
                Err(failure) => last = Some(failure),
            }
            counts.rejected += 1;
            length *= 0.5;
        }
        Err(no_equilibrium(last, structure, self.reached.load, None, ADVICE))
    }

    fn is_at_end(&self, state: &State) -> bool {
        state.load >= 1.0
    }
}

/// Equations of one step.
struct AlongArc<'a> {
    structure: &'a Structure,
    u_0: &'a DVector<f64>,
    tangent: &'a DVector<f64>,
    response: &'a mut DVector<f64>,
    /// Load factor, and its last change.
    load: f64,
    change: f64,
    solver: &'a mut Equilibrium,
}

impl Equations for AlongArc<'_> {
    fn residual(&mut self, counts: &mut Counts) -> Residual {
        let Equilibrium { increment, load, thermal, .. } = &mut *self.solver;
        self.structure.thermal_strains_into(self.load, thermal);
        self.structure.load_into(self.load, load);
        increment.move_from(self.u_0);
        let Increment { u, residual, .. } = increment;
        self.structure.force(u, thermal, residual);
        counts.force_calls += 1;
        let largest_term = self.structure.largest_force(residual).max(self.structure.largest_force(load));
        *residual -= &*load;
        Residual { size: self.structure.largest_force(residual), largest_term }
    }

    fn at_rounding(&self, times: f64) -> bool {
        self.solver.increment.at_rounding(self.structure, &self.solver.thermal, times)
    }

    fn factorize(&mut self) -> std::result::Result<(), SingularAt> {
        let Equilibrium { increment: Increment { u, factors, .. }, before, thermal, .. } = &mut *self.solver;
        self.structure.factorize(Matrix::Mixed { before, u, thermal }, factors)
    }

    fn improve(&mut self) {
        let solver = &mut *self.solver;
        solver.before.copy_from(&solver.increment.u);
        solver.set_load_rate(self.structure);
        self.response.copy_from(&solver.load_rate);
        solver.increment.factors.solve(self.response);
        solver.increment.improve();
        let product = |a: &DVector<f64>| self.structure.displacement_product(self.tangent, a);
        self.change = product(solver.increment.improvement()) / product(self.response);
        self.load += self.change;
        solver.increment.du.axpy(self.change, self.response, 1.0);
    }

    fn undo(&mut self) {
        self.load -= self.change;
        self.solver.increment.du.axpy(-self.change, self.response, 1.0);
        self.solver.increment.undo();
    }
}
