//! Stability of static equilibria, by the inertia of the tangent.

use nalgebra::DVector;

use super::Structure;
use super::rod_elements::ElementMatrix;
use super::unknown_kind::UnknownKind;
use crate::elements::ThermalStrain;
use crate::linear::{Bordered, InertiaMemory};

/// Shift of the tangent's diagonal where elimination meets a zero pivot, relative to the stiffness of a unit strain.
const SHIFT: f64 = 1e-12;

/// Counts unstable directions, with the memory that this takes.
#[derive(Debug)]
pub struct StabilityCounter {
    tangent: Bordered,
    thermal: Vec<ThermalStrain>,
    memory: InertiaMemory,
    shift: DVector<f64>,
}

impl StabilityCounter {
    /// Allocates the memory for a structure.
    pub fn new(structure: &Structure) -> StabilityCounter {
        // Stiffness: force of a unit strain over the element's length, or moment of a unit slope.
        let stiffness = |(force, kind): (&f64, &UnknownKind)| match kind {
            UnknownKind::Position => SHIFT * force / structure.shortest_element,
            UnknownKind::Slope(_) => SHIFT * force,
            UnknownKind::Multiplier => 0.0,
        };
        let shift = structure.unit_forces.iter().zip(&structure.kinds).map(stiffness);
        StabilityCounter {
            tangent: Bordered::zeros(&structure.layout),
            thermal: structure.thermal_strains(0.0),
            memory: InertiaMemory::default(),
            shift: DVector::from_iterator(structure.size(), shift),
        }
    }

    /// Number of independent directions in which the equilibrium at the load factor `load` is unstable: negative
    /// eigenvalues of the tangent; where elimination meets a pivot of exactly zero, the larger count of two tangents
    /// shifted to either side. `None` where numbers have left their range.
    pub fn unstable_directions(&mut self, structure: &Structure, u: &DVector<f64>, load: f64) -> Option<usize> {
        let StabilityCounter { tangent, thermal, memory, shift } = self;
        structure.thermal_strains_into(load, thermal);
        let of_rod = |n: usize| ElementMatrix::Tangent { u, eps_t: thermal[n], stiffness: 1.0, mass: 0.0 };
        structure.assemble_matrix_into(of_rod, tangent);
        tangent.negative_eigenvalues_near(shift, memory)
    }
}
