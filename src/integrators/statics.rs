//! Statics: equilibrium Q_e(u, s ΔT) = s f, as the load factor s grows from 0 to 1.
//!
//! Newton's iteration with independent stresses (Magisano, Leonetti and Garcea 2017,
//! [`Beam::mixed_tangent`](crate::elements::Beam::mixed_tangent)). In large bending plain Newton needs ever more
//! iterations the more slender a rod is, since its steps must not stretch the axis; with independent stresses a slender
//! rod needs no more than a stubby one.
//!
//! The equilibrium found need not be stable: a perfect column stays straight above its Euler load.

use nalgebra::DVector;

use super::counts::Counts;
use super::increment::Increment;
use super::integrator::Integrator;
use super::newton::{Equations, Failure, Newton, Residual};
use super::state::State;
use crate::elements::ThermalStrain;
use crate::error::{Error, Result};
use crate::linear::SingularAt;
use crate::structure::{Matrix, Structure};

/// Static method: load steps, with the load factor in place of time.
#[derive(Debug)]
pub struct Statics {
    newton: Newton,
    workspace: Workspace,
}

/// Buffers of a load step.
#[derive(Debug)]
struct Workspace {
    /// Unknown increment; that of the last load step is the guess for the next.
    increment: Increment,
    /// Displacement before the last improvement.
    before: DVector<f64>,
    load: DVector<f64>,
    thermal: Vec<ThermalStrain>,
}

impl Statics {
    /// Statics of a structure; [`Newton::with_new_matrices`] converges best.
    pub fn new(structure: &Structure, newton: Newton) -> Statics {
        let zeros = || DVector::zeros(structure.size());
        let workspace = Workspace {
            increment: Increment::new(structure),
            before: zeros(),
            load: zeros(),
            thermal: structure.thermal_strains(0.0),
        };
        Statics { newton, workspace }
    }
}

/// Equations of one load step.
struct StepEquations<'a> {
    structure: &'a Structure,
    u_0: &'a DVector<f64>,
    workspace: &'a mut Workspace,
    largest_load: f64,
    /// Whether an improvement was made, so that `before` is valid.
    improved: bool,
}

impl Equations for StepEquations<'_> {
    fn residual(&mut self, counts: &mut Counts) -> Residual {
        let Workspace { increment, load, thermal, .. } = &mut *self.workspace;
        increment.move_from(self.u_0);
        let Increment { u, residual, .. } = increment;
        self.structure.force(u, thermal, residual);
        counts.force_calls += 1;
        let largest_term = self.structure.largest_force(residual).max(self.largest_load);
        *residual -= &*load;
        Residual { size: self.structure.largest_force(residual), largest_term }
    }

    fn at_rounding(&self, times: f64) -> bool {
        self.workspace.increment.at_rounding(self.structure, &self.workspace.thermal, times)
    }

    fn factorize(&mut self) -> std::result::Result<(), SingularAt> {
        let Workspace { increment: Increment { u, factors, .. }, before, thermal, .. } = &mut *self.workspace;
        let before = if self.improved { &*before } else { &*u };
        self.structure.factorize(Matrix::Mixed { before, u, thermal }, factors)
    }

    fn improve(&mut self) {
        self.workspace.before.copy_from(&self.workspace.increment.u);
        self.improved = true;
        self.workspace.increment.improve();
    }

    fn undo(&mut self) {
        self.workspace.increment.undo();
    }
}

impl Integrator for Statics {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        let Statics { newton, workspace } = self;
        structure.thermal_strains_into(t_1, &mut workspace.thermal);
        structure.load_into(t_1, &mut workspace.load);
        let largest_load = structure.largest_force(&workspace.load);
        let mut step = StepEquations { structure, u_0: &state.u, workspace, largest_load, improved: false };
        newton.solve(&mut step, counts).map_err(|failure| no_equilibrium(failure, structure, t_1))?;
        state.u += &workspace.increment.du;
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}

/// Error of a load step, in terms of loads instead of times.
fn no_equilibrium(failure: Failure, structure: &Structure, factor: f64) -> Error {
    let reason = match failure {
        Failure::NotConverged { iterations, residual, tolerance, .. } => format!(
            "residual {residual:.3e} of the largest force term after {iterations} iterations (tolerance {tolerance:.1e})"
        ),
        Failure::Singular { iteration, at: SingularAt(unknown) } => {
            format!("the tangent is singular at {}, iteration {iteration}", structure.location(unknown))
        }
    };
    Error::NoEquilibrium { factor, reason }
}
