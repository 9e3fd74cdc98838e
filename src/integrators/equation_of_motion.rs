//! The equation of motion M q̈ = Q_w − Q_e(q, ΔT), solved for accelerations.

use nalgebra::DVector;

use super::counts::Counts;
use crate::elements::ThermalStrain;
use crate::error::{Error, Result};
use crate::linear::SingularAt;
use crate::structure::{MassFactors, Structure};

/// Factors of the mass matrix, with the constraints beside and below it where there are multipliers.
///
/// # Errors
/// [`Error::Singular`].
pub fn mass_factors(structure: &Structure, counts: &mut Counts) -> Result<MassFactors> {
    counts.factorizations += 1;
    structure.factorize_mass().map_err(|at| singular_mass(structure, at))
}

fn singular_mass(structure: &Structure, SingularAt(unknown): SingularAt) -> Error {
    Error::Singular { time: 0.0, iteration: 0, place: structure.place(unknown) }
}

/// Accelerations, and multipliers λ in their places, from the equation of motion:
/// M q̈ + Φ_qᵀ λ = Q_w − Q_e with Φ_q q̈ = 0, the second derivative of Φ(q) = 0 for constraints that are linear in q.
pub fn acceleration(
    structure: &Structure,
    mass: &mut MassFactors,
    u: &DVector<f64>,
    t: f64,
    counts: &mut Counts,
) -> DVector<f64> {
    let mut force = DVector::zeros(structure.size());
    structure.force(u, &structure.thermal_strains(t), &mut force);
    let mut a = structure.load(t) - force;
    mass.solve(&mut a);
    counts.force_calls += 1;
    counts.solves += 1;
    a
}

/// The equation of motion, ready to be asked for one acceleration after the other.
#[derive(Debug)]
pub struct EquationOfMotion {
    mass: MassFactors,
    /// The last acceleration; multipliers, if there are any, in their places.
    pub a: DVector<f64>,
    force: DVector<f64>,
    thermal: Vec<ThermalStrain>,
}

impl EquationOfMotion {
    /// The equation with the factors of its mass matrix.
    ///
    /// # Errors
    /// [`Error::Singular`].
    pub fn new(structure: &Structure, counts: &mut Counts) -> Result<EquationOfMotion> {
        let zeros = || DVector::zeros(structure.size());
        let thermal = structure.thermal_strains(0.0);
        Ok(EquationOfMotion { mass: mass_factors(structure, counts)?, a: zeros(), force: zeros(), thermal })
    }

    /// The acceleration at a displacement and a time into `a`.
    pub fn accelerate(&mut self, structure: &Structure, u: &DVector<f64>, t: f64, counts: &mut Counts) {
        structure.thermal_strains_into(t, &mut self.thermal);
        structure.force(u, &self.thermal, &mut self.force);
        structure.load_into(t, &mut self.a);
        self.a -= &self.force;
        self.mass.solve(&mut self.a);
        counts.force_calls += 1;
        counts.solves += 1;
    }
}

/// Refuses an explicit step over the stability limit `limit`/ω of the largest frequency ω.
pub fn check_step(structure: &Structure, method: &str, step: f64, limit: f64) -> Result<()> {
    let frequency = structure.largest_frequency().map_err(|at| singular_mass(structure, at))?;
    let largest = limit / frequency;
    // A limit that is not a number is refused too.
    if step > largest || largest.is_nan() {
        return Err(Error::StepTooLarge { method: method.into(), step, largest, frequency, limit });
    }
    Ok(())
}
