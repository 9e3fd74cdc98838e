//! `ancf error-time --references`: solutions converged in time on each mesh, agreed by two methods.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::case::{Case, ELEMENTS};
use super::reference::{Converged, Mesh, Reference, SCHEMA, Witness};
use super::samples::Samples;
use super::technique::Technique;
use super::trial::{Record, Setting, Trial};
use crate::error::{Error, Result};
use crate::files::Files;
use crate::parallel::in_parallel;
use ancf::model::{Element, Method};
use ancf::run::run;

/// A change under the last halving of the step that is small enough, m.
const CHANGE: f64 = 1e-8;

/// Runs of a ladder at most; at least there are two solutions.
const MOST_RUNGS: usize = 12;

/// Steps that a method may refuse before it makes one.
const REFUSED: usize = 4;

/// The longest run that is worth its while, s: a ladder ends before it, but not before its least number of runs.
const LONGEST_RUN: f64 = 5.0;

/// Tolerance of Newton's iteration, relative to the largest force term: short steps cannot reach much less, and the second
/// witness shows what it costs.
const NEWTON_TOLERANCE: f64 = 1e-10;

/// Runs of one method on one mesh, each with half the step of the one before.
struct Ladder {
    case: &'static Case,
    element: Element,
    elements: usize,
    method: Method,
    /// Parts of the sample interval that its first step is; an explicit method has its limit.
    parts: usize,
}

/// What a ladder ended with.
struct Outcome {
    witness: Witness,
    samples: Samples,
}

/// Writes the references of the cases into `folder`, and returns their paths. Nothing is written if a run fails.
///
/// # Errors
/// Those of the runs, and [`Error::Write`].
pub fn write_references(cases: &[&'static Case], folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Files::in_folder(folder)?;
    let ladders: Vec<Ladder> = cases.iter().flat_map(|case| ladders(case)).collect();
    let mut outcomes = in_parallel("references", &ladders, Ladder::climb)?.into_iter();
    for case in cases {
        for element in ELEMENTS {
            let mut meshes = Vec::new();
            for &elements in case.meshes {
                if let (Some(first), Some(second)) = (outcomes.next(), outcomes.next()) {
                    meshes.push(agree(elements, first, second));
                }
            }
            let reference = reference(case, element, meshes)?;
            let text = serde_json::to_string_pretty(&reference).map_err(|reason| unusable(case, reason.to_string()))?;
            // What is written can be read.
            Reference::parse(case.scene, &text, case, element)?;
            files.write(&Reference::file_name(case, element), |file| writeln!(file, "{text}"))?;
        }
    }
    files.publish()
}

fn unusable(case: &Case, reason: String) -> Error {
    Error::Fixture { name: case.scene, reason }
}

fn ladders(case: &'static Case) -> impl Iterator<Item = Ladder> {
    let meshes = ELEMENTS.into_iter().flat_map(|element| case.meshes.iter().map(move |&elements| (element, elements)));
    meshes.flat_map(move |(element, elements)| {
        case.witnesses.map(|(method, parts)| Ladder { case, element, elements, method, parts })
    })
}

impl Ladder {
    fn climb(&self) -> Result<Outcome> {
        let &Ladder { case, element, elements, method, parts } = self;
        let unknown = || unusable(case, format!("the method {method} is not in the study"));
        let technique = Technique::of(method).ok_or_else(unknown)?;
        let first = if technique.is_static() { Setting::LoadSteps(parts) } else { Setting::Steps(parts) };
        let mut trial = Trial { case, element, elements, technique, setting: first };
        if technique.explicit {
            trial.setting = with_margin(trial.first_setting()?);
        }
        // Waves that the step does not resolve leave an error of no order: there the last run stands for itself.
        let extrapolated = case.smooth;
        let mut refused = 0;
        let (mut steps, mut last, mut solutions) = (Vec::new(), None::<Samples>, Vec::new());
        loop {
            let clock = Instant::now();
            let mut scene = trial.scene(Record::All)?;
            scene.time.newton_tolerance = NEWTON_TOLERANCE;
            let samples = match run(&scene) {
                Ok(run) => Samples::of(case, &run),
                // A ladder begins with the first step that is short enough to be made at all.
                Err(ancf::error::Error::NewtonFailed { .. } | ancf::error::Error::NotFinite { .. })
                    if last.is_none() && refused < REFUSED =>
                {
                    refused += 1;
                    trial.setting = trial.setting.finer();
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            steps.extend(trial.setting.step(case.interval));
            match &last {
                Some(coarser) if extrapolated => solutions.push(coarser.extrapolated(&samples, technique.order)),
                Some(_) => solutions.push(samples.clone()),
                None if !extrapolated => solutions.push(samples.clone()),
                None => {}
            }
            last = Some(samples);
            if let [.., before, solution] = &solutions[..] {
                let change = solution.distance(before);
                let next = 2.0 * clock.elapsed().as_secs_f64();
                // More load steps cannot find another equilibrium: what they change is rounding.
                let fine = change <= CHANGE || technique.is_static();
                if fine || next > LONGEST_RUN || steps.len() >= MOST_RUNGS {
                    let witness = Witness { method: method.to_string(), steps, extrapolated, change };
                    return Ok(Outcome { witness, samples: solution.clone() });
                }
            }
            trial.setting = trial.setting.finer();
        }
    }
}

/// A quarter more steps than the limit of the start asks for: a motion that strains the rods is faster than that.
fn with_margin(limit: Setting) -> Setting {
    match limit {
        Setting::Steps(parts) => Setting::Steps((5 * parts).div_ceil(4)),
        other => other,
    }
}

/// The solution of the first method with what the second says of it.
fn agree(elements: usize, first: Outcome, second: Outcome) -> Mesh {
    // Of the two, the one that its last halving changed less.
    let (kept, other) = if second.witness.change < first.witness.change { (second, first) } else { (first, second) };
    let time_uncertainty = kept.witness.change.max(kept.samples.distance(&other.samples));
    Mesh { elements, time_uncertainty, witnesses: vec![kept.witness, other.witness], samples: kept.samples }
}

fn reference(case: &'static Case, element: Element, meshes: Vec<Mesh>) -> Result<Reference> {
    let finest = meshes.last().map_or(0, |mesh| mesh.elements);
    let with = |elements| meshes.iter().find(|mesh| mesh.elements == elements);
    let (Some(finest), Some(second), Some(third)) = (with(finest), with(finest / 2), with(finest / 4)) else {
        return Err(unusable(case, "the finest mesh has to be there with half and a quarter of its elements".into()));
    };
    let (space, time) = (finest.samples.distance(&second.samples), finest.time_uncertainty);
    let order = (second.samples.distance(&third.samples) / space).log2();
    let order = Some(order).filter(|order| order.is_finite() && *order > 0.5);
    let extrapolated_space = order.map(|order| space / (2f64.powf(order) - 1.0));
    let converged =
        Converged { elements: finest.elements, space, time, uncertainty: space + time, order, extrapolated_space };
    Ok(Reference {
        schema: SCHEMA.into(),
        title: format!("{} with {element} elements: {} at the sample times, converged", case.scene, case.probe),
        command: format!("ancf error-time --references {}", case.scene),
        version: env!("CARGO_PKG_VERSION").into(),
        scene: case.scene.into(),
        element: element.to_string(),
        probe: case.probe.into(),
        times: case.times(),
        how: [
            "lengths in m, times in s; in statics a step is a part of the load",
            "each mesh: two witnesses, each halving its step until that changes nothing more or takes too long; the solution \
             is that of the first, which its last halving changed less",
            "extrapolated: the last two runs of a method, to a step of nothing (Richardson), and its change is that of the \
             extrapolated solutions",
            "time uncertainty: the larger of that change and the largest distance of the two witnesses",
            "space: largest distance of the finest mesh from that with half its elements; uncertainty: space + time of the finest mesh",
        ]
        .map(String::from)
        .to_vec(),
        converged,
        meshes,
    })
}
