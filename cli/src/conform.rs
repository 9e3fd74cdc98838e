//! `ancf conform`: tests another program.

use std::cell::Cell;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use ancf_conform::report::{RefusalVerdict, junit};
use ancf_conform::trajectory::{Request, compare};
use ancf_conform::{Examination, Options, Program, Recorded, Recorder, Report, Selection, Suite, examine};
use ancf_study::error::Error as StudyError;
use ancf_study::files::{Files, written_lines};
use clap::ValueEnum;
use indicatif::ProgressBar;

use ancf_cli::error::{Error, Result};

use crate::{Out, print, print_data};

/// Options of `ancf conform`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder with the reference values; those that this program was built with, if it is left out.
    #[arg(long, value_name = "DIR")]
    fixtures: Option<PathBuf>,
    /// Time that one answer may take, s.
    #[arg(long, value_name = "S", default_value = "10", value_parser = seconds)]
    time_limit: Duration,
    /// Ask for these quantities only: names such as 21.K_1, or their first parts, such as 21 or cable.
    #[arg(long, value_name = "QUANTITY", num_args = 1..)]
    only: Vec<String>,
    /// Ask in these states only, by their names in the fixtures (cable- stands before those of cable.json).
    #[arg(long, value_name = "ID", num_args = 1..)]
    state: Vec<String>,
    /// Never hand over intermediate values, also to a program that takes them.
    #[arg(long)]
    no_given: bool,
    /// Correct digits that every answer must have, relative to the terms that are added up, from 1 to 16; exit code 1 where one has
    /// fewer [default: what the program's own precision allows].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=16))]
    digits: Option<u8>,
    /// Exit code 0 in place of 3 for a program that is right, but answers what it implements in some cases only.
    #[arg(long)]
    allow_partial: bool,
    /// Exit code 1 also for a program that is right, but does not refuse all invalid states.
    #[arg(long)]
    must_refuse: bool,
    /// What is printed. The files are written in any case.
    #[arg(long, value_enum, default_value = "markdown")]
    format: Format,
    /// Write all questions to a file, a line each, for a program that is slow or cannot be started. With --answers: those without an
    /// answer.
    #[arg(long, value_name = "FILE")]
    questions: Option<PathBuf>,
    /// Judge the answers of files, a line each in any order, in place of a program.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    answers: Vec<PathBuf>,
    #[command(flatten)]
    out: Out,
    #[command(flatten)]
    motion: MotionOptions,
    /// The program and its arguments; it answers lines of JSON with lines of JSON (fixtures/PROTOCOL.md).
    #[arg(last = true, required_unless_present_any = ["questions", "answers", "trajectory"], conflicts_with_all = ["questions", "answers"])]
    #[arg(value_name = "COMMAND")]
    command: Vec<String>,
}

/// A motion in place of a program.
#[derive(clap::Args)]
#[command(next_help_heading = "A motion in place of a program")]
struct MotionOptions {
    /// Motion that a program wrote, CSV or JSON, to compare with one of the fixtures; a second file with another step shows the order.
    #[arg(long, value_name = "FILE", num_args = 1..=2, requires = "scene", conflicts_with = "command")]
    trajectory: Vec<PathBuf>,
    /// Name of that motion; an unknown name lists all.
    #[arg(long, value_name = "ID", requires = "trajectory")]
    scene: Option<String>,
    /// Steps of the files, s, where they do not say so themselves.
    #[arg(long, value_name = "A,B", value_delimiter = ',', requires = "trajectory")]
    steps: Vec<f64>,
}

/// Formats of the report on standard output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Markdown, as in conformance.md.
    Markdown,
    /// Plain text for a terminal.
    Text,
    /// JSON, as in conformance.json.
    Json,
    /// JUnit XML: a suite for each quantity, a case for each state.
    Junit,
}

/// Reads a time in seconds.
fn seconds(text: &str) -> std::result::Result<Duration, String> {
    let allowed = || "allowed: a number over 0 and up to 3600".to_string();
    let seconds: f64 = text.parse().map_err(|_| allowed())?;
    if seconds > 0.0 && seconds <= 3600.0 { Ok(Duration::from_secs_f64(seconds)) } else { Err(allowed()) }
}

/// Files that the command writes.
const FILES: [&str; 2] = ["conformance.json", "conformance.md"];
/// Answers so far, while a program is asked. It stays only if the command is ended before its report.
const PARTIAL: &str = "conformance.partial.jsonl";
/// Time after which the user is told of that file.
const LONG: Duration = Duration::from_secs(5);

/// `ancf conform`.
pub fn conform(arguments: &Arguments) -> Result<()> {
    if let MotionOptions { trajectory, scene: Some(scene), steps } = &arguments.motion {
        let request = Request { files: trajectory.clone(), scene: scene.clone(), steps: steps.clone() };
        return compare_motion(&request, &arguments.out.folder);
    }
    let suite = arguments.fixtures.as_deref().map_or_else(Suite::embedded, Suite::load)?;
    let options =
        Options { given: !arguments.no_given, asked: Selection::new(&suite, &arguments.only, &arguments.state)? };
    match &arguments.questions {
        Some(path) if arguments.answers.is_empty() => write_questions(&suite, options, path),
        _ => judge(&suite, options, arguments),
    }
}

/// Writes all questions to a file: those that a program without any answer leaves open.
fn write_questions(suite: &Suite, options: Options, path: &Path) -> Result<()> {
    let mut nothing = Recorded::default();
    examine(suite, &mut nothing, options, |_| {});
    let written = write_lines(path, nothing.unanswered(), &[])?;
    Ok(print(&format!(
        "{} questions. Answer them in any order, a line each; then: ancf conform --answers FILE\n{}",
        nothing.unanswered().len() - 1,
        written_lines(&written)
    ))?)
}

/// Asks, and writes the report.
fn judge(suite: &Suite, options: Options, arguments: &Arguments) -> Result<()> {
    let Arguments { fixtures, answers, command, out, .. } = arguments;
    let inputs: Vec<&Path> =
        command.iter().map(Path::new).chain(fixtures.as_deref()).chain(answers.iter().map(PathBuf::as_path)).collect();
    let mut files = Files::in_folder(&out.folder, FILES, &inputs)?;
    let mut written = Vec::new();
    let partial = out.folder.join(PARTIAL);
    let examination = if command.is_empty() {
        let mut recorded = read_answers(suite, answers)?;
        let examination = examine(suite, &mut recorded, options, |_| {});
        if let Some(path) = &arguments.questions {
            written = write_lines(path, recorded.unanswered(), &inputs)?;
        }
        examination
    } else {
        let mut program = Program::start(command, arguments.time_limit)?;
        ask(suite, &mut program, options, &partial)?
    };
    let mut report = Report::new(suite, &examination);
    if let Some(digits) = arguments.digits {
        report.demand(suite, &examination, digits);
    }
    let text = report.markdown();
    // Keys of JSON in alphabetical order.
    files.identify(serde_json::to_value(&report).unwrap_or_default().to_string().as_bytes());
    report.run = files.run_id();
    let json = serde_json::to_value(&report).unwrap_or_default();
    files.write("conformance.json", |file| Ok(serde_json::to_writer_pretty(file, &json)?))?;
    files.write_text("conformance.md", text.clone())?;
    written.extend(files.publish()?);
    if !command.is_empty() {
        // The report has all that it holds.
        let _ = fs::remove_file(&partial);
    }
    match arguments.format {
        Format::Markdown => print(&format!("{text}\n{}", written_lines(&written)))?,
        Format::Text => print(&format!("{}\n{}", report.text(), written_lines(&written)))?,
        Format::Json => print_data(&format!("{json:#}\n"))?,
        Format::Junit => print_data(&junit(suite, &examination, &report, arguments.must_refuse))?,
    }
    outcome(&report, arguments)
}

/// `ancf conform --trajectory`.
fn compare_motion(request: &Request, folder: &Path) -> Result<()> {
    let read: Vec<&Path> = request.files.iter().map(PathBuf::as_path).collect();
    let mut files = Files::in_folder(folder, FILES, &read)?;
    let mut outcome = compare(request)?;
    let text = outcome.markdown();
    files.identify(serde_json::to_value(&outcome).unwrap_or_default().to_string().as_bytes());
    outcome.run = files.run_id();
    let json = serde_json::to_value(&outcome).unwrap_or_default();
    files.write("conformance.json", |file| Ok(serde_json::to_writer_pretty(file, &json)?))?;
    files.write_text("conformance.md", text.clone())?;
    let paths = files.publish()?;
    print(&format!("{text}\n{}", written_lines(&paths)))?;
    if outcome.passes() { Ok(()) } else { Err(Error::OtherMotion { summary: outcome.summary }) }
}

/// The error that a report comes to, for the exit code.
fn outcome(report: &Report, arguments: &Arguments) -> Result<()> {
    if !report.passes {
        return Err(Error::NotConforming { summary: report.summary() });
    }
    if arguments.must_refuse && report.refusal.verdict == RefusalVerdict::ShouldRefuse {
        return Err(Error::NotRefusing { states: report.refusal.accepted + report.refusal.no_answer });
    }
    match report.partly_checked_text() {
        what if !what.is_empty() && !arguments.allow_partial => {
            Err(Error::PartlyChecked { what, left_out: report.left_out.clone() })
        }
        _ => Ok(()),
    }
}

/// Asks a program, and keeps its answers as they come: if this process is ended, they are left to be judged.
fn ask(suite: &Suite, program: &mut Program, options: Options, partial: &Path) -> Result<Examination> {
    let (started, told, bar) = (Instant::now(), Cell::new(false), ProgressBar::new(100));
    let progress = |share: f64| {
        bar.set_position((100.0 * share) as u64);
        if started.elapsed() > LONG && !told.replace(true) {
            let path = partial.display();
            // Without a standard error there is nobody to tell.
            bar.suspend(|| {
                let _ = writeln!(
                    io::stderr(),
                    "answers so far: {path}; `ancf conform --answers {path}` judges them, also if this run is ended"
                );
            });
        }
    };
    // A new file, so that two runs into one folder never write to the same one.
    let _ = fs::remove_file(partial);
    let file = File::create_new(partial).map_err(|source| unwritable(partial, source))?;
    let mut recorder = Recorder::new(program, suite, file);
    let examination = examine(suite, &mut recorder, options, progress);
    bar.finish_and_clear();
    match recorder.into_error() {
        Some(source) => Err(unwritable(partial, source)),
        None => Ok(examination),
    }
}

fn unwritable(path: &Path, source: io::Error) -> Error {
    Error::Study(StudyError::Write { path: path.into(), source })
}

/// Reads the answers of files.
fn read_answers(suite: &Suite, paths: &[PathBuf]) -> Result<Recorded> {
    let mut recorded = Recorded::default();
    for path in paths {
        let bytes = fs::read(path).map_err(|source| ancf_conform::Error::Read { path: path.clone(), source })?;
        recorded.read(suite, &String::from_utf8_lossy(&bytes), &path.display().to_string())?;
    }
    Ok(recorded)
}

/// Writes lines to a file, whole or not at all; to a device or a pipe as they are, for nothing may be put in its place.
fn write_lines(path: &Path, lines: &[String], inputs: &[&Path]) -> Result<Vec<PathBuf>> {
    // A link stays one.
    let path = &path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
    if path.metadata().is_ok_and(|known| !known.is_file() && !known.is_dir()) {
        let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
        fs::write(path, text).map_err(|source| unwritable(path, source))?;
        return Ok(vec![path.clone()]);
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let mut files = Files::in_folder(folder, [name.clone()], inputs)?;
    files.write(&name, |file| lines.iter().try_for_each(|line| writeln!(file, "{line}")))?;
    Ok(files.publish()?)
}
