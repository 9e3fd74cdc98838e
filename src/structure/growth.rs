//! Growth of small deviations from a motion.
//!
//! M is constant, so that a small deviation δu of a motion obeys M δü + K(t) δu = 0 with the tangent K. While K stays as
//! it is, a deviation along an eigenvector of K x = λ M x with λ = −μ² grows like e^(μt).

use nalgebra::{DVector, Vector2};

use super::{Factors, Matrix, Structure};
use crate::elements::ThermalStrain;
use crate::linear::{InertiaMemory, SingularAt};

impl Structure {
    /// Number of independent directions in which small deviations grow faster than e^(`rate` t): eigenvalues of K x =
    /// λ M x below −`rate`², 1/s². Counted by the inertia of K + `rate`² M, bordered by the constraints if there are
    /// multipliers. `factors` lend their memory. `None` where elimination meets a pivot of zero.
    pub fn growing_directions(
        &self,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        rate: f64,
        factors: &mut Factors,
    ) -> Option<usize> {
        self.eigenvalues_below(-rate * rate, u, thermal, factors)
    }

    /// Number of eigenvalues of K x = λ M x below `bound`, 1/s²: that of the negative ones of K − `bound` · M.
    pub(super) fn eigenvalues_below(
        &self,
        bound: f64,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        factors: &mut Factors,
    ) -> Option<usize> {
        let shifted = Matrix::Tangent { u, thermal, stiffness: 1.0, mass: -bound };
        match factors {
            Factors::Condensed(chains) => chains.negative_eigenvalues(|rod, element, columns| {
                self.rods[rod].mesh.matrix(element, &shifted.of_rod(rod), columns);
            }),
            Factors::Bordered(_) => {
                let mut sum = self.assemble_matrix(|rod| shifted.of_rod(rod));
                self.add_constraints(1.0, &mut sum);
                // Each independent constraint adds a negative eigenvalue to those of the constrained matrix.
                sum.negative_eigenvalues(&mut InertiaMemory::default())?.checked_sub(self.rows.len())
            }
        }
    }

    /// Small smooth displacement in all directions, consistent with the constraints; the largest one of a node is
    /// `size`, m. It is turned with the structure.
    ///
    /// Every node is displaced at random along and across its rod. M + `period`² K then smooths the displacement:
    /// vibrations of a higher angular frequency than 1/`period` are filtered out.
    ///
    /// # Errors
    /// Unknown of a vanishing pivot.
    pub fn perturbation(&self, size: f64, period: f64) -> Result<DVector<f64>, SingularAt> {
        let mut random = DVector::zeros(self.size());
        let mut number = 0;
        for rod in &*self.rods {
            let along = rod.along.normalize();
            let across = Vector2::new(-along.y, along.x);
            for node in rod.positions() {
                number += 2;
                node.set(&(irregular(number) * along + irregular(number + 1) * across), &mut random);
            }
        }
        let thermal = self.thermal_strains(0.0);
        let mut factors = self.factors();
        let smoothing = Matrix::Tangent { u: self.start(), thermal: &thermal, stiffness: period * period, mass: 1.0 };
        self.factorize(smoothing, &mut factors)?;
        let mut smooth = self.inertia(&random);
        factors.solve(&mut smooth);
        self.take_multipliers(&mut smooth);
        let nodes = self.rods.iter().flat_map(|rod| rod.positions().map(|node| node.get(&smooth).norm()));
        // In the total order NaN is the largest, and is not lost.
        let largest = nodes.max_by(f64::total_cmp).unwrap_or(0.0);
        // Where everything is held nothing can be displaced.
        if largest > 0.0 { Ok(smooth * (size / largest)) } else { Ok(smooth) }
    }
}

/// Numbers between −1 and 1 that hardly repeat: sin(1.7 n²).
fn irregular(n: usize) -> f64 {
    (1.7 * (n * n) as f64).sin()
}
