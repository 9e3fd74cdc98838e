//! Largest eigenvalue of K x = λ M x, from products with K and solutions with M (Lanczos 1950).

use nalgebra::{DMatrix, DVector};

/// Relative accuracy of the eigenvalue: enough for the iteration not to stop at one below the largest.
const TOLERANCE: f64 = 1e-6;

/// Most iterations.
const MOST_ITERATIONS: usize = 200;

/// Iterations between convergence checks.
const CHECK_EVERY: usize = 20;

/// Symmetric matrices K and M, M positive definite.
pub trait Pencil {
    /// Number of unknowns.
    fn size(&self) -> usize;

    /// Product K x, into `product`.
    fn stiffness(&mut self, x: &DVector<f64>, product: &mut DVector<f64>);

    /// Product M x, into `product`.
    fn mass(&mut self, x: &DVector<f64>, product: &mut DVector<f64>);

    /// Solution M⁻¹ x, in place.
    fn solve_mass(&mut self, x: &mut DVector<f64>);
}

/// Largest eigenvalue, and a bound on its error: some eigenvalue lies within that distance for certain. It need not be
/// the largest, since an iteration can linger at one below; the required accuracy makes that unlikely. `None` without
/// convergence.
pub fn largest_eigenvalue(pencil: &mut impl Pencil) -> Option<(f64, f64)> {
    let n = pencil.size();
    // Any start vector without a pattern.
    let mut v = DVector::from_fn(n, |i, _| (1.0 + 12.9898 * i as f64).sin());
    let (mut mass_v, mut before, mut next) = (DVector::zeros(n), DVector::zeros(n), DVector::zeros(n));
    let (mut alphas, mut betas): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    pencil.mass(&v, &mut mass_v);
    let mut beta = v.dot(&mass_v).sqrt();
    for iteration in 1..=MOST_ITERATIONS.min(n) {
        v /= beta;
        mass_v /= beta;
        // M⁻¹ K v, orthogonalised against the last two vectors in the inner product of M.
        pencil.stiffness(&v, &mut next);
        let alpha = v.dot(&next);
        pencil.solve_mass(&mut next);
        next.axpy(-alpha, &v, 1.0);
        if let Some(&beta) = betas.last() {
            next.axpy(-beta, &before, 1.0);
        }
        before.copy_from(&v);
        v.copy_from(&next);
        pencil.mass(&v, &mut mass_v);
        beta = v.dot(&mass_v).max(0.0).sqrt();
        alphas.push(alpha);
        if iteration % CHECK_EVERY == 0 || iteration == n || beta == 0.0 {
            let (eigenvalue, error_bound) = of_tridiagonal(&alphas, &betas, beta)?;
            if error_bound <= TOLERANCE * eigenvalue {
                return Some((eigenvalue, error_bound));
            }
        }
        betas.push(beta);
    }
    None
}

/// Largest eigenvalue of the tridiagonal matrix, and the residual of its eigenvector in the whole space.
fn of_tridiagonal(diagonal: &[f64], off_diagonal: &[f64], next: f64) -> Option<(f64, f64)> {
    let n = diagonal.len();
    let entry = |i: usize, j: usize| match i.abs_diff(j) {
        0 => diagonal[i],
        1 => off_diagonal[i.min(j)],
        _ => 0.0,
    };
    let matrix = DMatrix::from_fn(n, n, entry);
    if !matrix.iter().all(|x| x.is_finite()) {
        return None;
    }
    let eigen = matrix.symmetric_eigen();
    let largest = eigen.eigenvalues.imax();
    Some((eigen.eigenvalues[largest], (next * eigen.eigenvectors[(n - 1, largest)]).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs in a row between equal masses of 2: λ = 4k/m sin²(nπ/2(N + 1)).
    struct Springs(usize);

    impl Pencil for Springs {
        fn size(&self) -> usize {
            self.0
        }

        fn stiffness(&mut self, x: &DVector<f64>, product: &mut DVector<f64>) {
            let at = |i: usize| x.get(i).copied().unwrap_or(0.0);
            *product = DVector::from_fn(self.0, |i, _| 2.0 * at(i) - at(i + 1) - at(i.wrapping_sub(1)));
        }

        fn mass(&mut self, x: &DVector<f64>, product: &mut DVector<f64>) {
            *product = 2.0 * x;
        }

        fn solve_mass(&mut self, x: &mut DVector<f64>) {
            *x /= 2.0;
        }
    }

    #[test]
    fn the_largest_eigenvalue_of_springs_in_a_row() {
        for n in [1, 2, 7, 100] {
            let exact = 2.0 * (0.5 * std::f64::consts::PI * n as f64 / (n + 1) as f64).sin().powi(2);
            let (found, error_bound) = largest_eigenvalue(&mut Springs(n)).unwrap();
            assert!(
                (found - exact).abs() <= error_bound.max(1e-12) && error_bound <= 1e-6 * found,
                "{n}: {found} ± {error_bound}, {exact}"
            );
            assert!(found <= exact * (1.0 + 1e-12));
        }
    }
}
