//! A program's motion against a motion of the fixtures: what is read, and the order of the files.

use std::path::PathBuf;

use super::comparison::Comparison;
use super::file;
use super::outcome::Outcome;
use super::reference::{Reference, reference};
use super::run::Run;
use super::sampling::sample;
use super::written::Written;
use crate::error::{Error, Result};

/// What to compare.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// One file, or two with different steps.
    pub files: Vec<PathBuf>,
    /// Name of the motion.
    pub scene: String,
    /// Steps of the files, s; empty if the files tell.
    pub steps: Vec<f64>,
}

/// Compares a program's motion with a motion of the fixtures.
///
/// # Errors
/// [`Error::NoMotion`] for an unknown scene, [`Error::Read`] and [`Error::Motion`] for files, [`Error::Suite`] for the fixtures.
pub fn compare(request: &Request) -> Result<Outcome> {
    let reference = reference(&request.scene)?;
    let points: Vec<&str> = reference.frames.position.keys().map(String::as_str).collect();
    let mut written: Vec<Written> =
        request.files.iter().map(|path| file::read(path, &points)).collect::<Result<_>>()?;
    option_fault(request, &written)?;
    for (written, step) in written.iter_mut().zip(&request.steps) {
        written.step = Some(*step);
    }
    compare_written(&reference, written)
}

fn option_fault(request: &Request, written: &[Written]) -> Result<()> {
    let fault = |place: &str, value: String, allowed: &str| {
        Err(Error::Motion { file: "command line".into(), place: place.into(), value, allowed: allowed.into() })
    };
    if !matches!(request.files.len(), 1 | 2) {
        return fault(
            "--trajectory",
            format!("{} files", request.files.len()),
            "one file, or two with different steps",
        );
    }
    if !request.steps.is_empty() && request.steps.len() != written.len() {
        let value = format!("{} steps for {} files", request.steps.len(), written.len());
        return fault("--steps", value, "a step for each file, in their order");
    }
    if let Some(step) = request.steps.iter().find(|step| !(**step > 0.0 && step.is_finite())) {
        return fault("--steps", step.to_string(), "numbers over 0, s");
    }
    Ok(())
}

/// Compares motions that have been read.
///
/// # Errors
/// [`Error::Motion`] for samples that cannot be compared, and for two files whose steps are not known.
pub fn compare_written(reference: &Reference, written: Vec<Written>) -> Result<Outcome> {
    let mut runs = Vec::new();
    for written in written {
        let sampled = sample(&written, reference)?;
        runs.push(Run { written, sampled });
    }
    let ratio = steps(&mut runs)?;
    let comparison = Comparison::new(reference, runs, ratio);
    Ok(comparison.outcome())
}

/// Puts the run with the shortest step last; returns the ratio of both steps.
fn steps(runs: &mut [Run]) -> Result<Option<f64>> {
    let length = |run: &Run| run.written.step.unwrap_or(run.sampled.interval);
    let [one, two] = runs else { return Ok(None) };
    if one.written.step.is_some() != two.written.step.is_some() || (length(one) / length(two) - 1.0).abs() < 1e-3 {
        return Err(Error::Motion {
            file: two.written.file.clone(),
            place: "step".into(),
            value: format!(
                "the steps of both files are not known, or they are equal: {} and {} s",
                length(one),
                length(two)
            ),
            allowed: "`--steps a,b`, a comment `# step = …`, or a key `step`, in both files; two different steps"
                .into(),
        });
    }
    let ratio = length(one) / length(two);
    if ratio < 1.0 {
        runs.reverse();
    }
    Ok(Some(ratio.max(1.0 / ratio)))
}
