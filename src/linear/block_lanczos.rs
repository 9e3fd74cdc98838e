//! Largest eigenvalues of an operator A that is self-adjoint in an inner product xᵀ B y, with their vectors: block Lanczos with
//! full orthogonalisation (Golub and Underwood 1977).
//!
//! Vectors are taken one by one: A v is made orthogonal to all vectors so far, and what is left is one more. A block of start
//! vectors finds an eigenvalue as many times as there are vectors in it. In a small problem the vectors become a basis of the
//! whole space, and its eigenvalues those of a dense matrix.

use nalgebra::{DMatrix, DVector};

/// Residual of an eigenvector over its eigenvalue. The eigenvalue is known to the square of it.
const TOLERANCE: f64 = 1e-10;

/// Part of a vector, orthogonal to all before, below which it is one of theirs up to rounding.
const DEPENDENT: f64 = 1e-12;

/// Most vectors.
const MOST_VECTORS: usize = 400;

/// Vectors between convergence checks.
const CHECK_EVERY: usize = 8;

/// Eigenvalues in descending order, and their vectors, which are normalised by xᵀ B x = 1.
#[derive(Clone, Debug, Default)]
pub struct Eigenpairs {
    /// Eigenvalues.
    pub values: Vec<f64>,
    /// Vectors.
    pub vectors: Vec<DVector<f64>>,
}

/// The `wanted` largest eigenvalues, or all of them, from a block of `block` start vectors. `operator` is the product A x and
/// `inner` the product B x. An eigenvalue that is more than `block`-fold may be found fewer times than it is there. `None` without
/// convergence.
pub fn largest_eigenvalues(
    size: usize,
    wanted: usize,
    block: usize,
    mut operator: impl FnMut(&DVector<f64>) -> DVector<f64>,
    inner: impl Fn(&DVector<f64>) -> DVector<f64>,
) -> Option<Eigenpairs> {
    let wanted = wanted.min(size);
    let mut basis = Basis { inner, vectors: Vec::new() };
    for n in 0..block.min(size) {
        // Any vectors without a pattern; the operator takes out of them what is far from the wanted ones.
        let start = |i: usize, _| (1.0 + 12.9898 * i as f64 + 78.233 * n as f64 * (i + 1) as f64).sin();
        basis.add(operator(&DVector::from_fn(size, start)));
    }
    let mut columns: Vec<Vec<f64>> = Vec::new();
    while columns.len() < basis.vectors.len().min(MOST_VECTORS) {
        let image = operator(&basis.vectors[columns.len()]);
        columns.push(basis.add(image));
        let is_complete = columns.len() == basis.vectors.len();
        if is_complete || (columns.len() >= wanted && columns.len().is_multiple_of(CHECK_EVERY)) {
            let (values, vectors) = projected(&columns)?;
            let wanted = wanted.min(values.len());
            if (0..wanted).all(|n| residual(&columns, &vectors, n) <= TOLERANCE * values[0].abs()) {
                let combined = |n: usize| {
                    let parts = basis.vectors.iter().enumerate();
                    parts.take(columns.len()).fold(DVector::zeros(size), |sum, (i, own)| sum + vectors[(i, n)] * own)
                };
                return Some(Eigenpairs {
                    values: values[..wanted].to_vec(),
                    vectors: (0..wanted).map(combined).collect(),
                });
            }
        }
    }
    None
}

/// Vectors with xᵀ B y = 0, xᵀ B x = 1.
struct Basis<I> {
    inner: I,
    vectors: Vec<DVector<f64>>,
}

impl<I: Fn(&DVector<f64>) -> DVector<f64>> Basis<I> {
    /// Adds what is left of a vector, if anything; returns the vector's components.
    fn add(&mut self, mut vector: DVector<f64>) -> Vec<f64> {
        let mut components = vec![0.0; self.vectors.len()];
        let mut dual = (self.inner)(&vector);
        let whole = vector.dot(&dual).max(0.0).sqrt();
        // What rounding leaves of the first pass the second one takes.
        for _ in 0..2 {
            let parts: Vec<f64> = self.vectors.iter().map(|own| own.dot(&dual)).collect();
            for ((own, part), component) in self.vectors.iter().zip(&parts).zip(&mut components) {
                vector.axpy(-part, own, 1.0);
                *component += part;
            }
            dual = (self.inner)(&vector);
        }
        let rest = vector.dot(&dual).max(0.0).sqrt();
        if rest > DEPENDENT * whole {
            components.push(rest);
            self.vectors.push(vector / rest);
        }
        components
    }
}

/// Eigenvalues of the operator within the first vectors, in descending order, and their vectors as columns.
fn projected(columns: &[Vec<f64>]) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = columns.len();
    let entry = |i: usize, j: usize| columns[j].get(i).copied().unwrap_or(0.0);
    let matrix = DMatrix::from_fn(size, size, |i, j| 0.5 * (entry(i, j) + entry(j, i)));
    if !matrix.iter().all(|x| x.is_finite()) {
        return None;
    }
    let eigen = matrix.symmetric_eigen();
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
    let values = order.iter().map(|n| eigen.eigenvalues[*n]).collect();
    Some((values, eigen.eigenvectors.select_columns(&order)))
}

/// Part of A x outside the first vectors, for an eigenvector x within them.
fn residual(columns: &[Vec<f64>], vectors: &DMatrix<f64>, n: usize) -> f64 {
    let size = columns.len();
    let mut outside: Vec<f64> = Vec::new();
    for (column, part) in columns.iter().zip(vectors.column(n).iter()) {
        for (i, component) in column.iter().skip(size).enumerate() {
            outside.resize(outside.len().max(i + 1), 0.0);
            outside[i] += component * part;
        }
    }
    outside.iter().map(|part| part * part).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs in a row between N masses of 2, both ends held: 1/ω² with ω² = 4k/m sin²(nπ/2(N + 1)). Two such rows beside one
    /// another have every eigenvalue twice.
    #[test]
    fn eigenvalues_of_springs_in_a_row_once_and_twice() {
        for (length, rows) in [(1, 1), (7, 1), (100, 1), (100, 2)] {
            let size = rows * length;
            let springs = DMatrix::from_fn(size, size, |i, j| match i.abs_diff(j) {
                0 => 2.0,
                1 if i / length == j / length => -1.0,
                _ => 0.0,
            });
            let factor = springs.cholesky().unwrap();
            let inverse = |x: &DVector<f64>| factor.solve(&(2.0 * x));
            let found = largest_eigenvalues(size, 6, 3, inverse, |x| 2.0 * x).unwrap();
            assert_eq!(found.vectors.len(), size.min(6));
            for (n, (value, vector)) in found.values.iter().zip(&found.vectors).enumerate() {
                let angle = std::f64::consts::PI * (n / rows + 1) as f64 / (length + 1) as f64;
                let exact = 0.5 / (0.5 * angle).sin().powi(2);
                assert!((value / exact - 1.0).abs() <= 1e-11, "{length}, {n}: {value} {exact}");
                let rest = (inverse(vector) - *value * vector).norm();
                assert!(rest <= 1e-9 * found.values[0], "{length}, {n}: {rest:.1e}");
                assert!((2.0 * vector.dot(vector) - 1.0).abs() <= 1e-12);
            }
        }
    }

    #[test]
    fn an_operator_that_is_not_finite_has_no_eigenvalues() {
        assert!(largest_eigenvalues(3, 1, 1, |x| f64::NAN * x, Clone::clone).is_none());
    }
}
