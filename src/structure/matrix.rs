//! Matrices of a structure, and their factors.

use nalgebra::{Complex, DVector};

use super::rod_elements::ElementMatrix;
use super::{StepEnds, Structure, of_rod};
use crate::elements::ThermalStrain;
use crate::linear::{BlockMut, Bordered, BorderedLu, Chain, CondensedFactors, Number, SingularAt};

/// Matrix to be factorised.
#[derive(Debug)]
pub enum Matrix<'a> {
    /// `stiffness` · tangent (including the constraint forces, with multipliers) + `mass` · M.
    Tangent {
        /// Displacement.
        u: &'a DVector<f64>,
        /// Thermal strains of the rods.
        thermal: &'a [ThermalStrain],
        /// Factor of the tangent.
        stiffness: f64,
        /// Factor of M.
        mass: f64,
    },
    /// Tangent of Newton's iteration with independent stresses: those expected when it went from `before` to `u`
    /// ([`Beam::mixed_tangent`](crate::elements::Beam::mixed_tangent)).
    Mixed {
        /// Displacement before the last iteration.
        before: &'a DVector<f64>,
        /// Displacement.
        u: &'a DVector<f64>,
        /// Thermal strains of the rods.
        thermal: &'a [ThermalStrain],
    },
    /// Derivative of [`mean_force`](Structure::mean_force) with respect to `u_1`, plus `mass` · M.
    Mean {
        /// Both ends of the step.
        ends: StepEnds<'a>,
        /// Factor of M.
        mass: f64,
    },
}

impl<'a> Matrix<'a> {
    pub(super) fn of_rod(&self, rod: usize) -> ElementMatrix<'a> {
        match *self {
            Matrix::Tangent { u, thermal, stiffness, mass } => {
                ElementMatrix::Tangent { u, eps_t: thermal[rod], stiffness, mass }
            }
            Matrix::Mixed { before, u, thermal } => ElementMatrix::Mixed { before, u, eps_t: thermal[rod] },
            Matrix::Mean { ref ends, mass } => ElementMatrix::Mean { ends: of_rod(ends, rod), mass },
        }
    }

    /// Factor of Φ_qᵀ beside the matrix.
    pub(super) fn constraint_factor(&self) -> f64 {
        if let Matrix::Tangent { stiffness, .. } = self { *stiffness } else { 1.0 }
    }
}

/// LU factors of a structure's matrix, or memory for them.
#[derive(Debug)]
pub enum Factors {
    /// Factors in the condensed form.
    Condensed(CondensedFactors),
    /// Factors in the form with multipliers.
    Bordered(Option<BorderedLu>),
}

impl Factors {
    /// Solves A x = b in place. Without factors the solution is NaN.
    pub fn solve(&self, b: &mut DVector<f64>) {
        match self {
            Factors::Condensed(chains) => chains.solve(b),
            Factors::Bordered(Some(factors)) => factors.solve(b),
            Factors::Bordered(None) => b.fill(f64::NAN),
        }
    }
}

/// Number of entries of the largest element's matrix.
const MOST_ENTRIES: usize = 14 * 14;

impl Structure {
    /// Memory of one matrix with its factors, bytes.
    pub fn matrix_bytes(&self) -> usize {
        match self.factors() {
            Factors::Condensed(chains) => chains.bytes(),
            Factors::Bordered(_) => self.layout.bytes(),
        }
    }

    /// Mass matrix of the unknowns.
    pub fn mass(&self) -> Bordered {
        self.assemble_matrix(|_| ElementMatrix::Mass)
    }

    /// Tangent ∂Q/∂u.
    pub fn tangent(&self, u: &DVector<f64>, thermal: &[ThermalStrain]) -> Bordered {
        self.assemble_matrix(|n| ElementMatrix::Tangent { u, eps_t: thermal[n], stiffness: 1.0, mass: 0.0 })
    }

    /// Allocates the factors of a matrix.
    pub fn factors(&self) -> Factors {
        if self.rows.is_empty() {
            let chains = self.rods.iter().map(|rod| rod.mesh.chain(self.layout.border)).collect();
            Factors::Condensed(self.chains(chains))
        } else {
            Factors::Bordered(None)
        }
    }

    /// Allocates the factors of a complex matrix; for the condensed form only.
    pub fn complex_factors(&self) -> CondensedFactors<Complex<f64>> {
        self.chains(self.rods.iter().map(|rod| rod.mesh.complex_chain(self.layout.border)).collect())
    }

    fn chains<F: Number>(&self, chains: Vec<Box<dyn Chain<F>>>) -> CondensedFactors<F> {
        CondensedFactors::new(chains, self.layout.border, self.layout.border_size, self.layout.border_band)
    }

    /// Factorises a matrix.
    ///
    /// # Errors
    /// Unknown of a vanishing pivot; [`location`](Structure::location) describes it.
    pub fn factorize(&self, matrix: Matrix, factors: &mut Factors) -> Result<(), SingularAt> {
        match factors {
            Factors::Condensed(chains) => chains.factorize(|rod, element, columns| {
                self.rods[rod].mesh.matrix(element, &matrix.of_rod(rod), columns);
            }),
            // With multipliers beside coordinates, rows and columns of all blocks must be scaled first.
            Factors::Bordered(factors) => {
                let mut sum = self.assemble_matrix(|rod| matrix.of_rod(rod));
                self.add_constraints(matrix.constraint_factor(), &mut sum);
                *factors = Some(sum.equilibrated_lu()?);
                Ok(())
            }
        }
    }

    /// Factorises M + `stiffness` · tangent for a complex `stiffness`, in the condensed form.
    ///
    /// # Errors
    /// Those of [`factorize`](Structure::factorize).
    pub fn factorize_complex(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        stiffness: Complex<f64>,
        factors: &mut CondensedFactors<Complex<f64>>,
    ) -> Result<(), SingularAt> {
        factors.factorize(|rod, element, columns| {
            let mesh = &self.rods[rod].mesh;
            let mut real = [0.0; MOST_ENTRIES];
            let real = &mut real[..columns.len()];
            let tangent = ElementMatrix::Tangent { u, eps_t: thermal[rod], stiffness: 1.0, mass: 0.0 };
            mesh.matrix(element, &tangent, real);
            columns.iter_mut().zip(&*real).for_each(|(entry, real)| *entry = stiffness * *real);
            mesh.matrix(element, &ElementMatrix::Mass, real);
            columns.iter_mut().zip(&*real).for_each(|(entry, real)| *entry += *real);
        })
    }

    /// Adds the matrices of a rod's elements to its block.
    fn fill(&self, n: usize, matrix: &ElementMatrix, block: &mut BlockMut) {
        self.rods[n].mesh.add_matrix(matrix, block);
    }

    /// Sum of all elements' matrices; `matrix` chooses one by the number of the rod.
    pub(super) fn assemble_matrix<'a>(&self, matrix: impl Fn(usize) -> ElementMatrix<'a>) -> Bordered {
        let mut sum = Bordered::zeros(&self.layout);
        self.assemble_matrix_into(matrix, &mut sum);
        sum
    }

    /// Sum of all elements' matrices, into a matrix of the structure's layout.
    pub(super) fn assemble_matrix_into<'a>(&self, matrix: impl Fn(usize) -> ElementMatrix<'a>, sum: &mut Bordered) {
        sum.clear();
        for n in 0..self.rods.len() {
            self.fill(n, &matrix(n), &mut sum.block(n));
        }
    }
}
