//! Equilibrium Q_e(u, θ(s)) = f(s) at a load factor s, and the direction du/ds in which it moves.
//!
//! Newton's iteration with independent stresses (Magisano, Leonetti and Garcea 2017,
//! [`Beam::mixed_tangent`](crate::elements::Beam::mixed_tangent)). In large bending plain Newton needs ever more
//! iterations the more slender a rod is, since its steps must not stretch the axis; with independent stresses a slender
//! rod needs no more than a stubby one.
//!
//! Between two corners of histories loads and heat are linear in s, and Q_e is linear in the thermal strain θ. The
//! derivative of the equilibrium is then K du/ds = q(u), with the tangent K and the load rate
//!
//! q(u) = \[f(s₁) − f(s₀) − Q_e(u, θ(s₁)) + Q_e(u, θ(s₀))\] / (s₁ − s₀).

use nalgebra::DVector;

use super::counts::Counts;
use super::increment::Increment;
use super::newton::{Equations, Failure, Newton, Residual};
use crate::elements::ThermalStrain;
use crate::error::Error;
use crate::linear::SingularAt;
use crate::structure::{Matrix, Structure};

/// Largest distance of a step's displacement Δu from Δs du/ds at either of its ends, relative to |Δu|. Each rate then
/// points within 45° of Δu, and Δs du/ds is 0.3 to 1.7 times as long. A step to another branch leaves the direction of
/// the rate at its start: one to the mirrored branch has a distance above one. A step across a limit point is far longer
/// than both rates say. Of 300 columns none was mirrored with 0.5 … 0.8; smaller numbers only cost more steps.
const AGREEMENT: f64 = 0.7;

/// Shortest parts of a load step over which an element that is about to collapse at the end of a path has collapsed.
const COLLAPSE_AHEAD: f64 = 8.0;

/// Displacement, relative to the whole, below which a step is no jump: Newton's tolerance and rounding.
const NO_JUMP: f64 = 1e-6;

/// Point of an equilibrium path.
#[derive(Clone, Debug)]
pub struct PathPoint {
    /// Load factor s.
    pub load: f64,
    /// Displacement.
    pub u: DVector<f64>,
    /// Derivative du/ds of the equilibrium.
    pub rate: DVector<f64>,
}

impl PathPoint {
    /// Allocates a point.
    pub fn new(structure: &Structure) -> PathPoint {
        let zeros = || DVector::zeros(structure.size());
        PathPoint { load: 0.0, u: zeros(), rate: zeros() }
    }
}

/// Solver for equilibria of a structure, with its buffers.
#[derive(Debug)]
pub struct Equilibrium {
    newton: Newton,
    /// Unknown increment, and the factors of the last matrix.
    pub increment: Increment,
    /// Displacement before the last improvement.
    pub before: DVector<f64>,
    /// Load f(s).
    pub load: DVector<f64>,
    pub thermal: Vec<ThermalStrain>,
    /// Load rate q(u).
    pub load_rate: DVector<f64>,
    /// Ends s₀ and s₁ of the stretch on which loads and heat are linear, and f(s₁) − f(s₀).
    stretch: [f64; 2],
    load_change: DVector<f64>,
    /// Thermal strains at both ends of the stretch.
    ends: [Vec<ThermalStrain>; 2],
    heats: bool,
    buffer: DVector<f64>,
}

impl Equilibrium {
    /// Solver of a structure; [`Newton::with_new_matrices`] converges best.
    pub fn new(structure: &Structure, newton: Newton) -> Equilibrium {
        let (zeros, thermal) = (|| DVector::zeros(structure.size()), || structure.thermal_strains(0.0));
        Equilibrium {
            newton,
            increment: Increment::new(structure),
            before: zeros(),
            load: zeros(),
            thermal: thermal(),
            load_rate: zeros(),
            stretch: [f64::NAN; 2],
            load_change: zeros(),
            ends: [thermal(), thermal()],
            heats: false,
            buffer: zeros(),
        }
    }

    /// Takes the loads and the heat of the stretch in which the load factor `load` lies; returns whether it is another
    /// one than before.
    pub fn enter(&mut self, structure: &Structure, load: f64) -> bool {
        let stretch @ [start, end] = structure.stretch(load);
        if stretch == self.stretch {
            return false;
        }
        self.stretch = stretch;
        structure.load_into(end, &mut self.load_change);
        structure.load_into(start, &mut self.buffer);
        self.load_change -= &self.buffer;
        let [thermal_0, thermal_1] = &mut self.ends;
        structure.thermal_strains_into(start, thermal_0);
        structure.thermal_strains_into(end, thermal_1);
        self.heats = thermal_0 != thermal_1;
        true
    }

    /// Load rate q(u) on the present stretch, at the present iterate, into [`load_rate`](Equilibrium::load_rate).
    pub fn set_load_rate(&mut self, structure: &Structure) {
        let Equilibrium { increment: Increment { u, .. }, load_rate, load_change, ends, buffer, .. } = self;
        load_rate.copy_from(load_change);
        if self.heats {
            for (sign, thermal) in [1.0, -1.0].into_iter().zip(&*ends) {
                structure.force(u, thermal, buffer);
                load_rate.axpy(sign, buffer, 1.0);
            }
        }
        *load_rate /= self.stretch[1] - self.stretch[0];
    }

    /// Sets the rate du/ds of a point from the tangent there.
    ///
    /// # Errors
    /// Unknown of a vanishing pivot.
    pub fn set_rate(
        &mut self,
        structure: &Structure,
        point: &mut PathPoint,
        counts: &mut Counts,
    ) -> Result<(), SingularAt> {
        structure.thermal_strains_into(point.load, &mut self.thermal);
        self.increment.u.copy_from(&point.u);
        self.set_load_rate(structure);
        let tangent = Matrix::Tangent { u: &point.u, thermal: &self.thermal, stiffness: 1.0, mass: 0.0 };
        counts.tangent_calls += 1;
        counts.factorizations += 1;
        structure.factorize(tangent, &mut self.increment.factors)?;
        counts.solves += 1;
        point.rate.copy_from(&self.load_rate);
        self.increment.factors.solve(&mut point.rate);
        Ok(())
    }

    /// Finds the equilibrium at the load factor `to.load`, starting along the rate of `from`, and its rate.
    ///
    /// # Errors
    /// [`Failure`] of the iteration, or a singular tangent at its end.
    pub fn solve(
        &mut self,
        structure: &Structure,
        from: &PathPoint,
        to: &mut PathPoint,
        counts: &mut Counts,
    ) -> Result<(), Failure> {
        structure.thermal_strains_into(to.load, &mut self.thermal);
        structure.load_into(to.load, &mut self.load);
        let largest_load = structure.largest_force(&self.load);
        self.before.copy_from(&from.u);
        self.increment.du.copy_from(&from.rate);
        self.increment.du *= to.load - from.load;
        // Each iteration makes its own matrix: nothing is remembered from one solution to the next.
        let mut newton = self.newton.clone();
        newton.solve(&mut AtLoad { structure, u_0: &from.u, largest_load, solver: self }, counts)?;
        to.u.copy_from(&self.increment.u);
        self.set_rate(structure, to, counts).map_err(|at| Failure::Singular { iteration: 0, at })
    }

    /// What collapses if the displacement goes on from a point at its rate, over eight times the shortest part of a load
    /// step. Near the end of a path the rate is far above the mean of the way to it, so that a section that shrinks to
    /// nothing there is gone by then; a structure that snaps through has hardly moved.
    pub fn collapse_ahead(&mut self, structure: &Structure, point: &PathPoint, shortest: f64) -> Option<Error> {
        self.buffer.copy_from(&point.u);
        self.buffer.axpy(COLLAPSE_AHEAD * shortest, &point.rate, 1.0);
        structure.check_collapse(&self.buffer, &self.buffer, point.load).err()
    }

    /// Whether the displacement from one point to another agrees with the rates at both: |Δu − Δs du/ds| is at most 0.7
    /// |Δu|, or a millionth of the whole displacement; and no element collapses on the way.
    pub fn agree(&mut self, structure: &Structure, from: &PathPoint, to: &PathPoint) -> bool {
        let Equilibrium { buffer, .. } = self;
        buffer.copy_from(&to.u);
        *buffer -= &from.u;
        let moved = structure.displacement_product(buffer, buffer);
        let whole = structure.displacement_product(&to.u, &to.u).max(structure.thermal_stretch(&self.thermal));
        let limit = (AGREEMENT * AGREEMENT * moved).max(NO_JUMP * NO_JUMP * whole);
        [from, to].into_iter().all(|point| {
            buffer.copy_from(&to.u);
            *buffer -= &from.u;
            buffer.axpy(from.load - to.load, &point.rate, 1.0);
            structure.displacement_product(buffer, buffer) <= limit
        }) && structure.check_collapse(&from.u, &to.u, to.load).is_ok()
    }
}

/// Equations at a given load factor.
struct AtLoad<'a> {
    structure: &'a Structure,
    u_0: &'a DVector<f64>,
    largest_load: f64,
    solver: &'a mut Equilibrium,
}

impl Equations for AtLoad<'_> {
    fn residual(&mut self, counts: &mut Counts) -> Residual {
        let Equilibrium { increment, load, thermal, .. } = &mut *self.solver;
        increment.move_from(self.u_0);
        let Increment { u, residual, .. } = increment;
        self.structure.force(u, thermal, residual);
        counts.force_calls += 1;
        let largest_term = self.structure.largest_force(residual).max(self.largest_load);
        *residual -= &*load;
        Residual { size: self.structure.largest_force(residual), largest_term }
    }

    fn at_rounding(&self, times: f64) -> bool {
        self.solver.increment.at_rounding(self.structure, &self.solver.thermal, times)
    }

    fn factorize(&mut self) -> Result<(), SingularAt> {
        let Equilibrium { increment: Increment { u, factors, .. }, before, thermal, .. } = &mut *self.solver;
        self.structure.factorize(Matrix::Mixed { before, u, thermal }, factors)
    }

    fn improve(&mut self) {
        self.solver.before.copy_from(&self.solver.increment.u);
        self.solver.increment.improve();
    }

    fn undo(&mut self) {
        self.solver.increment.undo();
    }
}

/// Error of a path that cannot be followed beyond the load factor `factor`: the last failure, or a jump without one; what
/// collapses before the next equilibrium; and what to do next.
pub fn no_equilibrium(
    failure: Option<Failure>,
    structure: &Structure,
    factor: f64,
    collapsed: Option<Error>,
    advice: &'static str,
) -> Error {
    let reason = match (collapsed, failure) {
        (Some(Error::Collapsed { rod, element, elements, .. }), _) => {
            format!(
                "before the next one, at the present rate, element {element} of {elements} of the rod `{rod}` has collapsed"
            )
        }
        (_, None) => "the next ones found are none to which the structure moves without a jump".into(),
        (_, Some(Failure::NotConverged { iterations, residual, tolerance, .. })) => format!(
            "residual {residual:.3e} of the largest force term after {iterations} iterations (tolerance {tolerance:.1e})"
        ),
        (_, Some(Failure::Singular { at: SingularAt(unknown), .. })) => {
            format!("the tangent is singular at {}", structure.location(unknown))
        }
    };
    Error::NoEquilibrium { factor, reason, advice }
}
