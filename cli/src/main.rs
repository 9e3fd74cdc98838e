//! Command line: parsing and printing only.

mod conform;

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ancf::internals::model::{Scissors, Words, builtin_names, builtin_text};
use ancf::model::{Model, ThermalModel};
use ancf::run::About;
use ancf_conform::{equations_text, load_state};
use ancf_study::escape;
use ancf_study::files::written_lines;
use ancf_study::{error_time, stability};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{CommandFactory, Parser, Subcommand};

use ancf_cli::cost::cost_text;
use ancf_cli::error::{Error, Result};
use ancf_cli::options::Options;
use ancf_cli::summary::refused_line;
use ancf_cli::{compare, modes, report, run, source};

/// Planar thermo-elastic ANCF beam (Peng et al. 2018).
///
/// Without a command: the paper's pendulum and deployable structure in all their models, compared with the embedded oracles;
/// tables, pictures and what the paper says, measured.
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
    /// Run one scene; writes trajectory.csv, summary.json and report.html, in which the structure moves.
    Run {
        #[command(flatten)]
        scene: SceneArguments,
        /// Estimate the errors of all columns in time and space by finer runs, and try the stability of the motion by a perturbed
        /// one: some six times the work.
        #[arg(long)]
        estimate: bool,
        /// Write files for ParaView, too: axis.pvd and surface.pvd.
        #[arg(long)]
        vtk: bool,
        /// Write no report.html, and compute nothing for it.
        #[arg(long)]
        no_report: bool,
        /// Print the summary as one line of JSON in place of a text: also of a run that fails, and of a scene that is refused.
        #[arg(long)]
        summary_line: bool,
        #[command(flatten)]
        out: Out,
        // Last, as the heading of its options holds for what follows.
        #[command(flatten)]
        scissors: ScissorsOptions,
    },
    /// Error against run time: every method, mesh and step, beside converged references; writes error-time.csv, .json, .svg
    /// and .html.
    ErrorTime {
        /// Scenes of the study, or scene files of your own: for these a reference is computed first. All of the study if none is
        /// named.
        #[arg(value_name = "SCENE")]
        scenes: Vec<String>,
        #[command(flatten)]
        out: Out,
        /// Command of another program that runs the same scenes, in turns with this one on the same core: "python -m oracle.peers".
        #[arg(long, value_name = "COMMAND")]
        peer: Option<String>,
        /// Write the converged references of the scenes instead, into DIR or fixtures/converged.
        #[arg(long, value_name = "DIR", num_args = 0..=1, require_equals = true, default_missing_value = "fixtures/converged")]
        references: Option<PathBuf>,
        /// A coarse grid: of the flexible pendulum, if no scene is named.
        #[arg(long)]
        quick: bool,
    },
    /// Stiff and extreme cases in one table, each row right, refused or WRONG; writes stability.csv, .json, .svg and .html.
    Stability {
        /// Cases of the table; all of them if none is named.
        #[arg(value_name = "CASE")]
        cases: Vec<String>,
        #[command(flatten)]
        out: Out,
    },
    /// The paper's statements on its structure under every reading of the figures that its text does not have; writes readings.json.
    Readings {
        #[command(flatten)]
        out: Out,
    },
    /// Natural frequencies and shapes of a scene's structure, and the factor at which it buckles; writes modes.json and modes.html.
    Modes {
        #[command(flatten)]
        scene: SceneArguments,
        /// State to vibrate about: as built, in equilibrium under the heat alone, or under all loads [default: loaded in statics and for
        /// --buckling, otherwise unloaded].
        #[arg(long, value_name = "STATE", value_parser = about())]
        about: Option<About>,
        /// Number of vibrations, after the motions without a force.
        #[arg(long, value_name = "N", default_value_t = 6)]
        number: usize,
        /// Find the multiple of the loads (with `--about heated`, of the heat) at which the structure buckles.
        #[arg(long)]
        buckling: bool,
        #[command(flatten)]
        out: Out,
        #[command(flatten)]
        scissors: ScissorsOptions,
    },
    /// Say what is computed for a scene, what is left out, and why.
    Plan {
        #[command(flatten)]
        scene: SceneArguments,
        /// Make steps for half a second, and say how long the run will take and how much memory.
        #[arg(long)]
        cost: bool,
        #[command(flatten)]
        scissors: ScissorsOptions,
    },
    /// Print the value of every equation for one state.
    Equations {
        /// A file with the state of an element, in the shape of those of fixtures/equations.json or fixtures/cable.json; or the name of
        /// a stored one, also of a case of fixtures/structure.json (cable- stands before the names of fixtures/cable.json).
        state: String,
    },
    /// Compare two runs column by column: by how much they differ, and where.
    Compare(Compare),
    /// Test another implementation: which equation is wrong, and what kind of mistake fits; writes conformance.json and
    /// conformance.md.
    Conform(conform::Arguments),
    /// Print a script that completes commands and options in a shell.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// List the built-in scenes.
    Scenes,
    /// Print a built-in scene as JSON, a file to start from.
    Scene {
        /// Name of the scene.
        name: String,
        #[command(flatten)]
        scissors: ScissorsOptions,
    },
}

/// A scene, and changes to it.
#[derive(clap::Args)]
struct SceneArguments {
    /// Name of a built-in scene; path of a scene file, or of a summary.json, whose run is repeated; `-`: standard input.
    scene: String,
    /// Change a key of the scene, any number of times: time.step=1e-4, rods.0.elements=16, or an entry of a list by its name,
    /// rods.boom.elements=16. The value is JSON, or a word.
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
}

/// Two runs to be compared.
#[derive(clap::Args)]
struct Compare {
    /// Folder of a run, or its trajectory.csv.
    a: PathBuf,
    /// Folder of the other run, or its trajectory.csv.
    b: PathBuf,
    /// Fail where a column differs by more than this part of its largest value; energies by that of the largest energy.
    #[arg(long, value_name = "PART", value_parser = part)]
    within: Option<f64>,
    /// Compare these columns only.
    #[arg(long, value_name = "COLUMN", value_delimiter = ',')]
    columns: Vec<String>,
}

/// Reads a part, 0 or more.
fn part(text: &str) -> std::result::Result<f64, &'static str> {
    text.parse().ok().filter(|part: &f64| *part >= 0.0).ok_or("allowed: a number from 0 on, such as 1e-9")
}

/// What can be changed in the scenes `scissors-<n>`.
#[derive(clap::Args)]
#[command(next_help_heading = "Scenes scissors-<n>")]
struct ScissorsOptions {
    /// Angle between the rods and the x axis at the start, degrees, over 0 and under 90 [default: 80].
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    angle: Option<f64>,
    /// Force at a1, N, downwards [default: 50].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    force: Option<f64>,
    /// Which strains the changing temperature causes [default: 2d if the name ends in -thermal, else none].
    #[arg(long, value_name = "MODEL", value_parser = model())]
    temperature: Option<ThermalModel>,
}

/// Reads the word for a thermal model.
fn model() -> impl TypedValueParser<Value = ThermalModel> {
    let known = PossibleValuesParser::new(ThermalModel::WORDS);
    known.try_map(|word| ThermalModel::from_word(&word).ok_or("not a thermal model"))
}

/// Reads the word for a state.
fn about() -> impl TypedValueParser<Value = About> {
    let known = PossibleValuesParser::new(About::ALL.map(About::word));
    known.try_map(|word| About::ALL.into_iter().find(|about| about.word() == word).ok_or("not a state"))
}

impl ScissorsOptions {
    /// The structure of a scene's name with these changes; `None` if there are none.
    fn change(&self, name: &str) -> Result<Option<Scissors>> {
        let given = [
            self.angle.map(|angle| ("--angle", angle.to_string())),
            self.force.map(|force| ("--force", force.to_string())),
            self.temperature.map(|model| ("--temperature", model.to_string())),
        ];
        let Some((option, value)) = given.into_iter().flatten().next() else { return Ok(None) };
        let Some(scissors) = Scissors::named(name) else {
            let allowed = "this option for the scenes `scissors-<n>` and `scissors-<n>-thermal` only".into();
            return Err(ancf::error::Error::Scene { file: name.into(), key: option.into(), value, allowed }.into());
        };
        Ok(Some(Scissors {
            angle: self.angle.unwrap_or(scissors.angle),
            force: self.force.unwrap_or(scissors.force),
            model: self.temperature.unwrap_or(scissors.model),
            ..scissors
        }))
    }
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let outcome = match &cli.command {
        None => ancf_study::main_job(&cli.out.folder, print).map_err(Error::from),
        Some(Command::Run { scene, estimate, vtk, no_report, summary_line, out, scissors }) => {
            let options = Options { estimate: *estimate, page: !no_report, vtk: *vtk, set: &scene.set };
            run_scene(scene, options, *summary_line, scissors, &out.folder)
        }
        Some(Command::ErrorTime { scenes, references: Some(folder), .. }) => write_references(scenes, folder),
        Some(Command::ErrorTime { scenes, out, peer, quick, .. }) => {
            let options = error_time::Options { scenes: scenes.clone(), peer: peer.clone(), quick: *quick };
            error_time::study(&options, &out.folder, print).map_err(Error::from)
        }
        Some(Command::Equations { state }) => print_equations(state),
        Some(Command::Conform(arguments)) => conform::conform(arguments),
        Some(Command::Stability { cases, out }) => stability::study(cases, &out.folder, print).map_err(Error::from),
        Some(Command::Readings { out }) => ancf_study::readings(&out.folder, print).map_err(Error::from),
        Some(Command::Modes { scene, about, number, buckling, out, scissors }) => {
            let options = modes::Options { about: *about, number: *number, buckling: *buckling };
            print_modes(scene, options, scissors, &out.folder)
        }
        Some(Command::Plan { scene, cost, scissors }) => print_plan(scene, *cost, scissors),
        Some(Command::Compare(arguments)) => compare_runs(arguments),
        Some(Command::Completions { shell }) => {
            clap_complete::generate(*shell, &mut Cli::command(), "ancf", &mut io::stdout());
            Ok(())
        }
        Some(Command::Scenes) => list_scenes(),
        Some(Command::Scene { name, scissors }) => print_scene(name, scissors),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Without a standard error there is nobody left to tell.
            let _ = writeln!(io::stderr(), "error: {}", escape::line(&error.to_string()));
            ExitCode::from(error.exit_code())
        }
    }
}

/// `ancf run`.
fn run_scene(
    scene: &SceneArguments,
    options: Options,
    summary_line: bool,
    scissors: &ScissorsOptions,
    folder: &Path,
) -> Result<()> {
    let told = load(scene, scissors).and_then(|model| run::run(&model, &scene.scene, options, folder));
    if summary_line {
        let line = match &told {
            Ok(told) => told.line.clone(),
            Err(error) => refused_line(&scene.scene, &scene.set, &error.to_string()),
        };
        print_data(&line)?;
    }
    let told = told?;
    if !summary_line {
        print(&told.text)?;
    }
    told.error.map_or(Ok(()), Err)
}

/// `ancf compare`.
fn compare_runs(arguments: &Compare) -> Result<()> {
    let Compare { a, b, within, columns } = arguments;
    let comparison = compare::compare(a, b, columns)?;
    print(&comparison.text(*within))?;
    within.map_or(Ok(()), |within| comparison.judge(within))
}

/// The model of a scene, with the changes that options ask for.
fn load(scene: &SceneArguments, options: &ScissorsOptions) -> Result<Model> {
    let SceneArguments { scene, set } = scene;
    match options.change(scene)? {
        Some(scissors) => Ok(source::parse(&scissors.scene()?.to_text(), scene, set)?),
        None => Ok(source::load(scene, set)?),
    }
}

/// `ancf equations`.
fn print_equations(state: &str) -> Result<()> {
    Ok(print(&equations_text(&load_state(state)?, state)?)?)
}

/// `ancf modes`.
fn print_modes(
    scene: &SceneArguments,
    options: modes::Options,
    scissors: &ScissorsOptions,
    folder: &Path,
) -> Result<()> {
    let model = load(scene, scissors)?;
    Ok(print(&modes::run(&model, &scene.scene, options, folder)?)?)
}

/// `ancf plan`.
fn print_plan(scene: &SceneArguments, cost: bool, options: &ScissorsOptions) -> Result<()> {
    let model = load(scene, options)?;
    let cost = if cost { cost_text(&model)? } else { String::new() };
    Ok(print(&(report::plan_text(model.scene()) + &cost))?)
}

/// `ancf error-time --references`.
fn write_references(scenes: &[String], folder: &Path) -> Result<()> {
    Ok(print(&written_lines(&error_time::references(scenes, folder)?))?)
}

/// `ancf scene`.
fn print_scene(name: &str, options: &ScissorsOptions) -> Result<()> {
    match options.change(name)? {
        Some(scissors) => print(&scissors.scene()?.to_text())?,
        None => print(&builtin_text(name)?)?,
    }
    Ok(())
}

/// `ancf scenes`.
fn list_scenes() -> Result<()> {
    let width = builtin_names().map(str::len).max().unwrap_or(0);
    let mut list = String::new();
    for name in builtin_names() {
        let title = Model::load(name)?.into_scene().title;
        list += &format!("{name:width$}  {title}\n");
    }
    let any = "scissors-<n>";
    list += &format!("{any:width$}  scissors-3 with n scissor-like elements; scissors-<n>-thermal likewise; ");
    list += "--angle, --force and --temperature change them\n";
    Ok(print(&list)?)
}

/// Prints on standard output, without what a terminal would obey.
fn print(text: &str) -> ancf_study::error::Result<()> {
    print_data(&escape::terminal(text))
}

/// Prints what another program reads on standard output; that a reader like `head` has seen enough is no error.
fn print_data(text: &str) -> ancf_study::error::Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(ancf_study::error::Error::Write { path: "standard output".into(), source })
        }
        _ => Ok(()),
    }
}
