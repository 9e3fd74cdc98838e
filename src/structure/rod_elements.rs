//! What is asked of the elements of one rod, of whatever kind.

use std::fmt::Debug;

use nalgebra::{Complex, DVector, Vector2};

use super::node_dofs::NodeDofs;
use crate::elements::{Ends, NodalVector, ThermalStrain};
use crate::linear::{Chain, Filling};

/// Which matrix of an element is asked for; vectors are those of the whole structure.
pub(super) enum ElementMatrix<'a> {
    Mass,
    /// `stiffness` · tangent + `mass` · M.
    Tangent {
        u: &'a DVector<f64>,
        eps_t: ThermalStrain,
        stiffness: f64,
        mass: f64,
    },
    /// The same of every element at these stretches less 1.
    Stretched {
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        stiffness: f64,
        mass: f64,
    },
    /// [`Beam::mixed_tangent`](crate::elements::Beam::mixed_tangent).
    Mixed {
        before: &'a DVector<f64>,
        u: &'a DVector<f64>,
        eps_t: ThermalStrain,
    },
    /// [`Beam::mean_tangent`](crate::elements::Beam::mean_tangent) + `mass` · M.
    Mean {
        ends: Ends<'a, DVector<f64>>,
        mass: f64,
    },
}

/// What is asked of the elements of a rod.
pub(super) trait RodElements: Debug + Send + Sync {
    /// The nodal vectors of one element.
    fn vectors(&self) -> &'static [NodalVector];

    /// Force (N) of an axial strain of 1, or of a slope of 1 where that takes more.
    fn unit_force(&self) -> f64;

    /// Least size of the numbers that a strain is the difference of.
    fn rounded(&self) -> f64;

    /// Stretches less 1 (along, across) at which a thermal strain makes no stress.
    fn stress_free(&self, eps_t: ThermalStrain) -> [f64; 2];

    /// Takes the unknowns' numbers from the rod's chain of nodal vectors.
    fn number(&mut self, chain: &[NodeDofs]);

    /// Memory for the factors of its matrix; unknowns from `border` on are shared.
    fn chain(&self, border: usize) -> Box<dyn Chain<f64>>;

    /// The same for a complex matrix.
    fn complex_chain(&self, border: usize) -> Box<dyn Chain<Complex<f64>>>;

    /// Memory that the factors take for each element at most, bytes.
    fn bytes_each(&self) -> usize;

    /// Displacement of the axis, `place` elements from the rod's beginning.
    fn axis(&self, place: f64, u: &DVector<f64>) -> Vector2<f64>;

    /// The entry of an element's M that couples two of its nodal vectors, kg: M couples neither x with y nor tells them apart.
    fn mass(&self, row: usize, column: usize) -> f64;

    /// Adds M a.
    fn add_inertia(&self, a: &DVector<f64>, sum: &mut DVector<f64>);

    /// Adds the generalized force of gravity.
    fn add_gravity(&self, sum: &mut DVector<f64>);

    /// Adds the elastic forces.
    fn add_force(&self, u: &DVector<f64>, eps_t: ThermalStrain, sum: &mut DVector<f64>);

    /// Adds the step-averaged elastic forces.
    fn add_mean_force(&self, ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>);

    /// One element's matrix, by columns.
    fn matrix(&self, element: usize, matrix: &ElementMatrix, columns: &mut [f64]);

    /// Adds the elements' matrices to the rod's block.
    fn add_matrix(&self, matrix: &ElementMatrix, block: &mut Filling);

    /// M a + Q_e − `weight` · Q_w at one nodal vector, N.
    fn force_at(&self, vector: usize, now: &Loaded) -> Vector2<f64>;

    /// The first element that has collapsed.
    fn collapsed(&self, before: &DVector<f64>, u: &DVector<f64>) -> Option<usize>;

    /// Strain energy, J.
    fn energy(&self, u: &DVector<f64>, eps_t: ThermalStrain) -> f64;

    /// Energy that heating puts in over a step, J.
    fn heating_work(&self, ends: &Ends<DVector<f64>>) -> f64;

    /// The largest ω² of an element taken free, (rad/s)², at stretches less 1 (along, across) and a thermal strain. NaN where M is
    /// not positive definite.
    fn largest_square_frequency(&self, stretch: [f64; 2], eps_t: ThermalStrain) -> f64;

    /// Adds K x, every element at these stretches less 1 and this thermal strain.
    fn add_stretched_stiffness(
        &self,
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        x: &DVector<f64>,
        sum: &mut DVector<f64>,
    );
}

/// What acts on a rod at an instant.
pub(super) struct Loaded<'a> {
    pub u: &'a DVector<f64>,
    pub a: &'a DVector<f64>,
    pub eps_t: ThermalStrain,
    pub weight: f64,
}
