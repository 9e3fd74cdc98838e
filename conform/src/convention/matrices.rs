//! Nested lists of a matrix.

/// How a program writes matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Matrices {
    /// A list of rows.
    #[default]
    Rows,
    /// A list of columns.
    Columns,
    /// One flat list, row by row.
    FlatRows,
    /// One flat list, column by column.
    FlatColumns,
}

impl Matrices {
    pub(super) const ALL: [Matrices; 4] =
        [Matrices::Rows, Matrices::Columns, Matrices::FlatRows, Matrices::FlatColumns];

    /// Value of the key `matrices` in `hello`.
    pub(super) fn name(self) -> &'static str {
        match self {
            Matrices::Rows => "rows",
            Matrices::Columns => "columns",
            Matrices::FlatRows => "flat-rows",
            Matrices::FlatColumns => "flat-columns",
        }
    }

    /// The convention in words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Matrices::Rows => "matrices as lists of rows",
            Matrices::Columns => "matrices as lists of columns",
            Matrices::FlatRows => "matrices as flat lists, row by row",
            Matrices::FlatColumns => "matrices as flat lists, column by column",
        }
    }

    fn is_by_columns(self) -> bool {
        matches!(self, Matrices::Columns | Matrices::FlatColumns)
    }

    /// Shape of the nested lists of a value that has `shape` by rows; `points` is the number of points of a quantity per point.
    pub(super) fn shape(self, shape: &[usize], points: Option<usize>) -> Vec<usize> {
        let mut all: Vec<usize> = points.into_iter().collect();
        match (self, shape) {
            (Matrices::Columns, [rows, columns]) => all.extend([columns, rows]),
            (Matrices::FlatRows | Matrices::FlatColumns, [rows, columns]) => all.push(rows * columns),
            _ => all.extend(shape),
        }
        all
    }

    /// Whether nested lists of the shape `found` can be this convention's form of a value that has `shape` by rows.
    pub(super) fn admits(self, found: &[usize], shape: &[usize], points: Option<usize>) -> bool {
        if found == self.shape(shape, points) {
            return true;
        }
        let is_flat = matches!(self, Matrices::FlatRows | Matrices::FlatColumns);
        // A flat list may run through all points, and a vector may be a matrix with one column.
        let count = |lengths: &[usize]| lengths.iter().product::<usize>();
        let without_ones = found.iter().filter(|length| **length != 1).count();
        is_flat && count(found) == count(shape) * points.unwrap_or(1) && without_ones <= 1
    }

    /// Row by row, the entries of one matrix of `shape` as they stand in the program's list; and back with `to_rows` false.
    pub(super) fn rows(self, shape: &[usize], entries: &[f64], to_rows: bool) -> Vec<f64> {
        let [rows, columns] = *shape else { return entries.to_vec() };
        if !self.is_by_columns() {
            return entries.to_vec();
        }
        let place = |n: usize| if to_rows { n % columns * rows + n / columns } else { n % rows * columns + n / rows };
        (0..entries.len()).map(|n| entries.get(place(n)).copied().unwrap_or(f64::NAN)).collect()
    }
}
