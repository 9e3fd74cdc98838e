//! `ancf error-time`: error against run time of every method, mesh and step, on the paper's scenes or on one of the user's own.
//!
//! `benchmarks` has the scenes, `own` makes one of a file, `technique` has the methods. `grid` tries steps on meshes, and compares each run, read
//! by `trace`, with a reference that `converge` has made. `pareto` finds the points that are worth their time; `finals` times them in turns with
//! those of another program, which `peer` asks.

pub(crate) mod benchmark;
pub(crate) mod benchmarks;
mod clock;
mod converge;
mod core;
mod economies;
mod finals;
mod grid;
mod group;
#[cfg(test)]
mod labels;
mod machine;
mod own;
mod page;
mod pareto;
mod peer;
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
mod turns;
mod winner;
mod wording;

use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::error::{Error, Result};
use crate::files::{Files, written_lines};
use crate::parallel::progress_bar;
use crate::scene::ELEMENTS;
use ancf::model::Element;
use benchmarks::named;
use core::OneCore;
use grid::{Limits, Subject};
use group::Group;
use machine::Machine;
pub(crate) use page::fastest_by_group as fastest;
use peer::Peer;
use point::Point;
use reference::Reference;
use setup::Setup;
pub(crate) use study::ErrorTimeStudy;
pub use study::Options;

/// Files that the study writes.
pub(crate) const FILES: [&str; 4] = ["error-time.csv", "error-time.json", "error-time.svg", "error-time.html"];

/// Scene of the quick study.
const QUICK_SCENE: &str = "pendulum-flexible";

/// `ancf error-time`: measures, prints and writes.
///
/// # Errors
/// [`Error::Name`] for a scene that is not in the study, [`Error::Scene`] for a scene file that cannot be studied, [`Error::Peer`] for another
/// program that does not answer, [`Error::Fixture`] for a missing or broken reference, [`Error::Write`]. [`Error::Undecided`] if no accuracy is
/// certain in a scene of the user's own; the files are written all the same. Runs that fail are points of the result.
pub fn study(options: &Options, out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    let own: Vec<&Path> = options.scenes.iter().filter(|name| own::is_file(name)).map(Path::new).collect();
    // First, so that a folder that cannot be written is found before the work.
    let mut files = Files::in_folder(out, FILES, &own)?;
    let (study, _) = part(options, &mut files, &print)?;
    print(&written_lines(&files.publish()?))?;
    print(&format!("{:.1} s in all\n", study.wall_seconds))?;
    let undecided = study.groups.iter().find(|group| group.decades().iter().all(|(_, point)| point.is_none()));
    match undecided {
        Some(group) if !own.is_empty() => {
            Err(Error::Undecided { scene: group.scene.into(), uncertainty: group.reference.uncertainty })
        }
        _ => Ok(()),
    }
}

/// The study as a part of another job: measures, prints and adds to its files. Returns the study and the picture.
pub(crate) fn part(
    options: &Options,
    files: &mut Files,
    print: impl Fn(&str) -> Result<()>,
) -> Result<(ErrorTimeStudy, String)> {
    let study = measure(options, &print)?;
    let svg = picture::svg(&study.groups)?;
    let html = page::page(&study, &svg);
    let points = study.groups.iter().flat_map(Group::all_points);
    files.write_table("error-time.csv", |file| tables::points(points).csv(file))?;
    files.write_json("error-time.json", &study)?;
    files.write_text("error-time.svg", svg.clone())?;
    files.write_text("error-time.html", html)?;
    Ok((study, svg))
}

fn measure(options: &Options, print: impl Fn(&str) -> Result<()>) -> Result<ErrorTimeStudy> {
    let clock = Instant::now();
    let own = options.scenes.iter().any(|name| own::is_file(name));
    let limits = match (options.quick, own) {
        (true, _) => Limits::QUICK,
        (false, true) => Limits::OWN,
        (false, false) => Limits::FULL,
    };
    let mut other = options.peer.as_deref().map(Peer::start).transpose()?;
    let peer = other.as_ref().map_or_else(
        || format!("No other program was measured: `--peer \"{}\"` does.", peer::COMMAND),
        |other| format!("{} ({}), in turns with this one on the same core.", other.name, other.build),
    );
    let machine = Machine::here();
    print(&format!("Error against run time. {}\n{peer}\n\n", machine.line()))?;
    // References of scenes of the user's own take all cores; what is measured has one.
    let scenes = scenes(options)?;
    let _one = OneCore::keep();
    // The bar has no thread of its own, which would disturb the times.
    let mesh_runs = |subject: &Subject| subject.meshes(&limits).len() * subject.techniques().count();
    let bar = progress_bar("", scenes.iter().flatten().map(mesh_runs).sum());
    let mut groups = Vec::new();
    for subjects in &scenes {
        for group in scene_groups(subjects, &limits, options.quick, other.as_mut(), &bar)? {
            bar.suspend(|| print(&printed::group(&group)))?;
            groups.push(group);
        }
    }
    bar.finish_and_clear();
    let economies = if own || options.quick { Vec::new() } else { economies::measure()? };
    if !economies.is_empty() {
        print(&format!(
            "Economies, each left out where a scene does not need it:\n{}\n",
            tables::economies(&economies).text()
        ))?;
    }
    let (winners, wall_seconds) = (winner::winners(&groups), clock.elapsed().as_secs_f64());
    Ok(ErrorTimeStudy { options: options.clone(), machine, wall_seconds, peer, groups, winners, economies })
}

/// Runs the grids of a scene's elements and of the other program, and times the finalists in turns.
fn scene_groups(
    subjects: &[Subject],
    limits: &Limits,
    quick: bool,
    mut other: Option<&mut Peer>,
    bar: &indicatif::ProgressBar,
) -> Result<Vec<Group>> {
    let Some(first) = subjects.first() else { return Ok(Vec::new()) };
    let mut ours: Vec<Vec<(Setup, Point)>> = Vec::new();
    for subject in subjects {
        bar.set_message(format!("{}, {}", subject.benchmark.scene, subject.element));
        ours.push(subject.points(limits, || bar.inc(1))?);
    }
    // The other program's element without shear has the limit of ours.
    let euler_bernoulli = subjects.iter().find(|subject| subject.element == Element::EulerBernoulli);
    let mut theirs = match (&mut other, euler_bernoulli) {
        (Some(other), Some(known)) => peers::points(other, first.benchmark, &known.reference, quick)?,
        _ => Vec::new(),
    };
    bar.set_message(format!("{}, in turns", first.benchmark.scene));
    finals::hold(first.benchmark.unit, &mut ours, &mut theirs, other)?;
    let theirs: Vec<Point> = theirs.into_iter().map(|peer| peer.point).collect();
    let group = |(subject, points): (&Subject, Vec<(Setup, Point)>)| {
        let mut group = Group::new(subject, points.into_iter().map(|(_, point)| point).collect())?;
        group.compare(&theirs);
        Ok(group)
    };
    subjects.iter().zip(ours).map(group).collect()
}

/// The scenes, each with its elements and their references.
fn scenes(options: &Options) -> Result<Vec<Vec<Subject>>> {
    if options.scenes.is_empty() {
        let benchmarks = if options.quick { named(&[QUICK_SCENE.into()])? } else { named(&[])? };
        return benchmarks.into_iter().map(embedded).collect();
    }
    // Names and files are all looked at before the first one is computed.
    let own = |name: &String| if own::is_file(name) { own::benchmark(name).map(Some) } else { Ok(None) };
    let owns: Vec<_> = options.scenes.iter().map(own).collect::<Result<_>>()?;
    let pairs = options.scenes.iter().zip(owns);
    let subjects: Vec<Vec<Subject>> = pairs
        .clone()
        .filter(|(_, own)| own.is_none())
        .map(|(name, _)| embedded(benchmarks::of(name)?))
        .collect::<Result<_>>()?;
    let mut subjects = subjects.into_iter();
    let mut found = Vec::new();
    for (_, own) in pairs {
        found.extend(match own {
            None => subjects.next(),
            Some((benchmark, element)) => {
                let references = converge::references(&[(benchmark, element)], own::LONGEST_RUN)?;
                let subjects = references.into_iter().map(|reference| Subject::new(benchmark, element, reference));
                Some(subjects.collect::<Result<Vec<_>>>()?)
            }
        });
    }
    Ok(found)
}

/// A scene of the study with both elements.
fn embedded(benchmark: &'static benchmark::Benchmark) -> Result<Vec<Subject>> {
    let subject = |element| Subject::new(benchmark, element, Reference::embedded(benchmark, element)?);
    ELEMENTS.into_iter().map(subject).collect()
}

/// `ancf error-time --references`: writes the converged references of the scenes into a folder, and returns their paths.
///
/// # Errors
/// Those of the runs; [`Error::Name`], [`Error::Write`].
pub fn references(scenes: &[String], folder: &Path) -> Result<Vec<PathBuf>> {
    converge::write_references(&named(scenes)?, folder)
}
