//! Bordered matrices compared with dense ones.

use super::*;
use proptest::prelude::*;

/// Blocks of up to eight unknowns, or none, each touching up to five unknowns of the border, or none.
fn layouts() -> impl Strategy<Value = Layout> {
    let block = (0usize..9, 0usize..4, prop::collection::btree_set(0usize..5, 0..5));
    (prop::collection::vec(block, 1..6), 0usize..6).prop_map(|(sizes, border_size)| {
        let mut layout = Layout { border_size, ..Layout::default() };
        for (size, band, touches) in sizes {
            let first = layout.border;
            layout.border += size;
            let touches = touches.into_iter().filter(|&touched| touched < border_size).collect();
            layout.blocks.push(BlockLayout { first, size, band, touches });
        }
        let border = layout.border;
        let mut reach = 0;
        for touches in layout.blocks.iter_mut().map(|block| &mut block.touches) {
            reach = touches.last().zip(touches.first()).map_or(reach, |(last, first)| reach.max(last - first));
            touches.iter_mut().for_each(|touched| *touched += border);
        }
        layout.border_band = reach;
        layout
    })
}

/// Entries (block, row, column) where a matrix of this layout may be nonzero; those of the border once for each block
/// that touches them.
fn places(layout: &Layout) -> Vec<(usize, usize, usize)> {
    let mut places = Vec::new();
    for (n, block) in layout.blocks.iter().enumerate() {
        let own = block.first..block.first + block.size;
        let seen = || own.clone().chain(block.touches.iter().copied());
        let holds = |row: usize, column: usize| {
            !own.contains(&row) || !own.contains(&column) || row.abs_diff(column) <= block.band
        };
        places.extend(seen().flat_map(|row| seen().map(move |column| (n, row, column))).filter(|p| holds(p.1, p.2)));
    }
    // The border's diagonal too, which no block may touch.
    places.extend((layout.border..layout.size()).map(|unknown| (0, unknown, unknown)));
    places
}

/// Equal entries in a bordered and a dense matrix, `more` added on the diagonal.
fn bordered_and_dense(layout: Layout, values: &[f64], more: f64) -> (Bordered, DMatrix<f64>) {
    let layout = Arc::new(layout);
    let (mut bordered, mut dense) = (Bordered::zeros(&layout), DMatrix::zeros(layout.size(), layout.size()));
    for ((block, row, column), value) in places(&layout).into_iter().zip(values.iter().cycle()) {
        let value = if row == column { value + more } else { *value };
        bordered.block(block).add(row, column, value);
        dense[(row, column)] += value;
    }
    (bordered, dense)
}

fn values() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-1.0..1.0, 997)
}

/// Whether each block, and the whole matrix, has a reciprocal condition number above `least`: blocks are eliminated
/// separately.
fn well_conditioned(layout: &Layout, dense: &DMatrix<f64>, least: f64) -> bool {
    let blocks = layout.blocks.iter().map(|block| {
        dense.view_range(block.first..block.first + block.size, block.first..block.first + block.size).into_owned()
    });
    blocks.chain([dense.clone()]).filter(|matrix| !matrix.is_empty()).all(|matrix| {
        let sizes = matrix.singular_values();
        sizes.min() > least * sizes.max()
    })
}

/// Largest residual of a row, relative to the sum of its terms' magnitudes.
fn residual(matrix: &DMatrix<f64>, x: &DVector<f64>, b: &DVector<f64>) -> f64 {
    let sizes = matrix.abs() * x.abs() + b.abs();
    (matrix * x - b)
        .iter()
        .zip(&sizes)
        .map(|(r, size)| if *r == 0.0 { 0.0 } else { r.abs() / size })
        .fold(0.0, f64::max)
}

proptest! {
    #[test]
    fn holds_what_a_dense_matrix_holds(layout in layouts(), values in values(), factor in -2.0..2.0) {
        let (mut bordered, dense) = bordered_and_dense(layout, &values, 0.0);
        prop_assert_eq!(bordered.size(), dense.nrows());
        prop_assert!(bordered.dense().relative_eq(&dense, 1e-15, 1e-15));
        let other = bordered.clone();
        bordered.add_scaled(factor, &other);
        prop_assert!((bordered.dense() - &dense * (1.0 + factor)).iter().all(|error| error.abs() <= 1e-14));
    }

    #[test]
    fn solves_like_a_dense_lu(layout in layouts(), values in values()) {
        let (bordered, dense) = bordered_and_dense(layout, &values, 0.0);
        prop_assume!(well_conditioned(&bordered.layout, &dense, 1e-4));
        let b = DVector::from_fn(dense.nrows(), |i, _| values[i] + 2.0);
        let mut x = b.clone();
        bordered.lu().unwrap().solve(&mut x);
        // nalgebra's solve fails on a matrix without rows.
        let expected = if b.is_empty() { b.clone() } else { dense.lu().solve(&b).unwrap() };
        prop_assert!((&x - &expected).iter().all(|error| error.abs() <= 1e-8 * (1.0 + expected.norm())));
    }

    #[test]
    fn equilibrated_factors_solve_badly_scaled_matrices(
        layout in layouts(),
        values in values(),
        powers in prop::collection::vec((-8.0..8.0, -4.0..4.0), 60),
    ) {
        let (mut bordered, dense) = bordered_and_dense(layout, &values, 5.0);
        prop_assume!(well_conditioned(&bordered.layout, &dense, 1e-2));
        let scales = |power: fn(&(f64, f64)) -> f64| DVector::from_fn(dense.nrows(), |i, _| 10f64.powf(power(&powers[i])));
        let (rows, columns) = (scales(|power| power.0), scales(|power| power.1));
        bordered.scale_each(&rows, &columns);
        let scaled = bordered.dense();
        let x = DVector::from_fn(dense.nrows(), |i, _| (values[i] + 2.0) / columns[i]);
        let b = &scaled * &x;
        let mut solution = b.clone();
        bordered.equilibrated_lu().unwrap().solve(&mut solution);
        prop_assert!(solution.iter().zip(&x).all(|(a, b)| (a - b).abs() <= 1e-8 * b.abs()), "{solution} is not {x}");
        // Row by row; the worst of 40000 cases was 2e-10, since blocks are eliminated separately.
        prop_assert!(residual(&scaled, &solution, &b) <= 1e-9, "{}", residual(&scaled, &solution, &b));
    }

    #[test]
    fn a_singular_block_is_named_by_its_unknown(layout in layouts(), values in values(), which: prop::sample::Index) {
        prop_assume!(layout.border > 0);
        let unknown = which.index(layout.border);
        let (mut bordered, _) = bordered_and_dense(layout, &values, 5.0);
        let ones = DVector::repeat(bordered.size(), 1.0);
        let mut columns = ones.clone();
        columns[unknown] = 0.0;
        bordered.scale_each(&ones, &columns);
        prop_assert_eq!(bordered.clone().lu().unwrap_err(), SingularAt(unknown));
        prop_assert_eq!(bordered.equilibrated_lu().unwrap_err(), SingularAt(unknown));
    }

    #[test]
    fn a_singular_corner_is_named_by_its_unknown(layout in layouts(), values in values(), which: prop::sample::Index) {
        prop_assume!(layout.border_size > 0);
        let unknown = layout.border + which.index(layout.border_size);
        let (mut bordered, _) = bordered_and_dense(layout, &values, 5.0);
        let ones = DVector::repeat(bordered.size(), 1.0);
        let mut columns = ones.clone();
        columns[unknown] = 0.0;
        bordered.scale_each(&ones, &columns);
        prop_assert_eq!(bordered.clone().lu().unwrap_err(), SingularAt(unknown));
        prop_assert_eq!(bordered.equilibrated_lu().unwrap_err(), SingularAt(unknown));
    }
}

/// Two blocks of one unknown, [1] and [2], coupled to a border [3] by ones.
fn small(corner: f64) -> Bordered {
    let block = |first| BlockLayout { first, size: 1, band: 0, touches: vec![2] };
    let layout = Layout { blocks: vec![block(0), block(1)], border: 2, border_size: 1, border_band: 0 };
    let mut matrix = Bordered::zeros(&Arc::new(layout));
    for block in 0..2 {
        matrix.block(block).add(block, block, 1.0 + block as f64);
        matrix.block(block).add(block, 2, 1.0);
        matrix.block(block).add(2, block, 1.0);
    }
    matrix.block(0).add(2, 2, corner);
    matrix
}

#[test]
fn a_corner_that_blocks_use_up_is_singular() {
    // The blocks subtract 1/1 + 1/2 from the corner.
    assert_eq!(small(1.5).lu().unwrap_err(), SingularAt(2));
    assert_eq!(small(f64::NAN).lu().unwrap_err(), SingularAt(2));
    let mut b = DVector::from_vec(vec![2.0, 3.0, 5.0]);
    small(3.0).lu().unwrap().solve(&mut b);
    assert_eq!(b, DVector::repeat(3, 1.0));
}

#[test]
fn memory_counts_every_entry() {
    let matrix = small(3.0);
    // One entry for each 1 × 1 block and for the corner, and a right and a lower one for each block.
    assert_eq!(matrix.layout.bytes(), 8 * (3 + 4));
}

#[test]
fn scales_are_powers_of_two_that_bring_sizes_below_one() {
    for size in [1e-300, 0.3, 0.5, 1.0, 1.5, 2.0, 7e10, 1e300] {
        let scale = power_of_two(size);
        assert!((0.5..1.0).contains(&(size * scale)), "{size} times {scale}");
        assert_eq!(scale.log2().fract(), 0.0);
    }
    assert_eq!([0.0, f64::INFINITY, f64::NAN].map(power_of_two), [1.0; 3]);
}

proptest! {
    /// Negative eigenvalues are counted as for the dense matrix, where none is near zero.
    #[test]
    fn negative_eigenvalues_are_counted(layout in layouts(), values in values(), more in -3.0..3.0f64) {
        prop_assume!(layout.size() > 0);
        let layout = Arc::new(layout);
        let (mut bordered, mut dense) = (Bordered::zeros(&layout), DMatrix::<f64>::zeros(layout.size(), layout.size()));
        let lower = places(&layout).into_iter().filter(|(_, row, column)| column <= row);
        for ((block, row, column), value) in lower.zip(values.iter().cycle()) {
            let value = if row == column { value + more } else { *value };
            bordered.block(block).add(row, column, value);
            dense[(row, column)] += value;
            if row != column {
                bordered.block(block).add(column, row, value);
                dense[(column, row)] += value;
            }
        }
        let eigenvalues: Vec<f64> = dense.symmetric_eigenvalues().iter().copied().collect();
        prop_assume!(eigenvalues.iter().all(|value| value.abs() > 1e-3));
        let negative = eigenvalues.iter().filter(|value| **value < 0.0).count();
        prop_assert_eq!(bordered.negative_eigenvalues(&mut InertiaMemory::default()), Some(negative));
    }
}

/// [[0, 1], [1, 0]] has the eigenvalues ±1, and a zero pivot; [[0, 0], [0, 0]] has zeros, which count as negative.
#[test]
fn a_zero_pivot_is_shifted_away() {
    let layout = Layout {
        blocks: vec![BlockLayout { first: 0, size: 2, band: 1, touches: vec![] }],
        border: 2,
        ..Layout::default()
    };
    let mut matrix = Bordered::zeros(&Arc::new(layout));
    let (shift, mut memory) = (DVector::repeat(2, 1e-12), InertiaMemory::default());
    assert_eq!(matrix.negative_eigenvalues(&mut memory), None);
    assert_eq!(matrix.negative_eigenvalues_near(&shift, &mut memory), Some(2));
    matrix.clear();
    matrix.block(0).add(0, 1, 1.0);
    matrix.block(0).add(1, 0, 1.0);
    assert_eq!(matrix.negative_eigenvalues(&mut memory), None);
    assert_eq!(matrix.negative_eigenvalues_near(&shift, &mut memory), Some(1));
    matrix.block(0).add(1, 1, f64::NAN);
    assert_eq!(matrix.negative_eigenvalues_near(&shift, &mut memory), None);
}
