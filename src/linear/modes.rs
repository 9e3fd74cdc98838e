//! Smallest eigenvalues of K x = ω² M x with their vectors, by subspace iteration (Bathe and Wilson 1972).

use nalgebra::{DMatrix, DVector};

/// Relative change of an eigenvalue from one iteration to the next at which it has converged: above the rounding of a
/// slender rod's, and its vector is then known to 1e-5.
const TOLERANCE: f64 = 1e-10;

/// Most iterations.
const MOST_ITERATIONS: usize = 200;

/// Vectors beyond the wanted ones: convergence is as fast as the ratio of the last wanted eigenvalue to the first left out.
const MORE_VECTORS: usize = 8;

/// Eigenvalues ω² in ascending order, and their vectors, which are normalised by xᵀ M x = 1.
#[derive(Clone, Debug)]
pub struct Modes {
    /// ω², (rad/s)².
    pub squares: Vec<f64>,
    /// Vectors.
    pub shapes: Vec<DVector<f64>>,
}

/// The `wanted` smallest eigenvalues of matrices of `size` rows, or all of them. `mass` is the product M x, and
/// `solve` replaces x by K⁻¹ x. `None` without convergence.
pub fn smallest_modes(
    size: usize,
    wanted: usize,
    mass: impl Fn(&DVector<f64>) -> DVector<f64>,
    solve: impl Fn(&mut DVector<f64>),
) -> Option<Modes> {
    let wanted = wanted.min(size);
    let number = (2 * wanted + MORE_VECTORS).min(size);
    // Any start vectors without a pattern.
    let start =
        |n: usize| DVector::from_fn(size, |i, _| (1.0 + 12.9898 * i as f64 + 78.233 * n as f64 * (i + 1) as f64).sin());
    let mut shapes: Vec<DVector<f64>> = (0..number).map(start).collect();
    let mut squares: Vec<f64> = Vec::new();
    for _ in 0..MOST_ITERATIONS {
        // Y = K⁻¹ M X; Yᵀ K Y and Yᵀ M Y are the matrices of the subspace.
        let loads: Vec<DVector<f64>> = shapes.iter().map(&mass).collect();
        let mut moved = loads.clone();
        moved.iter_mut().for_each(&solve);
        let momenta: Vec<DVector<f64>> = moved.iter().map(&mass).collect();
        let product = |a: &[DVector<f64>], b: &[DVector<f64>]| DMatrix::from_fn(number, number, |i, j| a[i].dot(&b[j]));
        let (stiffness, inertia) = (product(&moved, &loads), product(&moved, &momenta));
        let (found, vectors) = eigen(stiffness, inertia)?;
        let mix = |n: usize| {
            moved.iter().enumerate().fold(DVector::zeros(size), |sum, (i, moved)| sum + moved * vectors[(i, n)])
        };
        shapes = (0..number).map(mix).collect();
        let same = |(old, new): (&f64, &f64)| (old - new).abs() <= TOLERANCE * new.abs();
        let has_converged = !squares.is_empty() && squares.iter().zip(&found).take(wanted).all(same);
        squares = found;
        if has_converged {
            squares.truncate(wanted);
            shapes.truncate(wanted);
            return Some(Modes { squares, shapes });
        }
    }
    None
}

/// Eigenvalues of a small pencil in ascending order, and its vectors as columns.
fn eigen(stiffness: DMatrix<f64>, inertia: DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    // Vectors of one size, so that the Cholesky factor keeps its digits.
    let scale = inertia.diagonal().map(|m| 1.0 / m.sqrt());
    let scaled = |matrix: DMatrix<f64>| {
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| scale[i] * matrix[(i, j)] * scale[j])
    };
    let lower = scaled(inertia).cholesky()?.l();
    let half = lower.solve_lower_triangular(&scaled(stiffness))?;
    let reduced = lower.solve_lower_triangular(&half.transpose())?;
    if !reduced.iter().all(|x| x.is_finite()) {
        return None;
    }
    let eigen = (0.5 * (&reduced + reduced.transpose())).symmetric_eigen();
    let mut order: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let vectors = lower.tr_solve_lower_triangular(&eigen.eigenvectors)?;
    let vectors = DMatrix::from_fn(vectors.nrows(), order.len(), |i, n| scale[i] * vectors[(i, order[n])]);
    Some((order.iter().map(|n| eigen.eigenvalues[*n]).collect(), vectors))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs k = 1 in a row between N masses of 2, both ends held: ω² = 4k/m sin²(nπ/2(N + 1)), shapes sin(inπ/(N + 1)).
    #[test]
    fn the_slowest_vibrations_of_springs_in_a_row() {
        for size in [1, 2, 7, 100] {
            let springs = DMatrix::from_fn(size, size, |i, j| match i.abs_diff(j) {
                0 => 2.0,
                1 => -1.0,
                _ => 0.0,
            });
            let factor = springs.cholesky().unwrap();
            let modes = smallest_modes(size, 3, |x| 2.0 * x, |x| factor.solve_mut(x)).unwrap();
            assert_eq!(modes.shapes.len(), size.min(3));
            for (n, (square, shape)) in modes.squares.iter().zip(&modes.shapes).enumerate() {
                let angle = std::f64::consts::PI * (n + 1) as f64 / (size + 1) as f64;
                let exact = 2.0 * (0.5 * angle).sin().powi(2);
                assert!((square - exact).abs() <= 1e-12, "{size}, {n}: {square} {exact}");
                let expected = DVector::from_fn(size, |i, _| ((i + 1) as f64 * angle).sin()).normalize();
                let found = shape.normalize();
                let off = (&found - &expected).amax().min((&found + &expected).amax());
                assert!(off <= 1e-6, "{size}, {n}: {off:.1e}");
            }
        }
    }
}
