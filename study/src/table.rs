//! Tables: rows of cells under named columns, as aligned text, HTML or CSV.

use std::fmt::Write as _;
use std::io::{self, Write};

use crate::escape;

/// How the cells of a column are shown to people; CSV has every digit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Format {
    /// Words, aligned to the left.
    Words,
    /// Numbers with so many decimals, aligned to the right.
    Fixed(usize),
    /// Numbers with a power of ten and so many decimals, aligned to the right.
    Power(usize),
}

/// One cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    Words(String),
    Number(f64),
    Count(usize),
    /// Nothing to show: "–", in CSV an empty field.
    Missing,
}

/// A table: columns with heading and format, and rows of as many cells.
#[derive(Clone, Debug)]
pub struct Table {
    columns: Vec<(String, Format)>,
    rows: Vec<Vec<Cell>>,
}

/// A row of cells from values of any type that makes a [`Cell`].
macro_rules! cells {
    ($($cell:expr),+ $(,)?) => { vec![$($crate::table::Cell::from($cell)),+] };
}
pub(crate) use cells;

impl Table {
    /// A table of columns and rows. Bars separate the columns; a heading ends with the format of its numbers, `:.6` or `:.1e`, and columns
    /// without one have words: `"run | distance, m :.1e | verdict"`.
    pub fn new(columns: &str, rows: impl IntoIterator<Item = Vec<Cell>>) -> Table {
        let column = |column: &str| {
            let (heading, format) = column.rsplit_once(":.").unwrap_or((column, ""));
            let format = match (format.strip_suffix('e').map(str::parse), format.parse()) {
                (Some(Ok(digits)), _) => Format::Power(digits),
                (_, Ok(digits)) => Format::Fixed(digits),
                _ => Format::Words,
            };
            (heading.trim().to_string(), format)
        };
        Table { columns: columns.split(" | ").map(column).collect(), rows: rows.into_iter().collect() }
    }

    /// The headings and the cells of every row as they are shown.
    fn shown(&self) -> impl Iterator<Item = Vec<String>> {
        let heading = self.columns.iter().map(|(heading, _)| heading.clone()).collect();
        let rows = self
            .rows
            .iter()
            .map(|row| row.iter().zip(&self.columns).map(|(cell, (_, format))| cell.shown(*format)).collect());
        std::iter::once(heading).chain(rows)
    }

    /// The table as text: indented, each column as wide as its widest cell. Control characters are escaped, so that a cell keeps to its line.
    pub fn text(&self) -> String {
        let printable = |cell: String| escape::line(&cell);
        let lines: Vec<Vec<String>> = self.shown().map(|line| line.into_iter().map(printable).collect()).collect();
        let width = |n: usize| lines.iter().map(|line| line[n].chars().count()).max().unwrap_or(0);
        let columns: Vec<(usize, Format)> =
            self.columns.iter().enumerate().map(|(n, (_, format))| (width(n), *format)).collect();
        let mut text = String::new();
        for line in &lines {
            let mut row = String::from(" ");
            for (cell, (width, format)) in line.iter().zip(&columns) {
                // Writing into a string cannot fail.
                let _ = match format {
                    Format::Words => write!(row, "  {cell:width$}"),
                    _ => write!(row, "  {cell:>width$}"),
                };
            }
            text = text + row.trim_end() + "\n";
        }
        text
    }

    /// The table as an HTML element, all text escaped.
    pub fn html(&self) -> String {
        let mut lines = self.shown().map(|line| line.into_iter().map(|cell| escape::html(&cell)).collect::<Vec<_>>());
        let head = lines.next().unwrap_or_default().join("</th><th>");
        let rows: String = lines.map(|line| format!("<tr><td>{}</td></tr>\n", line.join("</td><td>"))).collect();
        format!(
            "<div class=\"wide\"><table>\n<thead><tr><th>{head}</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
        )
    }

    /// Writes the table as CSV: numbers with as many digits as read back to the same value, words so that no spreadsheet takes them for
    /// formulas.
    pub fn csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(self.columns.iter().map(|(heading, _)| heading))?;
        for row in &self.rows {
            writer.write_record(row.iter().map(Cell::in_csv))?;
        }
        writer.flush()
    }
}

impl Cell {
    fn shown(&self, format: Format) -> String {
        match (self, format) {
            (Cell::Missing, _) => "–".into(),
            (Cell::Number(number), Format::Fixed(digits)) => format!("{number:.digits$}"),
            (Cell::Number(number), Format::Power(digits)) => format!("{number:.digits$e}"),
            _ => self.whole(),
        }
    }

    fn in_csv(&self) -> String {
        match self {
            Cell::Words(words) => escape::csv_cell(words),
            _ => self.whole(),
        }
    }

    fn whole(&self) -> String {
        match self {
            Cell::Words(words) => words.clone(),
            Cell::Number(number) => format!("{number:?}"),
            Cell::Count(count) => count.to_string(),
            Cell::Missing => String::new(),
        }
    }
}

impl From<&str> for Cell {
    fn from(words: &str) -> Cell {
        Cell::Words(words.into())
    }
}

impl From<String> for Cell {
    fn from(words: String) -> Cell {
        Cell::Words(words)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Cell {
        Cell::Number(number)
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Cell {
        Cell::Count(count)
    }
}

impl<T> From<Option<T>> for Cell
where
    Cell: From<T>,
{
    fn from(value: Option<T>) -> Cell {
        value.map_or(Cell::Missing, Cell::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        Table::new(
            "<run> | error, m :.1e | steps :.0",
            [cells!["a\nb", 1.0 / 3.0, 12], cells!["<long> name", None::<f64>, 7]],
        )
    }

    #[test]
    fn text_is_aligned_and_keeps_to_its_lines() {
        let text =
            "   <run>        error, m  steps\n   a\\nb           3.3e-1     12\n   <long> name         –      7\n";
        assert_eq!(table().text(), text);
    }

    #[test]
    fn html_is_escaped() {
        let html = table().html();
        assert!(html.contains("<th>&lt;run&gt;</th>") && html.contains("<td>&lt;long&gt; name</td>"), "{html}");
        assert!(!html.contains("<run>") && !html.contains("<long>"));
    }

    #[test]
    fn csv_reads_back_to_the_same_cells() {
        let mut csv = Vec::new();
        table().csv(&mut csv).unwrap();
        let mut reader = csv::Reader::from_reader(&csv[..]);
        assert_eq!(reader.headers().unwrap(), vec!["<run>", "error, m", "steps"]);
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows[0], vec!["a\nb", "0.3333333333333333", "12"]);
        assert_eq!(rows[0][1].parse(), Ok(1.0 / 3.0));
        assert_eq!(rows[1], vec!["<long> name", "", "7"]);
    }

    #[test]
    fn csv_has_numbers_as_they_are_and_no_formulas() {
        let mut csv = Vec::new();
        Table::new("a | b :.0 | c", [cells!["=1+1", -2.0, "\u{1b}[2J"]]).csv(&mut csv).unwrap();
        assert_eq!(String::from_utf8(csv).unwrap(), "a,b,c\n'=1+1,-2.0,\\u{1b}[2J\n");
    }
}
