//! Interface to the elements of one rod, of any type.

use std::fmt::Debug;

use nalgebra::{Complex, DVector, Vector2};

use super::node_dofs::NodeDofs;
use crate::elements::{Ends, NodalVector, SectionState, ThermalStrain};
use crate::linear::{BlockMut, Chain};

/// Matrix of an element; vectors are those of the whole structure.
pub(super) enum ElementMatrix<'a> {
    Mass,
    /// `stiffness` · tangent + `mass` · M, at the displacement `u`.
    Tangent {
        u: &'a DVector<f64>,
        eps_t: ThermalStrain,
        stiffness: f64,
        mass: f64,
    },
    /// `stiffness` · tangent + `mass` · M, with every element at these stretches minus 1.
    Stretched {
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        stiffness: f64,
        mass: f64,
    },
    /// Tangent with independent stresses, [`Beam::mixed_tangent`](crate::elements::Beam::mixed_tangent).
    Mixed {
        before: &'a DVector<f64>,
        u: &'a DVector<f64>,
        eps_t: ThermalStrain,
    },
    /// Step-averaged tangent, [`Beam::mean_tangent`](crate::elements::Beam::mean_tangent), plus `mass` · M.
    Mean {
        ends: Ends<'a, DVector<f64>>,
        mass: f64,
    },
}

impl ElementMatrix<'_> {
    /// Factor of the stiffness of a constant stress, which no displacement changes. 0 for rods whose stretch is given: they
    /// are straight.
    pub fn share_of_stress(&self) -> f64 {
        match *self {
            ElementMatrix::Mass | ElementMatrix::Stretched { .. } => 0.0,
            ElementMatrix::Tangent { stiffness, .. } => stiffness,
            ElementMatrix::Mixed { .. } => 1.0,
            // It acts in the middle of the step, and half of that is its end.
            ElementMatrix::Mean { .. } => 0.5,
        }
    }
}

/// Elements of a rod, of any type.
pub(super) trait RodElements: Debug + Send + Sync {
    /// Nodal vectors of one element.
    fn vectors(&self) -> &'static [NodalVector];

    /// Force (N) of a unit axial strain, or of a unit slope where that needs more.
    fn unit_force(&self) -> f64;

    /// Least magnitude of the numbers whose differences are strains.
    fn rounding_scale(&self) -> f64;

    /// Stretches minus 1 (along, across) at which a thermal strain causes no stress.
    fn stress_free(&self, eps_t: ThermalStrain) -> [f64; 2];

    /// Takes the unknowns from the rod's chain of nodal vectors.
    fn number(&mut self, chain: &[NodeDofs]);

    /// Makes the shape at the displacement `u` stress-free; once, after numbering. Only for elements that can be deviated
    /// ([`Beam::deviation`](crate::elements::Beam::deviation)), as a checked model has them.
    fn deviate(&mut self, u: &DVector<f64>);

    /// Allocates the factors of the rod's matrix; unknowns from `border` on are shared.
    fn chain(&self, border: usize) -> Box<dyn Chain<f64>>;

    /// Allocates the factors of a complex matrix of the rod.
    fn complex_chain(&self, border: usize) -> Box<dyn Chain<Complex<f64>>>;

    /// Largest memory of the factors per element, bytes.
    fn bytes_each(&self) -> usize;

    /// Displacement of the axis, `place` elements from the rod's first point.
    fn axis(&self, place: f64, u: &DVector<f64>) -> Vector2<f64>;

    /// State of the section, `place` elements from the rod's first point; between two elements the mean of both.
    fn section_state(&self, place: f64, u: &DVector<f64>) -> SectionState;

    /// Entry of an element's M that couples two of its nodal vectors, kg: M does not couple x with y, and is the same
    /// for both.
    fn mass(&self, row: usize, column: usize) -> f64;

    /// Adds M a.
    fn add_inertia(&self, a: &DVector<f64>, sum: &mut DVector<f64>);

    /// Adds the generalized force of gravity.
    fn add_gravity(&self, sum: &mut DVector<f64>);

    /// Adds `factor` times the elastic forces.
    fn add_force(&self, u: &DVector<f64>, eps_t: ThermalStrain, factor: f64, sum: &mut DVector<f64>);

    /// Adds the step-averaged elastic forces.
    fn add_mean_force(&self, ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>);

    /// Matrix of one element, by columns.
    fn matrix(&self, element: usize, matrix: &ElementMatrix, columns: &mut [f64]);

    /// Adds the elements' matrices to the rod's block.
    fn add_matrix(&self, matrix: &ElementMatrix, block: &mut BlockMut);

    /// Force M a + Q_e − `weight` · Q_w on one nodal vector, N.
    fn force_at(&self, vector: usize, now: &RodInstant) -> Vector2<f64>;

    /// First element that has collapsed.
    fn collapsed(&self, before: &DVector<f64>, u: &DVector<f64>) -> Option<usize>;

    /// Strain energy, J.
    fn energy(&self, u: &DVector<f64>, eps_t: ThermalStrain) -> f64;

    /// Energy supplied by heating over a step, J.
    fn heating_work(&self, ends: &Ends<DVector<f64>>) -> f64;

    /// Largest ω² of a free element, (rad/s)², at stretches minus 1 (along, across) and a thermal strain. NaN where M
    /// is not positive definite.
    fn largest_square_frequency(&self, stretch: [f64; 2], eps_t: ThermalStrain) -> f64;

    /// Adds K x, with every element at these stretches minus 1 and this thermal strain.
    fn add_stretched_stiffness(
        &self,
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        x: &DVector<f64>,
        sum: &mut DVector<f64>,
    );
}

/// State of a rod at an instant, for forces on its nodes.
pub(super) struct RodInstant<'a> {
    pub u: &'a DVector<f64>,
    pub a: &'a DVector<f64>,
    pub eps_t: ThermalStrain,
    pub weight: f64,
}
