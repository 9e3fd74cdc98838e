//! Motions as CSV with a header.

use std::collections::BTreeMap;

use super::column::{Column, column, decimals};
use super::written::{COLUMNS, Written, fault};
use crate::error::Result;

/// Step in a comment such as `# step = 1e-4`.
fn step_of(comment: &str) -> Option<f64> {
    let comment = comment.to_lowercase();
    let at = ["step", "dt"].iter().find_map(|word| Some(comment.find(word)? + word.len()))?;
    let rest = comment.get(at..)?.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '.');
    let end = rest.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | '-' | '+'))).unwrap_or(rest.len());
    rest.get(..end)?.parse().ok().filter(|step: &f64| *step > 0.0)
}

/// Reads CSV. `points` are the names of the scene's points.
///
/// # Errors
/// [`Error::Motion`](crate::error::Error::Motion).
pub fn csv(text: &str, file: &str, points: &[&str]) -> Result<Written> {
    let mut written = Written { rounding: f64::INFINITY, ..Written::default() };
    let mut lines = text.lines().enumerate().map(|(n, line)| (n + 1, line.trim())).filter(|(_, line)| !line.is_empty());
    let (number, header) = loop {
        match lines.next() {
            Some((_, line)) if line.starts_with(['#', '%']) => {
                written.step = written.step.or(step_of(line));
                // A header may be commented out, as numpy.savetxt does.
                let bare = line.trim_start_matches(['#', '%']).trim();
                if split(bare, delimiter(bare)).first().is_some_and(|name| column(name, points) == Some(Column::Time)) {
                    break (0, bare);
                }
            }
            Some((number, line)) => break (number, line),
            None => return Err(fault(file, "line 1", "there are no lines", COLUMNS)),
        }
    };
    let separator = delimiter(header);
    let names = split(header, separator);
    let headless = names.iter().all(|name| name.replace(',', ".").parse::<f64>().is_ok());
    let mut columns: Vec<Option<Column>> = if headless {
        let [point] = points else {
            return Err(fault(file, format!("line {number}"), "numbers without a header", COLUMNS));
        };
        let all = [
            Column::Time,
            Column::Position(point.to_string(), 0),
            Column::Position(point.to_string(), 1),
            Column::Velocity(point.to_string(), 0),
            Column::Velocity(point.to_string(), 1),
        ];
        if !matches!(names.len(), 3 | 5) {
            let value = format!("{} numbers without a header", names.len());
            return Err(fault(file, format!("line {number}"), value, COLUMNS));
        }
        all.into_iter().take(names.len()).map(Some).collect()
    } else {
        names.iter().map(|name| column(name, points)).collect()
    };
    for n in 0..columns.len() {
        let repeated = columns[n].is_some() && columns[..n].contains(&columns[n]);
        if repeated {
            let place = format!("line {number}, column `{}`", names[n]);
            return Err(fault(file, place, "a second column of this meaning", "one of each"));
        }
    }
    if !columns.contains(&Some(Column::Time)) {
        return Err(fault(file, format!("line {number}"), format!("`{header}` has no column `t`"), COLUMNS));
    }
    written.ignored =
        names.iter().zip(&columns).filter(|(_, column)| column.is_none()).map(|(name, _)| name.to_string()).collect();
    let mut table: Vec<Vec<f64>> = vec![Vec::new(); columns.len()];
    let first = headless.then_some((number, header));
    for (number, line) in first.into_iter().chain(lines) {
        if line.starts_with(['#', '%']) {
            written.step = written.step.or(step_of(line));
            continue;
        }
        let cells = split(line, separator);
        if cells.len() != columns.len() {
            let value = format!("{} columns", cells.len());
            return Err(fault(file, format!("line {number}"), value, format!("{}, as in the header", columns.len())));
        }
        for ((cell, column), (name, list)) in cells.iter().zip(&columns).zip(names.iter().zip(&mut table)) {
            let Some(column) = column else { continue };
            let cell = if separator == Some(',') { cell.to_string() } else { cell.replace(',', ".") };
            let Ok(value) = cell.parse::<f64>() else {
                let place = if headless { format!("line {number}") } else { format!("line {number}, column `{name}`") };
                return Err(fault(file, place, format!("`{cell}`"), "a number"));
            };
            if matches!(column, Column::Position(..)) && value.is_finite() {
                written.rounding = written.rounding.min(0.5 * 10f64.powi(-decimals(&cell)));
            }
            list.push(value);
        }
    }
    let mut halves: BTreeMap<(bool, String), [Option<Vec<f64>>; 2]> = BTreeMap::new();
    for (column, list) in columns.iter_mut().zip(table) {
        match column.take() {
            Some(Column::Time) => written.frames.t = list,
            Some(Column::Position(point, n)) => halves.entry((false, point)).or_default()[n] = Some(list),
            Some(Column::Velocity(point, n)) => halves.entry((true, point)).or_default()[n] = Some(list),
            Some(Column::Energy(name)) => _ = written.frames.energy.insert(name.into(), list),
            None => {}
        }
    }
    for ((is_velocity, point), halves) in halves {
        let [Some(x), Some(y)] = halves else {
            let value = format!("only one component of `{point}`");
            return Err(fault(file, format!("line {number}"), value, "both: x and y"));
        };
        let table = if is_velocity { &mut written.frames.velocity } else { &mut written.frames.position };
        table.insert(point, x.into_iter().zip(y).map(|(x, y)| [x, y]).collect());
    }
    Ok(written)
}

/// What separates the columns of a header; `None` for blanks.
fn delimiter(header: &str) -> Option<char> {
    [';', '\t', ','].into_iter().find(|separator| header.contains(*separator))
}

fn split(line: &str, separator: Option<char>) -> Vec<&str> {
    match separator {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    }
}
