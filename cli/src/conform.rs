//! `ancf conform`: tests another program.

use std::path::{Path, PathBuf};
use std::time::Duration;

use ancf_conform::{Options, Program, Report, Suite, examine};
use ancf_study::files::{Files, written_lines};
use indicatif::ProgressBar;

use ancf_cli::error::{Error, Result};

use crate::{Out, print};

/// Options of `ancf conform`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder with the reference values; those that this program was built with, if it is left out.
    #[arg(long, value_name = "DIR")]
    fixtures: Option<PathBuf>,
    /// Time that one answer may take, s.
    #[arg(long, value_name = "S", default_value = "10", value_parser = seconds)]
    time_limit: Duration,
    /// Never hand over intermediate values, also to a program that takes them.
    #[arg(long)]
    no_given: bool,
    /// Exit code 0 in place of 3 for a program that is right, but answers what it implements in some cases only.
    #[arg(long)]
    allow_partial: bool,
    #[command(flatten)]
    out: Out,
    /// The program and its arguments; it answers lines of JSON with lines of JSON (fixtures/README.md).
    #[arg(last = true, required = true, value_name = "COMMAND")]
    command: Vec<String>,
}

/// Reads a time in seconds.
fn seconds(text: &str) -> std::result::Result<Duration, String> {
    let allowed = || "allowed: a number over 0 and up to 3600".to_string();
    let seconds: f64 = text.parse().map_err(|_| allowed())?;
    if seconds > 0.0 && seconds <= 3600.0 { Ok(Duration::from_secs_f64(seconds)) } else { Err(allowed()) }
}

/// Files that the command writes.
const FILES: [&str; 2] = ["conformance.json", "conformance.md"];

/// `ancf conform`.
pub fn conform(arguments: &Arguments) -> Result<()> {
    let Arguments { fixtures, time_limit, no_given, allow_partial, out, command } = arguments;
    let suite = fixtures.as_deref().map_or_else(Suite::embedded, Suite::load)?;
    let words = command.iter().map(Path::new).chain(fixtures.as_deref());
    let mut files = Files::in_folder(&out.folder, FILES, &words.collect::<Vec<_>>())?;
    let bar = ProgressBar::new(100);
    let mut program = Program::start(command, *time_limit)?;
    let options = Options { given: !no_given };
    let examination = examine(&suite, &mut program, options, |share| bar.set_position((100.0 * share) as u64));
    bar.finish_and_clear();
    let mut report = Report::new(&suite, &examination);
    let text = report.markdown();
    // Keys of JSON in alphabetical order.
    files.identify(serde_json::to_value(&report).unwrap_or_default().to_string().as_bytes());
    report.run = files.run_id();
    files.write("conformance.json", |file| Ok(serde_json::to_writer_pretty(file, &serde_json::to_value(&report)?)?))?;
    files.write_text("conformance.md", text.clone())?;
    let paths = files.publish()?;
    print(&format!("{text}\n{}", written_lines(&paths)))?;
    if !report.passes {
        return Err(Error::NotConforming { summary: report.summary() });
    }
    match report.partly_checked_text() {
        what if !what.is_empty() && !allow_partial => Err(Error::PartlyChecked { what }),
        _ => Ok(()),
    }
}
