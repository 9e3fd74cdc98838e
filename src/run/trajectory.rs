//! Recorded rows of a run.

use std::io::{self, Write};

/// Table of recorded quantities over time.
///
/// ```
/// use ancf::run::Trajectory;
///
/// let columns = vec!["t".to_string(), "tip.x".to_string()];
/// let trajectory = Trajectory { columns, rows: vec![vec![0.0, 1.0], vec![0.1, 0.95]] };
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
    pub rows: Vec<Vec<f64>>,
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
