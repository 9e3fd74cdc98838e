//! A program's motion against a motion of the fixtures: t = 0, first difference, order, energies, mistake.

use std::collections::BTreeMap;
use std::path::PathBuf;

use ancf::model::{Constraints, Element, Scene};
use ancf::run::Simulation;
use nalgebra::DMatrix;

use super::file::{self, Written};
use super::frames::{Frames, Path, distance, farthest, largest_difference};
use super::matching::{Fit, Observed, matching};
use super::mistakes::{Made, mistakes, right_methods};
use super::motion::{Method, frames, initial_acceleration};
use super::outcome::{
    Difference, EnergyResult, FileResult, Named, OrderResult, Outcome, OwnError, SCHEMA, StartResult, Verdict,
};
use super::reference::{Reference, reference};
use super::rods::Rods;
use super::sampling::{Sampled, sample};
use super::setup::Setup;
use crate::error::{Error, Result};

/// Distance of two motions that counts as none, m: a millionth of a rod's length.
const AGREES: f64 = 1e-6;
/// A difference within this many errors of right methods with the same step is one of the step.
const EXPLAINED: f64 = 2.0;
/// A difference beyond this many is a mistake also without a name; in between, a method may have larger errors than others of its order.
const UNEXPLAINED: f64 = 10.0;
/// Lowest order in which a right method is expected to come to its limit; waves that no step resolves lower it.
const LEAST_ORDER: f64 = 0.8;
/// Below this order a method has lost one, where methods of second order show at least [`SECOND`].
const FIRST: f64 = 1.4;
const SECOND: f64 = 1.7;
/// Longest distance of samples that is taken for the step, s.
const LONGEST_STEP: f64 = 5e-3;
/// Part of the largest energy, or velocity, by which it may be off where positions agree.
const ENERGY_OFF: f64 = 0.02;
/// Beams differ from the solid by this many distances of a beam of eight or sixteen elements.
const BEAM_OFF: f64 = 1.5;

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

/// A file with its samples at the reference's times.
struct Run {
    written: Written,
    sampled: Sampled,
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

/// Comparison of runs with a reference.
struct Comparison<'a> {
    reference: &'a Reference,
    runs: Vec<Run>,
    ratio: Option<f64>,
    /// Distance of each run from the reference.
    off: Vec<f64>,
    /// What beams differ from the solid by; 0 for rods.
    model_off: f64,
    /// Largest error of right methods with each run's step.
    expected: Vec<Option<Expected>>,
}

/// Errors of right methods with a step.
#[derive(Clone, Debug)]
struct Expected {
    position: f64,
    velocity: f64,
    energy: BTreeMap<String, f64>,
}

impl<'a> Comparison<'a> {
    fn new(reference: &'a Reference, runs: Vec<Run>, ratio: Option<f64>) -> Comparison<'a> {
        let mut all = Comparison { reference, runs, ratio, off: Vec::new(), model_off: 0.0, expected: Vec::new() };
        all.off = all.runs.iter().map(|run| distance(&run.sampled.frames.position, &all.right(run).position)).collect();
        if reference.is_solid {
            all.model_off = BEAM_OFF * all.beams_off();
        }
        all.expected = (0..all.runs.len()).map(|n| all.expected(n)).collect();
        all
    }

    /// The reference at a run's times.
    fn right(&self, run: &Run) -> Frames {
        self.reference.frames.picked(&run.sampled.indices)
    }

    fn last(&self) -> (&Run, f64) {
        let n = self.runs.len() - 1;
        (&self.runs[n], self.off[n])
    }

    /// The step of a run, or what its samples let it be at most.
    fn step(&self, run: &Run) -> Option<f64> {
        run.written.step.or((run.sampled.interval <= LONGEST_STEP).then_some(run.sampled.interval))
    }

    /// Distance of beams from the solid.
    fn beams_off(&self) -> f64 {
        let (run, _) = self.last();
        let right = self.right(run);
        let beam = |elements: usize| {
            let mut setup = Setup::of(self.reference.scene.clone());
            setup.scene.rods.iter_mut().for_each(|rod| (rod.element, rod.elements) = (Element::Ancf, elements));
            let Some(rods) = Rods::new(&setup) else { return 0.0 };
            let moved = frames(&rods, Method::Fine, &right.t, |_| false);
            farthest(&right.position, &moved.position).map_or(0.0, |worst| worst.distance)
        };
        beam(8).max(beam(16))
    }

    /// Errors of right methods with the step of run `n`.
    fn expected(&self, n: usize) -> Option<Expected> {
        let run = self.runs.get(n)?;
        let rods = Rods::new(&Setup::of(self.reference.scene.clone()))?;
        let right = match self.reference.is_solid {
            true => frames(&rods, Method::Fine, &run.sampled.frames.t, |_| false),
            false => self.right(run),
        };
        let mut found: Option<Expected> = None;
        let step = self.step(run)?;
        let own = right_methods(step).into_iter().map(|method| frames(&rods, method, &right.t, |_| false));
        // The energy–momentum rule goes on where others fail: at long steps under sudden heat.
        for moved in own.chain(energy_momentum(&self.reference.scene, step, &right)) {
            let position = distance(&right.position, &moved.position);
            if !position.is_finite() {
                continue;
            }
            let velocity = distance(&right.velocity, &moved.velocity);
            let energy = right
                .energy
                .iter()
                .filter_map(|(name, list)| Some((name.clone(), largest_difference(list, moved.energy.get(name)?))));
            let one = Expected { position, velocity, energy: energy.collect() };
            found = Some(match found {
                None => one,
                Some(other) => Expected {
                    position: other.position.max(one.position),
                    velocity: other.velocity.max(one.velocity),
                    energy: one.energy.iter().map(|(name, off)| (name.clone(), off.max(other.energy[name]))).collect(),
                },
            });
        }
        found
    }

    /// Distance at a time that agrees: the reference's uncertainty and what was written and interpolated.
    fn allowed(&self, run: &Run, at: usize) -> f64 {
        let index = run.sampled.indices.get(at).copied().unwrap_or_default();
        let uncertainty = self.reference.position_uncertainty.get(index).copied().unwrap_or(0.0);
        let rounding = if run.written.rounding.is_finite() { 1.5 * run.written.rounding } else { 0.0 };
        AGREES + uncertainty + rounding + run.sampled.interpolation + self.model_off
    }

    /// First sample that is farther off than `allowed`.
    fn first_difference(&self, own_error: f64) -> Option<Difference> {
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

    /// What two steps show.
    fn order(&self) -> Option<OrderResult> {
        let ([one, two], Some(ratio)) = (&self.runs[..], self.ratio) else { return None };
        let off = [*self.off.first()?, *self.off.get(1)?];
        let (coarse, fine) = common(one, two);
        let apart = distance(&fine.position, &coarse.position);
        let order = (off[0] / off[1]).ln() / ratio.ln();
        let limits = [order.clamp(0.5, 4.0), 2.0].map(|p| extrapolated(&coarse, &fine, ratio.powf(p)));
        let right = self.right(two).position;
        let limit_off = limits.iter().map(|limit| distance(limit, &right)).fold(f64::INFINITY, f64::min);
        let expected = |n: usize| self.expected.get(n).and_then(|expected| Some(expected.as_ref()?.position));
        let order_of_a_right_method =
            expected(0).zip(expected(1)).map(|(coarse, fine)| (coarse / fine).ln() / ratio.ln());
        Some(OrderResult { ratio, off, apart, order, limit_off, order_of_a_right_method })
    }

    fn outcome(self) -> Outcome {
        let (run, off) = self.last();
        let start = self.start();
        let order = self.order();
        let expected = self.expected.last().cloned().flatten();
        let own_error = self.own_error(order.as_ref(), expected.as_ref());
        let first_agreeing = self.first_difference(0.0);
        let energies = self.energies();
        let wrong_start = start.iter().any(|start| !start.right);
        let verdict = self.verdict(first_agreeing.as_ref(), order.as_ref(), expected.as_ref());
        let mut fits = Vec::new();
        let mut verdict = verdict;
        if matches!(verdict, Verdict::Mistake | Verdict::Undecided) {
            fits = self.fits(own_error.as_ref().map_or(0.0, |own| own.size));
            if !fits.is_empty() {
                verdict = Verdict::Mistake;
            }
        }
        let mut named: Vec<Named> = self.named_at_the_start(&start);
        let of = |fit: Fit| Named { what: fit.what, look_at: fit.look_at.into(), distance: fit.distance };
        named.extend(fits.into_iter().map(of));
        if verdict == Verdict::Mistake && named.is_empty() {
            named.extend(order.as_ref().and_then(|order| self.lost_order(order)));
        }
        let agrees = matches!(verdict, Verdict::Agrees | Verdict::ShortenTheStep);
        let other = if agrees { self.wrong_besides(expected.as_ref(), &energies) } else { Vec::new() };
        if wrong_start || !other.is_empty() {
            verdict = Verdict::Mistake;
        }
        named.extend(other);
        let first_difference = match verdict {
            Verdict::Mistake if !agrees => {
                let size = own_error.as_ref().map_or(0.0, |own| own.size);
                self.first_difference(size.min(0.5 * off)).or(first_agreeing)
            }
            _ => first_agreeing,
        };
        let summary = summary(verdict, off, &named, order.as_ref());
        let next = self.next(verdict, off, order.as_ref(), !named.is_empty());
        let files = self.runs.iter().zip(&self.off).map(|(run, off)| FileResult {
            file: run.written.file.clone(),
            step: run.written.step,
            compared: run.sampled.indices.len(),
            interpolated: run.sampled.interpolated,
            interpolation_error: run.sampled.interpolation,
            rounding: if run.written.rounding.is_finite() { run.written.rounding } else { 0.0 },
            off: *off,
        });
        Outcome {
            schema: SCHEMA,
            run: String::new(),
            ancf: env!("CARGO_PKG_VERSION"),
            scene: self.reference.id.clone(),
            what: self.reference.what.clone(),
            source: self.reference.source.clone(),
            files: files.collect(),
            verdict,
            summary,
            start,
            first_difference,
            off,
            own_error,
            order,
            energies,
            mistakes: named,
            next,
            notes: self.notes(run),
        }
    }

    fn own_error(&self, order: Option<&OrderResult>, expected: Option<&Expected>) -> Option<OwnError> {
        if let Some(order) = order {
            let size = order.apart / (order.ratio.powf(LEAST_ORDER) - 1.0).max(1.0);
            return Some(OwnError { size, how: "from its two steps".into() });
        }
        let (run, _) = self.last();
        let step = self.step(run)?;
        let how = match run.written.step {
            Some(_) => format!("the largest of second-order methods with a step of {step:e} s"),
            None => {
                format!("the largest of second-order methods with a step of {step:e} s, the distance of its samples")
            }
        };
        Some(OwnError { size: expected?.position, how })
    }

    fn verdict(
        &self,
        difference: Option<&Difference>,
        order: Option<&OrderResult>,
        expected: Option<&Expected>,
    ) -> Verdict {
        if difference.is_none() {
            return Verdict::Agrees;
        }
        let (_, off) = self.last();
        let off = (off - self.model_off).max(0.0);
        let explained = expected.is_some_and(|expected| off <= EXPLAINED * expected.position);
        match order {
            Some(order) if self.lost_order(order).is_some() => Verdict::Mistake,
            Some(order) => {
                let reach = order.apart / (order.ratio.powf(LEAST_ORDER) - 1.0);
                let approaches = off <= reach && order.order >= 0.5 * LEAST_ORDER;
                match (approaches || explained, off <= reach) {
                    (true, _) => Verdict::ShortenTheStep,
                    (false, true) => Verdict::Undecided,
                    (false, false) => Verdict::Mistake,
                }
            }
            None if explained => Verdict::ShortenTheStep,
            None if expected.is_some_and(|expected| off > UNEXPLAINED * expected.position) => Verdict::Mistake,
            None => Verdict::Undecided,
        }
    }

    /// A method that comes to the reference, but more slowly than methods of second order do.
    fn lost_order(&self, order: &OrderResult) -> Option<Named> {
        let right = order.order_of_a_right_method?;
        let (_, off) = self.last();
        let expected = self.expected.last()?.as_ref()?.position;
        let approaches = order.limit_off < 0.5 * off && order.order > 0.5;
        let lost = approaches && order.order < FIRST && right > SECOND && off > EXPLAINED * expected;
        lost.then(|| Named {
            what: format!(
                "a first-order method: its error falls with order {:.2}, that of second-order methods with {right:.2}",
                order.order
            ),
            look_at: "the time-stepping method: where q̇ and q̈ are evaluated within the step".into(),
            distance: order.limit_off,
        })
    }

    fn fits(&self, own_error: f64) -> Vec<Fit> {
        let (run, off) = self.last();
        let right = self.right(run);
        let limit = match (&self.runs[..], self.ratio) {
            ([one, two], Some(ratio)) => {
                let (coarse, fine) = common(one, two);
                let position = extrapolated(&coarse, &fine, ratio * ratio);
                Some(Frames { t: fine.t.clone(), position, ..Frames::default() })
                    .filter(|limit| limit.t.len() == right.t.len())
            }
            _ => None,
        };
        let observed = Observed {
            reference: self.reference,
            right: &right,
            motions: limit.iter().chain([&run.sampled.frames]).collect(),
            off,
            own_error,
            step: run.written.step.or(self.step(run)),
        };
        matching(&observed)
    }

    /// What stands at t = 0.
    fn start(&self) -> Vec<StartResult> {
        let (run, _) = self.last();
        let mut all = Vec::new();
        let frames = &run.sampled.frames;
        if frames.t.first() == Some(&0.0) {
            let first = |table: &BTreeMap<String, Path>| -> BTreeMap<String, Path> {
                table.iter().filter_map(|(point, path)| Some((point.clone(), vec![*path.first()?]))).collect()
            };
            let off = distance(&first(&frames.position), &first(&self.right(run).position));
            all.push(StartResult {
                what: "positions".into(),
                right: off <= self.allowed(run, 0),
                detail: format!("off by {off:.1e} m"),
            });
        }
        let Some(rods) = Rods::new(&Setup::of(self.reference.scene.clone())) else { return all };
        let mut vector = |what: &str, own: &Option<Vec<f64>>, right: &[f64], tolerance: f64| {
            let Some(own) = own else { return };
            let scale = right.iter().fold(1.0, |scale: f64, a| scale.max(a.abs()));
            let (right_here, detail) = match own.len() == right.len() {
                true => {
                    let off = largest_difference(own, right);
                    (off <= tolerance * scale, format!("off by {off:.1e}, the largest is {scale:.3}"))
                }
                false => (false, format!("{} numbers; allowed: {}, in the fixtures' order", own.len(), right.len())),
            };
            all.push(StartResult { what: what.into(), right: right_here, detail });
        };
        let nodal = self.reference.nodal.clone().unwrap_or_else(|| rods.start.as_slice().to_vec());
        vector("nodal coordinates q", &run.written.nodal, &nodal, 1e-9);
        let a = self.reference.acceleration.clone().unwrap_or_else(|| initial_acceleration(&rods).as_slice().to_vec());
        vector("accelerations q̈", &run.written.acceleration, &a, 1e-6);
        if let Some(mass) = &run.written.mass {
            all.push(mass_result(mass, &rods.mass));
        }
        all
    }

    /// Mistakes that give the program's mass or accelerations at t = 0, where these are wrong.
    fn named_at_the_start(&self, start: &[StartResult]) -> Vec<Named> {
        let (run, _) = self.last();
        let wrong = |what: &str| start.iter().any(|start| start.what == what && !start.right);
        let mut named = Vec::new();
        for mistake in mistakes(&self.reference.scene, None) {
            let Made::Setup(setup) = &mistake.made else { continue };
            let Some(rods) = Rods::new(setup) else { continue };
            let mass = wrong("mass matrix M")
                && run.written.mass.as_ref().is_some_and(|mass| mass_result(mass, &rods.mass).right);
            let acceleration = wrong("accelerations q̈")
                && run.written.acceleration.as_ref().is_some_and(|own| {
                    let a = initial_acceleration(&rods);
                    own.len() == a.len() && largest_difference(own, a.as_slice()) <= 1e-6 * a.amax().max(1.0)
                });
            if mass || acceleration {
                named.push(Named {
                    what: format!("at t = 0: {}", mistake.what),
                    look_at: mistake.look_at.into(),
                    distance: 0.0,
                });
            }
        }
        named.truncate(4);
        named
    }

    /// Energies of the program beside the reference's.
    fn energies(&self) -> Vec<EnergyResult> {
        let (run, _) = self.last();
        let (mut own, mut right) = (run.sampled.frames.energy.clone(), self.right(run).energy);
        for table in [&mut own, &mut right] {
            // The height from which the potential counts is anybody's choice.
            let potential = table.get_mut("potential");
            potential.into_iter().for_each(|list| {
                let first = list.first().copied().unwrap_or(0.0);
                list.iter_mut().for_each(|energy| *energy -= first);
            });
        }
        let scale = right
            .iter()
            .filter(|(name, _)| *name != "input")
            .flat_map(|(_, list)| list)
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        let mut all = Vec::new();
        for name in ["kinetic", "strain", "potential"] {
            let (Some(own), Some(right)) = (own.get(name), right.get(name)) else { continue };
            let square: f64 = right.iter().map(|b| b * b).sum();
            let along: f64 = own.iter().zip(right).map(|(a, b)| a * b).sum();
            all.push(EnergyResult {
                name: name.into(),
                off: largest_difference(own, right),
                at_the_end: own.last().zip(right.last()).map_or(0.0, |(a, b)| a - b),
                scale,
                factor: Some(along / square),
            });
        }
        if all.len() == 3 {
            let total = |table: &BTreeMap<String, Vec<f64>>, n: usize| -> f64 {
                ["kinetic", "strain", "potential"].iter().filter_map(|name| table.get(*name)?.get(n)).sum()
            };
            let off: Vec<f64> = (0..run.sampled.frames.t.len()).map(|n| total(&own, n) - total(&right, n)).collect();
            all.push(EnergyResult {
                name: "total".into(),
                off: off.iter().fold(0.0, |a: f64, b| a.max(b.abs())),
                at_the_end: off.last().copied().unwrap_or(0.0),
                scale,
                factor: None,
            });
        }
        all
    }

    /// Velocities and energies that are wrong although positions agree.
    fn wrong_besides(&self, expected: Option<&Expected>, energies: &[EnergyResult]) -> Vec<Named> {
        let (run, _) = self.last();
        let right = self.right(run);
        let mut all = Vec::new();
        let fastest = right.velocity.values().flatten().fold(0.0, |a: f64, v| a.max(v[0].hypot(v[1])));
        if let Some(worst) = farthest(&run.sampled.frames.velocity, &right.velocity) {
            let own = expected.map_or(f64::INFINITY, |expected| 3.0 * expected.velocity);
            if worst.distance > ENERGY_OFF * fastest + own {
                all.push(Named {
                    what: format!(
                        "positions agree, velocities do not: {} is off by {:.1e} m/s",
                        worst.point, worst.distance
                    ),
                    look_at: "what is written as velocity, and at which time of the step".into(),
                    distance: 0.0,
                });
            }
        }
        for energy in energies.iter().filter(|energy| energy.name != "total") {
            let own = expected
                .map_or(f64::INFINITY, |expected| 3.0 * expected.energy.get(&energy.name).copied().unwrap_or(0.0));
            if energy.off > ENERGY_OFF * energy.scale + own {
                let factor = energy.factor.map(|factor| format!(", best factor {factor:.3}")).unwrap_or_default();
                all.push(Named {
                    what: format!(
                        "positions agree, the {} energy does not: off by {:.1e} J{factor}",
                        energy.name, energy.off
                    ),
                    look_at: "how this energy is computed, and from which heat it counts".into(),
                    distance: 0.0,
                });
            }
        }
        all
    }

    fn next(&self, verdict: Verdict, off: f64, order: Option<&OrderResult>, named: bool) -> String {
        let (run, _) = self.last();
        match verdict {
            Verdict::Agrees => "Nothing to do.".into(),
            Verdict::ShortenTheStep => {
                let order = order.map_or(2.0, |order| order.order.clamp(0.5, 4.0));
                let factor = (off / AGREES).powf(1.0 / order);
                match self.step(run) {
                    Some(step) if factor < 1e4 => format!(
                        "Shorten the step: about {:.1e} s would agree to {AGREES:e} m with order {order:.1}; until then mistakes smaller than {off:.1e} m are not seen.",
                        step / factor
                    ),
                    _ => format!("Shorten the step; until then mistakes smaller than {off:.1e} m are not seen."),
                }
            }
            Verdict::Mistake if named => "Correct it, and compare again: a second mistake may stand behind it.".into(),
            Verdict::Mistake => "No mistake that is made on purpose here moves like this. Ask the program for the terms of one element (`ancf conform -- COMMAND…`), or give \"M\", \"q\" and \"q_ddot\" at t = 0 in JSON.".into(),
            Verdict::Undecided => "Give a second file with half the step, or the step (`--steps`): only then its own error is known.".into(),
        }
    }

    fn notes(&self, run: &Run) -> Vec<String> {
        let mut notes = Vec::new();
        if !run.written.ignored.is_empty() {
            notes.push(format!("not used: {}", run.written.ignored.join(", ")));
        }
        if let Some(end) = run.written.ends_at {
            notes.push(format!("from t = {end} s on there are values that are no numbers: the motion has exploded, by its step or by a mistake"));
        }
        if let Some(last) = self.reference.frames.t.last()
            && run.sampled.frames.t.last().is_some_and(|t| t < last)
        {
            notes.push(format!("compared until {} s of {last}", run.sampled.frames.t.last().unwrap_or(&0.0)));
        }
        notes
    }
}

/// Motion by the library's energy–momentum rule at the times of the right one; `None` if it fails.
fn energy_momentum(scene: &Scene, step: f64, right: &Frames) -> Option<Frames> {
    let interval = right.t.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    let mut scene = scene.clone();
    (scene.time.method, scene.constraints) = (ancf::model::Method::EnergyMomentum, Constraints::Condensed);
    (scene.time.step, scene.time.end) = (interval / (interval / step * (1.0 - 1e-9)).ceil(), *right.t.last()?);
    scene.output.interval = None;
    scene.probes.clear();
    let mut simulation = Simulation::new(scene).ok()?;
    let mut moved = Frames { t: right.t.clone(), ..Frames::default() };
    for t in &right.t {
        simulation.run_until(*t).ok()?;
        for point in right.position.keys() {
            moved.position.entry(point.clone()).or_default().push(simulation.position(point).ok()?);
            moved.velocity.entry(point.clone()).or_default().push(simulation.velocity(point).ok()?);
        }
        let energy = simulation.energy();
        for (name, energy) in [("kinetic", energy.kinetic), ("strain", energy.strain), ("potential", energy.potential)]
        {
            moved.energy.entry(name.into()).or_default().push(energy);
        }
    }
    Some(moved)
}

/// Frames of two runs at the times that both have, points that both have.
fn common(one: &Run, two: &Run) -> (Frames, Frames) {
    let of = |run: &Run, other: &Run| {
        let picked: Vec<usize> = (0..run.sampled.indices.len())
            .filter(|n| other.sampled.indices.contains(&run.sampled.indices[*n]))
            .collect();
        run.sampled.frames.picked(&picked)
    };
    (of(one, two), of(two, one))
}

/// Limit of two motions whose errors are in a ratio.
fn extrapolated(coarse: &Frames, fine: &Frames, ratio: f64) -> BTreeMap<String, Path> {
    let limit = |(point, path): (&String, &Path)| {
        let other = coarse.position.get(point)?;
        let extrapolate = |(p, q): (&[f64; 2], &[f64; 2])| [0, 1].map(|c| p[c] + (p[c] - q[c]) / (ratio - 1.0));
        Some((point.clone(), path.iter().zip(other).map(extrapolate).collect()))
    };
    fine.position.iter().filter_map(limit).collect()
}

/// A mass matrix beside the right one. It may be that of one component, without coordinates that are held, or with the vectors in another
/// order only if it says so: none is guessed.
fn mass_result(own: &[Vec<f64>], right: &DMatrix<f64>) -> StartResult {
    let what = "mass matrix M".to_string();
    let size = right.nrows();
    let stride = match own.len() {
        n if n == size => 1,
        n if 2 * n == size => 2,
        n => {
            let detail = format!("{n} rows; allowed: {size} of all coordinates, or {} of one component", size / 2);
            return StartResult { what, right: false, detail };
        }
    };
    if let Some(row) = own.iter().find(|row| row.len() != own.len()) {
        return StartResult {
            what,
            right: false,
            detail: format!("a row of {} numbers in a matrix of {}", row.len(), own.len()),
        };
    }
    let mut worst = (0.0, (0, 0));
    for (i, row) in own.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let off = (entry - right[(stride * i, stride * j)]).abs();
            if off > worst.0 || off.is_nan() {
                worst = (off, (i, j));
            }
        }
    }
    let (off, (i, j)) = worst;
    let detail = format!("entry ({}, {}) is off by {off:.1e} kg", i + 1, j + 1);
    StartResult { what, right: off <= 1e-9 * right.amax(), detail }
}

fn summary(verdict: Verdict, off: f64, named: &[Named], order: Option<&OrderResult>) -> String {
    match (verdict, named) {
        (Verdict::Agrees, _) => format!("agrees, to {off:.1e} m"),
        (Verdict::ShortenTheStep, _) => match order {
            Some(order) if order.order >= 0.5 => {
                format!("agrees as far as its step allows, {off:.1e} m off, order {:.1}: shorten the step", order.order)
            }
            _ => format!("agrees as far as its step allows, {off:.1e} m off: shorten the step"),
        },
        (Verdict::Mistake, [first, ..]) => format!("a mistake: {}", first.what),
        (Verdict::Mistake, []) => format!("a mistake without a name: {off:.1e} m off, more than its step explains"),
        (Verdict::Undecided, _) => format!(
            "differs by {off:.1e} m: by its step or by a mistake, which one file without its step does not tell"
        ),
    }
}
