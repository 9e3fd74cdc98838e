//! Recorded rows of a run.

use std::collections::TryReserveError;
use std::io::{self, Write};
use std::ops::{Index, IndexMut};
use std::slice::ChunksExact;

/// Table of recorded quantities over time.
///
/// ```
/// use ancf::run::Trajectory;
///
/// let columns = vec!["t".to_string(), "tip.x".to_string()];
/// let trajectory = Trajectory { columns, rows: [[0.0, 1.0], [0.1, 0.95]].into_iter().collect() };
/// assert_eq!(trajectory.column("tip.x"), Some(vec![1.0, 0.95]));
///
/// let mut csv = Vec::new();
/// trajectory.write_csv(&mut csv)?;
/// assert_eq!(csv, b"t,tip.x\n0.0,1.0\n0.1,0.95\n");
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// Column names, the first of them `t`.
    pub columns: Vec<String>,
    /// Rows, each as long as `columns`.
    pub rows: Rows,
}

/// Rows of numbers, all of one length, one after another in memory: 8 bytes a number.
///
/// ```
/// use ancf::run::Rows;
///
/// let rows: Rows = [[0.0, 1.0], [0.1, 0.95]].into_iter().collect();
/// assert_eq!((rows.len(), &rows[1]), (2, &[0.1, 0.95][..]));
/// assert!(rows.iter().all(|row| row.len() == 2));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Length of a row.
    width: usize,
    numbers: Vec<f64>,
}

impl Rows {
    /// No rows, of the length `width`, with memory for `count` of them.
    ///
    /// # Errors
    /// The system's refusal of that memory.
    pub(super) fn with_memory(width: usize, count: usize) -> Result<Rows, TryReserveError> {
        let mut numbers = Vec::new();
        numbers.try_reserve_exact(width.saturating_mul(count))?;
        Ok(Rows { width, numbers })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.numbers.len() / self.width.max(1)
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All rows in order.
    pub fn iter(&self) -> ChunksExact<'_, f64> {
        self.numbers.chunks_exact(self.width.max(1))
    }

    /// First row.
    pub fn first(&self) -> Option<&[f64]> {
        self.iter().next()
    }

    /// Last row.
    pub fn last(&self) -> Option<&[f64]> {
        self.iter().next_back()
    }

    /// Whether the memory asked for is full.
    pub(super) fn is_full(&self) -> bool {
        self.numbers.len() + self.width > self.numbers.capacity()
    }

    /// Adds numbers to the row being written, which is the last when it is as long as the others.
    pub(super) fn extend(&mut self, numbers: impl IntoIterator<Item = f64>) {
        self.numbers.extend(numbers);
    }

    /// The row being written, after `len` whole ones.
    pub(super) fn after(&self, len: usize) -> &[f64] {
        self.numbers.get(len * self.width..).unwrap_or_default()
    }

    /// Drops all but the first `len` rows.
    pub(super) fn truncate(&mut self, len: usize) {
        self.numbers.truncate(len * self.width);
    }
}

impl<R: AsRef<[f64]>> FromIterator<R> for Rows {
    /// # Panics
    /// If the rows are not of one length.
    fn from_iter<I: IntoIterator<Item = R>>(rows: I) -> Rows {
        let mut all = Rows::default();
        for (n, row) in rows.into_iter().enumerate() {
            let row = row.as_ref();
            assert!(n == 0 || row.len() == all.width, "row {n} has {} numbers, the first {}", row.len(), all.width);
            all.width = row.len();
            all.numbers.extend(row);
        }
        all
    }
}

impl<'a> IntoIterator for &'a Rows {
    type Item = &'a [f64];
    type IntoIter = ChunksExact<'a, f64>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl Index<usize> for Rows {
    type Output = [f64];

    fn index(&self, row: usize) -> &[f64] {
        &self.numbers[row * self.width..(row + 1) * self.width]
    }
}

impl IndexMut<usize> for Rows {
    fn index_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.numbers[row * self.width..(row + 1) * self.width]
    }
}

impl Trajectory {
    /// Values of a column; `None` if there is none of this name.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let place = self.columns.iter().position(|column| column == name)?;
        self.rows.iter().map(|row| row.get(place).copied()).collect()
    }

    /// Writes the table as CSV: column names, then a line per row. Numbers have enough digits to be read back as the
    /// identical `f64`.
    ///
    /// # Errors
    /// I/O errors of `out`.
    pub fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "{}", self.columns.join(","))?;
        for row in &self.rows {
            for (column, number) in row.iter().enumerate() {
                let comma = if column == 0 { "" } else { "," };
                write!(out, "{comma}{number:?}")?;
            }
            writeln!(out)?;
        }
        Ok(())
    }
}
