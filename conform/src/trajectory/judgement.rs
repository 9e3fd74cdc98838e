//! The verdict on a motion: t = 0, the first difference, the order of two steps, energies, the mistake that moves alike.

use super::advice::{Cause, summary};
use super::comparison::Comparison;
use super::frames::{Frames, distance};
use super::matching::{Fit, Observed, Search, matching};
use super::order::{EXPLAINED, common, extrapolated};
use super::outcome::{Difference, FileResult, Named, OrderResult, Outcome, OwnError, SCHEMA, Verdict};

/// A difference beyond this many errors of right methods is a mistake also without a name; in between, a method may have larger errors
/// than others of its order.
const UNEXPLAINED: f64 = 10.0;
/// Lowest order in which a right method is expected to come to its limit; waves that no step resolves lower it.
const LEAST_ORDER: f64 = 0.8;
/// A right method that comes this near to the program's motion, in parts of the reference's distance, is the program's.
const SAME_METHOD: f64 = 0.02;
/// A program whose error is less than this part of every right method's has another method.
const MUCH_BETTER: f64 = 0.3;

impl Comparison<'_> {
    /// The report.
    pub fn outcome(self) -> Outcome {
        let (run, off) = self.last();
        let start = self.start();
        let order = self.order();
        let own_error = self.own_error(order.as_ref());
        let own_size = own_error.as_ref().map_or(0.0, |own| own.size);
        let first_agreeing = self.first_difference(0.0);
        let energies = self.energies();
        let wrong_start = start.iter().any(|start| !start.right);
        let mut verdict = self.verdict(first_agreeing.as_ref(), order.as_ref());
        let fits = if run.written.ends_at.is_some() && matches!(verdict, Verdict::Agrees | Verdict::ShortenTheStep) {
            // What there was before it exploded is right.
            verdict = Verdict::Undecided;
            Vec::new()
        } else {
            self.fits(verdict, own_size)
        };
        if !fits.is_empty() {
            verdict = Verdict::Mistake;
        }
        let mut named: Vec<Named> = self.named_at_the_start(&start, own_size);
        let of = |fit: Fit| Named { what: fit.what, look_at: fit.look_at.into(), distance: fit.distance };
        named.extend(fits.into_iter().map(of));
        if verdict == Verdict::Mistake && named.is_empty() {
            named.extend(order.as_ref().and_then(|order| self.lost_order(order)));
        }
        let agrees = matches!(verdict, Verdict::Agrees | Verdict::ShortenTheStep);
        let other = if agrees && named.is_empty() { self.wrong_besides(&energies) } else { Vec::new() };
        if wrong_start || !other.is_empty() {
            verdict = Verdict::Mistake;
        }
        named.extend(other);
        let first_difference = match verdict {
            Verdict::Mistake if !agrees => self.first_difference(own_size.min(0.5 * off)).or(first_agreeing),
            _ => first_agreeing,
        };
        let cause = match (run.written.ends_at, order.as_ref()) {
            (Some(end), _) => Cause::Explodes(end),
            (None, Some(order)) => Cause::Steps(order),
            (None, None) if run.written.step.is_some() => Cause::OneStep,
            (None, None) => Cause::NoStep,
        };
        let summary = summary(verdict, off, &named, &cause);
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

    /// Error of the program's method, from its two steps or from its step.
    fn own_error(&self, order: Option<&OrderResult>) -> Option<OwnError> {
        if let Some(order) = order {
            let size = order.apart / (order.ratio.powf(LEAST_ORDER) - 1.0).max(1.0);
            return Some(OwnError { size, how: "from its two steps".into() });
        }
        let (run, _) = self.last();
        let step = run.step()?;
        let how = match run.written.step {
            Some(_) => format!("the largest of second-order methods with a step of {step:e} s"),
            None => {
                format!("the largest of second-order methods with a step of {step:e} s, the distance of its samples")
            }
        };
        Some(OwnError { size: self.expected()?.position, how })
    }

    /// The verdict by positions alone.
    fn verdict(&self, difference: Option<&Difference>, order: Option<&OrderResult>) -> Verdict {
        let expected = self.expected();
        if difference.is_none() {
            return Verdict::Agrees;
        }
        let (_, off) = self.last();
        let off = (off - self.model.position).max(0.0);
        let explained = expected.is_some_and(|expected| off <= EXPLAINED * expected.position);
        match order {
            Some(order) if self.lost_order(order).is_some() => Verdict::Mistake,
            Some(order) => {
                let reach = order.apart / (order.ratio.powf(LEAST_ORDER) - 1.0);
                if off <= reach && order.order >= 0.5 * LEAST_ORDER {
                    Verdict::ShortenTheStep
                } else if off <= reach || explained {
                    // Right methods may be as far off at this step; but shorter steps do not lead this one to the reference.
                    Verdict::Undecided
                } else {
                    Verdict::Mistake
                }
            }
            None if explained => Verdict::ShortenTheStep,
            None if expected.is_some_and(|expected| off > UNEXPLAINED * expected.position) => Verdict::Mistake,
            None => Verdict::Undecided,
        }
    }

    /// Mistakes that move as the program does. What its step explains is matched too, unless a right method with this step moves exactly
    /// so: a mistake may be smaller than the error of the step, and then only the same mistake with the same method shows it.
    fn fits(&self, verdict: Verdict, own_error: f64) -> Vec<Fit> {
        let (run, off) = self.last();
        let search = match verdict {
            Verdict::Agrees => return Vec::new(),
            Verdict::ShortenTheStep if self.reference.is_solid || self.is_right_or_by_another_method() => {
                return Vec::new();
            }
            Verdict::ShortenTheStep => Search::SameMethod,
            Verdict::Undecided => Search::Undecided,
            Verdict::Mistake => Search::Mistake,
        };
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
            step: run.step(),
            search,
        };
        matching(&observed)
    }

    /// Whether a right method with the program's step moves as it does, or all of them have much larger errors: then it is by another.
    fn is_right_or_by_another_method(&self) -> bool {
        let (run, off) = self.last();
        let right = self.right(run);
        let Some(expected) = self.expected() else { return true };
        let errors = expected.motions.iter().map(|moved| distance(&right.position, &moved.position));
        let apart = expected.motions.iter().map(|moved| distance(&run.sampled.frames.position, &moved.position));
        off < MUCH_BETTER * errors.fold(f64::INFINITY, f64::min)
            || apart.fold(f64::INFINITY, f64::min) < SAME_METHOD * off
    }
}
