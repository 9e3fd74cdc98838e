//! A program's runs beside the reference.

use std::collections::BTreeMap;

use super::expected::Expected;
use super::frames::{Frames, Path, distance, farthest};
use super::outcome::Difference;
use super::reference::Reference;
use super::run::Run;

/// Distance of two motions that counts as none, m: a millionth of a rod's length.
pub const AGREES: f64 = 1e-6;

/// Comparison of runs with a reference.
#[derive(Debug)]
pub struct Comparison<'a> {
    /// The motion of the fixtures.
    pub reference: &'a Reference,
    /// The program's files, that of the shortest step last.
    pub runs: Vec<Run>,
    /// Ratio of both steps.
    pub ratio: Option<f64>,
    /// Distance of each run from the reference, m.
    pub off: Vec<f64>,
    /// What beams differ from the solid by; nothing for rods.
    pub model: Expected,
    /// Largest errors of right methods with each run's step.
    pub expected: Vec<Option<Expected>>,
}

impl<'a> Comparison<'a> {
    /// Compares runs, that of the shortest step last.
    pub fn new(reference: &'a Reference, runs: Vec<Run>, ratio: Option<f64>) -> Comparison<'a> {
        let right = |run: &Run| reference.frames.picked(&run.sampled.indices);
        let off = runs.iter().map(|run| distance(&run.sampled.frames.position, &right(run).position)).collect();
        let model = runs.last().map(|run| Expected::of_beams(reference, &right(run))).unwrap_or_default();
        let expected = runs.iter().map(|run| Expected::with_step(reference, &right(run), run.step()?)).collect();
        Comparison { reference, runs, ratio, off, model, expected }
    }

    /// The reference at a run's times.
    pub fn right(&self, run: &Run) -> Frames {
        self.reference.frames.picked(&run.sampled.indices)
    }

    /// The run with the shortest step, and its distance from the reference.
    pub fn last(&self) -> (&Run, f64) {
        let n = self.runs.len() - 1;
        (&self.runs[n], self.off[n])
    }

    /// Errors of right methods with the shortest step.
    pub fn expected(&self) -> Option<&Expected> {
        self.expected.last()?.as_ref()
    }

    /// Distance at a time that agrees: the reference's uncertainty and what was written and interpolated.
    pub fn allowed(&self, run: &Run, at: usize) -> f64 {
        let index = run.sampled.indices.get(at).copied().unwrap_or_default();
        let uncertainty = self.reference.position_uncertainty.get(index).copied().unwrap_or(0.0);
        let rounding = if run.written.rounding.is_finite() { 1.5 * run.written.rounding } else { 0.0 };
        AGREES + uncertainty + rounding + run.sampled.interpolation + self.model.position
    }

    /// First sample that is farther off than `allowed`.
    pub fn first_difference(&self, own_error: f64) -> Option<Difference> {
        let (run, _) = self.last();
        let right = self.right(run);
        let got = &run.sampled.frames;
        for at in 0..got.t.len() {
            let allowed = self.allowed(run, at) + own_error;
            let here = |table: &BTreeMap<String, Path>| -> BTreeMap<String, Path> {
                table.iter().filter_map(|(point, path)| Some((point.clone(), vec![*path.get(at)?]))).collect()
            };
            let worst = farthest(&here(&got.position), &here(&right.position))?;
            if worst.distance > allowed || worst.distance.is_nan() {
                let [expected, start] = [at, 0].map(|n| right.position[&worst.point][n]);
                let p = got.position[&worst.point][at];
                let ratio = [0, 1].map(|c| {
                    let moved = expected[c] - start[c];
                    (moved.abs() > 1e-6).then(|| (p[c] - start[c]) / moved)
                });
                return Some(Difference {
                    t: got.t[at],
                    point: worst.point,
                    expected,
                    got: p,
                    distance: worst.distance,
                    allowed,
                    ratio,
                });
            }
        }
        None
    }
}
