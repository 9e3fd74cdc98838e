//! Command line: parsing and printing only.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ancf::error::{Error, Result};
use ancf::report::{self, Files};
use ancf::run::run;
use ancf::scene::{Scene, builtin_names, builtin_text};
use ancf::study;
use clap::{Parser, Subcommand};

/// Planar thermo-elastic ANCF beam (Peng et al. 2018).
///
/// Without a command: the paper's pendulum in all its models, compared with the embedded oracle.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
struct Cli {
    #[command(flatten)]
    out: Out,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(clap::Args)]
struct Out {
    /// Folder for the output files; created if it does not exist.
    #[arg(long = "out", value_name = "DIR", default_value = "out")]
    folder: PathBuf,
}

#[derive(Subcommand)]
enum Command {
    /// Run one scene; writes trajectory.csv and summary.json.
    Run {
        /// Name of a built-in scene, or path of a scene file.
        scene: String,
        #[command(flatten)]
        out: Out,
    },
    /// List the built-in scenes.
    Scenes,
    /// Print a built-in scene as JSON, a file to start from.
    Scene {
        /// Name of the scene.
        name: String,
    },
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let outcome = match &cli.command {
        None => study::main_job(&cli.out.folder, print),
        Some(Command::Run { scene, out }) => run_scene(scene, &out.folder),
        Some(Command::Scenes) => list_scenes(),
        Some(Command::Scene { name }) => builtin_text(name).and_then(print),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Without a standard error there is nobody left to tell.
            let _ = writeln!(io::stderr(), "error: {error}");
            ExitCode::from(error.exit_code())
        }
    }
}

/// `ancf run`.
fn run_scene(name: &str, folder: &Path) -> Result<()> {
    let scene = Scene::load(name)?;
    // First, so that a folder that cannot be written is not found after the run.
    let files = Files::in_folder(folder)?;
    let run = run(&scene)?;
    let paths = report::write_run(files, &scene, &run)?;
    let written: String = paths.iter().map(|file| format!("wrote {}\n", file.display())).collect();
    print(&(report::run_text(&scene, &run) + &written))
}

/// `ancf scenes`.
fn list_scenes() -> Result<()> {
    let width = builtin_names().map(str::len).max().unwrap_or(0);
    let mut list = String::new();
    for name in builtin_names() {
        let title = Scene::load(name)?.title;
        list += &format!("{name:width$}  {title}\n");
    }
    print(&list)
}

/// Prints on standard output; that a reader like `head` has seen enough is no error.
fn print(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::Write { path: "standard output".into(), source })
        }
        _ => Ok(()),
    }
}
