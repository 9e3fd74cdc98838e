//! `ancf error-time --references`: solutions that have converged in time on each mesh, agreed by two methods.

use std::path::{Path, PathBuf};

use super::benchmark::Benchmark;
use super::clock;
use super::reference::{Converged, Mesh, Reference, SCHEMA, VERSION, Witness};
use super::samples::Samples;
use super::setup::{Record, Resolution, Setup};
use super::technique::Technique;
use crate::error::{Error, Result};
use crate::files::Files;
use crate::parallel::in_parallel;
use crate::scene::{Change, ELEMENTS};
use ancf::internals::model::Words;
use ancf::model::{Element, Method};
use ancf::run::run;
use itertools::iproduct;

/// Change under the last halving of the step that is small enough, m.
const CHANGE: f64 = 1e-8;

/// Most runs of a sequence; there are at least two solutions.
const MOST_RUNGS: usize = 12;

/// Steps that a method may refuse before its first one.
const REFUSED: usize = 4;

/// Longest run, s of one core: a sequence ends before it, but not before its second solution.
const LONGEST_RUN: f64 = 4.0;

/// Newton's tolerance, relative to the largest force term: short steps cannot reach much less, and the second witness shows its effect.
const NEWTON_TOLERANCE: f64 = 1e-10;

/// Runs of one method on one mesh, each with half the step of the one before.
struct Halvings {
    benchmark: &'static Benchmark,
    element: Element,
    elements: usize,
    method: Method,
    /// First step, as a part of the interval; an explicit method starts at its limit.
    parts: usize,
    /// Longest run, s of one core.
    longest: f64,
}

/// The last solution of a sequence.
struct Solution {
    witness: Witness,
    samples: Samples,
}

/// Writes the references of the benchmarks into `folder`, and returns their paths. Nothing is written if a run fails.
///
/// # Errors
/// Those of the runs, and [`Error::Write`].
pub fn write_references(benchmarks: &[&'static Benchmark], folder: &Path) -> Result<Vec<PathBuf>> {
    let pairs = benchmarks.iter().flat_map(|benchmark| ELEMENTS.map(|element| (benchmark, element)));
    let names = pairs.map(|(benchmark, element)| Reference::file_name(benchmark, element));
    let mut files = Files::in_folder(folder, names, &[])?;
    let subjects: Vec<_> =
        benchmarks.iter().flat_map(|benchmark| ELEMENTS.map(|element| (*benchmark, element))).collect();
    for reference in references(&subjects, LONGEST_RUN)? {
        let benchmark = benchmarks.iter().find(|benchmark| benchmark.scene == reference.scene);
        let element = ELEMENTS.into_iter().find(|element| element.word() == reference.element);
        if let (Some(benchmark), Some(element)) = (benchmark, element) {
            let text = reference.text()?;
            // The file has to be readable.
            Reference::parse(benchmark.scene, &text, benchmark, element)?;
            files.write(&Reference::file_name(benchmark, element), |file| writeln!(file, "{text}"))?;
        }
    }
    files.publish()
}

/// Converged solutions of benchmarks with an element each, on all cores; no run but the first two of a sequence is longer than `longest`, s.
///
/// # Errors
/// Those of the runs.
pub fn references(subjects: &[(&'static Benchmark, Element)], longest: f64) -> Result<Vec<Reference>> {
    let mut sequences: Vec<Halvings> = Vec::new();
    for &(benchmark, element) in subjects {
        for (&elements, (method, parts)) in iproduct!(benchmark.meshes, benchmark.witnesses) {
            sequences.push(Halvings { benchmark, element, elements, method, parts, longest });
        }
    }
    let mut solutions = in_parallel("references", &sequences, Halvings::run)?.into_iter();
    let mut found = Vec::new();
    for &(benchmark, element) in subjects {
        let mut meshes = Vec::new();
        for &elements in benchmark.meshes {
            if let (Some(first), Some(second)) = (solutions.next(), solutions.next()) {
                meshes.push(agree(elements, first, second));
            }
        }
        found.push(reference(benchmark, element, meshes)?);
    }
    Ok(found)
}

fn unusable(benchmark: &Benchmark, reason: String) -> Error {
    Error::fixture(benchmark.scene, reason)
}

impl Halvings {
    fn run(&self) -> Result<Solution> {
        let &Halvings { benchmark, element, elements, method, parts, longest } = self;
        let unknown = || unusable(benchmark, format!("the method {method} is not in the study"));
        let technique = Technique::of(method).ok_or_else(unknown)?;
        let first = if technique.is_static() { Resolution::LoadSteps(parts) } else { Resolution::Steps(parts) };
        let mut setup = Setup { benchmark, element, elements, technique, resolution: first };
        if technique.explicit {
            setup.resolution = with_margin(setup.first_resolution()?, benchmark.instants);
        }
        // The error of waves that the step does not resolve has no order: then the last run is not extrapolated.
        let extrapolated = benchmark.smooth;
        let mut refused = 0;
        let (mut steps, mut last, mut solutions) = (Vec::new(), None::<Samples>, Vec::new());
        loop {
            let begun = clock::seconds();
            let samples = match run(setup.scene(Record::Instants)?.newton(NEWTON_TOLERANCE)) {
                Ok(run) => Samples::of(benchmark, &run),
                // The sequence starts with the first step that is short enough to succeed.
                Err(ancf::error::Error::NewtonFailed { .. } | ancf::error::Error::NotFinite { .. })
                    if last.is_none() && refused < REFUSED =>
                {
                    refused += 1;
                    setup.resolution = setup.resolution.finer();
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            steps.extend(setup.resolution.step(benchmark.interval));
            match &last {
                Some(coarser) if extrapolated => solutions.push(coarser.extrapolated(&samples, technique.order)),
                Some(_) => solutions.push(samples.clone()),
                None if !extrapolated => solutions.push(samples.clone()),
                None => {}
            }
            last = Some(samples);
            if let [.., before, solution] = &solutions[..] {
                let change = solution.distance(before);
                let next = 2.0 * (clock::seconds() - begun);
                // More load steps find no other equilibrium: their change is rounding.
                let fine = change <= CHANGE || technique.is_static();
                if fine || next > longest || steps.len() >= MOST_RUNGS {
                    let witness = Witness { method: method.to_string(), steps, extrapolated, change };
                    return Ok(Solution { witness, samples: solution.clone() });
                }
            }
            setup.resolution = setup.resolution.finer();
        }
    }
}

/// A quarter more steps than the limit at the start, as strains raise the frequencies of the rods; so many that all instants are ends of steps.
fn with_margin(limit: Resolution, instants: usize) -> Resolution {
    match limit {
        Resolution::Steps(parts) => Resolution::Steps((5 * parts).div_ceil(4).next_multiple_of(instants)),
        other => other,
    }
}

/// The solution of one method, with its distance from that of the other.
fn agree(elements: usize, first: Solution, second: Solution) -> Mesh {
    // The one that changed less under its last halving.
    let (kept, other) = if second.witness.change < first.witness.change { (second, first) } else { (first, second) };
    let time_uncertainty = kept.witness.change.max(kept.samples.distance(&other.samples));
    Mesh { elements, time_uncertainty, witnesses: vec![kept.witness, other.witness], samples: kept.samples }
}

fn reference(benchmark: &'static Benchmark, element: Element, meshes: Vec<Mesh>) -> Result<Reference> {
    let finest = meshes.last().map_or(0, |mesh| mesh.elements);
    let with = |elements| meshes.iter().find(|mesh| mesh.elements == elements);
    let (Some(finest), Some(second), Some(third)) = (with(finest), with(finest / 2), with(finest / 4)) else {
        return Err(unusable(
            benchmark,
            "the meshes have to include half and a quarter of the finest mesh's elements".into(),
        ));
    };
    let (space, time) = (finest.samples.distance(&second.samples), finest.time_uncertainty);
    let order = (second.samples.distance(&third.samples) / space).log2();
    let order = Some(order).filter(|order| order.is_finite() && *order > 0.5);
    let extrapolated_space = order.map(|order| space / (2f64.powf(order) - 1.0));
    let converged = Converged {
        elements: finest.elements,
        space,
        time,
        uncertainty: space + time,
        order,
        extrapolated_space,
        velocity: finest.samples.velocity_difference(&second.samples),
        reaction: finest.samples.reaction_difference(&second.samples).filter(|_| benchmark.smooth),
    };
    let finest = finest.elements;
    let shortened = |mesh: Mesh| {
        let samples = mesh.samples.short(benchmark.smooth && mesh.elements == finest);
        Mesh { samples, ..mesh }
    };
    Ok(Reference {
        schema: SCHEMA.into(),
        title: format!("{} with {element} elements: {} at {} instants, converged", benchmark.scene, benchmark.probe, benchmark.count()),
        command: format!("ancf error-time --references {}", benchmark.scene),
        version: VERSION.into(),
        program: env!("CARGO_PKG_VERSION").into(),
        scene: benchmark.scene.into(),
        element: element.to_string(),
        probe: benchmark.probe.into(),
        count: benchmark.count(),
        interval: benchmark.interval / benchmark.instants as f64,
        how: [
            "lengths in m, times in s, forces in N; in statics a step is a part of the load",
            "each mesh: two witnesses, each halving its step until that changes nothing more or takes too long; the solution \
             is that of the first, which its last halving changed less; every instant is the end of a step",
            "extrapolated: the last two runs of a method, to a step of nothing (Richardson), and its change is that of the \
             extrapolated solutions",
            "time uncertainty: the larger of that change and the largest distance of the two witnesses at the instants",
            "space: largest distance of the finest mesh from that with half its elements; uncertainty: space + time of the finest mesh",
            "velocity and reaction: the same of the probe's velocity and of the first support's force, where they converge",
        ]
        .map(String::from)
        .to_vec(),
        converged,
        meshes: meshes.into_iter().map(shortened).collect(),
    })
}
