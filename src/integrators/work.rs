//! Work of forces and heat over a step, by Gauss quadrature with two points: fourth order, as the methods that need it.
//!
//! W = ∫ (f·v − ∫ σ : ε̇_T dV) dt. Between the times of a history, force and thermal strain are linear in time; a
//! corner inside a step costs the order there.

use nalgebra::DVector;

use crate::elements::ThermalStrain;
use crate::structure::{StepEnds, Structure};

/// Square root of 3, rounded.
pub const ROOT_3: f64 = 1.732_050_807_568_877_2;

/// Quadrature points, as fractions of the step; each has weight ½.
pub const POINTS: [f64; 2] = [0.5 - ROOT_3 / 6.0, 0.5 + ROOT_3 / 6.0];

/// Buffers for the work over a step.
#[derive(Debug)]
pub struct Work {
    force: DVector<f64>,
    /// Changes of the rods' thermal strains over the step; below, strains with that change whose mean is the strain at
    /// a point.
    change: Vec<ThermalStrain>,
    around: [Vec<ThermalStrain>; 2],
}

impl Work {
    /// Allocates the buffers for a structure.
    pub fn new(structure: &Structure) -> Work {
        let thermal = || structure.thermal_strains(0.0);
        Work { force: DVector::zeros(structure.size()), change: thermal(), around: [thermal(), thermal()] }
    }

    /// Work over the step of length `dt` that ends at `t_1`, J, from displacements and velocities at the [`POINTS`].
    pub fn over_step(
        &mut self,
        structure: &Structure,
        dt: f64,
        t_1: f64,
        u: &[DVector<f64>; 2],
        v: &[DVector<f64>; 2],
    ) -> f64 {
        let Work { force, change, around: [low, high] } = self;
        structure.thermal_strains_into(t_1 - dt, low);
        structure.thermal_strains_into(t_1, high);
        for (change, (low, high)) in change.iter_mut().zip(low.iter().zip(&*high)) {
            *change = [high[0] - low[0], high[1] - low[1]];
        }
        let heats = change.iter().flatten().any(|change| *change != 0.0);
        let mut work = 0.0;
        for (point, c) in POINTS.into_iter().enumerate() {
            let t = t_1 - (1.0 - c) * dt;
            force.fill(0.0);
            structure.add_point_forces(t, 1.0, force);
            work += 0.5 * dt * force.dot(&v[point]);
            if heats {
                structure.thermal_strains_into(t, low);
                for ((low, high), change) in low.iter_mut().zip(&mut *high).zip(&*change) {
                    let here = *low;
                    *low = [here[0] - 0.5 * change[0], here[1] - 0.5 * change[1]];
                    *high = [here[0] + 0.5 * change[0], here[1] + 0.5 * change[1]];
                }
                let ends = StepEnds { u_0: &u[point], u_1: &u[point], thermal_0: low, thermal_1: high };
                work += 0.5 * structure.heating_work(&ends);
            }
        }
        work
    }
}
