//! Bands that do not touch one another, coupled by a border:
//!
//! ```text
//! ⎡ A₁            B₁ ⎤
//! ⎢     A₂        B₂ ⎥
//! ⎢         …     …  ⎥
//! ⎣ C₁  C₂  …     D  ⎦
//! ```
//!
//! One block is one rod, the border is what rods share: pinned points, or multipliers. Each block is eliminated by itself,
//! and leaves a small band matrix D − Σ Cᵢ Aᵢ⁻¹ Bᵢ: the cost is linear in the number of rods and of their elements.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SMatrix};

use super::{BandLu, BandMatrix, BlockLayout, Layout, SingularAt};

/// Part of the largest entry of a solution below which an entry is nothing.
const NOTHING: f64 = 1e-100;

/// A matrix of this shape.
#[derive(Clone, Debug)]
pub struct Bordered {
    layout: Arc<Layout>,
    blocks: Vec<Block>,
    /// D, over all the border's unknowns.
    corner: BandMatrix,
}

#[derive(Clone, Debug)]
struct Block {
    /// A.
    own: BandMatrix,
    /// B: the block's rows, the columns of the border that it touches.
    right: DMatrix<f64>,
    /// Cᵀ, of the same shape: stored by columns, so that a column is a row of C.
    below: DMatrix<f64>,
}

/// A block that is being filled, and its share of the corner.
pub struct Filling<'a> {
    border: usize,
    place: &'a BlockLayout,
    block: &'a mut Block,
    corner: &'a mut BandMatrix,
}

/// Its LU factors.
#[derive(Clone, Debug)]
pub struct BorderedLu {
    layout: Arc<Layout>,
    blocks: Vec<BlockLu>,
    corner: BandLu,
    scales: Option<Scales>,
}

#[derive(Clone, Debug)]
struct BlockLu {
    own: BandLu,
    /// A⁻¹ B.
    right: DMatrix<f64>,
    /// Cᵀ.
    below: DMatrix<f64>,
}

/// Factors of the rows and columns of an equilibrated matrix.
#[derive(Clone, Debug)]
struct Scales {
    rows: DVector<f64>,
    columns: DVector<f64>,
}

/// Where an unknown stands as seen from a block.
#[derive(Clone, Copy)]
enum Seen {
    /// Among its own.
    Own(usize),
    /// In the border, and among those that the block touches.
    Border { place: usize, touch: usize },
}

impl Bordered {
    /// A zero matrix.
    pub fn zeros(layout: &Arc<Layout>) -> Bordered {
        Bordered {
            blocks: layout.blocks.iter().map(Block::zeros).collect(),
            corner: BandMatrix::zeros(layout.border_size, layout.border_band),
            layout: layout.clone(),
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.layout.size()
    }

    /// A block to add to.
    pub fn block(&mut self, number: usize) -> Filling<'_> {
        Filling {
            border: self.layout.border,
            place: &self.layout.blocks[number],
            block: &mut self.blocks[number],
            corner: &mut self.corner,
        }
    }

    /// The matrix with every entry in its place, for looking at small ones.
    pub fn dense(&self) -> DMatrix<f64> {
        let mut dense = DMatrix::zeros(self.size(), self.size());
        self.each(|row, column, value| dense[(row, column)] = value);
        dense
    }

    /// Multiplies every entry by `factor`.
    pub fn scale(&mut self, factor: f64) {
        for block in &mut self.blocks {
            block.own.scale(factor);
            block.right *= factor;
            block.below *= factor;
        }
        self.corner.scale(factor);
    }

    /// Adds `factor` · `other`, a matrix of the same layout.
    pub fn add_scaled(&mut self, factor: f64, other: &Bordered) {
        for (block, other) in self.blocks.iter_mut().zip(&other.blocks) {
            block.own.add_scaled(factor, &other.own);
            block.right.zip_apply(&other.right, |a, b| *a += factor * b);
            block.below.zip_apply(&other.below, |a, b| *a += factor * b);
        }
        self.corner.add_scaled(factor, &other.corner);
    }

    /// The product with a vector.
    pub fn mul(&self, x: &DVector<f64>) -> DVector<f64> {
        let border = self.layout.border;
        let mut product = DVector::zeros(self.size());
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            let own = layout.first..layout.first + layout.size;
            block.own.add_product(&x.as_slice()[own.clone()], &mut product.as_mut_slice()[own]);
            for (n, &touched) in layout.touches.iter().enumerate() {
                let mut own = product.rows_mut(layout.first, layout.size);
                own.axpy(x[touched], &block.right.column(n), 1.0);
                product[touched] += block.below.column(n).dot(&x.rows(layout.first, layout.size));
            }
        }
        self.corner.add_product(&x.as_slice()[border..], &mut product.as_mut_slice()[border..]);
        product
    }

    /// LU factors: each block, then what it leaves of the border.
    ///
    /// # Errors
    /// The unknown whose pivot is zero, or not a number.
    pub fn lu(self) -> Result<BorderedLu, SingularAt> {
        let Bordered { layout, blocks, corner } = self;
        let mut blocks = blocks.into_iter();
        BorderedLu::of(&layout, corner, |_, place, _| blocks.next().unwrap_or_else(|| Block::zeros(place)))
    }

    /// LU factors of a matrix that is never there as a whole: `fill` adds what there is in a block, by its number, and the
    /// block is eliminated while it is still in the processor's cache. `old` factors of the same layout give their memory.
    ///
    /// # Errors
    /// Those of [`lu`](Bordered::lu).
    pub fn lu_block_by_block(
        layout: &Arc<Layout>,
        old: Option<BorderedLu>,
        fill: impl Fn(usize, &mut Filling),
    ) -> Result<BorderedLu, SingularAt> {
        let (mut blocks, corner) = old.map(|old| (old.blocks.into_iter(), old.corner.into_zeros())).unzip();
        let corner = corner.unwrap_or_else(|| BandMatrix::zeros(layout.border_size, layout.border_band));
        BorderedLu::of(layout, corner, |number, place, corner| {
            let old = blocks.as_mut().and_then(Iterator::next);
            let mut block = old.map_or_else(|| Block::zeros(place), BlockLu::into_zeros);
            fill(number, &mut Filling { border: layout.border, place, block: &mut block, corner });
            block
        })
    }

    /// LU factors of the matrix with its rows, then its columns, scaled to a largest entry near 1. Scales are powers of
    /// two, so that scaling rounds nothing.
    ///
    /// # Errors
    /// Those of [`lu`](Bordered::lu).
    pub fn equilibrated_lu(mut self) -> Result<BorderedLu, SingularAt> {
        let rows = self.largest(|row, _, value| (row, value)).map(power_of_two);
        let columns = self.largest(|row, column, value| (column, value * rows[row])).map(power_of_two);
        self.scale_each(&rows, &columns);
        Ok(BorderedLu { scales: Some(Scales { rows, columns }), ..self.lu()? })
    }

    /// Largest sizes in places that `of` chooses from the row, the column and the value of each entry: with the value there.
    fn largest(&self, of: impl Fn(usize, usize, f64) -> (usize, f64)) -> DVector<f64> {
        let mut largest = DVector::zeros(self.size());
        self.each(|row, column, value| {
            let (place, value) = of(row, column, value);
            largest[place] = value.abs().max(largest[place]);
        });
        largest
    }

    /// Every entry with its row and column.
    fn each(&self, mut f: impl FnMut(usize, usize, f64)) {
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            for row in 0..layout.size {
                block.own.row(row).for_each(|(column, value)| f(layout.first + row, layout.first + column, value));
            }
            for (n, &touched) in layout.touches.iter().enumerate() {
                let sides = block.right.column(n);
                for (row, (right, below)) in sides.iter().zip(&block.below.column(n)).enumerate() {
                    f(layout.first + row, touched, *right);
                    f(touched, layout.first + row, *below);
                }
            }
        }
        let border = self.layout.border;
        for row in 0..self.layout.border_size {
            self.corner.row(row).for_each(|(column, value)| f(border + row, border + column, value));
        }
    }

    fn scale_each(&mut self, rows: &DVector<f64>, columns: &DVector<f64>) {
        let (rows, columns) = (rows.as_slice(), columns.as_slice());
        for (layout, block) in self.layout.blocks.iter().zip(&mut self.blocks) {
            let own = layout.first..layout.first + layout.size;
            block.own.scale_each(&rows[own.clone()], &columns[own]);
            for (n, &touched) in layout.touches.iter().enumerate() {
                for row in 0..layout.size {
                    block.right[(row, n)] *= rows[layout.first + row] * columns[touched];
                    block.below[(row, n)] *= rows[touched] * columns[layout.first + row];
                }
            }
        }
        let border = self.layout.border;
        self.corner.scale_each(&rows[border..], &columns[border..]);
    }
}

/// The power of two that brings `size` into [½, 1); 1 for nothing.
fn power_of_two(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() { (-size.log2().floor() - 1.0).exp2() } else { 1.0 }
}

impl Block {
    fn zeros(place: &BlockLayout) -> Block {
        Block {
            own: BandMatrix::zeros(place.size, place.band),
            right: DMatrix::zeros(place.size, place.touches.len()),
            below: DMatrix::zeros(place.size, place.touches.len()),
        }
    }
}

impl BlockLu {
    /// A zero block of the same shape in the same memory.
    fn into_zeros(self) -> Block {
        let BlockLu { own, mut right, mut below } = self;
        right.fill(0.0);
        below.fill(0.0);
        Block { own: own.into_zeros(), right, below }
    }
}

impl Filling<'_> {
    fn seen(&self, unknown: usize) -> Seen {
        match unknown.checked_sub(self.border) {
            None => Seen::Own(unknown - self.place.first),
            Some(place) => {
                let touches = &self.place.touches;
                let touch = touches.iter().position(|&touched| touched == unknown).unwrap_or(touches.len());
                Seen::Border { place, touch }
            }
        }
    }

    /// Adds `value` at (row, column), both of them unknowns of the block or of the border that it touches.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        self.add_seen(self.seen(row), self.seen(column), value);
    }

    /// Adds a dense matrix whose rows and columns are these unknowns of the block or of its border; `None` is left out.
    pub fn add_dense<const N: usize>(&mut self, unknowns: [Option<usize>; N], dense: &SMatrix<f64, N, N>) {
        let seen = unknowns.map(|unknown| unknown.map(|unknown| self.seen(unknown)));
        for (j, column) in seen.iter().enumerate() {
            for (i, row) in seen.iter().enumerate() {
                if let (Some(row), Some(column)) = (*row, *column) {
                    self.add_seen(row, column, dense[(i, j)]);
                }
            }
        }
    }

    fn add_seen(&mut self, row: Seen, column: Seen, value: f64) {
        let Block { own, right, below } = &mut *self.block;
        match (row, column) {
            (Seen::Own(row), Seen::Own(column)) => own.add(row, column, value),
            (Seen::Own(row), Seen::Border { touch, .. }) => right[(row, touch)] += value,
            (Seen::Border { touch, .. }, Seen::Own(column)) => below[(column, touch)] += value,
            (Seen::Border { place: row, .. }, Seen::Border { place: column, .. }) => {
                self.corner.add(row, column, value);
            }
        }
    }
}

impl BorderedLu {
    /// Eliminates block by block, as `next` gives them for their number and place; it may add to the corner.
    fn of(
        layout: &Arc<Layout>,
        mut corner: BandMatrix,
        mut next: impl FnMut(usize, &BlockLayout, &mut BandMatrix) -> Block,
    ) -> Result<BorderedLu, SingularAt> {
        let mut blocks = Vec::with_capacity(layout.blocks.len());
        for (number, place) in layout.blocks.iter().enumerate() {
            let Block { own, mut right, below } = next(number, place, &mut corner);
            let own = own.lu().map_err(|SingularAt(pivot)| SingularAt(place.first + pivot))?;
            own.solve_columns(right.as_mut_slice());
            for (m, row) in place.touches.iter().enumerate() {
                for (n, column) in place.touches.iter().enumerate() {
                    let taken = below.column(m).dot(&right.column(n));
                    corner.add(row - layout.border, column - layout.border, -taken);
                }
            }
            blocks.push(BlockLu { own, right, below });
        }
        let corner = corner.lu().map_err(|SingularAt(pivot)| SingularAt(layout.border + pivot))?;
        Ok(BorderedLu { layout: layout.clone(), blocks, corner, scales: None })
    }

    /// Solves A x = b in place. What is less than 10⁻¹⁰⁰ of the largest entry is set to zero: what acts on one end of a long
    /// structure dies out exponentially along it, and numbers that underflow are computed a hundred times slower than zeros.
    pub fn solve(&self, b: &mut DVector<f64>) {
        if let Some(Scales { rows, .. }) = &self.scales {
            b.component_mul_assign(rows);
        }
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            block.own.solve(&mut b.as_mut_slice()[layout.first..layout.first + layout.size]);
            for (n, &touched) in layout.touches.iter().enumerate() {
                let taken = block.below.column(n).dot(&b.rows(layout.first, layout.size));
                b[touched] -= taken;
            }
        }
        self.corner.solve(&mut b.as_mut_slice()[self.layout.border..]);
        flush(b);
        for (layout, block) in self.layout.blocks.iter().zip(&self.blocks) {
            for (n, &touched) in layout.touches.iter().enumerate() {
                let border = b[touched];
                b.rows_mut(layout.first, layout.size).axpy(-border, &block.right.column(n), 1.0);
            }
        }
        flush(b);
        if let Some(Scales { columns, .. }) = &self.scales {
            b.component_mul_assign(columns);
        }
    }
}

/// Sets to zero what is nothing beside the largest entry.
fn flush(b: &mut DVector<f64>) {
    let nothing = NOTHING * b.amax();
    b.iter_mut().filter(|x| x.abs() < nothing).for_each(|x| *x = 0.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Blocks of up to eight unknowns, none among them, that touch up to five unknowns of the border, or nothing.
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

    /// Places (block, row, column) where a matrix of this layout may have entries; those of the border once for each block
    /// that touches them.
    fn places(layout: &Layout) -> Vec<(usize, usize, usize)> {
        let mut places = Vec::new();
        for (n, block) in layout.blocks.iter().enumerate() {
            let own = block.first..block.first + block.size;
            let seen = || own.clone().chain(block.touches.iter().copied());
            let holds = |row: usize, column: usize| {
                !own.contains(&row) || !own.contains(&column) || row.abs_diff(column) <= block.band
            };
            places
                .extend(seen().flat_map(|row| seen().map(move |column| (n, row, column))).filter(|p| holds(p.1, p.2)));
        }
        // The border's diagonal as well, which no block may touch.
        places.extend((layout.border..layout.size()).map(|unknown| (0, unknown, unknown)));
        places
    }

    /// The same numbers in their places of a bordered and a dense matrix, `more` on the diagonal.
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

    /// Whether every block of its own, and the whole, can be solved to many digits; blocks are eliminated on their own.
    fn well_conditioned(layout: &Layout, dense: &DMatrix<f64>) -> bool {
        let blocks = layout.blocks.iter().map(|block| {
            dense.view_range(block.first..block.first + block.size, block.first..block.first + block.size).into_owned()
        });
        blocks.chain([dense.clone()]).filter(|matrix| !matrix.is_empty()).all(|matrix| {
            let sizes = matrix.singular_values();
            sizes.min() > 1e-4 * sizes.max()
        })
    }

    /// Largest residual of a row relative to the sum of its terms' sizes.
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
        fn multiplies_like_a_dense_matrix(layout in layouts(), values in values(), factor in -2.0..2.0) {
            let (mut bordered, dense) = bordered_and_dense(layout, &values, 0.0);
            prop_assert_eq!(bordered.size(), dense.nrows());
            prop_assert!(bordered.dense().relative_eq(&dense, 1e-15, 1e-15));
            let x = DVector::from_fn(dense.nrows(), |i, _| values[i]);
            prop_assert!((bordered.mul(&x) - &dense * &x).iter().all(|error| error.abs() <= 1e-13));

            let other = bordered.clone();
            bordered.scale(factor);
            prop_assert!(bordered.dense().relative_eq(&(&dense * factor), 1e-15, 1e-15));
            bordered.add_scaled(1.0 - factor, &other);
            prop_assert!((bordered.dense() - &dense).iter().all(|error| error.abs() <= 1e-14));
        }

        #[test]
        fn solves_like_a_dense_lu(layout in layouts(), values in values()) {
            let (bordered, dense) = bordered_and_dense(layout, &values, 0.0);
            prop_assume!(well_conditioned(&bordered.layout, &dense));
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
            powers in prop::collection::vec((-8.0..8.0, -8.0..8.0), 60),
        ) {
            let (mut bordered, dense) = bordered_and_dense(layout, &values, 5.0);
            prop_assume!(well_conditioned(&bordered.layout, &dense));
            let scales = |power: fn(&(f64, f64)) -> f64| DVector::from_fn(dense.nrows(), |i, _| 10f64.powf(power(&powers[i])));
            let (rows, columns) = (scales(|power| power.0), scales(|power| power.1));
            bordered.scale_each(&rows, &columns);
            let scaled = bordered.dense();
            let x = DVector::from_fn(dense.nrows(), |i, _| (values[i] + 2.0) / columns[i]);
            let b = bordered.mul(&x);
            let mut solution = b.clone();
            bordered.equilibrated_lu().unwrap().solve(&mut solution);
            prop_assert!(solution.iter().zip(&x).all(|(a, b)| (a - b).abs() <= 1e-6 * b.abs()), "{solution} is not {x}");
            // Scaling rows before columns is not the best that can be done where columns differ by 1e16: it costs digits.
            prop_assert!(residual(&scaled, &solution, &b) <= 1e-7, "{}", residual(&scaled, &solution, &b));
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

    /// Two blocks of one unknown, [1] and [2], that touch a border [3] with ones.
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
        // 1/1 + 1/2 is what the blocks take from the corner.
        assert_eq!(small(1.5).lu().unwrap_err(), SingularAt(2));
        assert_eq!(small(f64::NAN).lu().unwrap_err(), SingularAt(2));
        let mut b = DVector::from_vec(vec![2.0, 3.0, 5.0]);
        small(3.0).lu().unwrap().solve(&mut b);
        assert_eq!(b, DVector::repeat(3, 1.0));
    }

    #[test]
    fn memory_counts_every_entry() {
        let matrix = small(3.0);
        // 1 by 1 with no band: one entry for each block and the corner, and a right and a lower one for each block.
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
}
