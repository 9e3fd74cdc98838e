//! The paper's statements on its structure under every reading of the figures that the text does not have.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::claims_section4;
use super::reading::{READINGS, Reading};
use super::scissors::Structure;
use super::standing::Standing;
use super::statement::Statement;
use crate::error::Result;
use crate::files::{Files, written_lines};
use crate::fixture;
use crate::table::{Cell, Table};

/// File that the study writes; `study/readings.json` keeps it.
const FILE: &str = "readings.json";
const KEPT: &str = include_str!("../../readings.json");

/// The statements under every reading.
#[derive(Serialize, Deserialize)]
pub struct Readings {
    pub readings: Vec<Read>,
}

/// The statements under one reading.
#[derive(Serialize, Deserialize)]
pub struct Read {
    pub reading: String,
    /// The statements in a few words, and whether they hold.
    pub standings: Vec<(String, Standing)>,
}

impl Read {
    fn of(reading: &Reading) -> Result<Read> {
        let claims = claims_section4::measure(&Structure::simulate(reading)?);
        let standings =
            claims.iter().map(Statement::from).map(|statement| (statement.brief.into(), statement.standing));
        Ok(Read { reading: reading.name.into(), standings: standings.collect() })
    }
}

impl Readings {
    /// What is kept of the last study.
    pub fn kept() -> Result<Readings> {
        fixture::parse(FILE, KEPT)
    }

    /// A statement's standing under each reading.
    pub fn of<'a>(&'a self, brief: &'a str) -> impl Iterator<Item = (&'a str, Standing)> + Clone {
        self.readings.iter().flat_map(move |read| {
            let its = read.standings.iter().filter(move |(name, _)| name == brief);
            its.map(|(_, standing)| (&*read.reading, *standing))
        })
    }

    /// The statement with its standing under all readings, and the readings that it holds under.
    pub fn judge(&self, statement: Statement) -> Statement {
        let all = self.of(statement.brief);
        let under = |wanted: Standing| {
            let its: Vec<&str> =
                all.clone().filter(|(_, standing)| *standing == wanted).map(|(name, _)| name).collect();
            (!its.is_empty()).then(|| format!("{wanted} under: {}", its.join(", ")))
        };
        let parts: Vec<String> = Standing::ALL.into_iter().filter_map(under).collect();
        let somewhere = |standing: Standing| matches!(standing, Standing::Holds | Standing::InPart);
        let first = all.clone().next().map(|(_, standing)| standing);
        let (verdict, standing) = match (&parts[..], first) {
            ([_], Some(standing)) => (format!("{standing} under every reading"), standing),
            _ if all.clone().any(|(_, standing)| somewhere(standing)) => (parts.join("\n"), Standing::InPart),
            _ => (parts.join("\n"), Standing::Undecided),
        };
        Statement {
            verdict: format!("{verdict}\nThese numbers, as assumed: {}", statement.verdict),
            standing,
            ..statement
        }
    }

    /// Whether the statements under the assumed reading are as they were when the readings were kept.
    pub fn agree<'a>(&'a self, statements: &'a [Statement]) -> impl Iterator<Item = bool> + 'a {
        let kept = |statement: &Statement| self.of(statement.brief).next().map(|(_, standing)| standing);
        statements.iter().map(move |statement| kept(statement) == Some(statement.standing))
    }

    /// A row for each statement, a column for each reading.
    pub fn table(&self) -> Table {
        let columns: String = self.readings.iter().map(|read| format!(" | {}", read.reading)).collect();
        let statements = self.readings.first().map(|read| &read.standings[..]).unwrap_or_default();
        let row = |(brief, _): &(String, Standing)| {
            let standings = self.of(brief).map(|(_, standing)| Cell::from(standing.to_string()));
            std::iter::once(Cell::from(&**brief)).chain(standings).collect()
        };
        Table::new(&format!("statement{columns}"), statements.iter().map(row))
    }
}

/// `ancf readings`: measures the statements under every reading, prints and writes the table.
///
/// # Errors
/// Those of the runs; [`Error::Write`](crate::error::Error::Write).
pub fn study(out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    // First, so that a folder that cannot be written is found before the work.
    let mut files = Files::in_folder(out, [FILE], &[])?;
    let readings = Readings { readings: READINGS.iter().map(Read::of).collect::<Result<_>>()? };
    print(&readings.table().text())?;
    files.write_json(FILE, &readings)?;
    print(&written_lines(&files.publish()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Table;

    fn statement(brief: &'static str, standing: Standing) -> Statement {
        let (measure, verdict) = (String::new(), "as measured".to_string());
        Statement { brief, text: "", measure, numbers: Vec::<Table>::new(), verdict, standing }
    }

    fn readings(standings: [Standing; 2]) -> Readings {
        let read = |(name, standing): (&str, Standing)| Read {
            reading: name.into(),
            standings: vec![("one".into(), standing)],
        };
        Readings { readings: ["as assumed", "other"].into_iter().zip(standings).map(read).collect() }
    }

    #[test]
    fn a_verdict_names_the_readings_it_holds_under() {
        let judged = |standings| readings(standings).judge(statement("one", standings[0]));
        let all = judged([Standing::Holds, Standing::Holds]);
        assert_eq!(all.standing, Standing::Holds);
        assert!(all.verdict.starts_with("holds under every reading"), "{}", all.verdict);
        let part = judged([Standing::Holds, Standing::DoesNot]);
        assert_eq!(part.standing, Standing::InPart);
        assert!(part.verdict.starts_with("holds under: as assumed\ndoes not hold under: other"), "{}", part.verdict);
        assert_eq!(judged([Standing::Undecided, Standing::DoesNot]).standing, Standing::Undecided);
    }

    #[test]
    fn another_standing_than_the_kept_one_is_noticed() {
        let kept = readings([Standing::Holds; 2]);
        let fresh =
            [statement("one", Standing::Holds), statement("one", Standing::DoesNot), statement("two", Standing::Holds)];
        assert_eq!(kept.agree(&fresh).collect::<Vec<_>>(), [true, false, false]);
    }

    #[test]
    fn the_kept_readings_have_every_statement() {
        let kept = Readings::kept().unwrap();
        assert_eq!(kept.readings.len(), READINGS.len());
        assert!(kept.readings.iter().all(|read| read.standings.len() == 11));
    }
}
