//! What to say of a verdict, and what to do next.

use super::comparison::{AGREES, Comparison};
use super::outcome::{Named, OrderResult, Verdict};
use super::run::Run;

impl Comparison<'_> {
    /// What to do next.
    pub fn next(&self, verdict: Verdict, off: f64, order: Option<&OrderResult>, named: bool) -> String {
        let (run, _) = self.last();
        match verdict {
            Verdict::Agrees => "Nothing to do.".into(),
            Verdict::ShortenTheStep => {
                let order = order.map_or(2.0, |order| order.order.clamp(0.5, 4.0));
                let factor = (off / AGREES).powf(1.0 / order);
                match run.step() {
                    Some(step) if factor < 1e4 => format!(
                        "Shorten the step: about {:.1e} s would agree to {AGREES:e} m with order {order:.1}; until then mistakes smaller than {off:.1e} m are not seen.",
                        step / factor
                    ),
                    _ => format!("Shorten the step; until then mistakes smaller than {off:.1e} m are not seen."),
                }
            }
            Verdict::Mistake if named => "Correct it, and compare again: a second mistake may stand behind it.".into(),
            Verdict::Mistake => "No mistake that is made on purpose here moves like this. Ask the program for the terms of one element (`ancf conform -- COMMAND…`), or give \"M\", \"q\" and \"q_ddot\" at t = 0 in JSON.".into(),
            Verdict::Undecided if run.written.ends_at.is_some() => "Shorten the step: a right motion does not explode.".into(),
            Verdict::Undecided if order.is_some() => "Give two files with shorter steps, the second half the first.".into(),
            Verdict::Undecided if run.written.step.is_some() => "Give a second file with half the step.".into(),
            Verdict::Undecided => "Give a second file with half the step, or the step (`--steps`): only then its own error is known.".into(),
        }
    }

    /// Remarks on the files.
    pub fn notes(&self, run: &Run) -> Vec<String> {
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

/// What a verdict rests on.
pub enum Cause<'a> {
    /// From this time on, s, the motion has values that are no numbers.
    Explodes(f64),
    /// Two steps.
    Steps(&'a OrderResult),
    /// One file whose step is known, and one whose step is not.
    OneStep,
    NoStep,
}

/// The verdict in a sentence.
pub fn summary(verdict: Verdict, off: f64, named: &[Named], cause: &Cause) -> String {
    match (verdict, named) {
        (Verdict::Agrees, _) => format!("agrees, to {off:.1e} m"),
        (Verdict::ShortenTheStep, _) => match cause {
            Cause::Steps(order) if order.order >= 0.5 => {
                format!("agrees as far as its step allows, {off:.1e} m off, order {:.1}: shorten the step", order.order)
            }
            _ => format!("agrees as far as its step allows, {off:.1e} m off: shorten the step"),
        },
        (Verdict::Mistake, [first, ..]) => format!("a mistake: {}", first.what),
        (Verdict::Mistake, []) => format!("a mistake without a name: {off:.1e} m off, more than its step explains"),
        (Verdict::Undecided, _) => match cause {
            Cause::Explodes(end) => format!("explodes at t = {end} s, by its step or by a mistake"),
            Cause::Steps(order) => format!(
                "differs by {off:.1e} m, and the shorter step does not come nearer as it should (order {:.1}): by a mistake, or by steps that are too long for the waves, swapped, or the same",
                order.order
            ),
            Cause::OneStep => {
                format!("differs by {off:.1e} m, a little more than its step explains: by its method or by a mistake")
            }
            Cause::NoStep => format!(
                "differs by {off:.1e} m: by its step or by a mistake, which one file without its step does not tell"
            ),
        },
    }
}
