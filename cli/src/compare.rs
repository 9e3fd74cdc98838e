//! `ancf compare`: by how much two runs differ.

use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// Largest difference of the times of two rows that belong together, s or of the load.
const SAME_TIME: f64 = 1e-9;

/// Two runs beside each other.
pub struct Comparison {
    rows: usize,
    columns: Vec<Column>,
    is_identical: bool,
}

/// A column of both runs.
struct Column {
    name: String,
    /// Largest difference, and the time of its row.
    difference: f64,
    at: f64,
    /// Largest value of both, what the difference is measured by.
    largest: f64,
}

impl Column {
    /// The difference as a part of the largest value; infinite where one of two is no number.
    fn part(&self) -> f64 {
        if self.difference == 0.0 { 0.0 } else { self.difference / self.largest }
    }
}

/// A run's table.
struct Table {
    path: PathBuf,
    head: Vec<String>,
    rows: Vec<Vec<f64>>,
    text: String,
}

/// Compares two runs, each given by its folder or its table, in these columns, or in all.
///
/// # Errors
/// [`Error::Unreadable`] for files that cannot be read; [`Error::Compare`] for runs that have other columns or rows, or lack a column.
pub fn compare(a: &Path, b: &Path, wanted: &[String]) -> Result<Comparison> {
    let (a, b) = (Table::read(a)?, Table::read(b)?);
    let refused = |reason: String| Error::Compare { a: a.path.clone(), b: b.path.clone(), reason };
    if a.head != b.head {
        let other = |one: &Table, two: &Table| one.head.iter().find(|name| !two.head.contains(name)).cloned();
        let which = other(&a, &b)
            .or_else(|| other(&b, &a))
            .map_or("in another order".into(), |name| format!("`{name}` in one only"));
        return Err(refused(format!("they have other columns, {which}")));
    }
    if a.rows.len() != b.rows.len() {
        return Err(refused(format!("they have {} and {} rows", a.rows.len(), b.rows.len())));
    }
    let apart = a.rows.iter().zip(&b.rows).find(|(a, b)| (a[0] - b[0]).abs() > SAME_TIME * (1.0 + a[0].abs()));
    if let Some((a, b)) = apart {
        return Err(refused(format!("a row is at {} s in one and at {} s in the other", a[0], b[0])));
    }
    let column = |(n, name): (usize, &String)| {
        let mut column = Column { name: name.clone(), difference: 0.0, at: 0.0, largest: 0.0 };
        for (a, b) in a.rows.iter().zip(&b.rows) {
            let (difference, size) = ((a[n] - b[n]).abs(), a[n].abs().max(b[n].abs()));
            // What is no number in one run only differs without bound; in both it is equal.
            let difference = if a[n].is_nan() && b[n].is_nan() {
                0.0
            } else if difference.is_nan() {
                f64::INFINITY
            } else {
                difference
            };
            if difference > column.difference {
                (column.difference, column.at) = (difference, a[0]);
            }
            column.largest = column.largest.max(if size.is_nan() { 0.0 } else { size });
        }
        column
    };
    if let Some(unknown) = wanted.iter().find(|name| !a.head.iter().skip(1).any(|known| known == *name)) {
        return Err(refused(format!(
            "they have no column `{unknown}`, but {}",
            a.head.get(1..).unwrap_or_default().join(", ")
        )));
    }
    let mut columns: Vec<Column> = a.head.iter().enumerate().skip(1).map(column).collect();
    // A balance that is kept is rounding of the energies.
    let is_energy = |column: &Column| column.name.starts_with("energy.");
    let energy = columns.iter().filter(|column| is_energy(column)).map(|column| column.largest).fold(0.0, f64::max);
    columns.iter_mut().filter(|column| is_energy(column)).for_each(|column| column.largest = energy);
    columns.retain(|column| wanted.is_empty() || wanted.contains(&column.name));
    Ok(Comparison { rows: a.rows.len(), columns, is_identical: a.text == b.text })
}

impl Comparison {
    /// A line for each column, and the verdict.
    pub fn text(&self, within: Option<f64>) -> String {
        let width = self.columns.iter().map(|column| column.name.chars().count()).max().unwrap_or(0).max(6);
        let mut text = format!("{:width$}  largest difference  of the largest value  at t\n", "column");
        for column in &self.columns {
            let is_far = within.is_some_and(|within| column.part() > within);
            let mark = if is_far { "  more than --within" } else { "" };
            let at =
                if column.difference > 0.0 { format!("{}", (column.at * 1e9).round() / 1e9) } else { "–".into() };
            text +=
                &format!("{:width$}  {:18.1e}  {:20.1e}  {at}{mark}\n", column.name, column.difference, column.part());
        }
        let rows = self.rows;
        text + &match self.is_identical {
            true => format!("{rows} rows, the same bytes\n"),
            false => format!("{rows} rows, apart by at most {:.1e} of the largest value of a column\n", self.worst()),
        }
    }

    /// The verdict as an outcome.
    ///
    /// # Errors
    /// [`Error::RunsDiffer`].
    pub fn judge(&self, within: f64) -> Result<()> {
        let far: Vec<String> =
            self.columns.iter().filter(|column| column.part() > within).map(|column| column.name.clone()).collect();
        if far.is_empty() {
            Ok(())
        } else {
            Err(Error::RunsDiffer { columns: far.join(", "), worst: self.worst(), within })
        }
    }

    fn worst(&self) -> f64 {
        self.columns.iter().map(Column::part).fold(0.0, f64::max)
    }
}

impl Table {
    fn read(path: &Path) -> Result<Table> {
        let path = if path.is_dir() { path.join("trajectory.csv") } else { path.to_path_buf() };
        let refused = |reason: String| Error::Unreadable { path: path.clone(), reason };
        let text = std::fs::read_to_string(&path).map_err(|error| refused(error.to_string()))?;
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let head: Vec<String> =
            reader.headers().map_err(|error| refused(error.to_string()))?.iter().map(Into::into).collect();
        if head.first().is_none_or(|first| first != "t") {
            return Err(refused(
                "its first column is not `t`; allowed: the trajectory.csv of a run, or the run's folder".into(),
            ));
        }
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| refused(error.to_string()))?;
            let line = record.position().map_or(0, csv::Position::line);
            let number =
                |cell: &str| cell.parse().map_err(|_| refused(format!("line {line} has `{cell}`; allowed: numbers")));
            rows.push(record.iter().map(number).collect::<Result<Vec<f64>>>()?);
        }
        Ok(Table { path, head, rows, text })
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn written(texts: [&str; 2]) -> Result<Comparison> {
        let folder = tempfile::tempdir().unwrap();
        let paths = ["a", "b"].map(|name| folder.path().join(name));
        paths.iter().zip(texts).for_each(|(path, text)| fs::write(path, text).unwrap());
        compare(&paths[0], &paths[1], &[])
    }

    #[test]
    fn differences_are_told_by_column_with_their_time() {
        let comparison = written(["t,x,y\n0,1,0\n0.5,2,-4\n", "t,x,y\n0,1,0\n0.5,2.5,-4\n"]).unwrap();
        assert_eq!((comparison.worst(), comparison.columns[0].at), (0.2, 0.5));
        assert!(comparison.judge(0.2).is_ok());
        let error = comparison.judge(0.1).unwrap_err();
        assert!(error.to_string().contains("x") && error.exit_code() == 1, "{error}");
        assert!(comparison.text(Some(0.1)).contains("more than --within"));
    }

    #[test]
    fn a_balance_is_measured_by_the_energies() {
        let texts =
            ["t,energy.kinetic,energy.balance\n0,100,1e-14\n", "t,energy.kinetic,energy.balance\n0,100,-1e-14\n"];
        assert!(written(texts).unwrap().judge(1e-12).is_ok());
    }

    #[test]
    fn equal_bytes_are_said_and_a_number_that_is_none_agrees_with_nothing_else() {
        let text = "t,x\n0,NaN\n";
        assert!(written([text, text]).unwrap().text(None).contains("the same bytes"));
        assert!(written([text, "t,x\n0,1\n"]).unwrap().judge(1e9).is_err());
    }

    #[test]
    fn what_cannot_be_compared_is_refused_with_the_reason() {
        for (texts, words) in [
            (["t,x\n0,1\n", "t,y\n0,1\n"], "`x` in one only"),
            (["t,x\n0,1\n", "t,x\n"], "1 and 0 rows"),
            (["t,x\n0,1\n", "t,x\n1,1\n"], "at 0 s in one and at 1 s"),
            (["t,x\n0,1\n", "t,x\n0,one\n"], "`one`"),
            (["a,x\n0,1\n", "t,x\n0,1\n"], "first column"),
        ] {
            let Err(error) = written(texts) else { panic!("{texts:?} were compared") };
            assert!(error.to_string().contains(words) && error.exit_code() == 2, "{error}");
        }
    }
}
