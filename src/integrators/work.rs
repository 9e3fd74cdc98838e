//! Work of forces and heat over a step, by Gauss's rule with two points: of order four, as the methods are that ask for it.
//!
//! W = ∫ (f·v − ∫ σ : ε̇_T dV) dt. Between two times of a history force and thermal strain are linear in time; where a corner of one
//! lies inside of a step the order is lost there.

use nalgebra::DVector;

use crate::elements::ThermalStrain;
use crate::structure::{StepEnds, Structure};

const ROOT_3: f64 = 1.732_050_807_568_877_2;

/// Where the two points are in the step; each has half of the weight.
pub const POINTS: [f64; 2] = [0.5 - ROOT_3 / 6.0, 0.5 + ROOT_3 / 6.0];

/// What is computed with.
#[derive(Debug)]
pub struct Work {
    force: DVector<f64>,
    /// Of the rods: its change over the step, and what makes the stress at a point with that change around it.
    change: Vec<ThermalStrain>,
    around: [Vec<ThermalStrain>; 2],
}

impl Work {
    /// Workspace for a structure's steps.
    pub fn new(structure: &Structure) -> Work {
        let thermal = || structure.thermal_strains(0.0);
        Work { force: DVector::zeros(structure.size()), change: thermal(), around: [thermal(), thermal()] }
    }

    /// The work over the step that ends at `t_1` and is `dt` long, J, from displacements and velocities at the [`POINTS`].
    pub fn of(
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
