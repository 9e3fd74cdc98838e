//! Equation of motion M q̈ = Q_w − Q_e(q, ΔT), solved for accelerations.

use nalgebra::DVector;

use super::counts::Counts;
use crate::elements::ThermalStrain;
use crate::error::{Error, Result};
use crate::linear::SingularAt;
use crate::structure::{MassFactors, Structure};

/// Equation of motion, ready to be solved for one acceleration after the other.
///
/// ```
/// use ancf::integrators::{Counts, EquationOfMotion};
/// use ancf::{model::Scene, run::Simulation};
///
/// let pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap().build()?)?;
/// let mut counts = Counts::default();
/// let mut motion = EquationOfMotion::new(pendulum.structure(), &mut counts)?;
/// motion.accelerate(pendulum.structure(), &pendulum.state().u, 0.0, &mut counts);
/// assert_eq!((motion.a.len(), counts.factorizations, counts.force_calls), (pendulum.state().u.len(), 1, 1));
/// # Ok::<(), ancf::error::Error>(())
/// ```
#[derive(Debug)]
pub struct EquationOfMotion {
    mass: MassFactors,
    /// Last acceleration; with multipliers in their entries, if there are any.
    pub a: DVector<f64>,
    thermal: Vec<ThermalStrain>,
}

impl EquationOfMotion {
    /// Factorises the mass matrix, bordered by the constraints if there are multipliers.
    ///
    /// # Errors
    /// [`Error::Singular`] for a singular mass matrix.
    pub fn new(structure: &Structure, counts: &mut Counts) -> Result<EquationOfMotion> {
        let thermal = structure.thermal_strains(0.0);
        counts.factorizations += 1;
        let mass = structure.factorize_mass().map_err(|at| singular_mass(structure, at))?;
        Ok(EquationOfMotion { mass, a: DVector::zeros(structure.size()), thermal })
    }

    /// Computes the acceleration at displacement `u` and time `t`, into [`a`](EquationOfMotion::a).
    ///
    /// With multipliers it solves M q̈ + Φ_qᵀ λ = Q_w − Q_e and Φ_q q̈ = 0, the second time derivative of Φ(q) = 0 for
    /// constraints that are linear in q.
    pub fn accelerate(&mut self, structure: &Structure, u: &DVector<f64>, t: f64, counts: &mut Counts) {
        structure.thermal_strains_into(t, &mut self.thermal);
        structure.load_into(t, &mut self.a);
        structure.add_force(u, &self.thermal, -1.0, &mut self.a);
        self.mass.solve(&mut self.a);
        counts.force_calls += 1;
        counts.solves += 1;
    }
}

/// Refuses an explicit step above the stability limit `limit`/ω for the largest angular frequency ω.
pub fn check_step(structure: &Structure, method: &str, step: f64, limit: f64) -> Result<()> {
    let frequency = structure.largest_frequency().map_err(|at| singular_mass(structure, at))?;
    let largest = limit / frequency;
    // A limit that is not a number is refused too.
    if step > largest || largest.is_nan() {
        return Err(Error::StepTooLarge { method: method.into(), step, largest, frequency, limit });
    }
    Ok(())
}

fn singular_mass(structure: &Structure, SingularAt(unknown): SingularAt) -> Error {
    Error::Singular { time: 0.0, iteration: 0, place: structure.location(unknown) }
}
