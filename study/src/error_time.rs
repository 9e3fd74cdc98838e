//! `ancf error-time`: error against run time of every method, mesh and step on the paper's scenes.
//!
//! `benchmarks` has the scenes, `technique` the methods. `grid` tries steps on meshes, and compares each run with a reference that
//! `converge` has written. `pareto` finds the points that are worth their time, `peers` reads the runs of another program.

pub(crate) mod benchmark;
pub(crate) mod benchmarks;
mod clock;
mod converge;
mod economies;
mod grid;
mod group;
mod machine;
mod page;
mod pareto;
mod peers;
mod picture;
mod point;
mod printed;
pub(crate) mod reference;
pub(crate) mod samples;
pub(crate) mod setup;
mod study;
mod tables;
pub(crate) mod technique;
#[cfg(test)]
mod tests;
mod timing;
mod trace;
mod wording;

use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::error::Result;
use crate::files::{Files, written_lines};
use crate::parallel::progress_bar;
use crate::scene::ELEMENTS;
use ancf::model::Element;
use benchmarks::named;
use grid::{Limits, Subject};
use group::Group;
use machine::Machine;
pub(crate) use page::fastest_by_group as fastest;
use peers::Peer;
use reference::Reference;
pub(crate) use study::ErrorTimeStudy;
pub use study::Options;

/// File of the other program's runs.
const PEERS: &str = "peers.csv";

/// Files that the study writes.
pub(crate) const FILES: [&str; 4] = ["error-time.csv", "error-time.json", "error-time.svg", "error-time.html"];

/// Scene of the quick study.
const QUICK_SCENE: &str = "pendulum-flexible";

/// `ancf error-time`: measures, prints and writes.
///
/// # Errors
/// [`Error::Name`](crate::error::Error::Name) for a scene that is not in the study, [`Error::Table`](crate::error::Error::Table) for a malformed
/// file of the other program, [`Error::Fixture`](crate::error::Error::Fixture) for a missing or broken reference,
/// [`Error::Write`](crate::error::Error::Write). Runs that fail are points of the result.
pub fn study(options: &Options, out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    // First, so that a folder that cannot be written is found before the work.
    let mut files = Files::in_folder(out, FILES, &[&peers_file(options, out)])?;
    let (study, _) = part(options, out, &mut files, &print)?;
    print(&written_lines(&files.publish()?))?;
    print(&format!("{:.1} s in all\n", study.wall_seconds))
}

/// The study as a part of another job: measures, prints and adds to its files. Returns the study and the picture. `out` is the folder with
/// the other program's runs.
pub(crate) fn part(
    options: &Options,
    out: &Path,
    files: &mut Files,
    print: impl Fn(&str) -> Result<()>,
) -> Result<(ErrorTimeStudy, String)> {
    let study = measure(options, out, &print)?;
    let svg = picture::svg(&study.groups)?;
    let html = page::page(&study, &svg);
    let points = study.groups.iter().flat_map(Group::all_points);
    files.write_table("error-time.csv", |file| tables::points(points).csv(file))?;
    files.write_json("error-time.json", &study)?;
    files.write_text("error-time.svg", svg.clone())?;
    files.write_text("error-time.html", html)?;
    Ok((study, svg))
}

fn measure(options: &Options, out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<ErrorTimeStudy> {
    let clock = Instant::now();
    let (rows, peers) = read_peers(options, out)?;
    let subjects = subjects(options)?;
    let limits = if options.quick { Limits::QUICK } else { Limits::FULL };
    let machine = Machine::here();
    print(&format!("Error against run time. {}\n{peers}\n\n", machine.line()))?;

    // The bar has no thread of its own, which would disturb the times.
    let mesh_runs = |subject: &Subject| subject.meshes(&limits).len() * subject.techniques().count();
    let bar = progress_bar("", subjects.iter().map(mesh_runs).sum());
    let (mut groups, mut peer_rows) = (Vec::new(), Vec::new());
    for subject in &subjects {
        bar.set_message(format!("{}, {}", subject.benchmark.scene, subject.element));
        let mut group = Group::new(subject, subject.points(&limits, || bar.inc(1))?)?;
        // The other program's errors are distances from the limit of its own theory, in the groups of both elements.
        let theirs = Reference::embedded(subject.benchmark, Element::EulerBernoulli)?;
        let of_scene = rows.iter().filter(|row| row.benchmark == subject.benchmark).cloned();
        let compared: Vec<Peer> = of_scene.map(|row| row.compared(&theirs)).collect();
        group.peers = compared.iter().map(|peer| peer.point.clone()).collect();
        if group.is_euler_bernoulli() {
            peer_rows.extend(compared);
        }
        bar.suspend(|| print(&printed::group(&group)))?;
        groups.push(group);
    }
    bar.finish_and_clear();
    let economies = economies::measure()?;
    print(&format!(
        "Economies, each left out where a scene does not need it:\n{}\n",
        tables::economies(&economies).text()
    ))?;
    let wall_seconds = clock.elapsed().as_secs_f64();
    Ok(ErrorTimeStudy { options: options.clone(), machine, wall_seconds, peers, peer_rows, groups, economies })
}

/// The scenes with both elements, and their references.
fn subjects(options: &Options) -> Result<Vec<Subject>> {
    let quick = options.quick && options.scenes.is_empty();
    let benchmarks = if quick { named(&[QUICK_SCENE.into()])? } else { named(&options.scenes)? };
    let pairs = benchmarks.into_iter().flat_map(|benchmark| ELEMENTS.map(|element| (benchmark, element)));
    let subject =
        |(benchmark, element)| Ok(Subject { benchmark, element, reference: Reference::embedded(benchmark, element)? });
    pairs.map(subject).collect()
}

/// File with the other program's rows.
fn peers_file(options: &Options, out: &Path) -> PathBuf {
    options.peers.clone().unwrap_or_else(|| out.join(PEERS))
}

/// The other program's rows, and a sentence on them.
fn read_peers(options: &Options, out: &Path) -> Result<(Vec<Peer>, String)> {
    let file = peers_file(options, out);
    if options.peers.is_none() && !file.exists() {
        let how = format!("`{} --out {}` does", peers::COMMAND, file.display());
        return Ok((Vec::new(), format!("No other program was measured: {how}.")));
    }
    let rows = peers::read(&file)?;
    let mut programs: Vec<&str> = rows.iter().map(|row| row.point.program.as_str()).collect();
    programs.sort_unstable();
    programs.dedup();
    let sentence = format!("{}: {} runs, {}.", programs.join(", "), rows.len(), file.display());
    Ok((rows, sentence))
}

/// `ancf error-time --references`: writes the converged references of the scenes into a folder, and returns their paths.
///
/// # Errors
/// Those of the runs; [`Error::Name`](crate::error::Error::Name), [`Error::Write`](crate::error::Error::Write).
pub fn references(scenes: &[String], folder: &Path) -> Result<Vec<PathBuf>> {
    converge::write_references(&named(scenes)?, folder)
}
