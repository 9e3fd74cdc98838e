//! What the main job says first: what was checked, and what the paper has right and wrong.

use crate::paper::standing::Standing;
use crate::paper::statement::Statement;
use crate::table::{Table, cells};

/// Comparisons of one kind, counted.
pub struct Check {
    pub what: &'static str,
    /// How many are within their bound, and how many there are.
    pub within: usize,
    pub of: usize,
}

/// Width of a line of the terminal.
const WIDTH: usize = 100;
/// Width of what was checked, and of a verdict.
const NAME: usize = 84;
const VERDICT: usize = 24;

impl Check {
    /// Counts outcomes.
    pub fn of(what: &'static str, outcomes: impl Iterator<Item = bool>) -> Check {
        outcomes.fold(Check { what, within: 0, of: 0 }, |check, holds| Check {
            within: check.within + usize::from(holds),
            of: check.of + 1,
            ..check
        })
    }

    /// The check as a line of the terminal.
    pub fn line(&self) -> String {
        let Check { what, within, of } = self;
        let count = format!("{within} of {of}");
        format!("  {what:NAME$}{count:>12}\n")
    }

    fn cells(&self) -> Vec<crate::table::Cell> {
        cells![self.what, format!("{} of {}", self.within, self.of)]
    }
}

/// The checks as a table.
pub fn checks(checks: &[Check]) -> Table {
    Table::new("checked | within the bound", checks.iter().map(Check::cells))
}

/// The statements by verdict, in lines of the terminal.
pub fn verdicts(statements: &[Statement]) -> String {
    let mut text = String::new();
    for (standing, briefs) in by_standing(statements) {
        let head = format!("{standing} ({})", briefs.len());
        text += &format!("  {head:VERDICT$}{}\n", wrapped(&briefs.join("; "), WIDTH - VERDICT - 2, VERDICT + 2));
    }
    text
}

/// The statements of each verdict that there is, in a few words.
fn by_standing(statements: &[Statement]) -> impl Iterator<Item = (Standing, Vec<&'static str>)> {
    Standing::ALL.into_iter().filter_map(|standing| {
        let its = statements.iter().filter(|statement| statement.standing == standing);
        let briefs: Vec<&str> = its.map(|statement| statement.brief).collect();
        (!briefs.is_empty()).then_some((standing, briefs))
    })
}

/// The text in lines of a width; all but the first are indented.
fn wrapped(text: &str, width: usize, indent: usize) -> String {
    let (mut lines, mut length) = (String::new(), 0);
    for word in text.split(' ') {
        let size = word.chars().count();
        if length > 0 && length + 1 + size > width {
            lines += &format!("\n{:indent$}", "");
            length = 0;
        } else if length > 0 {
            lines.push(' ');
            length += 1;
        }
        lines += word;
        length += size;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_counts() {
        let check = Check::of("runs", [true, false, true].into_iter());
        assert_eq!((check.within, check.of), (2, 3));
        assert!(check.line().ends_with("2 of 3\n"));
    }

    #[test]
    fn lines_are_as_wide_as_they_may_be() {
        assert_eq!(wrapped("one two three", 8, 2), "one two\n  three");
        assert_eq!(wrapped("one", 2, 2), "one");
    }
}
