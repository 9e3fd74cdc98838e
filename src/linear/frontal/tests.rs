//! Condensed factors of elements, with one chain alone and with a border between two, against dense matrices.

use nalgebra::{Complex, DMatrix, DVector};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

use super::*;
use crate::linear::CondensedFactors;

/// Chains with their held and shared coordinates.
#[derive(Clone, Debug)]
struct Shape {
    /// Number of elements of each chain; neighbours share [`SHARED`] coordinates.
    chains: Vec<usize>,
    /// Held coordinates: chain and coordinate; below, shared ones: chain, coordinate, unknown of the border.
    held: Vec<(usize, usize)>,
    shared: Vec<(usize, usize, usize)>,
    border_size: usize,
}

/// Numbering of a shape: for each chain the unknowns of its coordinates.
struct Numbers {
    chains: Vec<Vec<u32>>,
    border: usize,
}

impl Shape {
    /// Number of coordinates of a chain whose elements have `n` each.
    fn coordinates(&self, chain: usize, n: usize) -> usize {
        self.chains[chain] * (n - SHARED) + SHARED
    }

    fn numbers(&self, n: usize) -> Numbers {
        let is_shared = |chain, at| self.shared.iter().any(|(c, a, _)| (*c, *a) == (chain, at));
        let mut next = 0;
        let mut chains: Vec<Vec<u32>> = Vec::new();
        for chain in 0..self.chains.len() {
            let own = (0..self.coordinates(chain, n)).map(|at| {
                if self.held.contains(&(chain, at)) || is_shared(chain, at) {
                    return NO_UNKNOWN;
                }
                next += 1;
                next - 1
            });
            chains.push(own.collect());
        }
        let border = next as usize;
        for &(chain, at, of_border) in &self.shared {
            chains[chain][at] = (border + of_border) as u32;
        }
        Numbers { chains, border }
    }

    /// One chain without a border: up to six elements, held coordinates anywhere.
    fn alone(n: usize) -> impl Strategy<Value = Shape> {
        (1usize..7).prop_flat_map(move |elements| {
            let coordinates = elements * (n - SHARED) + SHARED;
            prop::collection::btree_set(0..coordinates, 0..4).prop_map(move |held| Shape {
                chains: vec![elements],
                held: held.into_iter().map(|at| (0, at)).collect(),
                shared: vec![],
                border_size: 0,
            })
        })
    }

    /// Two chains that share a vector at an end, in the middle, or both; possibly with a held coordinate or two.
    fn coupled(n: usize) -> impl Strategy<Value = Shape> {
        let places = prop::collection::vec((0usize..3, 0usize..3), 1..4);
        (1usize..7, 1usize..7, places, any::<bool>()).prop_map(move |(first, second, places, holds)| {
            let mut shape = Shape { chains: vec![first, second], held: vec![], shared: vec![], border_size: 0 };
            // Positions of the first, the middle and the last node.
            let node = |elements: usize, place: usize| match place {
                0 => 0,
                1 => (elements / 2) * (n - SHARED) + if elements % 2 == 1 { n / 2 - 1 } else { 0 },
                _ => elements * (n - SHARED),
            };
            for (a, b) in places {
                let (a, b) = (node(first, a), node(second, b));
                let taken =
                    |chain, at| shape.shared.iter().any(|(c, own, _)| *c == chain && usize::abs_diff(*own, at) < 2);
                if taken(0, a) || taken(1, b) {
                    continue;
                }
                for component in 0..2 {
                    shape.shared.push((0, a + component, shape.border_size));
                    shape.shared.push((1, b + component, shape.border_size));
                    shape.border_size += 1;
                }
            }
            if holds {
                let free = |at: &usize| !shape.shared.iter().any(|(chain, own, _)| (*chain, own) == (0, at));
                shape.held = (0..n).filter(free).take(2).map(|at| (0, at)).collect();
            }
            shape
        })
    }
}

/// Number made of two reals.
trait FromPair: Number {
    fn from_pair(pair: (f64, f64)) -> Self;
}
impl FromPair for f64 {
    fn from_pair((a, _): (f64, f64)) -> f64 {
        a
    }
}
impl FromPair for Complex<f64> {
    fn from_pair((a, b): (f64, f64)) -> Complex<f64> {
        Complex::new(a, b)
    }
}

/// Matrices of all elements by columns, `more` added on their diagonals; and the assembled matrix.
fn matrices<F: FromPair, const N: usize>(
    shape: &Shape,
    values: &[(f64, f64)],
    more: f64,
) -> (Vec<Vec<Vec<F>>>, DMatrix<F>) {
    let numbers = shape.numbers(N);
    let size = numbers.border + shape.border_size;
    let (mut whole, mut all) = (DMatrix::zeros(size, size), Vec::new());
    let mut values = values.iter().cycle();
    for (chain, elements) in shape.chains.iter().enumerate() {
        let mut of_chain = Vec::new();
        for element in 0..*elements {
            let mut matrix = vec![F::zero(); N * N];
            for (place, entry) in matrix.iter_mut().enumerate() {
                let diagonal = F::from_real(if place % (N + 1) == 0 { more } else { 0.0 });
                *entry = F::from_pair(*values.next().unwrap()) + diagonal;
                let unknown = |n: usize| numbers.chains[chain][element * (N - SHARED) + n] as usize;
                let (column, row) = (unknown(place / N), unknown(place % N));
                if row < size && column < size {
                    whole[(row, column)] += *entry;
                }
            }
            of_chain.push(matrix);
        }
        all.push(of_chain);
    }
    (all, whole)
}

/// Memory for the factors of a shape.
fn chains<F: Number, const N: usize>(shape: &Shape) -> CondensedFactors<F> {
    let numbers = shape.numbers(N);
    let chains = numbers.chains.iter().enumerate().map(|(chain, unknowns)| {
        let elements = shape.chains[chain];
        let unknowns = unknowns.clone();
        let of_element = move |element: usize| std::array::from_fn(|n| unknowns[element * (N - SHARED) + n]);
        Box::new(FrontalChain::<F, N>::new((0..elements).map(of_element), numbers.border)) as Box<dyn Chain<F>>
    });
    CondensedFactors::new(chains.collect(), numbers.border, shape.border_size, shape.border_size.saturating_sub(1))
}

fn factorize<F: Number>(factors: &mut CondensedFactors<F>, matrices: &[Vec<Vec<F>>]) -> Result<(), SingularAt> {
    factors.factorize(|chain, element, columns| columns.copy_from_slice(&matrices[chain][element]))
}

/// Bits of a vector's numbers.
fn bits<F: Number>(x: &DVector<F>) -> Vec<u64> {
    x.iter().flat_map(|x| [x.real().to_bits(), x.imaginary().to_bits()]).collect()
}

/// The solution matches the dense one to 1e-9, and refactorising after other factors gives identical bits. Matrices
/// with singular fronts are excluded, since pivots are searched within a front only.
fn solves<F: FromPair, const N: usize>(shape: &Shape, values: &[(f64, f64)], more: f64) -> Result<(), TestCaseError> {
    let (elements, whole) = matrices::<F, N>(shape, values, more);
    let size = whole.nrows();
    let b = DVector::from_fn(size, |i, _| F::from_pair(values[values.len() - 1 - i]) + F::from_real(2.0));
    let mut factors = chains::<F, N>(shape);
    prop_assert!(factorize(&mut factors, &elements).is_ok());
    let mut x = b.clone();
    factors.solve(&mut x);
    let expected = whole.clone().full_piv_lu().solve(&b).unwrap();
    let error = (&x - &expected).norm();
    // Written so that a NaN fails.
    prop_assert!(error <= 1e-9 * expected.norm(), "{error:e} of {:e}", expected.norm());

    let (others, _) = matrices::<F, N>(shape, &values[1..], more + 1.0);
    prop_assert!(factorize(&mut factors, &others).is_ok());
    prop_assert!(factorize(&mut factors, &elements).is_ok());
    let mut again = b.clone();
    factors.solve(&mut again);
    prop_assert_eq!(bits(&x), bits(&again));
    Ok(())
}

/// Pairs of numbers between −1 and 1 (Steele's SplitMix64).
fn values(seed: u64) -> Vec<(f64, f64)> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) as f64 / 2f64.powi(63) - 1.0
    };
    (0..2503).map(|_| (next(), next())).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Every row is diagonally dominant, so that no pivot is small.
    #[test]
    fn dominant_matrices_are_solved_like_dense_ones(
        short in Shape::alone(8), long in Shape::alone(14), seed in any::<u64>(),
    ) {
        let values = values(seed);
        solves::<f64, 8>(&short, &values, 20.0)?;
        solves::<Complex<f64>, 8>(&short, &values, 30.0)?;
        solves::<f64, 14>(&long, &values, 30.0)?;
        solves::<Complex<f64>, 14>(&long, &values, 45.0)?;
    }

    /// Two chains with a border between them: at their ends, in their middles, at several places at once.
    #[test]
    fn coupled_chains_are_solved_like_dense_matrices(
        short in Shape::coupled(8), long in Shape::coupled(14), seed in any::<u64>(),
    ) {
        let values = values(seed);
        prop_assert!(short.border_size >= 2 && long.border_size >= 2);
        solves::<f64, 8>(&short, &values, 20.0)?;
        solves::<Complex<f64>, 8>(&short, &values, 30.0)?;
        solves::<f64, 14>(&long, &values, 30.0)?;
        solves::<Complex<f64>, 14>(&long, &values, 45.0)?;
    }

    /// No row is diagonally dominant: rows are swapped. Ill-conditioned matrices are excluded; for the others the error
    /// is below 1e-9.
    #[test]
    fn general_matrices_are_solved(short in Shape::coupled(8), long in Shape::coupled(14), seed in any::<u64>()) {
        let values = values(seed);
        general::<f64, 8>(&short, &values)?;
        general::<Complex<f64>, 8>(&short, &values)?;
        general::<f64, 14>(&long, &values)?;
        general::<Complex<f64>, 14>(&long, &values)?;
    }
}

/// Random entries everywhere; matrices with a condition number above 1e3 are skipped.
fn general<F: FromPair, const N: usize>(shape: &Shape, values: &[(f64, f64)]) -> Result<(), TestCaseError> {
    let (elements, whole) = matrices::<F, N>(shape, values, 0.0);
    let singular_values = whole.clone().map(|x| Complex::new(x.real(), x.imaginary())).singular_values();
    if singular_values.min() < 1e-3 * singular_values.max() {
        return Ok(());
    }
    let b = DVector::from_fn(whole.nrows(), |i, _| F::from_pair(values[i]) + F::from_real(2.0));
    let mut factors = chains::<F, N>(shape);
    prop_assert!(factorize(&mut factors, &elements).is_ok());
    let mut x = b.clone();
    factors.solve(&mut x);
    let expected = whole.full_piv_lu().solve(&b).unwrap();
    let error = (&x - &expected).norm();
    prop_assert!(error <= 1e-9 * expected.norm(), "{error:e} of {:e}", expected.norm());
    Ok(())
}

/// One chain of two elements with 8 coordinates.
fn two() -> Shape {
    Shape { chains: vec![2], held: vec![], shared: vec![], border_size: 0 }
}

/// Unit matrix, contributed in halves by both elements where they meet.
fn units(shape: &Shape) -> Vec<Vec<Vec<f64>>> {
    let elements = shape.chains[0];
    let unit = |element: usize| {
        let mut matrix = vec![0.0; 64];
        for n in 0..8 {
            let twice = (n < SHARED && element > 0) || (n >= 8 - SHARED && element + 1 < elements);
            matrix[9 * n] = if twice { 0.5 } else { 1.0 };
        }
        matrix
    };
    vec![(0..elements).map(unit).collect()]
}

/// A zero on the diagonal of a front, in its first and its last eliminated row, in the first and the last element.
#[test]
fn a_zero_pivot_is_swapped() {
    for (element, row, other) in [(0, 0, 3), (0, 2, 3), (1, 4, 7), (1, 6, 7), (1, 0, 5)] {
        let mut matrices = units(&two());
        // Rows `row` and `other` of the assembled matrix are swapped.
        for (row, column) in [(row, row), (other, other)] {
            matrices[0][element][8 * column + row] = 0.0;
            if element == 1 && row < SHARED {
                matrices[0][0][8 * (column + 4) + row + 4] = 0.0;
            }
        }
        for (row, column) in [(row, other), (other, row)] {
            matrices[0][element][8 * column + row] = 1.0;
        }
        let mut factors = chains::<f64, 8>(&two());
        factorize(&mut factors, &matrices).unwrap();
        let b = DVector::from_fn(12, |i, _| i as f64 + 1.0);
        let mut x = b.clone();
        factors.solve(&mut x);
        let mut expected = b;
        expected.swap_rows(4 * element + row, 4 * element + other);
        assert_eq!(x, expected, "rows {row} and {other} of element {element}");
    }
}

/// A row and a column of zeros: its unknown is named, also behind held coordinates, and in the border.
#[test]
fn a_singular_matrix_names_its_unknown() {
    for at in 0..12 {
        let mut matrices = units(&two());
        for (element, matrix) in matrices[0].iter_mut().enumerate() {
            if let Some(n) = usize::checked_sub(at, 4 * element).filter(|n| *n < 8) {
                matrix[9 * n] = 0.0;
            }
        }
        let mut factors = chains::<f64, 8>(&two());
        assert_eq!(factorize(&mut factors, &matrices), Err(SingularAt(at)));
        // There are no factors then: the solution is NaN, and new factors can be made.
        let mut x = DVector::from_element(12, 1.0);
        factors.solve(&mut x);
        assert!(x.iter().all(|x| x.is_nan()));
        factorize(&mut factors, &units(&two())).unwrap();
        let mut x = DVector::from_element(12, 1.0);
        factors.solve(&mut x);
        assert_eq!(x, DVector::from_element(12, 1.0));

        // With the first two coordinates held, unknowns count from the third.
        if at >= 2 {
            let shape = Shape { held: vec![(0, 0), (0, 1)], ..two() };
            assert_eq!(factorize(&mut chains::<f64, 8>(&shape), &matrices), Err(SingularAt(at - 2)));
        }
        // With this coordinate in the border, the border's unknown is named.
        let shape = Shape { shared: vec![(0, at, 0)], border_size: 1, ..two() };
        assert_eq!(factorize(&mut chains::<f64, 8>(&shape), &matrices), Err(SingularAt(11)));
    }
}

/// NaN is not a pivot.
#[test]
fn a_pivot_that_is_no_number_is_refused() {
    let mut matrices = units(&two());
    matrices[0][0][0] = f64::NAN;
    assert_eq!(factorize(&mut chains::<f64, 8>(&two()), &matrices), Err(SingularAt(0)));
}
