//! The report as plain text, for a terminal.

use super::marks::Marks;
use super::record::Report;

impl Report {
    /// The report as text without marks: the first screen, and a row for each quantity that was asked.
    pub fn text(&self) -> String {
        let marks = Marks::None;
        let mut text = format!("Conformance of {}\n\n", self.program.name);
        text += &format!("{}. {}\n\n", self.headline(), self.counts_text().replace('`', ""));
        for line in self.screen(marks) {
            text += &format!("* {line}\n");
        }
        let rows: Vec<[String; 5]> = self
            .asked_rows()
            .map(|row| {
                let word = row.counts.word().replace('*', "");
                [row.quantity.into(), word, row.counts_text(), row.counts.digits_text(), row.example(marks)]
            })
            .collect();
        let head =
            ["quantity", "", "right / asked / in the fixture", "digits", "smallest failing case"].map(String::from);
        let rows: Vec<&[String; 5]> = [&head].into_iter().chain(&rows).collect();
        let width =
            |n: usize| rows.iter().filter_map(|row| row.get(n)).map(|cell| cell.chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..5).map(width).collect();
        text.push('\n');
        for row in rows {
            let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}"));
            text += cells.collect::<Vec<_>>().join("  ").trim_end();
            text.push('\n');
        }
        text + "\n" + &self.about(marks) + "\n"
    }
}
