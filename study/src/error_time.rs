//! `ancf error-time`: error against run time, of every method, mesh and step on the paper's scenes.
//!
//! The [`case::CASES`] are the scenes, the [`technique::TECHNIQUES`] the methods; [`grid`] tries steps on meshes, and
//! compares each run with a [`reference::Reference`], which [`converge`] has written. [`pareto`] says which points are worth their
//! time, [`peers`] reads what another program needs for the same.

pub mod case;
pub mod converge;
pub mod economies;
pub mod grid;
pub mod group;
pub mod machine;
mod page;
pub mod pareto;
pub mod peers;
mod picture;
pub mod point;
pub mod reference;
pub mod row;
pub mod samples;
pub mod technique;
mod text;
pub mod timing;
pub mod trial;

use std::path::{Path, PathBuf};
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use crate::error::Result;
use crate::files::Files;
use ancf::model::Element;
use case::{Case, ELEMENTS};
use economies::Economy;
use grid::{Reach, Subject};
use group::Group;
use machine::Machine;
use peers::Peer;
use reference::Reference;

/// What is measured.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Options {
    /// Names of scenes; all if there are none.
    pub scenes: Vec<String>,
    /// The other program's runs; `None`: [`PEERS`] in the folder of the output, if it is there.
    pub peers: Option<PathBuf>,
    /// A coarse grid, of the flexible pendulum if no scene is named.
    pub quick: bool,
}

/// The file of the other program's runs.
pub const PEERS: &str = "peers.csv";

/// The scene of the quick study.
const QUICK_SCENE: &str = "pendulum-flexible";

/// `error-time.json`.
#[derive(Debug, Serialize)]
pub struct Study {
    /// What was asked for.
    pub options: Options,
    /// Where it was measured.
    pub machine: Machine,
    /// How long it took, s.
    pub wall_seconds: f64,
    /// What is known of the other program.
    pub peers: String,
    /// The other program's rows: options and samples.
    pub peer_rows: Vec<Peer>,
    /// Scenes with their elements.
    pub groups: Vec<Group>,
    /// What leaving things out saves.
    pub economies: Vec<Economy>,
}

/// `ancf error-time`: measures, prints and writes.
///
/// # Errors
/// [`Error::Scene`](crate::error::Error::Scene) for a scene that is not in the study, [`Error::Table`](crate::error::Error::Table)
/// for a malformed file of the other program, [`Error::Fixture`](crate::error::Error::Fixture) for a reference that is missing or
/// broken, [`Error::Write`](crate::error::Error::Write). Runs that fail are points of the result.
pub fn study(options: &Options, out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    // First, so that a folder that cannot be written is not found after the work.
    let mut files = Files::in_folder(out)?;
    let (study, _) = part(options, out, &mut files, &print)?;
    let paths = files.publish()?;
    print(&paths.iter().map(|path| format!("wrote {}\n", path.display())).collect::<String>())?;
    print(&format!("{:.1} s in all\n", study.wall_seconds))
}

/// The study, with its picture, as a part of another job, whose files it adds to: measured, printed, and written but not published.
/// `out` is where the other program's runs are looked for.
///
/// # Errors
/// Those of [`study`].
pub fn part(
    options: &Options,
    out: &Path,
    files: &mut Files,
    print: impl Fn(&str) -> Result<()>,
) -> Result<(Study, String)> {
    let study = measure(options, out, &print)?;
    let svg = picture::svg(&study.groups)?;
    let html = page::page(&study, &svg);
    let points = || study.groups.iter().flat_map(|group| group.points.iter().chain(group.own_peers()));
    files.write("error-time.csv", |file| row::write(file, points()))?;
    files.write("error-time.json", |file| Ok(serde_json::to_writer_pretty(file, &study)?))?;
    files.write("error-time.svg", |file| file.write_all(svg.as_bytes()))?;
    files.write("error-time.html", |file| file.write_all(html.as_bytes()))?;
    Ok((study, svg))
}

fn measure(options: &Options, out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<Study> {
    let clock = Instant::now();
    let (rows, known) = read_peers(options, out)?;
    let subjects = subjects(options)?;
    let reach = if options.quick { Reach::QUICK } else { Reach::FULL };
    let machine = Machine::here();
    print(&format!("Error against run time. {}\n{known}\n\n", machine.line()))?;

    let bar = progress(&subjects, &reach);
    let (mut groups, mut peer_rows) = (Vec::new(), Vec::new());
    for subject in &subjects {
        bar.set_message(format!("{}, {}", subject.case.scene, subject.element));
        let mut group = Group::new(subject, subject.points(&reach, || bar.inc(1))?)?;
        // The other program's errors are distances from the limit of its own theory, whichever element of ours is beside it.
        let theirs = Reference::embedded(subject.case, Element::EulerBernoulli)?;
        let of_scene = rows.iter().filter(|row| row.case == subject.case).cloned();
        let compared: Vec<Peer> = of_scene.map(|row| row.compared(&theirs)).collect();
        group.peers = compared.iter().map(|peer| peer.point.clone()).collect();
        if group.has_theory_of_peers() {
            peer_rows.extend(compared);
        }
        bar.suspend(|| print(&text::group(&group)))?;
        groups.push(group);
    }
    bar.finish_and_clear();
    let economies = economies::measure()?;
    print(&text::economies(&economies))?;
    let wall_seconds = clock.elapsed().as_secs_f64();
    Ok(Study { options: options.clone(), machine, wall_seconds, peers: known, peer_rows, groups, economies })
}

/// The scenes with both elements, and their references.
fn subjects(options: &Options) -> Result<Vec<Subject>> {
    let quick = options.quick && options.scenes.is_empty();
    let cases = if quick { Case::named(&[QUICK_SCENE.into()])? } else { Case::named(&options.scenes)? };
    let subject = |case: &'static Case, element: Element| {
        Ok(Subject { case, element, reference: Reference::embedded(case, element)? })
    };
    let pairs = cases.into_iter().flat_map(|case| ELEMENTS.map(|element| (case, element)));
    pairs.map(|(case, element)| subject(case, element)).collect()
}

/// The other program's rows, and a sentence on them.
fn read_peers(options: &Options, out: &Path) -> Result<(Vec<Peer>, String)> {
    let usual = out.join(PEERS);
    let file = match &options.peers {
        Some(file) => file,
        None if usual.exists() => &usual,
        None => {
            let known = format!("No other program was measured: `{} --out {}` does.", peers::COMMAND, usual.display());
            return Ok((Vec::new(), known));
        }
    };
    let rows = peers::read(file)?;
    let mut programs: Vec<&str> = rows.iter().map(|row| row.point.program.as_str()).collect();
    programs.sort_unstable();
    programs.dedup();
    let known = format!("{}: {} runs, {}.", programs.join(", "), rows.len(), file.display());
    Ok((rows, known))
}

/// A bar with the time left, on a terminal; nothing in a pipe. It has no thread of its own, which would disturb the times.
fn progress(subjects: &[Subject], reach: &Reach) -> ProgressBar {
    let walks = |subject: &Subject| subject.meshes(reach).len() * subject.techniques().count();
    let bar = ProgressBar::new(subjects.iter().map(walks).sum::<usize>() as u64);
    let style = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}, {eta} left");
    style.map_or(bar.clone(), |style| bar.with_style(style))
}

/// `ancf error-time --references`: writes the converged references of the scenes into a folder.
///
/// # Errors
/// Those of [`converge::write_references`].
pub fn references(scenes: &[String], folder: &Path) -> Result<Vec<PathBuf>> {
    converge::write_references(&Case::named(scenes)?, folder)
}
